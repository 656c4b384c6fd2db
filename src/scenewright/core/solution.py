"""A solution: the layout found, the reasons, what was left out, and how to get it again."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece


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


@dataclass(frozen=True, slots=True)
class Solution:
    """Everything about one answer; saved as JSON it reads back and can be solved again.

    ``energies`` is the final energy of each space, ``evaluations`` the number of layouts looked
    at, ``seconds`` the time solving took: it is not saved, and solutions that differ in nothing
    else are equal. ``detail`` is what only the brief's domain knows of its answers: a hall's
    layout of zones and groups, with the visitors' tours; the lanes and walks of a site.
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
