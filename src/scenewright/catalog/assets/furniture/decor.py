"""Pictures, clocks and books."""

from __future__ import annotations

from math import pi

from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import BLACK, OAK, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import SPINES, Stuff, wobble
from scenewright.catalog.assets.symbols import Lines, close_line, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import block, disc, pipe


def _wall_clock(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height

    def facing(mesh: Mesh) -> Mesh:
        upright = rotate_mesh(mesh, "x", -pi / 2)
        return Mesh(upright.vertices * (w, 1, h / 2) + (0, 0, h / 2), upright.faces)

    hands = [
        block((-0.03, 0.03), (-0.1, 0.5), (0.2 * d, 0.5 * d)),
        rotate_mesh(block((-0.02, 0.02), (-0.1, 0.72), (0.3 * d, 0.6 * d)), "z", 2.1),
    ]
    ticks = [
        rotate_mesh(block((-0.02, 0.02), (0.74, 0.84), (0.0, 0.4 * d)), "z", k * pi / 6)
        for k in range(12)
    ]
    return parts(
        size,
        {
            OAK: [facing(pipe(1, 0.9, (-d, d), sides=28))],
            WHITE: [facing(disc(0.92, (-0.8 * d, 0.2 * d), sides=28))],
            BLACK: [facing(m) for m in (*hands, *ticks)],
        },
    )


def _books(size: Size) -> Parts:
    """A row of books; a stack if there is no height for a row."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    found: Stuff = {}
    if h > 0.75 * size.depth:
        count = max(2, round(size.width / 0.035))
        for k, (a, b) in enumerate(spread(-w, w, count)):
            tall, deep = h * (0.75 + 0.25 * wobble(k)), size.depth * (0.8 + 0.2 * wobble(k + 0.5))
            book = block((a + 0.001, b - 0.001), (-d, -d + deep), (0, h if k == 1 else tall))
            found.setdefault(SPINES[int(wobble(k + 0.75) * len(SPINES))], []).append(book)
        return parts(size, found)
    for k, level in enumerate(spread(0, h, max(2, round(h / 0.03)))):
        inset = 0.1 * wobble(k) * min(w, d) * (k > 0)
        cover = SPINES[int(wobble(k + 3) * len(SPINES))]
        book = block(
            (-w + inset, w - inset), (-d + inset, d - inset), (level[0], level[1] - 0.0005)
        )
        found.setdefault(cover, []).append(
            rotate_mesh(book, "z", 0.0 if k == 0 else 0.1 * (wobble(k) - 0.5))
        )
    return parts(size, found)


def _books_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    if size.height <= 0.75 * size.depth:
        cover = [
            (-0.85 * w, -0.75 * d),
            (0.8 * w, -0.85 * d),
            (0.85 * w, 0.75 * d),
            (-0.8 * w, 0.85 * d),
        ]
        return rectangle(size), close_line(cover)
    count = max(2, round(size.width / 0.035))
    return rectangle(size), *(path((a, -d), (a, d)) for a, _ in spread(-w, w, count)[1:])
