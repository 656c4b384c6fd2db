"""What the walls of a house show: windows with frames and shutters, beams, along any side.

The front is arranged as one: its bays are an odd number with the entrance in the middle one, or,
where it is narrow, two with the entrance in one of them; every storey has its windows in these
bays (:mod:`~scenewright.catalog.assets.buildings.house_fronts`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from scenewright.catalog.assets.buildings.facades import bays
from scenewright.catalog.assets.buildings.house_looks import WindowLook
from scenewright.catalog.assets.joinery import spread
from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, block, sheet

OUT = 0.05
"""How far panes stand out, in metres; frames a little less, shutters a little more."""
FLOOR = 2.7
EDGE, LEAF, RIM = 0.35, 0.42, 0.09
"""Metres from a corner to the first bay, of the width of a shutter and of a window frame."""
LEAST_WIDE, LEAST_TALL, PIER = 0.4, 0.4, 0.3
"""Least width and height of a window, and what of a bay is wall beside it, in metres."""
STOREYS, WINDOWS = 4, 70
"""Most storeys with windows, and about how many windows a house has at most."""
SPARE = 0.45
"""Metres that a storey with windows may lack below the eaves."""
THREE, TWO = 1.9, 1.45
"""Metres of a bay from which a front has three, and from which it has two."""
BEAM, BRACE = 0.14, 0.6
"""Width of beams on a wall and of the least field that is braced, in metres."""
SHORT = 0.8
"""Metres beside the window of a side that is long enough for one."""


class WallOpenings(NamedTuple):
    """Meshes of what is in walls and on them: ``woods`` are balconies and the fronts of shops."""

    panes: list[Mesh]
    frames: list[Mesh]
    shutters: list[Mesh]
    doors: list[Mesh]
    stones: list[Mesh]
    beams: list[Mesh]
    woods: list[Mesh]
    shops: list[Mesh]


class Side(NamedTuple):
    """A side of a footprint: where it starts and ends, its length, and its bays along it, about
    its middle."""

    start: Points
    end: Points
    length: float
    bays: tuple[Interval, ...]


def front_of(footprint: Footprint) -> int:
    """The side of a footprint that is farthest ahead.

    >>> front_of(((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)))
    2
    """
    ring = np.array(footprint)
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    return int(np.argmax(np.round(middle[:, 1], 6)))


def count_storeys(eave: float, most: int = STOREYS) -> int:
    """Storeys with windows below an eave, at ``most`` so many.

    >>> count_storeys(2.3), count_storeys(5.5)
    (1, 2)
    """
    return min(max(1, int((eave + SPARE) // FLOOR)), most)


def front_bays(length: float, bay: float) -> tuple[Interval, ...]:
    """The bays of a front: an odd number nearest to ``bay`` metres each, two where three would be
    too narrow, one where two would.

    >>> [len(front_bays(length, 2.7)) for length in (3.2, 4.5, 7.0, 12.0)]
    [1, 2, 3, 5]
    """
    reach = length - 2 * EDGE
    if reach < 2 * TWO:
        return ((-max(reach, 0.6) / 2, max(reach, 0.6) / 2),)
    odd = 2 * max(round((reach / bay - 1) / 2), 1) + 1
    return tuple(spread(-reach / 2, reach / 2, odd if reach >= 3 * THREE else 2))


def list_sides(footprint: Footprint, bay: float, party: bool = False) -> tuple[list[Side], Side]:
    """The sides of a footprint that may have windows, and its front; the side walls of a ``party``
    house are its neighbours' too."""
    ring = np.array(footprint)
    ends, entrance = np.roll(ring, -1, axis=0), front_of(footprint)
    outer = np.abs(ring[:, 0]).max() - 0.02
    sides = []
    for number, (start, end) in enumerate(zip(ring, ends, strict=True)):
        length = float(np.hypot(*(end - start)))
        if number == entrance:
            front = Side(start, end, length, front_bays(length, bay))
        elif not (party and min(abs(start[0]), abs(end[0])) > outer and start[0] * end[0] > 0):
            rows = bays((-length / 2 + EDGE, length / 2 - EDGE), bay)
            sides.append(Side(start, end, length, tuple(rows)))
    return sides, front


def heights(floor: int, eave: float, look: WindowLook) -> Interval:
    """From where to where a window of a storey reaches."""
    low = floor * FLOOR + look.sill
    return low, min(low + look.tall, eave - 0.2)


def fill_bays(
    found: WallOpenings,
    side: Side,
    spans: Sequence[Interval],
    floors: range,
    eave: float,
    look: WindowLook,
) -> None:
    """A window in the middle of every span of every floor, no wider than leaves a pier; shutters
    where all of them have room."""
    if not spans:
        return
    least = min(b - a for a, b in spans)
    wide = min(look.wide, least - PIER)
    shutters = look.shutters and least >= wide + 2 * (RIM + LEAF) + 0.1
    for floor in floors:
        z = heights(floor, eave, look)
        if z[1] - z[0] > LEAST_TALL and wide >= LEAST_WIDE:
            for a, b in spans:
                _window(found, side, (a + b) / 2, wide, z, shutters)


def _window(
    found: WallOpenings, side: Side, at: float, wide: float, z: Interval, shutters: bool
) -> None:
    """A window about a place along a side."""
    half = wide / 2
    pane = block((at - half, at + half), (-OUT, OUT), z)
    rim = block((at - half - RIM, at + half + RIM), (-OUT, 0.6 * OUT), (z[0] - RIM, z[1] + RIM))
    found.panes.append(on_side(pane, side))
    found.frames.append(on_side(rim, side))
    for sign in (-1, 1) if shutters else ():
        edge = at + sign * (half + RIM)
        span = (edge, edge + LEAF) if sign > 0 else (edge - LEAF, edge)
        leaf = block(span, (0.0, 1.3 * OUT), (z[0] - 0.03, z[1] + 0.03))
        found.shutters.append(on_side(leaf, side))


def frame_side(
    found: WallOpenings, side: Side, floors: range, eave: float, look: WindowLook
) -> None:
    """Beams along every floor, sill and eave, posts between bays, braces in the last fields."""
    half, y = side.length / 2 - 0.02, (-OUT, 0.5 * OUT)
    if half < BRACE:
        return
    edges = sorted({-half + BEAM / 2, half - BEAM / 2, *(e for bay in side.bays for e in bay)})
    posts = [e for e in edges if abs(e) <= half - BEAM / 2 + 1e-9]
    made = list[Mesh]()
    for floor in floors:
        low, top = floor * FLOOR, eave if floor == floors[-1] else (floor + 1) * FLOOR
        sill = heights(floor, eave, look)[0] - RIM
        levels = [low + BEAM / 2, sill - BEAM / 2, top - BEAM / 2]
        levels += [low + FLOOR] if top > low + 1.2 * FLOOR else []
        made += [block((-half, half), y, (z - BEAM / 2, z + BEAM / 2)) for z in levels]
        made += [block((p - BEAM / 2, p + BEAM / 2), y, (low, top)) for p in posts]
        for a, b in ((posts[0], posts[1]), (posts[-1], posts[-2])) if len(posts) > 3 else ():
            made.append(_brace(a, b, (low + BEAM, sill - BEAM), y))
    found.beams.extend(on_side(mesh, side) for mesh in made)


def _brace(a: float, b: float, z: Interval, y: Interval) -> Mesh:
    """A beam aslant from the foot of a post to the sill of the next."""
    step = BEAM if b > a else -BEAM
    ring = [(a, z[0]), (a + step, z[0]), (b, z[1]), (b - step, z[1])]
    return sheet(ring if b > a else ring[::-1], y)


def on_side(mesh: Mesh, side: Side) -> Mesh:
    """What is built on a wall at y = 0 looking to +y, set on one side of a footprint."""
    along, middle = side.end - side.start, (side.start + side.end) / 2
    turned = rotate_mesh(mesh, "z", float(np.arctan2(-along[0], along[1]) - np.pi / 2))
    return translate_mesh(turned, float(middle[0]), float(middle[1]))
