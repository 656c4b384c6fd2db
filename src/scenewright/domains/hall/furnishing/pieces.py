"""From a solved hall to its pieces and its scene graph."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

import numpy as np
import shapely

from scenewright.catalog.suggestions import list_called
from scenewright.core.catalog import Asset, Catalog, footprint_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand, LoungePart
from scenewright.domains.hall.desks.staff_room import Place, part_row
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.hall_layout import Layer, PatternPart, PlacedGroup
from scenewright.domains.hall.patterns import ACROSS, ALONG, CODE, NUMBER, PART, PATTERNS
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.seats.lounges import set_parts
from scenewright.domains.hall.seats.seating import bare_tables
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.zoning.assign import Unit

NAMES = tuple(PATTERNS)
OWN, SHOWN = "box", "exhibit_island"
"""The kind of things of one's own, and that of large things that are shown, as cars."""


def furnish_hall(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    problem: HallProblem,
    boxes: Floats,
    catalog: Catalog,
) -> tuple[Piece, ...]:
    """One piece an object, in the order of the problem, those of a row one after another.

    ``boxes`` (n, 5) x, y, heading, width, depth in metres and radians.
    """
    pieces: list[Piece] = []
    each = [wishes[unit.demand] for unit in units for _ in range(unit.first, unit.last)]
    bare = iter(bare_tables(each, boxes).tolist())
    for unit, group in zip(units, problem.names, strict=True):
        wish = wishes[unit.demand]
        places: list[Place] = []
        for k, size in enumerate(wish.sizes[unit.first : unit.last], unit.first):
            x, y, heading = next(bare)[:3]
            pose = Pose(x, y, 0.0, _wrap_angle(heading))
            low, deep = min(size.height, hall.space.height), 2 * wish.chairs + wish.before
            wide, deep = size.width - 2 * wish.aside, size.depth - deep - wish.staff
            fitted = Size(round(wide, 9), round(deep, 9), low)
            if wish.lounges:
                lounge = wish.lounges[k]
                before = sum(len(own) for own in wish.lounges[unit.first : k])
                pieces += _furnish_lounge(hall, lounge, group, before, pose, catalog)
                continue
            places += part_row(wish, pose, fitted)
        rows = enumerate(places, 1)
        pieces += [make_piece(hall, wish, group, number, place, catalog) for number, place in rows]
    return tuple(pieces)


def make_piece(
    hall: HallContext, wish: HallDemand, group: str, number: int, place: Place, catalog: Catalog
) -> Piece:
    """The object of a group with a number, at its place."""
    pose, size = place
    asset = _model_of(wish, hall.space.name, number, size, catalog)
    return Piece(
        id=f"{group}/{wish.category}_{number}",
        category=wish.category,
        asset=asset.id if asset else "",
        space=hall.space.id,
        pose=pose,
        size=size,
        group=group,
        function=wish.id,
        footprint=footprint_of(asset, size),
    )


def _furnish_lounge(
    hall: HallContext,
    lounge: tuple[LoungePart, ...],
    group: str,
    before: int,
    pose: Pose,
    catalog: Catalog,
) -> Iterator[Piece]:
    """The pieces of a lounge at a pose; ``before`` pieces of its group come before
    them."""
    told = Counter[str]()
    for part, at in set_parts(lounge, pose):
        told[part.wish.id] += 1
        number = before + told[part.wish.id]
        yield make_piece(hall, part.wish, group, number, (at, part.size), catalog)


def _model_of(
    wish: HallDemand, hall: str, number: int, size: Size, catalog: Catalog
) -> Asset | None:
    """The model that draws an object: one that is called as the demand or else its ``hall`` is (a
    bakery), another for the next object where there are several (paintings, cars), else one of its
    kind and size. A box of one's own called as a known thing of its size is drawn as that."""
    known = _list_known(wish.name, number, size, catalog) if wish.category == OWN else ()
    for asset in known:
        return asset
    names = (f"{wish.id} {wish.name}", hall)
    called = (catalog.choose_called(wish.category, name, number - 1) for name in names)
    return next((one for one in called if one), None) or catalog.choose(wish.category, size)


def _list_known(name: str, number: int, size: Size, catalog: Catalog) -> Iterator[Asset]:
    """The models of the things a name says that are drawn at a size."""
    shown = catalog.choose_called(SHOWN, name.split()[-1] if name.split() else "", number - 1)
    kinds = (catalog.choose(kind, size) for kind in list_called(name, catalog.kinds))
    for asset in (shown, *kinds):
        if asset is not None and asset.category != OWN:
            limits = zip(asset.smallest, size, asset.largest, strict=True)
            if all(low <= side <= high for low, side, high in limits):
                yield asset


def placed_groups(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    problem: HallProblem,
    kept: Kept,
    pieces: tuple[Piece, ...],
) -> tuple[PlacedGroup, ...]:
    """The groups of the scene graph."""
    found: list[PlacedGroup] = []
    layer = 0
    for number, (unit, name) in enumerate(zip(units, problem.names, strict=True)):
        own = wishes[unit.demand].id
        mine = tuple(p for p in pieces if p.group == name and p.function == own)
        used = int(kept.rows[number, 1])
        layers = kept.layers[layer : layer + used]
        pattern = NAMES[int(kept.rows[number, 0])]
        parts = _parts(pattern, layers, float(kept.pose[number, 3]), len(mine))
        found.append(
            PlacedGroup(
                id=name,
                demand=own,
                space=hall.space.id,
                zone=hall.names[unit.zone],
                pattern=pattern,
                pose=_pose(pattern, kept.pose[number], mine),
                parts=parts,
                objects=tuple(piece.id for piece in mine),
            )
        )
        layer += int(capacity(np.array(unit.last - unit.first)))
    return tuple(found)


def kept_groups(hall: HallContext, locked: tuple[Piece, ...]) -> tuple[PlacedGroup, ...]:
    """Groups that stand already, as single objects; their zone is where their middle lies."""
    found = []
    for name in dict.fromkeys(piece.group for piece in locked if piece.function != "partition"):
        mine = tuple(piece for piece in locked if piece.group == name)
        x, y = np.mean([piece.pose[:2] for piece in mine], axis=0)
        inside = [
            zone.id
            for zone in hall.plan.zones
            if shapely.Polygon(zone.outline).contains(shapely.Point(x, y))
        ]
        found.append(
            PlacedGroup(
                id=name,
                demand=mine[0].function,
                space=hall.space.id,
                zone=inside[0] if inside else hall.names[0],
                pattern="single",
                pose=(float(x), float(y), mine[0].pose.heading),
                parts=(PatternPart("single", (Layer(len(mine), 0.0, 0.0),)),),
                objects=tuple(piece.id for piece in mine),
            )
        )
    return tuple(found)


def _parts(pattern: str, layers: Floats, extra: float, count: int) -> tuple[PatternPart, ...]:
    if pattern == "wall":
        return (PatternPart("wall", (Layer(count, extra, 0.0),)),)
    if pattern == "single":
        return (PatternPart("single", (Layer(count, 0.0, 0.0),)),)
    parts: list[PatternPart] = []
    for number in np.unique(layers[:, PART]):
        rows = layers[layers[:, PART] == number]
        parts.append(
            PatternPart(
                NAMES[int(rows[0, CODE])],
                tuple(Layer(int(r[NUMBER]), float(r[ALONG]), float(r[ACROSS])) for r in rows),
                extra if pattern == "fan" else 0.0,
                extra if pattern == "chain" else 0.0,
            )
        )
    return tuple(parts)


def _pose(pattern: str, pose: Floats, pieces: tuple[Piece, ...]) -> tuple[float, float, float]:
    if pattern not in ("wall", "single"):
        return (float(pose[0]), float(pose[1]), _wrap_angle(float(pose[2])))
    x, y = np.mean([piece.pose[:2] for piece in pieces], axis=0)
    return (float(x), float(y), pieces[0].pose.heading)


def _wrap_angle(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
