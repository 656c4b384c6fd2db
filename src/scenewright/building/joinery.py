"""Doors, windows and passages as meshes: linings, leaves, frames, panes, sills.

Local frame of an opening: x along its direction, y to the left of it, z up from the level's
floor; the origin is in the middle of the opening on the middle line of the wall.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from scenewright.building.door_leaves import leaves_of
from scenewright.core.catalog import Material, Part
from scenewright.core.space import Opening
from scenewright.geometry.mesh import Floats, Mesh, merge, translate_mesh
from scenewright.geometry.prisms import box

AJAR = np.deg2rad(78.0)
"""How far a door is drawn open, in radians."""
LEAF = 0.04
LINING = 0.03
PROUD = 0.012
"""How far a lining stands out of the wall, in metres."""
FRAME = 0.06

Span = tuple[float, float]

PAINT = Material("joinery white", (0.93, 0.92, 0.90), roughness=0.5)
LEAF_WOOD = Material("door oak", (0.80, 0.70, 0.57), roughness=0.55)
METAL = Material("brushed steel", (0.72, 0.72, 0.72), roughness=0.35, metallic=0.9)
DARK_FRAME = Material("frame graphite", (0.24, 0.25, 0.27), roughness=0.5)
GLASS = Material("window glass", (0.74, 0.86, 0.92), roughness=0.05, opacity=0.28)
THRESHOLD = Material("threshold", (0.62, 0.55, 0.47), roughness=0.6)


def parts(opening: Opening) -> tuple[Part, ...]:
    """What fills one opening, by its kind and how its leaf moves; nothing in a slope, as ceilings
    are not drawn.

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
        leaves = (part for leaf in leaves_of(opening) for part in _leaf(*leaf))
        return (_threshold(opening), _lining(opening), *leaves)
    return _sliding(opening)


def to_plan_coordinates(opening: Opening, vertices: Floats) -> Floats:
    """Points ``(n, 3)`` of an opening's frame in plan metres above the level's floor."""
    turn = np.array([[opening.ux, opening.uy], [-opening.uy, opening.ux]])
    return np.column_stack(
        [vertices[:, :2] @ turn + np.array([opening.x, opening.y]), vertices[:, 2]]
    )


def _part(material: Material, *meshes: Mesh) -> Part:
    return Part(material, *merge(meshes))


def _threshold(opening: Opening) -> Part:
    half, face = opening.width / 2, opening.thickness / 2
    return _part(THRESHOLD, box((-half, -face, -0.02), (half, face, 0.002)))


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
    return _part(PAINT, *_surround(opening, width, -face, face, 0.002))


def _leaf(opening: Opening, along: float) -> tuple[Part, Part]:
    """A leaf, open on its swing side, and its handles, set so far along the whole opening."""
    clear = opening.width - 2 * min(LINING, opening.width / 8) - 0.006
    top = max(opening.head - LINING - 0.006, 0.5)
    leaf = box((0, 0, 0.008), (clear, LEAF, top))
    reach = clear - 0.09
    handles = [
        box((reach, side, 1.0), (reach + 0.025, side + 0.05, 1.025)) for side in (-0.05, LEAF)
    ] + [
        box((reach - 0.1, side, 1.0), (reach + 0.025, side + 0.018, 1.025))
        for side in (-0.05, LEAF + 0.032)
    ]
    swung = [translate_mesh(_swung(opening, clear, mesh), along) for mesh in (leaf, merge(handles))]
    return _part(LEAF_WOOD, swung[0]), _part(METAL, swung[1])


def _swung(opening: Opening, clear: float, mesh: Mesh) -> Mesh:
    """From the frame of a leaf (x from the hinge, y towards the wall's far face) to its place.

    Made for a hinge at the start that opens to the left; other doors are mirror images.
    """
    vertices, faces = mesh
    cos, sin = np.cos(AJAR), np.sin(AJAR)
    turned = vertices[:, :2] @ np.array([[cos, sin], [sin, -cos]])
    face = opening.thickness / 2
    x = (turned[:, 0] - clear / 2) * -opening.hinge
    y = (turned[:, 1] + face) * opening.swing
    mirrored = opening.hinge * opening.swing > 0
    return Mesh(np.column_stack([x, y, vertices[:, 2]]), faces if mirrored else faces[:, ::-1])


def _sliding(opening: Opening) -> tuple[Part, ...]:
    """Two glazed panels, one slid over the other, if wide; else a leaf half into the wall."""
    half, top = opening.width / 2, opening.head - LINING
    if opening.width < 1.5:
        leaf = box((-half, -LEAF / 2, 0.01), (-0.3 * half, LEAF / 2, top))
        return _threshold(opening), _lining(opening), _part(LEAF_WOOD, leaf)
    depth = min(0.05, opening.thickness / 3)
    fixed, pane = _glazing((-half + LINING, LINING), (0.0, depth), (0.02, top), FRAME)
    moved, glass = _glazing((-half + 0.3, 0.3), (-depth, 0.0), (0.02, top), FRAME)
    surround = _surround(opening, LINING, -depth - 0.01, depth + 0.01, 0.0)
    return (
        _threshold(opening),
        _part(DARK_FRAME, *surround, *fixed, *moved),
        _part(GLASS, pane, glass),
    )


def _glazing(xs: Span, ys: Span, zs: Span, width: float) -> tuple[list[Mesh], Mesh]:
    """A framed pane in the box of three spans: four bars, and the glass between them."""
    (x0, x1), (y0, y1), (z0, z1) = xs, ys, zs
    bars = [
        box((x0, y0, z0), (x0 + width, y1, z1)),
        box((x1 - width, y0, z0), (x1, y1, z1)),
        box((x0 + width, y0, z0), (x1 - width, y1, z0 + width)),
        box((x0 + width, y0, z1 - width), (x1 - width, y1, z1)),
    ]
    middle = (y0 + y1) / 2
    pane = box((x0 + width, middle - 0.006, z0 + width), (x1 - width, middle + 0.006, z1 - width))
    return bars, pane


def _window(opening: Opening) -> tuple[Part, ...]:
    """Casements of about 0.9 m with one pane each, and a board on the sill inside."""
    half, face = opening.width / 2, opening.thickness / 2
    depth, low, high = min(0.035, face), opening.sill, opening.head
    count = max(1, round(opening.width / 0.9))
    width = min(FRAME, opening.width / count / 5, (high - low) / 5)
    ends = np.linspace(-half, half, count + 1).tolist()
    cases = [_glazing(xs, (-depth, depth), (low, high), width) for xs in pairwise(ends)]
    bars = [bar for found, _ in cases for bar in found]
    board = box((-half, depth, low), (half, face + 0.03, low + 0.025))
    return _part(PAINT, *bars, board), _part(GLASS, *(pane for _, pane in cases))
