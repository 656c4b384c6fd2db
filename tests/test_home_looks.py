"""What a designer would see at once: backs at walls, the screen before the bed, a turned chair."""

from __future__ import annotations

import re
from math import cos, pi, remainder, sin

import numpy as np
import pytest
from benchmarks.home_axis import records

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Ask, Brief, Room
from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece, Size
from scenewright.domains.home import solving as home
from scenewright.domains.home.build_problem import RELATIONS, holds
from scenewright.domains.home.cases.library import cases, find_preferred_case
from scenewright.domains.home.furnishing.facing import face_screen
from scenewright.domains.home.furnishing.furnish import Refused, furnish_patch
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.grounds.ground import ground_of
from thoroughness import THOROUGH

EMPTY = StandingObstacles(np.zeros((0, 5)), np.zeros((0, 2)), ())


def one_room(wide: float, deep: float, function: str, *groups: str) -> Brief:
    room = Room.model_validate(
        {
            "id": "room",
            "function": function,
            "doors": [{"at": [0.6, 0.0], "width": 0.8}],
            "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
            "ask": [Ask(group=group) for group in groups],
        }
    )
    return Brief(rooms=[room])


@pytest.mark.parametrize("function", ["washer", "wardrobe", "kitchen"])
def test_what_belongs_to_a_wall_is_refused_in_the_open(function: str) -> None:
    space = spaces(one_room(8.0, 7.0, "living"))[0]
    ground = ground_of(space, (), 56.0)
    case = find_preferred_case(function, 10.0)

    def dressed(y: float) -> object:
        box = np.array([4.5, y, -pi / 2, case.width, case.depth])
        return furnish_patch(function, box, ground, EMPTY, shipped(), 2.6)

    assert not isinstance(dressed(7.0 - case.depth / 2 - 0.01), Refused)
    refused = dressed(3.5)
    assert isinstance(refused, Refused)
    assert re.fullmatch(r"no free wall of \d\.\d m to stand against", refused.reason)


def front(pieces: tuple[Piece, ...], kind: str, other: str) -> float:
    """How far a piece is off the front of another, radians."""
    one, seen = (next(p.pose for p in pieces if p.category == k) for k in (kind, other))
    way = float(np.arctan2(seen.y - one.y, seen.x - one.x))
    return abs(remainder(way - one.heading, 2 * pi))


@pytest.mark.parametrize("seed", range(3))
def test_a_screen_in_a_bedroom_is_seen_from_the_bed(seed: int) -> None:
    brief = one_room(4.4, 4.0, "bedroom", "sleeping", "wardrobe", "media")
    pieces = home.solve(brief, seed=seed, threads=1).pieces
    assert front(pieces, "double_bed", "tv") < 0.5
    assert front(pieces, "tv", "double_bed") < 0.5


def test_a_screen_is_for_the_seats_where_there_are_seats() -> None:
    tied = [r for r in RELATIONS if "media" in (r.first, r.second)]
    assert {r.first for r in tied if holds(r, ["media", "sleeping"])} == {"media", "sleeping"}
    both = [r for r in tied if holds(r, ["media", "sleeping", "seating"])]
    assert {r.first for r in both} == {"media", "seating"}


def test_a_reading_chair_turns_out_of_its_corner() -> None:
    """In a large room the chair looks away from the corner lamp; either corner has a case."""
    assert "turned out" in find_preferred_case("reading", 30.0).name
    turned = [case.members for case in cases("reading").groups if "turned out" in case.name]
    assert {np.sign(lamp.x) for _, lamp in turned} == {-1.0, 1.0}
    for chair, lamp in turned:
        ahead = np.array([-sin(chair.heading), cos(chair.heading)])
        assert ahead @ np.array([lamp.x - chair.x, lamp.y - chair.y]) < -0.4


@pytest.mark.parametrize("seed", range(4))
def test_a_seat_is_before_its_screen_in_a_narrow_room(seed: int) -> None:
    """A room 2.8 m wide is too narrow for the usual distance; the seat does not slide aside for
    it, and a table beside the seat does not put it off the axis."""
    pieces = home.solve(one_room(2.8, 5.0, "living", "seating", "media"), seed=seed).pieces
    seat = next(p for p in pieces if p.category in ("sofa", "loveseat")).pose
    screen = next(p for p in pieces if p.category == "tv").pose
    dx, dy = screen.x - seat.x, screen.y - seat.y
    assert abs(dx * sin(seat.heading) - dy * cos(seat.heading)) < 0.05
    assert dx * cos(seat.heading) + dy * sin(seat.heading) > 1.0


def test_a_screen_is_put_before_its_seat_where_it_can_stand() -> None:
    """The seat is 0.3 m left of its group's middle; a wardrobe beside the screen keeps it where it
    is, and the seat moves instead."""
    sofa, tv = Size(1.6, 0.9, 0.8), Size(1.2, 0.2, 0.6)
    seating = Group("seating", "", 2.2, 0.9, (Member("loveseat", -0.3, 0, 0, 0, sofa),))
    media = Group("media", "", 1.2, 0.4, (Member("tv", 0, 0, 0, 0, tv),))
    wardrobe = Group("wardrobe", "", 1.0, 0.6, ())
    room = one_room(5.0, 4.0, "living")
    ground = ground_of(spaces(room)[0], (), 20.0)
    boxes = np.array(
        [
            [2.5, 0.5, pi / 2, 2.2, 0.9],
            [2.5, 3.8, -pi / 2, 1.2, 0.4],
            [1.35, 3.7, -pi / 2, 1.0, 0.6],
        ]
    )
    new = np.ones(3, bool)
    free = face_screen((seating, media), boxes[:2], new[:2], ground)
    assert free - boxes[:2] == pytest.approx(np.array([[0] * 5, [-0.3, 0, 0, 0, 0]]))
    held = face_screen((seating, media, wardrobe), boxes, new, ground)
    assert held[:, 0] - boxes[:, 0] == pytest.approx([0.3, 0.0, 0.0])
    warm = ground._replace(fronts=np.array([[1.8, 3.8, -pi / 2, 0.2, 0.4]]))
    assert face_screen((seating, media), boxes[:2], new[:2], warm)[0, 0] == pytest.approx(2.8)
    kept = face_screen((seating, media, wardrobe), boxes, np.zeros(3, bool), ground)
    assert np.array_equal(kept, boxes)


@pytest.mark.skipif(not THOROUGH, reason="many real scenes: in make test-all")
@pytest.mark.realdata
@pytest.mark.usefixtures("real_data")
def test_most_seats_of_real_flats_are_before_their_screens() -> None:
    far, mean, *_ = records(quick=True)
    assert far["runs"] >= 10
    assert far["ours"] < far["baseline"]
    assert mean["ours"] < 1.1 * mean["baseline"]
