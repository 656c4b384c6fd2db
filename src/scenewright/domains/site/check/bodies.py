"""A site and its buildings as exact shapes, built once and shared by every test.

Landmarks come from the brief, whatever the answer says of them; buildings are the other pieces.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import Flags, Floats, Shape, Shapes, footprints_of
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.domains.site.brief import Site
from scenewright.domains.site.check.streets import JudgedStreets, find_serving_streets
from scenewright.ground.plan import SitePlan

LARGEST = 1e5


class SiteBodies(NamedTuple):
    """Buildings first, then landmarks, row by row: ids, footprints, corners of the boxes (n, 4, 2)
    from back right counter-clockwise, undersides, tops, headings, and which came with the brief.
    ``landmark`` marks the landmarks. ``pieces`` are those of the buildings."""

    pieces: tuple[Piece, ...]
    ids: tuple[str, ...]
    footprints: Shapes
    corners: Floats
    low: Floats
    high: Floats
    heading: Floats
    given: Flags
    landmark: Flags


class JudgedSite(NamedTuple):
    """One site: what was asked for, its plan, its ground (outline less holes) and border, the
    areas of its roads and paths with their ids, whether each is a road, and the streets that serve
    it."""

    site: Site
    plan: SitePlan
    floor: Shape
    border: Shape
    ways: Shapes
    way_ids: tuple[str, ...]
    drivable: Flags
    streets: JudgedStreets


def grounds_of(sites: Sequence[Site], plans: Sequence[SitePlan]) -> list[JudgedSite]:
    """The grounds of all sites by their plans."""
    return [_grounds(site, plan) for site, plan in zip(sites, plans, strict=True)]


def _grounds(site: Site, plan: SitePlan) -> JudgedSite:
    floor = shapely.Polygon(plan.outline, plan.holes)
    rows = [(way, shapely.Polygon(a.outline, a.holes)) for way in plan.roads for a in way.areas]
    ways = np.empty(len(rows), object)
    ways[:] = [area for _, area in rows]
    drivable = np.array([way.kind == "road" for way, _ in rows], bool)
    return JudgedSite(
        site,
        plan,
        floor,
        shapely.boundary(floor),
        ways,
        tuple(way.id for way, _ in rows),
        drivable,
        find_serving_streets(site, floor),
    )


def fault_of(piece: Piece, known: set[str]) -> str:
    """The fault of a piece that cannot be judged; empty if it can."""
    values = np.array([*piece.pose, *piece.size], float)
    if not np.isfinite(values).all() or np.abs(values).max() > LARGEST:
        return "has a pose or size that is not a number of metres"
    if (values[4:] <= 0).any():
        return f"has no size: {values[4]:g} x {values[5]:g} x {values[6]:g} m"
    return "" if piece.space in known else f"stands in {piece.space!r}, which is not a site"


def bodies_of(grounds: JudgedSite, pieces: Sequence[Piece]) -> tuple[SiteBodies, list[Finding]]:
    """The buildings among sound pieces of a site and its landmarks, and what is wrong with these.
    Pieces of other categories (trees) are not judged."""
    marks = grounds.plan.landmarks
    matched = _match_landmarks(grounds.plan, pieces)
    mine = {id(piece) for piece in matched.values()}
    own = tuple(p for p in pieces if p.category == "building" and id(p) not in mine)
    rows = [
        (*p.pose[:2], p.pose.heading, *p.size[:2], p.pose.z, p.pose.z + p.size.height) for p in own
    ]
    rows += [(*row.box, 0.0, row.height) for row in marks]
    values = np.array(rows, float).reshape(-1, 7)
    corners = _corners(values)
    shapes = shapely.polygons(corners) if len(rows) else np.empty(0, object)
    shapes[: len(own)] = footprints_of(own, corners[: len(own)])
    for number, row in enumerate(marks):
        shapes[len(own) + number] = shapely.Polygon(row.footprint)
    landmark = np.arange(len(rows)) >= len(own)
    given = landmark | np.array([p.fixed for p in own] + [True] * len(marks), bool)
    ids = (*(p.id for p in own), *(matched[m.id].id if m.id in matched else m.id for m in marks))
    bodies = SiteBodies(
        own, ids, shapes, corners, values[:, 5], values[:, 6], values[:, 2], given, landmark
    )
    return bodies, _find_changed_landmarks(grounds.plan, matched)


def _match_landmarks(plan: SitePlan, pieces: Sequence[Piece]) -> dict[str, Piece]:
    """The piece of each landmark: named like it, or like it in its site (``site/landmark``)."""
    names = {name: row.id for row in plan.landmarks for name in (row.id, f"{plan.id}/{row.id}")}
    return {names[piece.id]: piece for piece in reversed(pieces) if piece.id in names}


def _find_changed_landmarks(plan: SitePlan, matched: dict[str, Piece]) -> list[Finding]:
    """Landmarks that are missing, moved, turned or of another size than in the brief."""
    found = []
    for row in plan.landmarks:
        piece = matched.get(row.id)
        if piece is None:
            message, by = f"{row.id} is missing", 0.0
        else:
            x, y, heading, width, depth = row.box
            moved = float(np.hypot(piece.pose.x - x, piece.pose.y - y)) + abs(piece.pose.z)
            turned = abs(float(np.angle(np.exp(1j * (piece.pose.heading - heading)))))
            size = np.abs(np.subtract(piece.size, (width, depth, row.height))).max()
            by = max(moved, turned * max(width, depth) / 2, float(size))
            message = f"{row.id} was changed: moved {moved:.2f} m, turned {np.rad2deg(turned):.1f} "
            message += f"degrees, size off by {size:.2f} m"
        if piece is None or by > 0.01:
            found.append(
                Finding("changed_landmark", "", plan.id, row.id, "", message, round(by, 4))
            )
    return found


def _corners(rows: Floats) -> Floats:
    x, y, heading, width, depth = rows.T[:5]
    front = np.stack([np.cos(heading), np.sin(heading)], -1) * depth[:, None] / 2
    right = np.stack([np.sin(heading), -np.cos(heading)], -1) * width[:, None] / 2
    signs = ((1, -1), (1, 1), (-1, 1), (-1, -1))
    middle = np.stack([x, y], -1)
    return np.stack([middle + r * right + f * front for r, f in signs], 1)
