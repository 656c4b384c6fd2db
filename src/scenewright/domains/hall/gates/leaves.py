"""The leaves of wide gates: they swing open for people and show the way through."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from scenewright.building.door_approach import edges_of
from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.hall.gates.barriers import BARRIERS, CATEGORY, GATE_POST
from scenewright.domains.hall.gates.rails import reach
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.visit.roles import GATE

GATE_LEAF = "gate_leaf"
LEAF_THICK, LEAF_HEIGHT, SLIT = 0.03, 0.9, 0.03
"""How thick and high a leaf is, and how far from the housings on both sides it ends; metres."""
NARROWEST_LEAF, WIDEST_GATE_LEAF = 0.3, 2.0
"""How wide what it closes is at least, and at most from a gate to a wall; metres."""
Span = tuple[Floats, Floats]
"""The ends (2,) of a leaf."""


def with_leaves(space: Space, pieces: Sequence[Piece], catalog: Catalog) -> tuple[Piece, ...]:
    """Pieces with the leaves of all wide gates: each between a post and the nearest gate of its
    group; where a group with barriers has no post, between its end and the wall, if near."""
    posts = [p for p in pieces if p.category == GATE_POST]
    fenced = [p for p in pieces if p.category == CATEGORY and p.function.endswith(BARRIERS)]
    bare = {p.group: p for p in fenced if p.group not in {post.group for post in posts}}
    spans = [(post, _span_to_gate(post, pieces)) for post in posts]
    spans += [(rail, _span_to_wall(space, rail.group, pieces)) for rail in bare.values()]
    leaves = (make_leaf(of, span, catalog) for of, span in spans if span is not None)
    return (*pieces, *leaves)


def make_leaf(of: Piece, span: Span, catalog: Catalog) -> Piece:
    """The leaf between two points, of the group of a piece."""
    start, end = span
    (x, y), along = 0.5 * (start + end), end - start
    size = Size(float(np.hypot(*along)) - 2.0 * SLIT, LEAF_THICK, LEAF_HEIGHT)
    heading = float(np.arctan2(-along[0], along[1])) + math.pi
    asset = catalog.choose(GATE_LEAF, size)
    return replace(
        of,
        id=f"{of.group}/{GATE_LEAF}",
        category=GATE_LEAF,
        asset=asset.id if asset else "",
        pose=Pose(float(x), float(y), 0.0, heading % (2 * math.pi) - math.pi),
        size=size,
        footprint=footprint_of(asset, size),
    )


def _span_to_gate(post: Piece, pieces: Sequence[Piece]) -> Span | None:
    """From a post to the nearest gate of its group."""
    front = math.cos(post.pose.heading), math.sin(post.pose.heading)
    gates = [p for p in pieces if p.group == post.group and p.category == GATE]
    way = min((_measure_lane(post, gate, front) for gate in gates), key=abs, default=0.0)
    if abs(way) <= NARROWEST_LEAF:
        return None
    start = np.array(post.pose[:2]) + math.copysign(0.5 * post.size.depth, way) * np.array(front)
    return start, start + way * np.array(front)


def _span_to_wall(space: Space, group: str, pieces: Sequence[Piece]) -> Span | None:
    """From the end of a row of gates to the wall, if no barrier runs there and it is near."""
    gates = [p for p in pieces if p.group == group and p.category == GATE]
    fence = shapely.union_all(polygons_of([p for p in pieces if p.group == group]))
    found: list[tuple[float, Span]] = []
    for gate in gates:
        right = np.array([math.sin(gate.pose.heading), -math.cos(gate.pose.heading)])
        for way in (right, -right):
            start = np.array(gate.pose[:2]) + 0.5 * gate.size.width * way
            far = reach(edges_of(space), start, way)
            line = shapely.LineString([start + 0.05 * way, start + (far - 0.01) * way])
            if NARROWEST_LEAF < far <= WIDEST_GATE_LEAF and not line.intersects(fence):
                found.append((far, (start, start + far * way)))
    return min(found, key=lambda one: one[0], default=(0.0, None))[1]


def _measure_lane(post: Piece, gate: Piece, front: tuple[float, float]) -> float:
    """Metres from a post to a gate, less than none if it lies behind the post."""
    off = (gate.pose.x - post.pose.x) * front[0] + (gate.pose.y - post.pose.y) * front[1]
    return math.copysign(abs(off) - 0.5 * (post.size.depth + gate.size.width), off)
