"""Low tables that a brief asks for beside lounge seats: they are those the seats stand round."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from scenewright.catalog.kinds import SIZES
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Size
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.hall_layout import PlacedGroup
from scenewright.domains.hall.patterns.around import COMPANY
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.seats.low_tables import CATEGORY, keep_reached, low_tables
from scenewright.domains.hall.seats.reachable import keep_off_seats
from scenewright.domains.hall.solvers.outcome import MeasuredLayout

AROUND = ("around",)
REASON = "no seats are left that could stand round it"


def split_low_tables(wishes: list[HallDemand]) -> tuple[list[HallDemand], list[HallDemand]]:
    """Demands without the low tables of usual size that each have a group of seats round a table
    in the same zones, and those tables, ``set_last``."""
    room = {wish.id: _count_companies(wish) for wish in wishes}
    rest, low = list[HallDemand](), list[HallDemand]()
    for wish in wishes:
        seats = [w.id for w in wishes if room[w.id] >= len(wish.sizes) and w.zones == wish.zones]
        usual = all(size == Size(*SIZES[CATEGORY][1]) for size in wish.sizes)
        if wish.category == CATEGORY and wish.unstated and usual and seats:
            room[seats[0]] -= len(wish.sizes)
            low.append(wish._replace(set_last=True))
        else:
            rest.append(wish)
    return rest, low


def _count_companies(wish: HallDemand) -> int:
    """In how many companies the seats of a demand stand, at least; 0 for other patterns."""
    return -(-len(wish.sizes) // COMPANY) if wish.patterns == AROUND else 0


def set_low_tables(
    hall: HallContext,
    wishes: Sequence[HallDemand],
    groups: tuple[PlacedGroup, ...],
    pieces: tuple[Piece, ...],
    others: tuple[Piece, ...],
    problem: HallProblem,
    layout: MeasuredLayout,
    catalog: Catalog,
) -> tuple[tuple[Piece, ...], tuple[LeftOut, ...]]:
    """The low tables that companies of seats stand round and people get to, those asked for among
    them, and what of these finds no seats."""
    tables = keep_reached(problem, layout, low_tables(groups, pieces, others, catalog))
    tables = keep_off_seats(hall.space, problem, tables, (*pieces, *others), hall.route)
    return claim_low_tables(hall, wishes, groups, tables)


def claim_low_tables(
    hall: HallContext,
    wishes: Sequence[HallDemand],
    groups: Sequence[PlacedGroup],
    tables: tuple[Piece, ...],
) -> tuple[tuple[Piece, ...], tuple[LeftOut, ...]]:
    """The low tables of a hall, as many as asked for by the demands they now belong to, and what of
    these finds no seats."""
    zones, owner = {group.id: group.zone for group in groups}, dict[str, str]()
    missing = list[LeftOut]()
    for wish in (wish for wish in wishes if wish.set_last and wish.category == CATEGORY):
        free = [
            table.id
            for table in tables
            if table.id not in owner and (not wish.zones or zones[table.group] in wish.zones)
        ][: len(wish.sizes)]
        owner |= dict.fromkeys(free, wish.id)
        if len(free) < len(wish.sizes):
            lack, many = len(wish.sizes) - len(free), len(wish.sizes)
            what = f"{lack} of {many} {wish.name}" if many > 1 else wish.name
            missing.append(LeftOut(hall.space.id, what, REASON, wish.required))
    claimed = (replace(t, function=owner[t.id]) if t.id in owner else t for t in tables)
    return tuple(claimed), tuple(missing)
