"""Pictures from above show a scene from the side on which it fills them and shows its fronts."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from scenewright.building.shell import shell
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.domains import plan_of
from scenewright.formats.png import INDOORS, TALLEST, WIDTH, _stage_scene
from scenewright.render.near_walls import KERB
from scenewright.render.stage import blocks_of
from scenewright.render.viewing_side import choose_turn

SHAPE = TALLEST / WIDTH
HOB, OVER = Size(0.6, 0.6, 0.9), Size(0.6, 0.35, 0.6)


def scene(width: float, depth: float, *pieces: Piece) -> Scene:
    outline = [[0, 0], [width, 0], [width, depth], [0, depth]]
    brief = Brief.model_validate({"rooms": [{"id": "room", "outline": outline}]})
    plan = plan_of(brief)
    walls, openings = shell(brief, plan.spaces)
    return Scene("home", plan.levels, plan.spaces, walls, openings, pieces)


def wardrobe(x: float, y: float, heading: float) -> Piece:
    pose, size = Pose(x, y, 0.0, heading), Size(2.0, 0.6, 2.1)
    return Piece(f"w{x}{y}", "wardrobe", "wardrobe", "room", pose, size)


def test_a_scene_as_wide_as_the_picture_is_seen_from_the_south():
    assert choose_turn(scene(8.0, 6.0), INDOORS.towards, SHAPE) == 0.0


def test_a_narrow_scene_is_turned_on_its_side():
    assert abs(choose_turn(scene(4.0, 12.0), INDOORS.towards, SHAPE)) == pytest.approx(np.pi / 2)


def test_wardrobes_are_seen_from_the_front():
    north, south = wardrobe(3.0, 0.4, np.pi / 2), wardrobe(3.0, 5.6, -np.pi / 2)
    assert choose_turn(scene(8.0, 6.0, south), INDOORS.towards, SHAPE) == 0.0
    assert choose_turn(scene(8.0, 6.0, north), INDOORS.towards, SHAPE) == pytest.approx(np.pi)


@pytest.mark.parametrize(("width", "depth"), [(3.3, 9.0), (3.0, 4.2), (9.0, 3.3)])
@pytest.mark.parametrize("heading", [0.0, np.pi / 2, np.pi, -np.pi / 2])
def test_no_home_is_shown_upright_whatever_its_fronts(
    width: float, depth: float, heading: float
) -> None:
    """However its wardrobes stand, the long side lies across a picture a thousand pixels wide."""
    both = (wardrobe(1.5, 2.0, heading), wardrobe(1.5, 3.0, heading + np.pi))
    home = scene(width, depth, *both)
    shape = _stage_scene(home, shipped(), INDOORS)[2]
    assert min(WIDTH, round(TALLEST / shape)) >= 1000


@pytest.mark.parametrize("turn", [0.0, np.pi / 2, -np.pi / 2, np.pi])
def test_a_turned_scene_is_the_same_scene(turn: float):
    """Distances between corners stay; what was east is where the turn takes it."""
    whole = scene(5.0, 3.0, wardrobe(1.5, 0.4, np.pi / 2))
    plain, turned = (blocks_of(whole, shipped(), None, None, t) for t in (0.0, turn))
    cos, sin = np.cos(turn), np.sin(turn)
    for one, other in zip(plain, turned, strict=True):
        x, y = one.vertices[:, 0], one.vertices[:, 1]
        expected = np.column_stack([cos * x - sin * y, sin * x + cos * y, one.vertices[:, 2]])
        np.testing.assert_allclose(other.vertices, expected, atol=1e-9)


def test_levels_stand_side_by_side_however_they_are_turned():
    brief = Brief.model_validate(
        {
            "levels": [{"id": "0"}, {"id": "1", "elevation": 2.8}],
            "rooms": [
                {"id": name, "level": level, "outline": [[0, 0], [4, 0], [4, 12], [0, 12]]}
                for name, level in (("a", "0"), ("b", "1"))
            ],
        }
    )
    plan = plan_of(brief)
    walls, openings = shell(brief, plan.spaces)
    house = Scene("home", plan.levels, plan.spaces, walls, openings, ())
    blocks = blocks_of(house, shipped(), 2.0, INDOORS.towards, np.pi / 2)
    spans = sorted({(round(b.vertices[:, 0].min()), round(b.vertices[:, 0].max())) for b in blocks})
    assert max(low for low, _ in spans) > min(high for _, high in spans)
    assert any(low - high > 1.0 for (_, high), (low, _) in pairwise(spans))


def test_curtains_of_lowered_walls_are_left_out():
    pose, size = Pose(2.5, 0.1, 0.0, np.pi / 2), Size(1.2, 0.12, 2.4)
    near = Piece("near", "curtain", "curtain", "room", pose, size)
    far = Piece("far", "curtain", "curtain", "room", Pose(2.5, 2.9, 0.0, -np.pi / 2), size)
    shown = blocks_of(scene(5.0, 3.0, near, far), shipped(), 2.0, INDOORS.towards)
    hung = [block for block in shown if block.category == "curtain"]
    assert hung
    assert min(block.vertices[:, 1].min() for block in hung) > 2.0


@pytest.mark.parametrize("turn", [np.pi / 2, -np.pi / 2, np.pi])
def test_the_wall_before_the_eye_is_low_from_every_side(turn: float):
    blocks = blocks_of(scene(6.0, 3.0), shipped(), 2.0, INDOORS.towards, turn)
    points = np.vstack([block.vertices for block in blocks])
    near = points[points[:, 1] < points[:, 1].min() + 0.05]
    far = points[points[:, 1] > points[:, 1].max() - 0.05]
    assert np.isclose(near[:, 2], KERB).any()
    assert not np.isclose(far[:, 2], KERB).any()


def test_what_hangs_over_a_worktop_is_drawn_whole_or_not_at_all():
    """Wall units that are seen from above only would hide the hob below them."""

    def kitchen(y: float, heading: float) -> list[str]:
        low = Piece("u", "hob_cabinet", "hob_cabinet", "room", Pose(3, y, 0.0, heading), HOB)
        high = Piece("o", "wall_cabinet", "wall_cabinet", "room", Pose(3, y, 1.4, heading), OVER)
        blocks = blocks_of(scene(6.0, 3.0, low, high), shipped(), 2.0, INDOORS.towards)
        assert all(b.material.opacity == 1.0 for b in blocks if b.category == "wall_cabinet")
        return sorted({b.category for b in blocks} & {"hob_cabinet", "wall_cabinet"})

    assert kitchen(2.7, -np.pi / 2) == ["hob_cabinet", "wall_cabinet"]
    assert kitchen(0.3, np.pi / 2) == ["hob_cabinet"]


def floor_in(home: Scene, *functions: str) -> str:
    """The floor of its only room, if that is for ``functions``."""
    used = replace(home, spaces=tuple(replace(s, functions=functions) for s in home.spaces))
    (room,) = (b for b in blocks_of(used, shipped()) if b.category == "space")
    return room.material.name


def test_oak_lies_where_a_bed_stands():
    pose, size = Pose(2.0, 1.5, 0.0, 0.0), Size(1.6, 2.0, 0.5)
    bed = Piece("bed", "double_bed", "", "room", pose, size)
    assert floor_in(scene(5.0, 3.0), "bathroom") == "tile floor"
    assert floor_in(scene(5.0, 3.0, bed), "bathroom") == "oak floor"
    assert floor_in(scene(5.0, 3.0), "kitchen", "bedroom", "hall") == "oak floor"


def test_a_cubby_of_unknown_use_has_a_plain_floor_and_a_hall_has_not():
    assert floor_in(scene(1.5, 1.4), "other") == "screed floor"
    assert floor_in(scene(30.0, 20.0), "other") == "oak floor"
