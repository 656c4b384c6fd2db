"""The table of small objects: which are put on which kinds, in which rooms, how many, and where.

Counts are a carrier's at the two levels; a fraction is a chance, so 0.5 puts one on every second.
Where there are seats they are a seat's. What makes up a room (``fill``) is placed last, one after
another, until the room holds :data:`ENOUGH`. Nothing is listed for what is sat on to eat or work,
cooked on, or opened at the top: hobs, chairs, stools, baskets, ovens, bins.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from scenewright.catalog.classes import BEDS, DESKS, EATING_TABLES, SOFAS, SOFT_SEATS, WORKTOP

Amount = Literal["none", "some", "lived-in"]
Place = Literal[
    "any", "back", "middle", "side", "seat", "beside", "behind", "lean", "foot", "shelf"
]
"""Anywhere on top; along the back; in the middle; towards a short side; before each seat, beside
what lies there, behind it; leaning on a back; across the foot of a bed; on shelves."""

AMOUNTS: tuple[Amount, ...] = ("none", "some", "lived-in")
ENOUGH = 44
"""Small objects of a room that is lived in, where its furniture has room for them."""
SHARE = 0.6
"""Share of a top's area that small objects and the free space about them may take."""

WORK = tuple(sorted((WORKTOP - {"fridge"}) | {"kitchen_island"}))
TABLES = tuple(sorted(EATING_TABLES | {"outdoor_table"}))
LOW = ("coffee_table", "side_table")
CHESTS = ("sideboard", "chest_of_drawers", "console_table", "shoe_cabinet", "tv_stand", "vanity")
SHELVES = ("bookcase", "shelf_unit", "storage_shelf", "wall_shelf", "display_cabinet")
BASINS = ("basin", "pedestal_basin")
WORKPLACES = tuple(sorted(DESKS))
DESK = (*WORKPLACES, "vanity")
DESKS_OF_HALLS = ("reading_table", "carrel", "info_desk", "counter")
SLEEPING = ("bedroom", "double_bedroom", "single_bedroom")
WET = ("bathroom", "toilet", "washroom")
CHILD = ("child_bedroom",)
GROWN = ("study", "living", "bedroom", "double_bedroom", "single_bedroom", "storage")
ENTRY = ("hall",)


class Row(NamedTuple):
    """``what`` stands ``on`` kinds in ``rooms`` (none named: all): ``some`` and ``lived`` of them
    at the two amounts, ``gap`` metres free about each; ``pile`` are put on one another; ``turn``
    is how far one may be turned, radians; at most
    ``most`` are in a room, piles counted once."""

    what: str
    on: tuple[str, ...]
    some: float
    lived: float
    where: Place = "any"
    rooms: tuple[str, ...] = ()
    pile: int = 1
    gap: float = 0.02
    turn: float = 0.12
    fill: bool = False
    most: int = 99


ROWS = (
    # where one eats
    Row("plate", TABLES, 0, 1, "seat", pile=1, turn=0),
    Row("drinking_glass", TABLES, 0, 1, "behind", turn=0),
    Row("cutlery", TABLES, 0, 2, "beside", gap=0.004, turn=0),
    Row("napkin", TABLES, 0, 1, "beside", gap=0.004, turn=0),
    Row("jug", TABLES, 0.6, 1, "middle"),
    Row("candle", TABLES, 1, 2, "middle"),
    # where one sits
    Row("cushion", tuple(sorted(SOFAS)), 2, 4, "lean", gap=0.0, turn=0),
    Row("cushion", ("armchair",), 0.4, 1, "lean", gap=0.0, turn=0),
    Row("throw", tuple(sorted(SOFAS)), 0, 0.7, "side", turn=0.05),
    Row("book", LOW, 1, 1, "any", pile=3, turn=0.25),
    Row("tray", ("coffee_table",), 0.5, 0.8, "middle"),
    Row("mug", LOW, 0, 1.5, "any", turn=3),
    Row("magazine", LOW, 0.5, 1.5, "any", pile=2, turn=0.3),
    Row("remote_control", ("coffee_table", "tv_stand"), 0.3, 0.7, "any", turn=0.6),
    Row("candle", LOW, 0.5, 1),
    Row("loudspeaker", ("tv_stand",), 0, 2, "side", turn=0, most=2),
    # where one sleeps
    Row("cushion", ("double_bed",), 2, 3, "lean", gap=0.0, turn=0),
    Row("cushion", ("single_bed",), 1, 1, "lean", gap=0.0, turn=0),
    Row("throw", ("double_bed", "single_bed"), 0.6, 1, "foot", turn=0),
    Row("teddy", ("single_bed", "bunk_bed", "cot"), 0.5, 1, "any", CHILD, turn=0.6),
    Row("book", ("nightstand",), 0.6, 1, "any", pile=2, turn=0.3),
    Row("alarm_clock", ("nightstand",), 0.5, 1, "any"),
    Row("drinking_glass", ("nightstand",), 0, 0.7),
    Row("phone", ("nightstand",), 0, 0.6, "any", turn=0.5),
    Row("cream_tube", ("nightstand",), 0, 0.5),
    # where one works
    Row("monitor", WORKPLACES, 0.7, 1, "behind", GROWN, turn=0),
    Row("keyboard", WORKPLACES, 0.7, 1, "seat", GROWN, turn=0),
    Row("mouse", WORKPLACES, 0.7, 1, "beside", GROWN, turn=0),
    Row("pen_pot", DESK, 1, 1, "back"),
    Row("book", DESK, 0.6, 1, "back", pile=3, turn=0.2),
    Row("mug", DESK, 0.3, 0.8, "side", turn=3),
    Row("photo_frame", DESK, 0, 0.7, "back"),
    Row("magazine", DESK, 0, 1, "side", turn=0.3),
    Row("phone", DESK, 0, 0.6, "side", turn=0.5),
    # where one cooks
    Row("kettle", WORK, 0.25, 0.3, "back", ("kitchen",), turn=0.4, most=1),
    Row("toaster", WORK, 0.15, 0.25, "back", most=1),
    Row("utensil_pot", WORK, 0.3, 0.4, "back", most=2),
    Row("jar", WORK, 0.7, 2.2, "back", gap=0.01),
    Row("bottle", WORK, 0.3, 1.2, "back", gap=0.01),
    Row("chopping_board", WORK, 0.25, 0.5, "middle", turn=0.1, most=2),
    Row("plate", WORK, 0.1, 0.4, "back", pile=4, turn=0, most=2),
    Row("mug", WORK, 0.2, 1, "any", turn=3),
    Row("cooking_pot", WORK, 0, 0.3, "back", most=2),
    Row("bowl", ("kitchen_island",), 1, 1, "middle"),
    Row("pump_bottle", ("sink_cabinet", *BASINS), 1, 1, "back", gap=0.005),
    Row("sponge", ("sink_cabinet",), 0.6, 1, "any", gap=0.005),
    # where one washes
    Row("toothbrush_cup", BASINS, 1, 1, "any", ("bathroom", "washroom"), gap=0.003),
    Row("cream_tube", BASINS, 0.5, 3, "any", gap=0.003),
    Row("pump_bottle", ("bathtub",), 1, 2, "any", gap=0.005),
    Row("cream_tube", ("bathtub",), 0, 2, "any", gap=0.005),
    Row("candle", ("bathtub",), 0, 1, "any", gap=0.005),
    Row("paper_roll", ("toilet",), 0.5, 1, "any", gap=0.005),
    Row("towels", ("washing_machine", "dryer", "bathroom_cabinet"), 0.8, 1, "any", WET),
    Row("basket", ("washing_machine", "dryer"), 0.3, 0.6, "back", WET),
    Row("bottle", ("washing_machine", "dryer"), 0, 2, "back", WET),
    Row("storage_box", ("bathroom_cabinet",), 0, 1, "any", WET),
    # what chests and shelves show
    Row("photo_frame", CHESTS[:3], 1, 2, "back", turn=0.3),
    Row("candle", CHESTS[:3], 0.5, 1),
    Row("book", CHESTS[:3], 0.5, 1, "side", pile=4, turn=0.15),
    Row("bowl", CHESTS[:3], 0, 0.5),
    Row("tray", ("sideboard",), 0, 0.5),
    Row("pump_bottle", ("vanity",), 0.5, 2, "back"),
    Row("hat", ("shoe_cabinet", "console_table"), 0.4, 0.7, "side", ENTRY, turn=0.5),
    Row("bag", ("shoe_cabinet", "console_table", "bench"), 0.3, 0.8, "any", ENTRY, turn=0.1),
    Row("magazine", ("shoe_cabinet", "console_table"), 0.5, 1, "any", ENTRY, pile=2, turn=0.3),
    Row("phone", ("shoe_cabinet", "console_table"), 0, 0.5, "any", ENTRY, turn=0.5),
    Row("shoes", ("shoe_cabinet", "console_table", "bench"), 0, 2, "shelf"),
    Row("plant", SHELVES, 0.3, 0.5, "any", ("living", "study", "double_bedroom")),
    Row("storage_box", ("wardrobe",), 0.5, 2, "any", gap=0.05),
    Row("basket", ("fridge", "wardrobe"), 0.2, 0.5),
    # what children leave
    Row("toy_blocks", (*DESK, "shelf_unit", "toy_box", "chest_of_drawers"), 0.4, 1, "any", CHILD),
    Row("toy_car", (*DESK, "shelf_unit", "toy_box", "nightstand"), 0.4, 1, "any", CHILD, turn=3),
    Row("ball", ("toy_box", "shelf_unit", "wardrobe"), 0.3, 0.6, "any", CHILD),
    Row("teddy", ("shelf_unit", "bookcase", "chest_of_drawers"), 0.3, 1, "any", CHILD, turn=0.4),
    # where the public reads and asks
    Row("book", DESKS_OF_HALLS[:2], 0.6, 2, "any", pile=3, turn=0.3),
    Row("laptop", DESKS_OF_HALLS[:2], 0.3, 0.5, "seat", turn=0),
    Row("magazine", DESKS_OF_HALLS[2:], 1, 2, "any", pile=4, turn=0.2),
    Row("pen_pot", DESKS_OF_HALLS[2:], 0.7, 1, "side"),
    Row("plant", DESKS_OF_HALLS[2:], 0.3, 0.5, "side"),
    # what makes a room up
    Row("toy_car", (*SHELVES, *DESK, "toy_box"), 0, 4, "any", CHILD, turn=3, fill=True),
    Row("toy_blocks", (*SHELVES, *DESK, *CHESTS), 0, 3, "any", CHILD, turn=0.5, fill=True),
    Row("ball", SHELVES, 0, 2, "any", CHILD, fill=True),
    Row("cream_tube", (*BASINS, "bathtub", "bathroom_cabinet"), 0, 5, "any", WET, fill=True),
    Row("pump_bottle", (*BASINS, "bathtub", "washing_machine"), 0, 4, "any", WET, fill=True),
    Row(
        "rolled_towel",
        (*SHELVES, "bathroom_cabinet", "washing_machine"),
        0,
        4,
        "any",
        WET,
        3,
        fill=True,
    ),
    Row("paper_roll", (*SHELVES, "toilet", "bathroom_cabinet"), 0, 4, "any", WET, 2, fill=True),
    Row("candle", ("bathtub", "washing_machine", *CHESTS), 0, 2, "any", fill=True),
    Row("jar", (*SHELVES, *WORK, "fridge"), 0, 4, "back", ("kitchen", "storage"), fill=True),
    Row("bottle", (*SHELVES, *WORK), 0, 3, "back", ("kitchen", "storage"), fill=True),
    Row("mug", (*SHELVES, *WORK), 0, 2, "any", ("kitchen",), turn=3, fill=True),
    Row("storage_box", (*SHELVES, "wardrobe"), 0, 3, "any", fill=True),
    Row("book", (*SHELVES, *CHESTS, *LOW, "nightstand", *DESK), 0, 2, "any", (), 5, fill=True),
    Row("photo_frame", (*SHELVES, *CHESTS), 0, 2, "back", turn=0.3, fill=True),
    Row("jar", (*SHELVES, *CHESTS), 0, 2, "any", fill=True),
    Row("plant", (*CHESTS, "wardrobe"), 0, 1, "side", fill=True),
    Row("shoes", ("shoe_cabinet", "bench", "console_table"), 0, 3, "shelf", fill=True),
    Row("hat", ("wardrobe", "shoe_cabinet"), 0, 2, "any", fill=True),
    Row("teddy", (*SHELVES, *DESK, "wardrobe", "chest_of_drawers"), 0, 2, "any", CHILD, fill=True),
    Row("cream_tube", (*CHESTS, "nightstand"), 0, 4, "back", SLEEPING, fill=True),
    Row("pump_bottle", CHESTS, 0, 2, "back", SLEEPING, fill=True),
    Row("candle", ("nightstand", *SHELVES, *LOW), 0, 2, "any", fill=True),
    Row("photo_frame", ("nightstand", *DESK), 0, 2, "back", turn=0.3, fill=True),
    Row("magazine", (*DESK, *LOW, *CHESTS), 0, 2, "any", pile=3, turn=0.3, fill=True),
    Row("book", (*SHELVES, *DESK, "nightstand"), 0, 3, "any", pile=4, turn=0.2, fill=True),
    Row("basket", (*SHELVES, "wardrobe", "bathroom_cabinet"), 0, 2, "any", fill=True),
    Row("bag", ("wardrobe", "chest_of_drawers", "bench", "sideboard"), 0, 2, "any", fill=True),
    Row("storage_box", ("wardrobe", "bathroom_cabinet", "fridge"), 0, 4, "any", fill=True),
    Row("towels", ("chest_of_drawers", "bench", "wardrobe"), 0, 1, "any", fill=True),
)
SOFT = frozenset((*SOFT_SEATS, *BEDS, "cot", "pouf"))
"""What gives way under a small object: :data:`scenewright.clutter.stability.SOFT_GIVES`."""
