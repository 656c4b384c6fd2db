"""Rooms made by hand for the tests of the referee."""

from __future__ import annotations

import math

import numpy as np

from scenewright.building.standing import item_of
from scenewright.catalog.kinds import KINDS
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.core.report import Report
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Space
from scenewright.domains import check

NORTH, SOUTH, EAST, WEST = math.pi / 2, -math.pi / 2, 0.0, math.pi


SERVING = {
    name: Kind(name, airy=kind.airy, services=kind.services, essential=kind.essential)
    for name, kind in KINDS.items()
}
"""What the shipped kinds serve as and are connected to, without how they are reached."""
CATALOG = Catalog(
    SERVING
    | {
        kind.category: kind
        for kind in (
            Kind("box"),
            Kind("wardrobe", access=("front",)),
            Kind("bed", access=("left", "right")),
            Kind("rug", flat=True),
            Kind("table"),
            Kind("chair", under=("table",), airy=True),
            Kind("hob", support="top", under=("counter",)),
            Kind("counter"),
            Kind("lamp", support="top"),
            Kind("pendant", support="ceiling"),
            Kind("picture", support="wall"),
            Kind("curtain", support="wall"),
        )
    }
)


def rectangle(x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
    return np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], float)


def door(x: float, y: float, u: tuple[float, float] = (1, 0), **more) -> Opening:
    wanted = {"width": 0.9, "thickness": 0.1, "sill": 0.0, "head": 2.05, "spaces": ("a",)}
    return Opening(more.pop("id", "door"), more.pop("kind", "door"), "0", x, y, *u, **wanted | more)


def room(**more) -> Space:
    """A room 4 m by 3 m with its door in the middle of the south wall."""
    entrance = door(2.0, -0.05)
    wanted = {"outline": rectangle(0, 0, 4, 3), "openings": (entrance,), "functions": ("other",)}
    return Space("a", "a", level="0", **wanted | more)


def piece(
    category: str, x: float, y: float, w: float = 1.0, d: float = 1.0, h: float = 1.0, **more
) -> Piece:
    z, heading = more.pop("z", 0.0), more.pop("heading", NORTH)
    named = more.pop("id", f"{category}@{x:g},{y:g}")
    pose, size, space = Pose(x, y, z, heading), Size(w, d, h), more.pop("space", "a")
    return Piece(named, category, "", space, pose, size, **more)


def judge(*pieces: Piece, spaces: tuple[Space, ...] | None = None, route: float = 0.6) -> Report:
    spaces = spaces or (room(),)
    rooms = [given(s, pieces) for s in spaces if any(p.fixed and p.space == s.id for p in pieces)]
    rooms = rooms or [{"outline": [[0, 0], [4, 0], [4, 3]]}]
    levels = [{"id": level} for level in dict.fromkeys(s.level for s in spaces)]
    brief = Brief.model_validate({"rooms": rooms, "levels": levels, "route_width": route})
    solution = Solution(brief, pieces, (), (), (), {}, "", "", 0, "", "", 0.0, 0)
    return check(solution, spaces=spaces, catalog=CATALOG)


def given(space: Space, pieces: tuple[Piece, ...]) -> dict[str, object]:
    """A room of a brief in which the fixed ones of some pieces stand."""
    fixed = [item_of(p).model_dump() for p in pieces if p.fixed and p.space == space.id]
    return {"id": space.id, "level": space.level, "outline": space.outline, "fixed": fixed}


def kinds(report: Report) -> set[str]:
    return {found.kind for found in report.findings}
