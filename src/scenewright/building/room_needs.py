"""What a room of each function needs: the size from which on it is of use, and the essentials.

Both are our own tables, after the rooms people actually live in.
"""

from __future__ import annotations

from typing import NamedTuple


class Usable(NamedTuple):
    """The least floor area in square metres and inscribed width in metres for a function."""

    area: float
    width: float


USABLE: dict[str, Usable] = {
    "living": Usable(7.0, 2.0),
    "dining": Usable(4.0, 1.8),
    "kitchen": Usable(3.0, 1.4),
    "bedroom": Usable(4.0, 1.6),
    "double_bedroom": Usable(7.0, 2.2),
    "single_bedroom": Usable(4.0, 1.6),
    "child_bedroom": Usable(4.0, 1.6),
    "study": Usable(3.0, 1.4),
    "bathroom": Usable(1.5, 1.0),
    "toilet": Usable(0.7, 0.7),
    "washroom": Usable(1.2, 0.8),
    "storage": Usable(0.5, 0.5),
    "hall": Usable(2.5, 1.1),
}
"""From which size on a room is expected to hold its essentials; smaller ones are never noted."""


class Essential(NamedTuple):
    """One thing a function needs, by the name that kinds serve as it (their ``essential``), and how
    many of them."""

    name: str
    least: int = 1


_BED, _CLOTHES, _BASIN = Essential("bed"), Essential("wardrobe"), Essential("basin")

ESSENTIALS: dict[str, tuple[Essential, ...]] = {
    "living": (Essential("seat"), Essential("table"), Essential("screen or focal point")),
    "dining": (Essential("dining table"), Essential("two chairs", 2)),
    "kitchen": (
        Essential("sink"),
        Essential("hob"),
        Essential("fridge"),
        Essential("base units", 2),
    ),
    "bedroom": (_BED, _CLOTHES),
    "double_bedroom": (Essential("double bed"), Essential("nightstand"), _CLOTHES),
    "single_bedroom": (_BED, _CLOTHES),
    "child_bedroom": (_BED, _CLOTHES),
    "study": (Essential("desk"), Essential("chair")),
    "bathroom": (_BASIN, Essential("bath, shower or toilet")),
    "toilet": (Essential("toilet"),),
    "washroom": (Essential("basin or washing machine"),),
    "storage": (Essential("storage"),),
    "hall": (Essential("somewhere for coats or shoes"),),
}
"""What each function needs; a room of several functions needs all of theirs."""
