"""Kinds offered for things that are no kinds of halls: by sense, not by spelling."""

from __future__ import annotations

from collections.abc import Mapping

from scenewright.catalog.suggestions import suggest_kinds
from scenewright.core.kind import Kind

ISLANDS = (
    *("car", "sculpture", "statue", "globe", "skeleton", "dinosaur", "whale", "boat", "ship"),
    *("aeroplane", "airplane", "plane", "locomotive", "train", "stand", "booth", "model"),
)
"""Drawings of an exhibit island, by words in its name."""
PICTURES = ("painting", "picture", "photograph", "photo", "drawing", "print", "poster", "art")
"""Words in names of wall exhibits that hang as pictures."""
COLD = "fridge_shelf, a cooler for goods, or fridge, as in a kitchen"
"""Words for cooled furniture."""
OTHERS = {
    "mirror": "fitting_room, which has one",
    "tv": "screen",
    "television": "screen",
    "monitor": "screen or catalogue_terminal",
    "computer": "catalogue_terminal",
    "whiteboard": "screen",
    "blackboard": "screen",
    "projector": "screen",
    "plant": "potted_tree or planter",
    "flowers": "planter",
    "tree": "potted_tree",
    "curtain": "partition",
    "chair": "dining_chair, reading_chair, auditorium_seat or lounge_seat",
    "seat": "auditorium_seat, lounge_seat or dining_chair",
    "armchair": "lounge_seat",
    "sofa": "lounge_seat",
    "table": "round_table, dining_table, reading_table or display_table",
    "bar": "counter",
    "reception": "info_desk",
    "shelf": "gondola, wall_shelving, book_stack or bookcase",
    "wardrobe": "coat_rack or lockers",
    "fence": "rope_barrier or glass_barrier",
    "wall": "partition",
    "column": "holes of the room",
    "atm": "cash_machine",
    "photocopier": "copier",
    "printer": "copier",
    **dict.fromkeys(("freezer", "chest freezer", "cooler", "chiller", "refrigerator"), COLD),
}
"""By what is asked for."""


def offer_stand_in(name: str, kinds: Mapping[str, Kind], unknown: bool = True) -> str:
    """What to ask a hall for instead of a kind that is ``unknown`` or does not stand on the floor;
    empty where nothing is known.

    >>> offer_stand_in("paintings", {}), offer_stand_in("car", {})
    ("use wall_exhibit with the name 'paintings'", "use exhibit_island with the name 'car'")
    >>> offer_stand_in("mirror", {}), offer_stand_in("unicorn", {})
    ('use fitting_room, which has one', '')
    """
    said = name.casefold().replace("_", " ").strip()
    one = said if said in OTHERS else said.removesuffix("s")
    if one in ISLANDS or said in ISLANDS:
        return f"use exhibit_island with the name '{said}'"
    if one in PICTURES:
        return f"use wall_exhibit with the name '{said}'"
    if one in OTHERS:
        return f"use {OTHERS[one]}"
    standing = {key: kind for key, kind in kinds.items() if kind.support == "floor" and kind.hall}
    near = suggest_kinds(name, standing) if unknown else []
    return f"use one of: {', '.join(near)}" if near else ""
