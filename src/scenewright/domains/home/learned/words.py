"""What makes a furniture group and what belongs to it, for learning groups from furnished rooms."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.catalog.kinds import KINDS


class GroupCompanions(NamedTuple):
    """Categories that join a group, how near they must be in metres, and whether they stand in
    a row with what makes it."""

    kinds: tuple[str, ...]
    reach: float = 0.4
    row: bool = False


ORDER = (
    "sleeping",
    "bunk",
    "single",
    "dining",
    "terrace",
    "desk",
    "kids_desk",
    "vanity",
    "seating",
    "media",
    "kitchen",
    "counter",
    "fridge",
    "wardrobe",
    "chest",
    "sideboard",
    "shelf",
    "console",
    "shoes",
    "coats",
    "toilet",
    "basin",
    "bath",
    "shower",
    "washer",
    "reading",
    "plant",
    "lounger",
)
"""Earlier groups take their company first; any others come last."""


def _order(function: str) -> int:
    return ORDER.index(function) if function in ORDER else len(ORDER)


ANCHORS: dict[str, str] = dict(
    sorted(
        ((kind.category, kind.forms) for kind in KINDS.values() if kind.forms),
        key=lambda anchor: _order(anchor[1]),
    )
)
"""The piece that makes a group and its function, in the order they take their company."""

SEATS = ("dining_chair", "office_chair", "stool", "bench")
_RUN_WORDS = (
    "base_cabinet",
    "drawer_cabinet",
    "sink_cabinet",
    "hob_cabinet",
    "oven_cabinet",
    "dishwasher",
    "fridge",
    "tall_cabinet",
)

COMPANIONS: dict[str, GroupCompanions] = {
    "sleeping": GroupCompanions(("nightstand", "rug", "pouf", "bench")),
    "single": GroupCompanions(("nightstand", "rug")),
    "dining": GroupCompanions((*SEATS, "rug"), 0.5),
    "terrace": GroupCompanions(("outdoor_chair", "bench"), 0.5),
    "desk": GroupCompanions(("office_chair", "dining_chair", "stool"), 0.4),
    "kids_desk": GroupCompanions(("office_chair", "dining_chair", "stool"), 0.4),
    "vanity": GroupCompanions(("stool", "pouf", "dining_chair"), 0.4),
    "seating": GroupCompanions(
        ("coffee_table", "side_table", "armchair", "loveseat", "pouf", "floor_lamp", "rug"), 1.1
    ),
    "media": GroupCompanions(("speaker",)),
    "reading": GroupCompanions(("floor_lamp", "side_table", "pouf"), 0.5),
    "washer": GroupCompanions(("dryer", "washing_machine"), row=True),
    "shelf": GroupCompanions(("bookcase",), row=True),
    "wardrobe": GroupCompanions(("wardrobe",), row=True),
    "kitchen": GroupCompanions(_RUN_WORDS, row=True),
    "counter": GroupCompanions(
        ("base_cabinet", "drawer_cabinet", "dishwasher", "oven_cabinet"), row=True
    ),
}

ABOVE: dict[str, tuple[str, ...]] = {
    "basin": ("mirror",),
    "vanity": ("mirror",),
    "chest": ("mirror", "picture"),
    "console": ("mirror", "picture"),
    "sideboard": ("picture",),
    "sleeping": ("picture",),
    "seating": ("picture",),
    "kitchen": ("wall_cabinet", "hood"),
    "counter": ("wall_cabinet",),
}
"""What hangs on the wall above a group and belongs to it."""

ROOMS: dict[tuple[str, ...], str] = {
    (table, room): "desk"
    for table in ("dining_table",)
    for room in ("bedroom", "double_bedroom", "single_bedroom", "child_bedroom", "study")
}
"""What a piece makes in a room, where that is not the usual."""

RUN_ROWS: tuple[tuple[str, frozenset[str], frozenset[str]], ...] = (
    ("kitchen", frozenset(("sink_cabinet", "hob_cabinet", "fridge")), frozenset()),
    ("kitchenette", frozenset(("sink_cabinet", "hob_cabinet")), frozenset()),
    ("fridge", frozenset(("fridge",)), frozenset(("sink_cabinet", "base_cabinet"))),
    ("counter", frozenset(("drawer_cabinet",)), frozenset(("sink_cabinet", "fridge"))),
)
"""Kitchen runs by what they must and must not hold."""
