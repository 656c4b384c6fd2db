"""Counters of halls that are no rows find what is planted, at their threshold and beyond."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.composition_faults import Room, list_rooms
from benchmarks.unseen_halls import SeenHall, tally_halls
from benchmarks.unseen_halls_briefs import THEMES, draw_halls
from benchmarks.unseen_halls_counters import COUNTERS, Hall, count_all, measure_all

from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Opening, Space

UP = np.pi / 2
FRONT = Opening("d", "door", "0", 6.0, 0.0, 1.0, 0.0, 2.0, 0.2, 0.0, 2.1, spaces=("hall",))
OUTLINE = np.array([[0, 0], [20, 0], [20, 15], [0, 15]], np.float64)
HALL = Space("hall", "Hall", (), "0", OUTLINE, openings=(FRONT,))


def piece(
    kind: str, x: float, y: float, width: float = 1.0, depth: float = 0.5, turn: float = UP
) -> Piece:
    """A piece that faces north unless it is turned."""
    return Piece(
        f"{kind}{x}{y}", kind, kind, "hall", Pose(x, y, 0.0, turn), Size(width, depth, 1.0)
    )


def grid(kind: str, step: float, nx: int, ny: int, jitter: float = 0.0) -> tuple[Piece, ...]:
    """Rows and columns of a kind, every other one ``jitter`` farther on."""
    return tuple(
        piece(kind, 2 + step * i + jitter * (i * i % 3), 2 + step * j + jitter * (j * j % 5), 0.5)
        for i in range(nx)
        for j in range(ny)
    )


def shelf(length: float, x: float = 0.0) -> tuple[Piece, ...]:
    """Goods along the north wall, in one piece."""
    return (piece("wall_shelving", x + length / 2, 14.75, length, 0.5, -UP),)


def row(gap: float) -> tuple[Piece, ...]:
    """Two pieces of a row of 6 m each, so far apart."""
    return (piece("gondola", 4, 7, 6.0, 0.9), piece("gondola", 10 + gap, 7, 6.0, 0.9))


def pews(pitch: float) -> tuple[Piece, ...]:
    return tuple(piece("bench", 5, 5 + pitch * k, 3.0, 0.5) for k in range(2))


SIDES = (
    *(piece("wall_shelving", 0.25, 7.5, 14.8, 0.5, 0.0),),
    *(piece("wall_shelving", 19.75, 7.5, 14.8, 0.5, np.pi),),
)
CASES = {
    "walls used under 60 per cent, numbers open": (
        ("mall shop", shelf(19)),
        ("mall shop", (*SIDES, *shelf(12))),
    ),
    "too much floor a seat, numbers open": (
        ("canteen", grid("dining_chair", 1.0, 14, 10)),
        ("canteen", grid("dining_chair", 0.7, 17, 15)),
    ),
    "role away from its door": (
        ("mall shop", (piece("checkout", 6, 9.0),)),
        ("mall shop", (piece("checkout", 6, 7.0),)),
    ),
    "row over 12 m without an aisle": (("mall shop", row(0.6)), ("mall shop", row(1.2))),
    "pitch of pews not 0.8 to 1.1 m": (("church", pews(1.5)), ("church", pews(0.95))),
    "formation": (
        ("mall shop", grid("mannequin", 1.4, 4, 4)),
        ("mall shop", grid("mannequin", 1.4, 4, 4, 0.6)),
    ),
    "back to the entrance": (
        ("showroom", (piece("sofa", 6, 4, 2.0, 0.9),)),
        ("showroom", (piece("sofa", 6, 4, 2.0, 0.9, -UP),)),
    ),
    "little stands there, numbers open": (
        ("museum", shelf(19)),
        ("museum", (piece("exhibit_island", 10, 7, 8, 6),)),
    ),
    "empty circle over 5 m, numbers open": (("museum", ()), ("museum", grid("plinth", 3.2, 6, 5))),
}
"""For each counter what breaks it, and what keeps it even 0.1 m beyond its threshold."""


def hall(theme: str, pieces: tuple[Piece, ...], left_open: bool = True) -> Hall:
    [room] = list_rooms([HALL], pieces)
    return Hall(theme, left_open, room)


def test_every_counter_has_its_case() -> None:
    assert {row.name for row in COUNTERS if row.open is not False} == set(CASES)


@pytest.mark.parametrize("name", CASES)
def test_counters_find_what_is_planted(name: str) -> None:
    broken, kept = CASES[name]
    faulty, of = count_all(hall(*broken))[name]
    assert faulty == of >= 1
    faulty, of = count_all(hall(*kept), 0.1)[name]
    assert (faulty, of >= 1) == (0, True)


@pytest.mark.parametrize(
    ("name", "theme", "pieces"),
    [
        ("role away from its door", "mall shop", (piece("checkout", 6, 8.2),)),
        ("row over 12 m without an aisle", "mall shop", (piece("gondola", 9, 7, 11.95, 0.9),)),
        ("back to the entrance", "showroom", (piece("sofa", 6, 6.5, 2.0, 0.9),)),
    ],
)
def test_centimetres_buy_nothing(name: str, theme: str, pieces: tuple[Piece, ...]) -> None:
    assert count_all(hall(theme, pieces))[name].faulty == 0
    assert count_all(hall(theme, pieces), 0.1)[name].faulty == 1


def test_what_a_brief_states_is_counted_apart() -> None:
    counts = count_all(hall("museum", (), left_open=False))
    assert counts["empty circle over 5 m, numbers open"] == (0, 0)
    assert counts["empty circle over 5 m, numbers stated"] == (1, 1)


def test_the_empty_circle_of_an_empty_hall_is_as_wide_as_the_hall() -> None:
    room = Room(HALL, list_rooms([HALL], ())[0].floor, ())
    assert measure_all(Hall("museum", True, room))["empty circle, m across"] == pytest.approx(15.0)


def test_a_bare_hall_has_no_roles_and_no_rows() -> None:
    counts = count_all(hall("supermarket", ()))
    assert counts["role away from its door"] == counts["formation"] == (0, 0)


def test_records_tell_counters_figures_and_the_guard() -> None:
    one = hall("museum", shelf(19))
    seen = SeenHall("a", count_all(one), count_all(one, 0.1), measure_all(one), 1, 2, 3.0)
    found = {record["case"]: record["ours"] for record in tally_halls([seen])}
    assert found["little stands there, numbers open"] == 1.0
    assert (found["valid"], found["required things left out"]) == (0.0, 2.0)


@pytest.mark.realdata
def test_halls_are_drawn_by_a_seed_and_leave_some_numbers_open() -> None:
    drawn = draw_halls(11, 30)
    assert [one.brief for one in drawn] == [one.brief for one in draw_halls(11, 30)]
    assert {one.theme for one in drawn} <= {*THEMES, "mall shop"}
    counts = {d.count is None for one in drawn for d in one.brief.rooms[0].demands}
    assert counts == {True, False}
