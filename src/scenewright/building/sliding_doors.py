"""Sliding doors as meshes: glazed to the open air, plain before closets, frosted between rooms.

The frame of an opening is that of :mod:`scenewright.building.joinery`.
"""

from __future__ import annotations

from dataclasses import replace

from scenewright.building.door_uses import DoorUse
from scenewright.building.glazing import DARK_FRAME, FRAME, GLASS, LINING, make_glazing, make_part
from scenewright.core.catalog import Material, Part
from scenewright.core.space import Opening
from scenewright.geometry.joints import Joint
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.prisms import box

WIDE = 1.5
"""Width in metres from which on a door between rooms has two panels; others of plain boards."""
WIDE_CLOSET = 0.9
PLAY = 0.004
"""Gap between a panel and what it runs under, metres."""
SHIFT = 0.3
"""How far the front panel is drawn slid over the other, in metres."""

PANEL = Material("cupboard panel", (0.90, 0.885, 0.855), roughness=0.55)
WHITE_FRAME = Material("frame white", (0.91, 0.90, 0.88), roughness=0.5)
FROSTED = Material("frosted glass", (0.86, 0.895, 0.90), roughness=0.35, opacity=0.85)

Panels = tuple[Part, ...]


def make_panels(opening: Opening, use: DoorUse, leaf: Material) -> Panels:
    """The panels of a sliding door, one slid over the other; a narrow one is a ``leaf`` half into
    the wall."""
    if use == "garden":
        return _glazed(opening, DARK_FRAME, GLASS)
    if use == "closet":
        return _plain(opening, PANEL, WIDE_CLOSET)
    if opening.width < WIDE:
        return _plain(opening, leaf, WIDE)
    return _glazed(opening, WHITE_FRAME, FROSTED)


def _spans(opening: Opening) -> tuple[tuple[float, float], tuple[float, float]]:
    """Along the opening, the fixed panel and the one slid over it."""
    half = opening.width / 2
    shift = min(SHIFT, 0.4 * half)
    return (-half + LINING, LINING), (-half + shift, shift)


def _glazed(opening: Opening, frame: Material, glass: Material) -> Panels:
    top = opening.head - LINING - PLAY
    depth, width = min(0.05, opening.thickness / 3), min(FRAME, opening.width / 12)
    fixed, moved = _spans(opening)
    bars, pane = make_glazing(fixed, (0.0, depth), (0.02, top), width)
    others, front = make_glazing(moved, (-depth, -0.002), (0.02, top), width)
    slid = (make_part(frame, *others), make_part(glass, front))
    joint = _slide(opening)
    return (
        make_part(frame, *bars),
        make_part(glass, pane),
        *(replace(part, joint=joint) for part in slid),
    )


def _plain(opening: Opening, material: Material, wide: float) -> Panels:
    top, depth = opening.head - LINING - PLAY, min(0.03, opening.thickness / 3)
    fixed, moved = _spans(opening)
    if opening.width < wide:
        half = opening.width / 2
        return (make_part(material, _board((-half, -0.3 * half), (-0.02, 0.02), top)),)
    front = make_part(material, _board(moved, (-depth, -0.002), top))
    return (
        make_part(material, _board(fixed, (0.002, depth), top)),
        replace(front, joint=_slide(opening)),
    )


def _slide(opening: Opening) -> Joint:
    """How the front panel runs: shut it closes the half that the other leaves open."""
    half = opening.width / 2
    (_, at), top = _spans(opening)[1], opening.head / 2
    shut, most = half - LINING, half - 2 * LINING
    axis, pivot = (-1.0, 0.0, 0.0), (at - half / 2, 0.0, top)
    return Joint("panel", "slide", pivot, axis, 0.0, most, shut - at)


def _board(xs: tuple[float, float], ys: tuple[float, float], top: float) -> Mesh:
    return box((xs[0], ys[0], 0.01), (xs[1], ys[1], top))
