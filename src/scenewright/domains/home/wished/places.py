"""Where in a room groups are wanted: at outlets, by doors and walls, far from or facing a window.

What the household wishes and what has to be connected becomes rows of the term ``places``: points
and lines of the room with the least and greatest distance from a group's box.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.door_approach import gates
from scenewright.catalog.kinds import services_of
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.cases.library import Library, cases
from scenewright.domains.home.problem import Items
from scenewright.domains.home.programme import Attraction, Wish

Floats = NDArray[np.float64]

WISHED = 4.0  # weight of a place that is wished for
CONNECTED = 2.0  # weight of an outlet within reach
PARTS = (("wall",), ("window",), ("door",), ("outlook",))
"""What draws a group to a part of its room."""
ACROSS = 0.7  # cosine of the angle by which an edge is turned from one it is across from
FRONT = 1  # the side of a box that is its front, of those that spots_of lists
BACKWARD = frozenset(("desk", "kids_desk", "vanity", "piano"))
"""Groups at which one sits before the piece and looks over it."""


class PlaceRow(NamedTuple):
    """One place an item wants: its spots (k, 4), least and greatest distance, facing, weight."""

    item: int
    spots: Floats
    near: float
    far: float
    facing: float
    weight: float


def assign_places(
    items: Items, wishes: tuple[Wish, ...], space: Space, fixed: tuple[Piece, ...], library: Library
) -> Items:
    """Items with the places their groups want in a room; as they are where none wants any."""
    rows = [
        row
        for i, wish in enumerate(wishes)
        for row in _collect_wished_places(i, wish, space, fixed)
    ]
    for i, wish in enumerate(wishes):
        rows += _collect_outlet_places(i, items, wish, space, library)
    if not rows:
        return items
    ends = np.cumsum([len(row.spots) for row in rows])
    return items._replace(
        placed=np.array([row.item for row in rows], np.int64),
        places=np.array(
            [
                (end - len(row.spots), end, row.near, row.far, row.facing, row.weight)
                for row, end in zip(rows, ends, strict=True)
            ],
            np.float64,
        ),
        spots=np.concatenate([row.spots for row in rows]),
    )


def _collect_wished_places(
    i: int, wish: Wish, space: Space, fixed: tuple[Piece, ...]
) -> list[PlaceRow]:
    turned = -1.0 if wish.group in BACKWARD else 1.0
    found = [
        (draw, (_middles if draw.middle else spots_of)(draw.to, space, fixed))
        for draw in wish.sway.draws
    ]
    return [
        PlaceRow(i, spots, draw.near, draw.far, turned * draw.facing, WISHED)
        for draw, spots in found
        if len(spots)
    ]


def spots_of(to: tuple[str, ...], space: Space, fixed: tuple[Piece, ...]) -> Floats:
    """Segments (k, 4) of what is meant: openings, walls, those across from doors, sides of fixed
    pieces; none if the room has none."""
    if to == ("wall",):
        return np.hstack([space.outline, np.roll(space.outline, -1, 0)])
    if to == ("outlook",):
        return _list_across(space)
    if to in (("window",), ("door",)):
        return np.array(
            [
                (*(g.face - half), *(g.face + half))
                for g in gates(space)
                if (g.opening.kind == "window") == (to == ("window",))
                for half in [np.array([g.opening.ux, g.opening.uy]) * g.opening.width / 2]
            ]
        ).reshape(-1, 4)
    there = [p for p in fixed if p.category in to or p.function in to]
    boxes = np.array([(p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]) for p in there])
    points = corners(boxes.reshape(-1, 5))
    return np.concatenate([points, np.roll(points, -1, axis=1)], axis=2).reshape(-1, 4)


def _list_across(space: Space) -> Floats:
    """The edges (k, 4) of a room that look back at a door and have none themselves."""
    walls = spots_of(("wall",), space, ())
    way = walls[:, 2:] - walls[:, :2]
    into = np.column_stack([-way[:, 1], way[:, 0]]) / np.hypot(*way.T)[:, None]
    doors = np.array([g.inward for g in gates(space) if g.opening.kind != "window"]).reshape(-1, 2)
    across = into @ doors.T
    return walls[(across < -ACROSS).any(1) & (across < ACROSS).all(1)]


def _middles(to: tuple[str, ...], space: Space, fixed: tuple[Piece, ...]) -> Floats:
    """The middles of the fronts of fixed pieces, each as a segment without length (k, 4)."""
    fronts = spots_of(to, space, fixed).reshape(-1, 4, 4)[:, FRONT]
    middle = (fronts[:, :2] + fronts[:, 2:]) / 2
    return np.hstack([middle, middle])


def _collect_outlet_places(
    i: int, items: Items, wish: Wish, space: Space, library: Library
) -> list[PlaceRow]:
    """The outlets a group's pieces need, of the kinds its room lists."""
    found = []
    for kind in sorted({outlet.kind for outlet in space.outlets}):
        reaches = [
            need.reach - max(float(items.wish[i, 0]) - member.size.width, 0.0) / 2
            for case in cases(wish.group, library).groups
            for member in case.members
            for need in services_of(member.category)
            if need.outlet == kind
        ]
        if reaches:
            spots = np.array([(o.x, o.y, o.x, o.y) for o in space.outlets if o.kind == kind])
            found.append(PlaceRow(i, spots, 0.0, max(min(reaches), 0.0), 0.0, CONNECTED))
    return found


def list_attractions(wish: Wish) -> tuple[Attraction, ...]:
    """The places among a wish's that are other groups, not parts of the room."""
    return tuple(d for d in wish.sway.draws if d.to not in PARTS)
