"""What a room holds if nobody says: by its functions and its area.

Ranks: 0 essential (without it the room fails its function), 1 usual, 2 welcome. Areas are square
metres of free floor.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import inf
from typing import NamedTuple

from scenewright.space import Space


class Draw(NamedTuple):
    """What draws a group, or keeps it away: a ``window``, ``door`` or ``wall``, or groups and
    kinds, from ``near`` to ``far`` metres off; ``facing`` 1 to look at it."""

    to: tuple[str, ...]
    near: float = 0.0
    far: float = inf
    facing: float = 0.0


class Sway(NamedTuple):
    """Where a group is wished: how much by a window, in a corner, and what else draws it."""

    daylight: float = 0.0
    corner: float = 0.0
    draws: tuple[Draw, ...] = ()


class Wish(NamedTuple):
    """One group wished for: its function and rank; ``required`` if the user asked for it, then
    ``most`` may bound its width and depth; ``small`` if any of its cases will do, not only those
    that become the room; ``core`` if it is what makes the function (the bed of a bedroom);
    ``sway`` where the household would like it."""

    group: str
    rank: int
    required: bool = False
    most: tuple[float, float] | None = None
    small: bool = False
    core: bool = False
    sway: Sway = Sway()


class Row(NamedTuple):
    """Wish for ``group`` in rooms of at least ``least`` m² (and less than ``below``), unless one
    of ``unless`` is among the room's functions or, with a ``home:`` prefix, the home's."""

    group: str
    rank: int
    least: float = 0.0
    below: float = 1e9
    unless: tuple[str, ...] = ()


PROGRAMME: dict[str, tuple[Row, ...]] = {
    "living": (
        Row("seating", 0), Row("media", 0),
        Row("dining", 1, 22, unless=("dining", "home:dining")),
        Row("shelf", 1, 16), Row("sideboard", 2, 24), Row("reading", 2, 26), Row("plant", 2, 12),
    ),
    "dining": (Row("dining", 0), Row("sideboard", 1, 9, unless=("living",)), Row("plant", 2, 9)),
    "kitchen": (
        Row("kitchen", 0), Row("counter", 1, 9, unless=("living",)),
        Row("dining_wall", 1, 8, unless=("dining", "living", "home:dining")),
        Row("island", 2, 34),
    ),
    "double_bedroom": (
        Row("sleeping", 0), Row("wardrobe", 0), Row("chest", 1, 11.5), Row("vanity", 2, 15),
        Row("plant", 2, 12), Row("reading", 2, 18),
    ),
    "single_bedroom": (
        Row("single", 0), Row("wardrobe", 0), Row("desk", 1, 6.5), Row("shelf", 2, 9),
        Row("chest", 2, 11),
    ),
    "child_bedroom": (
        Row("single", 0, below=14), Row("bunk", 0, 14), Row("wardrobe", 0),
        Row("kids_desk", 1, 7), Row("play", 1, 8), Row("shelf", 2, 12),
    ),
    "study": (
        Row("desk", 0), Row("shelf", 0), Row("reading", 1, 8), Row("shelf", 2, 10),
        Row("plant", 2, 9),
    ),
    "bathroom": (
        Row("bath", 0, 3.4), Row("shower", 0, below=3.4), Row("basin", 0),
        Row("toilet", 0, 2.6, unless=("home:toilet",)), Row("toilet", 1, 4.5),
        Row("shower", 2, 7), Row("washer", 1, 4.8, unless=("home:washroom",)),
        Row("linen", 2, 5), Row("basket", 2, 4.5),
    ),
    "toilet": (Row("toilet", 0), Row("basin", 1, 1.3)),
    "washroom": (
        Row("basin", 0), Row("washer", 0), Row("linen", 1, 3), Row("basket", 2, 3),
    ),
    "hall": (
        Row("shoes", 1, 1.5), Row("coats", 2, 4), Row("console", 2, 9),
        Row("plant", 2, 12),
    ),
    "storage": (Row("storage", 0), Row("storage", 1, 2.2), Row("storage", 2, 7.5)),
    "balcony": (
        Row("terrace", 1, 3.5), Row("lounger", 1, 1.6, 3.5), Row("planter", 1, 3),
        Row("drying", 2, 6),
    ),
    "other": (),
}  # fmt: skip

FALLBACK: dict[str, str] = {
    "sleeping": "single",
    "kitchen": "kitchenette",
    "dining": "dining_wall",
    "bath": "shower",
    "terrace": "lounger",
}
ALSO: dict[str, str] = {"kitchenette": "fridge"}
_BED = ("double_bed", "single_bed", "bunk_bed", "cot")
_TABLE = ("dining_table", "round_table")
_COATS = ("shoe_cabinet", "coat_rack", "console_table")
STANDS_FOR: dict[str, tuple[str, ...]] = {
    "sleeping": _BED, "single": _BED, "bunk": _BED,
    "wardrobe": ("wardrobe",), "desk": ("desk", "kids_desk"), "kids_desk": ("desk", "kids_desk"),
    "seating": ("sofa", "loveseat", "corner_sofa"), "media": ("tv", "tv_stand", "fireplace"),
    "dining": _TABLE, "dining_wall": _TABLE,
    "kitchen": ("hob_cabinet", "sink_cabinet"), "kitchenette": ("hob_cabinet", "sink_cabinet"),
    "fridge": ("fridge",), "toilet": ("toilet",),
    "bath": ("bathtub", "shower"), "shower": ("bathtub", "shower"),
    "basin": ("basin", "pedestal_basin", "vanity"), "washer": ("washing_machine",),
    "shoes": _COATS, "coats": _COATS, "terrace": ("outdoor_table",),
}  # fmt: skip
"""Fixed pieces of these categories make a group unnecessary."""

WELCOME = 2  # the rank of what is welcome
BEDS = ("sleeping", "single", "bunk")
PRIVATE = Sway(draws=(Draw(("door",), near=3.0),))
ROOMY = 40.0
"""A bed in a room of so many square metres that is also lived or cooked in is away from doors."""

DOUBLE_BEDROOM = 8.8
SHARED = 0.15  # by how much the k-th further function of an open plan, times k, shrinks it
CORE: dict[str, int] = {"bathroom": 5, "child_bedroom": 2, "washroom": 2}  # leading rows; else 1


def resolved(functions: Iterable[str], area: float) -> tuple[str, ...]:
    """Room functions with a plain ``bedroom`` decided by its size.

    >>> resolved(["bedroom"], 12.0), resolved(["bedroom"], 7.0)
    (('double_bedroom',), ('single_bedroom',))
    """
    bedroom = "double_bedroom" if area >= DOUBLE_BEDROOM else "single_bedroom"
    return tuple(dict.fromkeys(bedroom if f == "bedroom" else f for f in functions))


def part_of(functions: tuple[str, ...], area: float) -> float:
    """The area by which furniture is chosen in an open plan: that of a room of one function.

    >>> part_of(("living",), 20.0), round(part_of(("living", "dining"), 23.0), 1)
    (20.0, 20.0)
    """
    further = max(len(functions), 1) - 1
    return area / (1.0 + SHARED * further * (further + 1) / 2)


def programme(
    space: Space, area: float, home: frozenset[str], have: frozenset[str] = frozenset()
) -> tuple[Wish, ...]:
    """The groups a space of this function and area should hold, the essential first.

    ``home`` are the functions of all other rooms: a living room gets a dining table only where
    there is no dining room. ``have`` are the categories that stand there already.
    """
    functions = resolved(space.functions, area)
    shared = area >= ROOMY and bool({"living", "kitchen"} & set(functions))
    area = part_of(functions, area)
    avoid = set(functions) | {f"home:{f}" for f in home}
    wishes = [
        Wish(
            row.group,
            row.rank,
            core=row.rank == 0 and number < CORE.get(function, 1),
            sway=PRIVATE if row.group in BEDS and shared else Sway(),
        )
        for function in functions
        for number, row in enumerate(PROGRAMME[function])
        if row.least <= area < row.below
        and not avoid & (set(row.unless) - {function})
        and not have.intersection(STANDS_FOR.get(row.group, ()))
    ]
    return tuple(sorted(_once(wishes), key=lambda w: (w.rank, not w.core)))


def _once(wishes: list[Wish]) -> list[Wish]:
    """Without the repeats that two functions of an open plan bring (storage rows may repeat)."""
    kept: list[Wish] = []
    for wish in wishes:
        again = [w for w in kept if w.group == wish.group]
        if not again or (wish.group in ("storage", "shelf") and again[-1].rank != wish.rank):
            kept.append(wish)
    return kept
