"""Draws houses as their use and their neighbours have it: barns, shops, terraces.

The styles of houses (:mod:`scenewright.catalog.assets.buildings.house_looks`) have a form for each
use; which one a house takes is known once all stand.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.assets.buildings.house_looks import (
    FORMS,
    asset_of_house,
    form_of_use,
    read_asset,
)
from scenewright.core.brief.uses import UseName
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece

TOUCH, SHARED = 0.06, 0.5
"""Metres within which walls touch, and the share of a side wall that a terraced house shares."""
NEAR, ASIDE = 12.0, 0.7
"""Metres from a way or square within which a front stands at it, and the least cosine between
where it looks and the way there."""
LEAST_FRONT = 4.0
"""Metres of the narrowest front with a shop."""
AT_SQUARE, AT_STREET = 0.5, 0.15
"""Shares of the houses at a square and along the main street that have a shop, where nobody
says."""


class ShopGround(NamedTuple):
    """What shops are at: squares and main streets, as areas."""

    squares: shapely.Geometry
    streets: shapely.Geometry


def dress(
    pieces: Sequence[Piece],
    uses: Mapping[str, UseName],
    drawn: set[str],
    party: Collection[str] | None = None,
) -> list[Piece]:
    """The same pieces, those with an id in ``drawn`` that are houses of ours in the form of their
    use (by id; what is missing is a dwelling) and, where they share a side wall, of a row;
    ``party`` are the ids of those that do (found unless given)."""
    shared = find_party(pieces) if party is None else party
    return [_dressed(p, uses, p.id in shared) if p.id in drawn else p for p in pieces]


def find_party(pieces: Sequence[Piece]) -> frozenset[str]:
    """The ids of the buildings that share a side wall; see :func:`share_walls`."""
    built = [p for p in pieces if p.category == "building"]
    shares = zip(built, share_walls(built), strict=True)
    return frozenset(piece.id for piece, shared in shares if shared)


def _dressed(piece: Piece, uses: Mapping[str, UseName], party: bool) -> Piece:
    words = read_asset(piece.asset)
    if words is None:
        return piece
    form = form_of_use(uses.get(piece.id, "dwelling"), party)
    return replace(piece, asset=asset_of_house(form, words[1], words[2]))


def turn_into_shop(piece: Piece) -> Piece:
    """A house of ours with a shop on its ground floor."""
    words = read_asset(piece.asset)
    if words is None:
        return piece
    form = form_of_use("shop", FORMS[words[0]].party)
    return replace(piece, asset=asset_of_house(form, words[1], words[2]))


def share_walls(pieces: Sequence[Piece]) -> list[bool]:
    """Which buildings over their whole box share half a side wall with another.

    >>> from scenewright.core.scene import Pose, Size
    >>> rows = [Piece(f"{k}", "building", "", "a", Pose(5.0 * k, 0, 0, np.pi / 2), Size(5, 9, 8))
    ...         for k in (0, 1, 4)]
    >>> share_walls(rows)
    [True, True, False]
    """
    found = np.zeros(len(pieces), np.bool_)
    boxes = np.array([k for k, piece in enumerate(pieces) if not piece.footprint], np.int64)
    if len(pieces) < 2 or not len(boxes):
        return found.tolist()
    shapes = polygons_of(list(pieces))
    walls, of = _side_walls(shapes[boxes], np.array([pieces[k].pose.heading for k in boxes]))
    of = boxes[of]
    near = shapely.buffer(walls, TOUCH, cap_style="flat")
    wall, other = shapely.STRtree(shapes).query(near, predicate="intersects")
    wall, other = wall[other != of[wall]], other[other != of[wall]]
    round_ends = shapely.buffer(walls, TOUCH, quad_segs=16)
    for k in np.unique(wall).tolist():
        beside = shapely.union_all(shapes[other[wall == k]])
        along = shapely.intersection(round_ends[k], beside).area / (2 * TOUCH)
        found[of[k]] |= bool(along >= 0.5 * SHARED * walls[k].length)
    return found.tolist()


def _side_walls(
    boxes: NDArray[np.object_], headings: NDArray[np.float64]
) -> tuple[NDArray[np.object_], NDArray[np.int64]]:
    """The side walls (m,) of buildings over their boxes (n,), without their ends, and whose each
    is (m,)."""
    rings = shapely.get_coordinates(boxes).reshape(-1, 5, 2)
    sides = np.stack([rings[:, :-1], rings[:, 1:]], 2).reshape(-1, 2, 2)
    of = np.repeat(np.arange(len(boxes)), 4)
    ahead = np.stack([np.cos(headings), np.sin(headings)], 1)[of]
    lines = shapely.linestrings(sides)
    step = ((sides[:, 1] - sides[:, 0]) * ahead).sum(1)
    aside = np.flatnonzero(np.abs(step) > 0.7 * shapely.length(lines))
    ends = [shapely.line_interpolate_point(lines[aside], at, normalized=True) for at in (0.1, 0.9)]
    spots = np.stack([shapely.get_coordinates(one) for one in ends], 1)
    return np.asarray(shapely.linestrings(spots)), of[aside]


def find_shop_fronts(pieces: Sequence[Piece], ground: ShopGround) -> tuple[list[str], list[str]]:
    """The ids of houses of ours that look at a square, the nearest first, and of those that look
    at a main street."""
    houses = [p for p in pieces if _can_have_shop(p)]
    if not houses:
        return [], []
    turn = np.array([p.pose.heading for p in houses])
    ahead = np.stack([np.cos(turn), np.sin(turn)], 1)
    at = np.array([[*p.pose[:2]] for p in houses])
    doors = at + ahead * np.array([[p.size.depth / 2] for p in houses])
    rows = [_looking_at(goal, doors, ahead) for goal in ground]
    names = [[houses[k].id for k in row] for row in rows]
    return names[0], [name for name in names[1] if name not in names[0]]


def _can_have_shop(piece: Piece) -> bool:
    words = read_asset(piece.asset)
    lived = words is not None and words[0] in ("house", "row", "shop", "rowshop")
    return lived and piece.size.width >= LEAST_FRONT


def _looking_at(goal: shapely.Geometry, doors: Any, ahead: Any) -> list[int]:
    """The numbers of doors (n, 2) that look at a ground near by, the nearest first."""
    if goal.is_empty:
        return []
    lines = shapely.shortest_line(shapely.points(doors), goal)
    step = np.diff(shapely.get_coordinates(lines).reshape(-1, 2, 2), axis=1)[:, 0]
    away = np.hypot(*step.T)
    looks = (step * ahead).sum(1) >= ASIDE * away - 1e-9
    order = np.argsort(np.round(away, 3), kind="stable")
    return [int(k) for k in order if looks[k] and away[k] <= NEAR]


def choose_shops(square: Sequence[str], street: Sequence[str], share: float | None) -> list[str]:
    """The houses that have a shop where no brief says how many: by the ``share`` of all fronts, or
    by :data:`AT_SQUARE` and :data:`AT_STREET` where nothing is learned of a place.

    >>> choose_shops(["a", "b"], ["c", "d", "e"], None), choose_shops(["a"], ["c", "d"], 0.7)
    (['a'], ['a', 'c'])
    """
    if share is not None:
        both = [*square, *street]
        return both[: round(share * len(both))]
    return [
        *square[: math.ceil(AT_SQUARE * len(square))],
        *street[: round(AT_STREET * len(street))],
    ]
