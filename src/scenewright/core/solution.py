"""A solution: the layout found, the reasons, what was left out, and how to get it again."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from scenewright._version import __version__
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.views import describe, show

STOPPED = "stopped before it was placed"
"""Why something is left out of a run that was cancelled."""


class Patch(NamedTuple):
    """A functional area as solved: its id (``living/seating``), space, function and box
    (centre x, centre y, heading, width, depth)."""

    id: str
    space: str
    function: str
    box: tuple[float, float, float, float, float]


class TermValue(NamedTuple):
    """What one term says of one item (``item`` is empty for a whole-layout term): the raw value,
    its weight and their product, the cost."""

    space: str
    item: str
    term: str
    value: float
    weight: float
    cost: float


class LeftOut(NamedTuple):
    """Something wished for or usual that was not placed, and why; ``required`` if it was asked
    for or essential to the room's function."""

    space: str
    what: str
    reason: str
    required: bool


@dataclass(frozen=True, slots=True, repr=False)
class Solution:
    """Everything about one answer; saved as JSON it reads back and can be solved again.

    ``energies`` is the final energy of each space, ``evaluations`` the number of layouts looked
    at, ``seconds`` the time solving took: it is not saved, and solutions that differ in nothing
    else are equal. ``detail`` is what only the brief's domain knows of its answers: a hall's
    layout of zones and groups, with the visitors' tours; the lanes and walks of a site.
    ``clutter`` is how many small objects its scene has (:mod:`scenewright.clutter`).
    """

    brief: Brief
    pieces: tuple[Piece, ...]
    patches: tuple[Patch, ...]
    terms: tuple[TermValue, ...]
    left_out: tuple[LeftOut, ...]
    energies: dict[str, float]
    preset: str
    solver: str
    seed: int
    version: str
    brief_hash: str
    seconds: float = field(compare=False)
    evaluations: int
    detail: Any = None
    clutter: str = "none"

    def __repr__(self) -> str:
        """One line: what was laid out, how much of it stands, and how to get it again."""
        required = sum(entry.required for entry in self.left_out)
        return describe(
            "Solution",
            self.brief.domain,
            self.brief.name,
            spaces=len(self.energies) or None,
            pieces=len(self.pieces),
            not_placed=required,
            optional_not_placed=len(self.left_out) - required or None,
            preset=self.preset,
            seed=self.seed,
        )

    def _repr_html_(self) -> str:
        """In notebooks: the verdict, the plan, and what was not placed and why."""
        return str(show("solution_html", self))

    def _repr_svg_(self) -> str | None:
        """In notebooks: the plan, to scale; the picture is that of its scene."""
        drawn: str | None = show("solution_svg", self)
        return drawn


def unfurnished(brief: Brief) -> Solution:
    """The solution of a brief in which nothing is placed: what there is before anything is solved.

    >>> from scenewright.formats import read
    >>> unfurnished(read("sample:home-room")).pieces
    ()
    """
    return Solution(brief, (), (), (), (), {}, "default", "none", 0, __version__, "", 0.0, 0)
