"""A kind of object: everything that is stated of it, in one row.

A :class:`Kind` says how objects of one category are used (which sides a person reaches, what holds
them), what sizes they come in, what they are connected to, how halls lay them out, by which words
they are recognised, what a room needs them for and which module draws them. The shipped rows are
in :mod:`scenewright.catalog.kinds`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

from scenewright.core.scene import Size

Side = Literal["front", "back", "left", "right"]
SIDES: tuple[Side, ...] = ("front", "left", "back", "right")
"""The sides of a piece, counter-clockwise from its front."""
Support = Literal["floor", "wall", "ceiling", "top"]
Place = Literal["wall", "free"]
Sides = tuple[float, float, float, float]
SizeRange = tuple[Size, Size, Size]


class Service(NamedTuple):
    """One kind of outlet a piece needs, how many metres it reaches, and by what."""

    outlet: str
    reach: float
    by: str


class HallUse(NamedTuple):
    """How planners place objects of a kind in a hall: at a wall or free on the floor, the
    ``clearance`` in metres before, to the left of, behind and to the right of each, and the
    patterns in which a group of them is laid out."""

    place: Place
    clearance: Sides
    patterns: tuple[str, ...]


class TableChairs(NamedTuple):
    """Chairs of one category along the front and back of a table, ``pitch`` metres apart, pushed
    in by ``tuck``; ``around`` a round table they stand evenly, looking at its middle."""

    category: str
    pitch: float
    tuck: float
    around: bool = False


class Words(NamedTuple):
    """Phrases that name a kind, by language; with ``also`` they name those kinds as well, and the
    size tells which is meant (a *sofa* below 1.75 m is a loveseat)."""

    phrases: tuple[tuple[str, tuple[str, ...]], ...]
    also: tuple[str, ...] = ()


class OwnGroup(NamedTuple):
    """The furniture group of a piece that stands alone: its ``name``, what part of it belongs
    to a wall (``back``, 0 free on the floor to 1), and the room functions it suits, each with the
    least area in m² from which a room holds one unasked."""

    name: str
    back: float = 1.0
    rooms: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Kind:
    """One row: a category and all that is stated of its objects.

    ``access`` lists the sides, at least one of which must be reachable from the door (none: the
    piece is used together with its group, like a nightstand). ``reach`` is the free depth in
    metres a person needs at that side. ``flat`` things (rugs) may be stood on by others, one
    ``swings`` open for people (the leaf of a gate).
    ``support`` tells what holds it: the floor, a wall (pictures, wall cabinets), the ceiling
    (lamps) or the top of another piece. ``under`` names kinds this one may be pushed under or
    into (a chair under a table). ``airy`` is what air passes under or round: it may stand before
    a radiator. ``back`` tells how a shape shows its front: seats and beds are ``high`` at the back,
    cupboards ``flat`` there.

    ``label`` is what people call it (left out: the category in plain words). ``sizes`` are the
    smallest, usual and largest, in metres; empty where no size is usual. ``services`` is what it is
    connected to, ``hall`` how halls lay it out, ``chairs`` those that come with it. ``words`` are
    the phrases it is recognised by; ``in_rooms`` what such a word means in a room, where that is
    not this kind. ``essential`` names what it serves as where a room cannot do without (a *seat*,
    a *bed*). ``staff`` is the depth in metres of the floor for staff behind it, kept
    free in halls. ``forms`` is the furniture group it makes when groups are
    learned, ``alone`` the group it makes alone. ``lumens`` is the light it gives when lit, of a
    colour temperature of ``kelvin``.

    ``drawn_by`` lists the families (a text of parts, a module with ``ASSETS``) that draw it; a
    leading dot stands for ``scenewright.catalog.assets``.
    """

    category: str
    access: tuple[Side, ...] = ()
    reach: float = 0.5
    flat: bool = False
    swings: bool = False
    support: Support = "floor"
    under: tuple[str, ...] = ()
    airy: bool = False
    back: Literal["", "high", "flat"] = ""
    label: str = ""
    sizes: SizeRange | tuple[()] = ()
    services: tuple[Service, ...] = ()
    hall: HallUse | None = None
    chairs: TableChairs | None = None
    staff: float = 0.0
    words: tuple[Words, ...] = ()
    in_rooms: tuple[tuple[str, tuple[str, ...]], ...] = ()
    essential: tuple[str, ...] = ()
    forms: str = ""
    alone: OwnGroup | None = None
    lumens: float = 0.0
    kelvin: float = 2700.0
    drawn_by: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The name people use for it.

        >>> Kind("office_chair").name, Kind("tv", label="television").name
        ('office chair', 'television')
        """
        return self.label or self.category.replace("_", " ")

    @property
    def reached_from(self) -> tuple[Side, ...]:
        """The sides from which people may come to it: what they sit down on from behind, as at a
        table, stands at a wall too, and then they do so from the front.

        >>> Kind("chair", access=("back", "left", "right")).reached_from
        ('back', 'left', 'right', 'front')
        """
        behind = "back" in self.access and "front" not in self.access
        return (*self.access, "front") if behind else self.access


def size_range(width: str, depth: str, height: str) -> SizeRange:
    """The sizes of a kind from three columns ``"smallest usual largest"`` in centimetres.

    >>> size_range("60 78 100", "60 80 100", "70 85 105")[1]
    Size(width=0.78, depth=0.8, height=0.85)
    """
    columns = [[float(v) / 100 for v in column.split()] for column in (width, depth, height)]
    small, usual, large = (Size(*(column[i] for column in columns)) for i in range(3))
    return small, usual, large


def words(also: str = "", /, **phrases: str) -> Words:
    """Phrases by language, parted by commas; ``also`` names further kinds they may mean.

    >>> words("loveseat", en="sofa, couch", de="Couch").phrases
    (('en', ('sofa', 'couch')), ('de', ('Couch',)))
    """
    parted = {code: tuple(one.strip() for one in text.split(",")) for code, text in phrases.items()}
    return Words(tuple(parted.items()), tuple(also.split()))


def free(patterns: str, front: float, *sides: float) -> HallUse:
    """Free on the floor of a hall, ``front`` metres clear all around or, if left, back and right
    follow, before each object.

    >>> free("chain", 0.7, 0.0, 0.7, 0.0).clearance, free("grid single", 0.6).clearance
    ((0.7, 0.0, 0.7, 0.0), (0.6, 0.6, 0.6, 0.6))
    """
    left, back, right = sides or (front, front, front)
    return HallUse("free", (front, left, back, right), tuple(patterns.split()))


def at_wall(front: float, sides: float = 0.0) -> HallUse:
    """Along the walls of a hall, ``front`` and ``sides`` metres clear before and beside each
    object.

    >>> at_wall(0.75)
    HallUse(place='wall', clearance=(0.75, 0.0, 0.0, 0.0), patterns=('wall',))
    """
    return HallUse("wall", (front, sides, 0.0, sides), ("wall",))
