"""What a room holds if nobody says: by its functions and its area.

Ranks: 0 essential (without it the room fails its function), 1 usual, 2 welcome. Areas are square
metres of free floor.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from math import inf
from typing import NamedTuple

from scenewright.catalog.classes import EATING_TABLES
from scenewright.catalog.kinds import KINDS
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.groups.alone import own_groups
from scenewright.domains.home.groups.classes import BED_GROUPS


class Attraction(NamedTuple):
    """What draws a group, or keeps it away: a ``window``, ``door`` or ``wall``, the ``outlook``
    across from the doors, or groups and kinds, from ``near`` to ``far`` metres off; ``facing`` 1 to
    look at it, at the ``middle`` of its front or anywhere along it."""

    to: tuple[str, ...]
    near: float = 0.0
    far: float = inf
    facing: float = 0.0
    middle: bool = False


AMPLE, MODEST = 0.8, 0.6
"""Shares of the footprint preferred in a room that what is essential there, and the rest, has."""
AROUND = ("dining",)
"""Groups one walks round, which take more floor than they stand on: no larger than need be."""


class PlacementPreference(NamedTuple):
    """Where a group is wished: how much by a window, in a corner, and what else draws it."""

    daylight: float = 0.0
    corner: float = 0.0
    draws: tuple[Attraction, ...] = ()


class Wish(NamedTuple):
    """One group wished for: its function and rank; ``required`` if the user asked for it, then
    ``most`` may bound its width and depth; ``becoming`` the share of the footprint preferred in
    the room that it has at least, unless it is ``small``: then any of its cases will do; ``core``
    if it is what makes the function (the bed of a bedroom); ``sway`` where the household would
    like it."""

    group: str
    rank: int
    required: bool = False
    most: tuple[float, float] | None = None
    small: bool = False
    becoming: float = MODEST
    core: bool = False
    sway: PlacementPreference = PlacementPreference()


class ProgrammeRow(NamedTuple):
    """Wish for ``group`` in rooms of at least ``least`` m² (and less than ``below``), unless one
    of ``unless`` is among the room's functions or, prefixed ``home:``, those of the home's other
    rooms or, prefixed ``no:``, is among neither; ``alone`` is a home of one room for one use."""

    group: str
    rank: int
    least: float = 0.0
    below: float = 1e9
    unless: tuple[str, ...] = ()


WELCOME = 2  # the rank of what is welcome

_INDOORS = (
    *("living", "dining", "kitchen", "study", "hall", "bathroom", "toilet", "washroom"),
    *("double_bedroom", "single_bedroom", "child_bedroom"),
)
_PROGRAMME: dict[str, tuple[ProgrammeRow, ...]] = {
    "living": (
        ProgrammeRow("seating", 0),
        ProgrammeRow("media", 0),
        ProgrammeRow("dining", 1, 22, unless=("dining", "home:dining")),
        ProgrammeRow("dining_wall", 1, 9, 22, unless=("dining", "home:dining")),
        ProgrammeRow("shelf", 1, 16),
        ProgrammeRow("sideboard", 2, 24),
        ProgrammeRow("reading", 2, 26),
        ProgrammeRow("plant", 2, 12),
    ),
    "dining": (
        ProgrammeRow("dining", 0),
        ProgrammeRow("sideboard", 1, 9, unless=("living",)),
        ProgrammeRow("plant", 2, 9),
    ),
    "kitchen": (
        ProgrammeRow("kitchen", 0),
        ProgrammeRow("counter", 1, 9, unless=("living",)),
        ProgrammeRow("dining_wall", 1, 7, unless=("dining", "living", "home:dining")),
        ProgrammeRow("island", 2, 34),
    ),
    "double_bedroom": (
        ProgrammeRow("sleeping", 0),
        ProgrammeRow("wardrobe", 0),
        ProgrammeRow("chest", 1, 11.5),
        ProgrammeRow("seating", 1, 17, unless=("living", "home:living", "alone")),
        ProgrammeRow("media", 1, 17, unless=("living", "home:living", "alone")),
        ProgrammeRow("vanity", 2, 15),
        ProgrammeRow("plant", 2, 12),
        ProgrammeRow("reading", 2, 18, unless=("no:living",)),
    ),
    "single_bedroom": (
        ProgrammeRow("single", 0),
        ProgrammeRow("wardrobe", 0),
        ProgrammeRow("desk", 1, 6.5),
        ProgrammeRow("shelf", 2, 9),
        ProgrammeRow("chest", 2, 11),
    ),
    "child_bedroom": (
        ProgrammeRow("single", 0, below=14),
        ProgrammeRow("bunk", 0, 14),
        ProgrammeRow("wardrobe", 0),
        ProgrammeRow("kids_desk", 1, 7),
        ProgrammeRow("play", 1, 8),
        ProgrammeRow("shelf", 2, 12),
    ),
    "study": (
        ProgrammeRow("desk", 0),
        ProgrammeRow("shelf", 0),
        ProgrammeRow("reading", 1, 8),
        ProgrammeRow("shelf", 2, 10),
        ProgrammeRow("plant", 2, 9),
    ),
    "bathroom": (
        ProgrammeRow("bath", 0, 3.4),
        ProgrammeRow("shower", 0, below=3.4),
        ProgrammeRow("basin", 0),
        ProgrammeRow("toilet", 0, 1.4, unless=("home:toilet",)),
        ProgrammeRow("toilet", 0, 1.0, 1.4, unless=("home:toilet", "home:bathroom")),
        ProgrammeRow("toilet", 1, 4.5, unless=("living", "dining", "kitchen")),
        ProgrammeRow("shower", 2, 7),
        ProgrammeRow("washer", 1, 4.8, unless=("home:washroom",)),
        ProgrammeRow("linen", 2, 5),
        ProgrammeRow("basket", 2, 4.5),
    ),
    "toilet": (ProgrammeRow("toilet", 0), ProgrammeRow("basin", 1, 1.3)),
    "washroom": (
        ProgrammeRow("basin", 0),
        ProgrammeRow("washer", 0),
        ProgrammeRow("linen", 1, 3),
        ProgrammeRow("basket", 2, 3),
    ),
    "hall": (
        ProgrammeRow("shoes", 1, 1.5),
        ProgrammeRow("coats", 2, 4),
        ProgrammeRow("console", 2, 9),
        ProgrammeRow("plant", 2, 12),
    ),
    "storage": (
        ProgrammeRow("storage", 0),
        ProgrammeRow("storage", 1, 2.2),
        ProgrammeRow("storage", 2, 7.5),
    ),
    "balcony": (
        ProgrammeRow("terrace", 1, 2.8, unless=_INDOORS),
        ProgrammeRow("lounger", 1, 1.6, 2.8, unless=_INDOORS),
        ProgrammeRow("planter", 1, 2, unless=_INDOORS),
        ProgrammeRow("drying", 2, 6),
    ),
    "other": (),
}
_OPEN_PLAN = ("living", "dining", "kitchen")


def _welcome(function: str) -> tuple[ProgrammeRow, ...]:
    """Rows of single pieces that are welcome in rooms of a function, not in an open plan."""
    return tuple(
        ProgrammeRow(kind.alone.name, WELCOME, least, unless=_OPEN_PLAN)
        for kind in KINDS.values()
        if kind.alone
        for room, least in kind.alone.rooms
        if room == function
    )


PROGRAMME: dict[str, tuple[ProgrammeRow, ...]] = {
    function: (*rows, *_welcome(function)) for function, rows in _PROGRAMME.items()
}

FALLBACK: dict[str, str] = {
    "sleeping": "single",
    "kitchen": "kitchenette",
    "dining": "dining_wall",
    "bath": "shower",
    "terrace": "lounger",
}
ALSO: dict[str, str] = {"kitchenette": "fridge"}
LAST: dict[str, str] = {"wardrobe": "chest", "bunk": "single", "shower": "bath"}
"""Fallbacks that are taken only where all else fails: a chest of drawers or a bathtub stands below
a window, a wardrobe or a shower does not."""
INSTEAD_OF: dict[str, tuple[str, ...]] = {"corner_desk": ("desk", "kids_desk")}
"""Usual groups that a group asked for takes the place of."""
_BED = ("double_bed", "single_bed", "bunk_bed", "cot")
_COATS = ("shoe_cabinet", "coat_rack", "console_table")
STANDS_FOR: dict[str, Collection[str]] = {
    "sleeping": _BED,
    "single": _BED,
    "bunk": _BED,
    "wardrobe": ("wardrobe",),
    "desk": ("desk", "kids_desk", "corner_desk"),
    "kids_desk": ("desk", "kids_desk", "corner_desk"),
    "seating": ("sofa", "loveseat", "corner_sofa"),
    "media": ("tv", "tv_stand", "fireplace"),
    "dining": EATING_TABLES,
    "dining_wall": EATING_TABLES,
    "kitchen": ("hob_cabinet", "sink_cabinet", "worktops"),
    "kitchenette": ("hob_cabinet", "sink_cabinet", "worktops"),
    "fridge": ("fridge",),
    "toilet": ("toilet",),
    "bath": ("bathtub", "shower", "wall_shower"),
    "shower": ("bathtub", "shower", "wall_shower"),
    "basin": ("basin", "pedestal_basin", "vanity"),
    "washer": ("washing_machine",),
    "shoes": _COATS,
    "coats": _COATS,
    "terrace": ("outdoor_table",),
} | {name: tuple(kind.category for kind in kinds) for name, kinds in own_groups().items()}
"""Fixed pieces of these kinds (:func:`standing_kinds`) make a group unnecessary."""
BASE_UNITS = frozenset(("base_cabinet", "drawer_cabinet", "corner_cabinet", "oven_cabinet"))
LONG_RUN = 1.8
"""Metres of kitchen units that are a kitchen, though no sink and no hob is named among them."""

NOTED = frozenset(("shoes",))  # usual, and all that a hall is for
GUESTS = {"wardrobe": (1.2, 0.62), "washer": (0.62, 0.64)}
"""Groups that in a kitchen leave their wall to the run, and their greatest width and depth,
metres."""
HEARTH = PlacementPreference(
    draws=(Attraction(("fireplace",), near=0.6, far=2.6, facing=1.0, middle=True),)
)
"""Seats gather before the middle of a fireplace that stands."""
VIEW = PlacementPreference(draws=(Attraction(("outlook",), facing=0.1),))
"""Seats on a balcony look out or along it, not at the house."""
PRIVATE = PlacementPreference(draws=(Attraction(("door",), near=3.0),))
BED_APART_FROM = 40.0
"""Area in m² of a room also lived or cooked in from which its bed keeps away from doors."""

DOUBLE_BEDROOM = 8.8
SHARED = 0.15  # by how much the k-th further function of an open plan, times k, shrinks it
CORE: dict[str, int] = {"bathroom": 6, "child_bedroom": 2, "washroom": 2}  # leading rows; else 1


def standing_kinds(pieces: Iterable[Piece]) -> frozenset[str]:
    """The categories of pieces, and ``worktops`` where units of a room make a run of 1.8 m."""
    kinds, runs = set[str](), defaultdict[str, float](float)
    for piece in pieces:
        kinds.add(piece.category)
        runs[piece.space] += piece.size.width if piece.category in BASE_UNITS else 0.0
    return frozenset(
        kinds | ({"worktops"} if any(run >= LONG_RUN for run in runs.values()) else set())
    )


def standing_groups(pieces: Iterable[Piece]) -> frozenset[str]:
    """The groups that pieces make unnecessary."""
    kinds = standing_kinds(pieces)
    return frozenset(group for group, names in STANDS_FOR.items() if kinds.intersection(names))


def resolve_bedrooms(functions: Iterable[str], area: float) -> tuple[str, ...]:
    """Room functions with a plain ``bedroom`` decided by its size.

    >>> resolve_bedrooms(["bedroom"], 12.0), resolve_bedrooms(["bedroom"], 7.0)
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
    functions = resolve_bedrooms(space.functions, area)
    shared = area >= BED_APART_FROM and bool({"living", "kitchen"} & set(functions))
    area = part_of(functions, area)
    avoid = set(functions) | {f"home:{f}" for f in home}
    if home or len(functions) > 1:
        avoid |= {f"no:{f}" for f in PROGRAMME.keys() - home - set(functions)}
    else:
        avoid.add("alone")
    wishes = [
        Wish(
            row.group,
            row.rank,
            becoming=AMPLE if row.rank == 0 and row.group not in AROUND else MODEST,
            core=row.rank == 0 and number < CORE.get(function, 1),
            sway=_usual_place(row.group, shared),
        )
        for function in functions
        for number, row in enumerate(PROGRAMME[function])
        if row.least <= area < row.below
        and not avoid & (set(row.unless) - {function})
        and not have.intersection(STANDS_FOR.get(row.group, ()))
    ]
    return tuple(sorted(_once(wishes), key=lambda w: (w.rank, not w.core)))


def _usual_place(group: str, shared: bool) -> PlacementPreference:
    """Where a group is wished though nobody says: beds of a ``shared`` room away from its doors,
    seats before a fireplace, chairs of a balcony looking out."""
    if group in BED_GROUPS and shared:
        return PRIVATE
    if group in ("lounger", "terrace"):
        return VIEW
    return HEARTH if group == "seating" else PlacementPreference()


def most_of(functions: Iterable[str], group: str) -> tuple[float, float] | None:
    """The largest width and depth that a group has in a room for these functions unless somebody
    says so; None where it may be as large as any.

    >>> most_of(("kitchen",), "wardrobe"), most_of(("kitchen", "bedroom"), "wardrobe")
    ((1.2, 0.62), None)
    """
    return GUESTS.get(group) if set(functions) == {"kitchen"} else None


def _once(wishes: list[Wish]) -> list[Wish]:
    """Without the repeats that two functions of an open plan bring (storage rows may repeat)."""
    kept: list[Wish] = []
    for wish in wishes:
        again = [w for w in kept if w.group == wish.group]
        if not again or (wish.group in ("storage", "shelf") and again[-1].rank != wish.rank):
            kept.append(wish)
    return kept


def is_essential(wish: Wish) -> bool:
    """Whether a room is incomplete without a wish: it fails its function, or the referee notes it.

    A rack for coats counts where it stands for shoes that are kept in another room.

    >>> [is_essential(wish) for wish in (Wish("shoes", 1), Wish("coats", 1), Wish("coats", 2))]
    [True, True, False]
    """
    return wish.rank == 0 or wish.group in NOTED or (wish.group == "coats" and wish.rank == 1)


def instead_of(wish: Wish, others: Mapping[str, str] = FALLBACK) -> tuple[Wish, ...]:
    """A wish in its smallest form: its fallback, with what that needs beside it.

    >>> [wish.group for wish in instead_of(Wish("kitchen", 0))]
    ['kitchenette', 'fridge']
    >>> [wish.group for wish in instead_of(Wish("kitchenette", 0))]
    ['kitchenette']
    """
    other = others.get(wish.group, wish.group)
    also = [ALSO[other]] if other in ALSO and other != wish.group else []
    return tuple(wish._replace(group=group, small=True) for group in (other, *also))
