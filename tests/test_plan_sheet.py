"""Plans for the site office: three pens, sills and heads, a schedule, sheet number and date."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from shapely import Polygon, box, union_all

from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Size
from scenewright.core.solution import Solution
from scenewright.domains import draw_plan, scene_of, solve
from scenewright.domains.home.drawing.plan import list_furniture
from scenewright.drawing.labels import place
from scenewright.drawing.marks import CUT, FINE, LINE, PaperView
from scenewright.drawing.pieces import footprint, hangs
from scenewright.drawing.svg import write_svg
from scenewright.drawing.wordings import extent
from scenewright.formats import read

SCALE = 20.0


@pytest.fixture(scope="module")
def home() -> Solution:
    return solve(read("sample:home-flat"), steps=300, seed=3)


@pytest.fixture(scope="module")
def drawn(home: Solution) -> str:
    return write_svg(draw_plan(home))


def words_of(text: str) -> list[str]:
    return re.findall(r"<text[^>]*>([^<]*)</text>", text)


def test_a_plan_is_drawn_with_three_pens(drawn: str) -> None:
    marks = re.findall(r"<[^>]*stroke-width=[^>]*>", drawn)
    inked = [m for m in marks if not m.startswith("<text")]
    pens = {float(w) for m in inked for w in re.findall(r'stroke-width="([\d.]+)"', m)}
    assert pens == {CUT, LINE, FINE}


def test_windows_tell_their_sills_and_heads(home: Solution, drawn: str) -> None:
    told = Counter(words_of(drawn))
    for window in (o for o in scene_of(home).openings if o.kind == "window"):
        full = f"sill {window.sill:.2f} · head {window.head:.2f}"
        short = f"{window.sill:.2f} / {window.head:.2f}"
        assert told[full] + told[short] >= 1 or window.width < 0.5


def test_number_and_date_are_printed_as_stated_and_no_clock_is_read(home: Solution) -> None:
    dated = home.brief.model_copy(update={"sheet": "A-101", "date": "2026-11-22"})
    told = words_of(write_svg(draw_plan(replace(home, brief=dated))))
    assert {"Sheet A-101", "2026-11-22"} <= set(told)
    plain = write_svg(draw_plan(home))
    assert plain == write_svg(draw_plan(home))
    assert "Sheet 1" in words_of(plain)
    assert not re.search(r"20\d\d-\d\d-\d\d", plain)


@pytest.mark.parametrize("date", ["22.11.2026", "2026-13-45x", "yesterday"])
def test_other_dates_are_refused(home: Solution, date: str) -> None:
    document = home.brief.model_dump(mode="json", exclude_unset=True)
    with pytest.raises(ValueError, match="date"):
        Brief.model_validate(document | {"date": date})


def test_the_schedule_counts_what_stands_on_the_floor(home: Solution, drawn: str) -> None:
    rows = list_furniture(home.pieces, shipped())
    kinds = shipped().kinds
    standing = [p for p in home.pieces if kinds[p.category].support == "floor"]
    assert sum(int(row.value) for row in rows[1:]) == len(standing)
    names = [row.words for row in rows[1:]]
    assert names == sorted(names)
    assert set(names) <= set(words_of(drawn))


def test_names_of_rooms_lie_over_no_piece(home: Solution) -> None:
    view, scene = PaperView(SCALE, 0.0, 0.0), scene_of(home)
    for space in scene.spaces:
        here = [p for p in scene.pieces if p.space == space.id and not hangs(p)]
        flat = {"rug"}
        solid = union_all([Polygon(footprint(p)) for p in here if p.category not in flat])
        label, (x, y) = place(view, space, solid)
        w, h = np.array(extent(label)) / SCALE / 2
        assert box(x - w, y - h, x + w, y + h).intersection(solid).area < 0.003, space.name


def test_curtains_are_drawn_open() -> None:
    size = Size(2.0, 0.12, 2.4)
    left, right, rail = shipped().assets["curtain"].symbol(size)
    assert left[:, 0].max() <= -0.4 + 1e-9
    assert right[:, 0].min() >= 0.4 - 1e-9
    assert np.ptp(rail[:, 1]) == 0.0


def test_dimension_chains_keep_off_leaves_that_swing_out() -> None:
    door = {"at": [2, 0], "width": 0.9, "swing": "out"}
    room = {"id": "a", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "doors": [door]}
    solution = solve(Brief.model_validate({"rooms": [room]}), steps=50)
    text = write_svg(draw_plan(solution))
    leaf = max(float(v) for v in re.findall(r"A[\d. ,]+?[, ]([\d.]+)\"", text) or ["0"])
    layer = text[text.index("Dimensions") :]
    lines = [float(y) for y in re.findall(r"M[\d.]+,([\d.]+) [\d.]+,\1\"", layer)]
    assert lines
    assert max(lines) > leaf + 3.0
