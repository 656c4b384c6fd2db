"""What kinds of ours are called by AI2-THOR, and its words for what fills holes of walls."""

from __future__ import annotations

from typing import NamedTuple

ROOM_TYPES = {
    "kitchen": "Kitchen",
    "bedroom": "Bedroom",
    "double_bedroom": "Bedroom",
    "single_bedroom": "Bedroom",
    "child_bedroom": "Bedroom",
    "bathroom": "Bathroom",
    "toilet": "Bathroom",
    "washroom": "Bathroom",
}
"""The four types a room may be of, by what it serves as; all else is lived in."""
LIVING = "LivingRoom"
FUNCTIONS = {"Kitchen": "kitchen", "Bedroom": "bedroom", "Bathroom": "bathroom", LIVING: "living"}

TYPES = {
    "armchair": "ArmChair",
    "base_cabinet": "CounterTop",
    "basin": "Sink",
    "bookcase": "ShelvingUnit",
    "books": "Book",
    "bowl": "Bowl",
    "box": "Box",
    "chest_of_drawers": "Dresser",
    "coffee_table": "CoffeeTable",
    "desk": "Desk",
    "desk_lamp": "DeskLamp",
    "dining_chair": "Chair",
    "dining_table": "DiningTable",
    "double_bed": "Bed",
    "dryer": "ClothesDryer",
    "floor_lamp": "FloorLamp",
    "fridge": "Fridge",
    "laptop": "Laptop",
    "laundry_basket": "LaundryHamper",
    "litter_bin": "GarbageCan",
    "loveseat": "Sofa",
    "monitor": "Desktop",
    "nightstand": "SideTable",
    "office_chair": "Chair",
    "pedestal_basin": "Sink",
    "picture": "Painting",
    "plant": "HousePlant",
    "pouf": "Ottoman",
    "shelf_unit": "ShelvingUnit",
    "side_table": "SideTable",
    "single_bed": "Bed",
    "sink_cabinet": "CounterTop",
    "sofa": "Sofa",
    "stool": "Stool",
    "table_lamp": "DeskLamp",
    "toilet": "Toilet",
    "toy_box": "Box",
    "tv": "Television",
    "tv_stand": "TVStand",
    "vase": "Vase",
    "wardrobe": "Dresser",
    "washing_machine": "WashingMachine",
}
"""The object type of a kind; others are called by our name: ``towel_rail`` is ``TowelRail``."""
KINDS = {kind: name for name, kind in reversed(TYPES.items())} | {
    "Bed": "double_bed",
    "Chair": "dining_chair",
    "Sink": "basin",
    "Dresser": "chest_of_drawers",
    "SideTable": "side_table",
    "Footstool": "pouf",
    "Safe": "box",
}
"""The kind a type is read as."""


class HoleAsset(NamedTuple):
    """A door, frame or window of AI2-THOR's: its id, width and height in metres."""

    name: str
    width: float
    height: float


DOORS = (HoleAsset("Doorway_1", 1.0815, 2.1302), HoleAsset("Doorway_Double_1", 1.9969, 2.1302))
FRAMES = (HoleAsset("Doorframe_1", 1.0815, 2.1302), HoleAsset("Doorframe_Double_1", 1.9969, 2.1302))
WINDOWS = (
    HoleAsset("Window_Fixed_36x48", 0.915, 1.2192),
    HoleAsset("Window_Fixed_60x36", 1.5314, 0.9235),
    HoleAsset("Window_Fixed_60x48", 1.5296, 1.2194),
    HoleAsset("Window_Fixed_96x48", 2.4436, 1.2274),
    HoleAsset("Window_Fixed_96x72", 2.4422, 1.8288),
)
HOLES = {"door": DOORS, "passage": FRAMES, "window": WINDOWS}
"""What fills an opening of each kind; it is scaled to the hole."""


def nearest_asset(kind: str, width: float, height: float) -> HoleAsset:
    """What has to be scaled least to fill a hole.

    >>> nearest_asset("door", 0.9, 2.0).name, nearest_asset("window", 1.4, 1.3).name
    ('Doorway_1', 'Window_Fixed_60x48')
    """
    return min(HOLES[kind], key=lambda a: abs(a.width - width) + abs(a.height - height))


def object_type(category: str) -> str:
    """The object type of a kind.

    >>> object_type("sofa"), object_type("towel_rail")
    ('Sofa', 'TowelRail')
    """
    return TYPES.get(category) or "".join(word.capitalize() for word in category.split("_"))


def category_of_type(kind: str) -> str:
    """The kind of an object type; a type without one in its own words.

    >>> category_of_type("Bed"), category_of_type("TowelRail"), category_of_type("DogBed")
    ('double_bed', 'towel_rail', 'dog_bed')
    """
    words = "".join(f"_{c.lower()}" if c.isupper() else c for c in kind).strip("_")
    return KINDS.get(kind) or words
