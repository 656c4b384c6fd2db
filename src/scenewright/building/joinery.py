"""Doors, windows and passages as meshes: linings, leaves, frames, panes, sills.

Local frame of an opening: x along its direction, y to the left of it, z up from the level's
floor; the origin is in the middle of the opening on the middle line of the wall.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from scenewright.building.door_leaves import leaves_of
from scenewright.building.door_uses import DoorUse
from scenewright.building.glazing import (
    DARK_FRAME,
    FRAME,
    GLASS,
    LINING,
    Span,
    make_glazing,
    make_part,
)
from scenewright.building.sliding_doors import PANEL, make_panels
from scenewright.core.catalog import Material, Part, transform_part
from scenewright.core.space import Opening
from scenewright.geometry.joints import Joint
from scenewright.geometry.mesh import Floats, Mesh
from scenewright.geometry.prisms import box

AJAR = float(np.deg2rad(78.0))
"""How far a door is drawn open, in radians, where its brief does not say."""
WIDEST = float(np.deg2rad(92.0))
"""How far it opens."""
LEAF = 0.04
RIM, PLAY = 0.03, 0.002
"""Width of the frame that holds the casements of a window, and their gap to it, in metres."""
PROUD = 0.012
"""How far a lining stands out of the wall, in metres."""

PAINT = Material("joinery white", (0.93, 0.92, 0.90), roughness=0.5)
LEAF_WOOD = Material("door oak", (0.80, 0.70, 0.57), roughness=0.55)
METAL = Material("brushed steel", (0.72, 0.72, 0.72), roughness=0.35, metallic=0.9)
THRESHOLD = Material("threshold", (0.62, 0.55, 0.47), roughness=0.6)


def parts(opening: Opening, use: DoorUse = "inner") -> tuple[Part, ...]:
    """What fills one opening, by its kind, its ``use`` and how its leaf moves; nothing in a slope,
    as ceilings are not drawn.

    >>> from scenewright.core.space import Opening
    >>> door = Opening("d", "door", "0", 0, 0, 1, 0, 0.9, 0.12, 0.0, 2.05, hinge=1, swing=1)
    >>> [part.material.name for part in parts(door)]
    ['threshold', 'joinery white', 'door oak', 'brushed steel']
    """
    if opening.roof is not None:
        return ()
    if opening.kind == "window":
        return _window(opening)
    if opening.kind == "passage":
        return _threshold(opening), _lining(opening)
    if opening.hinge and opening.swing:
        leaves = (part for leaf in leaves_of(opening) for part in _leaf(*leaf, use))
        return (_threshold(opening), _lining(opening), *leaves)
    return (_threshold(opening), _lining(opening), *make_panels(opening, use, LEAF_WOOD))


def to_plan_coordinates(opening: Opening, vertices: Floats) -> Floats:
    """Points ``(n, 3)`` of an opening's frame in plan metres above the level's floor."""
    turn = np.array([[opening.ux, opening.uy], [-opening.uy, opening.ux]])
    return np.column_stack(
        [vertices[:, :2] @ turn + np.array([opening.x, opening.y]), vertices[:, 2]]
    )


def _threshold(opening: Opening) -> Part:
    half, face = opening.width / 2, opening.thickness / 2
    return make_part(THRESHOLD, box((-half, -face, -0.02), (half, face, 0.002)))


def _surround(opening: Opening, width: float, y0: float, y1: float, low: float) -> list[Mesh]:
    """Two jambs and a head of the given width, from ``low`` to the head of the opening."""
    half, head = opening.width / 2, opening.head
    return [
        box((-half, y0, low), (-half + width, y1, head - width)),
        box((half - width, y0, low), (half, y1, head - width)),
        box((-half, y0, head - width), (half, y1, head)),
    ]


def _lining(opening: Opening) -> Part:
    face = opening.thickness / 2 + PROUD
    width = min(LINING, opening.width / 8)
    return make_part(PAINT, *_surround(opening, width, -face, face, 0.002))


def _leaf(opening: Opening, along: float, use: DoorUse) -> tuple[Part, ...]:
    """A leaf, open on its swing side, and its handles, set ``along`` metres into the whole
    opening."""
    clear = opening.width - 2 * min(LINING, opening.width / 8) - 0.006
    top = max(opening.head - LINING - 0.006, 0.5)
    made = (*_panel(clear, top, use), make_part(METAL, *_handles(clear)))
    ajar = AJAR if opening.ajar is None else opening.ajar
    matrix, shift = _swing(opening, clear, along, ajar)
    name = "leaf" if not along else f"leaf {1 if along < 0 else 2}"
    hinge = Joint(name, "hinge", (0.0, 0.0, 0.0), (0.0, 0.0, -1.0), 0.0, WIDEST, ajar)
    return tuple(transform_part(replace(part, joint=hinge), matrix, shift) for part in made)


def _panel(clear: float, top: float, use: DoorUse) -> tuple[Part, ...]:
    """A closed leaf: glazed to the open air, else a board."""
    if use == "garden":
        bars, pane = make_glazing((0, clear), (0, LEAF), (0.008, top), min(0.09, clear / 6))
        return make_part(DARK_FRAME, *bars), make_part(GLASS, pane)
    board = box((0, 0, 0.008), (clear, LEAF, top))
    return (make_part(PANEL if use == "closet" else LEAF_WOOD, board),)


def _handles(clear: float) -> list[Mesh]:
    reach = clear - 0.09
    knobs = [(side, side + 0.05, reach) for side in (-0.05, LEAF)]
    grips = [(side, side + 0.018, reach - 0.1) for side in (-0.05, LEAF + 0.032)]
    return [box((x, y0, 1.0), (reach + 0.025, y1, 1.025)) for y0, y1, x in (*knobs, *grips)]


def _swing(opening: Opening, clear: float, along: float, ajar: float) -> tuple[Floats, Floats]:
    """From the frame of a leaf (x from the hinge, y towards the wall's far face) to its place, as
    a matrix (3, 3) and a shift (3,): turned open about the hinge, on the side it swings to."""
    cos, sin = np.cos(ajar), np.sin(ajar)
    sides = np.diag([-opening.hinge, opening.swing, 1.0])
    turn = np.array([[cos, sin, 0.0], [sin, -cos, 0.0], [0.0, 0.0, 1.0]])
    place = sides @ np.array([-clear / 2, opening.thickness / 2, 0.0])
    return sides @ turn, place + np.array([along, 0.0, 0.0])


def _window(opening: Opening) -> tuple[Part, ...]:
    """A frame with casements of about 0.9 m, one pane each, that open inwards, and a board on the
    sill inside."""
    half, face = opening.width / 2, opening.thickness / 2
    depth, low, high = min(0.035, face), opening.sill, opening.head
    count = max(1, round(opening.width / 0.9))
    rim = min(RIM, opening.width / 20, (high - low) / 20)
    board = box((-half, depth, low), (half, face + 0.03, low + 0.83 * rim))
    sill = box((-half + rim, -depth, low), (half - rim, depth, low + rim))
    frame = (*_surround(opening, rim, -depth, depth, low), sill)
    ends = np.linspace(-half + rim, half - rim, count + 1).tolist()
    each = enumerate(pairwise(ends), 1)
    sashes = (part for i, xs in each for part in _sash(f"sash {i}", xs, depth, (low, high), rim))
    return (make_part(PAINT, *frame, board), *sashes)


def _sash(name: str, xs: Span, depth: float, z: Span, rim: float) -> tuple[Part, ...]:
    """One casement between two upright edges, hung on the left or, every second, on the right."""
    (x0, x1), (low, high) = (xs[0] + PLAY, xs[1] - PLAY), (z[0] + rim + PLAY, z[1] - rim - PLAY)
    width = min(FRAME - RIM, (x1 - x0) / 5, (high - low) / 5)
    bars, pane = make_glazing((x0, x1), (-depth, depth), (low, high), width)
    right = name.endswith(tuple("02468"))
    pivot = (x1 if right else x0, depth, (low + high) / 2)
    axis = (0.0, 0.0, -1.0 if right else 1.0)
    joint = Joint(name, "hinge", pivot, axis, 0.0, WIDEST)
    made = (make_part(PAINT, *bars), make_part(GLASS, pane))
    return tuple(replace(part, joint=joint) for part in made)
