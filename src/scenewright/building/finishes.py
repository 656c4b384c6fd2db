"""Finishes of floors, walls and open ground: what a space is covered with by its functions."""

from __future__ import annotations

from shapely import Polygon

from scenewright.core.catalog import Material
from scenewright.core.space import Space

PLASTER = Material("wall plaster", (0.955, 0.945, 0.925), roughness=0.95)
SECTION = Material("wall top", (0.56, 0.55, 0.535), roughness=0.95)
LID = Material("shaft lid", (0.70, 0.69, 0.675), roughness=0.95)
CONCRETE = Material("slab concrete", (0.74, 0.73, 0.71), roughness=0.95)
UNKNOWN = Material("plain", (0.75, 0.74, 0.72), roughness=0.9)
WOOD_FLOOR = Material("oak floor", (0.73, 0.62, 0.50), roughness=0.55)
STONE_FLOOR = Material("stone floor", (0.83, 0.81, 0.77), roughness=0.5)
TILE_FLOOR = Material("tile floor", (0.80, 0.82, 0.82), roughness=0.3)
DECK_FLOOR = Material("deck floor", (0.64, 0.58, 0.51), roughness=0.8)
GRASS = Material("grass", (0.50, 0.58, 0.37), roughness=1.0)
TERRAZZO_FLOOR = Material("terrazzo floor", (0.80, 0.79, 0.76), roughness=0.3)
PLAIN_FLOOR = Material("screed floor", (0.78, 0.77, 0.74), roughness=0.85)

SURFACES: dict[str, Material] = {
    "asphalt": Material("asphalt", (0.36, 0.37, 0.38), roughness=0.95),
    "pavement": Material("pavement", (0.72, 0.71, 0.68), roughness=0.95),
    "kerb": Material("kerb", (0.80, 0.79, 0.77), roughness=0.9),
    "path": Material("gravel path", (0.70, 0.65, 0.56), roughness=1.0),
    "lane": Material("lane", (0.56, 0.55, 0.53), roughness=0.95),
    "walk": Material("garden walk", (0.70, 0.68, 0.63), roughness=0.95),
    "yard": Material("yard", (0.66, 0.62, 0.54), roughness=1.0),
    "bed": Material("vegetable bed", (0.40, 0.40, 0.26), roughness=1.0),
    "square": Material("cobbles", (0.67, 0.64, 0.59), roughness=0.95),
    "parking": Material("parking", (0.47, 0.47, 0.47), roughness=0.95),
    "park": Material("park lawn", (0.52, 0.62, 0.39), roughness=1.0),
    "court": Material("court lawn", (0.57, 0.64, 0.43), roughness=1.0),
    "hedge": Material("hedge", (0.30, 0.42, 0.20), roughness=1.0),
    "white_wall": Material("garden wall, white", (0.93, 0.92, 0.89), roughness=0.95),
    "stone_wall": Material("garden wall, stone", (0.74, 0.69, 0.60), roughness=0.95),
    "fence": Material("garden fence", (0.55, 0.46, 0.36), roughness=0.95),
    "coping": Material("tile coping", (0.27, 0.28, 0.30), roughness=0.9),
    "carpet_grey": Material("carpet, grey", (0.49, 0.50, 0.52), roughness=1.0),
    "carpet_sand": Material("carpet, sand", (0.64, 0.59, 0.53), roughness=1.0),
    "carpet_sage": Material("carpet, sage", (0.50, 0.53, 0.48), roughness=1.0),
    "plinth": Material("plinth", (0.62, 0.60, 0.56), roughness=0.95),
    "water": Material("water", (0.30, 0.42, 0.47), roughness=0.15),
    "around": Material("meadow", (0.47, 0.54, 0.36), roughness=1.0),
    "earth": Material("earth", (0.50, 0.43, 0.35), roughness=1.0),
    "marking": Material("road marking", (0.93, 0.93, 0.91), roughness=0.9),
}
"""Finishes of the ground and of floors of halls, by kind."""

FLOORS: dict[str, Material] = {
    "kitchen": STONE_FLOOR,
    "hall": STONE_FLOOR,
    "bathroom": TILE_FLOOR,
    "toilet": TILE_FLOOR,
    "washroom": TILE_FLOOR,
    "balcony": DECK_FLOOR,
    "storage": PLAIN_FLOOR,
    "supermarket": TERRAZZO_FLOOR,
    "worship": STONE_FLOOR,
    "museum": PLAIN_FLOOR,
    "site": GRASS,
    "village": GRASS,
    "extend": GRASS,
}
"""Floor finish by a room's first function; all others are oak."""
WARM = frozenset(
    ("living", "bedroom", "double_bedroom", "single_bedroom", "child_bedroom", "study")
)
"""Functions for which a room has oak whatever else it is for."""
CUBBY = 6.0
"""Area in m² up to which a room of unknown use has a plain floor."""


def floor_of(space: Space, slept_in: bool = False) -> Material:
    """The floor finish of a space by its functions: oak where one of them is lived or slept in, or
    where a bed stands.

    >>> import numpy as np
    >>> floor_of(Space("a", "", ("kitchen",), "0", np.zeros((3, 2)))).name
    'stone floor'
    >>> floor_of(Space("a", "", ("kitchen", "living"), "0", np.zeros((3, 2)))).name
    'oak floor'
    """
    if slept_in or WARM & set(space.functions):
        return WOOD_FLOOR
    if "other" in space.functions and Polygon(space.outline).area < CUBBY:
        return PLAIN_FLOOR
    return FLOORS.get(space.functions[0] if space.functions else "", WOOD_FLOOR)
