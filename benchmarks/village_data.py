"""Real blocks of villages and hamlets, split by place.

Cleaning and rebuilt outlines are those of ``scenewright learn village``
(:mod:`scenewright.domains.village.learning.real_blocks`), alike for training and test. Fixed before
anything was tuned: :data:`SPLITS`.
"""

from __future__ import annotations

from functools import lru_cache

from benchmarks.real_data import data_set
from scenewright.domains.village.learning.real_blocks import read_blocks
from scenewright.domains.village.learning.tables import RealBlock

KINDS = ("village", "hamlet")

SPLITS: dict[str, tuple[str, ...]] = {
    "A": ("Triesen", "Cap-d'Ail", "Altenplos", "Ramsenthal", "Ruh", "Steg", "Muckenreuth"),
    "B": ("Triesenberg", "La Turbie", "Ruggell", "Harsdorf", "Stöckig", "Malbun", "Pferch"),
    "C": ("Schaan", "Vaduz", "Nendeln", "Èze", "Rotenboden", "Altdrossenfeld", "Hettersreuth"),
}
"""The places held out by each split; all others are for training."""


@lru_cache(maxsize=1)
def real_blocks() -> tuple[RealBlock, ...]:
    """All blocks of villages and hamlets that are left after cleaning."""
    return read_blocks(data_set("village_blocks_osm") / "blocks.json", KINDS)


def split(name: str) -> tuple[list[RealBlock], list[RealBlock]]:
    """Blocks to learn from and blocks held out."""
    held = SPLITS[name]
    blocks = real_blocks()
    return [b for b in blocks if b.place not in held], [b for b in blocks if b.place in held]
