"""What the referee says: findings, figures and a verdict."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Any

from scenewright.core.views import describe, show

KINDS = (
    "malformed",
    "changed_given",
    "missing",
    "surplus",
    "collision",
    "mesh_overlap",
    "out_of_bounds",
    "blocked_door",
    "blocked_window",
    "blocked_radiator",
    "unserved",
    "blocked_stairs",
    "unreachable_piece",
    "unreachable_group",
    "unreachable_room",
    "narrow_passage",
    "outside_zone",
    "no_wall",
    "through_slope",
    "floating",
    "sunk",
    "no_turning",
    "no_transfer",
    "blocked_path",
    "setback",
    "spacing",
    "unreachable_building",
    "unserved_door",
    "door_at_border",
    "far_from_lane",
    "lack_of_sun",
    "blocked_area",
    "lack_of_parking",
    "lack_of_square",
    "blocked_forecourt",
    "blocked_view",
    "open_court",
    "changed_landmark",
    "too_high",
    "door_off_ground",
    "steep_way",
    "in_water",
)


Place = tuple[float, float]
"""(x, y) in the plan, metres."""
Ring = tuple[Place, ...]
"""Corners of a polygon in order, the first not repeated."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One violation.

    ``kind`` is one of :data:`KINDS`; ``piece`` and ``other`` are ids (empty where there is none;
    for a blocked opening ``other`` is the opening, for something unreachable or narrow what blocks
    it, several ids joined by commas; outside a zone, the zone). ``amount`` is the size of the
    fault in metres (depth of an overlap, distance outside, gap beneath, width missing) and
    ``area`` in square metres. ``given`` findings concern only pieces fixed by the brief: they are
    reported, but the answer is not to blame for them; nor for those ``accepted`` by the user, for
    the reason stated there (empty: not accepted). ``locked`` findings concern something that a
    person locked: that is said, and excuses nothing. ``polygons`` and ``points`` say where in the
    plan of its level it lies (:mod:`scenewright.check.locating`).
    """

    kind: str
    level: str
    space: str
    piece: str
    other: str
    message: str
    amount: float = 0.0
    area: float = 0.0
    given: bool = False
    accepted: str = ""
    locked: bool = False
    polygons: tuple[Ring, ...] = ()
    points: tuple[Place, ...] = ()

    @property
    def is_blamed(self) -> bool:
        """Whether the answer is to blame: it neither came with the brief nor was accepted."""
        return not self.given and not self.accepted


@dataclass(frozen=True, slots=True)
class Note:
    """Something usual that a room of its function and size lacks, or a hall of its size and number
    of people; not a violation."""

    space: str
    function: str
    missing: str
    message: str


@dataclass(frozen=True, slots=True, repr=False)
class Report:
    """The verdict on a solution.

    ``unplaced`` counts what is required and stated as left out, with a reason: such an answer
    breaks no rule and is not ``complete``. ``figures`` holds ``pieces`` and ``counts`` (findings by
    kind), ``navigable_share`` and ``reachable_share`` by level, ``usability`` (of the occupancy
    grid), ``rooms`` (pieces, floor area in square metres and density of each space) and, for
    answers with a scene graph, ``halls``
    (measures, passages, tour, ways out of each space).
    """

    findings: tuple[Finding, ...]
    notes: tuple[Note, ...] = ()
    figures: dict[str, Any] = field(default_factory=dict)
    unplaced: int = 0

    @property
    def complete(self) -> bool:
        """Whether it is valid and all that is required stands."""
        return self.valid and not self.unplaced

    @property
    def valid(self) -> bool:
        """Whether nothing but what came with the brief or was accepted violates a rule."""
        return not any(found.is_blamed for found in self.findings)

    def of(self, kind: str) -> tuple[Finding, ...]:
        """The findings of one kind."""
        return tuple(found for found in self.findings if found.kind == kind)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, ready for JSON.

        >>> Report(()).to_dict()
        {'valid': True, 'complete': True, 'unplaced': 0, 'findings': [], 'notes': [], 'figures': {}}
        """
        return {
            "valid": self.valid,
            "complete": self.complete,
            "unplaced": self.unplaced,
            "findings": [_plain(found) for found in self.findings],
            "notes": [_plain(note) for note in self.notes],
            "figures": self.figures,
        }

    def __str__(self) -> str:
        """One line.

        >>> str(Report((Finding("collision", "0", "a", "sofa", "tv", "they overlap"),)))
        'not valid: 1 collision'
        """
        blamed = Counter(found.kind for found in self.findings if found.is_blamed)
        counted = ", ".join(f"{blamed[k]} {k.replace('_', ' ')}" for k in KINDS if blamed[k])
        accepted = sum(bool(found.accepted) for found in self.findings)
        given = len(self.findings) - blamed.total() - accepted
        tail = f" ({given} more in what was given)" if given else ""
        tail += f" ({accepted} accepted)" if accepted else ""
        tail += f", not complete: {self.unplaced} not placed" if self.unplaced else ""
        return (f"not valid: {counted}" if counted else "valid") + tail

    def __repr__(self) -> str:
        """The verdict in one line, with how many findings and notes there are."""
        return describe("Report", str(self), findings=len(self.findings), notes=len(self.notes))

    def _repr_html_(self) -> str:
        """In notebooks: the verdict and a table of findings and notes."""
        return str(show("report_html", self))


def count_by_kind(findings: tuple[Finding, ...]) -> dict[str, int]:
    """How many findings there are of every kind, zeros included."""
    counted = Counter(found.kind for found in findings)
    return {kind: counted[kind] for kind in KINDS}


def _plain(value: Finding | Note) -> dict[str, Any]:
    return {name: getattr(value, name) for name in value.__slots__}
