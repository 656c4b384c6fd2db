"""Indoor maps: a building drawn for OpenStreetMap (simple indoor tagging) as GeoJSON.

Shops become halls with demands by their kind (``scenewright.domains.hall.demands.programme``);
other rooms, corridors and open areas are what their doors lead to, and stay empty. Broken features
are left out; the brief carries a report of what became of every feature. The map shows the middle
lines of walls. Levels may be named in words ("EG", "Ground floor").
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.building import plan
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.projection import Projection, metres
from scenewright.core.space import Points
from scenewright.domains.hall.demands.programme import shop_kind
from scenewright.domains.hall.indoor.doors import (
    FloorWalls,
    PlacedDoor,
    borders,
    front,
    place_marked_doors,
    walls_of,
)
from scenewright.domains.hall.indoor.floors import (
    MAP_WALL,
    IndoorFloor,
    floors_of,
    levels_or_ground,
    rings,
    role,
    with_points,
)
from scenewright.domains.hall.indoor.report import report_indoor
from scenewright.ground.maps.features import Collection, Feature, SkippedFeature, load
from scenewright.ground.maps.levels import number_levels
from scenewright.ground.maps.place import projection_of

STOREY = 4.0
CEILING = 3.2
MOST_DOORS = 5_000


class IndoorReport(NamedTuple):
    """What was read from an indoor map: the brief, and how it came about.

    ``units`` counts shops and the like, ``filled`` those of at least 30 m², which get demands.
    ``doors`` were marked in the map; ``assumed`` are openings of units without one, their ids
    begin with "assumed-"; ``open_borders`` those between ways, "open-". ``doorless`` are units
    for which no opening could be assumed. ``skipped`` and ``changed`` list features with reasons.
    """

    brief: Brief
    features: int
    units: int
    filled: int
    doors: int
    assumed: int
    open_borders: int
    doorless: tuple[str, ...]
    skipped: tuple[SkippedFeature, ...]
    changed: tuple[SkippedFeature, ...]


class Openings(NamedTuple):
    """Doors of one brief by origin, with the number of the floor they are listed in."""

    found: list[PlacedDoor]
    fronts: list[PlacedDoor]
    open_borders: list[PlacedDoor]
    doorless: list[str]
    lost: list[SkippedFeature]


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of an indoor map. There is no furniture to ``keep``."""
    del keep
    return read_report(path).brief


def read_report(path: Path) -> IndoorReport:
    """The brief of an indoor map, and what was found, assumed, changed and left out."""
    return report(load(path), Path(path).stem)


def recognises(found: Collection) -> bool:
    """Whether a map shows the inside of a building."""
    return any(feature.polygons and role(feature.tags) for feature in found.features)


def brief_of(found: Collection, name: str) -> Brief:
    """The brief of an indoor map already read."""
    return report(found, name).brief


def report(found: Collection, name: str) -> IndoorReport:
    """The brief and report of features already read; InputError if no room is among them."""
    features, words = number_levels(found.features)
    drawn = [f for f in features if f.polygons and role(f.tags)]
    if not drawn:
        raise InputError(
            f"holds no room: none of its {len(found.features) + len(found.skipped)} features is "
            "an area with the tag indoor=room, area or corridor",
            "export a building with simple indoor tagging",
        )
    corners = np.vstack([ring for f in drawn for rings_ in f.polygons for ring in rings_])
    map_ = projection_of(found, corners)
    floors, skipped, changed = floors_of(features, map_)
    if not floors:
        first = " ".join(skipped[0])
        raise InputError(f"none of its {len(drawn)} rooms can be used: {first}", "correct the map")
    named = _assign_room_ids(with_points(floors, _shops(features, map_)))
    openings = _openings(named, features, map_, name)
    placed = [*openings.found, *openings.fronts, *openings.open_borders]
    lost = (*skipped, *openings.lost)
    stated = report_indoor(
        found._replace(features=features),
        map_,
        [floor for _, floor in named],
        [entry.door.id for entry in openings.found],
        lost,
        changed,
    )
    return IndoorReport(
        _brief(name, named, placed, words).model_copy(update={"input_report": stated}),
        len(found.features) + len(found.skipped),
        sum(floor.role == "unit" for _, floor in named),
        sum(bool(floor.demands) for _, floor in named),
        len(openings.found),
        len(openings.fronts),
        len(openings.open_borders),
        tuple(openings.doorless),
        (*found.skipped, *lost),
        changed,
    )


def _assign_room_ids(floors: Iterable[IndoorFloor]) -> list[tuple[str, IndoorFloor]]:
    """Floors with the ids of their rooms: the feature's, with the level if it has several."""
    listed = list(floors)
    several = Counter(floor.feature for floor in listed)
    on_levels = {
        f: len({o.level for o in listed if o.feature == f}) for f, n in several.items() if n > 1
    }
    taken: Counter[str] = Counter()
    pairs = []
    for floor in listed:
        wish = floor.feature
        if on_levels.get(wish, 1) > 1:
            wish = f"{wish}-level-{floor.level:g}"
        while taken[wish]:
            wish = f"{wish}-part"
        taken[wish] += 1
        pairs.append((wish, floor))
    return pairs


def _shops(features: Iterable[Feature], map_: Projection) -> list[tuple[Feature, shapely.Point]]:
    """Points that mark a shop."""
    return [
        (feature, shapely.Point(metres(map_, feature.point[None])[0]))
        for feature in features
        if feature.point is not None and shop_kind(feature.tags) and _levels(feature)
    ]


def _levels(feature: Feature) -> tuple[float, ...]:
    """Levels of a point; none if what it says about them cannot be read."""
    try:
        return levels_or_ground(feature.tags)
    except InputError:
        return ()


def _openings(
    floors: list[tuple[str, IndoorFloor]], features: Iterable[Feature], map_: Projection, name: str
) -> Openings:
    """Doors of all levels: marked ones first; then, where the plan shows none, assumed ones."""
    walls = walls_of([floor for _, floor in floors])
    doors = [f for f in features if f.point is not None and {"door", "entrance"} & f.tags.keys()]
    lost = [
        SkippedFeature(f.id, "a door on a level that is not a number")
        for f in doors
        if not _levels(f)
    ]
    result = Openings([], [], [], [], lost)
    if len(doors) > MOST_DOORS:
        raise InputError(f"holds {len(doors)} doors", f"at most {MOST_DOORS} are read")
    levels = sorted({floor.level for _, floor in floors})
    for level in levels:
        numbers = [i for i, (_, floor) in enumerate(floors) if floor.level == level]
        here = [_point(f, level, map_) for f in doors if level in _levels(f)]
        placed, off = place_marked_doors([walls[i] for i in numbers], here)
        result.found.extend(p._replace(number=numbers[p.number]) for p in placed)
        result.lost.extend(SkippedFeature(*row) for row in off)
    joined = _find_joined_floors(floors, result.found, name)
    for level in levels:
        numbers = [i for i, (_, floor) in enumerate(floors) if floor.level == level]
        _assume(floors, walls, numbers, joined, result)
    return result


def _point(feature: Feature, level: float, map_: Projection) -> tuple[str, dict[str, str], Points]:
    """Id, tags and position of a door on one of its levels."""
    assert feature.point is not None
    name = feature.id if len(_levels(feature)) == 1 else f"{feature.id}-level-{level:g}"
    return name, feature.tags, metres(map_, feature.point[None])[0]


def _assume(
    floors: list[tuple[str, IndoorFloor]],
    walls: list[FloorWalls],
    numbers: list[int],
    joined: set[tuple[int, int]],
    result: Openings,
) -> None:
    """Adds fronts and open borders of one level, given the pairs of floors that doors join."""
    here = [walls[i] for i in numbers]
    own = {number: i for i, number in enumerate(numbers)}
    placed = [p._replace(number=own[p.number]) for p in result.found if p.number in own]
    pairs = {(own[a], own[b]) for a, b in joined if a in own and b in own}
    tree = shapely.STRtree([wall.floor.polygon for wall in here])
    for i, wall in enumerate(here):
        if wall.floor.role != "unit" or any(i in pair for pair in pairs):
            continue
        entry = front(here, tree, i, placed)
        if entry is None:
            result.doorless.append(floors[numbers[i]][0])
            continue
        placed.append(entry)
        result.fronts.append(entry._replace(number=numbers[i]))
    result.open_borders.extend(
        p._replace(number=numbers[p.number]) for p in borders(here, pairs, placed)
    )


def _find_joined_floors(
    floors: list[tuple[str, IndoorFloor]], placed: list[PlacedDoor], name: str
) -> set[tuple[int, int]]:
    """Pairs of floors joined by doors, lower number first; a floor with itself: to the outside."""
    index = {room: i for i, (room, _) in enumerate(floors)}
    pairs = set()
    for space in plan.spaces(_brief(name, floors, placed)):
        for opening in space.openings:
            ends = sorted(index[s] for s in opening.spaces)
            pairs.add((ends[0], ends[-1]))
    return pairs


def _brief(
    name: str,
    floors: list[tuple[str, IndoorFloor]],
    placed: list[PlacedDoor],
    words: dict[float, str] | None = None,
) -> Brief:
    levels = sorted({floor.level for _, floor in floors})
    rooms: list[dict[str, Any]] = []
    for room, floor in floors:
        outline, holes = rings(floor.polygon)
        rooms.append(
            {
                "id": room,
                "name": floor.name,
                "level": f"{floor.level:g}",
                "function": "hall" if floor.role == "way" else "other",
                "outline": outline,
                "holes": holes,
                "doors": [],
                "demands": floor.demands,
            }
        )
    for entry in placed:
        rooms[entry.number]["doors"].append(entry.door)
    return Brief.model_validate(
        {
            "domain": "hall",
            "name": name or "hall",
            "outlines": "centre",
            "wall_thickness": MAP_WALL,
            "levels": [
                {
                    "id": f"{z:g}",
                    "name": (words or {}).get(z, f"Level {z:g}"),
                    "elevation": STOREY * z,
                    "height": CEILING,
                }
                for z in levels
            ],
            "rooms": rooms,
        }
    )
