"""The shipped catalog: every model at every size fills its box, is sound and drawn in plan."""

from __future__ import annotations

from functools import cache
from importlib.util import resolve_name
from itertools import pairwise

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from every import every
from scenewright.catalog.assets import assets_of, shipped
from scenewright.catalog.assets.declared import drawings_of
from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Asset, Part
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, clipped_ears, extrude, merge, rotate_mesh, volume
from scenewright.geometry.solids import cushion, frame, lathe, leaf, tube

REQUIRED = (
    "sofa loveseat corner_sofa armchair dining_chair office_chair stool bar_stool bench pouf "
    "dining_table round_table coffee_table side_table desk kids_desk console_table vanity "
    "double_bed single_bed bunk_bed cot nightstand wardrobe chest_of_drawers bookcase "
    "shelf_unit sideboard display_cabinet tv_stand shoe_cabinet coat_rack storage_shelf toy_box "
    "wall_shelf base_cabinet drawer_cabinet sink_cabinet hob_cabinet oven_cabinet dishwasher "
    "fridge tall_cabinet wall_cabinet hood kitchen_island corner_cabinet toilet basin "
    "pedestal_basin bathtub shower washing_machine dryer mirror towel_rail bathroom_cabinet "
    "laundry_basket tv monitor laptop speaker floor_lamp table_lamp desk_lamp pendant_lamp "
    "ceiling_lamp rug plant potted_tree picture curtain wall_clock books vase bowl "
    "outdoor_table outdoor_chair deck_chair planter drying_rack radiator column staircase "
    "fireplace piano exercise_bike ironing_board box obstacle "
    "showcase plinth exhibit_panel wall_exhibit interactive_table info_desk ticket_gate "
    "rope_barrier exhibit_island gondola wall_shelving ring_shelf clothes_rail round_rack "
    "mannequin display_table checkout fitting_room fridge_shelf basket_stack book_stack "
    "reading_table reading_chair carrel lounge_seat catalogue_terminal auditorium_seat lectern pew "
    "stage screen counter partition litter_bin sign_totem lockers vending_machine "
    "building tree lamp_post site_bench "
)

ASSETS = list(shipped().assets.values())
SIZES = ("smallest", "usual", "largest")
CASES = [(a, getattr(a, s)) for a in ASSETS for s in SIZES]


def name_asset(row: Asset | tuple[Asset, Size]) -> str:
    """An asset, and the size it is drawn in."""
    return f"{row[0].id} of {row[1]}" if isinstance(row, tuple) else row.id


@cache
def _mesh(asset: Asset, size: Size) -> tuple[Part, ...]:
    return asset.mesh(size)


MOST_TRIANGLES = {"usual": 5000, "largest": 9000}


def _bounds(parts: tuple[Part, ...]) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate([p.vertices for p in parts])
    return points.min(0), points.max(0)


@every(CASES, name_asset)
def test_a_mesh_fills_exactly_its_box(asset: Asset, size: Size) -> None:
    low, high = _bounds(_mesh(asset, size))
    w, d, h = size
    assert low == pytest.approx([-w / 2, -d / 2, 0], abs=1e-6)
    assert high == pytest.approx([w / 2, d / 2, h], abs=1e-6)


@every(CASES, name_asset)
def test_parts_are_closed_and_look_outward(asset: Asset, size: Size) -> None:
    for part in _mesh(asset, size):
        assert np.isfinite(part.vertices).all()
        assert part.vertices.dtype == np.float64
        assert part.faces.dtype == np.int64
        assert 0 <= part.faces.min() <= part.faces.max() < len(part.vertices)
        assert _open_edges(part.faces) == 0, f"{asset.id}: {part.material.name} is not closed"
        assert _areas(part).min() > 1e-12, f"{asset.id}: {part.material.name} has a flat face"
        least = _volumes(part).min()
        assert least > 0, f"{asset.id}: {part.material.name} has a body turned inside out {least}"


def _open_edges(faces: np.ndarray) -> int:
    """Directed edges without exactly one partner in the other direction."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    count = int(faces.max()) + 1
    there, back = edges @ (count, 1), edges[:, ::-1] @ (count, 1)
    return len(np.setxor1d(there, back)) + len(there) - len(np.unique(there))


def _areas(part: Part) -> np.ndarray:
    a, b, c = (part.vertices[part.faces[:, i]] for i in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def _volumes(part: Part) -> np.ndarray:
    """Signed volume of every connected body."""
    edges = np.concatenate([part.faces[:, [0, 1]], part.faces[:, [1, 2]]])
    label = trimesh.graph.connected_component_labels(edges, len(part.vertices))[part.faces[:, 0]]
    start = np.zeros((label.max() + 1, 3))
    start[label] = part.vertices[part.faces[:, 0]]
    a, b, c = (part.vertices[part.faces[:, i]] - start[label] for i in range(3))
    found = np.zeros(label.max() + 1)
    np.add.at(found, label, np.einsum("ij,ij->i", a, np.cross(b, c)) / 6)
    return found[np.unique(label)]


@every(ASSETS, name_asset)
def test_meshes_are_light_and_sizes_ordered(asset: Asset) -> None:
    for which, most in MOST_TRIANGLES.items():
        assert sum(len(p.faces) for p in _mesh(asset, getattr(asset, which))) <= most
    assert np.all(np.array(asset.smallest) > 0)
    assert np.all(np.array(asset.smallest) <= asset.usual)
    assert np.all(np.array(asset.usual) <= asset.largest)


@every(ASSETS, name_asset)
def test_equal_sizes_give_equal_meshes(asset: Asset) -> None:
    first, second = _mesh(asset, asset.usual), asset.mesh(asset.usual)
    for one, other in zip(first, second, strict=True):
        assert one.material == other.material
        assert np.array_equal(one.vertices, other.vertices)


@every(CASES, name_asset)
def test_a_symbol_stays_inside_the_footprint(asset: Asset, size: Size) -> None:
    lines = asset.symbol(size)
    assert lines
    half = np.array(size[:2]) / 2
    for line in lines:
        assert line.ndim == 2
        assert line.shape[1] == 2
        assert len(line) >= 2
        assert np.all(np.abs(line) <= half + 1e-9), asset.id
    extent = np.abs(np.concatenate(lines)).max(0)
    assert np.all(extent > 0.6 * half)


def test_a_colour_takes_no_part_away() -> None:
    assets = shipped().assets
    faces = {name: sum(len(p.faces) for p in a.mesh(a.usual)) for name, a in assets.items()}
    numbered = [name for name in faces if name.rpartition("_")[2].isdigit()]
    coloured = {n: n.rpartition("_")[0] for n in numbered if n.rpartition("_")[0] in faces}
    assert len(coloured) > 20
    assert [name for name, of in coloured.items() if faces[name] != faces[of]] == []


def test_the_required_categories_are_there() -> None:
    found = {asset.category for asset in ASSETS}
    assert not set(REQUIRED.split()) - found
    assert found == set(KINDS) == set(shipped().kinds)
    assert all(category == kind.category for category, kind in KINDS.items())
    assert {u for kind in KINDS.values() for u in kind.under} <= found


def test_ids_are_unique_and_materials_valid() -> None:
    listed = [asset.id for kind in KINDS.values() for asset in assets_of(kind)]
    assert len(listed) == len(set(listed)) == len(shipped().assets)
    drawn = {name for kind in KINDS.values() for name in kind.drawn_by}
    for name in drawn:
        for drawing in drawings_of(resolve_name(name, "scenewright.catalog.assets")):
            assert name in KINDS[drawing.category].drawn_by, drawing
    names: dict[str, object] = {}
    for asset in ASSETS:
        for part in _mesh(asset, asset.usual):
            material = part.material
            shares = (*material.color, material.roughness, material.metallic, material.opacity)
            assert all(0 <= v <= 1 for v in (*shares, material.emission))
            assert names.setdefault(material.name, material) == material


@pytest.mark.parametrize(
    ("category", "size", "chosen"),
    [
        ("sofa", Size(2.1, 0.9, 0.8), "sofa"),
        ("wardrobe", Size(1.0, 0.6, 2.2), "wardrobe"),
        ("wardrobe", Size(2.6, 0.65, 2.3), "wardrobe_sliding"),
        ("potted_tree", Size(0.5, 0.5, 1.5), "potted_tree"),
        ("potted_tree", Size(0.4, 0.4, 0.6), "potted_tree_low"),
    ],
)
def test_choose_takes_the_asset_that_fits(category: str, size: Size, chosen: str) -> None:
    asset = shipped().choose(category, size)
    assert asset is not None
    assert asset.id == chosen


def test_seats_look_to_the_front_and_beds_have_their_head_behind() -> None:
    for name in ("sofa", "armchair", "dining_chair", "office_chair", "toilet", "double_bed", "cot"):
        asset = shipped().assets[name]
        points = np.concatenate([p.vertices for p in asset.mesh(asset.usual)])
        top = points[points[:, 2] > 0.85 * asset.usual.height]
        if name != "cot":
            assert top[:, 1].mean() < -0.1 * asset.usual.depth, name
    tv = shipped().assets["tv"]
    screen = next(p for p in tv.mesh(tv.usual) if p.material.name == "screen")
    case = next(p for p in tv.mesh(tv.usual) if p.material.name == "black metal")
    case_front = case.vertices[case.vertices[:, 2] > 0.3, 1].max()
    assert screen.vertices[:, 1].max() > case_front


@given(st.integers(3, 14), st.integers(0, 10_000))
def test_ears_cover_a_star_polygon(count: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    angle = (np.arange(count) + rng.uniform(0.1, 0.9, count)) * 2 * np.pi / count
    ring = rng.uniform(0.3, 2, (count, 1)) * np.column_stack([np.cos(angle), np.sin(angle)])
    if count == 3 and np.max(np.diff(np.append(angle, angle[0] + 2 * np.pi))) >= np.pi:
        return
    following = np.roll(ring, -1, 0)
    area = np.sum(ring[:, 0] * following[:, 1] - ring[:, 1] * following[:, 0]) / 2
    triangles = ring[clipped_ears(ring)]
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    each = np.cross(np.pad(b - a, ((0, 0), (0, 1))), np.pad(c - a, ((0, 0), (0, 1))))[:, 2] / 2
    assert len(triangles) == count - 2
    assert np.all(each > -1e-12)
    assert each.sum() == pytest.approx(area)
    assert volume(extrude(ring, 0.5, 2.0)) == pytest.approx(1.5 * area)


@given(st.floats(-3, 3), st.sampled_from("xyz"))
def test_turning_keeps_the_volume(angle: float, axis: str) -> None:
    body = merge([cushion((0, 1), (0, 0.4), (0, 0.2)), frame((2, 3), (0, 0.1), (0, 1), 0.1)])
    kept = volume(body)
    assert volume(rotate_mesh(body, axis, angle, (1, 2, 3))) == pytest.approx(kept)


def test_a_lathe_has_the_volume_of_its_prism() -> None:
    sides = 12
    share = sides / 2 * np.sin(2 * np.pi / sides)
    assert volume(lathe([(1, 0), (1, 2)], sides=sides)) == pytest.approx(2 * share)


@given(
    st.lists(st.sampled_from([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)]), min_size=1, max_size=6)
)
def test_a_bent_tube_has_the_volume_of_its_length(steps: list[tuple[int, int, int]]) -> None:
    path = np.cumsum([(0, 0, 0), *steps], axis=0).astype(float)
    length = sum(float(np.linalg.norm(b - a)) for a, b in pairwise(path))
    section = 6 / 2 * np.sin(2 * np.pi / 6) * 0.05**2
    assert volume(tube(path, 0.05, 6)) == pytest.approx(section * length)


@given(st.floats(-0.5, 1.5), st.floats(0, 2), st.floats(-7, 7))
def test_a_leaf_is_closed(rise: float, droop: float, turn: float) -> None:
    found: Mesh = leaf(0.4, 0.1, rise, droop, turn, (1, 2, 3))
    assert _open_edges(found.faces) == 0
    assert volume(Mesh(found.vertices - (1, 2, 3), found.faces)) > 0
