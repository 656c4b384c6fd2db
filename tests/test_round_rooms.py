"""Rooms with curved walls: furniture stands along chords of them, what hangs hangs on the wall."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.catalog.classes import SOFAS
from scenewright.geometry.arcs import BEHIND, chords_of, true_walls

CASES = Path(__file__).parent / "data" / "field_cases"


def circle(radius: float, parts: int, turns: float = 1.0) -> np.ndarray:
    way = np.linspace(0.0, 2 * np.pi * turns, parts + 1)[:parts]
    return radius * np.column_stack([np.cos(way), np.sin(way)])


@pytest.mark.parametrize("radius", [1.5, 2.4, 6.0])
def test_chords_are_in_the_room_and_near_its_wall(radius: float) -> None:
    ring = circle(radius, 72)
    room = shapely.Polygon(ring).buffer(1e-9)
    chords = chords_of(ring)
    middles = (chords[:, :2] + chords[:, 2:]) / 2
    assert all(room.covers(shapely.LineString(row.reshape(2, 2))) for row in chords)
    assert (radius - np.hypot(*middles.T) <= BEHIND + 1e-9).all()
    longest = np.hypot(*(chords[:, 2:] - chords[:, :2]).T).max()
    assert longest > 0.7 * np.sqrt(8 * radius * BEHIND)


def test_corners_long_walls_and_curves_into_the_room_have_none() -> None:
    octagon = circle(2.0, 8)
    twelve = circle(4.0, 16)
    pillar = np.vstack([[[-5, -5], [5, -5], [5, 5], [-5, 5]], circle(1.0, 36)[::-1] - [5.0, 0.0]])
    assert [len(chords_of(ring)) for ring in (octagon, twelve)] == [0, 0]
    ahead = pillar[4:][pillar[4:, 0] > -5]
    into = np.vstack([pillar[:4], ahead])
    assert len(chords_of(into)) == 0


def test_a_quarter_circle_between_straight_walls() -> None:
    arc = circle(3.0, 72)[:19]
    ring = np.vstack([[[0.0, 0.0]], arc])
    chords = chords_of(ring)
    assert len(chords) > 20
    assert np.hypot(chords[:, 0], chords[:, 1]) == pytest.approx(3.0)


def test_nothing_hangs_on_a_long_chord() -> None:
    ring = circle(2.4, 72)
    edges = np.hstack([ring, np.roll(ring, -1, 0)])
    chords = chords_of(ring)
    kept = true_walls(np.vstack([edges, chords]), edges)
    assert len(edges) < len(kept) < len(edges) + len(chords)
    assert np.hypot(*(kept[:, 2:] - kept[:, :2]).T).max() < 0.8


def test_a_round_living_room_has_its_television_and_table() -> None:
    arranged = sw.arrange(CASES / "f10_round_room.sh3d", seed=0)
    solution = arranged.solution
    kinds = {piece.category for piece in solution.pieces}
    assert {"tv", "tv_stand", "dining_table"} <= kinds
    assert kinds & SOFAS
    assert arranged.complete
    wall = shapely.LinearRing(solution.brief.rooms[0].outline)
    (stand,) = [piece for piece in solution.pieces if piece.category == "tv_stand"]
    back = np.array(stand.pose[:2]) - stand.size.depth / 2 * np.array(
        [np.cos(stand.pose.heading), np.sin(stand.pose.heading)]
    )
    assert wall.distance(shapely.Point(back)) < BEHIND + 0.03
