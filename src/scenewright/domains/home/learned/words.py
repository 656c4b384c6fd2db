"""What makes a furniture group and what belongs to it, for learning groups from furnished rooms."""

from __future__ import annotations

from typing import NamedTuple


class Company(NamedTuple):
    """Categories that join a group, how near they must be in metres, and whether they stand in
    a row with what makes it."""

    kinds: tuple[str, ...]
    reach: float = 0.4
    row: bool = False


ANCHORS: dict[str, str] = {
    "double_bed": "sleeping", "bunk_bed": "bunk", "single_bed": "single",
    "dining_table": "dining", "round_table": "dining", "outdoor_table": "terrace",
    "desk": "desk", "kids_desk": "kids_desk", "vanity": "vanity",
    "corner_sofa": "seating", "sofa": "seating", "loveseat": "seating",
    "tv_stand": "media", "sink_cabinet": "kitchen", "drawer_cabinet": "counter",
    "base_cabinet": "counter", "fridge": "fridge", "wardrobe": "wardrobe",
    "chest_of_drawers": "chest", "sideboard": "sideboard", "bookcase": "shelf",
    "console_table": "console", "shoe_cabinet": "shoes", "coat_rack": "coats",
    "toilet": "toilet", "basin": "basin", "pedestal_basin": "basin", "bathtub": "bath",
    "shower": "shower", "washing_machine": "washer", "armchair": "reading",
    "potted_tree": "plant", "deck_chair": "lounger",
}  # fmt: skip
"""The piece that makes a group and its function; earlier ones take their company first."""

SEATS = ("dining_chair", "office_chair", "stool", "bench")
_UNITS = ("base_cabinet", "drawer_cabinet", "sink_cabinet", "hob_cabinet", "oven_cabinet",
          "dishwasher", "fridge", "tall_cabinet")  # fmt: skip

COMPANIONS: dict[str, Company] = {
    "sleeping": Company(("nightstand", "rug", "pouf", "bench")),
    "single": Company(("nightstand", "rug")),
    "dining": Company((*SEATS, "rug"), 0.5),
    "terrace": Company(("outdoor_chair", "bench"), 0.5),
    "desk": Company(("office_chair", "dining_chair", "stool"), 0.4),
    "kids_desk": Company(("office_chair", "dining_chair", "stool"), 0.4),
    "vanity": Company(("stool", "pouf", "dining_chair"), 0.4),
    "seating": Company(("coffee_table", "side_table", "armchair", "loveseat", "pouf",
                        "floor_lamp", "rug"), 1.1),
    "media": Company(("speaker",)),
    "reading": Company(("floor_lamp", "side_table", "pouf"), 0.5),
    "washer": Company(("dryer", "washing_machine"), row=True),
    "shelf": Company(("bookcase",), row=True),
    "wardrobe": Company(("wardrobe",), row=True),
    "kitchen": Company(_UNITS, row=True),
    "counter": Company(("base_cabinet", "drawer_cabinet", "dishwasher", "oven_cabinet"), row=True),
}  # fmt: skip

ABOVE: dict[str, tuple[str, ...]] = {
    "basin": ("mirror",), "vanity": ("mirror",), "chest": ("mirror", "picture"),
    "console": ("mirror", "picture"), "sideboard": ("picture",), "sleeping": ("picture",),
    "seating": ("picture",), "kitchen": ("wall_cabinet", "hood"), "counter": ("wall_cabinet",),
}  # fmt: skip
"""What hangs on the wall above a group and belongs to it."""

ROOMS: dict[tuple[str, ...], str] = {
    (table, room): "desk"
    for table in ("dining_table",)
    for room in ("bedroom", "double_bedroom", "single_bedroom", "child_bedroom", "study")
}
"""What a piece makes in a room, where that is not the usual."""

RUNS: tuple[tuple[str, frozenset[str], frozenset[str]], ...] = (
    ("kitchen", frozenset(("sink_cabinet", "hob_cabinet", "fridge")), frozenset()),
    ("kitchenette", frozenset(("sink_cabinet", "hob_cabinet")), frozenset()),
    ("fridge", frozenset(("fridge",)), frozenset(("sink_cabinet", "base_cabinet"))),
    ("counter", frozenset(("drawer_cabinet",)), frozenset(("sink_cabinet", "fridge"))),
)
"""Kitchen runs by what they must and must not hold."""
