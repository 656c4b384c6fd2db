"""Geometry of rooms and openings: what comes out is clean, and does not depend on the drawing."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from scenewright.building.outlines import edges, polygon, ring, rings, shrink, signed_area
from scenewright.building.plan import levels, spaces
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.space import Opening, Points, Space


def brief(*rooms: dict[str, Any], **more: Any) -> Brief:
    return Brief.model_validate({"rooms": list(rooms)} | more)


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


@st.composite
def stars(draw: st.DrawFn) -> Points:
    """Simple outlines of 3 to 12 corners around a point, convex or not, in either direction."""
    count = draw(st.integers(3, 12))
    parts = np.array(draw(st.lists(st.floats(0.4, 1.0), min_size=count, max_size=count)))
    radii = np.array(draw(st.lists(st.floats(1.5, 6.0), min_size=count, max_size=count)))
    angles = np.cumsum(parts) / parts.sum() * 2 * np.pi
    corners = radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    corners = np.roll(corners, draw(st.integers(0, count - 1)), axis=0)
    return corners[::-1] if draw(st.booleans()) else corners


@given(stars(), st.data())
def test_rings_are_clean_and_keep_their_area(corners: Points, data: st.DataObject) -> None:
    clean = ring(corners)
    assert signed_area(clean) == pytest.approx(abs(signed_area(corners)), rel=1e-6)
    noisy = []
    for first, second in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        noisy += [first] * data.draw(st.integers(1, 3))
        noisy += [first + t * (second - first) for t in data.draw(st.sampled_from([[], [0.5]]))]
    again = ring(np.array([*noisy, noisy[0]]))
    assert (
        shapely.Polygon(again).equals_exact(shapely.Polygon(clean), 1e-9)
        or shapely.Polygon(again).symmetric_difference(shapely.Polygon(clean)).area < 1e-3
    )
    assert len(again) <= len(clean)
    assert signed_area(ring(corners, clockwise=True)) < 0


def test_straight_points_go_and_curves_stay() -> None:
    angle = np.linspace(0, np.pi, 200)
    arc = np.column_stack([4 * np.cos(angle), 4 * np.sin(angle)])
    assert len(ring(arc)) == 200
    line = np.column_stack([np.linspace(0, 3, 50), np.zeros(50)])
    assert len(ring(np.vstack([line, [[3, 2], [0, 2]]]))) == 4


@given(stars(), st.floats(0.02, 0.3))
def test_shrinking_keeps_half_a_wall_away(corners: Points, by: float) -> None:
    floor = polygon(corners.tolist())
    try:
        inner = shrink(floor, by)
    except InputError:
        assert floor.buffer(-by).area < 0.5
        return
    assert floor.covers(inner)
    assert inner.distance(floor.exterior) == pytest.approx(by, abs=1e-6)


def test_shrinking_is_mitred_and_drops_what_falls_off() -> None:
    inner = shrink(polygon(box(0, 0, 4, 3)), 0.1)
    assert inner.bounds == pytest.approx((0.1, 0.1, 3.9, 2.9))
    assert inner.area == pytest.approx(3.8 * 2.8)
    dumbbell = [
        (0, 0),
        (3, 0),
        (3, 1),
        (5, 1),
        (5, 0),
        (6, 0),
        (6, 2),
        (5, 2),
        (5, 1.1),
        (3, 1.1),
        (3, 3),
        (0, 3),
    ]
    assert shrink(polygon(dumbbell), 0.06).bounds == pytest.approx((0.06, 0.06, 2.94, 2.94))


def test_holes_run_clockwise_and_columns_in_the_wall_are_cut_off() -> None:
    outline, holes = rings(polygon(box(0, 0, 6, 4), [box(2, 1, 3, 2), box(5.8, 1, 6.2, 2)]))
    assert signed_area(holes[0]) == pytest.approx(-1)
    assert len(outline) == 8
    assert signed_area(outline) == pytest.approx(24 - 0.2)


@pytest.mark.parametrize("turned", [False, True])
def test_main_wall_is_found_again(turned: bool) -> None:
    outline = [[0, 0], [2, 0], [5, 0], [5, 4], [0, 4], [0, 2]]
    listed = outline[::-1] if turned else outline
    for index in range(len(listed)):
        room = {"outline": listed, "main_wall": index}
        space = spaces(brief(room))[0]
        assert space.main_wall is not None
        x0, y0, x1, y1 = edges(space.outline)[space.main_wall]
        middle = np.add(listed[index], listed[(index + 1) % len(listed)]) / 2
        line = shapely.LineString([(x0, y0), (x1, y1)])
        assert line.distance(shapely.Point(middle)) < 1e-9


def two_rooms(**door: Any) -> tuple[Space, ...]:
    """A west room A (4 m wide) and an east room B, a wall of 0.1 m between."""
    a = {"id": "a", "outline": box(0, 0, 4, 3), "doors": [{"at": [4, 1], "width": 0.8} | door]}
    return spaces(brief(a, {"id": "b", "outline": box(4.1, 0, 8, 3)}))


def leaf_end(opening: Opening) -> Points:
    """Where the free end of the leaf is when the door stands open."""
    along, left = np.array([opening.ux, opening.uy]), np.array([-opening.uy, opening.ux])
    hinge = np.array([opening.x, opening.y]) + opening.hinge * along * opening.width / 2
    return hinge + opening.swing * left * (opening.width + opening.thickness / 2)


def test_one_opening_is_shared_by_both_rooms() -> None:
    a, b = two_rooms()
    assert a.openings[0] is b.openings[0]
    door = a.openings[0]
    assert (door.x, door.y, door.thickness) == pytest.approx((4.05, 1.0, 0.1))
    assert door.spaces == ("a", "b")
    assert (-door.uy, door.ux) == pytest.approx((-1, 0))


@pytest.mark.parametrize(
    ("hinge", "swing", "end"),
    [
        ("left", "in", (3.2, 1.4)),
        ("right", "in", (3.2, 0.6)),
        ("left", "out", (4.9, 1.4)),
        ("right", "out", (4.9, 0.6)),
    ],
)
def test_hinge_and_swing_as_seen_from_inside(
    hinge: str, swing: str, end: tuple[float, float]
) -> None:
    """From room A one looks east at the door: left is north."""
    door = two_rooms(hinge=hinge, swing=swing)[0].openings[0]
    assert leaf_end(door) == pytest.approx(end)


def test_doors_without_a_leaf() -> None:
    slide, passage = two_rooms(swing="slide")[0].openings[0], two_rooms(swing="none")[0].openings[0]
    assert (slide.kind, slide.hinge, slide.swing) == ("door", 0, 0)
    assert passage.kind == "passage"


def test_a_door_listed_in_both_rooms_is_one() -> None:
    a = {"id": "a", "outline": box(0, 0, 4, 3), "doors": [{"at": [4, 1.0], "hinge": "left"}]}
    b = {"id": "b", "outline": box(4.1, 0, 8, 3), "doors": [{"at": [4.1, 1.1], "hinge": "right"}]}
    first, second = spaces(brief(a, b))
    assert len(first.openings) == len(second.openings) == 1
    assert first.openings[0].hinge == 1


def test_an_opening_slides_and_narrows_a_little_to_fit() -> None:
    window = {"at": [0.5, 0], "width": 1.2}
    found = spaces(brief({"outline": box(0, 0, 4, 3), "windows": [window]}))[0].openings[0]
    assert (found.x, found.width, found.thickness) == pytest.approx((0.6, 1.2, 0.25))
    door = {"at": [0.5, 0.1], "width": 1.05}
    found = spaces(brief({"outline": box(0, 0, 1, 3), "doors": [door]}))[0].openings[0]
    assert (found.x, found.width) == pytest.approx((0.5, 1.0))


def test_a_window_on_a_curved_wall_lies_on_its_chord() -> None:
    angle = np.linspace(-np.pi / 2, np.pi / 2, 31)
    bow = np.column_stack([5 + 2 * np.cos(angle), 2 + 2 * np.sin(angle)])
    window = {"at": [7, 2], "width": 1.2}
    room = {"outline": [[0, 0], *bow.tolist(), [0, 4]], "windows": [window]}
    found = spaces(brief(room))[0].openings[0]
    assert (found.ux, found.uy) == pytest.approx((0, 1), abs=1e-6)
    assert found.y == pytest.approx(2)
    chord = 5 + 2 * math.cos(math.asin(found.width / 2 / 2))
    assert found.x == pytest.approx(chord + 0.125, abs=0.005)


def test_centre_lines_leave_a_wall_between_rooms() -> None:
    a = {"id": "a", "outline": box(0, 0, 4, 3), "doors": [{"at": [4, 1]}]}
    found = spaces(
        brief(a, {"id": "b", "outline": box(4, 0, 8, 3)}, outlines="centre", wall_thickness=0.2)
    )
    assert found[0].outline.max(0) == pytest.approx((3.9, 2.9))
    assert found[0].openings[0].x == pytest.approx(4.0)
    assert found[0].openings[0].thickness == pytest.approx(0.2)


@given(st.floats(0, 2 * np.pi), st.floats(-50, 50), st.sampled_from(["left", "right"]))
def test_turning_the_plan_turns_the_openings(turn: float, shift: float, hinge: str) -> None:
    c, s = math.cos(turn), math.sin(turn)

    def move(point: Any) -> list[float]:
        return [c * point[0] - s * point[1] + shift, s * point[0] + c * point[1]]

    def plan(put: Any) -> Opening:
        door = {"at": put([4, 1]), "width": 0.8, "hinge": hinge}
        a = {"id": "a", "outline": [put(p) for p in box(0, 0, 4, 3)], "doors": [door]}
        return spaces(brief(a, {"outline": [put(p) for p in box(4.1, 0, 8, 3)]}))[0].openings[0]

    still, moved = plan(list), plan(move)
    assert move((still.x, still.y)) == pytest.approx((moved.x, moved.y), abs=1e-6)
    assert move(leaf_end(still)) == pytest.approx(leaf_end(moved), abs=1e-6)


def test_levels_and_heights() -> None:
    room = {"outline": box(0, 0, 3, 3)}
    assert [level.height for level in levels(brief(room))] == [2.6]
    low, high = {"id": "u", "height": 2.2}, {"id": "o", "height": 3.0, "elevation": 2.5}
    found = spaces(brief(room | {"level": "o"}, room | {"height": 2.0}, levels=[low, high]))
    assert [space.height for space in found] == [3.0, 2.0]
    assert [space.level for space in found] == ["o", "u"]


@pytest.mark.parametrize(
    ("room", "level", "place"),
    [
        ({"height": 0.5}, {}, r"rooms\[0\] 'room-1': "),
        ({}, {"height": 0.99}, r"rooms\[0\] 'room-1', level 'u': "),
    ],
)
def test_a_room_too_low_to_stand_in_is_refused(
    room: dict[str, Any], level: dict[str, Any], place: str
) -> None:
    listed = [{"id": "u"} | level]
    with pytest.raises(InputError, match=rf"^{place}.* m high.*at least 1 \(metres\)"):
        spaces(brief({"outline": box(0, 0, 3, 3)} | room, levels=listed))


def test_a_low_level_without_rooms_is_no_fault() -> None:
    listed = [{"id": "u"}, {"id": "crawl", "height": 0.4}]
    assert len(spaces(brief({"outline": box(0, 0, 3, 3)}, levels=listed))) == 1


def test_rooms_of_two_levels_may_lie_over_each_other() -> None:
    room = {"outline": box(0, 0, 3, 3)}
    two = [{"id": "0"}, {"id": "1", "elevation": 3}]
    assert len(spaces(brief(room, room | {"level": "1"}, levels=two))) == 2
