"""The input report: what became of every feature of a file that was read.

A reader states one :class:`Fate` for each feature of its file (a building of a map, a wall of a
plan, a key of a brief) and sums them up with :func:`report_input`; the report travels with the
brief and is stored with it. Rows are counts by kind, fate and reason, so that five thousand
features make a few lines; their sum is the number of features in the file.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from scenewright.core.brief.fields import Number, StrictModel, Switch, Whole
from scenewright.core.views import describe, show

Outcome = Literal["used", "changed", "left out"]
OUTCOMES: tuple[Outcome, ...] = ("used", "changed", "left out")
MOST_ROWS = 200
"""Rows of a report; of a kind with more reasons the rarest share one row."""
MOST_EXAMPLES = 3
LEAST_FLOOR_READ = 0.95
"""Share of the floor drawn in a plan below which what was read is incomplete."""
LONGEST = 200
"""Letters of a kind, reason or name of a feature."""

_Text = Annotated[str, Field(max_length=LONGEST)]


class Fate(NamedTuple):
    """What became of one feature: its ``name`` in the file, its ``kind`` in words a user has for
    it, and how it was changed or why it was left out. ``stands`` marks something that stands or
    was drawn as built and is now missing from the brief, so that the result may be wrong."""

    name: str
    kind: str
    outcome: Outcome
    reason: str = ""
    stands: bool = False


class InputRow(StrictModel):
    """How many features of a kind share an outcome and its reason, and the names of the first."""

    kind: _Text
    outcome: Outcome
    count: Annotated[Whole, Field(ge=1)]
    reason: _Text = ""
    examples: Annotated[list[_Text], Field(max_length=MOST_EXAMPLES)] = []
    stands: Switch = False

    def describe(self) -> str:
        """The row in words, without its kind.

        >>> InputRow(kind="tree", outcome="left out", count=4, reason="planted anew",
        ...     examples=["node/7", "node/8", "node/9"]).describe()
        '4 left out: planted anew (node/7, node/8, node/9 …)'
        """
        more = " …" * (self.count > len(self.examples))
        named = f" ({', '.join(self.examples)}{more})" if self.examples else ""
        return (
            f"{self.count:,} {self.outcome}" + (f": {self.reason}" if self.reason else "") + named
        )


class InputReport(StrictModel):
    """What was read of a file: its ``format``, reference ``system`` and ``unit`` in words, rows of
    features, and for plans the floor drawn and the floor read in m²."""

    format: _Text = ""
    system: _Text = ""
    unit: _Text = ""
    rows: Annotated[list[InputRow], Field(max_length=MOST_ROWS)] = []
    drawn_floor: Annotated[Number | None, Field(ge=0)] = None
    read_floor: Annotated[Number | None, Field(ge=0)] = None

    @property
    def features(self) -> int:
        """How many features the file holds."""
        return sum(row.count for row in self.rows)

    @property
    def lost(self) -> tuple[InputRow, ...]:
        """Rows of standing things that were left out."""
        return tuple(row for row in self.rows if row.stands and row.outcome == "left out")

    @property
    def floor_share(self) -> float | None:
        """Share of the drawn floor that was read, 0 to 1; ``None`` where none was measured."""
        if self.read_floor is None or not self.drawn_floor:
            return None
        return min(self.read_floor / self.drawn_floor, 1.0)

    @property
    def complete(self) -> bool:
        """Whether nothing that stands is lost and enough of the drawn floor was read."""
        return not self.warnings

    @property
    def warnings(self) -> tuple[str, ...]:
        """A line for each thing lost: standing things that were left out, then the floor of a
        plan if less than :data:`LEAST_FLOOR_READ` of it was read."""
        lost = tuple(f"{row.kind}: {row.describe()}" for row in self.lost)
        share = self.floor_share
        if share is None or share >= LEAST_FLOOR_READ:
            return lost
        return (*lost, f"only {self.describe_floor()}")

    def __repr__(self) -> str:
        """One line: the format, and how many features were read and lost."""
        lost = sum(row.count for row in self.lost)
        return describe("InputReport", self.format, features=self.features, lost=lost)

    __str__ = __repr__

    def _repr_html_(self) -> str:
        """In notebooks: a table of what became of the features."""
        return str(show("input_report_html", self))

    def describe_floor(self) -> str:
        """The floor read of the floor drawn in words; empty where none was measured.

        >>> InputReport(drawn_floor=40.0, read_floor=37.0).describe_floor()
        '37.0 of 40.0 m² of drawn floor were read (92 %)'
        """
        if self.floor_share is None:
            return ""
        share = 100 * self.floor_share
        return (
            f"{self.read_floor:.1f} of {self.drawn_floor:.1f} m² of drawn floor were read "
            f"({share:.0f} %)"
        )


def report_input(
    fates: Iterable[Fate],
    *,
    format: str = "",  # noqa: A002 (the word users know)
    system: str = "",
    unit: str = "",
    drawn_floor: float | None = None,
    read_floor: float | None = None,
) -> InputReport:
    """The report of a file from the fate of each of its features.

    >>> found = report_input([Fate("way/1", "building", "used"), Fate("way/2", "building", "used"),
    ...     Fate("node/7", "tree", "left out", "trees are planted anew")], format="GeoJSON")
    >>> [(row.kind, row.outcome, row.count) for row in found.rows]
    [('building', 'used', 2), ('tree', 'left out', 1)]
    >>> found.features, found.complete
    (3, True)
    """
    return InputReport(
        format=format[:LONGEST],
        system=system[:LONGEST],
        unit=unit[:LONGEST],
        rows=_limit([_row(group) for group in _grouped(fates).values()]),
        drawn_floor=drawn_floor,
        read_floor=read_floor,
    )


def _grouped(fates: Iterable[Fate]) -> dict[tuple[str, str, str, bool], list[Fate]]:
    groups: dict[tuple[str, str, str, bool], list[Fate]] = {}
    for fate in fates:
        groups.setdefault((fate.kind, fate.outcome, fate.reason, fate.stands), []).append(fate)
    return groups


def _row(group: list[Fate]) -> InputRow:
    first = group[0]
    return InputRow(
        kind=first.kind[:LONGEST],
        outcome=first.outcome,
        count=len(group),
        reason=first.reason[:LONGEST],
        examples=[fate.name[:LONGEST] for fate in group[:MOST_EXAMPLES] if fate.name],
        stands=first.stands,
    )


def _limit(rows: list[InputRow]) -> list[InputRow]:
    """At most :data:`MOST_ROWS` rows: what exceeds them is summed up by outcome, no count lost."""
    ordered = sorted(rows, key=lambda row: (OUTCOMES.index(row.outcome), -row.count))
    if len(ordered) <= MOST_ROWS:
        return ordered
    spare = 2 * len(OUTCOMES)
    ordered.sort(key=lambda row: (not row.stands, -row.count))
    kept, rest = ordered[: MOST_ROWS - spare], ordered[MOST_ROWS - spare :]
    summed = [
        InputRow(
            kind="other",
            outcome=outcome,
            count=sum(row.count for row in found),
            reason="for various reasons" if outcome != "used" else "",
            examples=[name for row in found for name in row.examples][:MOST_EXAMPLES],
            stands=stands,
        )
        for outcome in OUTCOMES
        for stands in (True, False)
        if (found := [row for row in rest if (row.outcome, row.stands) == (outcome, stands)])
    ]
    return [*kept, *summed]
