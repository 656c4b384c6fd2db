"""What a designer would see at once: backs at walls, the screen before the bed, a turned chair."""

from __future__ import annotations

from math import cos, pi, remainder, sin

import numpy as np
import pytest

from scenewright.assets import shipped
from scenewright.brief import Ask, Brief, Room
from scenewright.domains import home
from scenewright.domains.home.dress import Refused, dress_patch
from scenewright.domains.home.ground import ground_of
from scenewright.domains.home.library import cases, wished
from scenewright.domains.home.obstacles import Standing
from scenewright.domains.home.pose import RELATIONS, holds
from scenewright.plan import spaces
from scenewright.scene import Piece

EMPTY = Standing(np.zeros((0, 5)), np.zeros((0, 2)), ())


def one_room(wide: float, deep: float, function: str, *groups: str) -> Brief:
    room = Room.model_validate({
        "id": "room", "function": function, "doors": [{"at": [0.6, 0.0], "width": 0.8}],
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "ask": [Ask(group=group) for group in groups],
    })  # fmt: skip
    return Brief(rooms=[room])


@pytest.mark.parametrize("function", ["washer", "wardrobe", "kitchen"])
def test_what_belongs_to_a_wall_is_refused_in_the_open(function: str) -> None:
    space = spaces(one_room(8.0, 7.0, "living"))[0]
    ground = ground_of(space, (), 56.0)
    case = wished(function, 10.0)

    def dressed(y: float) -> object:
        box = np.array([4.5, y, -pi / 2, case.width, case.depth])
        return dress_patch(function, box, ground, EMPTY, shipped(), 2.6)

    assert not isinstance(dressed(7.0 - case.depth / 2 - 0.01), Refused)
    assert dressed(3.5) == Refused("no wall is left for its back")


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
    assert "turned out" in wished("reading", 30.0).name
    turned = [case.members for case in cases("reading").groups if "turned out" in case.name]
    assert {np.sign(lamp.x) for _, lamp in turned} == {-1.0, 1.0}
    for chair, lamp in turned:
        ahead = np.array([-sin(chair.heading), cos(chair.heading)])
        assert ahead @ np.array([lamp.x - chair.x, lamp.y - chair.y]) < -0.4
