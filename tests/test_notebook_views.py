"""What a notebook shows of briefs, solutions, scenes and reports, and the line a shell shows."""

from __future__ import annotations

import base64
import re
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from xml.etree import ElementTree

import pytest
from PIL import Image

import scenewright as sw
from scenewright.core.brief.input_report import Fate, report_input
from scenewright.core.report import Finding, Report
from scenewright.core.solution import LeftOut
from scenewright.formats import notebook

SAMPLES = ("home-room", "hall-shop", "site-square", "village-hamlet", "extend-court")
"""A brief of each domain."""


def check_balance(text: str) -> None:
    """Every tag that is opened is closed."""
    waiting: list[str] = []

    class Parser(HTMLParser):
        def handle_starttag(self, tag: str, attrs: object) -> None:  # noqa: ARG002
            if tag != "img":
                waiting.append(tag)

        def handle_endtag(self, tag: str) -> None:
            assert waiting.pop() == tag

    Parser().feed(text)
    assert not waiting


def drawing_in(text: str) -> ElementTree.Element:
    """The drawing embedded in a page."""
    (data,) = re.findall(r"data:image/svg\+xml;base64,([^\"]+)", text)
    return ElementTree.fromstring(base64.b64decode(data))


@pytest.mark.parametrize("name", SAMPLES)
def test_a_brief_shows_its_plan_without_furniture(name: str) -> None:
    brief = sw.read(f"sample:{name}")
    line = repr(brief)
    assert line == str(brief)
    assert "\n" not in line
    assert len(line) < 120
    assert line.startswith(f"Brief('{brief.domain}', '{brief.name}'")
    page = brief._repr_html_()
    check_balance(page)
    assert drawing_in(page).tag.endswith("svg")
    assert brief._repr_svg_() is not None


def test_the_rooms_of_a_brief_are_listed_with_their_area() -> None:
    page = sw.read("sample:home-room")._repr_html_()
    assert re.search(r"<td>\d+\.\d m²</td>", page)


def test_a_brief_that_cannot_be_planned_says_why() -> None:
    twisted = {"outline": [[0, 0], [4, 4], [4, 0], [0, 4]]}
    brief = sw.Brief.model_validate({"rooms": [twisted]})
    assert brief._repr_svg_() is None
    assert "cannot be laid out" in brief._repr_html_()


def test_a_solution_shows_its_verdict_plan_and_what_is_missing(solution: sw.Solution) -> None:
    lost = LeftOut("living", "single", "no free wall of 2.0 m to stand against", True)
    lacking = replace(solution, left_out=(lost,))
    assert "not_placed=1" in repr(lacking)
    assert "\n" not in repr(lacking)
    page = lacking._repr_html_()
    check_balance(page)
    drawing_in(page)
    assert "1 not placed" in page
    assert "keep 2.0 m of wall free" in page
    assert ElementTree.fromstring(lacking._repr_svg_() or "").tag.endswith("svg")


def test_a_scene_shows_its_picture(solution: sw.Solution, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(notebook, "WIDTH", 120)
    scene = sw.scene_of(solution)
    assert repr(scene).startswith("Scene(")
    with Image.open(BytesIO(scene._repr_png_() or b"")) as picture:
        assert picture.width <= 120


def test_reports_are_tables_and_names_are_escaped() -> None:
    found = Finding("collision", "0", "a", "sofa", "tv", "<b>sofa</b> & tv overlap")
    report = Report((found,))
    assert repr(report) == "Report('not valid: 1 collision', findings=1, notes=0)"
    page = report._repr_html_()
    check_balance(page)
    assert "&lt;b&gt;sofa&lt;/b&gt; &amp; tv overlap" in page
    read = report_input([Fate("node/7", "tree", "left out", "planted anew")], format="GeoJSON")
    assert repr(read) == "InputReport('GeoJSON', features=1, lost=0)"
    assert "planted anew" in read._repr_html_()


def test_an_explanation_is_a_table(solution: sw.Solution) -> None:
    told = sw.explain(solution)
    check_balance(told._repr_html_())
    assert "\n" not in repr(told)


def test_long_tables_are_cut() -> None:
    page = notebook.table(("n",), [(str(n),) for n in range(notebook.MOST_ROWS + 3)])
    check_balance(page)
    assert "and 3 more" in page


def test_a_line_of_a_brief_loads_nothing_heavy() -> None:
    code = """import sys
from scenewright.core.brief import Brief
room = {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
brief = Brief.model_validate({"rooms": [room]})
before = set(sys.modules)
assert repr(brief) == "Brief('home', 'home', rooms=1)", repr(brief)
assert not {name.partition(".")[0] for name in set(sys.modules) - before} - {"scenewright"}
assert "numba" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)
