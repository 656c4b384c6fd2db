"""What gables show above the eaves: a window, and the beams of a timber frame."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.catalog.assets.buildings.house_looks import HouseForm, HouseLook
from scenewright.catalog.assets.buildings.house_shapes import Wing
from scenewright.catalog.assets.buildings.house_walls import (
    BEAM,
    OUT,
    RIM,
    Side,
    WallOpenings,
    on_side,
)
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import block

SILL, WIDE, TALL = 0.55, 0.7, 1.0
"""Of the window of a gable: its sill above the eaves, width and height, in metres."""
CLEAR = 0.25
"""Metres between the window of a gable and the slope."""


def list_ends(wing: Wing, by: float) -> Iterator[Side]:
    """The gable walls of a wing, set in by ``by`` metres."""
    across, length = (wing.y, wing.x) if wing.along == "x" else (wing.x, wing.y)
    low, high = across[0] + by, across[1] - by
    for at, ends in ((length[0] + by, (high, low)), (length[1] - by, (low, high))):
        spots = [(at, c) if wing.along == "x" else (-c + low + high, at) for c in ends]
        start, end = (np.array(spot) for spot in spots)
        yield Side(start, end, high - low, ())


def show_gable(
    found: WallOpenings, end: Side, eave: float, pitch: float, look: HouseLook, form: HouseForm
) -> None:
    """A window where there is room for it under the slopes, and the beams of the style."""
    half = end.length / 2
    lived = form.entrance not in ("gate", "portal")
    room = half - (SILL + TALL + CLEAR) / pitch if pitch > 0 else 0.0
    window = form.entrance != "gate" and room >= WIDE / 2 + RIM
    if window:
        z = (eave + SILL, eave + SILL + TALL)
        pane = block((-WIDE / 2, WIDE / 2), (-OUT, OUT), z)
        wide = WIDE / 2 + RIM
        rim = block((-wide, wide), (-OUT, 0.6 * OUT), (z[0] - RIM, z[1] + RIM))
        found.panes.append(on_side(pane, end))
        found.frames.append(on_side(rim, end))
    if lived and look.frame is not None:
        posts = (-1, 1) if window else (0,)
        beams = _gable_beams(half, eave, pitch, [s * (WIDE / 2 + RIM + BEAM / 2) for s in posts])
        found.beams.extend(on_side(mesh, end) for mesh in beams)


def _gable_beams(half: float, eave: float, pitch: float, posts: list[float]) -> Iterator[Mesh]:
    """Rails one above the other, as wide as the slopes leave, and posts up to the roof."""
    y, rise = (-OUT, 0.5 * OUT), pitch * half
    for high in (BEAM / 2, SILL - RIM - BEAM / 2, SILL + TALL + RIM + BEAM / 2):
        wide = half - (high + BEAM) / pitch
        if wide > 0.3:
            yield block((-wide, wide), y, (eave + high - BEAM / 2, eave + high + BEAM / 2))
    for x in (*posts, *(s * 0.55 * half for s in (-1, 1) if 0.55 * half > abs(posts[0]) + 0.4)):
        top = rise - pitch * (abs(x) + BEAM / 2) - 0.05
        if top > 0.4:
            yield block((x - BEAM / 2, x + BEAM / 2), y, (eave, eave + top))
