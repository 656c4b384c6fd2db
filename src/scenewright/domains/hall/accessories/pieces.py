"""Small objects that have found their spots, as pieces and groups of a hall."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import shapely

from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import STOPPED, LeftOut
from scenewright.domains.hall.accessories import ACCESSORIES
from scenewright.domains.hall.accessories.place import Placed, StandingHall, place_accessories
from scenewright.domains.hall.accessories.stools import STOOL
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.hall_layout import Layer, PatternPart, PlacedGroup
from scenewright.domains.hall.problem import Floats

REASON = "no place is left for it that bars no way"
REMEDIES = {STOOL: "ask for fewer, a longer counter, or less beside it"}
"""Remedies by category."""

Furnished = tuple[tuple[Piece, ...], tuple[PlacedGroup, ...], tuple[LeftOut, ...]]
"""Pieces, their groups, and what found no place."""


class SmallGroup(NamedTuple):
    """The objects of one demand in one zone: its id, the zone, and their sizes and boxes (5,)."""

    id: str
    wish: HallDemand
    zone: str
    sizes: tuple[Size, ...]
    boxes: tuple[Floats, ...]


def furnish_accessories(
    there: StandingHall, catalog: Catalog, stopped: Callable[[], bool] = lambda: False
) -> Furnished:
    """The demands ``set_last`` in a hall that stands otherwise; the objects of one in one zone are
    a group. Once ``stopped``, those not placed are listed so."""
    small = [w for w in there.wishes if w.set_last and w.category in ACCESSORIES]
    if not small:
        return (), (), ()
    placed = place_accessories(there, small, stopped)
    why = STOPPED if stopped() else REASON
    groups = _share_out(there, small, placed)
    made = [_make_pieces(there.hall.space.id, one, catalog) for one in groups]
    rows = [_group(there.hall.space.id, *row) for row in zip(groups, made, strict=True)]
    return sum(made, ()), tuple(rows), _report(there, small, placed, why)


def _share_out(there: StandingHall, small: list[HallDemand], placed: Placed) -> list[SmallGroup]:
    """The groups of some demands, by zones."""
    taken, found = {piece.group for piece in there.pieces}, list[SmallGroup]()
    for wish, boxes in zip(small, placed, strict=True):
        stand = [row for row in zip(wish.sizes, boxes, strict=True) if row[1] is not None]
        zones = [_find_zone(there, box) for _, box in stand if box is not None]
        for zone in dict.fromkeys(zones):
            mine = [row for row, where in zip(stand, zones, strict=True) if where == zone]
            name = _name(f"{there.hall.space.id}/{wish.id}", taken)
            taken.add(name)
            rows = tuple(box for _, box in mine if box is not None)
            found.append(SmallGroup(name, wish, zone, tuple(size for size, _ in mine), rows))
    return found


def _find_zone(there: StandingHall, box: Floats) -> str:
    """The zone nearest to the middle of a box (5,)."""
    far = [
        shapely.Polygon(z.outline).distance(shapely.Point(box[:2])) for z in there.hall.plan.zones
    ]
    return there.hall.plan.zones[far.index(min(far))].id


def _name(stem: str, taken: set[str]) -> str:
    """The first name that is free, numbered as those of other groups are."""
    names = (stem if count == 1 else f"{stem}-{count}" for count in range(1, len(taken) + 2))
    return next(name for name in names if name not in taken)


def _make_pieces(space: str, group: SmallGroup, catalog: Catalog) -> tuple[Piece, ...]:
    wish, rows = group.wish, zip(group.sizes, group.boxes, strict=True)
    found = list[Piece]()
    for number, (size, (x, y, heading, *_)) in enumerate(rows, 1):
        asset = catalog.choose_called(wish.category, f"{wish.id} {wish.name}", number - 1)
        asset = asset or catalog.choose(wish.category, size)
        turned = (float(heading) + math.pi) % (2 * math.pi) - math.pi
        found.append(
            Piece(
                id=f"{group.id}/{wish.category}_{number}",
                category=wish.category,
                asset=asset.id if asset else "",
                space=space,
                pose=Pose(float(x), float(y), 0.0, turned),
                size=size,
                group=group.id,
                function=wish.id,
                footprint=footprint_of(asset, size),
            )
        )
    return tuple(found)


def _group(space: str, group: SmallGroup, pieces: tuple[Piece, ...]) -> PlacedGroup:
    first, parts = pieces[0].pose, (PatternPart("single", (Layer(len(pieces), 0.0, 0.0),)),)
    x = sum(piece.pose.x for piece in pieces) / len(pieces)
    y = sum(piece.pose.y for piece in pieces) / len(pieces)
    names = tuple(piece.id for piece in pieces)
    pose = (x, y, first.heading)
    return PlacedGroup(group.id, group.wish.id, space, group.zone, "single", pose, parts, names)


def _report(
    there: StandingHall, small: list[HallDemand], placed: Placed, why: str
) -> tuple[LeftOut, ...]:
    """Objects without a spot, by name."""
    found = []
    for wish, boxes in zip(small, placed, strict=True):
        absent, many = sum(box is None for box in boxes), len(boxes)
        if absent:
            what = f"{absent} of {many} {wish.name}" if many > 1 else wish.name
            remedy = REMEDIES.get(wish.category)
            reason = f"{why}: {remedy}" if remedy and why == REASON else why
            found.append(LeftOut(there.hall.space.id, what, reason, wish.required))
    return tuple(found)
