"""What the net sees of a pose: the house itself, the six nearest houses, the four nearest sides.

Everything is seen from the pose: x along the longer side of the house, mirrored so that the nearest
house lies ahead and to the right. So turning, moving or mirroring a block changes nothing.
Distances are given as exp(-d / s) at several scales s, angles modulo 90° by their cosine, sine and
how near they are to 0. What is smaller than the errors of a map counts as 0 (:data:`HAIR`,
:data:`ASKEW`): proposals stand exactly parallel and wall to wall, mapped houses never quite, and a
net that saw the difference would tell them by it.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.village.house import House
from scenewright.domains.village.learned.surroundings import Surroundings
from scenewright.domains.village.standing import Flags, Floats, Indices, Shapes

HOUSES, SIDES = 6, 4
"""Nearest houses, and sides: half of them streets, half others."""
CANDIDATES = 9
"""Houses by their middles among which the nearest are looked for by their walls."""
RINGS = (15.0, 30.0, 60.0)
"""Radii in metres within which houses and voids are counted."""
HAIR, ASKEW = 0.2, float(np.deg2rad(1.0))
"""Metres and radians that count as nothing."""
SELF, HOUSE, SIDE = 28, 31, 20
"""Numbers about the house itself, of each house near, and of each side."""


class PoseTokens(NamedTuple):
    """Features of poses (k,): ``own`` (k, SELF), ``houses`` (k, HOUSES, HOUSE) nearest first,
    ``sides`` (k, SIDES, SIDE), streets first, and which rows ``known`` (k, HOUSES + SIDES) are
    there."""

    own: NDArray[Any]
    houses: NDArray[Any]
    sides: NDArray[Any]
    known: Flags


def tokens_of(seen: Surroundings, house: House, poses: Floats, shapes: Shapes) -> PoseTokens:
    """Features of a house at poses (k, 3) with their footprints (k,)."""
    near, gaps = _nearest_houses(seen, poses, shapes)
    street = _sides(seen.streets, seen.street_lines, poses, shapes)
    other = _sides(seen.others, seen.other_lines, poses, shapes)
    mirror = _mirror(seen, poses, near, street)
    beside = _house_rows(seen, house, poses, near, gaps, mirror, street.away[:, 0])
    sides = np.concatenate(
        [_side_rows(poses, street, mirror, 1.0), _side_rows(poses, other, mirror, 0.0)], 1
    )
    known = np.concatenate([near >= 0, street.known, other.known], 1)
    own = _own_rows(seen, house, poses, street.away[:, 0], gaps[:, 0])
    return PoseTokens(own, beside, sides * known[:, HOUSES:, None], known)


def near_to(distance: Floats, *scales: float) -> Floats:
    """exp(-d / s) for each scale, as a last axis.

    >>> near_to(np.array([0.0, 2.0]), 2.0).round(3).tolist()
    [[1.0], [0.368]]
    """
    return np.exp(-np.maximum(distance, 0.0)[..., None] / np.array(scales))


def forgive(value: Floats, by: float) -> Floats:
    """Values moved towards 0 by at most ``by``.

    >>> forgive(np.array([-0.5, 0.1, 2.0]), 0.2).round(3).tolist()
    [-0.3, 0.0, 1.8]
    """
    return np.sign(value) * np.maximum(np.abs(value) - by, 0.0)


def _angles(turn: Floats) -> Floats:
    """A difference of angles modulo 180° and 90°, and how near it is to a right angle or 0."""
    rest = (turn + np.pi / 4) % (np.pi / 2) - np.pi / 4
    turn = turn - rest + forgive(rest, ASKEW)
    fold = np.abs(forgive(rest, ASKEW))
    return np.concatenate(
        [
            np.stack([np.cos(2 * turn), np.sin(2 * turn), np.cos(4 * turn), np.sin(4 * turn)], -1),
            near_to(np.rad2deg(fold), 1.5, 5.0, 15.0),
        ],
        -1,
    )


def _nearest_houses(seen: Surroundings, poses: Floats, shapes: Shapes) -> tuple[Indices, Floats]:
    """The numbers (k, HOUSES) of the nearest houses (-1: none) and the gaps to them."""
    count, frames = len(poses), seen.standing.frames
    near = np.full((count, HOUSES), -1)
    gaps = np.full((count, HOUSES), 1e3)
    if not len(frames) or not count:
        return near, gaps
    away = np.hypot(*(poses[:, None, :2] - frames[None, :, :2]).transpose(2, 0, 1))
    away -= (frames[:, 3] + frames[:, 4]) / 4
    most = min(CANDIDATES, len(frames))
    chosen = np.argpartition(away, most - 1, axis=1)[:, :most]
    gap = forgive(shapely.distance(shapes[:, None], seen.standing.shapes[chosen]), HAIR)
    order = np.argsort(gap + 1e-4 * np.take_along_axis(away, chosen, 1), axis=1, kind="stable")
    order = order[:, :HOUSES]
    kept = order.shape[1]
    near[:, :kept] = np.take_along_axis(chosen, order, 1)
    gaps[:, :kept] = np.take_along_axis(gap, order, 1)
    return near, gaps


class _NearSides(NamedTuple):
    """The nearest sides (k, m) of each pose: metres, direction, length, the vector to the nearest
    point of it from the middle (k, m, 2), and which are there."""

    away: Floats
    angle: Floats
    length: Floats
    toward: Floats
    known: Flags


def _sides(sides: Floats, lines: Shapes, poses: Floats, shapes: Shapes) -> _NearSides:
    count, kept = len(poses), SIDES // 2
    found = _NearSides(
        np.full((count, kept), 1e3),
        np.zeros((count, kept)),
        np.zeros((count, kept)),
        np.zeros((count, kept, 2)),
        np.zeros((count, kept), bool),
    )
    most = min(kept, len(sides))
    if not most or not count:
        return found
    step = sides[:, 1] - sides[:, 0]
    length = np.hypot(step[:, 0], step[:, 1])
    toward, middle_away = _toward(sides, step, length, poses)
    few = min(kept + 2, len(sides))
    chosen = np.argpartition(middle_away, few - 1, axis=1)[:, :few]
    away = forgive(shapely.distance(shapes[:, None], lines[chosen]), HAIR)
    order = np.argsort(away, axis=1, kind="stable")[:, :most]
    pick = np.take_along_axis(chosen, order, 1)
    found.away[:, :most] = np.take_along_axis(away, order, 1)
    found.angle[:, :most] = np.arctan2(step[:, 1], step[:, 0])[pick]
    found.length[:, :most] = length[pick]
    found.toward[:, :most] = np.take_along_axis(toward, pick[..., None], 1)
    found.known[:, :most] = True
    return found


def _toward(sides: Floats, step: Floats, length: Floats, poses: Floats) -> tuple[Floats, Floats]:
    """From middles (k,) to the nearest points of sides (s,): vectors (k, s, 2), lengths (k, s)."""
    from_start = poses[:, None, :2] - sides[None, :, 0]
    along = (from_start * step).sum(-1) / np.maximum(length**2, 1e-9)
    toward = np.clip(along, 0.0, 1.0)[..., None] * step - from_start
    return toward, np.hypot(toward[..., 0], toward[..., 1])


def _mirror(seen: Surroundings, poses: Floats, near: Indices, street: _NearSides) -> Floats:
    """Signs (k, 2) by which x and y are mirrored."""
    toward = street.toward[:, 0]
    if len(seen.standing.frames):
        toward = seen.standing.frames[np.maximum(near[:, 0], 0), :2] - poses[:, :2]
    return np.where(_turn(toward[:, None], poses)[:, 0] < -1e-6, -1.0, 1.0)


def _turn(vectors: Floats, poses: Floats) -> Floats:
    """Vectors (k, m, 2) seen from poses (k, 3)."""
    cos, sin = np.cos(poses[:, 2, None]), np.sin(poses[:, 2, None])
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack([cos * x + sin * y, cos * y - sin * x], -1)


def _house_rows(
    seen: Surroundings,
    house: House,
    poses: Floats,
    near: Indices,
    gaps: Floats,
    mirror: Floats,
    setback: Floats,
) -> Floats:
    """Features of the nearest houses (k, HOUSES, HOUSE)."""
    rows = np.zeros((*near.shape, HOUSE))
    if not len(seen.standing.frames):
        return rows
    known = near >= 0
    theirs = seen.standing.frames[np.maximum(near, 0)]
    at = _turn(theirs[..., :2] - poses[:, None, :2], poses) * mirror[:, None]
    turn = (theirs[..., 2] - poses[:, None, 2]) * mirror.prod(1)[:, None]
    half = np.array(house.extent) / 2
    cos, sin = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    long, short = theirs[..., 3] / 2, theirs[..., 4] / 2
    reach = np.stack([cos * long + sin * short, sin * long + cos * short], -1)
    low, high = forgive(at - reach + half, HAIR), forgive(at + reach - half, HAIR)
    back = forgive(setback[:, None] - seen.setbacks[np.maximum(near, 0)], HAIR)
    parts = [
        np.log1p(gaps)[..., None] / 3,
        near_to(gaps, 0.3, 2.0, 8.0),
        _angles(turn),
        np.tanh(at / 15.0),
        np.tanh((np.abs(at) - reach - half) / 5.0),
        np.tanh(low / 4.0),
        np.tanh(high / 4.0),
        np.exp(-np.abs(low) / 0.4),
        np.exp(-np.abs(high) / 0.4),
        np.log(np.stack([long, short], -1) / 5.0),
        np.log(long * short / (half[0] * half[1]))[..., None] / 2,
        np.exp(-np.abs(long - half[0]) - np.abs(short - half[1]))[..., None],
        (seen.standing.sizes[np.maximum(near, 0)] == 0)[..., None].astype(float),
        np.tanh(back / 5.0)[..., None],
        np.exp(-np.abs(back) / 0.7)[..., None],
        np.tanh(seen.setbacks[np.maximum(near, 0)] / 15.0)[..., None],
    ]
    rows[:] = np.concatenate(parts, -1) * known[..., None]
    return rows


def _side_rows(poses: Floats, side: _NearSides, mirror: Floats, street: float) -> Floats:
    """Features of sides (k, m, SIDE)."""
    at = _turn(side.toward, poses) * mirror[:, None]
    turn = (side.angle - poses[:, None, 2]) * mirror.prod(1)[:, None]
    reach = np.hypot(at[..., 0], at[..., 1])
    parts = [
        np.full((*side.away.shape, 1), street),
        np.log1p(side.away)[..., None] / 3,
        near_to(side.away, 0.7, 3.0, 8.0, 20.0),
        _angles(turn),
        at / np.maximum(reach, 1e-6)[..., None],
        np.tanh(at / 15.0),
        np.log1p(side.length)[..., None] / 4,
        np.exp(-np.abs(side.away - 3.0) / 3.0)[..., None],
        np.exp(-np.abs(side.away - 6.0) / 3.0)[..., None],
    ]
    return np.concatenate(parts, -1)


def _own_rows(
    seen: Surroundings, house: House, poses: Floats, setback: Floats, gap: Floats
) -> Floats:
    """Features of the house itself and of the block about it (k, SELF)."""
    count, standing = len(poses), len(seen.standing.shapes)
    whole = np.array(
        [
            np.log(house.area / 80.0),
            np.log(house.extent[0] / 10.0),
            np.log(house.extent[1] / 8.0),
            float(house.shape),
            float(house.size == 0),
            float(house.size == 2),
            standing / seen.planned,
            float(standing == 0),
            np.log(seen.planned / 10.0),
            np.log(seen.area / 1e4),
            np.log(seen.plot / 25.0),
            seen.street_share,
        ]
    )
    crowd = _crowd(seen, poses)
    parts = [
        np.broadcast_to(whole, (count, len(whole))),
        np.log1p(setback)[:, None] / 3,
        near_to(setback, 2.0, 8.0, 25.0),
        np.tanh(gap / seen.plot)[:, None],
        near_to(gap, 0.3, 4.0),
        crowd,
    ]
    return np.concatenate(parts, 1)


def _crowd(seen: Surroundings, poses: Floats) -> Floats:
    """Within each radius: the share of the ground, houses against those expected, and the void:
    the mean distance to a house in plots (k, 9)."""
    ground = np.hypot(*(poses[:, None, :2] - seen.points[None]).transpose(2, 0, 1))
    frames = seen.standing.frames
    houses = np.hypot(*(poses[:, None, :2] - frames[None, :, :2]).transpose(2, 0, 1))
    void = np.minimum(seen.away / seen.plot, 3.0)
    found = []
    for radius in RINGS:
        inside = (ground < radius).astype(float)
        held = np.maximum(inside.sum(1), 1.0)
        share = held / len(seen.points)
        number = (houses < radius).sum(1) if len(frames) else np.zeros(len(poses))
        found += [share, np.tanh(number / (seen.planned * share + 0.5)), inside @ void / held]
    return np.stack(found, 1)
