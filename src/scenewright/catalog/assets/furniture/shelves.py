"""Open storage: bookcases, shelves, racks."""

from __future__ import annotations

from functools import partial

from scenewright.catalog.assets.drawing import Drawing, letter_models
from scenewright.catalog.assets.joinery import corpus, spread
from scenewright.catalog.assets.materials import BLACK, OAK, RATTAN, SAGE, STEEL, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff, book_rows, boxes, garments, wobble
from scenewright.catalog.assets.symbols import Lines, path, plain, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, cushion, rod, slab, tube

LOW_SHELF = 0.2  # a lower wall shelf is a box on which something stands, metres


def _add(found: Stuff, more: Stuff) -> Stuff:
    for material, meshes in more.items():
        found.setdefault(material, []).extend(meshes)
    return found


def _bookcase(size: Size, start: int = 0) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    columns = max(1, round(size.width / 0.9))
    shelves = max(2, round(h / 0.36) - 1)
    found: Stuff = {OAK: corpus((-w, w), (-d, d), (0.0, h), 0.022, shelves, columns - 1)}
    levels = [(a + 0.014, b - 0.014) for a, b in spread(0.012, h - 0.012, shelves + 1)]
    for k, (a, b) in enumerate(spread(-w + 0.02, w - 0.02, columns)):
        inner = (a + 0.012, b - 0.012)
        rows = levels[1:] if k % 2 == 0 else levels
        _add(found, book_rows(inner, (-d + 0.03, d - 0.04), rows, 0.75, 31 * k + 7 * start))
        if k % 2 == 0:
            _add(found, {SAGE: _panel(inner, (-d + 0.03, d - 0.012), levels[0])})
    return parts(size, found)


def _panel(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    return [block((a + 0.003, b - 0.003), y, (z[0], z[1])) for a, b in spread(*x, 2)]


def _shelf_unit(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    columns, rows = max(1, round(size.width / 0.38)), max(1, round(h / 0.38))
    found: Stuff = {WHITE: corpus((-w, w), (-d, d), (0, h), 0.02, rows - 1, columns - 1)}
    for i, (a, b) in enumerate(spread(-w + 0.01, w - 0.01, columns)):
        for k, (low, high) in enumerate(spread(0.01, h - 0.01, rows)):
            x, z = (a + 0.014, b - 0.014), (low + 0.011, high - 0.011)
            if (i + k) % 2 == 0:
                basket = cushion(
                    (x[0] + 0.01, x[1] - 0.01),
                    (-d + 0.03, d - 0.015),
                    (z[0] + 0.001, z[1] - 0.04),
                    0.02,
                    1,
                )
                _add(found, {RATTAN if k % 2 == 0 else SAGE: [basket]})
            else:
                _add(found, book_rows(x, (-d + 0.04, d - 0.03), [z], 0.9, 17 * i + 5 * k))
    return parts(size, found)


def _storage_shelf(size: Size, start: int = 0) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    count = max(3, round(h / 0.42))
    levels = [0.08 + i * (h - 0.16) / (count - 1) for i in range(count)]
    posts = [
        block(
            (sx * (w - 0.015) - 0.015, sx * (w - 0.015) + 0.015),
            (sy * (d - 0.015) - 0.015, sy * (d - 0.015) + 0.015),
            (0, h),
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    found: Stuff = {
        STEEL: posts,
        OAK: [
            block((-w + 0.004, w - 0.004), (-d + 0.004, d - 0.004), (z - 0.02, z)) for z in levels
        ],
    }
    clear = (h - 0.16) / (count - 1) - 0.04
    for k, z in enumerate(levels[:-1]):
        wide = size.width - 0.1
        row = (-w + 0.05, -w + 0.05 + wide * (0.7 + 0.3 * wobble(k + start)))
        number = max(1, round((row[1] - row[0]) / 0.33))
        _add(found, boxes(row, (-d + 0.03, d - 0.03), (z, z + clear), number, 5 * k + 3 * start))
    return parts(size, found)


def _coat_rack(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rail = h - 0.08
    bars = [
        tube(
            [
                (s * (w - 0.014), -d + 0.014, 0),
                (s * (w - 0.014), -d + 0.014, rail),
                (s * (w - 0.014), d - 0.014, rail),
                (s * (w - 0.014), d - 0.014, 0),
            ],
            0.012,
        )
        for s in (-1, 1)
    ]
    bars.append(rod((-w + 0.014, 0, rail), (w - 0.014, 0, rail), 0.011))
    shelf = [slab((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.02), (0.14, 0.16), 0.01)]
    top = [
        block((-w, w), (y - 0.02, y + 0.02), (rail + 0.012, rail + 0.03))
        for y in (-d + 0.03, 0.0, d - 0.03)
    ]
    shoes = [
        cushion((x - 0.045, x + 0.045), (-0.12, 0.12), (0.16, 0.23), 0.035)
        for x in (-0.55 * w, -0.55 * w + 0.11)
        if size.width > 0.45
    ]
    hat = cushion((-0.1, 0.1), (-0.08, 0.08), (rail + 0.03, h), 0.03)
    found: Stuff = {BLACK: [*bars, *shoes], OAK: [*shelf, *top], RATTAN: [hat]}
    return parts(size, _add(found, garments((-w + 0.08, w - 0.08), 0.0, rail, 0.95)))


def _wall_shelf(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    levels = [(low + 0.024, high) for low, high in spread(0, h, max(1, round(h / 0.34)))]
    found: Stuff = {OAK: [block((-w, w), (-d, d), (low - 0.024, low)) for low, _ in levels]}
    found[BLACK] = [
        block((x - 0.008, x + 0.008), (-d, -d + 0.012), (low, high - 0.003))
        for low, high in levels
        for x in (-0.75 * w, 0.75 * w)
    ]
    if h < LOW_SHELF:
        sides = [block((x - 0.012, x + 0.012), (-d, d), (0, h)) for x in (0.012 - w, w - 0.012)]
        top = block((-w, w), (-d, d), (h - 0.024, h))
        return parts(size, {OAK: [block((-w, w), (-d, d), (0, 0.024)), top, *sides]})
    more = book_rows((-w + 0.03, w - 0.03), (-d + 0.02, d - 0.02), levels, 0.7, round(100 * h))
    return parts(size, _add(found, more))


def _open_shelf(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    columns = max(1, round(size.width / 0.9))
    splits = [path((a, -d), (a, d)) for a, _ in spread(-w, w, columns)[1:]]
    return rectangle(size), path((-w, -d + 0.03), (w, -d + 0.03)), *splits


def _cubes(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    columns = max(1, round(size.width / 0.38))
    return rectangle(size), *(path((a, -d), (a, d)) for a, _ in spread(-w, w, columns)[1:])


def _rack(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, -d), (w, d))


def _coats(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    count = max(2, round(size.width / 0.12))
    strokes = [
        path((x - 0.015, -0.7 * d), (x + 0.015, 0.7 * d))
        for x in (-w + (i + 0.5) * size.width / count for i in range(count))
    ]
    return rectangle(size, 0, 0.02), path((-w + 0.03, 0), (w - 0.03, 0)), *strokes


ASSETS = (
    *letter_models("bookcase", _open_shelf, (partial(_bookcase, start=k) for k in range(10))),
    Drawing("shelf_unit", _shelf_unit, _cubes),
    *letter_models("storage_shelf", _rack, (partial(_storage_shelf, start=k) for k in range(8))),
    Drawing("coat_rack", _coat_rack, _coats),
    Drawing("wall_shelf", _wall_shelf, plain),
)
