"""Which demands stand together in a zone, what seats for an audience look at, and at which tables
chairs stand."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.catalog.kinds.usual import DESKS, TABLES, is_high
from scenewright.core.brief.zones import Demand
from scenewright.domains.hall.classes import SHOWS, TABLE_CHAIRS, is_altar, is_audience_seat
from scenewright.domains.hall.demands.checked import usual_size

MEALS = (*TABLES, "reading_table")
AT_TABLES = (*TABLES, *DESKS, "reading_table", "carrel", "interactive_table")


def may_share_zone(one: Demand, other: Demand) -> bool:
    """Whether two demands may stand in one zone.

    >>> may_share_zone(Demand(category="box", zone="a"), Demand(category="box", zone=["a", "b"]))
    True
    """
    here, there = _zones(one), _zones(other)
    return not here or not there or bool(here & there)


def find_shows(demands: Sequence[Demand], ids: Sequence[str]) -> list[str]:
    """The id of the stage, screen or lectern each demand looks at if it does not say: one in its
    own zone before others; empty for what is no audience."""
    named = zip(demands, ids, strict=True)
    shows = [
        (d, name)
        for d, name in named
        if d.category in SHOWS or is_altar(d.category, f"{name} {d.name}")
    ]
    shows.sort(key=lambda row: row[0].category == "lectern")
    found = []
    for one in demands:
        near = sorted(shows, key=lambda row: not _zones(row[0]) & _zones(one))
        found.append(near[0][1] if near and _is_audience(one, demands) else "")
    return found


def find_tables(demands: Sequence[Demand], ids: Sequence[str]) -> list[str]:
    """The id of the desk or table at which the chairs of each demand stand, one of its own zone
    before others, a desk before tables for office chairs; empty for what is no chair, looks
    somewhere, has a pattern of its own or has none."""
    named = list(zip(demands, ids, strict=True))
    found = []
    for one in demands:
        kinds = [*DESKS, *MEALS] if one.category == "office_chair" else [*MEALS, *DESKS]
        free = one.category in TABLE_CHAIRS and not (one.facing or one.patterns or one.place)
        near = [row for row in named if free and may_share_zone(one, row[0])]
        near = [row for row in near if row[0].category in kinds and _may_sit_at(row[0])]
        near.sort(key=lambda row: (_zones(row[0]) != _zones(one), kinds.index(row[0].category)))
        found.append(near[0][1] if near else "")
    return found


def _may_sit_at(table: Demand) -> bool:
    """Whether chairs stand at a table: it is not one to stand at."""
    heights = (size[2] for size in table.sizes or [usual_size(table)])
    return not is_high(table.category, max(heights))


def _is_audience(one: Demand, demands: Sequence[Demand]) -> bool:
    tables = (d for d in demands if d.category in AT_TABLES and may_share_zone(one, d))
    return is_audience_seat(one.category, usual_size(one)[0]) or (
        one.category in TABLE_CHAIRS and next(tables, None) is None
    )


def _zones(demand: Demand) -> set[str]:
    return {demand.zone} if isinstance(demand.zone, str) else set(demand.zone or ())
