"""Furniture of a Sweet Home 3D level: in which room it stands, and what stays where it stands."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from scenewright.core.brief import FixedItem
from scenewright.core.brief.fields import FURNITURE
from scenewright.core.errors import InputError
from scenewright.formats.sh3d.kinds import LANDMARKS, kind_of
from scenewright.formats.sh3d.xml import HomePiece, outline_of

KITCHEN = (
    "base_cabinet",
    "drawer_cabinet",
    "corner_cabinet",
    "sink_cabinet",
    "hob_cabinet",
    "oven_cabinet",
    "wall_cabinet",
    "tall_cabinet",
    "hood",
    "dishwasher",
    "fridge",
)


def flatten_groups(pieces: Sequence[HomePiece]) -> Iterator[HomePiece]:
    """Visible pieces with groups opened; a group named as stairs or a fireplace stays whole.

    Members of a group that is not movable are not movable either.
    """
    for piece in pieces:
        if not piece.visible:
            continue
        if piece.kind != "furnitureGroup":
            yield piece
        elif kind_of(piece) in LANDMARKS:
            yield piece._replace(movable=False)
        else:
            level = piece.level
            yield from flatten_groups(
                [
                    m._replace(movable=m.movable and piece.movable, level=m.level or level)
                    for m in piece.members
                ]
            )


def assign_to_floors(
    pieces: Sequence[HomePiece], floors: Sequence[shapely.Polygon]
) -> list[list[HomePiece]]:
    """The pieces of each floor: by centre, or for those centred in no room by largest overlap."""
    inside: list[list[HomePiece]] = [[] for _ in floors]
    tree = shapely.STRtree(floors)
    for piece in pieces:
        number = _home_of(piece, floors, tree)
        if number is not None:
            inside[number].append(piece)
    return inside


def stays(piece: HomePiece) -> bool:
    """True for what is built in. Kitchen units are not: a new kitchen is planned as a whole."""
    return not piece.movable and kind_of(piece) not in KITCHEN


def fixed_item(piece: HomePiece) -> FixedItem:
    """A piece as it stands. Its front is opposite the back, which is y in the piece's frame."""
    largest = max(piece.width, piece.depth, piece.height)
    if largest > FURNITURE:
        fault = f"is {largest:.0f} m large, more than furniture's {FURNITURE:.0f} m"
        raise InputError(fault, "correct its size in the home", place=piece.place)
    return FixedItem(
        category=kind_of(piece),
        at=(piece.x, piece.y),
        heading=math.remainder(piece.turn - math.pi / 2, 2 * math.pi),
        size=(piece.width, piece.depth, piece.height),
        z=max(piece.z, 0.0),
        name=piece.name,
    )


def _home_of(
    piece: HomePiece, floors: Sequence[shapely.Polygon], tree: shapely.STRtree
) -> int | None:
    at = tree.query(shapely.Point(piece.x, piece.y), predicate="within")
    if len(at):
        return int(at.min())
    footprint = shapely.Polygon(outline_of(piece))
    near = np.sort(tree.query(footprint))
    shared = [floors[number].intersection(footprint).area for number in near.tolist()]
    best = int(np.argmax(shared)) if shared else -1
    return int(near[best]) if best >= 0 and shared[best] > 0.25 * footprint.area else None
