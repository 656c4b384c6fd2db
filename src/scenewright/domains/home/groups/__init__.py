"""The table of furniture groups: how each is used, and the cases it can take.

A row says how a patch of that function behaves in a room; its cases are concrete groups with real
furniture sizes. Adding a group is one generator of cases and one row here; a piece that stands
alone needs neither, only a kind that is ``alone`` (:mod:`.alone`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

from scenewright.core.catalog import Group
from scenewright.core.errors import InputError
from scenewright.core.kind import Kind
from scenewright.domains.home.groups import bath, dining, entry, kitchen, living, outdoor, sleeping
from scenewright.domains.home.groups.alone import access_of, cases_of, clearance_of, own_groups

Sides = tuple[float, float, float, float]
NONE: Sides = (0, 0, 0, 0)
FRONT: Sides = (1, 0, 0, 0)
FLANKS: Sides = (0, 1, 0, 1)
THREE: Sides = (1, 1, 0, 1)
ALL: Sides = (1, 1, 1, 1)


@dataclass(frozen=True, slots=True)
class GroupKind:
    """How a group's patch behaves. Sides are front, left, back, right, in metres or flags.

    ``height`` is what counts in front of windows; ``back`` 1 if it belongs to a wall; ``main``
    its role at the main wall; ``clear`` free depth outside the patch; ``access`` sides, at least
    one must be reachable; ``inset`` walkable depth inside; ``daylight`` and ``nestle``
    wishes; ``roomy`` the room areas (m²) at which the smallest and the largest case are preferred;
    ``essential`` the category that makes the group what it is; ``shades`` how much it minds a
    window behind it; ``symmetry`` how much its axis belongs to the middle of the floor beside it;
    ``lean`` the category whose end belongs to the nearer side wall when the case
    is not symmetric; ``label`` what people call the group, empty where that is its name in plain
    words.
    """

    cases: Callable[[], Iterator[Group]]
    height: float
    essential: tuple[str, ...]
    back: float = 1.0
    main: float = 0.0
    clear: Sides = (0.6, 0, 0, 0)
    access: Sides = FRONT
    inset: Sides = NONE
    daylight: float = 0.0
    nestle: float = 0.0
    roomy: tuple[float, float] = (8.0, 30.0)
    lean: str = ""
    label: str = ""
    shades: float = 0.0
    symmetry: float = 0.0


_GROUPS: dict[str, GroupKind] = {
    "media": GroupKind(
        living.media,
        1.2,
        ("tv_stand", "wall_shelf"),
        main=-1,
        clear=(0.9, 0, 0, 0),
        access=NONE,
        roomy=(8, 34),
        label="TV stand",
        shades=1,
    ),
    "seating": GroupKind(
        living.seating,
        0.85,
        ("sofa", "loveseat", "corner_sofa"),
        back=0.4,
        main=1,
        access=THREE,
        inset=(0, 0, 0, 0),
        roomy=(7, 20),
        label="seating group",
        shades=1,
    ),
    "reading": GroupKind(
        living.reading,
        1.55,
        ("armchair",),
        nestle=1,
        clear=(0.4, 0, 0, 0),
        daylight=0.5,
        back=0.5,
        roomy=(8, 22),
        lean="floor_lamp",
        label="reading chair",
        shades=0.5,
    ),
    "shelf": GroupKind(
        living.shelf, 2.0, ("bookcase",), nestle=1, roomy=(8, 40), label="bookcase", shades=1
    ),
    "sideboard": GroupKind(living.sideboard, 0.8, ("sideboard",), roomy=(12, 36), shades=1),
    "plant": GroupKind(
        living.plant,
        1.5,
        ("potted_tree",),
        back=0.5,
        nestle=1,
        clear=NONE,
        access=NONE,
        daylight=0.3,
        roomy=(8, 30),
    ),
    "sleeping": GroupKind(
        sleeping.sleeping,
        0.9,
        ("double_bed",),
        main=-1,
        access=THREE,
        inset=(0, 0.45, 0, 0.45),
        roomy=(4, 13),
        label="double bed",
        shades=1,
        symmetry=1,
    ),
    "single": GroupKind(
        sleeping.single,
        0.9,
        ("single_bed",),
        access=THREE,
        nestle=1,
        clear=(0.3, 0, 0, 0),
        inset=NONE,
        roomy=(5, 14),
        lean="single_bed",
        label="single bed",
        shades=1,
    ),
    "bunk": GroupKind(
        sleeping.bunk,
        1.65,
        ("bunk_bed",),
        access=THREE,
        nestle=1,
        clear=(0.3, 0, 0, 0),
        label="bunk bed",
        shades=1,
    ),
    "wardrobe": GroupKind(
        sleeping.wardrobe,
        2.2,
        ("wardrobe",),
        nestle=1,
        clear=(0.75, 0, 0, 0),
        roomy=(4, 14),
        shades=1,
    ),
    "chest": GroupKind(
        sleeping.chest,
        0.85,
        ("chest_of_drawers",),
        clear=(0.7, 0, 0, 0),
        roomy=(9, 18),
        label="chest of drawers",
        shades=1,
    ),
    "vanity": GroupKind(
        sleeping.vanity,
        0.95,
        ("vanity",),
        clear=(0.3, 0, 0, 0),
        daylight=0.5,
        inset=(0.45, 0, 0, 0),
        label="dressing table",
    ),
    "play": GroupKind(
        sleeping.play,
        1.0,
        ("shelf_unit",),
        nestle=0.5,
        roomy=(8, 16),
        label="shelf for toys",
        shades=0.5,
    ),
    "dining": GroupKind(
        dining.dining,
        0.8,
        ("dining_table", "round_table"),
        back=0.0,
        clear=(0.4, 0.25, 0.4, 0.25),
        access=ALL,
        inset=(0.5, 0.1, 0.5, 0.1),
        daylight=0.4,
        roomy=(8, 34),
        label="dining table",
    ),
    "dining_wall": GroupKind(
        dining.dining_wall,
        0.8,
        ("dining_table",),
        access=THREE,
        clear=(0.3, 0.1, 0, 0.1),
        inset=(0.3, 0, 0, 0),
        daylight=0.3,
        roomy=(6, 14),
        label="dining table at a wall",
    ),
    "kitchen": GroupKind(
        kitchen.kitchen,
        0.92,
        ("sink_cabinet",),
        clear=(0.9, 0, 0, 0),
        nestle=1,
        roomy=(1, 11),
        lean="fridge",
        label="kitchen run",
    ),
    "kitchenette": GroupKind(
        kitchen.kitchenette, 0.92, ("sink_cabinet",), clear=(0.8, 0, 0, 0), nestle=1, roomy=(2, 9)
    ),
    "counter": GroupKind(
        kitchen.counter,
        0.92,
        ("drawer_cabinet",),
        clear=(0.9, 0, 0, 0),
        nestle=1,
        roomy=(8, 18),
        label="second kitchen run",
    ),
    "fridge": GroupKind(kitchen.fridge, 1.9, ("fridge",), clear=(0.8, 0, 0, 0), nestle=1),
    "island": GroupKind(
        kitchen.island,
        0.95,
        ("kitchen_island",),
        back=0,
        access=ALL,
        clear=(0.4, 0.7, 0.9, 0.7),
        inset=(0.4, 0, 0, 0),
        roomy=(14, 30),
        label="kitchen island",
    ),
    "toilet": GroupKind(bath.toilet, 0.8, ("toilet",), clear=(0.5, 0, 0, 0), roomy=(1.2, 5)),
    "basin": GroupKind(
        bath.basin, 0.9, ("basin", "pedestal_basin"), clear=(0.55, 0, 0, 0), roomy=(1.2, 9)
    ),
    "bath": GroupKind(
        bath.bath,
        0.6,
        ("bathtub",),
        clear=(0.5, 0, 0, 0),
        nestle=1,
        roomy=(2.5, 8),
        label="bathtub",
    ),
    "shower": GroupKind(
        bath.shower, 2.0, ("shower", "wall_shower"), clear=(0.5, 0, 0, 0), nestle=1, roomy=(2, 7)
    ),
    "washer": GroupKind(
        bath.washer,
        0.86,
        ("washing_machine",),
        clear=(0.6, 0, 0, 0),
        nestle=1,
        roomy=(2, 9),
        label="washing machine",
    ),
    "linen": GroupKind(
        bath.linen,
        1.7,
        ("bathroom_cabinet",),
        clear=(0.5, 0, 0, 0),
        nestle=1,
        label="bathroom cabinet",
    ),
    "basket": GroupKind(
        bath.basket,
        0.55,
        ("laundry_basket",),
        clear=NONE,
        access=NONE,
        nestle=1,
        label="laundry basket",
    ),
    "desk": GroupKind(
        entry.desk,
        0.8,
        ("desk",),
        clear=(0.25, 0, 0, 0),
        daylight=4,
        inset=(0.55, 0, 0, 0),
        nestle=0.3,
        roomy=(6, 16),
    ),
    "corner_desk": GroupKind(
        entry.corner_desk,
        0.8,
        ("corner_desk",),
        clear=(0.25, 0, 0, 0),
        access=(1, 0, 0, 1),
        daylight=4,
        inset=(0.5, 0, 0, 0),
        nestle=1,
        roomy=(6, 16),
        lean="desk_lamp",
        label="corner desk",
    ),
    "kids_desk": GroupKind(
        entry.kids_desk,
        0.8,
        ("kids_desk",),
        clear=(0.25, 0, 0, 0),
        daylight=4,
        inset=(0.55, 0, 0, 0),
        nestle=0.3,
        roomy=(6, 14),
        label="child's desk",
    ),
    "shoes": GroupKind(
        entry.shoes,
        1.0,
        ("shoe_cabinet",),
        clear=(0.5, 0, 0, 0),
        nestle=0.5,
        roomy=(2, 8),
        label="shoe cabinet",
    ),
    "coats": GroupKind(
        entry.coats, 1.75, ("coat_rack",), clear=(0.3, 0, 0, 0), nestle=1, label="coat rack"
    ),
    "console": GroupKind(
        entry.console, 0.8, ("console_table",), roomy=(5, 12), label="console table"
    ),
    "storage": GroupKind(
        entry.storage,
        1.9,
        ("storage_shelf",),
        clear=(0.5, 0, 0, 0),
        nestle=1,
        roomy=(0.2, 3.5),
        label="storage shelf",
    ),
    "terrace": GroupKind(
        outdoor.terrace,
        0.8,
        ("outdoor_table",),
        clear=NONE,
        access=THREE,
        back=0.6,
        roomy=(3, 10),
        label="outdoor table with chairs",
    ),
    "lounger": GroupKind(
        outdoor.lounger,
        0.8,
        ("outdoor_chair",),
        clear=(0.3, 0, 0, 0),
        back=0.6,
        label="outdoor chair",
    ),
    "planter": GroupKind(
        outdoor.planter, 0.6, ("planter",), clear=NONE, access=NONE, nestle=1, roomy=(2, 10)
    ),
    "drying": GroupKind(
        outdoor.drying, 0.95, ("drying_rack",), clear=(0.3, 0, 0, 0), label="drying rack"
    ),
}


def _own_group(name: str, kinds: tuple[Kind, ...]) -> GroupKind:
    """How a group of one piece behaves, by the first of the kinds that make it."""
    first = kinds[0]
    if name in _GROUPS or first.alone is None or not all(kind.sizes for kind in kinds):
        fault = "has no sizes" if name not in _GROUPS else f"makes a second group '{name}'"
        raise InputError(f"the kind '{first.category}' {fault}", "mend its row")
    return GroupKind(
        partial(cases_of, kinds),
        max(kind.sizes[1].height for kind in kinds if kind.sizes),
        tuple(kind.category for kind in kinds),
        back=first.alone.back,
        clear=clearance_of(first),
        access=access_of(first),
        label=first.label,
    )


GROUPS: dict[str, GroupKind] = _GROUPS | {
    name: _own_group(name, kinds) for name, kinds in own_groups().items()
}

LABELS: dict[str, str] = {
    name: kind.label or name.replace("_", " ") for name, kind in GROUPS.items()
}
"""What people call each group."""
