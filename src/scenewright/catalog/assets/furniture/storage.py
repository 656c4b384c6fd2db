"""Closed storage: wardrobes, chests, sideboards, stands and cabinets."""

from __future__ import annotations

from scenewright.catalog.assets.bodies import front_joint, slide_joint
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import (
    GAP,
    corpus,
    door_pulls,
    drawer_pulls,
    four_legs,
    fronts,
    knobs,
    spread,
)
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    CREAM,
    GLASS,
    GREIGE,
    MIRROR,
    OAK,
    PINE,
    RATTAN,
    SAGE,
    STEEL,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.objects import book_rows
from scenewright.catalog.assets.symbols import Lines, box, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import block, frame, rod, slab


def _wardrobe(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    doors, face = max(1, round(size.width / 0.5)), d - 0.042
    x, z = (-w + 0.018, w - 0.018), (0.08, h - 0.018)
    case = [
        block((-w, x[0]), (-d, d - 0.02), (0, h)),
        block((x[1], w), (-d, d - 0.02), (0, h)),
        block(x, (-d, d - 0.02), (z[1], h)),
        block(x, (-d + 0.02, face - 0.04), (0, 0.08)),
        block(x, (-d, face), z),
    ]
    return parts(
        size,
        {
            WHITE: case,
            pick(size, (GREIGE, OAK, CREAM)): fronts(x, z, doors, 1, (face, face + 0.022), "door"),
            BRASS: door_pulls(x, z, doors, face + 0.022, 0.02, 0.48, 0.32),
        },
    )


def _shallow_wardrobe(size: Size) -> Parts:
    """Open bays of half a metre, in each a rail from front to back: hangers face the room."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    bays = max(1, round(size.width / 0.5))
    x, z = (-w + 0.018, w - 0.018), (0.08, h - 0.018)
    rails = [0.5 * (a + b) for a, b in spread(*x, bays)]
    walls = [block((a - 0.009, a + 0.009), (-d + 0.012, d), z) for a, _ in spread(*x, bays)[1:]]
    case = [
        *corpus((-w, w), (-d, d), (z[0], h), 0.018, back=True),
        block(x, (-d, d - 0.03), (0, z[0])),
        *walls,
    ]
    coats = [
        block((at - 0.2, at + 0.2), (y, y + 0.03), (0.32 * h, h - 0.2))
        for at in rails
        for y in (-0.6 * d, -0.1 * d, 0.4 * d)
    ]
    rods = [rod((at, -d + 0.02, h - 0.12), (at, d - 0.03, h - 0.12), 0.012) for at in rails]
    return parts(size, {OAK: case, GREIGE: coats[::2], SAGE: coats[1::2], STEEL: rods})


def _sliding_wardrobe(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    doors = 2 if size.width < 2.3 else 3
    x, z, face = (-w + 0.02, w - 0.02), (0.03, h - 0.03), d - 0.07
    found: dict[Material, list[Mesh]] = {
        OAK: [
            block((-w, x[0]), (-d, d), (0, h)),
            block((x[1], w), (-d, d), (0, h)),
            block(x, (-d, d), (z[1], h)),
            block(x, (-d, d), (0, z[0])),
            block(x, (-d, face - 0.01), z),
        ],
        WHITE: [],
        MIRROR: [],
        BLACK: [],
    }
    for i, (a, b) in enumerate(spread(*x, doors)):
        y = face + (0.03 if i % 2 == 0 else 0.0)
        wide = (a - (0.02 if i else 0), b)
        pane = (wide[0] + 0.012, wide[1] - 0.012)
        panel = MIRROR if i == 1 else WHITE
        joint = slide_joint("panel", wide, z, y, 0.9 * (b - a) * (-1 if i else 1))
        up = (z[0] + GAP, z[1] - GAP)
        found[BLACK].append(frame(wide, (y, y + 0.024), up, 0.014)._replace(joint=joint))
        found[panel].append(block(pane, (y + 0.004, y + 0.019), (z[0] + 0.012, z[1] - 0.012)))
    return parts(size, found)


def _chest(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, face = 0.12, d - 0.04
    rows, columns = max(2, round((h - low) / 0.23)), 2 if size.width > 1.05 else 1
    x, z = (-w + 0.02, w - 0.02), (low + 0.02, h - 0.025)
    return parts(
        size,
        {
            OAK: [
                slab((-w, w), (-d, d - 0.02), (h - 0.022, h), 0.01),
                block((-w + 0.003, w - 0.003), (-d + 0.003, face), (low, h - 0.022)),
                *four_legs(w, d - 0.01, (0, low + 0.01), 0.02, 0.013, 0.03, 0.02),
            ],
            WHITE: fronts(x, z, columns, rows, (face, face + 0.018)),
            BRASS: knobs(x, z, columns, rows, face + 0.018, 0.022, 0.5),
        },
    )


def _sideboard(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, face = 0.18, d - 0.03
    x, z = (-w + 0.022, w - 0.022), (low + 0.022, h - 0.022)
    third = (x[1] - x[0]) / 3
    doors = [(x[0], x[0] + third), (x[1] - third, x[1])]
    middle = (x[0] + third, x[1] - third)
    panels = [m for door in doors for m in fronts(door, z, 1, 1, (face - 0.02, face), "door")]
    slats = [
        block((a + 0.004, b - 0.004), (face, face + 0.01), (z[0] + 0.02, z[1] - 0.02))
        for door in doors
        for a, b in spread(door[0] + 0.03, door[1] - 0.03, 10)
    ]
    return parts(
        size,
        {
            WALNUT: [
                *corpus((-w, w), (-d, d), (low, h), 0.022, back=True),
                block(x, (-d + 0.01, face - 0.025), z),
                *panels,
                *slats,
                *fronts(middle, z, 1, 3, (face - 0.02, face)),
            ],
            BLACK: four_legs(w, d, (0, low + 0.005), 0.015, 0.011, 0.06, 0.03),
            BRASS: drawer_pulls(middle, z, 1, 3, face, 0.02, 0.35),
        },
    )


def _tv_stand(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, face = 0.28 * h, d - 0.012
    x, z = (-w + 0.02, w - 0.02), (low + 0.02, h - 0.02)
    third = (x[1] - x[0]) / 3
    sides = [(x[0], x[0] + third), (x[1] - third, x[1])]
    middle = (x[0] + third, x[1] - third)
    solid = [block(s, (-d + 0.01, face - 0.02), z) for s in sides]
    shelf = block(middle, (-d + 0.01, d - 0.03), (sum(z) / 2 - 0.008, sum(z) / 2 + 0.008))
    player = block((-0.18, 0.18), (-d + 0.1, d - 0.08), (z[0], z[0] + min(0.055, 0.2 * h)))
    return parts(
        size,
        {
            OAK: [*corpus((-w, w), (-d, d), (low, h), 0.02), *solid, shelf],
            WHITE: [m for s in sides for m in fronts(s, z, 1, 1, (face - 0.02, face), "door")],
            BRASS: [m for s in sides for m in knobs(s, z, 1, 1, face, 0.012)],
            BLACK: [player, *four_legs(w, d, (0, low + 0.005), 0.016, 0.011, 0.05, 0.025)],
        },
    )


def _shoe_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows, columns = max(2, round(h / 0.4)), 2 if size.width > 0.95 else 1
    face, low = d - 0.04, 0.06
    x, z = (-w + 0.016, w - 0.016), (low, h - 0.025)
    flaps = [
        rotate_mesh(m, "x", 0.03, (0, face, m.vertices[:, 2].min()))
        for m in fronts(x, z, columns, rows, (face + 0.012, face + 0.028), "flap")
    ]
    return parts(
        size,
        {
            WHITE: flaps,
            OAK: [
                block((-w, w), (-d, d), (h - 0.022, h)),
                block((-w + 0.005, w - 0.005), (-d, face), (0, h - 0.022)),
            ],
            BRASS: drawer_pulls(x, z, columns, rows, face + 0.016, 0.022, 0.3),
        },
    )


def _toy_box(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    lid = slab((-w, w), (-d, d), (h - 0.025, h), 0.02)
    body = block((-w + 0.012, w - 0.012), (-d + 0.012, d - 0.012), (0.03, h - 0.028))
    stripe = block((-w + 0.008, w - 0.008), (-d + 0.008, d - 0.008), (0.3 * h, 0.5 * h))
    holes = [
        block(
            (s * (w - 0.006) - 0.004, s * (w - 0.006) + 0.004), (-0.06, 0.06), (0.7 * h, 0.78 * h)
        )
        for s in (-1, 1)
    ]
    feet = four_legs(w, d, (0, 0.035), 0.022, 0.022, 0.03)
    return parts(size, {PINE: [lid, body, *feet], SAGE: [stripe], BLACK: holes})


def _display_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, split, face = 0.1, 0.1 + 0.28 * h, d - 0.035
    columns = max(1, round(size.width / 0.45))
    x, z = (-w + 0.022, w - 0.022), (split + 0.02, h - 0.022)
    inside = (-w + 0.05, w - 0.05)
    shelves = 3 if h > 1.5 else 2
    found: dict[Material, list[Mesh]] = {
        OAK: [
            *corpus((-w, w), (-d, face), (low, h), 0.022),
            *corpus(
                (-w + 0.023, w - 0.023),
                (-d + 0.01, face - 0.01),
                (split, h - 0.023),
                0.018,
                shelves,
                back=False,
            ),
            *four_legs(w, d - 0.03, (0, low + 0.01), 0.02, 0.014, 0.03, 0.02),
            block(x, (-d + 0.01, face - 0.003), (low + 0.02, split - 0.002)),
            *(
                frame(wide, (face, face + 0.018), z, 0.035)._replace(
                    joint=front_joint("door", wide, z, (face, face + 0.018), bool(i % 2))
                )
                for i, (a, b) in enumerate(spread(*x, columns))
                for wide in [(a + 0.003, b - 0.003)]
            ),
        ],
        CREAM: fronts(x, (low + 0.02, split), columns, 1, (face, face + 0.018), "door"),
        GLASS: [
            block((a + 0.036, b - 0.036), (face + 0.006, face + 0.01), (z[0] + 0.033, z[1] - 0.033))
            for a, b in spread(*x, columns)
        ],
        BRASS: door_pulls(x, z, columns, face + 0.018, 0.017, 0.3, 0.12),
    }
    levels = spread(split + 0.018, h - 0.04, shelves + 1)
    for material, meshes in book_rows(inside, (-d + 0.03, face - 0.06), levels, 0.5).items():
        found.setdefault(material, []).extend(meshes)
    return parts(size, found)


def _bathroom_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    face, low = d - 0.035, 0.1 if h > 0.9 else 0.0
    columns = 2 if size.width > 0.5 else 1
    x, z = (-w + 0.004, w - 0.004), (low, h)
    rows = 2 if h > 1.2 else 1
    legs = four_legs(w, d - 0.03, (0, low + 0.01), 0.014, 0.014, 0.02) if low else []
    return parts(
        size,
        {
            WHITE: [block((-w, w), (-d, face), z)],
            OAK: fronts(x, z, columns, rows, (face, face + 0.018), "door"),
            BLACK: [
                *legs,
                *(
                    p
                    for part in spread(*z, rows)
                    for p in door_pulls(x, part, columns, face + 0.018, 0.017, 0.5, 0.16)
                ),
            ],
        },
    )


def _laundry_basket(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    bands = spread(0, h - 0.05, 8)
    body = [
        slab(
            (-w + 0.012 + 0.004 * (i % 2), w - 0.012 - 0.004 * (i % 2)),
            (-d + 0.012 + 0.004 * (i % 2), d - 0.012 - 0.004 * (i % 2)),
            band,
            0.07,
            3,
        )
        for i, band in enumerate(bands)
    ]
    lid = slab((-w, w), (-d, d), (h - 0.05, h - 0.012), 0.08, 3)
    knob = slab((-0.06, 0.06), (-0.015, 0.015), (h - 0.014, h), 0.012)
    return parts(size, {RATTAN: [*body, lid], STEEL: [knob]})


def draw_hangers(size: Size) -> Lines:
    """Outline, the line of the doors, the rail and strokes for the hangers."""
    w, d = size.width / 2, size.depth / 2
    rail = -0.05 * size.depth
    count = max(3, round(size.width / 0.11))
    strokes = [
        path((x - 0.02, rail - 0.5 * d), (x + 0.02, rail + 0.5 * d))
        for x in (-w + (i + 0.5) * size.width / count for i in range(count))
    ]
    return (
        rectangle(size),
        path((-w, d - 0.03), (w, d - 0.03)),
        path((-w + 0.03, rail), (w - 0.03, rail)),
        *strokes,
    )


def draw_front_line(size: Size) -> Lines:
    """The footprint and the line of its doors."""
    w, d = size.width / 2, size.depth / 2
    line = d - min(0.04, 0.15 * size.depth)
    return rectangle(size), path((-w, line), (w, line))


def _sideboard_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = d - 0.04
    thirds = [path((x, line), (x, d)) for x in (-w / 3, w / 3)]
    return rectangle(size), path((-w, line), (w, line)), *thirds


def _draw_lid(size: Size) -> Lines:
    return rectangle(size, 0, 0.04), rectangle(size, 0.04, 0.03)


def _chest_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size),
        path((-w, d - 0.04), (w, d - 0.04)),
        box(-0.06, 0.06, d - 0.03, d - 0.01),
    )


def _draw_facing_hangers(size: Size) -> Lines:
    """The outline, and in each bay a rail from front to back with hangers across it."""
    w, d = size.width / 2, size.depth / 2
    bays = spread(-w, w, max(1, round(size.width / 0.5)))
    rails = [path((0.5 * (a + b), -d), (0.5 * (a + b), d)) for a, b in bays]
    hangers = [path((a + 0.04, y * d), (b - 0.04, y * d)) for a, b in bays for y in (-0.4, 0.3)]
    return rectangle(size), *rails, *hangers


_SHALLOW = (Size(0.5, 0.35, 1.8), Size(1.0, 0.4, 2.0), Size(2.0, 0.45, 2.2))
_SLIDING = (Size(1.6, 0.55, 1.9), Size(2.4, 0.65, 2.3), Size(3.6, 0.75, 2.7))

ASSETS = (
    Drawing("wardrobe", _wardrobe, draw_hangers),
    Drawing(
        "wardrobe",
        _sliding_wardrobe,
        draw_hangers,
        id="wardrobe_sliding",
        name="Sliding wardrobe",
        sizes=_SLIDING,
    ),
    Drawing(
        "wardrobe",
        _shallow_wardrobe,
        _draw_facing_hangers,
        id="wardrobe_shallow",
        name="Shallow wardrobe",
        sizes=_SHALLOW,
        called=("shallow wardrobe",),
    ),
    Drawing("chest_of_drawers", _chest, _chest_symbol),
    Drawing("sideboard", _sideboard, _sideboard_symbol),
    Drawing("tv_stand", _tv_stand, draw_front_line),
    Drawing("shoe_cabinet", _shoe_cabinet, draw_front_line),
    Drawing("toy_box", _toy_box, _draw_lid),
    Drawing("display_cabinet", _display_cabinet, draw_front_line),
    Drawing("bathroom_cabinet", _bathroom_cabinet, draw_front_line),
    Drawing("laundry_basket", _laundry_basket, _draw_lid),
)
