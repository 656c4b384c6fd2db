"""Villages as CityJSON: what is written is read back by our own reader of city models."""

from __future__ import annotations

import json
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from scenewright.catalog.assets.buildings.roof_planes import RoofPlane, roof_planes
from scenewright.catalog.assets.buildings.rural_houses import LOOKS, build_house
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Size
from scenewright.domains import plan_of, solve
from scenewright.formats import read, write
from scenewright.ground.reading.city import city_scene


def test_houses_are_read_back_where_they_stand(tmp_path: Path) -> None:
    brief = read("sample:village-hamlet")
    solution = solve(brief, plan=plan_of(brief), steps=1)
    path = tmp_path / "hamlet.city.json"
    write(solution, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    kinds = [row["type"] for row in document["CityObjects"].values()]
    houses = [piece for piece in solution.pieces if piece.category == "building"]
    assert kinds.count("Building") == len(houses)
    assert {"LandUse", "Road"} <= set(kinds)
    found = city_scene(document, path)
    areas = sorted(shapely.Polygon(outline_of(piece)).area for piece in houses)
    assert len(found.buildings) == len(houses)
    again = sorted(shapely.Polygon(row.outline).area for row in found.buildings)
    assert np.array(again) == pytest.approx(np.array(areas), rel=0.02)


@pytest.mark.parametrize("sample", ["street", "hamlet", "dense"])
def test_every_solid_is_closed_plane_and_looks_outwards(tmp_path: Path, sample: str) -> None:
    brief = read(f"sample:village-{sample}")
    solution = solve(brief, plan=plan_of(brief), steps=1)
    path = tmp_path / "village.city.json"
    write(solution, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    corners = np.array(document["vertices"]) / 1000
    houses = [row for row in document["CityObjects"].values() if row["type"] == "Building"]
    for row in houses:
        solids = {one["lod"]: one for one in row["geometry"]}
        assert set(solids) == {"1.2", "2.0"}
        prism, roofed = (_volume(solids[lod]["boundaries"][0], corners) for lod in ("1.2", "2.0"))
        assert 0.5 * prism < roofed <= prism * 1.0001
        _check_meanings(solids["2.0"], corners)


def _volume(shell: list[list[list[int]]], corners: np.ndarray) -> float:
    """What a shell holds, in cubic metres; every side is used twice, in opposite directions."""
    rings = [ring for surface in shell for ring in surface]
    edges = [(ring[k - 1], ring[k]) for ring in rings for k in range(len(ring))]
    assert len(set(edges)) == len(edges)
    assert set(edges) == {(b, a) for a, b in edges}
    total = 0.0
    for ring in rings:
        points = corners[ring] - corners[rings[0][0]]
        normal = _normal(points)
        total += float(points[0] @ normal) / 3
        assert np.abs((points - points[0]) @ normal).max() < 0.01 * np.hypot.reduce(normal)
    return total


def _normal(points: np.ndarray) -> np.ndarray:
    return np.cross(points, np.roll(points, -1, axis=0)).sum(0) / 2


def _check_meanings(solid: dict[str, Any], corners: np.ndarray) -> None:
    """Roofs look up, walls sideways, the ground down."""
    kinds = [solid["semantics"]["surfaces"][k]["type"] for k in solid["semantics"]["values"][0]]
    for kind, (ring, *_) in zip(kinds, solid["boundaries"][0], strict=True):
        normal = _normal(corners[ring] - corners[ring[0]])
        rise = normal[2] / np.linalg.norm(normal)
        assert {
            "RoofSurface": rise > 0.5,
            "WallSurface": abs(rise) < 0.01,
            "GroundSurface": rise < -0.999,
        }[kind]


def test_planes_of_roofs_meet_the_slopes_that_are_drawn() -> None:
    ell = ((-7.5, -4.75), (7.5, -4.75), (7.5, 1.75), (3.0, 1.75), (3.0, 4.75), (-7.5, 4.75))
    kite = ((-6.0, -4.0), (5.0, -5.0), (6.0, 4.0), (-5.0, 5.0))
    for asset, outline in product(("house_rural_gabled", "house_rural_hipped"), (ell, kite)):
        size = Size(15.0 if outline is ell else 12.0, 9.5 if outline is ell else 10.0, 8.0)
        planes = roof_planes(asset, size, outline)
        _, style, roof = asset.split("_")
        drawn = build_house(size, outline, style, roof)
        (tiles,) = [part for part in drawn if part.material == LOOKS[style].roof]
        tops = [_height(planes, x, y) for x, y, _ in tiles.vertices]
        off = [z - top for (_, _, z), top in zip(tiles.vertices, tops, strict=True)]
        assert max(off) == pytest.approx(0.0, abs=0.02)


def _height(planes: tuple[RoofPlane, ...], x: float, y: float) -> float:
    """The height of a roof over a place."""
    at = shapely.Point(x, y)
    nearest = min(row.ground.distance(at) for row in planes)
    over = [row.plane for row in planes if row.ground.distance(at) <= nearest + 1e-3]
    return max(a * x + b * y + c for a, b, c in over)
