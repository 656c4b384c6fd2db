"""Carpets and spots of halls: drawn, in their zones, over what they light, and no part of the
solution."""

from __future__ import annotations

import pytest
import shapely

from scenewright.core.solution import Solution
from scenewright.domains import plan_of, scene_of, solve
from scenewright.domains.hall.furnishing.islands import plain_carpet
from scenewright.formats import read


def gallery() -> Solution:
    return solve(read("sample:hall-irregular"), preset="quick", steps=2000, threads=1)


def test_carpets_lie_in_their_zones_and_spots_hang_over_exhibits() -> None:
    solution = gallery()
    scene = scene_of(solution)
    zones = {zone.id: shapely.Polygon(zone.outline) for zone in solution.detail.layout.zones}
    assert scene.surfaces
    for surface in scene.surfaces:
        zone = zones[surface.id.split("/")[1]]
        parts = [shapely.Polygon(outline, holes) for outline, holes in surface.areas]
        assert all(part.is_valid and zone.buffer(1e-6).contains(part) for part in parts)
    exhibits = {(p.pose.x, p.pose.y) for p in solution.pieces if p.category == "showcase"}
    spots = [piece for piece in scene.pieces if piece.function == "light"]
    assert exhibits <= {(spot.pose.x, spot.pose.y) for spot in spots}
    height = plan_of(solution.brief).spaces[0].height
    assert all(spot.pose.z + spot.size.height <= height for spot in spots)


def test_the_solution_knows_nothing_of_them() -> None:
    solution = gallery()
    drawn = {piece.id for piece in scene_of(solution).pieces} - {p.id for p in solution.pieces}
    assert drawn
    assert all(name.endswith("/spot") for name in drawn)


def test_carpets_become_rectangles_unless_they_are_round() -> None:
    disc = shapely.Point(0, 0).buffer(4.0, quad_segs=16).simplify(0.05)
    assert plain_carpet(disc).equals(disc)
    notched = shapely.box(0, 0, 6, 4).difference(shapely.box(0, 0, 1, 1))
    holed = shapely.box(0, 0, 9, 9).difference(shapely.box(3, 3, 6, 6))
    assert plain_carpet(notched).area == pytest.approx(24.0)
    assert plain_carpet(holed).area == pytest.approx(81.0)
