"""Walls before a room are lowered in pictures: nothing on the floor is hidden by an outer wall."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from scenewright.building.finishes import LID
from scenewright.building.shell import shell
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.space import Opening
from scenewright.domains import plan_of
from scenewright.formats.png import INDOORS, frame_points
from scenewright.render.items import things
from scenewright.render.near_walls import KERB, RAIL, NearWalls, cut_of_opening, find_near_walls
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


def shower_at(scene: Scene, y: float, heading: float) -> float:
    """The highest point of a shower in a picture."""
    pose, size = Pose(2.5, y, 0.0, heading), Size(0.9, 0.9, 2.0)
    stall = Piece("stall", "shower", "shower", "south", pose, size)
    shown = things(replace(scene, pieces=(stall,)), shipped(), 2.0, INDOORS.towards)
    return max(p.vertices[:, 2].max() for t in shown if t.name == "stall" for p in t.parts)


def test_a_shower_is_cut_with_the_lowest_wall_it_stands_at(scene: Scene) -> None:
    assert shower_at(scene, 2.55, -np.pi / 2) == pytest.approx(RAIL, abs=0.02)
    assert shower_at(scene, 0.45, np.pi / 2) == pytest.approx(KERB, abs=0.02)
    assert shower_at(scene, 0.45, 0.0) == pytest.approx(KERB, abs=0.02)
    assert shower_at(scene, 1.5, np.pi / 2) > 1.5


def test_a_shelf_at_a_lowered_wall_stays_under_what_stands_on_it(scene: Scene) -> None:
    shelf = Piece(
        *("shelf", "wall_shelf", "wall_shelf", "south"),
        *(Pose(1.0, 0.1, 0.55, np.pi / 2), Size(1.4, 0.16, 0.15)),
    )
    pose, size = Pose(1.0, 0.1, 0.7, np.pi / 2), Size(1.3, 0.12, 0.8)
    screen = Piece("screen", "tv", "tv", "south", pose, size, on="shelf")

    def list_drawn(*pieces: Piece) -> set[str]:
        shown = things(replace(scene, pieces=pieces), shipped(), INDOORS.cut, INDOORS.towards)
        return {thing.name for thing in shown} & {"shelf", "screen"}

    assert list_drawn(shelf) == set()
    assert list_drawn(shelf, screen) == {"shelf", "screen"}


def test_a_picture_at_a_lowered_wall_leaves_its_rail(scene: Scene) -> None:
    def measure_top(y: float, heading: float, asset: str = "wall_exhibit_painting_a") -> float:
        pose, size = Pose(1.0, y, 0.0, heading), Size(1.2, 0.4, 2.2)
        piece = Piece("art", "wall_exhibit", asset, "south", pose, size)
        shown = things(replace(scene, pieces=(piece,)), shipped(), INDOORS.cut, INDOORS.towards)
        (drawn,) = [thing for thing in shown if thing.name == "art"]
        return max(float(part.vertices[:, 2].max()) for part in drawn.parts)

    assert 0.4 < measure_top(0.21, np.pi / 2) < 0.5
    assert measure_top(6.79, -np.pi / 2) > 1.9
    assert measure_top(0.21, np.pi / 2, "wall_exhibit") > 1.9


@pytest.fixture(scope="module")
def shafted() -> Scene:
    """A room with a shaft before its south-west and one behind its north-west corner."""
    boxes = [("a", 0, 0, 5, 4), ("b", 0, -1.12, 1.5, -0.12), ("c", 0, 4.12, 1.5, 5.12)]
    rooms = [
        {"id": i, "name": "" if i == "a" else "shaft", "outline": [[x, y], [u, y], [u, v], [x, v]]}
        for i, x, y, u, v in boxes
    ]
    brief = Brief.model_validate({"rooms": rooms})
    plan = plan_of(brief)
    walls, openings = shell(brief, plan.spaces)
    return Scene("home", plan.levels, plan.spaces, walls, openings, ())


def test_shafts_are_closed_at_the_height_of_their_walls(shafted: Scene) -> None:
    shown = {t.name: t for t in things(shafted, shipped(), 2.0, INDOORS.towards)}
    (near,), (far,), (room,) = shown["b"].parts, shown["c"].parts, shown["a"].parts
    assert near.vertices[:, 2].max() == pytest.approx(RAIL)
    assert far.vertices[:, 2].max() == pytest.approx(2.0)
    assert near.material == far.material == LID != room.material
    high = np.concatenate([p.vertices for t in shown.values() if t.kind == "wall" for p in t.parts])
    round_near = high[(high[:, 0] < 1.6) & (high[:, 0] > -0.2) & (high[:, 1] < -0.2)]
    assert round_near[:, 2].max() <= RAIL + 1e-9, "the shaft is low all round"
    whole = {t.name: t for t in things(shafted, shipped())}
    assert whole["b"].parts[0].vertices[:, 2].max() == 0.0, "no lid in a model"


def test_an_opening_is_no_higher_than_the_wall_on_both_its_sides() -> None:
    low = NearWalls(((shapely.box(0, 0, 0.5, 1), KERB), (shapely.box(1.5, 0, 2, 1), RAIL)))
    door = Opening("d", "door", "0", 1.0, 0.5, 1, 0, 1.0, 0.1, 0, 2.05)
    assert cut_of_opening(door, low, 2.0) == RAIL
    assert cut_of_opening(replace(door, width=0.6), low, 2.0) == 2.0
    assert cut_of_opening(replace(door, x=0.75), low, 2.0) == 2.0, "one side is high"
