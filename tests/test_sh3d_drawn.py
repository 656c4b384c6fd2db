"""Homes as they are drawn in Sweet Home 3D: gaps for doors, roofs, tilted pieces, and a fate for
every element."""

from __future__ import annotations

import zipfile
from collections import Counter
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest
import shapely

from scenewright import formats
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.input_report import InputReport
from scenewright.core.errors import InputError

CASES = Path(__file__).parent / "data" / "field_cases"
PIECES = ("pieceOfFurniture", "light", "doorOrWindow", "shelfUnit", "furnitureGroup")


def wall(number: int, x0: int, y0: int, x1: int, y1: int, more: str = "") -> str:
    return (
        f"<wall id='w{number}' xStart='{x0}' yStart='{y0}' xEnd='{x1}' yEnd='{y1}' height='250' "
        f"thickness='10' {more}/>"
    )


def box(width: int, depth: int) -> str:
    """Four walls around a floor, from the corner (0, 0)."""
    corners = [(0, 0), (width, 0), (width, depth), (0, depth), (0, 0)]
    return "".join(wall(k, *a, *b) for k, (a, b) in enumerate(pairwise(corners)))


def room(name: str, x0: int, y0: int, x1: int, y1: int) -> str:
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    points = "".join(f"<point x='{x}' y='{y}'/>" for x, y in corners)
    return f"<room name='{name}'>{points}</room>"


def piece(name: str, x: int, y: int, size: tuple[int, int, int], more: str = "") -> str:
    width, depth, height = size
    return (
        f"<pieceOfFurniture name='{name}' x='{x}' y='{y}' width='{width}' depth='{depth}' "
        f"height='{height}' {more}/>"
    )


def read(folder: Path, *parts: str, keep: bool = False) -> Brief:
    path = folder / "home.xml"
    path.write_text(f"<home version='7400' wallHeight='250'>{''.join(parts)}</home>")
    return formats.read(path, keep=keep)


def area(room: Room) -> float:
    return float(shapely.Polygon(room.outline, room.holes).area)


def report_of(brief: Brief) -> InputReport:
    assert brief.input_report is not None
    return brief.input_report


def test_gaps_for_doors_are_passages() -> None:
    brief = formats.read(CASES / "f07_wall_gaps_for_doors.sh3d")
    areas = sorted(round(area(room)) for room in brief.rooms)
    doors = [door for room in brief.rooms for door in room.doors]
    assert areas == [1, 15, 22] or areas == [2, 15, 22]
    assert [door.swing for door in doors] == ["none", "none"]
    assert all(0.85 < door.width < 0.95 for door in doors)
    report = report_of(brief)
    assert report.complete
    assert report.features == 9
    assert report.drawn_floor == report.read_floor


@pytest.mark.parametrize(("gap", "rooms"), [(60, 2), (149, 2), (170, 1)])
def test_a_wall_that_ends_before_another_leaves_a_passage(
    tmp_path: Path, gap: int, rooms: int
) -> None:
    brief = read(tmp_path, box(800, 500), wall(9, 400, 0, 400, 495 - gap))
    assert len(brief.rooms) == rooms
    assert sum(len(room.doors) for room in brief.rooms) == rooms - 1


def test_a_low_wall_or_a_joined_one_leaves_no_gap(tmp_path: Path) -> None:
    low = wall(9, 400, 0, 400, 400).replace("height='250'", "height='110'")
    assert len(read(tmp_path, box(800, 500), low).rooms) == 1
    whole = read(tmp_path, box(800, 500), wall(9, 400, 0, 400, 500))
    assert [len(room.doors) for room in whole.rooms] == [0, 0]


def test_a_door_in_a_gap_stays_the_only_one(tmp_path: Path) -> None:
    door = (
        "<doorOrWindow catalogId='eTeks#door' name='Door' x='400' y='450' angle='1.5707964' "
        "width='90' depth='10' height='208'><sash xAxis='0.05' yAxis='0.6' width='0.9' "
        "startAngle='0' endAngle='-1.57'/></doorOrWindow>"
    )
    brief = read(tmp_path, box(800, 500), wall(9, 400, 0, 400, 405), door)
    assert [d.swing != "none" for room in brief.rooms for d in room.doors] == [True]


def test_floor_behind_a_wide_gap_is_missed_and_said(tmp_path: Path) -> None:
    walls = [(0, 0, 800, 0), (800, 0, 800, 500), (800, 500, 700, 500), (450, 500, 0, 500)]
    walls += [(0, 500, 0, 0), (300, 0, 300, 500)]
    brief = read(tmp_path, *(wall(k, *ends) for k, ends in enumerate(walls)))
    assert [round(area(room)) for room in brief.rooms] == [14]
    assert not report_of(brief).complete
    assert 0.3 < (report_of(brief).floor_share or 1) < 0.5
    assert "gaps of more than 1.5 m (2.50 m near (5.75, -5.00))" in brief.notes[0]


def test_what_walls_enclose_beside_drawn_rooms_is_read(tmp_path: Path) -> None:
    brief = read(
        tmp_path, box(800, 500), wall(9, 400, 0, 400, 500), room("Kitchen", 5, 5, 395, 495)
    )
    assert [room.name for room in brief.rooms] == ["Kitchen", "Room 2"]


def test_a_door_among_the_furniture_is_a_door() -> None:
    brief = formats.read(CASES / "f23_door_as_furniture.sh3d")
    (room,) = brief.rooms
    (door,) = room.doors
    assert (door.width, *door.at) == pytest.approx((0.91, 1.0, -4.45))
    assert not room.fixed


@pytest.mark.parametrize(
    ("name", "y", "doors"),
    [("Входная дверь", 500, 1), ("Zimmertür", 500, 1), ("Door", 250, 0), ("Wardrobe", 500, 0)],
)
def test_only_what_is_called_a_door_and_lies_in_a_wall(
    tmp_path: Path, name: str, y: int, doors: int
) -> None:
    brief = read(tmp_path, box(600, 500), piece(name, 300, y, (90, 12, 205)))
    assert sum(len(room.doors) for room in brief.rooms) == doors


def test_tilted_pieces_take_the_box_around_them() -> None:
    brief = formats.read(CASES / "f09_tilted_furniture.sh3d")
    sizes = {
        item.name: tuple(round(side, 2) for side in item.size) for item in brief.rooms[0].fixed
    }
    assert sizes == {"Bookcase": (0.9, 2.0, 0.3), "Beam": (2.26, 0.2, 2.26)}


def test_the_box_of_a_tilted_piece_is_computed_where_the_file_leaves_it_out(tmp_path: Path) -> None:
    lying = piece("Bookcase", 300, 250, (90, 30, 200), "pitch='-1.5707964' movable='false'")
    leaning = piece("Beam", 300, 100, (200, 20, 20), "roll='0.7853982' movable='false'")
    brief = read(tmp_path, box(600, 500), lying, leaning)
    sizes = [tuple(round(side, 2) for side in item.size) for item in brief.rooms[0].fixed]
    assert sizes == [(0.9, 2.0, 0.3), (1.56, 0.2, 1.56)]


def test_walls_higher_at_one_end_slope_the_ceiling(tmp_path: Path) -> None:
    gable = [(0, 0, 400, 0, 100, 250), (400, 0, 800, 0, 250, 100)]
    gable += [(800, 500, 400, 500, 100, 250), (400, 500, 0, 500, 250, 100)]
    parts = [
        wall(k, *ends, f"heightAtEnd='{b}'").replace("height='250'", f"height='{a}'", 1)
        for k, (*ends, a, b) in enumerate(gable)
    ]
    knees = [wall(8, 800, 0, 800, 500), wall(9, 0, 500, 0, 0)]
    parts += [knee.replace("height='250'", "height='100'") for knee in knees]
    (attic,) = read(tmp_path, *parts).rooms
    assert len(attic.slopes) == 2
    for slope in attic.slopes:
        (x0, _), (x1, _) = attic.outline[slope.edge], attic.outline[(slope.edge + 1) % 4]
        assert x0 == x1
        assert x0 in (0.05, 7.95)
        assert slope.knee == pytest.approx(1.0 + 0.05 * 1.5 / 4, abs=1e-3)
        assert slope.pitch == pytest.approx(0.3588, abs=1e-3)


COOKING = [
    piece("Cooker", 40, 40, (60, 60, 90), "catalogId='eTeks#cooker' movable='false'"),
    piece("Sink", 110, 40, (80, 60, 90), "catalogId='eTeks#sink' movable='false'"),
]


@pytest.mark.parametrize(
    ("name", "functions"),
    [("Living room", ("living", "kitchen")), ("Kitchen", ("kitchen",)), ("Xyzzy", ("kitchen",))],
)
def test_a_kitchen_taken_out_is_a_function_of_its_room(
    tmp_path: Path, name: str, functions: tuple[str, ...]
) -> None:
    home = (box(600, 500), room(name, 5, 5, 595, 495), *COOKING)
    assert spaces(read(tmp_path, *home))[0].functions == functions
    if name == "Living room":
        assert spaces(read(tmp_path, *home, keep=True))[0].functions == ("living",)


def test_what_is_taken_out_and_not_brought_back_is_left_out(tmp_path: Path) -> None:
    bed = piece("Bed", 300, 250, (140, 190, 60), "catalogId='eTeks#bed140x190'")
    brief = read(tmp_path, box(600, 500), room("Bathroom", 5, 5, 595, 495), bed)
    rows = {(row.kind, row.outcome): row for row in report_of(brief).rows}
    assert "--keep keeps it" in rows["piece of furniture", "left out"].reason


def count_features(path: Path) -> Counter[str]:
    """Elements in the home itself and pieces in its groups, counted from the XML alone."""
    root = ElementTree.fromstring(home_xml(path))
    found: Counter[str] = Counter()
    groups = [child for group in root.iter("furnitureGroup") for child in group]
    found.update(child.tag for child in root)
    found.update(child.tag for child in groups if child.tag in PIECES)
    found["backgroundImage"] += sum(1 for _ in root.findall("level/backgroundImage"))
    return found


def home_xml(path: Path) -> bytes:
    if path.suffix == ".xml":
        return path.read_bytes()
    with zipfile.ZipFile(path) as archive:
        return archive.read("Home.xml")


@pytest.mark.realdata(quick=True)
def test_every_element_of_real_homes_has_a_fate(real_data: Path) -> None:
    homes = [*real_data.rglob("*.sh3d"), *(real_data / "furnished_homes_sh3d").glob("*.xml")]
    assert homes
    for path in homes:
        report = report_of(formats.read(path))
        counted = count_features(path)
        assert report.features == counted.total(), path.name
        walls = sum(row.count for row in report.rows if row.kind == "wall")
        openings = sum(row.count for row in report.rows if row.kind in ("door", "window"))
        assert walls == counted["wall"], path.name
        assert openings >= counted["doorOrWindow"], path.name
        assert (report.floor_share or 0) >= 0.95, path.name


@pytest.mark.parametrize(("unit", "factor"), [("inches", 2.54), ("millimetres", 0.1)])
def test_a_home_in_another_unit_is_told_its_factor(
    tmp_path: Path, unit: str, factor: float
) -> None:
    def far(value: float) -> str:
        return f"{value / factor:.4f}"

    ends = [(0, 0, 600, 0), (600, 0, 600, 400), (600, 400, 0, 400), (0, 400, 0, 0)]
    walls = "".join(
        f"<wall id='w{k}' xStart='{far(a)}' yStart='{far(b)}' xEnd='{far(c)}' yEnd='{far(d)}' "
        f"height='{far(250)}' thickness='{far(10)}'/>"
        for k, (a, b, c, d) in enumerate(ends)
    )
    path = tmp_path / "home.xml"
    path.write_text(f"<home version='7400' wallHeight='{far(250)}'>{walls}</home>")
    with pytest.raises(InputError, match=f"--scale {factor:g} if it is drawn in {unit}"):
        formats.read(path)
    (room,) = spaces(formats.read(path, scale=factor))
    assert shapely.Polygon(room.outline).area == pytest.approx(5.9 * 3.9, abs=0.01)
    assert room.height == pytest.approx(2.5, abs=0.01)
