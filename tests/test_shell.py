"""Walls: exact areas, none in a room, none in another, every opening open."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely import Polygon

from scenewright import formats
from scenewright.building.joinery import parts, to_plan_coordinates
from scenewright.building.plan import spaces
from scenewright.building.shell import opening_box, shell
from scenewright.core.brief import Brief
from scenewright.core.scene import Wall
from scenewright.core.space import Opening
from scenewright.geometry import rays
from scenewright.geometry.mesh import merge, volume
from scenewright.geometry.prisms import corner_normals, face_normals, prism, triangles

SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3]]


def brief_of(*rooms: dict[str, Any], **rest: Any) -> Brief:
    return Brief.model_validate({"rooms": list(rooms), **rest})


def built(brief: Brief) -> tuple[tuple[Wall, ...], tuple[Opening, ...]]:
    return shell(brief, spaces(brief))


def solid_volume(walls: tuple[Wall, ...]) -> float:
    return sum(
        Polygon(p.outline, p.holes).area * (p.top - p.base) for wall in walls for p in wall.prisms
    )


def bodies(walls: tuple[Wall, ...], height: float) -> list[Polygon]:
    """What a level cut at a height goes through, wall by wall."""
    return [
        Polygon(p.outline, p.holes)
        for wall in walls
        for p in wall.prisms
        if p.base < height < p.top
    ]


def caster(walls: tuple[Wall, ...]) -> rays.Caster:
    return rays.build(
        *merge([prism(p.outline, p.base, p.top, p.holes) for w in walls for p in w.prisms])[:2]
    )


def blocked(walls: tuple[Wall, ...], opening: Opening, along: float, height: float) -> bool:
    """Whether a ray through an opening, 0.6 m from face to face, meets a wall."""
    out = np.array([-opening.uy, opening.ux, 0.0])
    side = np.array([opening.ux, opening.uy, 0.0]) * along * opening.width / 2
    middle = np.array([opening.x, opening.y, height]) + side
    start = middle - out * (opening.thickness / 2 + 0.2)
    return bool(rays.is_occluded(caster(walls), [start], [out], opening.thickness + 0.4)[0])


def star(radii: list[float]) -> list[list[float]]:
    """A polygon around the origin, acute where neighbours differ much."""
    turn = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    return np.column_stack([radii * np.cos(turn), radii * np.sin(turn)]).round(6).tolist()


def test_a_square_room_has_walls_of_exact_volume() -> None:
    window = {"at": [2, 0], "width": 1.0, "sill": 0.9, "height": 1.4}
    walls, _ = built(brief_of({"outline": SQUARE, "windows": [window]}))
    assert solid_volume(walls) == pytest.approx((4.5 * 3.5 - 12) * 2.6 - 1.0 * 0.25 * 1.4, abs=1e-6)
    assert len({wall.id for wall in walls}) == 4


def test_between_rooms_the_gap_is_wall_and_nothing_else() -> None:
    for gap in (0.05, 0.12, 0.3, 0.5):
        other = [[4 + gap, 0], [7 + gap, 0], [7 + gap, 3], [4 + gap, 3]]
        walls, _ = built(brief_of({"outline": SQUARE}, {"outline": other}))
        outer = (7 + gap + 0.5) * 3.5
        assert solid_volume(walls) / 2.6 == pytest.approx(outer - 12 - 9, abs=1e-6)


def test_rooms_that_touch_get_a_thin_wall_with_its_door() -> None:
    other = [[4, 0], [7, 0], [7, 3], [4, 3]]
    door = {"at": [4, 1.5], "width": 0.8, "to": "b"}
    walls, openings = built(
        brief_of({"id": "a", "outline": SQUARE, "doors": [door]}, {"id": "b", "outline": other})
    )
    thin = shapely.union_all(bodies(walls, 1.0)).intersection(shapely.box(3.5, 0, 4.5, 3))
    assert thin.area == pytest.approx(0.04 * (3 - 0.8), abs=1e-9)
    assert not blocked(walls, openings[0], 0.0, 1.0)


def test_a_balcony_has_a_parapet_and_no_high_outer_wall() -> None:
    deck = [[0.5, -1.7], [3.5, -1.7], [3.5, -0.25], [0.5, -0.25]]
    walls, _ = built(
        brief_of({"id": "a", "outline": SQUARE}, {"outline": deck, "function": "balcony"})
    )
    high = shapely.union_all(bodies(walls, 2.0))
    low = shapely.union_all(bodies(walls, 0.5))
    assert high.bounds[1] == pytest.approx(-0.25)
    assert low.bounds[1] == pytest.approx(-1.8)
    assert max(p.top for w in walls if "parapet" in w.id for p in w.prisms) == 1.05


def test_columns_are_solid_and_named() -> None:
    column = [[1, 1], [1.4, 1], [1.4, 1.4], [1, 1.4]]
    walls, _ = built(brief_of({"id": "a", "outline": SQUARE, "holes": [column]}))
    named = next(wall for wall in walls if wall.id == "a/column-0")
    assert Polygon(named.prisms[0].outline).area == pytest.approx(0.16)


@given(st.lists(st.floats(1.5, 6.0), min_size=4, max_size=14))
def test_walls_of_any_room_are_disjoint_outside_it_and_without_gaps(radii: list[float]) -> None:
    brief = brief_of({"id": "a", "outline": star(radii)})
    room = Polygon(spaces(brief)[0].outline)
    walls, _ = built(brief)
    shapes = bodies(walls, 1.0)
    whole = shapely.union_all(shapes)
    assert whole.intersection(room).area < 1e-6
    assert sum(shape.area for shape in shapes) == pytest.approx(whole.area, abs=1e-6)
    around = room.buffer(0.249).difference(room.buffer(0.001))
    assert around.difference(whole).area < 1e-3


def test_the_sample_flat_is_whole() -> None:
    brief = formats.read("sample:home-flat")
    walls, openings = built(brief)
    names = [wall.id for wall in walls]
    assert len(names) == len(set(names))
    shapes = bodies(walls, 1.0)
    whole = shapely.union_all(shapes)
    assert sum(shape.area for shape in shapes) == pytest.approx(whole.area, abs=1e-9)
    rooms = shapely.union_all([Polygon(s.outline, s.holes) for s in spaces(brief)])
    assert whole.intersection(rooms).area < 1e-9
    assert len(openings) == len({opening.id for opening in openings})


def test_every_opening_of_the_sample_is_open_and_framed_by_wall() -> None:
    walls, openings = built(formats.read("sample:home-flat"))
    for opening in openings:
        middle = (opening.sill + opening.head) / 2
        for along in (-0.95, 0.0, 0.95):
            assert not blocked(walls, opening, along, middle), opening.id
            assert not blocked(walls, opening, along, opening.sill + 0.02), opening.id
            assert not blocked(walls, opening, along, opening.head - 0.02), opening.id
        assert blocked(walls, opening, 0.0, opening.head + 0.02), opening.id
        assert opening.sill == 0 or blocked(walls, opening, 0.0, opening.sill - 0.02), opening.id


def test_windows_in_a_curved_wall_are_open() -> None:
    brief = brief_of(
        {
            "id": "round",
            "outline": star([3.0] * 40),
            "windows": [
                {"at": [3 * np.cos(a), 3 * np.sin(a)], "width": 1.6} for a in (0.3, 2.0, 4.1)
            ],
        }
    )
    walls, openings = built(brief)
    assert len(openings) == 3
    for opening in openings:
        assert not any(blocked(walls, opening, along, 1.5) for along in (-0.9, 0.0, 0.9))
        assert blocked(walls, opening, 0.0, 0.5)


def test_listed_walls_keep_their_lines_and_meet_in_mitres() -> None:
    corners = [(0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)]
    lines = [
        {"start": a, "end": b, "thickness": 0.2}
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    middle = {"start": (2.5, 0.0), "end": (2.5, 4.0), "thickness": 0.1, "height": 1.5, "id": "low"}
    door = {"at": [1.2, 0.1], "width": 0.9}
    room = {"outline": [[0.1, 0.1], [2.45, 0.1], [2.45, 3.9], [0.1, 3.9]], "doors": [door]}
    walls, openings = built(brief_of(room, walls=[*lines, middle]))
    assert solid_volume(walls) == pytest.approx(
        (5.2 * 4.2 - 4.8 * 3.8) * 2.6 + 0.1 * 3.8 * 1.5 - 0.9 * 0.2 * 2.05, abs=1e-6
    )
    shapes = bodies(walls, 1.0)
    assert all(a.intersection(b).area < 1e-9 for a, b in combinations(shapes, 2))
    assert [wall.id for wall in walls] == ["wall-1", "wall-2", "wall-3", "wall-4", "low"]
    assert not blocked(walls, openings[0], 0.0, 1.0)


def test_listed_walls_of_different_thickness_close_their_corner() -> None:
    walls, _ = built(
        brief_of(
            {"outline": [[0.2, 0.1], [4.8, 0.1], [4.8, 3.9], [0.2, 3.9]]},
            walls=[
                {"start": (0, 0), "end": (5, 0), "thickness": 0.2},
                {"start": (0, 0), "end": (0, 4), "thickness": 0.4},
            ],
        )
    )
    whole = shapely.union_all(bodies(walls, 1.0))
    assert whole.area == pytest.approx(5.2 * 0.2 + 0.4 * 4.1 - 0.4 * 0.2, abs=1e-9)
    assert shapely.box(*whole.bounds).exterior.covers(shapely.Point(-0.2, -0.1))


@pytest.mark.parametrize("hinge", [-1, 1])
@pytest.mark.parametrize("swing", [-1, 1])
def test_an_open_leaf_hangs_at_its_hinge_and_stands_on_its_side(hinge: int, swing: int) -> None:
    door = Opening("d", "door", "0", 3.0, 2.0, 0.6, 0.8, 0.9, 0.12, 0.0, 2.05, hinge, swing)
    leaf = next(part for part in parts(door) if part.material.name == "door oak")
    assert volume(leaf) == pytest.approx(np.prod([0.834, 0.04, 2.006]), rel=1e-3)  # type: ignore[arg-type]
    along, left = np.array([0.6, 0.8]), np.array([-0.8, 0.6])
    away = to_plan_coordinates(door, leaf.vertices)[:, :2] - [3.0, 2.0]
    assert ((away @ left) * swing).min() > 0.0
    assert ((away @ left) * swing).max() == pytest.approx(0.06 + 0.834 * np.sin(1.361), abs=0.02)
    assert ((away @ along) * hinge).max() == pytest.approx(0.417, abs=0.01)


def test_what_fills_an_opening_stays_in_it_but_for_the_leaf() -> None:
    _, openings = built(formats.read("sample:home-flat"))
    for opening in openings:
        for part in parts(opening):
            assert volume(part) > 0, (opening.id, part.material.name)
            if part.material.name in ("door oak", "brushed steel"):
                continue
            points = shapely.points(to_plan_coordinates(opening, part.vertices)[:, :2])
            room = opening_box(opening, 0.04).buffer(1e-6)
            assert shapely.covers(room, points).all(), (opening.id, part.material.name)
            assert part.vertices[:, 2].max() <= opening.head + 1e-9


@given(st.lists(st.floats(1.0, 6.0), min_size=3, max_size=20), st.booleans())
def test_triangles_cover_a_polygon_exactly(radii: list[float], pierced: bool) -> None:
    outline = np.array(star(radii))
    holes = [0.3 * np.array(star([1.0] * 5))[::-1]] if pierced and len(radii) > 5 else []
    shape = Polygon(outline, holes)
    corners = np.vstack([outline, *holes])
    pieces = [Polygon(corners[row]) for row in triangles(outline, holes)]
    assert sum(piece.area for piece in pieces) == pytest.approx(shape.area, rel=1e-9)
    solid = prism(outline, 0.5, 2.5, holes)
    assert volume(solid) == pytest.approx(2 * shape.area, rel=1e-9)


def test_normals_are_sharp_on_a_box_and_round_on_a_fine_cylinder() -> None:
    square = prism(np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]]), 0.0, 1.0)
    flat = np.repeat(face_normals(*square[:2])[:, None], 3, axis=1)
    assert np.allclose(corner_normals(*square[:2]), flat)
    ring = np.array(star([1.0] * 24))
    drum = prism(ring, 0.0, 1.0)
    normals = corner_normals(*drum[:2])
    sides = np.abs(face_normals(*drum[:2])[:, 2]) < 0.5
    outward = drum.vertices[drum.faces[sides]].copy()
    outward[..., 2] = 0
    assert np.allclose(normals[sides], outward, atol=0.07)
    assert np.abs(np.abs(normals[~sides][..., 2]) - 1).max() < 1e-9


def test_normals_of_a_fan_of_thousands_take_no_square_of_them() -> None:
    """A flat disc, whose faces are one plane, and the tip of a cone, where all planes differ."""
    count = 20_000
    way = np.linspace(0.0, 2 * np.pi, count, endpoint=False)
    rim = np.column_stack([np.cos(way), np.sin(way), np.zeros(count)])
    faces = np.column_stack(
        [np.full(count, count), np.arange(count), (np.arange(count) + 1) % count]
    )
    disc = corner_normals(np.vstack([rim, [[0.0, 0.0, 0.0]]]), faces)
    assert np.allclose(disc, [0.0, 0.0, 1.0])
    cone = corner_normals(np.vstack([rim, [[0.0, 0.0, 3.0]]]), faces)
    flat = face_normals(np.vstack([rim, [[0.0, 0.0, 3.0]]]), faces)
    assert np.allclose(cone[:, 0], flat)
    assert np.isclose(np.linalg.norm(cone, axis=2), 1.0).all()


def test_normals_are_the_mean_of_the_faces_that_meet_within_the_crease() -> None:
    """Against a walk over all pairs of faces, on a crumpled sheet with flat parts."""
    draw = np.random.default_rng(3)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0))
    points = np.column_stack(
        [x.ravel(), y.ravel(), np.where(x < 2, 0, draw.random(x.shape)).ravel()]
    )
    corner = (np.arange(5)[:, None] * 6 + np.arange(5)).ravel()
    faces = np.vstack(
        [
            np.column_stack([corner, corner + 1, corner + 6]),
            np.column_stack([corner + 1, corner + 7, corner + 6]),
        ]
    )
    own = face_normals(points, faces)
    sides = points[faces]
    areas = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1)
    for face, normals in enumerate(corner_normals(points, faces)):
        for corner_, normal in zip(faces[face], normals, strict=True):
            near = (faces == corner_).any(1) & (own @ own[face] >= np.cos(np.deg2rad(46)) - 1e-9)
            mean = (own[near] * areas[near, None]).sum(0)
            assert np.allclose(normal, mean / np.linalg.norm(mean))


def test_a_balcony_by_itself_has_no_walls() -> None:
    brief = brief_of({"id": "out", "function": "balcony", "outline": SQUARE})
    walls, _ = shell(brief, spaces(brief))
    assert all(prism.top < 2.0 for wall in walls for prism in wall.prisms)


@pytest.mark.parametrize(("width", "leaves"), [(1.2, 1), (1.8, 2)])
def test_a_wide_door_that_turns_has_two_leaves(width: float, leaves: int) -> None:
    door = Opening("d", "door", "0", 0, 0, 1, 0, width, 0.12, 0.0, 2.05, hinge=1, swing=1)
    wood = [part for part in parts(door) if part.material.name == "door oak"]
    assert len(wood) == leaves
    assert all(np.ptp(part.vertices[:, 1]) < width / leaves for part in wood)
    sides = {float(np.sign(part.vertices[:, 0].mean())) for part in wood}
    assert len(sides) == leaves
