"""What already stands in a room: fixed items of a brief as pieces and back, in every domain."""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.brief import FixedItem, Room
from scenewright.catalog import Catalog
from scenewright.scene import STAIRS, Piece, Pose, Size
from scenewright.space import Radiator, Space

RADIATOR = "radiator"
RADIATED = 0.2
"""Depth of the floor before a radiator that is left free, in metres: advice on heating asks for 0.1
to 0.3 m, so that warm air rises and is not shut in."""


def fixed_pieces(room: Room, space: Space, catalog: Catalog) -> list[Piece]:
    """What already stands in a room, as pieces; a locked group stays one."""
    found = [_radiator(radiator, space, catalog) for radiator in space.radiators]
    known = {item.id for item in room.fixed if item.id}
    for number, item in enumerate(room.fixed, 1):
        category = item.category if item.category in catalog.kinds else "obstacle"
        size = Size(*item.size)
        asset = item.asset if item.asset in catalog.assets else None
        chosen = catalog.choose(category, size)
        found.append(
            Piece(
                id=item.id or f"{space.id}/fixed/{category}_{number}", category=category,
                asset=asset or (chosen.id if chosen else ""), space=space.id,
                pose=Pose(*item.at, item.z, item.heading), size=size,
                group=item.group or f"{space.id}/fixed", function=item.function or "fixed",
                on=item.on if item.on in known else None, fixed=True,
            )
        )  # fmt: skip
    return [*found, *stair_pieces(space)]


def stair_pieces(space: Space) -> Iterator[Piece]:
    """What stairs take of a space, as pieces that nobody moves; stairs are drawn with the
    building."""
    for part in space.stair_parts:
        x, y, heading, width, depth = part.box
        yield Piece(
            id=part.id, category=part.category, asset="", space=space.id,
            pose=Pose(x, y, 0.0, heading), size=Size(width, depth, part.height),
            group=f"{space.id}/fixed", function=STAIRS, fixed=True,
        )  # fmt: skip


def _radiator(radiator: Radiator, space: Space, catalog: Catalog) -> Piece:
    size = Size(radiator.width, radiator.depth, radiator.height)
    asset = catalog.choose(RADIATOR, size)
    pose = Pose(radiator.x, radiator.y, radiator.z, radiator.heading)
    return Piece(
        radiator.id, RADIATOR, asset.id if asset else "", space.id, pose, size,
        f"{space.id}/fixed", RADIATOR, fixed=True,
    )  # fmt: skip


def is_radiator(piece: Piece) -> bool:
    """Whether a piece is one of the radiators its room lists."""
    return piece.fixed and piece.function == RADIATOR


def is_item(item: FixedItem, piece: Piece) -> bool:
    """Whether a piece is a brief's fixed item, by id or (where it has none) by place."""
    if item.id:
        return item.id == piece.id
    apart = max(abs(item.at[0] - piece.pose.x), abs(item.at[1] - piece.pose.y))
    return item.category == piece.category and apart < 1e-3


def item_of(piece: Piece, name: str = "") -> FixedItem:
    """A piece as the fixed item of a brief."""
    x, y, z, heading = piece.pose
    return FixedItem(
        id=piece.id,
        category=piece.category,
        asset=piece.asset or None,
        at=(x, y),
        z=max(z, 0.0),
        heading=heading,
        size=(piece.size.width, piece.size.depth, piece.size.height),
        name=name,
        on=piece.on,
        group=piece.group,
        function=piece.function,
    )
