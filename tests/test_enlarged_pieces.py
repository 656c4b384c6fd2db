"""Rugs and screens grow as far as what is round them lets them: rooms of a few pieces by hand."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import SIZES
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import OWN
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.furnishing.enlarge import enlarge_pieces, find_widest_screen
from scenewright.domains.home.grounds.ground import ground_of

WIDE, DEEP = 9.0, 8.0
OUTLINE = [
    [-WIDE / 2, -DEEP / 2],
    [WIDE / 2, -DEEP / 2],
    [WIDE / 2, DEEP / 2],
    [-WIDE / 2, DEEP / 2],
]


def room():
    brief = Brief(
        rooms=[Room.model_validate({"id": "a", "function": "living", "outline": OUTLINE})]
    )
    (space,) = spaces(brief)
    return ground_of(space, (), 60.0, ())


GROUND = room()


def piece(category, x, y, heading, width, depth, height=0.5, group="seating", **more):
    name = more.pop("name", category)
    pose = Pose(x, y, more.pop("z", 0.0), heading)
    return Piece(name, category, "", "a", pose, Size(width, depth, height), group, **more)


def seats(heading=0.0, width=2.0, rug=1.6, table=0.6, beyond=0.05):
    """A sofa in the middle that looks along ``heading``, a table before it and a rug whose far
    edge lies ``beyond`` that of the table."""
    c, s = cos(heading), sin(heading)
    edge = 0.9 + table / 2 + beyond
    middle, deep = (0.3 + edge) / 2, edge - 0.3
    return [
        piece("sofa", 0.0, 0.0, heading, width, 0.9, 0.8),
        piece("coffee_table", 0.9 * c, 0.9 * s, heading, 1.0, table),
        piece("rug", middle * c, middle * s, heading, rug, deep, 0.012),
    ]


def grow(pieces, *others):
    grown = enlarge_pieces(pieces, others, GROUND, 2.6, shipped())
    return next((p for p in grown if p.category == "rug"), None)


def spans(rug, heading=0.0):
    """Where a rug lies seen from the sofa at the origin: near, far, right and left ends."""
    c, s = cos(heading), sin(heading)
    x, y = rug.pose.x * c + rug.pose.y * s, -rug.pose.x * s + rug.pose.y * c
    wide, deep = rug.size.width / 2, rug.size.depth / 2
    return (x - deep, x + deep, y - wide, y + wide)


@pytest.mark.parametrize("heading", [0.0, 0.6, pi / 2, -2.0])
def test_a_rug_in_the_open_frames_sofa_and_table(heading):
    assert spans(grow(seats(heading)), heading) == pytest.approx((0.3, 1.5, -1.3, 1.3))


@pytest.mark.parametrize("gap", [0.35, 0.3, 0.25, 0.2, 0.15, 0.12])
def test_a_rug_between_two_walls_is_the_widest_that_fits(gap):
    sides = [
        piece("bookcase", 0.9, k * (1.0 + gap + 0.2), 0.0, 0.4, 3.0, 2.0, f"{k}") for k in (-1, 1)
    ]
    most = max(b for b in (0.6, 0.5, 0.4, 0.3, 0.2) if b / 2 <= gap)
    assert grow(seats(), *sides).size.width == pytest.approx(2.0 + most)


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize("heading", [0.0, 1.1])
def test_a_rug_beside_one_wall_reaches_out_at_the_other_end(side, heading):
    c, s = cos(heading), sin(heading)
    x, y = 0.9, side * 1.22
    wall = piece("bookcase", x * c - y * s, x * s + y * c, heading, 0.4, 3.0, 2.0, "wall")
    low, high = spans(grow(seats(heading), wall), heading)[2:]
    near, far = (high, -low) if side > 0 else (-low, high)
    assert near == pytest.approx(1.0)
    assert far == pytest.approx(1.6)


@pytest.mark.parametrize(("free", "far"), [(0.35, 1.5), (0.25, 1.4), (0.17, 1.355), (0.1, 1.25)])
def test_a_rug_reaches_as_far_beyond_the_table_as_floor_is_free(free, far):
    wall = piece("bookcase", 1.2 + free + 0.2, 0.0, 0.0, 6.0, 0.4, 2.0, "wall")
    assert spans(grow(seats(), wall))[1] == pytest.approx(far)


def test_a_rug_never_becomes_smaller():
    long = seats(rug=3.2, beyond=0.7)
    assert spans(grow(long))[1] == pytest.approx(1.9)
    assert grow(long).size.width == pytest.approx(3.2)


@pytest.mark.parametrize(("width", "stays"), [(1.9, False), (2.0, False), (2.1, True)])
def test_a_rug_that_cannot_grow_stays_where_it_is_wider_than_its_sofa(width, stays):
    chest = piece("chest", 0.6, 0.0, 0.0, 4.0, 0.2, 0.8, "chest")
    assert (grow(seats(rug=width), chest) is not None) == stays


def test_models_of_a_users_own_and_what_is_fixed_stay():
    for more in ({"asset": f"{OWN}kilim"}, {"fixed": True}):
        *rest, rug = seats()
        assert grow([*rest, replace(rug, **more)]) == replace(rug, **more)


def screens(away, stand=1.2, name="s", width=0.8):
    """A stand near the left wall with a screen, and a sofa so far before it."""
    return [
        piece("tv_stand", -4.0, 0.0, 0.0, stand, 0.4, 0.45, "media", name=name),
        piece("tv", -4.0, 0.0, 0.0, width, 0.2, 0.5, "media", z=0.45, on=name, name=f"tv {name}"),
        piece("sofa", -4.0 + away, 0.0, pi, 2.0, 0.9, 0.8),
    ]


def widest(pieces, *others):
    return next(
        p for p in enlarge_pieces(pieces, others, GROUND, 2.6, shipped()) if p.category == "tv"
    )


@pytest.mark.parametrize("away", [2.0, 2.5, 3.0, 3.6, 4.0, 4.4, 6.5])
@pytest.mark.parametrize("stand", [0.9, 1.2, 1.6])
def test_a_screen_is_as_wide_as_its_distance_asks_and_its_stand_carries(away, stand):
    asked = min(away / 2.3, max(stand, away / 3.15), stand + 0.36, SIZES["tv"][2].width)
    assert widest(screens(away, stand)).size.width == pytest.approx(max(asked, 0.8), abs=0.006)


def test_a_screen_keeps_its_shape_and_its_depth():
    size = widest(screens(3.0)).size
    assert size.height / size.width == pytest.approx(0.5 / 0.8)
    assert size.depth == 0.2


def test_the_nearest_seats_and_its_own_stand_say_how_wide_a_screen_is():
    far = replace(screens(6.5)[2], id="far")
    assert widest([*screens(2.3), far]).size.width == pytest.approx(1.0, abs=0.006)
    other = piece("tv_stand", 3.0, 3.0, pi, 0.8, 0.4, 0.45, "other", name="o")
    assert widest([other, *screens(3.6)]).size.width == pytest.approx(1.2, abs=0.006)


@pytest.mark.parametrize(("off", "wide"), [(0.9, 1.2), (2.0, 1.56)])
def test_no_screen_reaches_over_a_chair_beside_its_stand(off, wide):
    chair = piece("dining_chair", -4.0, off, 0.0, 0.46, 0.5, 0.8, "table")
    assert widest([*screens(6.5), chair]).size.width == pytest.approx(wide, abs=0.06)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_screen_beside_something_tall_reaches_beyond_its_stand_at_the_other_end(side):
    stand, screen, sofa = screens(6.5)
    tall = piece("bookcase", -4.0, side * 0.83, 0.0, 0.4, 0.4, 2.0, "case")
    found = widest([stand, screen, sofa], tall)
    assert found.size.width == pytest.approx(1.36, abs=0.006)
    assert found.pose.y == pytest.approx(-side * 0.08, abs=0.006)
    assert find_widest_screen(stand, GROUND, (tall,)) == pytest.approx(1.36)


@pytest.mark.parametrize("off", [0.63, 0.75, 0.9])
def test_the_widest_screen_is_the_widest_that_ends_before_its_neighbours(off):
    """Neighbours on both sides, alike and ``off`` metres from the middle of a stand of 1.2 m."""
    stand = screens(6.5)[0]
    pair = [piece("bookcase", -4.0, k * (off + 0.15), 0.0, 0.3, 0.3, 2.0, f"{k}") for k in (-1, 1)]
    widths = [1.56 - 0.1 * k for k in range(9)]
    held = [w for w in widths if max(w - 1.2, 0.0) / 2 + 1e-9 >= w / 2 - off]
    free = max(w for w in held if w / 2 <= off or w / 2 + (w - 1.2) / 2 <= off)
    assert find_widest_screen(stand, GROUND, pair) == pytest.approx(free)
    assert find_widest_screen(stand, GROUND) == pytest.approx(1.56)


@pytest.mark.parametrize(
    ("height", "group", "keeps"),
    [(2.0, "case", True), (0.44, "case", False), (2.0, "media", False)],
)
def test_only_what_rises_above_the_stand_and_is_not_of_its_group_counts(height, group, keeps):
    stand = screens(6.5)[0]
    pair = [
        piece("bookcase", -4.0, k * 0.8, 0.0, 0.36, 0.36, height, group, name=f"{k}")
        for k in (-1, 1)
    ]
    assert (find_widest_screen(stand, GROUND, pair) < 1.5) == keeps
