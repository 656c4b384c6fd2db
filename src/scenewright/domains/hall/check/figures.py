"""What the referee tells of each hall: measures, passages, tour, ways out, wheelchairs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import Bodies, Shape
from scenewright.check.routes import TURNING, JoinedFloor, Walk, room_for, walk_in
from scenewright.core.brief import Brief, Room
from scenewright.core.report import Finding, Note
from scenewright.domains.hall.check.escape import Field, escape_figures, escape_notes, field_of
from scenewright.domains.hall.check.halls import JudgedHall
from scenewright.domains.hall.check.measures import measures_of
from scenewright.domains.hall.check.passages import (
    MeasuredPassage,
    describe_neighbours,
    find_narrow,
    passages_of,
)
from scenewright.domains.hall.check.sight import seen_from
from scenewright.domains.hall.check.tours import tour_figures
from scenewright.domains.hall.check.walls import find_no_wall
from scenewright.domains.hall.check.zones import WHEELCHAIR, find_outside_zone, reached_by, turning


class HallVerdict(NamedTuple):
    """What is said of all halls of an answer."""

    findings: list[Finding]
    notes: list[Note]
    figures: dict[str, dict[str, Any]]


class _Around(NamedTuple):
    """What all halls of one ground share: routes for visitors and wheelchairs, room to turn, and
    the ways out."""

    ground: JoinedFloor
    walk: Walk
    wheelchair: Walk
    open_floor: Shape
    field: Field | None


def judge_halls(
    brief: Brief,
    wishes: Mapping[str, Room],
    halls: list[JudgedHall],
    bodies: Bodies,
    grounds: list[JoinedFloor],
    walks: list[Walk],
    narrow: list[Walk],
) -> HallVerdict:
    """Zone fidelity, passages and figures of all halls.

    ``walks`` are the visitors' routes in each of ``grounds``, ``narrow`` those of a person 0.4 m
    wide, ``wishes`` the rooms of the brief by space.
    """
    verdict = HallVerdict([], [], {})
    for ground, walk, slim in zip(grounds, walks, narrow, strict=True):
        same = walk.radius == WHEELCHAIR / 2
        wheelchair = walk if same else walk_in(bodies, ground, WHEELCHAIR / 2)
        circle = room_for(bodies, ground, TURNING / 2)
        open_floor = shapely.intersection(wheelchair.reached, circle)
        shapely.prepare(open_floor)
        field = field_of(ground, slim.free)
        around = _Around(ground, walk, wheelchair, open_floor, field)
        for room in ground.rooms:
            _judge(verdict, brief, wishes, halls[int(room)], bodies, around)
    return verdict


def _judge(
    verdict: HallVerdict,
    brief: Brief,
    wishes: Mapping[str, Room],
    hall: JudgedHall,
    bodies: Bodies,
    around: _Around,
) -> None:
    passages = passages_of(bodies, hall)
    verdict.findings.extend(find_outside_zone(bodies, hall))
    verdict.findings.extend(find_narrow(bodies, hall, passages))
    wish = wishes.get(hall.space.id)
    verdict.findings.extend(find_no_wall(bodies, hall, wish))
    escape = escape_figures(hall, around.field, wish.people if wish else None)
    verdict.notes.extend(escape_notes(hall, escape))
    seen = seen_from(bodies, hall, around.ground)
    verdict.figures[hall.space.id] = {
        "objects": len(hall.objects),
        "groups": len(hall.groups),
        **measures_of(bodies, hall),
        **_floor(bodies, hall, around.walk),
        "passages": [_passage(bodies, hall, passage) for passage in passages],
        "turning": turning(hall, around.open_floor),
        "wheelchair": reached_by(bodies, hall, around.wheelchair),
        "escape": escape,
        "tour": tour_figures(bodies, hall, around.ground, seen, brief.passage_width),
    }


def _floor(bodies: Bodies, hall: JudgedHall, walk: Walk) -> dict[str, float]:
    """Shares of the floor: covered by objects, and swept by the visitors' route."""
    area = max(float(hall.shape.area), 1e-9)
    stands = shapely.union_all(bodies.footprints[hall.solids])
    near = shapely.buffer(hall.shape, walk.radius)
    centres = shapely.intersection(shapely.clip_by_rect(walk.reached, *near.bounds), near)
    swept = shapely.buffer(centres, walk.radius, quad_segs=8)
    return {
        "floor_used": round(float(shapely.intersection(stands, hall.shape).area) / area, 4),
        "walkable_share": round(float(shapely.intersection(swept, hall.shape).area) / area, 4),
    }


def _passage(bodies: Bodies, hall: JudgedHall, passage: MeasuredPassage) -> dict[str, Any]:
    link = passage.link
    return {
        "first": hall.zones[link.first],
        "second": hall.zones[link.second],
        "needed": float(np.round(link.width, 3)),
        "clear": round(passage.width, 3),
        "at": list(passage.at) if passage.at else None,
        "message": describe_neighbours(bodies, passage.between) if passage.at else "",
    }
