"""Sofas, chairs, stools and benches."""

from __future__ import annotations

from math import cos, pi, sin

from scenewright.catalog.assets.bodies import attach_joint
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.corners import (
    Outline,
    corner_outline,
    cover,
    mirror_drawing,
)
from scenewright.catalog.assets.joinery import bent, four_legs, spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CHARCOAL,
    CHROME,
    FABRIC,
    FABRIC_LIGHT,
    LEATHER,
    MUSTARD,
    NAVY,
    OAK,
    OAK_DARK,
    RUBBER,
    SAGE_FABRIC,
    TERRACOTTA,
    WALNUT,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import (
    Lines,
    box,
    close_line,
    crescent,
    oval,
    path,
    rectangle,
    round_plain,
)
from scenewright.core.scene import Size
from scenewright.geometry.joints import Joint
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import (
    Interval,
    ball,
    block,
    cushion,
    disc,
    lathe,
    leg,
    make_bevelled_box,
    pad,
    pipe,
    rod,
    slab,
    tube,
)

ARM, BACK = 0.15, 0.2
SOFT, LOOSE = (0.0, 0.012, 0.025), (0.0, 0.04, 0.015)
"""How far seats and what one leans on stand out in the middle, in x, y and z, metres."""


def throw_pillow(x: float, y: float, z: float, side: float, lean: float, turn: float) -> Mesh:
    """A square throw pillow standing on its edge at ``z``, leaning back."""
    half = side / 2
    flat = pad((-half, half), (-0.065, 0.065), (0, side), 0.02, (0, 0.05, 0))
    return translate_mesh(rotate_mesh(rotate_mesh(flat, "x", lean), "z", turn), x, y, z)


def _seats(x: Interval, y: Interval, z: Interval, count: int) -> list[Mesh]:
    return [pad((a + 0.003, b - 0.003), y, z, 0.05, SOFT) for a, b in spread(*x, count)]


def _backs(x: Interval, y: float, z: Interval, count: int, thick: float = 0.16) -> list[Mesh]:
    tall = z[1] - z[0]
    return [
        translate_mesh(
            rotate_mesh(pad((a + 0.004, b - 0.004), (0, thick), (0, tall), 0.05, LOOSE), "x", 0.12),
            0,
            y + 0.05,
            z[0],
        )
        for a, b in spread(*x, count)
    ]


def _sofa(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    arm, seat = min(ARM, 0.3 * w), min(0.44, 0.56 * h)
    low, high = 0.1, h - 0.05
    count = max(1, round((2 * w - 2 * arm) / 0.72))
    inner = (-w + arm, w - arm)
    body = [
        make_bevelled_box((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.03), (low, seat - 0.15), 0.015),
        cushion((-w + 0.01, w - 0.01), (-d, -d + 0.15), (low, high), 0.05),
        cushion((-w, -w + arm), (-d + 0.02, d - 0.01), (low, seat + 0.17), 0.05),
        cushion((w - arm, w), (-d + 0.02, d - 0.01), (low, seat + 0.17), 0.05),
    ]
    soft = [
        *_seats(inner, (-d + 0.14, d), (seat - 0.16, seat), count),
        *_backs(inner, -d + 0.1, (seat - 0.02, h), count),
    ]
    pillow = min(0.42, h - seat - 0.02)
    return parts(
        size,
        {
            FABRIC: body,
            FABRIC_LIGHT: soft,
            TERRACOTTA: [throw_pillow(-w + arm + 0.24, -d + 0.37, seat - 0.02, pillow, 0.3, -0.35)],
            MUSTARD: [throw_pillow(w - arm - 0.24, -d + 0.37, seat - 0.02, pillow, 0.3, 0.35)],
            OAK: four_legs(w, d, (0, low + 0.01), 0.026, 0.018, 0.04),
        },
    )


def _corner_sofa(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    arm, seat, low = ARM, min(0.44, 0.56 * h), 0.1
    deep, lounge = min(0.95, 0.7 * 2 * d), min(1.0, 0.42 * 2 * w)
    front, edge = -d + deep, -w + lounge
    count = max(1, round((w - arm - edge) / 0.75))
    body = [
        make_bevelled_box((edge, w - 0.02), (-d + 0.02, front - 0.03), (low, seat - 0.15), 0.015),
        make_bevelled_box((-w + 0.02, edge), (-d + 0.02, d - 0.03), (low, seat - 0.15), 0.015),
        cushion((-w + 0.01, w - 0.01), (-d, -d + 0.15), (low, h - 0.05), 0.05),
        cushion((w - arm, w), (-d + 0.02, front - 0.01), (low, seat + 0.17), 0.05),
        cushion((-w, -w + arm), (-d + 0.02, front - 0.01), (low, seat + 0.17), 0.05),
    ]
    soft = [
        *_seats((edge, w - arm), (-d + 0.14, front), (seat - 0.16, seat), count),
        *_seats((-w + arm, edge), (-d + 0.14, front), (seat - 0.16, seat), 1),
        *_seats((-w, edge), (front, d), (seat - 0.16, seat), 1),
        *_backs((edge, w - arm), -d + 0.1, (seat - 0.02, h), count),
        *_backs((-w + arm, edge), -d + 0.1, (seat - 0.02, h), 1),
    ]
    pillow = min(0.42, h - seat - 0.02)
    return parts(
        size,
        {
            FABRIC: body,
            FABRIC_LIGHT: soft,
            TERRACOTTA: [throw_pillow(-w + arm + 0.24, -d + 0.38, seat - 0.02, pillow, 0.3, -0.3)],
            NAVY: [throw_pillow(w - arm - 0.24, -d + 0.38, seat - 0.02, pillow, 0.3, 0.35)],
            OAK: [
                leg(x, y, (0, low + 0.01), 0.026, 0.018)
                for x, y in (
                    (-w + 0.07, -d + 0.07),
                    (-w + 0.07, d - 0.09),
                    (edge - 0.07, d - 0.09),
                    (w - 0.07, -d + 0.07),
                    (w - 0.07, front - 0.09),
                )
            ],
        },
    )


def _armchair(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    arm, seat, low = 0.13, min(0.43, 0.52 * h), 0.17
    inner = (-w + arm - 0.01, w - arm + 0.01)
    body = [
        cushion((-w + 0.03, w - 0.03), (-d + 0.04, d - 0.04), (low, seat - 0.11), 0.03, 1),
        cushion((-w, -w + arm), (-d + 0.07, d - 0.03), (low + 0.02, seat + 0.17), 0.055),
        cushion((w - arm, w), (-d + 0.07, d - 0.03), (low + 0.02, seat + 0.17), 0.055),
        translate_mesh(
            rotate_mesh(
                cushion((-w + 0.05, w - 0.05), (0, 0.14), (0, h - low - 0.02), 0.06, 2), "x", 0.1
            ),
            0,
            -d + 0.09,
            low + 0.02,
        ),
    ]
    soft = [*_seats(inner, (-d + 0.16, d), (seat - 0.13, seat), 1)]
    back = [*_backs(inner, -d + 0.16, (seat - 0.02, h - 0.06), 1, 0.13)]
    return parts(
        size,
        {
            SAGE_FABRIC: [*body, *soft, *back],
            WALNUT: four_legs(w, d, (0, low + 0.01), 0.022, 0.013, 0.05, 0.035),
        },
    )


def _dining_chair(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.45, 0.56 * h)
    legs = four_legs(w, d, (0, seat - 0.03), 0.019, 0.012, 0.005, 0.03)
    posts = [
        rod(
            (s * (w - 0.06), -d + 0.075, seat - 0.05),
            (s * (w - 0.065), -d + 0.035, h - 0.05),
            0.016,
            0.013,
        )
        for s in (-1, 1)
    ]
    rest = bent(w - 0.03, -d + 0.06, 0.035, 0.022, (h - 0.2, h), lean=0.02)
    rails = [
        block((-w + 0.05, w - 0.05), (y - 0.01, y + 0.01), (seat - 0.07, seat - 0.02))
        for y in (-d + 0.07, d - 0.07)
    ]
    pad = cushion((-w + 0.015, w - 0.015), (-d + 0.05, d), (seat - 0.03, seat + 0.02), 0.022)
    return parts(size, {OAK_DARK: [*legs, *posts, rest, *rails], FABRIC: [pad]})


def _office_chair(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat, reach = min(0.48, 0.5 * h), min(w, d) - 0.03
    black, wheels = [], []
    for k in range(5):
        angle = pi / 2 + k * 2 * pi / 5
        x, y = reach * cos(angle), reach * sin(angle)
        black.append(rod((0, 0, 0.11), (x, y, 0.07), 0.026, 0.016, 6))
        wheels.append(ball(0.028, 0.028, 0.03, (x, y, 0.03), 8, 4))
    black += [disc(0.025, (0.06, seat - 0.06), sides=10)]
    arms = [
        tube(
            [
                (s * (w - 0.09), 0.02, seat - 0.05),
                (s * (w - 0.03), 0.02, seat - 0.03),
                (s * (w - 0.03), 0.02, seat + 0.14),
            ],
            0.014,
        )
        for s in (-1, 1)
    ]
    rests = [
        cushion(
            (s * (w - 0.03) - 0.03, s * (w - 0.03) + 0.03),
            (-0.12, 0.16),
            (seat + 0.13, seat + 0.16),
            0.014,
            1,
        )
        for s in (-1, 1)
    ]
    seat_pad = cushion(
        (-w + 0.08, w - 0.08), (-d + 0.12, d - 0.04), (seat - 0.06, seat + 0.02), 0.035
    )
    back = bent(w - 0.1, -d + 0.13, 0.05, 0.05, (seat + 0.1, h), lean=0.05)
    stem = tube(
        [(0, 0, seat - 0.06), (0, -d + 0.06, seat - 0.04), (0, -d + 0.04, seat + 0.25)], 0.022
    )
    turning, shell, padded = (
        attach_joint(Joint("seat", "hinge", (0.0, 0.0, seat), (0.0, 0.0, 1.0), -pi, pi), meshes)
        for meshes in ([stem], [*arms, *rests], [seat_pad, back])
    )
    return parts(size, {CHARCOAL: padded, CHROME: [*black, *turning], RUBBER: [*wheels, *shell]})


def _stool(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    legs = four_legs(0.86 * w, 0.86 * d, (0, h - 0.03), 0.018, 0.012, 0.0, 0.04)
    top = lathe(
        [(0, h - 0.045), (0.92, h - 0.045), (1, h - 0.03), (0.98, h - 0.006), (0.85, h)], sides=20
    )
    seat = Mesh(top.vertices * (w, d, 1), top.faces)
    ring = [
        rod((a * 0.71 * w, b * 0.71 * d, 0.17), (c * 0.71 * w, e * 0.71 * d, 0.17), 0.009)
        for a, b, c, e in ((-1, -1, 1, -1), (1, 1, -1, 1))
    ]
    return parts(size, {OAK: [*legs, seat, *ring]})


def _bar_stool(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = h < 0.85
    seat = h - 0.14 if low else h - 0.32
    legs = four_legs(w, d, (0, seat - 0.02), 0.013, 0.013, 0.0, 0.04, square=True)
    rungs = [
        block((-w + 0.03, w - 0.03), (y - 0.01, y + 0.01), (0.2, 0.22))
        for y in (d - 0.03, -d + 0.03)
    ]
    rest = bent(w - 0.03, -d + 0.05, 0.02, 0.022, (h - 0.12, h))
    posts = [
        rod((s * (w - 0.07), -d + 0.05, seat - 0.02), (s * (w - 0.07), -d + 0.03, h - 0.05), 0.011)
        for s in (-1, 1)
    ]
    pad = cushion(
        (-w + 0.03, w - 0.03), (-d + 0.045, d - 0.02), (seat - 0.025, seat + 0.025), 0.022
    )
    return parts(size, {BLACK: [*legs, *rungs, *posts], LEATHER: [pad, rest]})


def _bench(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    legs = four_legs(w - 0.05, d - 0.01, (0, h - 0.06), 0.02, 0.014, 0.0, 0.03)
    rail = block((-w + 0.12, w - 0.12), (-0.015, 0.015), (h - 0.12, h - 0.06))
    seat = slab((-w, w), (-d, d), (h - 0.07, h - 0.035), 0.03)
    pad = cushion((-w + 0.01, w - 0.01), (-d + 0.01, d - 0.01), (h - 0.04, h), 0.018)
    return parts(size, {OAK: [*legs, rail, seat], FABRIC: [pad]})


def _pouf(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows = [(0, 0), (0.78, 0), (0.93, 0.12), (1, 0.35), (1, 0.62), (0.94, 0.85), (0.8, 0.97)]
    body = lathe([*((r, z * h) for r, z in rows), (0.06, h * 0.985)], sides=24)
    seams = pipe(1.005, 0.985, (0.46 * h, 0.5 * h), sides=24)
    knob = disc(0.07, (0.95 * h, h), sides=10)
    mesh = [Mesh(m.vertices * (w, d, 1), m.faces) for m in (body, knob)]
    seam = Mesh(seams.vertices * (w / 1.005, d / 1.005, 1), seams.faces)
    return parts(size, {TERRACOTTA: mesh, LEATHER: [seam]})


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


def _office_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    back = crescent(0.78 * w, -d, 0.18, 0.09)
    arms = [box(s * w - max(s, 0) * 0.06, s * w + max(-s, 0) * 0.06, -0.12, 0.14) for s in (-1, 1)]
    return box(-w + 0.08, w - 0.08, -d + 0.12, d, 0.08), back, *arms


def _round_seat_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return oval(0, 0, w, d), oval(0, 0, 0.8 * w, 0.8 * d)


def _bench_symbol(size: Size) -> Lines:
    return rectangle(size, 0, 0.03), rectangle(size, 0.035, 0.02)


CORNER_SOFA = Drawing(
    "corner_sofa", _corner_sofa, corner_sofa_symbol, footprint=cover(corner_sofa_outline)
)
ASSETS = (
    Drawing("sofa", _sofa, sofa_symbol),
    Drawing("loveseat", _sofa, sofa_symbol),
    CORNER_SOFA,
    mirror_drawing(CORNER_SOFA),
    Drawing("armchair", _armchair, sofa_symbol),
    Drawing("dining_chair", _dining_chair, chair_symbol),
    Drawing("office_chair", _office_chair, _office_symbol),
    Drawing("stool", _stool, _round_seat_symbol),
    Drawing("bar_stool", _bar_stool, chair_symbol),
    Drawing("bench", _bench, _bench_symbol),
    Drawing("pouf", _pouf, round_plain),
)
