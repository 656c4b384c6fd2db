"""Walls before a room are lowered in pictures: nothing on the floor is hidden by an outer wall."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scenewright.building.shell import shell
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Scene
from scenewright.domains import plan_of
from scenewright.formats.png import INDOORS, frame_points
from scenewright.render.items import things
from scenewright.render.near_walls import KERB, RAIL, find_near_walls
from scenewright.render.picture import view_of

BRIEF = Brief.model_validate(
    {
        "rooms": [
            {
                "id": "south",
                "outline": [[0, 0], [5, 0], [5, 3], [0, 3]],
                "windows": [{"at": [2.5, 0], "width": 1.2}],
            },
            {"id": "north", "outline": [[0, 3.12], [5, 3.12], [5, 7], [0, 7]]},
        ]
    }
)


@pytest.fixture(scope="module")
def scene() -> Scene:
    plan = plan_of(BRIEF)
    walls, openings = shell(BRIEF, plan.spaces)
    return Scene("home", plan.levels, plan.spaces, walls, openings, ())


def test_outer_walls_are_kerbs_walls_between_rooms_are_rails(scene: Scene) -> None:
    near = find_near_walls(scene, scene.levels[0].id, INDOORS.towards)
    assert near.top_at(2.5, -0.1, 2.0) == KERB
    assert near.top_at(2.5, 3.06, 2.0) == RAIL
    assert near.top_at(2.5, 7.1, 2.0) == 2.0
    assert near.top_at(-0.1, 1.5, 2.0) == 2.0
    floors = [shapely.Polygon(space.outline) for space in scene.spaces]
    for region, _ in near.parts:
        assert all(region.intersection(floor).area < 1e-3 for floor in floors)


def test_looking_the_other_way_lowers_the_other_walls(scene: Scene) -> None:
    x, y, z = INDOORS.towards
    near = find_near_walls(scene, scene.levels[0].id, (x, -y, z))
    assert near.top_at(2.5, 7.1, 2.0) == KERB
    assert near.top_at(2.5, -0.1, 2.0) == 2.0


def test_walls_windows_and_masonry_are_cut_there_and_only_there(scene: Scene) -> None:
    for towards, low in ((None, 2.0), (INDOORS.towards, KERB)):
        shown = things(scene, shipped(), 2.0, towards)
        walls = np.concatenate([p.vertices for t in shown if t.kind == "wall" for p in t.parts])
        before = walls[(walls[:, 1] < -0.01) & (abs(walls[:, 0] - 2.5) < 2.0)]
        assert before[:, 2].max() <= low + 1e-9
        assert walls[walls[:, 1] > 7.01][:, 2].max() == pytest.approx(2.0)
        windows = [t for t in shown if t.kind == "opening" and t.parts]
        assert bool(windows) == (towards is None), "the sill is above the kerb"


def test_a_picture_without_a_cut_shows_whole_walls(scene: Scene) -> None:
    shown = things(scene, shipped(), None, INDOORS.towards)
    assert max(p.vertices[:, 2].max() for t in shown if t.kind == "wall" for p in t.parts) > 2.5


def test_tall_homes_fill_a_narrow_picture() -> None:
    points = np.array(list(np.ndindex(2, 2, 2)), float) * [6.0, 18.0, 2.0]
    camera, shape = frame_points(points)
    view = view_of(camera, 600, round(600 * shape))
    away = (points - np.array(camera.eye)) @ view.axes.T.astype(float)
    x, y = away[:, 0] / away[:, 2] / view.across, away[:, 1] / away[:, 2] / view.across
    assert 1.2 < shape < 2.5
    assert 0.85 < np.abs(x).max() < 1.0
    assert 0.85 * shape < np.abs(y).max() < shape
