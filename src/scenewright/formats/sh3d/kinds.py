"""Which of our kinds of object a Sweet Home 3D piece is: by catalog id, else by its name."""

from __future__ import annotations

from scenewright.catalog.models.furniture import meanings, nearest
from scenewright.catalog.models.words import match
from scenewright.core.scene import Size
from scenewright.formats.sh3d.xml import HomePiece

LANDMARKS = frozenset({"staircase", "fireplace", "column"})

CATALOG = {
    "bed140x190": "double_bed",
    "bed90x190": "single_bed",
    "bed": "bed",
    "bunkBed90x190": "bunk_bed",
    "cornerBunkBed90x190": "bunk_bed",
    "loftBed140x190": "bunk_bed",
    "crib": "cot",
    "bedsideTable": "nightstand",
    "chest": "chest_of_drawers",
    "dresser": "chest_of_drawers",
    "wardrobe": "wardrobe",
    "slidingDoors": "wardrobe",
    "bookcase": "bookcase",
    "filledBookcase": "bookcase",
    "glassDoorCabinet": "display_cabinet",
    "shelves": "wall_shelf",
    "sofa": "sofa",
    "sofa2": "sofa",
    "cornerSofa": "corner_sofa",
    "armchair": "armchair",
    "armchair2": "armchair",
    "chair": "dining_chair",
    "chair2": "dining_chair",
    "stool": "stool",
    "squareTable": "table",
    "table": "table",
    "roundTable": "round_table",
    "coffeeTable": "coffee_table",
    "desk": "desk",
    "tvUnit": "tv_stand",
    "flatTV": "tv",
    "laptop": "laptop",
    "piano": "piano",
    "aquarium": "box",
    "fireplace": "fireplace",
    "toiletUnit": "toilet",
    "washbasin": "basin",
    "washbasinWithCabinet": "basin",
    "bath": "bathtub",
    "fittedBath": "bathtub",
    "shower": "shower",
    "clothesWasher": "washing_machine",
    "cooker": "hob_cabinet",
    "dishwasher": "dishwasher",
    "fridge": "fridge",
    "fridgeFreezer": "fridge",
    "kitchenCabinet": "base_cabinet",
    "kitchenUpperCabinet": "wall_cabinet",
    "sink": "sink_cabinet",
    "hood": "hood",
    "oven": "oven_cabinet",
    "plant": "plant",
    "flowers": "vase",
    "frame": "picture",
    "curtains": "curtain",
    "blind": "curtain",
    "mirror": "mirror",
    "electricRadiator": "radiator",
    "hotWaterRadiator": "radiator",
    "staircase": "staircase",
    "curveStaircase": "staircase",
    "spiralStaircase": "staircase",
    "floorUplight": "floor_lamp",
    "lamp": "lamp",
    "workLamp": "desk_lamp",
    "pendantLamp": "pendant_lamp",
    "spotlight": "ceiling_lamp",
    "wallUplight": "ceiling_lamp",
    "texturableBox": "",
    "texturableCylinder": "",
    "texturableTriangle": "",
}

SEVERAL: dict[str, tuple[str, ...]] = {
    "bed": ("double_bed", "single_bed"),
    "table": ("dining_table", "coffee_table", "side_table"),
    "sofa": ("sofa", "loveseat", "corner_sofa"),
    "lamp": ("table_lamp", "floor_lamp"),
}
"""Catalog words that are several kinds, apart by size."""


def kind_of(piece: HomePiece) -> str:
    """The category of a piece, ``obstacle`` if neither its catalog id nor its name says.

    Beds, tables, sofas and lamps are told apart by size.
    """
    kind = CATALOG.get(piece.catalog, "")
    kinds = (SEVERAL.get(kind) or (kind,)) if kind else _by_name(piece.name)
    if len(kinds) < 2:
        return kinds[0] if kinds else "obstacle"
    return nearest(kinds, Size(*piece.upright))[0]


def _by_name(name: str) -> tuple[str, ...]:
    found = match(name)
    kinds = found.kinds if found else ()
    return tuple(one for kind in kinds for one in meanings(kind))
