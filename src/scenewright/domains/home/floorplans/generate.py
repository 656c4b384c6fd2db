"""A floor plan of a home as a brief, from a programme."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.outline_forms import OutlineName, check_outline, draw_outline
from scenewright.core.asked import read_asked
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains.home.floorplans import openings
from scenewright.domains.home.floorplans.annealing import Storey, divide
from scenewright.domains.home.floorplans.openings import WALL
from scenewright.domains.home.floorplans.outlines import Ground, draw_ground
from scenewright.domains.home.floorplans.programme import BEDROOMS, ROWS, list_rooms, wanted_areas

Floats = NDArray[np.float64]
MOST_ROOMS, MOST_STOREYS = 8, 3
LEAST_A_ROOM, MOST_A_ROOM = 17.0, 45.0
"""Bounds of a home's floor a habitable room, in square metres."""
LEAST_A_STOREY = 42.0
"""Least floor of a storey with stairs, in square metres."""
ATTEMPTS = 240
MOST_ABOVE = 3
"""Bedrooms of an upper storey whose doors find a place along the hall."""
CEILING_HEIGHT, STOREY_RISE = 2.6, 2.9
WALLS = 1.07
"""Floor between middle lines to floor between walls, as it usually is."""


class PlanRequest(NamedTuple):
    """What a plan is asked for: habitable ``rooms`` (living room, bedrooms, studies), square metres
    of floor (0: as many as usual), ``storeys``, the form of the ``outline`` (empty: drawn)."""

    rooms: int = 3
    area: float = 0.0
    storeys: int = 1
    outline: OutlineName | None = None


def generate(request: PlanRequest, seed: int = 0) -> Brief:
    """A home with rooms, walls, doors and windows, the same for the same seed.

    A storey is divided by :func:`~.annealing.divide`; a plan one of whose rooms is too narrow,
    dark or out of reach is drawn anew. Raises :class:`InputError` for what cannot be built.

    >>> brief = generate(PlanRequest(rooms=3, area=75.0), seed=7)
    >>> sorted(room.id for room in brief.rooms)[:3]
    ['bath', 'child', 'double']
    """
    request = _checked(request, seed)
    for attempt in range(ATTEMPTS):
        made = _try(request, np.random.default_rng([seed, attempt]))
        if made is not None:
            document = {"name": f"Home {seed}", **made}
            return Brief.model_validate(document)
    raise InputError(
        f"no plan of {request.rooms} rooms on {request.area:.0f} m² came out in {ATTEMPTS} tries",
        "give it more floor, another seed or another outline",
    )


def generate_home(asked: Mapping[str, Any], seed: int = 0) -> Brief:
    """The plan that :func:`generate` makes of the keys of a :class:`PlanRequest`, any left out."""
    return generate(read_asked(PlanRequest, asked, "home"), seed)


def _checked(request: PlanRequest, seed: int) -> PlanRequest:
    """The request with its area, or a fault in one line."""
    rooms, area, storeys, outline = request
    if not 1 <= rooms <= MOST_ROOMS:
        raise InputError(f"{rooms} rooms are asked for", f"1 to {MOST_ROOMS} can be planned")
    if not 1 <= storeys <= MOST_STOREYS:
        raise InputError(f"{storeys} storeys are asked for", f"1 to {MOST_STOREYS} can be planned")
    if rooms < 2 * storeys - 1:
        raise InputError(f"{rooms} rooms do not fill {storeys} storeys", "ask for more rooms")
    check_outline(outline, seed)
    least = max(LEAST_A_ROOM * rooms + 8, LEAST_A_STOREY * storeys * (storeys > 1))
    most = MOST_A_ROOM * rooms + 20
    if area == 0:
        area = max(least * 1.05, 22.0 * rooms + 12)
    if not isfinite(area) or not least <= area <= most:
        fault = f"{area:g} m² do not suit {rooms} rooms on {storeys} storeys"
        raise InputError(fault, f"give {least:.0f} to {most:.0f} m²")
    return request._replace(area=float(area))


def _try(request: PlanRequest, rng: np.random.Generator) -> dict[str, Any] | None:
    """One plan; None where a storey breaks a rule."""
    outline = request.outline or draw_outline(rng)
    area = request.area * WALLS / request.storeys
    ground = draw_ground(outline, area, request.storeys, rng)
    levels, rooms, stairs = [], [], []
    for level, kinds in enumerate(_split(request, rng)):
        boxes = _divide(ground, kinds, level, int(rng.integers(2**31)))
        storey = None if boxes is None else _rooms(ground, kinds, boxes, level)
        if storey is None:
            return None
        levels.append(
            {"id": str(level), "elevation": level * STOREY_RISE, "height": CEILING_HEIGHT}
        )
        rooms += storey
        if level:
            stairs.append(_stairs(ground, level))
    document = {"levels": levels, "rooms": rooms, "stairs": stairs, "outlines": "centre"}
    return document | {"wall_thickness": WALL}


def _split(request: PlanRequest, rng: np.random.Generator) -> list[list[str]]:
    """The kinds of rooms by storey: one lives below and sleeps above, where each storey has a
    bathroom and at most :data:`MOST_ABOVE` bedrooms; further ones lie below."""
    kinds = list_rooms(request.rooms, request.area, rng)
    if request.storeys == 1:
        return [kinds]
    above = request.storeys - 1
    beds = [kind for kind in kinds if kind in BEDROOMS]
    common = [kind for kind in kinds if kind not in (*BEDROOMS, "bath", "toilet", "hall")]
    high, low = beds[: MOST_ABOVE * above], beds[MOST_ABOVE * above :]
    sleeping = [[*high[k::above], "bath", "hall"] for k in range(above)]
    return [[*common, *low, "toilet", "hall"], *sleeping]


def _divide(ground: Ground, kinds: list[str], level: int, seed: int) -> Floats | None:
    """The rooms (n, 4) of a storey; None where a rule is broken."""
    rng = np.random.default_rng(seed)
    rows = [ROWS[kind] for kind in kinds]
    hall = kinds.index("hall")
    entrance = rows[hall].door + 0.3 if level == 0 and ground.hall is None else 0.0
    rooms = np.array(
        [
            (r.least + WALL, r.slender, r.light, entrance * (k == hall), r.door + 0.35)
            for k, r in enumerate(rows)
        ]
    )
    joins = np.array([_joined(kinds, row.joins) for row in rows])
    parts, free = ground.parts, [k for k in range(len(kinds)) if k != hall or ground.hall is None]
    sizes = np.prod(parts[:, 2:] - parts[:, :2], axis=1)
    wanted = wanted_areas([kinds[k] for k in free], float(sizes.sum()))
    within = _assign(free, wanted, sizes, rng)
    if within is None:
        return None
    areas = np.ones(len(kinds))
    areas[free] = wanted
    if ground.hall is not None:
        parts, within = np.vstack([parts, ground.hall]), [*within, [hall]]
        areas[hall] = np.prod(ground.hall[2:] - ground.hall[:2])
        rooms[hall, :2] = 1.0, 9.0
    order = np.argsort([len(members) == 1 for members in within], kind="stable")
    storey = Storey(
        parts[order], tuple(tuple(within[k]) for k in order), areas, rooms, joins, ground.lit_sides
    )
    boxes, broken = divide(storey, seed)
    return boxes if broken < 1e-9 else None


def _joined(kinds: list[str], joins: tuple[str, ...]) -> tuple[int, int]:
    """The rooms a room may be entered from, by number: at most two, -1 for none."""
    found = [k for want in joins for k, kind in enumerate(kinds) if openings.is_kind(kind, want)]
    return (found[0] if found else -1, found[1] if len(found) > 1 else -1)


def _assign(
    rooms: list[int], wanted: Floats, sizes: Floats, rng: np.random.Generator
) -> list[list[int]] | None:
    """Rooms by part: in random order each to the part with most floor left; None where a part
    would have none."""
    left = sizes.astype(float).copy()
    found: list[list[int]] = [[] for _ in sizes]
    for k in rng.permutation(len(rooms)):
        part = int(np.argmax(left))
        found[part].append(rooms[k])
        left[part] -= wanted[k]
    return found if all(found) else None


def _rooms(
    ground: Ground, kinds: list[str], boxes: Floats, level: int
) -> list[dict[str, Any]] | None:
    """The rooms of a storey as a brief has them; None where one cannot be entered."""
    ids = _ids(kinds, level)
    found = []
    for k, kind in enumerate(kinds):
        others = np.delete(boxes, k, axis=0)
        doors = []
        if kind == "hall":
            entrance = openings.entrance_of(ground, boxes[k], others) if level == 0 else {}
            if entrance is None:
                return None
            doors = [entrance] if entrance else []
        else:
            joined = openings.door_of(ground, kinds, boxes, k)
            if joined is None:
                return None
            doors = [joined[1] | {"to": ids[joined[0]]}]
        windows = openings.windows_of(ground, kind, boxes[k], others)
        x0, y0, x1, y1 = boxes[k]
        corners = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
        room: dict[str, Any] = {
            "id": ids[k],
            "name": ROWS[kind].name,
            "function": list(ROWS[kind].functions),
        }
        room |= {"level": str(level), "outline": _points(ground, corners)}
        room["doors"] = [each | {"at": _points(ground, each["at"])} for each in doors]
        room["windows"] = [each | {"at": _points(ground, each["at"])} for each in windows]
        found.append(room)
    return found


def _points(ground: Ground, points: Floats) -> Any:
    """Points of the plan on the ground, to the millimetre."""
    return np.round(ground.lay(points), 3).tolist()


def _ids(kinds: list[str], level: int) -> list[str]:
    """Unique ids: the kind, a number from the second on, the storey from the first floor on."""
    seen: dict[str, int] = {}
    found = []
    for kind in kinds:
        seen[kind] = seen.get(kind, 0) + 1
        found.append(
            kind + (f"-{seen[kind]}" if seen[kind] > 1 else "") + f"@{level}" * (level > 0)
        )
    return found


def _stairs(ground: Ground, level: int) -> dict[str, Any]:
    """The flight to a storey along the front wall of the hall, its foot beside the front door."""
    assert ground.hall is not None
    _, _, x1, y1 = ground.hall
    at = np.array([x1 - WALL / 2 - 1.5, y1 - WALL / 2 - 0.5])
    heading = openings.turned(ground, at, np.array([-1.0, 0.0]))
    place = {"at": _points(ground, at), "heading": round(heading, 6), "width": 0.95, "going": 0.22}
    return {"id": f"stairs-{level}", "level": str(level - 1), "to": str(level), **place}
