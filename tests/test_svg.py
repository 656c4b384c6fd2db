"""The plan: true to scale, safe with hostile names, symbols where they belong."""

from __future__ import annotations

import dataclasses
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import LineString, Point, Polygon, affinity, box, union_all

from flat import flat_solution
from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.space import Level, Opening, Space
from scenewright.domains import draw_plan, scene_of, solve
from scenewright.drawing import rooms
from scenewright.drawing import sheet as svg_sheet
from scenewright.drawing.dimensions import chains
from scenewright.drawing.labels import place, polygon_of
from scenewright.drawing.marks import PaperView, clean, text_width, to_paper
from scenewright.drawing.pieces import drawing_height, footprint, pieces_mark, symbol
from scenewright.drawing.shell import cut_walls, openings_mark, swing_square, walls_mark
from scenewright.drawing.svg import mark_text, number, write_svg
from scenewright.drawing.wordings import extent, wordings
from scenewright.formats import read

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
UNIT = PaperView(20.0, 0.0, 0.0)
PLACES = st.floats(-50, 50)
KINDS = {
    "rug": Kind("rug", flat=True),
    "chair": Kind("chair", under=("table",)),
    "pendant": Kind("pendant", support="ceiling"),
}


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_of(flat_solution())


def rings(path: str) -> list[np.ndarray]:
    """The closed rings of straight path data."""
    return [
        np.array([[float(v) for v in pair.split(",")] for pair in ring.split()])
        for ring in path.strip("MZ").split("ZM")
    ]


def test_walls_keep_their_area_at_scale(scene: Scene) -> None:
    root = ET.fromstring(mark_text(walls_mark(UNIT, scene.walls)))
    dark = [p for p in root.iter("path") if p.get("fill") not in ("#ffffff", "none")]
    drawn = 0.0
    for path in dark:
        outer, *holes = (Polygon(ring) for ring in rings(path.get("d", "")))
        drawn += outer.area - sum(hole.area for hole in holes)
    true = cut_walls(scene.walls).area
    assert true > 5
    assert drawn / UNIT.scale**2 == pytest.approx(true, rel=2e-3)


def test_the_cut_passes_doors_and_windows(scene: Scene) -> None:
    walls = cut_walls(scene.walls)
    for opening in scene.openings:
        assert walls.distance(Point(opening.x, opening.y)) > 0.3


@pytest.mark.parametrize(("width", "leaves"), [(1.29, 1), (1.3, 2), (2.4, 2)])
def test_wide_doors_have_two_leaves(width: float, leaves: int) -> None:
    door = Opening("d", "door", "0", 3.0, 2.0, 1.0, 0.0, width, 0.12, 0, 2.05, 1, 1)
    radii = re.findall(r"A([\d.]+),", mark_text(openings_mark(UNIT, [door])))
    assert [float(r) for r in radii] == pytest.approx([width / leaves * UNIT.scale] * leaves)


@given(
    st.sampled_from([-1, 1]),
    st.sampled_from([-1, 1]),
    st.floats(0, 6.3),
    st.floats(0.5, 1.29),
    st.floats(0.05, 0.4),
)
def test_the_door_arc_turns_around_the_hinge(
    hinge: int, swing: int, angle: float, width: float, thickness: float
) -> None:
    along = np.array([np.cos(angle), np.sin(angle)])
    left = np.array([-along[1], along[0]])
    door = Opening("d", "door", "0", 3.0, 2.0, *along, width, thickness, 0, 2.05, hinge, swing)
    mark = mark_text(openings_mark(UNIT, [door]))
    found = re.search(r"M([-\d.]+),([-\d.]+)A([\d.]+),\S+ 0 0 ([01]) ([-\d.]+),([-\d.]+)", mark)
    assert found
    x0, y0, radius, sweep, x1, y1 = map(float, found.groups())
    start, end = np.array([x0, y0]), np.array([x1, y1])
    middle, half = (start + end) / 2, (end - start) / 2
    # a quarter arc: its centre lies half a chord to the right of the way if it sweeps clockwise
    centre = middle + np.array([-half[1], half[0]]) * (1 if sweep else -1)
    true = [3.0, 2.0] + along * hinge * width / 2 + left * swing * thickness / 2
    assert np.hypot(*(centre - to_paper(UNIT, true))) < 0.05
    assert radius == pytest.approx(width * UNIT.scale, abs=0.01)
    square = swing_square(door)
    assert square is not None
    assert square.area == pytest.approx(width**2)
    assert square.buffer(1e-9).contains(Point(*true))
    tip = affinity.scale(square, 1.02, 1.02)
    assert tip.contains(Point(*(true + left * swing * width)))


@given(PLACES, PLACES, st.floats(-7, 7), st.floats(0.1, 3), st.floats(0.1, 3))
def test_footprints_agree_with_layouts(x: float, y: float, h: float, w: float, d: float) -> None:
    piece = Piece("a", "sofa", "", "r", Pose(x, y, 0, h), Size(w, d, 1))
    from_back_left = np.roll(corners(np.array([x, y, h, w, d])), 1, axis=0)
    assert footprint(piece) == pytest.approx(from_back_left, abs=1e-9)


def test_the_front_is_drawn_at_the_front() -> None:
    piece = Piece("a", "sofa", "", "r", Pose(5, 5, 0, 0.0), Size(2, 1, 1))
    outline, front = symbol(piece, Catalog())
    assert outline[0].tolist() == outline[-1].tolist()
    drawn = mark_text(pieces_mark(PaperView(20, 0, 0), [piece], Catalog()))
    # heading 0 looks to +x, so the front line is right of the middle on paper
    assert f"M{number(108.5)},-120 {number(108.5)},-80" in drawn
    assert front[:, 1].tolist() == [0.425, 0.425]


def test_lower_things_are_drawn_first(scene: Scene) -> None:
    heights = {
        "rug": Piece("rug", "rug", "", "r", Pose(0, 0, 0, 0), Size(3, 2, 0.02)),
        "chair": Piece("chair", "chair", "", "r", Pose(0, 0, 0, 0), Size(0.5, 0.5, 0.95)),
        "table": Piece("table", "table", "", "r", Pose(0, 0, 0, 0), Size(2, 1, 0.75)),
        "vase": Piece("vase", "vase", "", "r", Pose(0, 0, 0.75, 0), Size(0.2, 0.2, 0.3)),
        "lamp": Piece("lamp", "lamp", "", "r", Pose(0, 0, 2.0, 0), Size(0.2, 0.2, 0.3)),
    }
    order = sorted(heights, key=lambda name: drawing_height(heights[name], KINDS))
    assert order == ["rug", "chair", "table", "vase", "lamp"]
    lamp = Piece("p", "pendant", "", "r", Pose(0, 0, 2.0, 0), Size(0.2, 0.2, 0.3))
    drawn = mark_text(pieces_mark(UNIT, [*list(heights.values())[::-1], lamp], Catalog(KINDS)))
    assert "pendant" not in drawn
    assert [drawn.index(f"<title>{name}</title>") for name in order] == sorted(
        drawn.index(f"<title>{name}</title>") for name in order
    )
    assert "stroke-dasharray" in drawn[drawn.index("<title>lamp") - 60 :]


def test_a_hostile_name_stays_text(tmp_path: Path) -> None:
    hostile = '</text><script>alert("1")</script>\x00\n\u202e&amp;"\'<image href="x"/>'
    solution = flat_solution(hostile)
    room = solution.brief.rooms[0].model_copy(update={"name": hostile})
    brief = solution.brief.model_copy(update={"rooms": [room, solution.brief.rooms[1]]})
    piece = dataclasses.replace(solution.pieces[0], category=hostile, asset=hostile)
    solution = dataclasses.replace(solution, brief=brief, pieces=(piece,))
    text = write_svg(rooms.plan(scene_of(solution), Catalog()))
    allowed = {"svg", "title", "rect", "g", "path", "circle", "text", "defs", "pattern"}
    root = ET.fromstring(text)
    assert {node.tag.removeprefix(SVG) for node in root.iter()} <= allowed
    assert not [a for node in root.iter() for a in node.attrib if "href" in a or a[:2] == "on"]
    assert "\u202e" not in text
    assert root.findtext(f"{SVG}title") == clean(hostile)


@given(st.text(max_size=80))
def test_cleaned_words_are_one_printable_line(words: str) -> None:
    found = clean(words, 20)
    assert len(found) <= 20
    assert "\n" not in found
    ET.fromstring(f"<a>{found.replace('&', '').replace('<', '')}</a>")


def test_the_sheet_is_in_millimetres_and_holds_the_drawing(scene: Scene) -> None:
    root = ET.fromstring(write_svg(rooms.plan(scene, Catalog())))
    assert (root.get("version"), root.get("width"), root.get("height")) == ("1.1", "297mm", "210mm")
    _, _, width, height = map(float, root.get("viewBox", "").split())
    for path in root.iter(f"{SVG}path"):
        if set(path.get("d", "")) & set("AHV"):
            continue
        for ring in rings(path.get("d", "")):
            assert ring.min() >= 0
            assert (ring <= [width, height]).all()


@given(st.floats(0.5, 900), st.floats(0.5, 900), st.floats(0, 120), st.floats(0, 80))
def test_every_drawing_gets_a_sheet_it_fits(
    w: float, h: float, more_w: float, more_h: float
) -> None:
    sheet = svg_sheet.choose(w, h, more_w, more_h)
    wide, high = svg_sheet.drawing_area(sheet)
    assert w * 1000 / sheet.scale + more_w <= wide + 1e-6
    assert h * 1000 / sheet.scale + more_h <= high + 1e-6


def test_dimensions_tell_the_building(scene: Scene) -> None:
    root = ET.fromstring(write_svg(rooms.plan(scene, Catalog())))
    words = [node.text for node in root.iter(f"{SVG}text")]
    # 5.00 + 0.12 + 3.08 inside, 0.25 of wall on either side; openings and the wall between
    assert {"8.70", "4.50", "5.31", "3.39", "0.90", "1.80"} <= set(words)
    assert {"Living room", "20.0 m²", "5.00 × 4.00", "Ground floor · ±0.00 · 32.3 m²"} <= set(words)


@pytest.mark.parametrize("side", ["south", "west", "north", "east"])
def test_chains_are_complete_and_in_order(scene: Scene, side: str) -> None:
    walls = union_all([cut_walls(scene.walls), *map(polygon_of, scene.spaces)])
    for chain in chains(walls, walls, scene.spaces, scene.openings)[side]:  # type: ignore[index]
        ends = walls.bounds[0::2] if side in ("south", "north") else walls.bounds[1::2]
        assert (chain.stations[0], chain.stations[-1]) == pytest.approx(ends)
        assert all(b > a for a, b in zip(chain.stations, chain.stations[1:], strict=False))


def test_an_inner_window_is_in_no_outer_chain() -> None:
    """A north window seen through the open door of the south wall belongs to the north only."""
    room = Space("r", "R", (), "0", np.array([[0, 0], [4, 0], [4, 3], [0, 3]], float))
    south = LineString([(0, -0.1), (1, -0.1)]).buffer(0.1, cap_style="flat")
    window = Opening("w", "window", "0", 2.0, 3.1, 1.0, 0.0, 1.0, 0.2, 0.9, 2.2, spaces=("r",))
    solid = union_all([south, polygon_of(room)])
    found = chains(box(0, -0.2, 4, 3.2), solid, [room], [window])
    assert [chain.stations for chain in found["north"]] == [(0, 1.5, 2.5, 4)]
    assert [chain.stations for chain in found["south"]] == [(0, 4)]


def test_a_room_behind_a_row_of_rooms_is_in_no_chain_of_their_side() -> None:
    """The middle of its wall lies behind the wall between the second and the third."""
    row = [box(3.2 * k, 0, 3.2 * k + 3, 4) for k in range(4)]
    rooms = [
        Space(f"r{k}", "", (), "0", np.array(shape.exterior.coords[:-1]))
        for k, shape in enumerate([*row, box(0, 4.2, 12.6, 7)])
    ]
    solid = union_all([polygon_of(room) for room in rooms])
    found = chains(box(0, 0, 12.6, 7), solid, rooms, [])
    assert found["south"][0].stations == pytest.approx((0, 3.1, 6.3, 9.5, 12.6))


def test_corners_are_dimensioned_where_they_are_seen_and_bows_are_not() -> None:
    """A chamfer in the north-east, a step in the south; a bow of short edges adds nothing."""
    outline = [(0, 0), (3, 0), (3, 1), (8, 1), (8, 4), (6, 6), (0, 6)]
    bow = Point(0, 3).buffer(1, quad_segs=16)
    whole = union_all([Polygon(outline), bow])
    room = Space("r", "R", (), "0", np.array(whole.exterior.coords[:-1]))
    found = {
        side: [chain.stations for chain in rows]
        for side, rows in chains(whole, whole, [room], []).items()
    }
    assert found["north"] == [pytest.approx((-1, 0, 6, 8))]
    assert found["east"] == [pytest.approx((0, 1, 4, 6))]
    assert found["south"] == [pytest.approx((-1, 0, 3, 8)), pytest.approx((-1, 8))]


@given(st.integers(0, 2**32 - 1))
def test_labels_stand_on_the_floor_and_off_the_furniture(seed: int) -> None:
    """In a big room of any L shape with a few boxes there is always a free place."""
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(3, 6, 2)
    outline = np.array([[0, 0], [8, 0], [8, b / 2], [a / 2, b / 2], [a / 2, 7], [0, 7]])
    room = Space("r", "Living room", ("living",), "0", outline)
    boxes = [box(x, y, x + 0.6, y + 0.6) for x, y in rng.uniform(0, 7, (3, 2))]
    label, at = place(UNIT, room, union_all(boxes))
    width, height = np.array(extent(label)) / UNIT.scale
    drawn = box(at[0] - width / 2, at[1] - height / 2, at[0] + width / 2, at[1] + height / 2)
    assert drawn.difference(polygon_of(room)).area < 0.02 * drawn.area
    assert drawn.intersection(union_all(boxes)).area < 0.35 * drawn.area


@pytest.mark.parametrize(("wide", "turn"), [(0.7, 0), (0.4, 90)])
def test_a_narrow_room_gets_a_smaller_or_turned_label(wide: float, turn: float) -> None:
    outline = np.array([[0, 0], [wide, 0], [wide, 4], [0, 4]], float)
    room = Space("r", "Long corridor", ("hall",), "0", outline)
    label, _ = place(UNIT, room, Polygon())
    assert label.turn == turn
    assert label in wordings(room, polygon_of(room).area)


def test_a_long_name_is_set_in_two_lines_before_it_leaves_the_room() -> None:
    outline = np.array([[0, 0], [1.2, 0], [1.2, 1.6], [0, 1.6]], float)
    label, _ = place(UNIT, Space("r", "Walk-in wardrobe", (), "0", outline), Polygon())
    assert [words for words, _ in label.lines][:3] == ["Walk-in", "wardrobe", "1.9 m²"]
    assert extent(label)[0] / UNIT.scale < 1.2


def test_wide_scripts_are_given_their_width() -> None:
    assert text_width("客厅", 2.5) == pytest.approx(5.0)
    assert text_width("ab", 2.5) < 3.0


def test_levels_stand_side_by_side(scene: Scene) -> None:
    upper = tuple(
        dataclasses.replace(space, id=f"up-{space.id}", level="up") for space in scene.spaces
    )
    walls = tuple(dataclasses.replace(wall, level="up") for wall in scene.walls)
    two = dataclasses.replace(
        scene,
        levels=(*scene.levels, Level("up", "Upper floor", 2.9, 2.6), Level("void", "", 6, 2)),
        spaces=(*scene.spaces, *upper),
        walls=(*scene.walls, *walls),
    )
    root = ET.fromstring(write_svg(rooms.plan(two, Catalog())))
    captions = [node for node in root.iter(f"{SVG}text") if "floor ·" in (node.text or "")]
    assert [node.text for node in captions] == [
        "Ground floor · ±0.00 · 32.3 m²",
        "Upper floor · +2.90 · 32.3 m²",
    ]
    (x0, y0), (x1, y1) = ((float(c.get("x", 0)), float(c.get("y", 0))) for c in captions)
    scale = 8.7 * 1000 / (50 if "1:50" in ET.tostring(root, "unicode") else 100)
    assert y0 == y1
    assert x1 - x0 > scale


def test_an_empty_scene_still_makes_a_sheet() -> None:
    empty = Scene("nothing", (), (), (), (), ())
    assert ET.fromstring(write_svg(rooms.plan(empty, Catalog()))).tag == f"{SVG}svg"


def test_every_kind_of_scene_is_drawn_in_layers_by_name() -> None:
    """What a drawing program shows and hides: no layer twice, none empty, in the order drawn."""
    samples = {
        "home-room": ["Floors", "Furniture", "Walls", "Names"],
        "hall-shop": ["Zones", "Furniture", "Walls", "Route", "Legend"],
        "site-30": ["Ground", "Buildings", "Names", "Legend"],
    }
    for sample, wanted in samples.items():
        solution = solve(read(f"sample:{sample}"), steps=200)
        drawing = draw_plan(solution)
        names = [layer.name for layer in drawing.layers]
        assert len(set(names)) == len(names)
        assert [name for name in names if name in wanted] == wanted
        root = ET.fromstring(write_svg(drawing))
        layers = [g for g in root.findall(f"{SVG}g") if (g.get("id") or "").startswith("layer-")]
        assert [g.get(f"{INKSCAPE}label") for g in layers] == names
        assert all(len(layer) for layer in layers)
        assert not [node for node in root if node.tag == f"{SVG}path"], "all is in a layer"
