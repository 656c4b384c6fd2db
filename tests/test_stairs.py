"""Stairs: their geometry, what they take of both floors, how they are judged and drawn."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from scenewright import formats
from scenewright.building.plan import levels, spaces
from scenewright.building.stair_parts import flight_parts, railing_lines, well_of
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.brief.stairs import StairsBrief
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.scene import STAIRS, Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.stairs import Stairs, build_stairs
from scenewright.domains import check, resolve, scene_of
from scenewright.domains.home import solving as home
from scenewright.drawing import rooms
from scenewright.drawing.svg import write_svg
from scenewright.formats import solution_json
from scenewright.render.items import things

SHAPES = ("straight", "quarter", "half", "spiral")
HEIGHT = 2.9


def made(
    shape: str,
    turn: str = "left",
    heading: float = pi / 2,
    at: tuple[float, float] = (0.0, 0.0),
    **more: Any,
) -> Stairs:
    asked = StairsBrief.model_validate(
        {"at": at, "heading": heading, "shape": shape, "turn": turn} | more
    )
    return build_stairs(asked, "s", "0", "1", HEIGHT)


def outlines(stairs: Stairs) -> list[shapely.Polygon]:
    return [shapely.Polygon(tread.outline) for tread in stairs.treads]


@pytest.mark.parametrize("turn", ["left", "right"])
@pytest.mark.parametrize("shape", SHAPES)
def test_treads_rise_evenly_side_by_side_on_the_floor_that_is_taken(shape: str, turn: str) -> None:
    stairs = made(shape, turn, 0.7, (2.0, 1.0))
    assert stairs.rises == 17
    assert stairs.rise * stairs.rises == pytest.approx(HEIGHT)
    assert [t.height for t in stairs.treads] == pytest.approx(
        [stairs.rise * k for k in range(1, 17)]
    )
    treads = outlines(stairs)
    assert all(shapely.is_ccw(t.exterior) for t in treads)
    whole = shapely.union_all(treads)
    assert whole.area == pytest.approx(sum(t.area for t in treads), rel=1e-6)
    assert whole.buffer(1e-6).geom_type == "Polygon"
    for lower, upper in zip(stairs.treads, stairs.treads[1:], strict=False):
        nosing = shapely.LineString(upper.outline[:2])
        assert shapely.Polygon(lower.outline).distance(nosing) < 1e-6
    boxes = [shapely.Polygon(corners(np.array([box]))[0]) for box in stairs.taken]
    assert shapely.union_all(boxes).buffer(1e-6).covers(whole)
    assert sum(box.area for box in boxes) == pytest.approx(shapely.union_all(boxes).area)
    assert shapely.Point(stairs.head[:2]).distance(treads[-1]) < 1e-6
    assert shapely.Point(stairs.foot[:2]).distance(treads[0]) < 1e-6
    off = shapely.Point(
        np.array(stairs.head[:2])
        + 0.2 * np.array([np.cos(stairs.head.heading), np.sin(stairs.head.heading)])
    )
    assert not well_of(stairs).covers(off)


@pytest.mark.parametrize("shape", SHAPES)
def test_stairs_turn_and_mirror(shape: str) -> None:
    """A right turn is the left one in the mirror; a heading turns all about the foot."""
    left, right = made(shape, "left"), made(shape, "right")
    if shape != "straight":
        for one, other in zip(outlines(left), outlines(right), strict=True):
            assert shapely.transform(one, lambda p: p * (-1, 1)).symmetric_difference(
                other
            ).area == pytest.approx(0.0, abs=1e-9)
        assert right.head[:2] == pytest.approx((-left.head.x, left.head.y))
        assert np.cos(right.head.heading) == pytest.approx(-np.cos(left.head.heading), abs=1e-9)
    turned = made(shape, "left", pi / 2 + 0.4)
    c, s = np.cos(0.4), np.sin(0.4)
    for one, other in zip(left.treads, turned.treads, strict=True):
        assert one.outline @ np.array([[c, s], [-s, c]]) == pytest.approx(other.outline)
    assert turned.head.heading - left.head.heading == pytest.approx(0.4)


def test_steps_are_comfortable_unless_said() -> None:
    stairs = made("straight")
    assert 2 * stairs.rise + stairs.going == pytest.approx(0.63)
    steep = made("straight", going=0.2)
    assert steep.head.y == pytest.approx(16 * 0.2)
    well = well_of(steep)
    assert well.bounds[1] == pytest.approx(3 * 0.2, abs=2e-3), "2 m below the floor need no well"


def house(**more: Any) -> dict[str, Any]:
    """Two floors of one room each; on the upper one a bedroom beside the landing."""
    return {
        "levels": [{"id": "0", "height": 2.6}, {"id": "1", "elevation": HEIGHT, "height": 2.5}],
        "stairs": [{"at": [0.6, 1.2], "heading": pi / 2, "going": 0.22}],
        "rooms": [
            {
                "id": "hall",
                "function": "hall",
                "level": "0",
                "doors": [{"at": [3.0, 0.0]}],
                "outline": [[0, 0], [4, 0], [4, 6.5], [0, 6.5]],
            },
            {
                "id": "landing",
                "function": "hall",
                "level": "1",
                "outline": [[0, 0], [4, 0], [4, 6.5], [0, 6.5]],
            },
            {
                "id": "bed",
                "function": "double_bedroom",
                "level": "1",
                "outline": [[4.12, 0], [8.2, 0], [8.2, 4], [4.12, 4]],
                "doors": [{"at": [4.12, 3.0], "to": "landing"}],
            },
        ],
    } | more


def brief(**more: Any) -> Brief:
    return Brief.model_validate(house(**more))


def test_both_floors_know_of_the_stairs() -> None:
    hall, landing, bed = spaces(brief())
    (foot,), (head,) = hall.stairs, landing.stairs
    assert (foot.kind, foot.arrival) == ("foot", False)
    assert (head.kind, head.arrival) == ("head", True)
    assert head[2:4] == pytest.approx((0.6, 1.2 + 16 * 0.22))
    assert [part.id for part in hall.stair_parts] == ["stairs"]
    assert [part.id for part in landing.stair_parts] == ["stairs/well"]
    assert landing.stair_parts[0].box[4] == pytest.approx(13 * 0.22)
    assert not bed.stairs
    assert not bed.stair_parts


def test_in_a_basement_one_arrives_at_the_foot() -> None:
    down = [{"id": "0", "height": 2.3, "elevation": -2.7}, {"id": "1", "elevation": 0.0}]
    rooms = house()["rooms"]
    rooms[1]["doors"], rooms[0]["doors"] = rooms[0]["doors"], []
    cellar, ground, _ = spaces(brief(levels=down, rooms=rooms))
    assert cellar.stairs[0].arrival
    assert not ground.stairs[0].arrival


@pytest.mark.parametrize(
    ("stairs", "told"),
    [
        ({"to": "9"}, "the level '9' does not exist; use one of: 0, 1"),
        ({"level": "1", "to": "0"}, "the level '0' is -2.90 m above '1'"),
        ({"level": "1"}, "there is no level above '1'"),
        ({"at": [0.6, 9.0]}, "the foot at (0.60, 9.00) leads into no room of the level '0'"),
        ({"at": [0.6, 4.0]}, "the head at (0.60, 7.52) leads into no room of the level '1'"),
        ({"at": [1e9, 0]}, "stairs[0]"),
        ({"shape": "ladder"}, "stairs[0]"),
        ({"width": 0.0}, "stairs[0]"),
    ],
)
def test_what_cannot_be_built_is_told(tmp_path: Path, stairs: dict[str, Any], told: str) -> None:
    text = json.dumps(house(stairs=[house()["stairs"][0] | stairs]))
    (tmp_path / "house.json").write_text(text)
    with pytest.raises(InputError) as caught:
        spaces(formats.read(tmp_path / "house.json"))
    assert told in str(caught.value)
    assert "stairs[0]" in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.fixture(scope="module")
def furnished() -> Solution:
    return home.solve(brief(), steps=2000, seed=3)


def test_a_house_with_stairs_is_furnished_round_them(furnished: Solution) -> None:
    report = check(furnished)
    assert report.valid
    assert report.figures["reachable_share"] == {"0": 1.0, "1": 1.0}
    assert not any("stairs" in note.missing for note in report.notes)
    assert [p.id for p in furnished.pieces if p.function == STAIRS] == ["stairs", "stairs/well"]


def piece(category: str, space: str, x: float, y: float, w: float, d: float) -> Piece:
    return Piece(f"{space}/{category}", category, "", space, Pose(x, y, 0, pi / 2), Size(w, d, 1.8))


def with_piece(solution: Solution, *more: Piece) -> Solution:
    stays = tuple(p for p in solution.pieces if p.function == STAIRS)
    return replace(solution, pieces=(*stays, *more))


def test_the_referee_keeps_foot_head_and_well_free(furnished: Solution) -> None:
    assert {f.kind for f in check(with_piece(furnished)).findings} == {"missing"}
    cases = (
        (piece("chest_of_drawers", "hall", 0.7, 0.8, 0.8, 0.4), "blocked_stairs", "foot"),
        (piece("chest_of_drawers", "landing", 0.7, 5.1, 0.8, 0.4), "blocked_stairs", "head"),
        (piece("wardrobe", "landing", 0.6, 3.0, 0.8, 0.6), "collision", "stairs/well"),
    )
    for thing, kind, told in cases:
        report = check(with_piece(furnished, thing))
        assert not report.valid
        assert any(told in found.message for found in report.of(kind)), report.findings
    beyond = piece("chest_of_drawers", "landing", 0.7, 6.2, 0.8, 0.4)
    assert not check(with_piece(furnished, beyond)).of("blocked_stairs")


def test_upstairs_one_comes_from_the_head(furnished: Solution) -> None:
    """A row of shelves between the head and the bedroom cuts it off, though the bedroom has a door
    to the outside; on the ground floor one still comes by the door."""
    rooms = house()["rooms"]
    rooms[2]["doors"].append({"id": "roof", "at": [6.0, 0.0], "swing": "out"})
    own = replace(with_piece(furnished), brief=brief(rooms=rooms))
    assert {f.kind for f in check(own).findings} == {"missing"}
    across = piece("bookcase", "landing", 2.6, 3.9, 2.8, 0.3)
    beside = Piece("landing/box", "bookcase", "", "landing", Pose(1.3, 4.4, 0, 0), Size(1, 0.3, 2))
    report = check(replace(own, pieces=(*own.pieces, across, beside)))
    assert "unreachable_room" in {found.kind for found in report.findings}


def test_a_level_without_stairs_is_noted(furnished: Solution) -> None:
    bare = replace(furnished, brief=brief(stairs=[]), pieces=())
    notes = [note.message for note in check(bare).notes if note.missing == "stairs"]
    assert notes == ["no stairs lead to the level 1"]


def test_the_referee_knows_of_stairs_that_no_piece_stands_for(furnished: Solution) -> None:
    for thing in (
        piece("chest_of_drawers", "hall", 0.6, 3.0, 0.8, 0.4),
        piece("wardrobe", "landing", 0.6, 3.0, 0.8, 0.6),
    ):
        report = check(replace(furnished, pieces=(thing,)))
        (found,) = report.of("collision")
        assert {found.piece, found.other} & {"stairs", "stairs/well"}
        missing = {found.piece for found in report.of("changed_given")}
        assert missing == {"stairs", "stairs/well"}
    beside = piece("wardrobe", "landing", 1.5, 3.0, 0.8, 0.6)
    assert not check(replace(furnished, pieces=(beside,))).of("collision")


def storeys(**more: Any) -> dict[str, Any]:
    """The house with a second upper floor over the first."""
    rooms = house()["rooms"]
    top = rooms[1] | {"id": "top", "level": "2"}
    third = {"id": "2", "elevation": 2 * HEIGHT, "height": 2.5}
    return house(levels=[*house()["levels"], third], rooms=[*rooms, top]) | more


def test_stairs_do_not_say_that_the_level_above_theirs_is_reached() -> None:
    solved = home.solve(Brief.model_validate(storeys()), steps=50)
    notes = [note.message for note in check(solved).notes if note.missing == "stairs"]
    assert notes == ["no stairs lead to the level 2"]


def test_stairs_go_through_no_room_of_a_level_between() -> None:
    long = [house()["stairs"][0] | {"to": "2", "at": [0.6, 0.8], "going": 0.15}]
    with pytest.raises(InputError, match="goes through 'landing' of the level '1'"):
        spaces(Brief.model_validate(storeys(stairs=long)))
    rooms = storeys()["rooms"]
    rooms[1]["outline"] = [[1.2, 0], [4, 0], [4, 6.5], [1.2, 6.5]]
    around = spaces(Brief.model_validate(storeys(stairs=long, rooms=rooms)))
    assert [space.id for space in around if space.stairs] == ["hall", "top"]


def test_a_well_over_two_rooms_is_kept_free_in_both() -> None:
    rooms = house()["rooms"]
    rooms[1]["outline"] = [[0, 3.4], [4, 3.4], [4, 6.5], [0, 6.5]]
    rooms[2] |= {
        "outline": [[0, 0], [4, 0], [4, 3.28], [0, 3.28]],
        "doors": [{"at": [3.0, 3.28], "to": "landing"}],
    }
    _, landing, bed = spaces(brief(rooms=rooms))
    (own,), (other,) = landing.stair_parts, bed.stair_parts
    assert (own.id, own.category) == ("stairs/well", "staircase")
    assert other.category == "obstacle"
    well = (1.2 + 3 * 0.22, 1.2 + 16 * 0.22)
    assert (own.box[1] - own.box[4] / 2, own.box[1] + own.box[4] / 2) == pytest.approx(
        (3.4, well[1])
    )
    assert (other.box[1] - other.box[4] / 2, other.box[1] + other.box[4] / 2) == pytest.approx(
        (well[0], 3.28)
    )


def test_a_room_that_is_all_well_has_no_floor() -> None:
    rooms = house()["rooms"]
    shaft = {
        "id": "void",
        "function": "other",
        "level": "1",
        "outline": [[0.15, 1.87], [1.05, 1.87], [1.05, 4.72], [0.15, 4.72]],
    }
    rooms[1]["outline"] = [[0, 4.84], [1.17, 4.84], [1.17, 0], [4, 0], [4, 6.5], [0, 6.5]]
    solved = home.solve(brief(rooms=[*rooms, shaft]), steps=50)
    floors = [t.name for t in things(scene_of(solved), catalog_of([])) if t.kind == "space"]
    assert floors == ["hall", "landing", "bed"]


def test_stairs_share_no_id_with_what_stands() -> None:
    rooms = house()["rooms"]
    rooms[0]["fixed"] = [
        {
            "id": "stairs",
            "category": "wardrobe",
            "at": [3.5, 5],
            "heading": 0.0,
            "size": [1.0, 0.6, 2.0],
        }
    ]
    with pytest.raises(InputError, match="the id 'stairs' is used twice"):
        spaces(brief(rooms=rooms))


def test_saved_homes_keep_their_stairs_once(furnished: Solution, tmp_path: Path) -> None:
    file = tmp_path / "home.json"
    solution_json.write(furnished, file)
    again = formats.read(file)
    assert len(again.stairs) == 1
    assert not any(item.category == "staircase" for room in again.rooms for item in room.fixed)
    second = home.solve(again, steps=300)
    assert [p.id for p in second.pieces if p.function == STAIRS] == ["stairs", "stairs/well"]
    with pytest.raises(InputError, match="of the building"):
        resolve(furnished, move={"stairs": (2.0, 3.0)})
    with pytest.raises(InputError, match="of the building"):
        resolve(furnished, swap=[("bed/wardrobe", "stairs")])


def test_they_are_drawn_on_both_plans(furnished: Solution) -> None:
    scene = scene_of(furnished)
    text = write_svg(rooms.plan(scene, catalog_of([])))
    told = "stairs: 17 rises of 17.1 cm, goings of 22.0 cm"
    assert text.count(f"<title>{told}</title>") == 2
    assert len(re.findall(r"stroke-dasharray=\"0\.9 0\.6\"", text)) == 9, "treads above the cut"


@pytest.mark.parametrize("shape", SHAPES)
def test_the_mesh_stays_over_the_floor_that_is_taken(shape: str) -> None:
    for turn in ("left", "right"):
        stairs = made(shape, turn, 1.0, (3.0, 3.0))
        boxes = [shapely.Polygon(corners(np.array([box]))[0]) for box in stairs.taken]
        room = shapely.union_all(boxes).buffer(0.11)
        for part in flight_parts(stairs):
            assert np.isfinite(part.vertices).all()
            assert shapely.contains_xy(room, *part.vertices[:, :2].T).all()
            assert part.vertices[:, 2].min() > -1e-9
            assert part.vertices[:, 2].max() < HEIGHT + 1.0


def test_the_upper_floor_is_open_over_the_stairs_and_railed(furnished: Solution) -> None:
    scene = scene_of(furnished)
    found = {thing.name: thing for thing in things(scene, catalog_of([]))}
    assert {"stairs", "stairs railing"} <= set(found)
    area = {}
    for name in ("hall", "landing"):
        part = found[name].parts[0]
        a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
        up = np.cross(b - a, c - a)[:, 2]
        area[name] = up[up > 0].sum() / 2
    well = well_of(scene.stairs[0]).area
    assert area["hall"] == pytest.approx(26.0)
    assert area["landing"] == pytest.approx(26.0 - well, abs=1e-3)
    floors = [shapely.Polygon(s.outline) for s in scene.spaces if s.level == "1"]
    rails = shapely.union_all(list(railing_lines(scene.stairs[0], floors)))
    head = shapely.Point(scene.stairs[0].head[:2])
    assert rails.distance(head) > 0.3, "nothing bars the head"
    assert rails.length == pytest.approx(2 * 13 * 0.22 + 0.9, abs=0.2)


def test_levels_of_the_sample_are_joined() -> None:
    sample = formats.read("sample:home-house")
    assert [s.level for s in spaces(sample) if s.stairs] == ["0", "1"]
    assert len(levels(sample)) == 2


def test_sites_have_no_stairs() -> None:
    site = {"outline": [[0, 0], [60, 0], [60, 40], [0, 40]]}
    stairs = [{"at": [1, 1], "heading": 0}]
    with pytest.raises(InputError, match="stairs: are given, but the brief is of a site"):
        spaces(Brief.model_validate({"domain": "site", "sites": [site], "stairs": stairs}))
