"""What lies on a layer of a drawing, by its name in many languages and by what is drawn there."""

from __future__ import annotations

import re

from scenewright.text import fold_letters

WALLS = (
    "wall", "wand", "mauer", "mur", "muro", "muri", "muur", "parede", "pared", "tabique", "cloison",
    "vegg", "vagg", "mauerwerk", "stena", "стен", "перегород", "墙", "壁", "벽", "obstacle",
    "column", "pillar", "stutze", "pilar", "poteau", "колонн", "柱", "glass", "crystal", "glas",
    "cristal", "verre", "partition", "room", "raum", "walkable", "area-outline",
)  # fmt: skip
DOORS = (
    "door", "tur", "tueren", "porte", "puerta", "porta", "opening", "deur", "dor", "dorr", "двер",
    "门", "ドア", "扉", "문", "exit", "eingang",
)  # fmt: skip
WINDOWS = ("window", "fenster", "fenetre", "ventana", "finestra", "janela", "glaz", "raam", "окн",
           "窗", "窓", "창")  # fmt: skip
OTHER = (
    "furn", "mobel", "moebel", "mueble", "mobil", "mobili", "meubel", "meuble", "мебель", "家具",
    "dim", "mass", "cota", "quote", "cotation", "размер", "标注", "寸法", "text", "anno", "note",
    "title", "frame", "rahmen", "axis", "achse", "axe", "grid", "ось", "оси", "floor", "tile",
    "belag", "carrelage", "projection", "roof", "dach", "foot", "stem", "found", "slab", "beam",
    "ceiling", "decke", "header", "hatch", "fixture", "case", "journey", "distribution", "param",
    "background", "rail", "stair", "treppe", "escal", "elec", "light", "lamp", "plant", "defpoint",
    "viewport", "temp", "legend", "symbol", "text", "footprint", "garage-door", "rolltrepp",
)  # fmt: skip


def kind_of_layer(name: str) -> str:
    """``wall``, ``door``, ``window``, ``other`` (furniture, dimensions, notes, what lies above or
    below), or nothing where the name does not say.

    >>> [kind_of_layer(n) for n in ("xref$0$A-WALL", "Tueren", "Fenster", "A-DIMS-1", "0", "Стены")]
    ['wall', 'door', 'window', 'other', '', 'wall']
    """
    own = fold_letters(name.split("$")[-1].split("|")[-1])
    tests = (("other", OTHER), ("window", WINDOWS), ("door", DOORS), ("wall", WALLS))
    return next((kind for kind, words in tests if any(_in(own, word) for word in words)), "")


def _in(name: str, word: str) -> bool:
    """Whether a word begins in a name where a word may begin; signs of other scripts anywhere."""
    if not word.isascii():
        return word in name
    return re.search(rf"(?:^|[^a-z]){re.escape(word)}", name) is not None
