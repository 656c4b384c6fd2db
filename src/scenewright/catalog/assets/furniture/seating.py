"""Sofas, chairs, stools and benches."""

from __future__ import annotations

from scenewright.catalog.assets.furniture.corners import Outline, corner_outline
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.symbols import Lines, box, close_line, crescent, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import pad

ARM, BACK = 0.15, 0.2
SOFT, LOOSE = (0.0, 0.012, 0.025), (0.0, 0.04, 0.015)
"""How far seats and what one leans on stand out in the middle, in x, y and z, metres."""


def throw_pillow(x: float, y: float, z: float, side: float, lean: float, turn: float) -> Mesh:
    """A square throw pillow standing on its edge at ``z``, leaning back."""
    half = side / 2
    flat = pad((-half, half), (-0.065, 0.065), (0, side), 0.02, (0, 0.05, 0))
    return translate_mesh(rotate_mesh(rotate_mesh(flat, "x", lean), "z", turn), x, y, z)


def sofa_symbol(size: Size) -> Lines:
    """Rounded outline, back, arms and one line between the cushions."""
    w, d = size.width / 2, size.depth / 2
    arm = min(ARM, 0.3 * w)
    count = max(1, round((2 * w - 2 * arm) / 0.72))
    back = -d + BACK
    lines = [rectangle(size, 0, 0.06), box(-w + arm, w - arm, back, d - 0.02, 0.04)]
    lines += [path((a, back), (a, d - 0.02)) for a, _ in spread(-w + arm, w - arm, count)[1:]]
    lines.append(path((-w + arm, back), (-w + arm, -d + 0.03)))
    lines.append(path((w - arm, back), (w - arm, -d + 0.03)))
    return tuple(lines)


def corner_sofa_outline(size: Size) -> Outline:
    """The L of a corner sofa, its lounge on the left."""
    return corner_outline(size, min(0.95, 0.7 * size.depth), min(1.0, 0.42 * size.width))


def corner_sofa_symbol(size: Size) -> Lines:
    """Outline, back, arms and the lines between the cushions."""
    w, d = size.width / 2, size.depth / 2
    front, edge = -d + min(0.95, 1.4 * d), -w + min(1.0, 0.84 * w)
    back = -d + BACK
    count = max(1, round((w - ARM - edge) / 0.75))
    outline = close_line(corner_sofa_outline(size))
    seams = [path((a, back), (a, front)) for a, _ in spread(edge, w - ARM, count)]
    return (
        outline,
        path((-w + ARM, -d), (-w + ARM, front)),
        path((w - ARM, -d), (w - ARM, front)),
        path((-w + ARM, back), (w - ARM, back)),
        path((-w, front), (edge, front)),
        *seams,
    )


def chair_symbol(size: Size) -> Lines:
    """The seat and the bent backrest behind it."""
    w, d = size.width / 2, size.depth / 2
    deep = 0.16 * size.depth
    seat = box(-0.9 * w, 0.9 * w, -d + 0.6 * deep, d, 0.06)
    return seat, crescent(w, -d, deep, 0.1 * size.depth)
