"""Fifty real rooms: one from each of fifty flats of Raster-to-Vector, chosen by hash alone.

Flats come in the order of the SHA-256 of their ids; of each the room of the lowest hash that wishes
for at least three groups is taken. So the list is fixed, and nobody picked it by looks.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from typing import NamedTuple

import shapely

from benchmarks.plans_r2v import adapt, raw_plans
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.domains.home.attempts.attempt import RoomTask, build_task_problem, floor_of
from scenewright.domains.home.furnishing.pieces import Parts, parts_of, posed_pieces
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.programme import Wish, part_of, programme, resolve_bedrooms

LEAST = 3


class Case(NamedTuple):
    """One room: its problem of patches, and for solvers over single pieces its parts and their
    problem; ``task`` and ``wishes`` furnish an answer. Instances have a problem only."""

    name: str
    problem: Problem
    pieces: Problem
    parts: tuple[Parts, ...] = ()
    task: RoomTask | None = None
    wishes: tuple[Wish, ...] = ()


def _hash(name: str) -> str:
    return sha256(name.encode()).hexdigest()


@cache
def rooms(count: int = 50) -> tuple[Case, ...]:
    """The first rooms of the list."""
    found: list[Case] = []
    for raw in sorted(raw_plans(), key=lambda plan: _hash(plan["id"])):
        brief = adapt(raw).brief
        cases = sorted(cases_of(brief), key=lambda case: _hash(case.name)) if brief else []
        found += cases[:1]
        if len(found) == count:
            break
    return tuple(found)


def cases_of(brief: Brief) -> Iterator[Case]:
    """The rooms of a flat that wish for enough."""
    preset, catalog, spaces_ = PRESETS["default"], shipped(), spaces(brief)
    for space in spaces_:
        area = float(shapely.Polygon(space.outline, list(space.holes)).area)
        ground = ground_of(space, (), area)
        task = RoomTask(
            space,
            ground,
            (),
            catalog,
            preset,
            "anneal",
            brief.route_width,
            brief.route_width,
            frozenset(),
            0,
            None,
        )
        others = frozenset(
            f for s in spaces_ if s.id != space.id for f in resolve_bedrooms(s.functions, 0.0)
        )
        wishes = programme(space, area, others)
        if len(wishes) < LEAST:
            continue
        part = part_of(space.functions, floor_of(ground))
        parts = tuple(parts_of(wish, part, catalog) for wish in wishes)
        pieces = posed_pieces(ground, parts, catalog, preset.weights, False, brief.route_width)
        name = f"{brief.name}/{space.id}"
        yield Case(name, build_task_problem(task, wishes, ground), pieces, parts, task, wishes)
