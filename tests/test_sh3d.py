"""Sweet Home 3D homes: a small one of our own, and the real ones."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path

import numpy as np
import pytest
import shapely

from scenewright import formats
from scenewright.building.outlines import signed_area
from scenewright.building.plan import spaces
from scenewright.catalog.kinds import KINDS
from scenewright.core.brief import Brief
from scenewright.core.space import Space
from scenewright.formats.sh3d.archive import home_xml
from scenewright.formats.sh3d.floors import floors
from scenewright.formats.sh3d.kinds import CATALOG, SEVERAL, kind_of
from scenewright.formats.sh3d.pieces import fixed_item, flatten_groups
from scenewright.formats.sh3d.xml import HomeWall, middle_line, parse

# Two rooms side by side, 4 x 3 m and 3 x 3 m, walls 20 and 10 cm; y grows down the page.
WALLS = """
<wall id='n' wallAtStart='w' wallAtEnd='e' xStart='-10' yStart='-10' xEnd='720' yEnd='-10'
 thickness='20' height='260'/>
<wall id='e' wallAtStart='n' wallAtEnd='s' xStart='720' yStart='-10' xEnd='720' yEnd='310'
 thickness='20'/>
<wall id='s' wallAtStart='e' wallAtEnd='w' xStart='720' yStart='310' xEnd='-10' yEnd='310'
 thickness='20'/>
<wall id='w' wallAtStart='s' wallAtEnd='n' xStart='-10' yStart='310' xEnd='-10' yEnd='-10'
 thickness='20'/>
<wall id='m' xStart='405' yStart='-10' xEnd='405' yEnd='310' thickness='10'/>
"""
ROOMS = """
<room name='Wohnzimmer'><point x='-10' y='-10'/><point x='405' y='-10'/><point x='405' y='310'/>
<point x='-10' y='310'/></room>
<room name='主卧'><point x='405' y='0'/><point x='710' y='0'/><point x='710' y='300'/>
<point x='405' y='300'/></room>
"""
OPENINGS = """
<doorOrWindow catalogId='eTeks#door' name='Door' x='405' y='100' angle='1.5707964' width='90'
 depth='14' height='208' movable='false'>
 <sash xAxis='0.05' yAxis='0.6' width='0.9' startAngle='0' endAngle='-1.5707964'/></doorOrWindow>
<doorOrWindow catalogId='eTeks#doorFrame' name='Frame' x='405' y='100' angle='1.5707964'
 width='90' depth='10' height='210'/>
<doorOrWindow catalogId='eTeks#window85x123' name='Fenster' x='200' y='-10' width='85'
 depth='24' height='123' elevation='90'/>
"""
PIECES = """
<pieceOfFurniture catalogId='eTeks#sofa' name='Sofa' x='200' y='45' width='180' depth='90'
 height='80'/>
<furnitureGroup name='Essgruppe' x='300' y='200' width='100' depth='100' height='75'>
 <pieceOfFurniture name='Esstisch' x='300' y='200' width='90' depth='90' height='75'/>
 <pieceOfFurniture name='Stuhl' x='300' y='240' angle='3.1415927' width='45' depth='45'
  height='90'/></furnitureGroup>
<pieceOfFurniture catalogId='eTeks#hotWaterRadiator' name='Radiator' x='600' y='8' width='80'
 depth='12' height='60' elevation='10' movable='false'/>
<pieceOfFurniture name='Lit double' x='605' y='150' angle='4.712389' width='160' depth='200'
 height='60'/>
<pieceOfFurniture name='Ghost' x='600' y='250' width='10' depth='10' height='10'
 visible='false'/>
<light catalogId='eTeks#pendantLamp' name='Lamp' x='2000' y='150' width='30' depth='30'
 height='30' elevation='200'/>
"""


def home(*parts: str) -> str:
    return f"<?xml version='1.0'?><home version='7000' wallHeight='260'>{''.join(parts)}</home>"


def read(folder: Path, *parts: str, keep: bool = False) -> Brief:
    path = folder / "home.sh3d"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Home", b"\xac\xed")
        archive.writestr("Home.xml", home(*parts))
    return formats.read(path, keep=keep)


def test_rooms_are_freed_of_walls(tmp_path: Path) -> None:
    living, bedroom = spaces(read(tmp_path, WALLS, ROOMS))
    assert living.functions == ("living",)
    assert bedroom.functions == ("double_bedroom",)
    assert [signed_area(s.outline) for s in (living, bedroom)] == pytest.approx([12, 9])
    assert living.outline.min(0) == pytest.approx((0, -3))
    assert living.height == pytest.approx(2.6)


def test_doors_and_windows(tmp_path: Path) -> None:
    """The door's front is to the west (a quarter turn on the page), so it opens into the west
    room; its hinge, left of the back seen from the front, is to the north."""
    brief = read(tmp_path, WALLS, ROOMS, OPENINGS)
    assert sum(len(room.doors) for room in brief.rooms) == 1
    living, _ = spaces(brief)
    door = next(o for o in living.openings if o.kind == "door")
    window = next(o for o in living.openings if o.kind == "window")
    assert (door.x, door.y) == pytest.approx((4.05, -1.0))
    assert door.thickness == pytest.approx(0.1)
    assert set(door.spaces) == {space.id for space in spaces(brief)}
    opens = door.swing * np.array([-door.uy, door.ux])
    assert opens == pytest.approx((-1, 0))
    assert door.hinge * door.uy == pytest.approx(1)
    assert (window.x, window.y, window.thickness) == pytest.approx((2.0, 0.1, 0.2))
    assert (window.sill, window.head) == pytest.approx((0.9, 2.13))


def test_movable_furniture_goes_and_built_in_stays(tmp_path: Path) -> None:
    empty = read(tmp_path, WALLS, ROOMS, PIECES)
    assert [item.category for room in empty.rooms for item in room.fixed] == ["radiator"]
    kept = read(tmp_path, WALLS, ROOMS, PIECES, keep=True)
    living = {item.category: item for item in kept.rooms[0].fixed}
    bedroom = {item.category: item for item in kept.rooms[1].fixed}
    assert set(living) == {"sofa", "dining_table", "dining_chair"}
    assert set(bedroom) == {"radiator", "double_bed"}
    assert math.cos(living["sofa"].heading + math.pi / 2) == pytest.approx(1)
    assert math.cos(living["dining_chair"].heading - math.pi / 2) == pytest.approx(1)
    assert math.cos(bedroom["double_bed"].heading) == pytest.approx(1)
    assert bedroom["radiator"].z == pytest.approx(0.1)


def test_walls_alone_make_rooms(tmp_path: Path) -> None:
    living, bedroom = spaces(read(tmp_path, WALLS, PIECES))
    assert (living.name, living.functions) == ("Room 1", ("living", "dining"))
    assert bedroom.functions == ("double_bedroom",)
    assert signed_area(living.outline) == pytest.approx(12, abs=1e-3)
    bare = spaces(read(tmp_path, WALLS))
    assert [space.functions for space in bare] == [("living",), ("bedroom",)]


def test_overlapping_and_adjoining_rooms(tmp_path: Path) -> None:
    small = "<room name='Bad'><point x='250' y='0'/><point x='400' y='0'/><point x='400' y='150'/>"
    small += "<point x='250' y='150'/></room>"
    found = {s.name: s for s in spaces(read(tmp_path, WALLS, ROOMS, small))}
    assert signed_area(found["Bad"].outline) == pytest.approx(2.25)
    assert signed_area(found["Wohnzimmer"].outline) == pytest.approx(12 - 2.25)
    passages = [o for o in found["Bad"].openings if o.kind == "passage"]
    assert sorted(o.width for o in passages) == pytest.approx([1.5, 1.5])


def test_levels(tmp_path: Path) -> None:
    up = "<level id='a' elevation='0' height='250'/><level id='b' elevation='280' height='240'/>"
    roof = "<level id='c' elevation='560' height='100' visible='false'/>"
    walls = [WALLS.replace("<wall ", f"<wall level='{x}' ") for x in "abc"]
    found = spaces(read(tmp_path, up, roof, *walls))
    assert [space.level for space in found] == ["a", "a", "b", "b"]
    assert [space.height for space in found] == [2.5, 2.5, 2.4, 2.4]


def test_arcs_are_polylines_on_their_circle() -> None:
    """A half circle that starts at the right end and turns counter-clockwise passes above."""
    wall = HomeWall("", "", (1.0, 0.0), (-1.0, 0.0), 0.1, None, math.pi, ("", ""))
    line = middle_line(wall)
    assert np.linalg.norm(line, axis=1) == pytest.approx(np.ones(len(line)))
    assert line[len(line) // 2] == pytest.approx((0, 1))
    assert line[[0, -1]].ravel().tolist() == pytest.approx([1, 0, -1, 0])


@pytest.mark.parametrize(
    ("attributes", "kind"),
    [
        ("catalogId='eTeks#bed90x190' name='x' width='90'", "single_bed"),
        ("name='King bed'", "double_bed"),
        ("name='Couchtisch'", "coffee_table"),
        ("name='Canapé'", "sofa"),
        ("name='Table basse'", "coffee_table"),
        ("name='床头柜'", "nightstand"),
        ("name='书桌'", "desk"),
        ("name='ソファ'", "sofa"),
        ("name='Office chair 3'", "office_chair"),
        ("name='Kitchen cabinet'", "base_cabinet"),
        ("name='Bureau'", "desk"),
        ("name='Kleiderschrank'", "wardrobe"),
        ("name='Thingamajig'", "obstacle"),
    ],
)
def test_kinds_by_catalog_and_name(attributes: str, kind: str) -> None:
    width = "" if "width" in attributes else "width='180'"
    text = home(f"<pieceOfFurniture {attributes} {width} x='0' y='0' depth='90' height='50'/>")
    assert kind_of(parse(text.encode()).pieces[0]) == kind


HOMES = {
    "2BedroomApartment": (7, 7, 5),
    "2BedroomHouseWithBasement": (13, 15, 12),
    "3BedroomApartment": (9, 10, 11),
    "3BedroomHouseWithAttic": (10, 10, 11),
    "4BedroomHouse": (11, 16, 6),
    "Studio": (5, 5, 2),
}


def real(folder: Path, name: str) -> Path:
    path = folder / "furnished_homes_sh3d" / f"{name}.xml"
    if not path.is_file():
        pytest.skip(f"no {path}")
    return path


@pytest.mark.realdata(quick=True)
@pytest.mark.parametrize("name", HOMES)
def test_real_homes(real_data: Path, name: str) -> None:
    """Counts of rooms, doors (with open sides) and windows, looked at in drawings."""
    brief = formats.read(real(real_data, name))
    doors = sum(len(room.doors) for room in brief.rooms)
    windows = sum(len(room.windows) for room in brief.rooms)
    assert (len(brief.rooms), doors, windows) == HOMES[name]
    assert all(o.width > 0.3 for s in spaces(brief) for o in s.openings)


@pytest.mark.realdata(quick=True)
@pytest.mark.parametrize("name", HOMES)
def test_real_walls_enclose_most_of_the_drawn_rooms(real_data: Path, name: str) -> None:
    home_ = parse(home_xml(real(real_data, name)))
    for level in {room.level for room in home_.rooms}:
        drawn = shapely.union_all([f.polygon for f in floors(home_, level)])
        alone = floors(home_._replace(rooms=()), level)
        within = sum(floor.polygon.intersection(drawn).area for floor in alone)
        assert within > 0.9 * sum(floor.polygon.area for floor in alone)


@pytest.mark.realdata(quick=True)
def test_fronts_of_real_furniture(real_data: Path) -> None:
    """Backs of wardrobes and toilets are nearer to a wall than their fronts; doors mostly open
    into the room that is no corridor."""
    nearer = []
    for name in HOMES:
        brief = formats.read(real(real_data, name), keep=True)
        for space, room in zip(spaces(brief), brief.rooms, strict=True):
            walls = shapely.LinearRing(space.outline)
            for item in room.fixed:
                if item.category in ("wardrobe", "toilet", "double_bed", "vanity", "fridge"):
                    ahead = np.array([math.cos(item.heading), math.sin(item.heading)])
                    reach = ahead * item.size[1] / 2
                    front, back = (shapely.Point(np.add(item.at, s * reach)) for s in (1, -1))
                    nearer.append(walls.distance(back) < walls.distance(front))
    assert len(nearer) > 40
    assert np.mean(nearer) > 0.9


@pytest.mark.realdata(quick=True)
def test_real_pieces_all_have_a_kind(real_data: Path) -> None:
    """Only plain shapes (boxes, cylinders, triangles) stay unknown."""
    for name in HOMES:
        for piece in flatten_groups(parse(home_xml(real(real_data, name))).pieces):
            known = kind_of(piece) != "obstacle" or piece.catalog.startswith("texturable")
            assert known or piece.kind == "doorOrWindow", piece.name
            assert fixed_item(piece).size[0] > 0


@pytest.mark.realdata(quick=True)
def test_real_doors_open_into_rooms(real_data: Path) -> None:
    into_hall, into_room = 0, 0
    for name in HOMES:
        halls: dict[str, Space] = {s.id: s for s in spaces(formats.read(real(real_data, name)))}
        for door in {o.id: o for s in halls.values() for o in s.openings if o.swing}.values():
            pair = [halls[i] for i in door.spaces]
            if len(pair) == 2 and sum("hall" in s.functions for s in pair) == 1:
                inside = pair[0] if door.swing > 0 else pair[1]
                into_hall += "hall" in inside.functions
                into_room += "hall" not in inside.functions
    assert into_room > 2 * into_hall


def test_every_kind_is_in_the_catalog() -> None:
    named = set(CATALOG.values()) | {kind for kinds in SEVERAL.values() for kind in kinds}
    assert named - set(SEVERAL) - {""} <= set(KINDS)
