"""Where one pays: checkouts with a belt, cash desks."""

from __future__ import annotations

from functools import partial

import numpy as np

from scenewright.catalog.assets.drawing import LETTERS, Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    ACCENT,
    CHARCOAL,
    OAK,
    RUBBER,
    SCREEN,
    STEEL,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import merge_by_material, stock
from scenewright.catalog.assets.symbols import Lines, box, oval, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import rotate_mesh
from scenewright.geometry.solids import block, make_bevelled_box, rod, tube


def _checkout(size: Size, front: Material = OAK, seed: int = 0) -> Parts:
    """Customers walk along the front; the cashier sits behind, right of the belt. A panelled
    front with a rail, goods on the belt, a rack of small things at its end."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.88, 0.75 * h)
    desk, till, belt = (-0.1 * d, d), 0.35 * w, (-w + 0.05, 0.1 * w)
    stand = rod((till, 0.1 * d, top), (till, 0.1 * d, h - 0.2), 0.02, sides=8)
    shown = make_bevelled_box(
        (till - 0.17, till + 0.17), (0.1 * d - 0.02, 0.1 * d + 0.02), (h - 0.26, h), 0.008
    )
    pay = rotate_mesh(
        block((till - 0.05, till + 0.05), (0.75 * d, 0.75 * d + 0.14), (top + 0.05, top + 0.09)),
        "x", 0.4, (till, 0.75 * d, top + 0.05))  # fmt: skip
    y = (desk[0] + 0.02, d - 0.03)
    panels = [
        block((a + 0.006, b - 0.006), (d - 0.03, d - 0.012), (0.13, top - 0.05))
        for a, b in spread(-w + 0.02, w - 0.02, max(2, round(size.width / 0.5)))
    ]
    found: Stuff = {
        WHITE: [
            block((-w, w), (y[0] - 0.02, y[1]), (0.1, top - 0.03)),
            block((till - 0.5 * w, till - 0.42 * w), (-d, desk[0]), (0.1, top - 0.06)),
            block((0.85 * w, w), (-d, desk[0]), (0.1, top - 0.06)),
        ],
        STEEL: [
            make_bevelled_box((-w, w), desk, (top - 0.03, top), 0.008),
            stand,
            tube([(-w + 0.04, d - 0.02, top + 0.05), (w - 0.04, d - 0.02, top + 0.05)], 0.014, 6),
            *(rod((x, d - 0.02, top), (x, d - 0.02, top + 0.05), 0.008, sides=6)
              for x in np.linspace(-0.9 * w, 0.9 * w, 4)),
        ],
        RUBBER: [
            block(belt, (0.02 * d, 0.85 * d), (top, top + 0.012)),
            block((-w + 0.04, w - 0.04), (-0.05 * d, d - 0.06), (0, 0.1)),
        ],
        SCREEN: [shown, pay],
        CHARCOAL: [block((0.6 * w, 0.9 * w), (0.05 * d, 0.8 * d), (top, top + 0.008))],
    }  # fmt: skip
    found.setdefault(front, []).extend(panels)
    bought = stock(
        "groceries", (belt[0] + 0.05, belt[1] - 0.3 * w), (0.1 * d, 0.75 * d),
        [(top + 0.012, h)], seed, 700)  # fmt: skip
    return parts(size, merge_by_material(found, bought))


def _cash_desk(size: Size) -> Parts:
    """A counter to pay at without a belt: a screen and a card reader on a closed desk."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(1.0, h - 0.25)
    till = 0.4 * w
    shown = block((till - 0.17, till + 0.17), (-0.02, 0.02), (top + 0.06, top + 0.25))
    pay = block((till - 0.3, till - 0.2), (0.5 * d, 0.5 * d + 0.14), (top, top + 0.04))
    return parts(
        size,
        {
            WHITE: [block((-w + 0.02, w - 0.02), (-0.2 * d, d - 0.04), (0.1, top - 0.04))],
            OAK: [block((-w, w), (-d, d), (top - 0.04, top))],
            RUBBER: [block((-w + 0.04, w - 0.04), (-0.15 * d, d - 0.08), (0, 0.1))],
            STEEL: [rod((till, 0.0, top), (till, 0.0, top + 0.08), 0.02, sides=6)],
            SCREEN: [shown, pay],
        },
    )


def _checkout_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = -0.1 * d
    belt = box(-w + 0.05, 0.1 * w, 0.02 * d, 0.85 * d)
    return (
        rectangle(size),
        path((-w, line), (w, line)),
        belt,
        oval(0.52 * w, -0.55 * d, 0.25 * min(w, d)),
    )


def _cash_desk_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = 0.7 * d
    return rectangle(size), path((-w, line), (w, line)), box(0.2 * w, 0.6 * w, -0.1 * d, 0.1 * d)


ASSETS = (
    *(
        Drawing(
            "checkout",
            partial(_checkout, front=front, seed=k),
            _checkout_symbol,
            f"checkout_{LETTERS[k]}" if k else "",
            f"Checkout, {suit}",
            suit=suit,
        )
        for k, (suit, front) in enumerate((("oak", OAK), ("steel", ACCENT), ("black", WALNUT)))
    ),
    Drawing(
        "checkout",
        _cash_desk,
        _cash_desk_symbol,
        id="checkout_desk",
        name="Cash desk",
        sizes=(Size(0.8, 0.5, 0.9), Size(1.6, 0.7, 1.2), Size(3.0, 0.78, 1.4)),
    ),
)
