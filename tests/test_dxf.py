"""DXF out: sound, to scale, with blocks, tags, dimensions and layouts; read back it is the plan."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import numpy as np
import pytest
from shapely import Point, Polygon

from flat import flat_brief, flat_solution
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import plan_of, scene_of
from scenewright.drawing.shell import swing_square
from scenewright.formats import read_planned, write

ezdxf = pytest.importorskip("ezdxf")


def save(solution: Solution, path: Path) -> ezdxf.document.Drawing:
    """The document as read back, which the library finds sound."""
    write(solution, path)
    document = ezdxf.readfile(path)
    found = document.audit()
    assert [error.message for error in [*found.errors, *found.fixes]] == []
    return document


@pytest.fixture(scope="module")
def flat(tmp_path_factory: pytest.TempPathFactory) -> ezdxf.document.Drawing:
    return save(flat_solution(), tmp_path_factory.mktemp("dxf") / "flat.dxf")


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> ezdxf.document.Drawing:
    """A house of two levels without furniture."""
    brief, _ = read_planned("sample:home-house")
    empty = dataclasses.replace(flat_solution(), brief=brief, pieces=())
    return save(empty, tmp_path_factory.mktemp("dxf") / "house.dxf")


def outlines(document: ezdxf.document.Drawing, layer: str) -> list[Polygon]:
    lines = document.modelspace().query(f'LWPOLYLINE[layer=="{layer}"]')
    return [Polygon(line.get_points("xy")) for line in lines if line.closed]


def test_rooms_are_closed_polylines_in_metres(flat: ezdxf.document.Drawing) -> None:
    rooms = [space.outline for space in plan_of(flat_brief()).spaces]
    drawn = outlines(flat, "A-AREA")
    assert flat.units == 6
    for room, outline in zip(drawn, rooms, strict=True):
        assert room.symmetric_difference(Polygon(outline)).area < 1e-6


def test_a_wall_of_ten_metres_measures_ten(tmp_path: Path) -> None:
    brief = flat_brief().model_dump(exclude_unset=True)
    brief["rooms"] = [{"id": "hall", "outline": [[0, 0], [10, 0], [10, 4], [0, 4]]}]
    ten = dataclasses.replace(flat_solution(), brief=type(flat_brief()).model_validate(brief))
    ten = dataclasses.replace(ten, pieces=())
    for name, unit, code in (("a.dxf", 1.0, 6), ("a.mm.dxf", 1000.0, 4)):
        document = save(ten, tmp_path / name)
        west, _, east, _ = outlines(document, "A-AREA")[0].bounds
        assert document.units == code
        assert east - west == pytest.approx(10.0 * unit)
        lengths = [dim.get_measurement() for dim in document.modelspace().query("DIMENSION")]
        walls = [outline.bounds for outline in outlines(document, "A-WALL")]
        whole = max(b[2] for b in walls) - min(b[0] for b in walls)
        assert max(lengths) == pytest.approx(whole)
        assert 10.1 * unit < whole < 11.0 * unit


def test_walls_are_closed_and_hatched(flat: ezdxf.document.Drawing) -> None:
    cut = outlines(flat, "A-WALL")
    hatched = flat.modelspace().query('HATCH[layer=="A-WALL-PATT"]')
    assert cut
    assert len(hatched) > 0
    assert all(line.closed for line in flat.modelspace().query('LWPOLYLINE[layer=="A-WALL"]'))


def test_every_drawn_piece_is_a_block_with_attributes(flat: ezdxf.document.Drawing) -> None:
    solution = flat_solution()
    inserts = flat.modelspace().query('INSERT[layer=="A-FURN"]')
    found = {insert.get_attrib_text("ID"): insert for insert in inserts}
    drawn = {piece.id: piece for piece in solution.pieces if piece.id in found}
    assert len(drawn) == len(found) > 3
    for name, insert in found.items():
        pose, size = drawn[name].pose, drawn[name].size
        assert insert.get_attrib_text("KIND") == drawn[name].category
        assert insert.get_attrib_text("SIZE").startswith(f"{size.width:.3f} x {size.depth:.3f}")
        assert insert.has_attrib("PRICE")
        assert (insert.dxf.insert.x, insert.dxf.insert.y) == pytest.approx(pose[:2])
        heading = (insert.dxf.rotation + 90.0 - np.degrees(pose.heading) + 180.0) % 360.0 - 180.0
        assert heading == pytest.approx(0.0, abs=1e-6)


def test_leaves_swing_as_in_the_plan(house: ezdxf.document.Drawing) -> None:
    """Every arc of the ground floor lies in the square that a leaf of the plan sweeps."""
    brief, plan = read_planned("sample:home-house")
    scene = scene_of(dataclasses.replace(flat_solution(), brief=brief, pieces=()), plan)
    first = [o for o in scene.openings if o.level == scene.levels[0].id]
    squares = [s.buffer(0.02) for opening in first if (s := swing_square(opening)) is not None]
    arcs = house.modelspace().query('ARC[layer=="A-DOOR"]')
    inside = 0
    for arc in arcs:
        points = [Point(p.x, p.y) for p in arc.flattening(0.01)]
        inside += any(all(square.covers(point) for point in points) for square in squares)
    assert inside >= len(squares) > 2


def test_a_layout_a_level_to_scale(house: ezdxf.document.Drawing) -> None:
    names = [name for name in house.layouts.names() if name != "Model"]
    assert len(names) == 2
    windows = [house.layouts.get(name).query("VIEWPORT")[-1] for name in names]
    for window in windows:
        scale = 1000 * window.dxf.view_height / window.dxf.height
        assert scale == pytest.approx(round(scale))
        assert round(scale) in (20, 25, 50, 100)
    centres = [window.dxf.view_center_point[0] for window in windows]
    assert abs(centres[1] - centres[0]) > 15.0


def test_names_of_rooms_are_text_and_tags(flat: ezdxf.document.Drawing) -> None:
    words = {text.dxf.text for text in flat.modelspace().query("TEXT")}
    tags = flat.modelspace().query('INSERT[name=="ROOM_TAG"]')
    assert {"Living room", "Bedroom"} <= words
    assert {tag.get_attrib_text("NAME") for tag in tags} == {"Living room", "Bedroom"}
    assert {tag.get_attrib_text("AREA") for tag in tags} == {"20.0 m²", "12.3 m²"}


def test_the_same_solution_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one.dxf", "two.dxf"):
        write(flat_solution(), tmp_path / name)
    assert (tmp_path / "one.dxf").read_bytes() == (tmp_path / "two.dxf").read_bytes()


def test_hostile_names_stay_words(tmp_path: Path) -> None:
    document = save(flat_solution("%%c ^J {\\H3;x} \n0\nEOF 客厅"), tmp_path / "a.dxf")
    words = [
        text.dxf.text for text in document.layouts.get(document.layouts.names()[-1]).query("TEXT")
    ]
    assert any("EOF 客厅" in text for text in words)
    assert not any("%%c" in text for text in words)


def test_meshes_stand_where_the_pieces_do(tmp_path: Path) -> None:
    document = save(flat_solution(), tmp_path / "flat.3d.dxf")
    sofa = next(p for p in flat_solution().pieces if p.id == "sofa")
    insert = next(
        i for i in document.modelspace().query("INSERT") if i.get_attrib_text("ID") == "sofa"
    )
    meshes = document.blocks.get(insert.dxf.name).query("MESH")
    top = max(vertex[2] for mesh in meshes for vertex in mesh.vertices)
    assert top == pytest.approx(sofa.size.height, abs=1e-4)
    assert (insert.dxf.insert.x, insert.dxf.insert.y) == pytest.approx(sofa.pose[:2])


def test_a_missing_extra_is_named_with_its_install_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in [name for name in sys.modules if name.startswith("scenewright.drawing.dxf")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.delitem(sys.modules, "scenewright.formats.dxf", raising=False)
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(InputError, match=r"pip install 'scenewright\[dxf\]'"):
        write(flat_solution(), tmp_path / "flat.dxf")
    assert not list(tmp_path.iterdir())


def test_hatches_are_named_as_every_program_knows_them(tmp_path: Path) -> None:
    """Programs that look a pattern up by its name drop a hatch of another."""
    brief, plan = read_planned("sample:home-services")
    empty = Solution(brief, (), (), (), (), {}, "default", "none", 0, "0", "", 0.0, 0)
    write(empty, tmp_path / "plan.dxf", plan)
    hatches = ezdxf.readfile(tmp_path / "plan.dxf").modelspace().query("HATCH")
    patterned = [hatch for hatch in hatches if not hatch.dxf.solid_fill]
    assert patterned
    assert {hatch.dxf.pattern_name for hatch in patterned} <= {"ANSI31", "SQUARE"}
    for hatch in patterned:
        pitch = max(abs(v) for v in hatch.pattern.lines[0].offset)
        assert 50.0 * hatch.dxf.pattern_scale == pytest.approx(pitch, rel=1e-3)
