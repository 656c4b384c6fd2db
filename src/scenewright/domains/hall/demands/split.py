"""The demands of a hall by how they come to stand: laid out, on the stage, or set last."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.domains.hall.accessories import split_accessories
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.bedsides import join_bedsides
from scenewright.domains.hall.demands.companies import group_shown
from scenewright.domains.hall.demands.cross_aisles import break_rows
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.demands.small_groups import drop_small_rings
from scenewright.domains.hall.demands.stands import abut_stands
from scenewright.domains.hall.desks.rows import turn_to_show
from scenewright.domains.hall.desks.stools import keep_stools
from scenewright.domains.hall.desks.ways import part_desks
from scenewright.domains.hall.furnishing.on_stage import split_carried
from scenewright.domains.hall.seats.asked_low_tables import split_low_tables
from scenewright.domains.hall.seats.lounges import join_lounges
from scenewright.domains.hall.seats.seating import join_chairs


class SplitDemands(NamedTuple):
    """Demands that patterns lay out, those that stand on a stage, and small objects set last."""

    wishes: list[HallDemand]
    carried: list[HallDemand]
    small: list[HallDemand]


def find_locked(hall: HallContext) -> tuple[Piece, ...]:
    """The locked pieces of groups of a hall."""
    return tuple(piece for piece in hall.fixed if piece.function not in ("", "fixed"))


def split_demands(
    hall: HallContext,
    asked: list[HallDemand],
    catalog: Catalog,
    together: bool,
    played: list[HallDemand],
) -> SplitDemands:
    """The demands of a hall, chairs joined with tables, sofas with low tables and beds with
    nightstands; pianos and small objects are laid out with the rest if all are ``together``, and
    sofas and beds by themselves. Small objects may belong to what is ``played``, set at doors."""
    asked = [break_rows(wish) for wish in asked]
    if not together:
        asked = [group_shown(wish) for wish in join_bedsides(join_lounges(asked, hall.route))]
    joined = drop_small_rings(hall, join_chairs(asked, catalog))
    joined = joined if together else keep_stools(turn_to_show(joined, catalog))
    parted = part_desks(hall, abut_stands(hall, joined, catalog))
    wishes, carried = split_carried(parted, hall.fixed, together)
    rest, small = split_accessories(wishes, together, played)
    rest, low = split_low_tables(rest) if not together else (rest, [])
    return SplitDemands(rest, carried, [*small, *low])
