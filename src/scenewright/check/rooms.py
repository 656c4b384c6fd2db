"""What the referee says of every scene of rooms: bodies, routes, and the rules all rooms share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from scenewright.check.bodies import Bodies, Members, Rooms, bodies_of, rooms_of
from scenewright.check.bounds import find_out_of_bounds, find_unsupported
from scenewright.check.ceilings import find_through_slopes
from scenewright.check.collisions import find_collisions
from scenewright.check.openings import find_blocked
from scenewright.check.outlets import connections_of, connections_told
from scenewright.check.radiators import find_shut_in
from scenewright.check.reach import find_unreachable
from scenewright.check.routes import (
    ROBOT_RADIUS,
    JoinedFloor,
    Walk,
    grounds_of,
    navigable_share,
    reachable_share,
    walk_in,
)
from scenewright.check.spaces import room_figures
from scenewright.check.stairs import find_blocked_stairs
from scenewright.check.usability import measure_usability
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.report import Finding, Note, count_by_kind
from scenewright.core.scene import Piece
from scenewright.core.space import Space


class Walked(NamedTuple):
    """Rooms and their pieces as exact shapes, with the routes of people through each of
    ``grounds``: ``walks`` at the brief's width, ``narrow`` of one 0.4 m wide."""

    rooms: Rooms
    bodies: Bodies
    malformed: list[Finding]
    grounds: list[JoinedFloor]
    walks: list[Walk]
    narrow: list[Walk]


def walk_rooms(
    brief: Brief,
    pieces: Sequence[Piece],
    spaces: tuple[Space, ...],
    kinds: Catalog,
    narrow: bool = True,
) -> Walked:
    """Build the shapes and walk the routes once, for every rule; those of a ``narrow`` body only
    if asked for."""
    rooms = rooms_of(spaces)
    bodies, malformed = bodies_of(tuple(pieces), rooms, kinds)
    grounds = grounds_of(rooms, brief.route_width)
    walks = [walk_in(bodies, ground, brief.route_width / 2) for ground in grounds]
    slim = [walk_in(bodies, ground, ROBOT_RADIUS) for ground in grounds if narrow]
    return Walked(rooms, bodies, malformed, grounds, walks, slim)


class Verdict(NamedTuple):
    """What is said of an answer: broken rules, what is missing or worth knowing, and figures."""

    findings: list[Finding]
    notes: list[Note]
    figures: dict[str, Any]


def judge_rooms(walked: Walked, groups: Sequence[Members] = (), figures: bool = True) -> Verdict:
    """The rules and, if asked for, the figures all scenes of rooms share; ``groups`` are reached
    as a whole."""
    rooms, bodies = walked.rooms, walked.bodies
    unserved, unreached, connected = connections_told(connections_of(bodies, rooms), bodies, rooms)
    findings = [
        *walked.malformed,
        *find_collisions(bodies, rooms.levels),
        *find_out_of_bounds(bodies, rooms),
        *find_through_slopes(bodies, rooms),
        *find_blocked(bodies, rooms),
        *find_shut_in(bodies, rooms),
        *unserved,
        *find_blocked_stairs(bodies, rooms),
        *find_unreachable(bodies, rooms, walked.grounds, walked.walks, groups),
        *find_unsupported(bodies, rooms),
    ]
    if not figures:
        return Verdict(findings, unreached, {})
    told = {
        "navigable_share": navigable_share(bodies, rooms, walked.grounds),
        "reachable_share": reachable_share(bodies, rooms, walked.grounds, walked.narrow),
        "usability": measure_usability(bodies, rooms, walked.grounds, findings),
        "rooms": room_figures(bodies, rooms),
    }
    return Verdict(findings, unreached, told | ({"outlets": connected} if connected else {}))


def count_findings(pieces: Sequence[Piece], findings: Sequence[Finding]) -> dict[str, Any]:
    """The figures every report begins with."""
    return {"pieces": len(pieces), "counts": count_by_kind(tuple(findings))}
