"""The pieces placed so far, as obstacles."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.standing import RADIATED, is_radiator
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.domains.home.problem import Ground
from scenewright.geometry.fit import faults

Floats = NDArray[np.float64]
Codes = NDArray[np.int64]

TOUCHING = 0.002
"""Metres by which pieces may overlap."""


class StandingObstacles(NamedTuple):
    """The pieces in the room so far: boxes ``(o, 5)``, several where a piece covers less than its
    own, underside and top ``(o, 2)``, and what each is called."""

    boxes: Floats
    spans: Floats
    names: tuple[str, ...]


@lru_cache(maxsize=64)
def flat_kinds(catalog: Catalog) -> frozenset[str]:
    """The kinds of a catalog that other things stand on."""
    return frozenset(category for category, kind in catalog.kinds.items() if kind.flat)


def standing_of(pieces: tuple[Piece, ...], flat: frozenset[str]) -> StandingObstacles:
    """Pieces as something to keep clear of, without the flat ones; radiators with the air before
    them."""
    solid = [p for p in pieces if p.category not in flat]
    parts = [(p, box) for p in solid for box in _kept_clear(p)]
    boxes = [box for _, box in parts]
    spans = [(p.pose.z, p.pose.z + p.size.height) for p, _ in parts]
    return StandingObstacles(
        np.array(boxes, np.float64).reshape(-1, 5),
        np.array(spans, np.float64).reshape(-1, 2),
        tuple(p.category for p, _ in parts),
    )


def _kept_clear(piece: Piece) -> list[list[float]]:
    """The boxes ``(k, 5)`` a piece keeps clear."""
    if not is_radiator(piece):
        return boxes_of(piece)
    pose, size = piece.pose, piece.size
    x, y = (
        pose.x + RADIATED / 2 * np.cos(pose.heading),
        pose.y + RADIATED / 2 * np.sin(pose.heading),
    )
    return [[float(x), float(y), pose.heading, size.width, size.depth + RADIATED]]


def join_standing(standing: StandingObstacles, more: StandingObstacles) -> StandingObstacles:
    """Both together."""
    return StandingObstacles(
        np.concatenate([standing.boxes, more.boxes]),
        np.concatenate([standing.spans, more.spans]),
        standing.names + more.names,
    )


def find_faults(boxes: Floats, spans: Floats, ground: Ground, standing: StandingObstacles) -> Codes:
    """What is wrong with each of the boxes (n, 5) of ``spans`` (n, 2) in a room: codes (n,) as of
    :func:`scenewright.geometry.fit.faults`, 0 where nothing is."""
    codes, _ = faults(
        boxes,
        spans,
        np.zeros(len(boxes), bool),
        ground.edges,
        ground.keep_free,
        ground.windows,
        standing.boxes,
        standing.spans,
        TOUCHING,
    )
    return codes


def find_faults_of(
    piece: Piece, ground: Ground, standing: StandingObstacles
) -> tuple[Floats, Floats, Codes]:
    """The box (1, 5) and the span (1, 2) of a piece, and what is wrong with it, as a code (1,)."""
    box = np.array([[*piece.pose[:2], piece.pose.heading, *piece.size[:2]]])
    span = np.array([[piece.pose.z, piece.pose.z + piece.size.height]])
    return box, span, find_faults(box, span, ground, standing)
