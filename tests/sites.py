"""Hand-made sites for the tests: ground, roads, landmarks and buildings whose truth is known."""

from __future__ import annotations

import math

import numpy as np

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site

SOUTH = -math.pi / 2


def site(width: float = 120.0, depth: float = 80.0, **more) -> Site:
    """A rectangle of ground called ``s`` with no distances to keep unless told."""
    outline = [(0, 0), (width, 0), (width, depth), (0, depth)]
    plain = {
        "id": "s",
        "name": "Ground",
        "outline": outline,
        "setback": 0.0,
        "road_setback": 0.0,
        "spacing": 0.0,
    }
    return Site.model_validate(plain | more)


def building(name: str, x: float, y: float, w=10.0, d=8.0, h=9.0, heading=SOUTH, **more) -> Piece:
    asset, space = more.pop("asset", "modern_residential"), more.pop("space", "s")
    pose = Pose(x, y, more.pop("z", 0.0), heading)
    return Piece(name, "building", asset, space, pose, Size(w, d, h), **more)


def quarter() -> tuple[Site, list[Piece]]:
    """A quarter with everything a plan can show: a bent road, a path, a pond, a round and a
    square landmark, rows of buildings, two of them too close and one on the path."""
    turn = np.linspace(0, 2 * math.pi, 24, endpoint=False)
    round_ = np.stack([92 + 9 * np.cos(turn), 62 + 9 * np.sin(turn)], -1).round(3).tolist()
    ground = Site.model_validate(
        {
            "id": "s",
            "name": "Mill quarter",
            "setback": 4.0,
            "road_setback": 2.0,
            "spacing": 7.0,
            "outline": [(0, 0), (150, -6), (165, 60), (120, 104), (20, 96), (-8, 50)],
            "holes": [[(120, 20), (134, 16), (140, 28), (128, 36)]],
            "roads": [
                {
                    "id": "mill-lane",
                    "name": "Mill Lane",
                    "line": [(62, -8), (66, 40), (58, 108)],
                    "width": 7.0,
                },
                {"id": "walk", "line": [(66, 40), (168, 48)], "width": 3.0, "kind": "path"},
            ],
            "landmarks": [
                {"id": "rotunda", "name": "Rotunda", "outline": round_, "height": 18.0},
                {"id": "mill", "name": "Old mill", "at": (28, 82), "size": (20, 10, 14)},
            ],
            "buildings": [
                {"model": "modern_residential", "count": 10, "floors": 6, "size": (24, 11, 18)}
            ],
        }
    )
    rows = [building(f"b{k}", 30, y, 30, 11, 18) for k, y in enumerate((14, 34, 54))]
    rows += [building(f"b{k + 3}", 92, y, 28, 11, 18) for k, y in enumerate((12, 28))]
    rows += [
        building("tower-1", 138, 66, 18, 16, 54, heading=SOUTH + 0.4, asset="tower"),
        building("tower-2", 118, 82, 18, 16, 48, heading=SOUTH + 0.4, asset="tower"),
        building("kiosk", 110, 45, 5, 5, 4, asset="kiosk"),
    ]
    rows += [
        Piece("mill", "building", "", "s", Pose(28, 82, 0, SOUTH), Size(20, 10, 14), fixed=True)
    ]
    return ground, rows


def field(
    count: int, gap: float = 14.0, w: float = 12.0, d: float = 10.0, h: float = 15.0
) -> tuple[Site, list[Piece]]:
    """``count`` buildings in a square grid, ``gap`` metres apart, on ground just large enough,
    with a road along the south."""
    columns = math.ceil(math.sqrt(count))
    wide, deep = columns * (w + gap) + gap, math.ceil(count / columns) * (d + gap) + gap
    ground = site(
        wide,
        deep + 10,
        spacing=6.0,
        setback=3.0,
        roads=[{"line": [(0, 4), (wide, 4)], "width": 6.0}],
    )
    rows = [
        building(
            f"b{k}",
            gap + w / 2 + (k % columns) * (w + gap),
            10 + gap + d / 2 + (k // columns) * (d + gap),
            w,
            d,
            h,
        )
        for k in range(count)
    ]
    return ground, rows


def answer(ground: Site, pieces: list[Piece], **more) -> Solution:
    """A solution of one site."""
    document = ground.model_dump() | more
    brief = Brief.model_validate({"domain": "site", "name": ground.name, "sites": [document]})
    return Solution(brief, tuple(pieces), (), (), (), {}, "", "", 0, "", "", 0.0, 0)
