"""Words of no single kind: those of several, and those of what is no furniture of ours.

The latter keep a name from meaning what only a part of it says: a *piano bench* is no piano.
"""

from __future__ import annotations

from typing import NamedTuple

from scenewright.catalog.kinds.said import said_words
from scenewright.core.kind import Words, words


class Generic(NamedTuple):
    """Words for several kinds, apart by size and by how high they hang, and what they mean in a
    room."""

    kinds: tuple[str, ...]
    words: Words
    in_rooms: tuple[tuple[str, tuple[str, ...]], ...] = ()


GENERIC: dict[str, Generic] = {
    "lamp": Generic(
        ("table_lamp", "floor_lamp", "pendant_lamp", "ceiling_lamp"),
        words(
            en="lamp, light, uplight lamp",
            fr="lampe",
            de="leuchte, lampe",
            es="lampara",
            zh="灯, 燈",
            ja="ランプ, ライト",
        ),
        (("exterior", ("lamp_post",)),),
    ),
    "cabinet": Generic(
        (
            "wardrobe",
            "chest_of_drawers",
            "sideboard",
            "display_cabinet",
            "wall_cabinet",
            "bookcase",
        ),
        words(
            en="cabinet, cupboard",
            fr="placard, meuble",
            de="schrank",
            es="armario bajo, mueble",
            zh="柜, 櫃, 箱子",
            ja="キャビネット",
        ),
        (
            ("kitchen", ("base_cabinet", "wall_cabinet", "tall_cabinet")),
            ("bathroom", ("bathroom_cabinet",)),
            ("office", ("shelf_unit", "bookcase", "chest_of_drawers")),
        ),
    ),
}

NO_KIND: tuple[Words, ...] = said_words()[""]
