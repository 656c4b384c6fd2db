"""Curvature of known surfaces, and meshes as files have them made sound."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scenewright.geometry.curvature import bends, mean_curvature, vertex_areas
from scenewright.geometry.mesh import Mesh, loft
from scenewright.geometry.mesh_edges import seams, sides
from scenewright.geometry.mesh_weld import clean_mesh

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


def plain(mesh: trimesh.Trimesh) -> Mesh:
    return Mesh(np.array(mesh.vertices, np.float64), np.array(mesh.faces, np.int64))


def sheet(count: int, height: object, half: float = 1.0) -> Mesh:
    """The graph of a function of x and y over a square."""
    x, y = np.meshgrid(*[np.linspace(-half, half, count)] * 2, indexing="ij")
    z = np.vectorize(height)(x, y)
    n = np.arange(count * count).reshape(count, count)
    a, b, c, d = (n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:])
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return Mesh(np.stack([x, y, z], -1).reshape(-1, 3), faces)


def tower(sides_: int, rings: int, radius: float) -> Mesh:
    angle = 2 * np.pi * np.arange(sides_) / sides_
    ring = np.stack([radius * np.cos(angle), radius * np.sin(angle)], 1)
    return loft([[(x, y, z) for x, y in ring] for z in np.linspace(0, 5 * radius, rings)])


def boundary(mesh: Mesh) -> NDArray[np.bool_]:
    alone = seams(mesh.faces).beside < 0
    marked = np.zeros(len(mesh.vertices), np.bool_)
    for k in range(3):
        marked[mesh.faces[alone[:, k]][:, [k, (k + 1) % 3]]] = True
    return marked


@pytest.mark.parametrize("radius", [0.1, 1.0, 40.0])
@pytest.mark.parametrize("cut", ["even", "in rings"])
def test_a_sphere_has_one_over_its_radius(radius: float, cut: str) -> None:
    ball = (
        trimesh.creation.icosphere(4, radius)
        if cut == "even"
        else trimesh.creation.uv_sphere(radius, count=[40, 60])
    )
    assert mean_curvature(clean_mesh(plain(ball)).mesh) * radius == pytest.approx(1.0, rel=0.02)


def test_a_cylinder_has_half_of_one_over_its_radius() -> None:
    found = tower(64, 40, 2.0)
    on_the_side = (found.vertices[:, 2] > 0.1) & (found.vertices[:, 2] < 9.9)
    assert mean_curvature(found)[on_the_side] == pytest.approx(1 / 4, rel=1e-3)


def test_a_plane_has_none_and_open_edges_add_none() -> None:
    found = sheet(7, lambda x, y: 0.3 * x + 0.5 * y)
    assert mean_curvature(found) == pytest.approx(0.0, abs=1e-12)


def test_a_saddle_bends_both_ways_alike() -> None:
    curve = 0.5
    saddle = sheet(41, lambda x, y: curve * (x * x - y * y), 0.2)
    bowl = sheet(41, lambda x, y: -curve * (x * x + y * y), 0.2)
    middle = np.argmin(np.linalg.norm(saddle.vertices, axis=1))
    assert mean_curvature(saddle)[middle] == pytest.approx(0.0, abs=1e-3)
    assert mean_curvature(bowl)[middle] == pytest.approx(2 * curve, rel=1e-2)
    upside_down = Mesh(bowl.vertices * [1.0, 1.0, -1.0], bowl.faces)
    assert mean_curvature(upside_down)[middle] == pytest.approx(-2 * curve, rel=1e-2)


def test_a_box_holds_what_steiner_says() -> None:
    """The integral of the mean curvature of a convex body is pi/4 times its edges, if square."""
    box = plain(trimesh.creation.box((2.0, 3.0, 5.0)))
    assert bends(box).total().sum() == pytest.approx(np.pi / 4 * 4 * (2 + 3 + 5))


@given(st.integers(0, 10_000))
def test_winding_does_not_matter_to_a_closed_surface(seed: int) -> None:
    rng = np.random.default_rng(seed)
    hull = plain(trimesh.convex.convex_hull(rng.normal(size=(30, 3)) + rng.normal(size=3)))
    wanted = bends(hull).total().sum()
    assert wanted > 0.0
    flipped = hull.faces.copy()
    some = rng.random(len(flipped)) < 0.5
    flipped[some] = flipped[some][:, ::-1]
    mixed = Mesh(hull.vertices, flipped)
    assert bends(mixed).total().sum() == pytest.approx(wanted)
    assert np.all((sides(mixed, seams(flipped)) < 0) == some)


def test_most_of_an_open_sheet_says_which_side_is_out() -> None:
    bowl = sheet(9, lambda x, y: -x * x - y * y)
    wanted = mean_curvature(bowl)
    faces = bowl.faces.copy()
    faces[::3] = faces[::3][:, ::-1]
    assert mean_curvature(Mesh(bowl.vertices, faces)) == pytest.approx(wanted)


def test_a_band_with_one_side_is_taken() -> None:
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    ways = np.stack(
        [np.cos(angle / 2) * np.cos(angle), np.cos(angle / 2) * np.sin(angle), np.sin(angle / 2)], 1
    )
    middle = 3 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1)
    points = np.stack([middle - ways, middle + ways], 1).reshape(-1, 3)
    names = np.arange(80)
    after = np.roll(names.reshape(-1, 2), -1, 0)
    after[-1] = after[-1][::-1]
    a, b, c, d = names[::2], names[1::2], after[:, 1], after[:, 0]
    band = Mesh(points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]))
    found = bends(band)
    disagree = (sides(band, found.seams)[found.seams.faces].prod(1) > 0) != found.seams.alike
    assert disagree.any()
    assert np.all(found.angle[disagree] == 0.0)
    assert np.isfinite(mean_curvature(band)).all()


def test_an_edge_of_three_faces_joins_none() -> None:
    fins = np.array([[0.0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 1, 0], [-1, -1, 0]])
    assert len(bends(Mesh(fins, np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]]))).angle) == 0


@given(st.integers(0, 10_000))
def test_areas_add_up(seed: int) -> None:
    rng = np.random.default_rng(seed)
    soup = Mesh(rng.normal(size=(20, 3)), np.stack([rng.permutation(20)[:3] for _ in range(9)]))
    a, b, c = (soup.vertices[soup.faces[:, k]] for k in range(3))
    whole = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    assert vertex_areas(soup).sum() == pytest.approx(whole)
    assert vertex_areas(soup).min() >= 0.0


def test_curvature_of_a_lumpy_ball_agrees_with_the_cotangent_formula() -> None:
    """Half the length of the Laplacian of place (Meyer et al. 2003), by dense matrices."""
    ball = trimesh.creation.icosphere(4)
    wave = 1 + 0.1 * np.sin(4 * ball.vertices[:, :1]) * np.cos(3 * ball.vertices[:, 1:2])
    lumpy = Mesh(np.array(ball.vertices * wave), np.array(ball.faces, np.int64))
    laplace = np.zeros_like(lumpy.vertices)
    for k in range(3):
        here, one, other = (lumpy.vertices[lumpy.faces[:, (k + i) % 3]] for i in range(3))
        cross = np.linalg.norm(np.cross(one - here, other - here), axis=1)
        cot = ((one - here) * (other - here)).sum(1) / cross
        step = 0.5 * cot[:, None] * (one - other)
        np.add.at(laplace, lumpy.faces[:, (k + 1) % 3], step)
        np.add.at(laplace, lumpy.faces[:, (k + 2) % 3], -step)
    normal = np.array(trimesh.Trimesh(*lumpy, process=False).vertex_normals)
    wanted = (laplace * normal).sum(1) / (2 * vertex_areas(lumpy))
    assert np.corrcoef(wanted, mean_curvature(lumpy))[0, 1] > 0.995
    assert mean_curvature(lumpy) == pytest.approx(wanted, abs=0.2)


@given(st.integers(0, 10_000))
def test_loose_and_doubled_faces_are_put_right(seed: int) -> None:
    """Every face with its own corners, slightly off; faces twice; lines; a stray vertex."""
    rng = np.random.default_rng(seed)
    ball = plain(trimesh.creation.icosphere(2, 3.0))
    loose = ball.vertices[ball.faces].reshape(-1, 3)
    loose = loose + 1e-7 * rng.uniform(-1, 1, loose.shape)
    faces = np.arange(len(loose)).reshape(-1, 3)
    junk = np.concatenate([faces[:40, ::-1], np.repeat(faces[:5, :1], 3, 1), faces[7:9, [0, 1, 1]]])
    turn = Rotation.random(random_state=seed).as_matrix()
    corners = np.concatenate([loose, [[np.nan] * 3]]) @ turn + rng.normal(size=3) * 1e4
    found = clean_mesh(Mesh(corners, rng.permutation(np.concatenate([faces, junk]))))
    assert len(found.mesh.vertices) == len(ball.vertices)
    assert len(found.face) == len(ball.faces)
    assert found.vertex[-1] == -1
    assert found.size == pytest.approx(6.0, rel=1e-4)
    assert (seams(found.mesh.faces).beside >= 0).all()


def test_size_of_a_box_is_its_diagonal() -> None:
    assert clean_mesh(plain(trimesh.creation.box((2.0, 3.0, 6.0)))).size == pytest.approx(7.0)


TRIANGLE = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])


@pytest.mark.parametrize(
    ("vertices", "faces", "fault"),
    [
        (TRIANGLE, np.zeros((0, 3), int), "no faces"),
        (np.zeros((0, 3)), np.zeros((0, 3), int), "no faces"),
        (TRIANGLE, [[0, 1, 3]], "not there"),
        (TRIANGLE, [[0, 1, -1]], "not there"),
        (TRIANGLE, [[0, 1, 2, 0]], "not made of triangles"),
        (TRIANGLE * [1, 0, 0], [[0, 1, 2]], "with an area"),
        (TRIANGLE * 0, [[0, 1, 2]], "with an area"),
        (np.where(TRIANGLE > 0, np.inf, 0.0), [[0, 1, 2]], "finite"),
        (TRIANGLE * 1e200, [[0, 1, 2]], "finite"),
    ],
)
def test_unusable_meshes_are_told(vertices: Floats, faces: Ints, fault: str) -> None:
    with pytest.raises(ValueError, match=fault):
        clean_mesh(Mesh(np.asarray(vertices), np.asarray(faces)))
