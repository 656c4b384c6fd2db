"""Plans of homes as they are printed: filled sheets, names on free floor, a key to symbols."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import Polygon, box

from scenewright.building.shafts import is_shaft
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Space
from scenewright.domains import draw_plan, scene_of, solve
from scenewright.domains.home.drawing.plan import list_outlets
from scenewright.domains.home.drawing.short_names import LETTERS, short_names_mark
from scenewright.drawing import legend as svg_legend
from scenewright.drawing.dimensions import readable
from scenewright.drawing.doors import heights_mark
from scenewright.drawing.filled_sheet import NARROW, arrange_filled
from scenewright.drawing.labels import Floor, labels_mark, place
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.marks import PaperView, text_width
from scenewright.drawing.shafts import HATCH, shafts_mark
from scenewright.drawing.sheet import EDGE, drawing_area, sheet_mark
from scenewright.drawing.svg import mark_text, write_svg
from scenewright.drawing.wordings import READABLE, extent
from scenewright.formats import read

VIEW = PaperView(20.0, 0.0, 0.0)
EXTRA = (28.0, 36.0)


@pytest.fixture(scope="module")
def home() -> Solution:
    return solve(read("sample:home-services"), steps=300, seed=3)


@pytest.fixture(scope="module")
def drawn(home: Solution) -> str:
    return write_svg(draw_plan(home))


def words_of(text: str) -> list[str]:
    return re.findall(r"<text[^>]*>([^<]*)</text>", text)


def room(name: str, wide: float, deep: float, *openings: Opening) -> Space:
    outline = np.array([[0, 0], [wide, 0], [wide, deep], [0, deep]], float)
    return Space("r", name, (), "0", outline, openings=openings)


@pytest.mark.parametrize(
    ("need", "paper", "scale"),
    [
        ((8.7, 5.8), (297, 210), 50),
        ((13.7, 10.3), (420, 297), 50),
        ((19.4, 9.1), (594, 420), 50),
        ((3.7, 8.0), (297, 420), 25),
        ((5.4, 2.9), (297, 210), 25),
        ((40.0, 15.0), (594, 420), 100),
        ((6.6, 11.0), (420, 297), 50),
        ((11.4, 8.3), (420, 297), 50),
    ],
)
def test_a_home_is_drawn_at_a_usual_scale_on_the_smallest_sheet_it_fills(
    need: tuple[float, float], paper: tuple[float, float], scale: int
) -> None:
    rows = [LegendRow("letter", "Bed", value="1")] * 20
    assert arrange_filled(need, EXTRA, rows).sheet == (*paper, scale)


@given(st.floats(1, 150), st.floats(1, 150), st.integers(0, 120))
def test_plan_and_schedule_fit_their_sheet(w: float, h: float, count: int) -> None:
    found = arrange_filled((w, h), EXTRA, [LegendRow("letter", "Bed", value="1")] * count)
    sheet, (wide, high) = found.sheet, found.room
    assert w * 1000 / sheet.scale + EXTRA[0] <= wide + 1e-6
    assert h * 1000 / sheet.scale + EXTRA[1] <= high + 1e-6
    assert sum(len(part) for *_, part in found.columns) in (0, count)
    area = drawing_area(sheet)
    for left, top, part in found.columns:
        assert found.width >= NARROW
        assert left + found.width <= EDGE + area[0] + 1e-6
        assert top + len(part) * svg_legend.ROW <= EDGE + area[1] + 1e-6
        assert left >= EDGE + wide - 1e-6 or top >= EDGE + high - 1e-6


def test_a_name_lies_on_a_rug_only_where_no_other_floor_is_left() -> None:
    bedroom = room("Bedroom", 4.0, 4.0)
    strips = box(0, 0.29, 4, 3.71)  # leaves room for small type only
    for rug, beside in ((box(0.5, 1, 3.5, 3), True), (strips, True), (box(0, 0, 4, 4), False)):
        label, at = place(VIEW, bedroom, Polygon(), rug)
        half = np.array(extent(label)) / VIEW.scale / 2
        drawn = box(*(at - half), *(at + half))
        assert (drawn.intersection(rug).area < 1e-3) == beside
        assert label.turn == 0


def test_a_long_name_is_whole_and_horizontal_where_its_lines_find_room() -> None:
    name = "bedroom + kitchen + storage + hall"
    label, _ = place(VIEW, room(name, 1.5, 4.0), Polygon())
    assert label.turn == 0
    assert label.names > 1
    assert " ".join(words for words, _ in label.lines[: label.names]) == name


def test_names_are_larger_on_larger_sheets_where_there_is_room() -> None:
    for wide, larger in ((4.0, True), (0.9, False)):
        usual = labels_mark(VIEW, [room("Bedroom", wide, 4.0)], Floor(Polygon()), ["#fff"])
        large = labels_mark(VIEW, [room("Bedroom", wide, 4.0)], Floor(Polygon()), ["#fff"], 1.4)
        sizes = [sizes_of(mark_text(mark)) for mark in (usual, large)]
        assert (sizes[1] == pytest.approx(1.4 * sizes[0])) == larger
        assert sizes[1] >= sizes[0]


def sizes_of(text: str) -> float:
    """The height of the largest letters."""
    return max(map(float, re.findall(r'font-size="([\d.]+)"', text)))


def test_heights_of_a_bow_window_stand_outside_its_wall() -> None:
    window = Opening("w", "window", "0", 2.0, 0.0, 1.0, 0.0, 1.5, 0.3, 0.5, 2.3, spaces=("r",))
    bow = Polygon([(1.0, 0.0), (2.0, -0.35), (3.0, 0.0)])

    def away(*low: Polygon) -> float:
        mark = mark_text(heights_mark(VIEW, [window], *low))
        return float(re.findall(r'y="([-\d.]+)"', mark)[0])

    assert away(bow) - away() == pytest.approx((0.35 - 0.15) * VIEW.scale, abs=0.02)
    assert away(box(0, 1, 4, 2)) == away()


def test_a_closet_full_of_shelves_has_no_name() -> None:
    closet = room("storage", 1.0, 0.6)
    shelves = box(0, 0, 1, 0.6)
    assert "storage" in words_of(mark_text(labels_mark(VIEW, [closet], Floor(Polygon()), ["#fff"])))
    assert not words_of(mark_text(labels_mark(VIEW, [closet], Floor(shelves), ["#fff"])))
    larger = replace(closet, outline=3 * closet.outline)
    found = mark_text(labels_mark(VIEW, [larger], Floor(box(0, 0, 3, 1.8)), ["#fff"]))
    assert "storage" in words_of(found), "a room is always named"


def test_other_is_no_name_and_what_has_no_door_is_a_shaft() -> None:
    door = Opening("d", "door", "0", 0.5, 0.0, 1.0, 0.0, 0.6, 0.1, 0, 2, 1, 1, spaces=("r",))
    told = []
    for space in (room("other", 2, 1), room("other", 0.5, 0.5), room("other", 2, 1, door)):
        names = mark_text(labels_mark(VIEW, [space], Floor(Polygon()), ["#fff"]))
        told.append((set(words_of(names)), HATCH in mark_text(shafts_mark(VIEW, [space]))))
    sizes = {"2.0 m²", "2.00 × 1.00"}
    assert told == [({"shaft"} | sizes, True), (set(), True), (sizes, False)]


def test_a_window_makes_no_room_of_a_shaft_but_a_large_one() -> None:
    window = Opening("w", "window", "0", 0.5, 0.0, 1.0, 0.0, 0.6, 0.1, 0.9, 2, spaces=("r",))
    rooms = [room("other", wide, 1.0, *given) for wide in (1.3, 3.0) for given in ((), (window,))]
    assert [is_shaft(space) for space in rooms] == [True, True, True, False]


def test_all_words_of_a_home_can_be_read(drawn: str) -> None:
    sizes = [float(size) for size in re.findall(r'font-size="([\d.]+)"', drawn)]
    assert min(sizes) >= READABLE


def test_appliances_bear_the_letters_that_the_schedule_explains(home: Solution, drawn: str) -> None:
    told = words_of(drawn)
    here = {piece.category for piece in home.pieces} & set(LETTERS)
    assert {"fridge", "washing_machine"} <= here
    for kind in here:
        assert LETTERS[kind] in told
        assert any(word.endswith(f"({LETTERS[kind]})") for word in told)
    stack = [
        Piece(k, k, "", "r", Pose(1, 1, z, 0), Size(0.6, 0.6, 0.8))
        for k, z in (("washing_machine", 0.0), ("dryer", 0.8))
    ]
    assert set(words_of(mark_text(short_names_mark(VIEW, stack)))) == {"TD/WM"}
    small = PaperView(5.0, 0.0, 0.0)
    assert not words_of(mark_text(short_names_mark(small, stack)))


def test_the_key_counts_outlets(home: Solution, drawn: str) -> None:
    spaces = scene_of(home).spaces
    rows, count = list_outlets(spaces), sum(len(space.outlets) for space in spaces)
    assert count > 0
    assert sum(int(row.right) for row in rows[1:]) == count
    assert {row.words for row in rows} <= set(words_of(drawn))


def test_a_title_of_its_own_stays_and_the_number_of_a_file_is_cut() -> None:
    sheet = arrange_filled((8.0, 6.0), EXTRA, ()).sheet
    for name, told in (
        ("Flat 12, second floor", "Flat 12, second floor"),
        ("07-ee-d0bc3031a7f3d6848c7a64826307-0002", "07-ee-d0bc30…-0002"),
        ("Deadbeefdeadbeef", "Deadbeefdeadbeef"),
    ):
        assert told in words_of(mark_text(sheet_mark(sheet, name, "")))


def test_figures_of_neighbouring_segments_stay_apart() -> None:
    """0.54 and 0.56 m are 5.4 and 5.6 mm at 1:100, room for figures of 3.7 mm; at 1:125 only 0.6 mm
    would part them, and they share one."""
    stations = (0.0, 2.0, 2.54, 3.1, 6.0)
    assert readable(stations, 10.0) == stations
    kept = np.array(readable(stations, 8.0))
    assert np.diff(kept).min() * 8.0 >= text_width("0.00", 1.6) + 1.0
