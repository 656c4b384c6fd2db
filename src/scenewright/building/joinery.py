"""Doors, windows and passages as meshes: linings, leaves, frames, panes, sills.

Local frame of an opening: x along its direction, y to the left of it, z up from the level's
floor; the origin is in the middle of the opening on the middle line of the wall.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from scenewright.building.door_leaves import leaves_of
from scenewright.building.door_uses import DoorUse
from scenewright.building.glazing import DARK_FRAME, FRAME, GLASS, LINING, make_glazing, make_part
from scenewright.building.sliding_doors import PANEL, make_panels
from scenewright.core.catalog import Material, Part
from scenewright.core.space import Opening
from scenewright.geometry.mesh import Floats, Mesh, translate_mesh
from scenewright.geometry.prisms import box

AJAR = np.deg2rad(78.0)
"""How far a door is drawn open, in radians, where its brief does not say."""
LEAF = 0.04
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
    return tuple(
        Part(p.material, *translate_mesh(_swung(opening, clear, Mesh(p.vertices, p.faces)), along))
        for p in made
    )


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


def _swung(opening: Opening, clear: float, mesh: Mesh) -> Mesh:
    """From the frame of a leaf (x from the hinge, y towards the wall's far face) to its place.

    Made for a hinge at the start that opens to the left; other doors are mirror images.
    """
    vertices, faces = mesh
    ajar = AJAR if opening.ajar is None else opening.ajar
    cos, sin = np.cos(ajar), np.sin(ajar)
    turned = vertices[:, :2] @ np.array([[cos, sin], [sin, -cos]])
    face = opening.thickness / 2
    x = (turned[:, 0] - clear / 2) * -opening.hinge
    y = (turned[:, 1] + face) * opening.swing
    mirrored = opening.hinge * opening.swing > 0
    return Mesh(np.column_stack([x, y, vertices[:, 2]]), faces if mirrored else faces[:, ::-1])


def _window(opening: Opening) -> tuple[Part, ...]:
    """Casements of about 0.9 m with one pane each, and a board on the sill inside."""
    half, face = opening.width / 2, opening.thickness / 2
    depth, low, high = min(0.035, face), opening.sill, opening.head
    count = max(1, round(opening.width / 0.9))
    width = min(FRAME, opening.width / count / 5, (high - low) / 5)
    ends = np.linspace(-half, half, count + 1).tolist()
    cases = [make_glazing(xs, (-depth, depth), (low, high), width) for xs in pairwise(ends)]
    bars = [bar for found, _ in cases for bar in found]
    board = box((-half, depth, low), (half, face + 0.03, low + 0.025))
    return make_part(PAINT, *bars, board), make_part(GLASS, *(pane for _, pane in cases))
