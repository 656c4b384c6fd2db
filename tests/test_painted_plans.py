"""Plans in vector PDF and SVG: our own and others', scales, pens, hostile files."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from flat import flat_solution
from scenewright.cli import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.solution import unfurnished
from scenewright.formats import read, read_planned, write
from thoroughness import few_or_many

pytest.importorskip("svgelements")
pdfium = pytest.importorskip("pypdfium2")
fpdf = pytest.importorskip("fpdf")


def areas(brief: Brief) -> list[float]:
    """Floor areas of the rooms, the largest first."""
    return sorted((round(Polygon(room.outline).area, 2) for room in brief.rooms), reverse=True)


def two_rooms(size: float, *, leaves: bool = True, pen: float = 0.5) -> str:
    """Rooms of 4 x 3 m and 3 x 3 m with walls of two lines, ``size`` units a metre: the inside of
    an SVG; a table is drawn with a thinner pen."""
    faces = (
        "0,1.1 0,0 4,0 4,1.1 4.2,1.1 4.2,0 7.2,0 7.2,3 4.2,3 4.2,1.9 4,1.9 4,3 0,3 0,1.9 -.2,1.9 "
        "-.2,3.2 7.4,3.2 7.4,-.2 -.2,-.2 -.2,1.1 0,1.1"
    )
    points = [[size * float(v) for v in pair.split(",")] for pair in faces.split()]
    walls = " ".join(f"{x},{y}" for x, y in points)
    side, low, high = 0.8 * size, 1.1 * size, 1.9 * size
    leaf = "".join(
        f'<path d="M{x * size},{low} h{-side} A{side},{side} 0 0 0 {x * size},{high}"/>'
        for x in (4.0, 0.0)
    )
    table = f'<rect x="{size}" y="{0.5 * size}" width="{2 * size}" height="{size}"/>'
    return (
        f'<g fill="none" stroke="black"><polygon stroke-width="{pen}" points="{walls}"/>'
        f'<g stroke-width="{pen / 4}">{leaf * leaves}{table}</g></g>'
        f'<text x="{5 * size}" y="{1.5 * size}" font-size="{0.2 * size}">Kitchen</text>'
    )


def save(path: Path, inside: str, attributes: str) -> Path:
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>'
    path.write_text(f"{head}{inside}</svg>", encoding="utf-8")
    return path


PAPER = 'width="400mm" height="297mm" viewBox="-30 -30 400 297"'


@pytest.mark.parametrize("suffix", ["svg", "pdf"])
def test_our_own_plans_read_back(tmp_path: Path, suffix: str) -> None:
    solution = flat_solution()
    write(solution, tmp_path / f"flat.{suffix}")
    brief = read(tmp_path / f"flat.{suffix}")
    assert areas(brief) == pytest.approx(areas(solution.brief), rel=0.01)
    assert {room.name for room in brief.rooms} == {"Living room", "Bedroom"}
    assert sum(len(room.doors) for room in brief.rooms) == 2
    assert sum(len(room.windows) for room in brief.rooms) == 2
    assert brief.input_report is not None
    assert brief.input_report.complete


def test_pages_of_a_set_are_storeys(tmp_path: Path) -> None:
    """Our own set of a house: both plans with their names and heights above each other, what else
    is in it left out with its reason."""
    brief, plan = read_planned("sample:home-house")
    write(unfurnished(brief), tmp_path / "house.pdf", plan)
    found = read(tmp_path / "house.pdf")
    levels = [("Ground floor", 0.0), ("Upper floor", 2.9)]
    assert [(level.name, level.elevation) for level in found.levels] == levels
    assert areas(found) == pytest.approx(areas(brief), rel=0.01)
    assert {room.name for room in found.rooms} == {room.name for room in brief.rooms}
    by_level = [{room.name for room in found.rooms if room.level == k} for k in ("0", "1")]
    assert "Living room" in by_level[0]
    assert "Main bedroom" in by_level[1]


@pytest.mark.parametrize(("sample", "suffix"), [("home-flat", "svg"), ("home-curved", "pdf")])
def test_balconies_and_round_rooms_read_back(tmp_path: Path, sample: str, suffix: str) -> None:
    """The balcony has no walls, windows of the round room lie askew to each other."""
    brief, plan = read_planned(f"sample:{sample}")
    write(unfurnished(brief), tmp_path / f"plan.{suffix}", plan)
    found = read(tmp_path / f"plan.{suffix}")
    assert areas(found) == pytest.approx(areas(brief), rel=0.01)
    assert {room.name for room in found.rooms} == {room.name for room in brief.rooms}


def test_a_table_between_columns_closes_no_gap(tmp_path: Path) -> None:
    """Columns 4 m apart with tables on more than half of the way between them."""
    walls = "M-5,-5 H245 V165 H-5Z M0,0 V160 H240 V0Z"
    columns = "M60,70 h10 v10 h-10Z M150,70 h10 v10 h-10Z"
    tables = "".join(
        f'<rect x="{x}" y="71" width="30" height="8" fill="none" stroke="black"/>'
        for x in (75, 115)
    )
    door = '<rect x="-5.5" y="30" width="6" height="20" fill="white"/>'
    inside = f'<path fill-rule="evenodd" d="{walls}"/><path d="{columns}"/>{door}{tables}'
    brief = read(save(tmp_path / "plan.svg", f'{inside}<text y="200">1:50</text>', PAPER))
    holes = [Polygon(hole).area for room in brief.rooms for hole in room.holes]
    assert holes == pytest.approx([0.25, 0.25], rel=0.01)


def sheet_of(document: Any, boxes: Sequence[float], title: str, scale: str = "1:100") -> None:
    """A page of rooms 4 m high side by side, ``boxes`` metres wide, with doors between them and a
    title."""
    document.add_page()
    document.set_font("Helvetica", size=14)
    document.text(20, 20, title)
    document.set_font("Helvetica", size=8)
    document.text(20, 150, scale)
    document.set_fill_color(0)
    x = 30.0
    for row in (38.0, 80.0):
        document.rect(28, row, 10 * sum(boxes) + 2 * len(boxes) + 2, 2, style="F")
    for wide in (*boxes, 0.0):
        document.rect(x - 2, 40, 2, 15, style="F")
        document.rect(x - 2, 64, 2, 16, style="F")
        x += 10 * wide + 2


def test_storeys_by_name_and_what_is_none(tmp_path: Path) -> None:
    document = fpdf.FPDF(orientation="landscape", unit="mm", format="A4")
    sheet_of(document, (5.0, 4.0), "GRUNDRISS 1. OG")
    sheet_of(document, (5.0, 3.0, 4.0), "Grundriss EG")
    sheet_of(document, (5.0, 3.0, 4.0), "Elektroplan · EG")
    sheet_of(document, (5.0, 4.0), "Schnitt A-A")
    sheet_of(document, (5.0, 4.0), "2. OG", "1:50")
    document.output(str(tmp_path / "set.pdf"))
    brief = read(tmp_path / "set.pdf")
    assert [(level.name, level.elevation) for level in brief.levels] == [
        ("EG", 0.0),
        ("1. OG", 2.8),
    ]
    counts = Counter(room.level for room in brief.rooms)
    assert counts == {"0": 3, "1": 2}
    assert brief.input_report is not None
    reasons = " ".join(row.reason for row in brief.input_report.rows if row.kind == "page")
    assert "shows the storey of page 2" in reasons
    assert "is called schnitt" in reasons
    assert "is drawn at 1:50, the plan before it at 1:100" in reasons


def test_walls_by_the_widest_pen_and_the_written_scale(tmp_path: Path) -> None:
    note = '<text x="0" y="200" font-size="5">Scale 1 : 50</text>'
    brief = read(save(tmp_path / "plan.svg", two_rooms(20.0) + note, PAPER))
    assert areas(brief) == pytest.approx([12.0, 9.0], rel=0.01)
    assert [room.name for room in brief.rooms if len(room.outline) == 4].count("Kitchen") == 1
    inner = next(d for room in brief.rooms for d in room.doors if d.at[0] > 3)
    assert inner.swing == "in"


def test_what_is_painted_many_times_is_seen_once(tmp_path: Path) -> None:
    """Layers copied onto each other; lines that coincide cost much where all are cut by all."""
    note = '<text x="0" y="200" font-size="5">Scale 1 : 50</text>'
    once = read(save(tmp_path / "once.svg", two_rooms(20.0) + note, PAPER))
    often = read(save(tmp_path / "often.svg", two_rooms(20.0) * 150 + note, PAPER))
    assert [room.outline for room in often.rooms] == [room.outline for room in once.rooms]
    assert [len(room.doors) for room in often.rooms] == [len(room.doors) for room in once.rooms]


@pytest.mark.parametrize(
    ("size", "attributes"), [(20.0, PAPER), (37.0, 'viewBox="-30 -30 400 297"')]
)
def test_the_scale_by_the_leaves_of_doors(tmp_path: Path, size: float, attributes: str) -> None:
    """1:50 on paper; on a screen leaves of 0.8 m are taken as 0.85 m."""
    found = areas(read(save(tmp_path / "plan.svg", two_rooms(size), attributes)))
    assert found == pytest.approx([12.0, 9.0], rel=0.01 if attributes == PAPER else 0.15)


def test_without_scale_or_doors_the_scale_is_asked_for(tmp_path: Path) -> None:
    path = save(tmp_path / "plan.svg", two_rooms(20.0, leaves=False), PAPER)
    with pytest.raises(InputError, match=r"names no scale.*--scale 50"):
        read(path)
    assert run(["plan", str(path), "--scale", "50", "-o", str(tmp_path / "b.json"), "-q"]) == 0
    assert areas(read(tmp_path / "b.json")) == pytest.approx([12.0, 9.0], rel=0.01)


def test_light_paint_over_a_wall_is_an_opening(tmp_path: Path) -> None:
    """Walls filled through, doors as white rectangles painted over them."""
    walls = "M-5,-5 H210 V95 H-5Z M0,0 V90 H100 V0Z M105,0 V90 H205 V0Z"
    doors = "".join(
        f'<rect x="{x}" y="30" width="6" height="18" fill="white"/>' for x in (99.5, -5.5)
    )
    inside = f'<path fill-rule="evenodd" d="{walls}"/>{doors}<text y="200">1:50</text>'
    brief = read(save(tmp_path / "plan.svg", inside, PAPER))
    assert areas(brief) == pytest.approx([22.5, 22.5], rel=0.01)
    assert sum(len(room.doors) for room in brief.rooms) == 2


def hostile_svgs() -> dict[str, str]:
    lol = "".join(f'<!ENTITY l{k} "{f"&l{k - 1};" * 10}">' for k in range(1, 12))
    return {
        "empty": "",
        "no svg": "<html><p>plan</p></html>",
        "no lines": '<svg xmlns="http://www.w3.org/2000/svg"/>',
        "entities": f'<!DOCTYPE svg [<!ENTITY l0 "lol">{lol}]><svg><text>&l11;</text></svg>',
        "deep": "<svg>" + "<g>" * 50_000 + "</g>" * 50_000 + "</svg>",
        "uses": '<svg xmlns="http://www.w3.org/2000/svg"><g id="a"><use href="#a"/></g></svg>',
        "picture": '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">'
        '<image href="plan.png" width="9" height="9"/></svg>',
        "far": '<svg xmlns="http://www.w3.org/2000/svg"><path stroke="black" '
        'd="M1e300,0 L-1e300,1e308 NaN,5 C1e300,1e300 -1e300,0 1,1Z"/></svg>',
    }


@pytest.mark.parametrize("name", hostile_svgs())
def test_hostile_svgs_are_refused_in_one_line(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "bad.svg").write_text(hostile_svgs()[name], encoding="utf-8")
    assert run(["plan", str(tmp_path / "bad.svg"), "-o", str(tmp_path / "b.json")]) == 2
    assert not (tmp_path / "b.json").exists()
    assert len(capsys.readouterr().err.strip().splitlines()) == 1


def test_pdfs_without_a_plan_are_refused_with_the_reason(tmp_path: Path) -> None:
    sheet = fpdf.FPDF(unit="mm", format="A4")
    sheet.add_page()
    sheet.set_encryption(owner_password="a", user_password="b")
    sheet.output(str(tmp_path / "locked.pdf"))
    with pytest.raises(InputError, match="is encrypted"):
        read(tmp_path / "locked.pdf")
    (tmp_path / "broken.pdf").write_bytes(b"%PDF-1.7\n1 0 obj\n<<")
    with pytest.raises(InputError, match="no readable PDF"):
        read(tmp_path / "broken.pdf")
    from PIL import Image

    scan = fpdf.FPDF(unit="mm", format="A4")
    scan.add_page()
    scan.image(Image.new("RGB", (50, 50), "grey"), 0, 0, 200, 200)
    scan.output(str(tmp_path / "scan.pdf"))
    with pytest.raises(InputError, match="not read from pictures"):
        read(tmp_path / "scan.pdf")


def test_damaged_pdfs_are_refused_or_read(tmp_path: Path) -> None:
    write(flat_solution(), tmp_path / "flat.pdf")
    whole = (tmp_path / "flat.pdf").read_bytes()
    for seed in range(few_or_many(2, 40)):
        chance = random.Random(seed)
        damaged = bytearray(whole)
        for _ in range(chance.randint(1, 200)):
            damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        (tmp_path / "bad.pdf").write_bytes(damaged)
        with suppress(InputError):
            read(tmp_path / "bad.pdf")
