"""The plan of a hall: zones, partitions, route and legend, safe and not too large."""

from __future__ import annotations

import dataclasses
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import LineString, box, union_all

from halls import exhibition, exhibition_rows, large_hall
from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.domains.hall.drawing.narrow import across, narrow_places
from scenewright.domains.hall.drawing.overlay import overlay_of
from scenewright.domains.hall.drawing.plan import halls_of
from scenewright.domains.hall.drawing.route import curve, route_mark
from scenewright.domains.hall.drawing.zones import TINTS, borders_mark, passage, tints
from scenewright.domains.hall.hall_layout import HallDetail, Stop, Tour, Zone
from scenewright.drawing import legend as svg_legend
from scenewright.drawing import rooms
from scenewright.drawing import sheet as svg_sheet
from scenewright.drawing.dimensions import readable
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.marks import (
    POCHE,
    ROUTE,
    WARNING,
    PaperView,
    fit_text,
    text_width,
    to_paper,
)
from scenewright.drawing.pieces import define_repeated_symbols, footprint, pieces_mark
from scenewright.drawing.sheet import scale_bar
from scenewright.drawing.svg import mark_text, write_svg
from scenewright.formats import svg

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
ALLOWED = {"svg", "title", "rect", "g", "path", "circle", "text", "defs", "pattern", "use"}


def drawn(solution: Solution) -> ET.Element:
    halls, catalog = halls_of(solution), shipped()
    overlay = overlay_of(halls, catalog) if halls else None
    return ET.fromstring(write_svg(rooms.plan(scene_of(solution), catalog, overlay)))


def words(root: ET.Element) -> list[str]:
    return [node.text or "" for node in root.iter(f"{SVG}text")]


@pytest.fixture(scope="module")
def root() -> ET.Element:
    return drawn(exhibition())


def test_only_plain_elements_are_used(root: ET.Element) -> None:
    assert {node.tag.removeprefix(SVG) for node in root.iter()} <= ALLOWED
    ids = [node.get("id") for node in root.iter() if node.get("id")]
    assert len(ids) == len(set(ids))
    links = [node.get(LINK, "") for node in root.iter(f"{SVG}use")]
    assert links
    assert {link.removeprefix("#") for link in links} <= set(ids)


def test_zones_are_tinted_and_named(root: ET.Element) -> None:
    fills = [node.get("fill") for node in root.iter(f"{SVG}path")]
    assert {TINTS[0], TINTS[1], TINTS[2]} <= set(fills)
    assert {"Introduction", "The Roman town", "Museum shop", "104.0 m²"} <= set(words(root))
    assert "Exhibition hall" not in words(root)


def test_every_object_is_drawn_once(root: ET.Element) -> None:
    rows = exhibition_rows()
    uses = list(root.iter(f"{SVG}use"))
    many = sum(len(row) for row in rows.values() if len(row) > 1)
    assert len(uses) == many
    titles = [node.findtext(f"{SVG}title") for node in uses]
    assert titles.count("box") == len(rows["stones"])


@given(st.floats(-7, 7), st.floats(-20, 20), st.floats(-20, 20), st.sampled_from([4.0, 20.0]))
def test_used_symbols_lie_where_the_pieces_are(
    heading: float, x: float, y: float, scale: float
) -> None:
    piece = Piece("a", "box", "", "r", Pose(x, y, 0.0, heading), Size(2.0, 1.0, 1.0))
    symbols = define_repeated_symbols(scale, [piece, dataclasses.replace(piece, id="b")], Catalog())
    (definition,) = symbols.definitions
    local = definition.marks[0].rings[0]
    mark = mark_text(pieces_mark(PaperView(scale, 0.0, 0.0), [piece], Catalog(), symbols))
    moved = re.findall(r"translate\(([-\d.]+) ([-\d.]+)\)", mark)[0]
    turn = np.radians(float((re.findall(r"rotate\(([-\d.]+)\)", mark) or [0])[0]))
    cos, sin = np.cos(turn), np.sin(turn)
    placed = local @ np.array([[cos, sin], [-sin, cos]]) + np.array(moved, dtype=float)
    true = to_paper(PaperView(scale, 0.0, 0.0), footprint(piece))
    assert np.abs(placed - true).max() < 0.03


def test_partitions_are_solid_and_borders_dashed_only_where_none_stands() -> None:
    solution = exhibition()
    graph = solution.detail.layout
    assert graph is not None
    paths = drawn(solution).iter(f"{SVG}path")
    dark = "".join(node.get("d", "") for node in paths if node.get("fill") == POCHE)
    bare = drawn(dataclasses.replace(solution, pieces=())).iter(f"{SVG}path")
    without = "".join(node.get("d", "") for node in bare if node.get("fill") == POCHE)
    # two stand free, two join the north wall, one is the sign of the legend
    assert dark.count("M") == without.count("M") + 2 + 1
    standing = [p for p in solution.pieces if p.category == "partition"]
    walls = union_all(
        [
            box(
                p.pose.x - 0.08,
                p.pose.y - p.size.width / 2,
                p.pose.x + 0.08,
                p.pose.y + p.size.width / 2,
            )
            for p in standing
        ]
        + [box(0, 0, 24, 16).boundary.buffer(0.02)]
    )
    mark = mark_text(borders_mark(PaperView(1.0, 0.0, 0.0), graph.zones, walls))
    lines = [
        LineString([tuple(map(float, pair.split(","))) for pair in d.split()])
        for d in re.findall(r'd="M([^"]+)"', mark)
    ]
    # gaps of 2.4 and 2.2 m, and the foyer's border along all zones, each 6 cm off the walls
    total = sum(line.length for line in lines)
    assert total == pytest.approx(2.4 + 2.2 + 24.0 - 4 * 0.06 - 2 * 0.28 - 2 * 0.08, abs=0.1)


def test_the_legend_counts(root: ET.Element) -> None:
    told = words(root)
    assert "Coins: 12 display cabinets" in told
    assert {"radiation", "8 boxes", "6 bookcases", "Till", "Circulation"} <= set(told)
    assert any(re.fullmatch(r"\d+ m, 6 stops", word) for word in told)
    numbers = [word for word in told if word in "123456"]
    assert sorted(numbers) == sorted("123456" * 2 + "12")  # twice each, and the scale bar


def test_doors_tell_their_use_and_width(root: ET.Element) -> None:
    assert {"Entrance 1.80 m", "Exit 1.80 m", "In and out 2.40 m"} <= set(words(root))


def test_links_tell_the_least_width(root: ET.Element) -> None:
    assert {"≥ 1.80 m", "≥ 1.20 m"} <= set(words(root))


def test_a_passage_is_found_in_the_gap() -> None:
    graph = exhibition().detail.layout
    assert graph is not None
    walls = union_all([box(7.9, 3, 8.1, 6.6), box(7.9, 9, 8.1, 16)])
    found = passage(graph.zones[:2], 1.8, walls, LineString([(0, 0), (0, 1)]))
    assert found is not None
    assert found.open
    assert found.at[0] == pytest.approx(8.0)
    assert 6.6 + 0.85 < found.at[1] < 9.0 - 0.85
    shut = passage(graph.zones[:2], 3.0, walls, LineString([(0, 0), (0, 1)]))
    assert shut is not None
    assert not shut.open


def test_narrow_places_are_marked_with_their_width(root: ET.Element) -> None:
    tour = exhibition().detail.tours[0]
    assert tour.widths[5:-5].min() < 1.2
    figures = [node for node in root.iter(f"{SVG}text") if node.get("fill") == WARNING]
    told = {float(node.text or "") for node in figures}
    assert told
    assert max(told) < 1.2
    # books end at 22.85 m, the wall is at 24 m
    assert min(told) == pytest.approx(1.15, abs=0.02)


@given(st.floats(0.3, 3.0), st.floats(0.1, 0.9), st.floats(0, 6.3))
def test_widths_across_are_those_of_the_aisle(wide: float, share: float, turn: float) -> None:
    along = np.array([np.cos(turn), np.sin(turn)])
    left = np.array([-along[1], along[0]])
    walls = union_all(
        [
            LineString([-9 * along + s * left, 9 * along + s * left])
            for s in (-share * wide, (1 - share) * wide)
        ]
    )
    widths, ends = across(np.zeros((1, 2)), 2.0 * wide, walls)
    assert widths[0] == pytest.approx(wide, rel=1e-6)
    assert np.hypot(*(ends[0, 1] - ends[0, 0])) == pytest.approx(wide, rel=1e-6)


def test_a_way_along_one_wall_is_not_narrow() -> None:
    points = np.column_stack([np.linspace(0, 20, 41), np.full(41, 0.45)])
    tour = Tour("hall", points, np.full(41, 0.9), ())
    floor = box(-1, -1, 21, 0)
    assert narrow_places(tour, 1.2, floor) == []
    (place,) = narrow_places(tour, 1.2, union_all([floor, box(9.8, 1.0, 10.2, 2.0)]))[:1]
    assert place.width == pytest.approx(1.0)


@given(st.integers(1, 40), st.integers(0, 2**32 - 1))
def test_neighbouring_zones_differ(count: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    zones = []
    for k in range(count):
        x, y = divmod(k, 6)
        outline = np.array(box(x, y, x + 1, y + 1).exterior.coords[:-1])
        zones.append(Zone(f"z{k}", "", "hall", outline))
    zones = [zones[k] for k in rng.permutation(count)]
    found = tints(zones)
    for one in zones:
        for two in zones:
            near = np.abs(one.outline.mean(0) - two.outline.mean(0)).sum() < 1.1
            assert one.id == two.id or not near or (found["hall", one.id] != found["hall", two.id])


def test_tints_differ_in_grey_and_carry_ink() -> None:
    def lightness(colour: str) -> float:
        rgb = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
        linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
        return float(116 * np.cbrt(linear @ [0.2126, 0.7152, 0.0722]) - 16)

    found = sorted(lightness(colour) for colour in TINTS)
    assert np.diff(found).min() > 1.2
    assert found[0] > 78


def test_the_route_passes_its_points() -> None:
    points = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 20.0], [30.0, 25.0]])
    assert curve(points)[::3] == pytest.approx(points)


def test_numbers_of_stops_do_not_meet() -> None:
    points = np.column_stack([np.linspace(0, 30, 301), np.zeros(301)])
    stops = tuple(Stop(f"g{k}", 150) for k in range(5))
    tour = Tour("hall", points, np.full(301, 2.0), stops)
    numbers = {f"g{k}": k + 1 for k in range(5)}
    mark = mark_text(route_mark(PaperView(10, 0, 0), tour, numbers, []))
    discs = re.findall(rf'<circle cx="([-\d.]+)" cy="[-\d.]+" r="1.75" fill="{ROUTE}"', mark)
    assert len(discs) == 5
    assert np.diff(sorted(map(float, discs))).min() > 3.5


def test_a_hall_of_2000_objects_stays_small(tmp_path: Path) -> None:
    svg.write(large_hall(2000), tmp_path / "hall.svg")
    text = (tmp_path / "hall.svg").read_text(encoding="utf-8")
    assert len(text.encode()) < 3e6
    root = ET.fromstring(text)
    assert len(list(root.iter(f"{SVG}use"))) == 2000
    assert "1:200" in words(root)


def test_hostile_names_stay_text() -> None:
    hostile = '</text><script>alert("1")</script>\x00\u202e&"<image href="x"/>'
    solution = exhibition(hostile)
    graph = solution.detail.layout
    assert graph is not None
    zones = tuple(zone._replace(name=hostile) for zone in graph.zones)
    groups = tuple(group._replace(pattern=hostile, demand=hostile) for group in graph.groups)
    room = solution.brief.rooms[0]
    demands = [demand.model_copy(update={"name": hostile}) for demand in room.demands]
    room = room.model_copy(update={"demands": demands})
    brief = solution.brief.model_copy(update={"rooms": [room]})
    solution = dataclasses.replace(
        solution,
        detail=solution.detail._replace(layout=graph._replace(zones=zones, groups=groups)),
        brief=brief,
    )
    root = drawn(solution)
    assert {node.tag.removeprefix(SVG) for node in root.iter()} <= ALLOWED
    assert "\u202e" not in ET.tostring(root, "unicode")


def test_what_makes_no_sense_is_left_out() -> None:
    """A file may name spaces, groups and points that do not exist."""
    solution = exhibition()
    graph, tour = solution.detail.layout, solution.detail.tours[0]
    assert graph is not None
    crossed = Zone("x", "Crossed", "hall", np.array([[0, 0], [4, 4], [4, 0], [0, 4.0]]))
    nothing = Zone("y", "Nothing", "hall", np.array([[0, 0], [1, 0], [2, 0.0]]))
    lost = Zone("z", "Lost", "nowhere", np.array([[0, 0], [1, 0], [1, 1.0]]))
    link = graph.links[0]._replace(first="x", second="unknown")
    broken = graph._replace(
        zones=(*graph.zones, crossed, nothing, lost),
        links=(*graph.links, link, link._replace(first="y", second="z", space="nowhere")),
        groups=(*graph.groups, graph.groups[0]._replace(id="more", objects=("none",))),
    )
    tours = (
        tour._replace(widths=tour.widths[:9], stops=(Stop("none", 3), Stop("more", 10**6))),
        tour._replace(points=tour.points[:1]),
        tour._replace(points=np.zeros((3, 2)), widths=-np.ones(3)),
        tour._replace(space="nowhere"),
    )
    text = words(drawn(dataclasses.replace(solution, detail=HallDetail(broken, tours))))
    assert "Crossed" in text
    assert "Nothing" not in text


@given(st.floats(5, 300), st.floats(5, 300), st.integers(1, 150))
def test_the_legend_lies_on_the_sheet_beside_the_drawing(w: float, h: float, count: int) -> None:
    rows = [LegendRow("heading" if k % 9 == 0 else "plain", "words") for k in range(count)]
    found = svg_legend.arrange((w, h), (40.0, 40.0), rows)
    sheet, (wide, high) = found.sheet, found.room
    assert w * 1000 / sheet.scale + 40 <= wide + 1e-6
    assert h * 1000 / sheet.scale + 40 <= high + 1e-6
    assert sum(len(part) for *_, part in found.columns) == count
    area = svg_sheet.drawing_area(sheet)
    for left, top, part in found.columns:
        assert left + svg_legend.COLUMN <= svg_sheet.EDGE + area[0] + 1e-6
        assert top + len(part) * svg_legend.ROW <= svg_sheet.EDGE + area[1] + 1e-6
        assert left >= svg_sheet.EDGE + wide - 1e-6 or top >= svg_sheet.EDGE + high - 1e-6


@given(st.lists(st.floats(0.01, 39.9), max_size=30), st.sampled_from([20.0, 10.0, 5.0, 1.0]))
def test_figures_of_chains_have_room(inner: list[float], scale: float) -> None:
    stations = (0.0, *sorted(set(inner)), 40.0)
    kept = readable(stations, scale)
    assert (kept[0], kept[-1]) == (0.0, 40.0)
    assert np.diff(kept).min() * scale >= min(text_width("0.00", 1.6), 40.0 * scale)


@pytest.mark.parametrize("scale", [50, 100, 200, 500, 1000])
def test_the_title_strip_of_a_portrait_sheet_holds_its_words(scale: int) -> None:
    sheet = svg_sheet.PaperSheet(210.0, 297.0, scale)
    mark = ET.fromstring(mark_text(svg_sheet.sheet_mark(sheet, "A" * 60, "words " * 30)))
    texts = [
        (float(n.get("x", 0)), float(n.get("font-size", 0)), n.text or "")
        for n in mark.iter("text")
    ]
    bar = min(x for x, _, word in texts if word == "0")
    for x, size, word in texts[:1] + [t for t in texts if t[2].startswith("words")]:
        assert x + text_width(word, size) < bar - 1.0
    assert "".join(re.findall(r">(\d+ m)<", mark_text(scale_bar(150, 10, scale, 50))))


@given(
    st.text(st.characters(min_codepoint=33, max_codepoint=126), min_size=1, max_size=60),
    st.floats(2, 60),
)
def test_fitted_words_fit(letters: str, room: float) -> None:
    told, size = fit_text(letters, 2.0, room)
    assert text_width(told, size) <= room + 1e-6 or len(told) <= 1
