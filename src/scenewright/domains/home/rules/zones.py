"""Zones of a home and the borders between them: what one does there, and what keeps apart.

A zone is a class of pieces, a border a pair of zones with the metres between them: each makes a
row. Where a border is a matter of how a room is laid out it is weighed while that is composed as
well, not only once all stands.
"""

from __future__ import annotations

from typing import NamedTuple

from scenewright.arranging.rows import (
    BACK,
    METRES,
    WHOLE,
    Class,
    Example,
    Place,
    Row,
    apart,
    clear,
    near,
    off,
)
from scenewright.catalog.classes import BEDS, DESKS, EATING_TABLES, RUN, SOFAS, TABLE_SEATS
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.rules.classes import AT_ENTRANCES, AT_PIPES, BY_GLASS, stand
from scenewright.domains.home.rules.every import DAYLIT, ROOMY, SEEN
from scenewright.domains.home.rules.sources import DAYLIGHT, DIN_4109, FLATS, NEUFERT

ZONES = {
    "cook": stand("a unit of the kitchen", *RUN),
    "chill": stand("a fridge", "fridge"),
    "eat": stand("a table", *EATING_TABLES),
    "dine": stand("where one eats", *EATING_TABLES, *TABLE_SEATS),
    "sit": stand("a sofa or armchair", *SOFAS, "armchair"),
    "lounge": stand("a sofa", *SOFAS),
    "watch": Class(
        "a screen", frozenset(("tv_stand",)), below=ON_FLOOR, hung=frozenset(("wall_shelf",))
    ),
    "sleep": stand("a bed", *BEDS),
    "work": stand("a desk", *DESKS),
    "dress": stand("a wardrobe or nightstand", "wardrobe", "nightstand"),
    "hang": stand("a coat rack", "coat_rack"),
    "arrive": stand("shoes or coats", "shoe_cabinet", "coat_rack"),
}
"""What one does, and the pieces that stand for it."""


class Border(NamedTuple):
    """Metres that the pieces of one zone keep off those of another, what it costs if they do not;
    ``laid`` out so from the first."""

    zone: str
    other: str
    metres: float
    cost: float
    laid: bool = False


APART = 0.3  # what keeps nearer is beside it, metres
HUM = 0.5  # a fridge nearer to a bed is heard in it, metres
BORDERS = (
    Border("sleep", "cook", APART, 10.0, True),
    Border("sleep", "chill", HUM, 8.0, True),
    Border("sit", "cook", APART, 16.0, True),
    Border("watch", "cook", APART, 8.0, True),
    Border("work", "cook", APART, 8.0, True),
    Border("dress", "cook", APART, 12.0, True),
    Border("arrive", "cook", APART, 6.0),
    Border("eat", "cook", APART, 4.0),
    Border("eat", "sleep", APART, 5.0),
    Border("hang", "dine", APART, 5.0),
    Border("lounge", "sleep", APART, 5.0),
)
"""All borders."""
AT_ENTRANCE = 1.0  # a bed nearer to the front door is beside it, metres
QUIET = 2.5  # a bed farther from the front door hears nobody come in, metres
NEAR_PIPES = 0.3  # a head nearer to a wall with pipes hears them, metres


def _make_row(border: Border) -> Row:
    return Row(
        f"{border.zone}_at_{border.other}", ZONES[border.zone], apart(), ZONES[border.other],
        border.metres, border.cost, "{of} is within {metres} m of {to}", FLATS, late=True,
        early=border.laid,
    )  # fmt: skip


ZONED = (
    *map(_make_row, BORDERS),
    Row(
        "bed_unquiet", ZONES["sleep"], off(SEEN / QUIET, METRES, WHOLE, each=True), AT_ENTRANCES,
        QUIET, 2.0, "{of} is within {metres} m of {to}", NEUFERT, area=ROOMY, late=True,
        example=Example(
            broken=(Place("single_bed", 1.3, 1.05, 90.0, 0.9, 2.0),),
            held=(),
            mended=(Place("single_bed", 1.1, 3.5, 0.0, 0.9, 2.0),),
        ),
    ),
    Row(
        "head_at_pipes", ZONES["sleep"], clear(BACK, 0.05, each=True), AT_PIPES, NEAR_PIPES, 2.0,
        "the head of {of} is at {to}", DIN_4109, late=True,
    ),
    Row(
        "dim_seat", ZONES["sit"], near(2 * DAYLIT), BY_GLASS, DAYLIT, 2.0,
        "{of} is more than {metres} m from {to}", DAYLIGHT, late=True,
    ),
    Row(
        "dim_meal", ZONES["eat"], near(2 * DAYLIT), BY_GLASS, DAYLIT, 1.5,
        "{of} is more than {metres} m from {to}", DAYLIGHT, late=True,
    ),
    Row(
        "bed_at_entrance", ZONES["sleep"], off(SEEN / AT_ENTRANCE, METRES, each=True), AT_ENTRANCES,
        AT_ENTRANCE, 12.0, "{of} is within {metres} m of {to}", NEUFERT, area=ROOMY,
        example=Example(
            broken=(Place("single_bed", 1.3, 1.05, 90.0, 0.9, 2.0),),
            held=(Place("single_bed", 0.5, 2.9, 90.0, 0.9, 2.0),),
            mended=(Place("single_bed", 4.5, 2.9, 90.0, 0.9, 2.0),),
        ),
    ),
)  # fmt: skip
"""The rows."""
