"""PDF out: to scale, all words text in embedded fonts, a set of sheets in one file."""

from __future__ import annotations

import dataclasses
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flat import flat_brief, flat_solution
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import draw_levels
from scenewright.drawing.marks import GroupMark, MeantMark, TextMark
from scenewright.formats import read, write

pypdf = pytest.importorskip("pypdf")
pytest.importorskip("fpdf")
POINT = 25.4 / 72.0


def save(solution: Solution, path: Path) -> Any:
    write(solution, path)
    return pypdf.PdfReader(path)


@pytest.fixture(scope="module")
def flat(tmp_path_factory: pytest.TempPathFactory) -> Any:
    return save(flat_solution(), tmp_path_factory.mktemp("pdf") / "flat.pdf")


def words_of(mark: Any) -> Iterator[str]:
    """The words of a mark, those of halos once."""
    if isinstance(mark, GroupMark):
        for part in mark.marks:
            yield from words_of(part)
    elif isinstance(mark, MeantMark):
        yield from words_of(mark.mark)
    elif isinstance(mark, TextMark) and mark.style.get("stroke", "none") == "none":
        yield mark.words


def test_the_words_are_those_of_the_drawing(flat: Any) -> None:
    drawing = draw_levels(flat_solution())[0]
    drawn = {word for layer in drawing.layers for word in words_of(layer.mark) if word}
    text = " ".join(flat.pages[0].extract_text().split())
    assert len(drawn) > 20
    assert [word for word in drawn if word not in text] == []


def test_words_are_not_there_twice_for_their_halo(flat: Any) -> None:
    assert flat.pages[0].extract_text().count("Living room") == 1


def test_fonts_are_embedded(tmp_path: Path) -> None:
    pdf = save(flat_solution("客厅 キッチン 부엌 Кухня Küche Ελλάδα Bếp"), tmp_path / "a.pdf")
    text = pdf.pages[0].extract_text().replace("\0", "")
    assert "客厅 キッチン 부엌 Кухня Küche Ελλάδα Bếp" in text
    fonts = [font.get_object() for font in pdf.pages[0]["/Resources"]["/Font"].values()]
    for font in fonts:
        descriptor = font["/DescendantFonts"][0].get_object()["/FontDescriptor"].get_object()
        assert {"/FontFile2", "/FontFile3"} & descriptor.keys()


def test_a_wall_of_ten_metres_is_to_scale(tmp_path: Path) -> None:
    brief = flat_brief().model_dump(exclude_unset=True)
    brief["rooms"] = [{"id": "hall", "outline": [[0, 0], [10, 0], [10, 4], [0, 4]]}]
    empty = dataclasses.replace(
        flat_solution(), brief=type(flat_brief()).model_validate(brief), pieces=()
    )
    scale = draw_levels(empty)[0].sheet.scale
    content = save(empty, tmp_path / "ten.pdf").pages[0].get_contents().get_data().decode("latin-1")
    wide = [
        np.ptp([float(x) for x, _ in re.findall(r"([\d.]+) ([\d.]+) [ml]\b", path)]) * POINT
        for path in re.findall(r"[\d.]+ [\d.]+ m(?: [\d.]+ [\d.]+ l)+ h", content)
    ]
    assert min(abs(width - 10_000 / scale) for width in wide) < 0.1


def test_a_set_holds_plans_elevations_schedule_and_pictures(tmp_path: Path) -> None:
    solution = flat_solution()
    pdf = save(solution, tmp_path / "flat.pdf")
    texts = [page.extract_text() for page in pdf.pages]
    assert sum("Schedule of furniture" in text for text in texts) == 1
    assert len(pdf.pages[-1].images) == len({piece.space for piece in solution.pieces})
    house = dataclasses.replace(solution, brief=read("sample:home-house"), pieces=())
    assert len(save(house, tmp_path / "house.pdf").pages) == 2


def test_the_same_solution_gives_the_same_bytes(tmp_path: Path) -> None:
    plain = dataclasses.replace(flat_solution(), pieces=())
    for name in ("one.pdf", "two.pdf"):
        write(plain, tmp_path / name)
    assert (tmp_path / "one.pdf").read_bytes() == (tmp_path / "two.pdf").read_bytes()


def test_a_missing_extra_is_named_with_its_install_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in [name for name in sys.modules if name.startswith("scenewright.drawing.pdf")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.delitem(sys.modules, "scenewright.formats.pdf", raising=False)
    monkeypatch.setitem(sys.modules, "fpdf", None)
    with pytest.raises(InputError, match=r"pip install 'scenewright\[pdf\]'"):
        write(flat_solution(), tmp_path / "flat.pdf")
    assert not list(tmp_path.iterdir())
