"""Chairs at desks: of the staff behind them, of who reads at them, of customers before them.

They are set once everything stands and move nothing; one that would stand in a way is left out.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import NamedTuple

from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.seats.chairs import CHAIRS, keep_free


class DeskChair(NamedTuple):
    """A chair at desks of a ``category``: its kind, at their front or behind them, how far off
    their middle as a share of their width, and how far it is pushed in, in metres. It stands at
    desks from ``least`` to ``most`` metres wide, ``called`` by one of some words (none: all)."""

    category: str
    chair: str
    front: bool
    aside: float = 0.0
    tuck: float = 0.2
    least: float = 0.0
    most: float = math.inf
    called: tuple[str, ...] = ()


SCREENS, FOR_TWO = 0.225, 1.6
"""Where the screens of a desk of the staff stand, off its middle as a share of its width, and from
how many metres on two have room behind it."""
ADVISING = (
    *("advi", "consult", "sale", "travel", "vente", "conseil", "voyage", "beratung", "verkauf"),
    *("reise", "venta", "asesor", "viaje", "销售", "咨询", "販売", "相談"),
)
"""Parts of the names of desks before which visitors sit down."""
CUSTOMERS = 1.2
"""From how many metres on two visitors sit before a desk."""

DESK_CHAIRS = (
    DeskChair("info_desk", "office_chair", front=False, most=FOR_TWO),
    DeskChair("info_desk", "office_chair", front=False, aside=-SCREENS, least=FOR_TWO),
    DeskChair("info_desk", "office_chair", front=False, aside=SCREENS, least=FOR_TWO),
    DeskChair("carrel", "reading_chair", front=True),
    DeskChair("desk", "office_chair", front=True),
    DeskChair("corner_desk", "office_chair", front=True),
    DeskChair("desk", "dining_chair", front=False, tuck=0.05, most=CUSTOMERS, called=ADVISING),
    DeskChair("desk", "dining_chair", False, -0.24, 0.05, least=CUSTOMERS, called=ADVISING),
    DeskChair("desk", "dining_chair", False, 0.24, 0.05, least=CUSTOMERS, called=ADVISING),
)
"""Which chairs stand at which desks. Who advises sits at the front of the desk, where its drawers
open, customers at the other side."""


def desk_chairs(
    desks: tuple[Piece, ...],
    names: dict[str, str],
    served: Collection[str],
    solid: tuple[Piece, ...],
    catalog: Catalog,
) -> tuple[Piece, ...]:
    """The chairs of all desks among ``desks`` that stand in nothing ``solid``. ``names`` are what
    their demands are called; those ``served`` have chairs of their own at their fronts, and kinds
    of chairs that stand by themselves come with no desk."""
    asked = {piece.category for piece in desks}
    found = [
        (desk, _chair_at(desk, row, number, catalog))
        for desk in desks
        for number, row in enumerate(_rows_of(desk, names[desk.function]), 1)
        if row.chair not in asked and not (row.front and desk.function in served)
    ]
    return keep_free(found, solid) if found else ()


def _rows_of(desk: Piece, name: str) -> list[DeskChair]:
    """The chairs at a desk of a demand of some name."""
    name = name.casefold()
    return [
        row
        for row in DESK_CHAIRS
        if row.category == desk.category
        and row.least <= desk.size.width < row.most
        and (not row.called or any(word in name for word in row.called))
    ]


def _chair_at(desk: Piece, row: DeskChair, number: int, catalog: Catalog) -> Piece:
    """One chair at a desk, looking at it."""
    asset = catalog.of(row.chair)[0]
    size = Size(*asset.usual)
    return Piece(
        id=f"{desk.id}/{row.chair}_{number}",
        category=row.chair,
        asset=asset.id,
        space=desk.space,
        pose=_pose_at(desk, row, size.depth),
        size=size,
        group=desk.group,
        function=f"{desk.function}{CHAIRS}",
        footprint=footprint_of(asset, size),
    )


def _pose_at(desk: Piece, row: DeskChair, deep: float) -> Pose:
    """Where a chair ``deep`` metres deep stands at a desk."""
    way = 1.0 if row.front else -1.0
    x, y, _, heading = desk.pose
    ahead = way * (0.5 * (desk.size.depth + deep) - row.tuck)
    right = row.aside * desk.size.width
    c, s = math.cos(heading), math.sin(heading)
    turned = heading + (math.pi if row.front else 0.0)
    turned = (turned + math.pi) % (2.0 * math.pi) - math.pi
    return Pose(x + right * s + ahead * c, y - right * c + ahead * s, 0.0, turned)
