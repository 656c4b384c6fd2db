"""Glass barriers that close what a row of gates leaves open, as pieces."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.hall.gates.rails import (
    POST,
    RowOfGates,
    find_stops,
    has_post,
    lay_rails,
    measure_barred,
    measure_blocked,
)
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.gates import find_gates, find_row, measure_gates
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, lacking, measure_among
from scenewright.domains.hall.walls.built import clip_span
from scenewright.domains.hall.zoning.borders import floor_of

CATEGORY, BARRIERS = "glass_barrier", "/barriers"
"""The kind that closes the floor beside gates, and the ending of its function."""
GATE_POST = "gate_post"
"""The kind beyond a wide gate."""
RAIL_HEIGHT = 1.0
"""How high barriers are, in metres."""
GATES_ASTRAY = 3.5
"""Metres of fault from which on gates stand where no way in is: rails would close nothing."""

RAILS_SHARE = 0.002
"""How much of a rail may stand in others, in metres: less than is a collision."""


def place_barriers(
    space: Space,
    problem: HallProblem,
    layout: MeasuredLayout,
    solid: Floats,
    demands: dict[str, str],
    catalog: Catalog,
) -> tuple[Piece, ...]:
    """The barriers beside every row of gates of a layout from which the route still leads
    everywhere, none where others stand in all their places. ``solid`` (n, 5) are boxes of objects
    beside the layout, ``demands`` the demand of each group."""
    found: tuple[Piece, ...] = ()
    for unit in find_gates(problem, layout.kept) if not layout.loose else ():
        if measure_gates(problem, layout.kept, layout.boxes, unit) > GATES_ASTRAY:
            continue
        row = find_row(problem, layout.boxes, unit)
        row = row._replace(others=np.concatenate([row.others, solid]))
        for rails in _choices(problem, row):
            free = measure_blocked(problem, row, rails) <= RAILS_SHARE
            if free and _leads_on(problem, layout, rails):
                name = problem.names[unit]
                found = (*found, *make_barriers(space, name, demands[name], rails, catalog))
                solid = np.concatenate([solid, rails])
                break
    return found


def _choices(problem: HallProblem, row: RowOfGates) -> list[Floats]:
    """Rails (k, 5) of a row: first those that close floor on which nothing stands, then without the
    post of their wide gate, last those with one more end open."""
    stops = find_stops(problem, row)
    laid = {side: lay_rails(stops, row, side) for side in (-1, 1)}
    barred = {side: measure_barred(problem, row, side, rails) for side, rails in laid.items()}
    sides = sorted(laid, key=lambda side: (barred[side], not has_post(laid[side])))
    whole = [laid[side] for side in sides]
    last = max(len(rails) for rails in whole)
    less = [
        np.delete(rails, k, axis=0)
        for k in reversed(range(last))
        for rails in whole
        if k < len(rails)
    ]
    return [rails for rails in (*whole, *less) if len(rails)]


def _leads_on(problem: HallProblem, layout: MeasuredLayout, rails: Floats) -> bool:
    """Whether the route misses no more with some rails (k, 5), and no passage is narrower."""
    p, s, missed = measure_among(problem, layout, rails)
    return missed <= layout.missed and lacking(p, s) <= layout.lacking + 1e-9


def make_barriers(
    space: Space, group: str, demand: str, rails: Floats, catalog: Catalog
) -> tuple[Piece, ...]:
    """The rails (k, 5) of a group as pieces, within the hall."""
    found, floor = [], floor_of(space)
    for number, (x, y, heading, width, depth) in enumerate(_clip(rails, floor).tolist(), 1):
        size = Size(width, depth, RAIL_HEIGHT)
        category = GATE_POST if depth >= POST else CATEGORY
        asset = catalog.choose(category, size)
        turned = (heading + math.pi) % (2 * math.pi) - math.pi
        found.append(
            Piece(
                id=f"{group}/{category}_{number}",
                category=category,
                asset=asset.id if asset else "",
                space=space.id,
                pose=Pose(x, y, 0.0, turned),
                size=size,
                group=group,
                function=f"{demand}{BARRIERS}",
                footprint=footprint_of(asset, size),
            )
        )
    return tuple(found)


def _clip(rails: Floats, floor: shapely.Polygon) -> Floats:
    """Rails (k, 5) cut where a slanting wall begins, without those of no length.

    >>> floor = shapely.Polygon([(0, 0), (4, 0), (4, 3), (0, 5)])
    >>> rails = np.array([[2, 3, 0, 4, 0.2], [9, 3, 0, 4, 0.2]])
    >>> _clip(rails, floor)[:, [1, 3]].round(4).tolist()
    [[2.475, 2.95]]
    """
    found = rails.copy()
    for rail in found:
        middle, way = rail[:2].copy(), np.array([np.sin(rail[2]), -np.cos(rail[2])])
        span = (-0.5 * float(rail[3]), 0.5 * float(rail[3]))
        low, high = clip_span(floor, middle, way, span, float(rail[4]))
        rail[:2], rail[3] = middle + 0.5 * (low + high) * way, high - low
    return found[found[:, 3] > RAILS_SHARE]
