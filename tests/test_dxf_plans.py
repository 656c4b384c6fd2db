"""DXF in: rooms of drawings as people make them, units, doors, storeys, hostile files."""

from __future__ import annotations

import random
from contextlib import suppress
from itertools import pairwise
from pathlib import Path

import pytest
from shapely import Polygon

from flat import flat_solution
from scenewright.cli import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.isolated_reading import Allowance, read_apart
from scenewright.formats import read, write
from thoroughness import few_or_many

ezdxf = pytest.importorskip("ezdxf")


def areas(brief: Brief) -> list[float]:
    """Floor areas of the rooms, the largest first."""
    found = [Polygon(room.outline, room.holes).area for room in brief.rooms]
    return sorted((round(area, 2) for area in found), reverse=True)


def draw(path: Path, unit: int, size: float, layer: str = "0", leaf: bool = True) -> None:
    """Two rooms of 4 x 3 m and 3 x 3 m side by side, walls 0.2 m thick as double lines, a door of
    0.8 m between them and one to the outside, drawn ``size`` units a metre, far from the origin."""
    ezdxf.options.write_fixed_meta_data_for_testing = True
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = unit
    model = document.modelspace()
    far = 14_000.0

    def line(*points: tuple[float, float]) -> None:
        moved = [((x + far) * size, (y - far) * size) for x, y in points]
        for a, b in pairwise(moved):
            model.add_line(a, b, dxfattribs={"layer": layer})

    line((0, 1.9), (0, 3), (4, 3), (4, 1.9), (4.2, 1.9), (4.2, 3), (7.2, 3), (7.2, 0), (4.2, 0))
    line((4.2, 0), (4.2, 1.1), (4, 1.1), (4, 0), (0, 0), (0, 1.1))
    line((-0.2, 1.1), (-0.2, -0.2), (7.4, -0.2), (7.4, 3.2), (-0.2, 3.2), (-0.2, 1.9), (0, 1.9))
    line((-0.2, 1.1), (0, 1.1))
    if leaf:
        for x in (4.0, 0.0):
            middle = ((x + far) * size, (1.1 - far) * size)
            model.add_arc(middle, 0.8 * size, 90, 180, dxfattribs={"layer": layer})
            line((x, 1.1), (x - 0.8, 1.1))
    for x, words in ((2.0, "%%uKITCHEN"), (5.7, "Schlafzimmer")):
        place = ((x + far) * size, (1.5 - far) * size)
        model.add_text(words, height=0.2 * size).set_placement(place)
    document.saveas(path)


@pytest.mark.parametrize(
    ("unit", "size"), [(6, 1.0), (4, 1000.0), (4, 1.0), (1, 100.0), (0, 1 / 0.0254), (5, 100.0)]
)
def test_rooms_whatever_the_header_says(tmp_path: Path, unit: int, size: float) -> None:
    draw(tmp_path / "plan.dxf", unit, size)
    brief = read(tmp_path / "plan.dxf")
    assert areas(brief) == [12.0, 9.0]
    assert brief.input_report is not None
    assert brief.input_report.complete


@pytest.mark.parametrize("layer", ["Wände", "墙体", "xref$0$A-WALL", "Стены", "0"])
def test_layers_in_any_language(tmp_path: Path, layer: str) -> None:
    draw(tmp_path / "plan.dxf", 6, 1.0, layer)
    assert areas(read(tmp_path / "plan.dxf")) == [12.0, 9.0]


def test_gaps_are_doors_without_a_leaf(tmp_path: Path) -> None:
    draw(tmp_path / "plan.dxf", 6, 1.0, leaf=False)
    brief = read(tmp_path / "plan.dxf")
    doors = [door for room in brief.rooms for door in room.doors]
    assert areas(brief) == [12.0, 9.0]
    assert [door.swing for door in doors] == ["none", "none"]
    assert all(door.width == pytest.approx(0.8, abs=0.01) for door in doors)


def test_names_doors_and_their_leaves(tmp_path: Path) -> None:
    draw(tmp_path / "plan.dxf", 6, 1.0)
    brief = read(tmp_path / "plan.dxf")
    kitchen = next(room for room in brief.rooms if room.name == "KITCHEN")
    assert {room.name for room in brief.rooms} == {"KITCHEN", "Schlafzimmer"}
    inner = next(door for door in kitchen.doors if door.at[0] > 3)
    assert (inner.swing, inner.hinge) == ("in", "right")
    assert inner.at == pytest.approx((4.0, 1.5))


def test_a_threshold_leaves_the_opening_in_the_wall(tmp_path: Path) -> None:
    """The door to the outside is closed by a line on the outer face, as thresholds are drawn."""
    draw(tmp_path / "plan.dxf", 6, 1.0)
    document = ezdxf.readfile(tmp_path / "plan.dxf")
    document.modelspace().add_line((13_999.8, -13_998.9), (13_999.8, -13_998.1))
    document.saveas(tmp_path / "plan.dxf")
    brief = read(tmp_path / "plan.dxf")
    assert areas(brief) == [12.0, 9.0]
    assert sorted(len(room.doors) for room in brief.rooms) == [0, 2]


def test_elevations_beside_a_plan_are_no_storeys(tmp_path: Path) -> None:
    """A front of many panes is larger than the plan, and has no way in."""
    draw(tmp_path / "plan.dxf", 6, 1.0)
    document = ezdxf.readfile(tmp_path / "plan.dxf")
    for k in range(20):
        x, y = 14_020 + 2 * (k % 10), -14_000 + 1.5 * (k // 10)
        pane = [(x, y), (x + 2, y), (x + 2, y + 1.5), (x, y + 1.5)]
        document.modelspace().add_lwpolyline(pane, close=True)
    document.saveas(tmp_path / "plan.dxf")
    assert areas(read(tmp_path / "plan.dxf")) == [12.0, 9.0]


def add_lines(path: Path, *lines: tuple[tuple[float, float], ...]) -> None:
    """Add lines to the drawing of :func:`draw` in metres, in its coordinates."""
    document = ezdxf.readfile(path)
    for points in lines:
        moved = [(x + 14_000, y - 14_000) for x, y in points]
        document.modelspace().add_lwpolyline(moved)
    document.saveas(path)


def broken(*corners: tuple[float, float]) -> list[tuple[tuple[float, float], ...]]:
    """A ring of walls as strokes 3 m long with 2 m between them, and 1 m at corners."""
    strokes: list[tuple[tuple[float, float], ...]] = []
    for (x, y), (u, v) in pairwise((*corners, corners[0])):
        length = max(abs(u - x), abs(v - y))
        dx, dy = (u - x) / length, (v - y) / length
        for k in range(0, int(length) - 2, 5):
            strokes.append(((x + k * dx, y + k * dy), (x + (k + 3) * dx, y + (k + 3) * dy)))
    return strokes


def test_floor_that_no_room_has_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A third room whose walls are full of gaps: it is named as not read, exit code 1."""
    draw(tmp_path / "plan.dxf", 6, 1.0)
    add_lines(tmp_path / "plan.dxf", *broken((8.4, -0.8), (12.4, -0.8), (12.4, 3.2), (8.4, 3.2)))
    assert run(["plan", str(tmp_path / "plan.dxf")]) == 1
    assert "m² of drawn floor were read" in capsys.readouterr().err
    brief = read(tmp_path / "plan.dxf")
    assert areas(brief) == [12.0, 9.0]
    assert brief.input_report is not None
    assert brief.input_report.drawn_floor == pytest.approx(21.0 + 4.0 * 4.0, rel=0.15)


def test_rooms_that_cover_little_of_what_the_walls_span_are_no_plan(tmp_path: Path) -> None:
    """A hall of broken walls around two closets with doors: the closets are not the plan."""
    draw(tmp_path / "plan.dxf", 6, 1.0)
    corners = ((-8.0, -10.0), (16.0, -10.0), (16.0, 14.0), (-8.0, 14.0))
    add_lines(tmp_path / "plan.dxf", *broken(*corners))
    with pytest.raises(
        InputError, match=r"close rooms of 21.0 m² of the \d+\.\d m² that they span"
    ):
        read(tmp_path / "plan.dxf")


def test_rooms_without_doors_are_no_plan(tmp_path: Path) -> None:
    """A page of boxes, one with a gap: strips between dimensions, a table of words."""
    draw(tmp_path / "plan.dxf", 6, 1.0)
    boxes = [
        ((x, y), (x + 3.0, y), (x + 3.0, y + 2.0), (x, y + 2.0), (x, y))
        for x in (7.4, 10.4, 13.4, 16.4)
        for y in (-0.2, 1.8, 3.8)
    ]
    add_lines(tmp_path / "plan.dxf", *boxes)
    with pytest.raises(InputError, match=r"2 of 1\d rooms have doors"):
        read(tmp_path / "plan.dxf")


def test_a_corridor_around_rooms_is_a_room(tmp_path: Path) -> None:
    """Four cells with a door each on the walk around them, all within an outer wall."""
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = 6
    model = document.modelspace()
    for thick in (0.0, 0.2):
        low, right, top = -1 - thick, 13 + thick, 5 + thick
        model.add_lwpolyline([(low, low), (right, low), (right, top), (low, top)], close=True)
    for k in range(4):
        x = 3.0 * k
        cell = [(x + 1.8, 0), (x + 2.8, 0), (x + 2.8, 4), (x, 4), (x, 0), (x + 1, 0)]
        model.add_lwpolyline(cell)
    document.saveas(tmp_path / "plan.dxf")
    assert areas(read(tmp_path / "plan.dxf")) == [39.2, 11.2, 11.2, 11.2, 11.2]


def test_our_own_plans_read_back(tmp_path: Path) -> None:
    solution = flat_solution()
    for name in ("flat.dxf", "flat.mm.dxf"):
        write(solution, tmp_path / name)
        brief = read(tmp_path / name)
        assert areas(brief) == areas(solution.brief)
        assert {room.name for room in brief.rooms} == {"Living room", "Bedroom"}


def test_what_is_no_plan_is_refused_with_its_reason(tmp_path: Path) -> None:
    document = ezdxf.new()
    for k in range(30):
        document.modelspace().add_line((k * 1000.0, 0), (k * 900.0, 5e4))
    document.saveas(tmp_path / "map.dxf")
    with pytest.raises(InputError, match="holds no floor plan"):
        read(tmp_path / "map.dxf")
    (tmp_path / "a.dxf").write_bytes(b"AC1032" + b"\0" * 100)
    with pytest.raises(InputError, match=r"DWG.*save it as .dxf"):
        read(tmp_path / "a.dxf")
    ezdxf.new().saveas(tmp_path / "none.dxf")
    with pytest.raises(InputError, match=r"no lines that may be walls; save the model"):
        read(tmp_path / "none.dxf")


@pytest.mark.parametrize("suffix", ["dxf", "pdf", "svg", "ifc", "json"])
def test_empty_files_are_refused_as_empty(tmp_path: Path, suffix: str) -> None:
    (tmp_path / f"b.{suffix}").write_bytes(b"")
    with pytest.raises(InputError, match="is empty: 0 bytes; save or export it again"):
        read(tmp_path / f"b.{suffix}")


def test_binary_dxf_is_read_as_its_text(tmp_path: Path) -> None:
    draw(tmp_path / "plan.dxf", 6, 1.0)
    ezdxf.readfile(tmp_path / "plan.dxf").saveas(tmp_path / "binary.dxf", fmt="bin")
    assert (tmp_path / "binary.dxf").read_bytes().startswith(b"AutoCAD Binary DXF")
    assert areas(read(tmp_path / "binary.dxf")) == [12.0, 9.0]


def test_damaged_files_are_refused_or_read(tmp_path: Path) -> None:
    draw(tmp_path / "plan.dxf", 6, 1.0)
    whole = (tmp_path / "plan.dxf").read_bytes()
    for seed in range(few_or_many(3, 60)):
        chance = random.Random(seed)
        damaged = bytearray(whole)
        for _ in range(chance.randint(1, 30)):
            damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        cut = chance.choice([len(damaged), chance.randrange(len(damaged))])
        (tmp_path / "bad.dxf").write_bytes(damaged[:cut])
        with suppress(InputError):
            read(tmp_path / "bad.dxf")


def test_hostile_files_end_in_bounded_time_and_memory(tmp_path: Path) -> None:
    """Blocks in blocks without end, curves and arcs as far as numbers go: what can be read is."""
    draw(tmp_path / "plan.dxf", 6, 1.0)
    document = ezdxf.readfile(tmp_path / "plan.dxf")
    model = document.modelspace()
    for number in range(40):
        block = document.blocks.new(f"B{number}")
        for _ in range(8 if number else 0):
            block.add_blockref(f"B{number - 1}", (0, 0))
    model.add_blockref("B3", (0, 0))
    for radius in (1e30, 1e160, 1e300):
        model.add_arc((1e300, 14_000), radius, 0, 90)
        model.add_arc((1e17, 14_000, radius), 1.0, 0, 200)
    points = [(0, 0, 0), (1, 0, 1e300), (1, 1, -1e300), (0, 1, 0)]
    model.add_open_spline(points)
    document.saveas(tmp_path / "far.dxf")
    assert areas(read(tmp_path / "far.dxf")) == [12.0, 9.0]
    model.add_blockref("B39", (0, 0))
    document.saveas(tmp_path / "bomb.dxf")
    limits = Allowance(memory=1024, per_size=16, seconds=3)
    with pytest.raises(InputError, match="within 3 s and"):
        read_apart("scenewright.formats.dxf.entities", tmp_path / "bomb.dxf", limits, {"scale": 1})


def test_the_command_writes_the_brief_and_a_picture(tmp_path: Path) -> None:
    draw(tmp_path / "plan.dxf", 4, 1000.0)
    outputs = [str(tmp_path / name) for name in ("brief.json", "plan.svg")]
    given = [part for name in outputs for part in ("-o", name)]
    assert run(["plan", str(tmp_path / "plan.dxf"), *given, "-q"]) == 0
    assert areas(read(outputs[0])) == [12.0, 9.0]
    assert "KITCHEN" in Path(outputs[1]).read_text(encoding="utf-8")


def test_a_refused_file_leaves_nothing_behind(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "bad.dxf").write_text("0\nSECTION\n2\nENTITIES\n", encoding="utf-8")
    assert run(["plan", str(tmp_path / "bad.dxf"), "-o", str(tmp_path / "brief.json")]) == 2
    assert not (tmp_path / "brief.json").exists()
    assert len(capsys.readouterr().err.strip().splitlines()) == 1


@pytest.mark.realdata
def test_rooms_of_real_drawings(real_data: Path) -> None:
    """As many rooms as were counted, and of rectangular ones the areas by their corners within
    3 %."""
    folder = real_data / "professional_files" / "dxf"
    if not folder.is_dir():
        pytest.skip("the drawings are not there")
    by_corners = {
        "small_house_librecad": [35.16, 16.0, 8.0],
        "rooms_schematic_depthmap": [30.0, 24.26, 24.26, 19.11, 14.46, 14.46],
    }
    for name, listed in by_corners.items():
        assert areas(read(folder / f"{name}.dxf")) == pytest.approx(listed, rel=0.03)
    counts = {"ship_deck_jupedsim": 6, "house_double_wall_gama": 9, "iso_office_jupedsim": 13}
    counts["barcelona_pavilion_sheet_autocad"] = 4
    for name, count in counts.items():
        assert len(read(folder / f"{name}.dxf").rooms) == count
