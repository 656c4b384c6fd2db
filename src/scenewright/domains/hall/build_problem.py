"""From a hall and the units to lay out in it to the problem that is solved."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import (
    DoorApproach,
    before,
    door_zone,
    edges_of,
    gates,
    throat,
)
from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.core.piece_outlines import boxes_of, polygons_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.hall.classes import is_audience_seat
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.demands.themes import Island
from scenewright.domains.hall.measures import HEAD_HEIGHT
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.domains.hall.problem import Floats, HallGround, HallProblem, Ints, Units
from scenewright.domains.hall.settings import HallSettings
from scenewright.domains.hall.visit.visitor_plan import plan_visitors
from scenewright.domains.hall.walls.corners import corner_share
from scenewright.domains.hall.walls.curved import WallNeed, space_places
from scenewright.domains.hall.walls.partitions import Host, lacking
from scenewright.domains.hall.zoning.assign import Unit
from scenewright.domains.hall.zoning.borders import Border, WallStretch, wall_stretches, zone_edges
from scenewright.domains.hall.zoning.zones import HallPlan

LANDING = 1.5
"""Kept free inside a door, in metres: people stop there."""
WINDOW = 0.3
ZONE_SHARE, MOST_OF_ZONE = 0.75, 0.8
"""δ_min: this share of what its objects demand of a zone, and at most."""
STARTS = 2.0
"""How wide the floor is from which a walk begins in a hall without doors, in routes."""
MARGIN = 0.1
"""Passages are planned this much wider than asked for, in metres."""
EACH = 2.0
"""Access flag of sides that must all be reached: those of two rows back to back."""
SIDES = ("front", "left", "back", "right")


class HallContext(NamedTuple):
    """A hall ready to be posed: its space, zones and links, borders between zones, the walls of
    each zone, fixed objects, the width of the route, objects of other rooms that
    reach in, the ``passage`` wished for between objects people walk round, boxes of the floor on
    which people queue, and the ``island`` that stands where floor is left empty."""

    space: Space
    plan: HallPlan
    borders: tuple[Border, ...]
    walls: tuple[tuple[WallStretch, ...], ...]
    fixed: tuple[Piece, ...]
    route: float
    beside: tuple[Piece, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Ids of the zones."""
        return tuple(zone.id for zone in self.plan.zones)

    settings: HallSettings = HallSettings()
    passage: float = 1.2
    queues: tuple[tuple[float, ...], ...] = ()
    island: Island = ()


def hall_of(
    space: Space,
    plan: HallPlan,
    borders: tuple[Border, ...],
    fixed: tuple[Piece, ...],
    route: float,
    beside: tuple[Piece, ...] = (),
    passage: float = 1.2,
) -> HallContext:
    """Everything about a hall that does not depend on what it is to hold."""
    walls = tuple(_without_windows(wall_stretches(zone, space)) for zone in plan.zones)
    return HallContext(space, plan, borders, walls, fixed, route, beside, passage=passage)


def wall_lengths(hall: HallContext) -> Floats:
    """Metres of wall (z,) that rows may stand along in each zone."""
    return np.array([sum(_length(wall) for wall in walls) for walls in hall.walls])


def taken_floor(hall: HallContext) -> Floats:
    """Boxes (n, 5) of the floor that doors and windows need, and of fixed objects."""
    solid = [piece for piece in (*hall.fixed, *hall.beside) if _solid(piece)]
    standing = [list(box) for piece in solid for box in boxes_of(piece)]
    queues = [list(box) for box in hall.queues]
    return _rows([*_kept_free(hall.space, gates(hall.space)), *queues, *standing], 5)


def zone_areas(hall: HallContext) -> Floats:
    """Square metres of each zone, less fixed objects."""
    shapes = [shapely.Polygon(zone.outline, zone.holes) for zone in hall.plan.zones]
    taken = [*polygons_of([p for p in (*hall.fixed, *hall.beside) if _solid(p)])]
    solid = shapely.union_all(taken) if taken else shapely.Polygon()
    return np.array([shape.difference(solid).area for shape in shapes])


def build_problem(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    hosts: tuple[Host, ...],
    weights: dict[str, float],
    catalog: Catalog,
) -> HallProblem:
    """The problem of laying out some units."""
    sizes = [s for u in units for s in wishes[u.demand].sizes[u.first : u.last]]
    counts = np.array([unit.last - unit.first for unit in units], np.int64)
    ends = np.cumsum(counts)
    clear = np.repeat(
        np.array([wishes[u.demand].clearance for u in units]).reshape(-1, 4), counts, axis=0
    )
    flat = np.array([(size.width, size.depth) for size in sizes], np.float64).reshape(-1, 2)
    return HallProblem(
        ground=_ground(hall, wishes, units, hosts, catalog),
        units=Units(
            sizes=flat,
            clear=np.array(clear, np.float64).reshape(-1, 4),
            access=_access(wishes, units, catalog),
            spans=np.stack([ends - counts, ends], 1),
            zones=np.array([unit.zone for unit in units], np.int64),
            choices=_choices(wishes, units, hall.settings.whole),
            demands=np.array([unit.demand for unit in units], np.int64),
            targets=_targets(wishes, units),
        ),
        names=unit_names(hall, wishes, units),
        zone_names=hall.names,
        weights=weights,
        route=hall.route,
        settings=hall.settings,
        visitors=plan_visitors(hall.space, hall.fixed, wishes, units),
        passage=hall.passage,
    )


def unit_names(hall: HallContext, wishes: list[HallDemand], units: list[Unit]) -> tuple[str, ...]:
    """Ids of the groups: the demand's, numbered where it is in several or stands already."""
    taken = {piece.group for piece in hall.fixed}
    names: list[str] = []
    for unit in units:
        stem, count = f"{hall.space.id}/{wishes[unit.demand].id}", 1
        name = stem
        while name in taken:
            count += 1
            name = f"{stem}-{count}"
        taken.add(name)
        names.append(name)
    return tuple(names)


def _ground(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    hosts: tuple[Host, ...],
    catalog: Catalog,
) -> HallGround:
    zones, names = hall.plan.zones, hall.names
    rings = [zone_edges(zone) for zone in zones]
    ends = np.cumsum([len(ring) for ring in rings])
    areas = zone_areas(hall)
    pairs = [(names.index(k.first), names.index(k.second)) for k in hall.plan.links]
    low, high = hall.space.outline.min(0), hall.space.outline.max(0)
    seen = gates(hall.space)
    doors = [gate for gate in seen if gate.opening.kind != "window"]
    solid = [piece for piece in (*hall.fixed, *hall.beside) if _solid(piece)]
    locked = _find_locked(hall, catalog)
    return HallGround(
        edges=edges_of(hall.space),
        obstacles=_rows([box for piece in solid for box in boxes_of(piece)], 5),
        keep_free=_rows([*_kept_free(hall.space, seen), *map(list, hall.queues)], 5),
        doors=_rows([throat(gate) for gate in doors] or _list_starts(hall), 5),
        zone_edges=np.concatenate(rings),
        zone_spans=np.stack([ends - [len(ring) for ring in rings], ends], 1),
        zone_areas=areas,
        zone_bounds=np.array([[*z.outline.min(0), *z.outline.max(0)] for z in zones]),
        zone_least=_least(wishes, units, areas),
        stretches=_rows(_stretches(hall, wishes, units), 6),
        borders=_rows(_link_borders(hall.borders, pairs), 5),
        links=_rows(
            [[*p, k.width + MARGIN] for p, k in zip(pairs, hall.plan.links, strict=True)], 3
        ),
        hosts=_rows([list(host.row) for host in hosts], 6),
        host_spans=_rows([list(host.most) for host in hosts], 2),
        host_shifts=_rows([list(host.shift) for host in hosts], 2),
        zone_walls=np.maximum(lacking(units, wishes, np.zeros(len(zones)), True), 0.0),
        bounds=np.concatenate([low, high]),
        standing=_rows([list(boxes_of(piece)[0]) for piece, _ in locked], 5),
        standing_access=_rows([[float(k in sides) for k in SIDES] for _, sides in locked], 4),
    )


def _list_starts(hall: HallContext) -> list[list[float]]:
    """Where a walk begins in a hall without doors, as maps draw some: the middle of its roomiest
    floor, where the referee begins too; nowhere where groups stay as printed."""
    solid = polygons_of([p for p in (*hall.fixed, *hall.beside) if _solid(p)])
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    bare = floor.difference(shapely.union_all([*solid]))
    if hall.settings.whole or bare.is_empty:
        return []
    circle = shapely.maximum_inscribed_circle(bare, tolerance=0.05)
    return [[*circle.coords[0], 0.0, STARTS * hall.route, STARTS * hall.route]]


def _find_locked(hall: HallContext, catalog: Catalog) -> list[tuple[Piece, tuple[str, ...]]]:
    """Locked objects of groups that one walks up to, and the sides they are used from."""
    found: list[tuple[Piece, tuple[str, ...]]] = []
    for piece in hall.fixed:
        kind = catalog.kinds.get(piece.category)
        mine = piece.function not in ("", "fixed", "partition") and _solid(piece)
        seat = is_audience_seat(piece.category, piece.size.width)
        if mine and not seat and kind is not None and kind.access:
            found.append((piece, tuple(kind.access)))
    return found


def _least(wishes: list[HallDemand], units: list[Unit], areas: Floats) -> Floats:
    demanded = np.zeros(len(areas))
    for unit in units:
        front, left, back, right = wishes[unit.demand].clearance
        for size in wishes[unit.demand].sizes[unit.first : unit.last]:
            demanded[unit.zone] += (size.width + left + right) * (size.depth + front + back)
    return np.minimum(ZONE_SHARE * demanded / np.maximum(areas, 1e-9), MOST_OF_ZONE)


def _kept_free(space: Space, seen: tuple[DoorApproach, ...]) -> list[list[float]]:
    boxes = []
    for gate in seen:
        if gate.opening.kind == "window":
            boxes.append(before(gate, gate.opening.width, WINDOW))
        else:
            boxes += door_zone(space, gate)
            boxes.append(before(gate, gate.opening.width, LANDING))
    return boxes


def _stretches(hall: HallContext, wishes: list[HallDemand], units: list[Unit]) -> list[list[float]]:
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    return [
        [wall.x0, wall.y0, wall.x1, wall.y1, float(number), corner_share(wall, floor)]
        for number, walls in enumerate(hall.walls)
        for wall in space_places(walls, _wall_need(wishes, units, number))
    ]


def _wall_need(wishes: list[HallDemand], units: list[Unit], zone: int) -> WallNeed:
    """The needs of the units of a zone for its walls."""
    rows = [
        (size.width, size.depth, sum(wishes[unit.demand].clearance[1::2]))
        for unit in units
        if unit.zone == zone and wishes[unit.demand].at_wall
        for size in wishes[unit.demand].sizes[unit.first : unit.last]
    ]
    wide, deep, side = np.array(rows).max(0) if rows else (0.0, 0.0, 0.0)
    return WallNeed(float(wide), float(deep), len(rows), bool(side > 0.0))


def _without_windows(walls: tuple[WallStretch, ...]) -> tuple[WallStretch, ...]:
    """Stretches without their windows, which objects at the wall would cover."""
    found = []
    for wall in walls:
        cuts = [0.0, *(t for low, high, _ in sorted(wall.windows) for t in (low, high))]
        cuts.append(_length(wall))
        for low, high in zip(cuts[::2], cuts[1::2], strict=True):
            if high - low > 0.4:
                found.append(_piece_of(wall, low, high))
    return tuple(found)


def _piece_of(wall: WallStretch, low: float, high: float) -> WallStretch:
    length = _length(wall)
    dx, dy = (wall.x1 - wall.x0) / length, (wall.y1 - wall.y0) / length
    return WallStretch(
        wall.x0 + dx * low, wall.y0 + dy * low, wall.x0 + dx * high, wall.y0 + dy * high
    )


def _length(wall: WallStretch) -> float:
    return float(np.hypot(wall.x1 - wall.x0, wall.y1 - wall.y0))


def _link_borders(borders: tuple[Border, ...], pairs: list[tuple[int, int]]) -> list[list[float]]:
    numbers = {frozenset(pair): number for number, pair in enumerate(pairs)}
    return [
        [*border.start, *border.end, float(numbers[frozenset((border.first, border.second))])]
        for border in borders
        if frozenset((border.first, border.second)) in numbers
    ]


def _access(wishes: list[HallDemand], units: list[Unit], catalog: Catalog) -> Floats:
    rows = []
    for unit in units:
        category = wishes[unit.demand].category
        kind = catalog.kinds.get(category, Kind(category))
        sides: tuple[str, ...] = kind.access
        if is_audience_seat(category, wishes[unit.demand].sizes[0].width):
            sides = ()  # one goes along the row, sideways
        elif wishes[unit.demand].lounges and not wishes[unit.demand].aisle:
            sides = ("left", "right")
        elif wishes[unit.demand].double:
            sides = ("front", "back")
        elif wishes[unit.demand].turned:
            sides = tuple(side for k, side in enumerate(SIDES) if SIDES[k - 2] in sides)
        elif wishes[unit.demand].at_wall and kind.reached_from != sides:
            sides = tuple(side for side in kind.reached_from if side != "back")
        own = wishes[unit.demand].used
        sides, each = own or sides, EACH if own or wishes[unit.demand].double else 1.0
        rows += [[each * (side in sides) for side in SIDES]] * (unit.last - unit.first)
    return _rows(rows, 4)


def _choices(wishes: list[HallDemand], units: list[Unit], whole: bool) -> Ints:
    """Patterns (g, 8) a unit may take; the paper's groups stand at walls or free, never either."""
    rows = np.zeros((len(units), len(PATTERNS)), np.int64)
    codes = {name: code for code, name in enumerate(PATTERNS)}
    for row, unit in zip(rows, units, strict=True):
        alone = unit.last - unit.first == 1
        for name in wishes[unit.demand].patterns:
            if name == "wall" and (alone or whole) and not wishes[unit.demand].at_wall:
                continue
            row[codes["single" if alone and name != "wall" else name]] = 1
    return rows


def _targets(wishes: list[HallDemand], units: list[Unit]) -> Ints:
    """The first unit of the demand each unit looks at."""
    first = {wishes[unit.demand].id: k for k, unit in reversed(list(enumerate(units)))}
    return np.array([first.get(wishes[u.demand].facing, -1) for u in units], np.int64)


def _solid(piece: Piece) -> bool:
    return piece.pose.z < HEAD_HEIGHT and piece.size.height > 0.05 and piece.on is None


def _rows(rows: list[list[float]], width: int) -> Floats:
    return np.array(rows, np.float64).reshape(-1, width)
