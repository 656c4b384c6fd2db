"""Doors, walks and lanes: can people and fire engines reach every building on paved ground?

Judged where the solution says what is laid out. A street is a road or path of the brief that serves
the site, or the border of a site that none does. Paved ground that touches, directly or by other
paved ground, a street or the ground over which one crosses from it, belongs to it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Flags, Floats, Shapes
from scenewright.core.report import Finding
from scenewright.domains.site.check.bodies import JudgedSite, SiteBodies
from scenewright.ground.works import GroundWorks, Pathway

STEP, JOIN = 0.3, 0.05
"""Metres a walk may end before a door, and between paved areas that count as joined."""
PORCH, ROUGH = 1.5, 0.05
"""Metres about a door where its walk may touch the wall, and by which the edge of a lane or walk,
drawn to the millimetre, may be off."""


def find_unserved_doors(
    grounds: JudgedSite, bodies: SiteBodies, works: GroundWorks
) -> list[Finding]:
    """Buildings to whose door no walk, lane or street leads, whose door looks at the border from
    too near, to which no lane comes near enough; and buildings that stand on a lane or walk."""
    own = np.flatnonzero(~bodies.landmark)
    served, near = find_served(grounds, bodies, works)
    site, found = grounds.site, []
    for row in own[~served[own]]:
        message = f"no walk, path or road leads to the door of {bodies.ids[row]}"
        found.append(_finding("unserved_door", grounds, bodies, row, message))
    for row in own[find_at_border(grounds, bodies)[own]]:
        message = f"the door of {bodies.ids[row]} is less than {site.door_distance:g} m from the "
        message += "border, with no way before it"
        found.append(_finding("door_at_border", grounds, bodies, row, message, site.door_distance))
    for row in own[~near[own]]:
        message = f"no lane or road {site.fire_access:g} m wide comes within {site.fire_reach:g} m "
        message += f"of {bodies.ids[row]}"
        found.append(_finding("far_from_lane", grounds, bodies, row, message, site.fire_reach))
    return found + _find_built_over(grounds, bodies, works.pathways)


def find_served(grounds: JudgedSite, bodies: SiteBodies, works: GroundWorks) -> tuple[Flags, Flags]:
    """Which bodies have a door on paved ground, squares included, joined to a street, and which are
    near enough to a lane of full width joined to a road."""
    walks = [row for row in works.pathways if row.kind == "walk"]
    wide = grounds.site.fire_access - TOLERANCE
    lanes = [row for row in works.pathways if row.kind == "lane"]
    strong = [row for row in lanes if row.width >= wide]
    open_ = [shapely.Polygon(a.outline) for a in works.areas if a.kind in ("square", "forecourt")]
    paved = np.concatenate([_pave([*lanes, *walks]), np.array(open_, object)])
    every = _join_paved(*_streets(grounds, False), paved)
    driven = _join_paved(*_streets(grounds, True), _pave(strong))
    doors = shapely.points(find_door_points(bodies)[0])
    return _within(every, doors, STEP), _within(
        driven, bodies.footprints, grounds.site.fire_reach + TOLERANCE
    )


def find_door_points(bodies: SiteBodies) -> tuple[Floats, Floats]:
    """The middle of the side of each body farthest ahead, and the way it looks; (n, 2) each."""
    ahead = np.stack([np.cos(bodies.heading), np.sin(bodies.heading)], -1)
    points = np.zeros_like(ahead)
    for row, shape in enumerate(bodies.footprints):
        ring = shapely.get_coordinates(shape.exterior)
        middles = (ring[1:] + ring[:-1]) / 2
        points[row] = middles[np.argmax(np.round(middles @ ahead[row], 6))]
    return points, ahead


def find_at_border(grounds: JudgedSite, bodies: SiteBodies) -> Flags:
    """Which doors look at the border from nearer than the least distance, no way between."""
    asked = grounds.site.door_distance - TOLERANCE
    streets = grounds.streets
    if not len(streets.surfaces) or asked <= 0.0 or not len(bodies.ids):
        return np.zeros(len(bodies.ids), bool)
    points, ahead = find_door_points(bodies)
    lines = shapely.linestrings(np.stack([points, points + asked * ahead], 1))
    out = shapely.intersects(grounds.border, lines)
    ways = shapely.union_all([*streets.surfaces, *streets.crossings])
    free = shapely.distance(ways, lines) > 0.0
    found: Flags = out & free & shapely.covers(grounds.floor, shapely.points(points))
    return found


def _streets(grounds: JudgedSite, drivable: bool) -> tuple[Shapes, Shapes]:
    """Where paved ground may begin, and the ground over which it is reached from there: roads and
    paths, ``drivable`` paths if they are as wide as a lane; else where paths come in; else the
    border."""
    streets, none = grounds.streets, np.empty(0, object)
    rows = streets.driven if drivable else np.ones(len(streets.driven), bool)
    if rows.any():
        return streets.surfaces[rows], streets.crossings[rows]
    ends = streets.ends[~shapely.is_empty(streets.ends)]
    reach = 2.0 * grounds.site.fire_access
    return (shapely.buffer(ends, reach), none) if len(ends) else (np.array([grounds.border]), none)


def _pave(rows: Sequence[Pathway]) -> Shapes:
    lines = np.array([shapely.LineString(row.line) for row in rows], object)
    return shapely.buffer(lines, np.array([row.width / 2 for row in rows]), cap_style="square")


def _join_paved(streets: Shapes, crossings: Shapes, paved: Shapes) -> Shapes:
    """Streets and the paved areas that lead to them, directly or over their crossings."""
    tree, reached = shapely.STRtree(paved), np.zeros(len(paved), bool)
    starts = np.concatenate([streets, crossings])
    fresh = np.unique(tree.query(starts, predicate="dwithin", distance=JOIN)[1])
    while len(fresh):
        reached[fresh] = True
        near = tree.query(paved[fresh], predicate="dwithin", distance=JOIN)[1]
        fresh = np.setdiff1d(near, np.flatnonzero(reached))
    return np.concatenate([streets, paved[reached]])


def _within(areas: Shapes, shapes: Shapes, distance: float) -> Flags:
    found = np.zeros(len(shapes), bool)
    near = shapely.STRtree(areas).query(shapes, predicate="dwithin", distance=distance)[0]
    found[near] = True
    return found


def _find_built_over(
    grounds: JudgedSite, bodies: SiteBodies, rows: Sequence[Pathway]
) -> list[Finding]:
    """Buildings that stand on a lane or walk, and lanes and walks that leave the site."""
    lines = np.array([shapely.LineString(row.line) for row in rows], object)
    half = np.array([row.width / 2 - ROUGH for row in rows])
    paved = shapely.buffer(lines, half, cap_style="flat")
    porches = shapely.union_all(shapely.buffer(shapely.points(find_door_points(bodies)[0]), PORCH))
    clear = shapely.difference(paved, porches)
    k, i = shapely.STRtree(bodies.footprints).query(clear, predicate="intersects")
    found = [
        _finding(
            "blocked_path",
            grounds,
            bodies,
            row,
            f"{bodies.ids[row]} stands on a {rows[way].kind} {rows[way].width:g} m wide",
        )
        for way, row in zip(k.tolist(), i.tolist(), strict=True)
    ]
    wider = shapely.union_all(
        [shapely.buffer(grounds.floor, 0.5 + ROUGH), *grounds.streets.crossings]
    )
    out = np.flatnonzero(~shapely.covers(wider, lines)).tolist()
    message = "a {0} leaves the site at ({1:.1f}, {2:.1f})"
    words = [message.format(rows[n].kind, *rows[n].line[0]) for n in out]
    return found + [Finding("out_of_bounds", "", grounds.plan.id, "", "", w) for w in words]


def _finding(
    kind: str, grounds: JudgedSite, bodies: SiteBodies, row: int, message: str, amount: float = 0.0
) -> Finding:
    given = bool(bodies.given[row])
    return Finding(kind, "", grounds.plan.id, bodies.ids[row], "", message, amount, 0.0, given)
