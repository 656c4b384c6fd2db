"""What hangs at windows: curtains, and blinds where these do not fit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from scenewright.building.ceiling import lowest
from scenewright.building.door_approach import DoorApproach, gates
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.furnishing.obstacles import (
    StandingObstacles,
    find_faults_of,
    flat_kinds,
    join_standing,
    standing_of,
)
from scenewright.domains.home.groups.classes import LIVED_IN
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import common_area, make_frame

DEPTH = {"curtain": 0.09, "blind": 0.06}
"""How far each stands out from its wall, metres."""
CURTAIN_REACH, SEEN = (
    0.15,
    0.005,
)  # floor below a curtain, metres, and what of it is not noticed, m²
LET_DOWN = 0.35  # of a window's height that a blind covers
RESTING = 0.2  # least gap between a curtain and a desk or chest below it, metres
OFF_UNITS = 0.8  # no curtain nearer than this to kitchen units, metres
NARROWEST = 0.3  # a window narrower than this is left bare, metres


def dress_windows(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> list[Piece]:
    """Curtains and blinds for the windows of a room in which ``pieces`` stand."""
    if not LIVED_IN & set(space.functions):
        return []
    standing = standing_of(pieces, flat_kinds(catalog))
    found: list[Piece] = []
    for gate in gates(space):
        opening = gate.opening
        outer = opening.kind == "window" and len(opening.spaces) == 1 and opening.roof is None
        if not outer or opening.width < NARROWEST:
            continue
        hung = _hang_first(_forms(space, ground, gate, pieces, found), ground, standing, catalog)
        if hung is not None:
            found.append(hung)
            standing = join_standing(standing, standing_of((hung,), frozenset()))
    return found


def _hang_first(
    forms: Iterator[Piece], ground: Ground, standing: StandingObstacles, catalog: Catalog
) -> Piece | None:
    """The first of the forms that meets nothing, drawn by the asset that suits it."""
    bare = ground._replace(windows=ground.windows[:0])
    for piece in forms:
        codes = find_faults_of(piece, bare, standing)[2]
        if codes[0] == 0:
            asset = catalog.choose(piece.category, piece.size)
            return replace(piece, asset=asset.id if asset else "")
    return None


def _forms(
    space: Space, ground: Ground, gate: DoorApproach, pieces: tuple[Piece, ...], hung: list[Piece]
) -> Iterator[Piece]:
    """A curtain to the floor, else one that ends below the sill; wide, else as the window; a blind
    where none of these fits, would lie on a desk, or where one cooks."""
    opening = gate.opening
    if not _cooked_at(gate, pieces):
        short = max(opening.sill - 0.12, 0.02)
        for low in (0.02,) if _would_lie(gate, short, pieces) else (0.02, short):
            for wider in (0.5, 0.24, 0.0):
                yield from _at_window("curtain", space, ground, gate, wider, low, hung)
    low = opening.head - LET_DOWN * (opening.head - opening.sill)
    for wider in (0.16, 0.0):
        yield from _at_window("blind", space, ground, gate, wider, low, hung)


def _cooked_at(gate: DoorApproach, pieces: tuple[Piece, ...]) -> bool:
    """True if kitchen units stand near a window: no place for a curtain."""
    near = gate.opening.width / 2 + OFF_UNITS
    units = (p for p in pieces if p.function in ("kitchen", "kitchenette", "counter"))
    return any(np.hypot(*(gate.face - np.array(p.pose[:2]))) < near for p in units)


def _would_lie(gate: DoorApproach, low: float, pieces: tuple[Piece, ...]) -> bool:
    """Whether a curtain whose foot is at ``low`` would lie on a piece below the window."""
    x, y = gate.face + gate.inward * CURTAIN_REACH / 2
    heading = float(np.arctan2(gate.inward[1], gate.inward[0]))
    below = make_frame(x, y, heading, gate.opening.width, CURTAIN_REACH)
    tops = (p for p in pieces if p.on is None and abs(p.pose.z + p.size.height - low) < RESTING)
    boxes = ((p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]) for p in tops)
    return any(float(common_area(make_frame(*box), below)) > SEEN for box in boxes)


def _at_window(
    category: str,
    space: Space,
    ground: Ground,
    gate: DoorApproach,
    wider: float,
    low: float,
    hung: list[Piece],
) -> Iterator[Piece]:
    """One form, if there is room for it over the window; ``low`` is the height of its foot."""
    opening, depth = gate.opening, DEPTH[category]
    heading = float(np.arctan2(gate.inward[1], gate.inward[0]))
    x, y = gate.face + gate.inward * (depth / 2 + 0.004)
    box = np.array([[x, y, heading, opening.width + wider, depth]])
    top = min(opening.head + 0.15, lowest(box, ground.slopes, space.height)[0] - 0.02)
    if top < min(opening.head, space.height - 0.02) - 1e-9:
        return
    number = sum(piece.category == category for piece in hung)
    name = f"{space.id}/{category}" + (f"_{number + 1}" if number else "")
    size = Size(opening.width + wider, depth, float(top - low))
    pose = Pose(float(x), float(y), low, heading)
    yield Piece(name, category, "", space.id, pose, size, space.id, "light")
