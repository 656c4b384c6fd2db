"""What already stands in a room: the fixed items of a brief as pieces, in every domain."""

from __future__ import annotations

from scenewright.brief import Room
from scenewright.catalog import Catalog
from scenewright.scene import Piece, Pose, Size
from scenewright.space import Space


def fixed_pieces(room: Room, space: Space, catalog: Catalog) -> list[Piece]:
    """What already stands in a room, as pieces; a locked group stays one."""
    found = []
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
    return found
