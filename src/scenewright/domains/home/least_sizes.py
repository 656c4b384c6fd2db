"""The least useful size of each kind of furniture: what is smaller serves nobody. Said once.

Every generator of cases draws its smallest sizes from here, so that no passage of the search can
buy a place with centimetres that make a piece useless. ``bench unseen`` counts the same things by
numbers of its own, at the threshold and 0.1 m beyond.
"""

from __future__ import annotations

from typing import NamedTuple

from scenewright.domains.home.measures import HAIR


class LeastSize(NamedTuple):
    """Metres across the front and from front to back that a piece has at least, and why."""

    width: float
    depth: float
    source: str


NEUFERT = "Neufert, Architects' Data"
WARDROBE = LeastSize(0.45, 0.55, f"{NEUFERT}: a hanger takes 0.45 m, doors and air 0.1 m")
SHALLOW_WARDROBE = LeastSize(0.5, 0.35, "a rail from front to back, hangers across: 0.5 m a rail")
TABLE = LeastSize(0.8, 0.6, f"{NEUFERT}: two places of 0.6 x 0.4 m round a corner, or opposite")
BED = LeastSize(0.8, 1.9, "mattresses of 80 x 190 cm, the smallest sold for adults (DIN EN 1334)")
DOUBLE_BED = LeastSize(1.4, BED.depth, "mattresses of 140 x 190 cm")
DESK = LeastSize(0.8, 0.5, "a keyboard and a screen behind it, 0.5 m from the eyes (DIN EN 527-1)")
CHEST = LeastSize(0.6, 0.38, f"{NEUFERT}: folded shirts of 0.25 x 0.35 m, two side by side")
SHELF = LeastSize(0.4, 0.19, "a row of paperbacks or of jars; the width of one board")
SINK = LeastSize(0.5, 0.5, "a bowl of 0.4 m, in which an oven tray is turned (DIN EN 1116)")
HOB = LeastSize(0.3, 0.5, "two rings one behind the other (DIN EN 1116)")
HAND_BASIN = LeastSize(0.45, 0.32, "basins to wash hands in (DIN 18022: 0.45 x 0.35 m)")
CABINET = LeastSize(0.3, 0.5, "what is narrower holds no drawer: a strip that fills the run")

LEAST_SIZES: dict[str, LeastSize] = {
    "wardrobe": WARDROBE,
    "dining_table": TABLE,
    "round_table": LeastSize(TABLE.width, TABLE.width, TABLE.source),
    "single_bed": BED,
    "bunk_bed": BED,
    "double_bed": DOUBLE_BED,
    "desk": DESK,
    "kids_desk": DESK,
    "chest_of_drawers": CHEST,
    "bookcase": SHELF,
    "storage_shelf": SHELF,
    "sink_cabinet": SINK,
    "hob_cabinet": HOB,
    "pedestal_basin": HAND_BASIN,
    "basin": HAND_BASIN,
    "drawer_cabinet": CABINET,
    "base_cabinet": CABINET,
}
"""By kind."""
LEAST_MODELS: dict[str, LeastSize] = {"wardrobe_shallow": SHALLOW_WARDROBE}
"""By model, where one of a kind is used in another way."""


def is_useful(category: str, width: float, depth: float, model: str = "") -> bool:
    """Whether a piece is no smaller than its least useful size.

    >>> is_useful("wardrobe", 1.0, 0.4), is_useful("wardrobe", 1.0, 0.4, "wardrobe_shallow")
    (False, True)
    """
    least = LEAST_MODELS.get(model) or LEAST_SIZES.get(category)
    return least is None or (width >= least.width - HAIR and depth >= least.depth - HAIR)
