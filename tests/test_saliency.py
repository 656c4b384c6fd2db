"""Saliency: what it is by a slow sum, what it must not depend on, and what lights up."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.distance import cdist
from scipy.spatial.transform import Rotation

from scenewright.geometry import saliency as subject
from scenewright.geometry.curvature import bends
from scenewright.geometry.gaussians import LEVELS, WIDTHS
from scenewright.geometry.mesh import Mesh, loft, merge
from scenewright.geometry.mesh_weld import clean_mesh
from scenewright.geometry.saliency import (
    FAINT,
    UNIT,
    Saliency,
    relative_quality,
    saliency,
    values_at,
    visual_quality,
)
from scenewright.geometry.surface_samples import sample_surface

Floats = NDArray[np.float64]


def plain(mesh: trimesh.Trimesh) -> Mesh:
    return Mesh(np.array(mesh.vertices, np.float64), np.array(mesh.faces, np.int64))


def block(size: tuple[float, float, float], at: tuple[float, float, float] = (0, 0, 0)) -> Mesh:
    half = np.array(size) / 2
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    rings = [[(x * half[0], y * half[1], z * half[2]) for x, y in square] for z in (-1, 1)]
    return loft(np.array(rings) + np.array(at))


def lumpy(seed: int, fine: int = 4) -> Mesh:
    """A ball with some bumps and dents, no two of its faces alike."""
    rng = np.random.default_rng(seed)
    ball = trimesh.creation.icosphere(fine)
    way = np.array(ball.vertices)
    heights = rng.uniform(-0.25, 0.35, 6)
    spots = rng.normal(size=(6, 3))
    spots /= np.linalg.norm(spots, axis=1)[:, None]
    bump = (heights * np.exp(-(cdist(way, spots) ** 2) / 0.02)).sum(1)
    way = way + rng.uniform(-0.01, 0.01, way.shape)
    return Mesh(way * (1 + bump)[:, None], np.array(ball.faces, np.int64))


def bump_on_a_plane(rows: int = 81) -> Mesh:
    """A square metre or two of ground, or a strip of it, with a bump in the middle."""
    half = (rows - 1) / 80
    x, y = np.meshgrid(np.linspace(-1, 1, 81), np.linspace(-half, half, rows), indexing="ij")
    z = 0.06 * np.exp(-(x**2 + y**2) / 0.005)
    n = np.arange(81 * rows).reshape(81, rows)
    a, b, c, d = n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return Mesh(np.stack([x, y, z], -1).reshape(-1, 3), faces)


def slow(mesh: Mesh) -> tuple[Floats, Floats]:
    """Points and saliency by whole matrices, written from the paper and nothing shared but the
    points."""
    base = clean_mesh(mesh)
    unit = UNIT * base.size
    given_ = sample_surface(base.mesh, 2 * unit)
    assert len(given_.points) < 5000
    away = cdist(given_.points, given_.points) / unit

    def mean(width: float) -> Floats:
        weight = np.where(away <= 2 * width, np.exp(-0.5 * (away / width) ** 2), 0.0)
        return (weight @ given_.bend) / (weight @ given_.area)

    result = np.zeros(len(away))
    for width in WIDTHS[:LEVELS]:
        level = np.abs(mean(width) - mean(2 * width)) * base.size
        level = level / max(level.max(), FAINT)
        near = np.where(away <= width, level, -1.0).max(1)
        top = np.sort(level[(level >= near - 1e-9) & (level > 1e-3)])[:-1]
        result += level * (1.0 - (top.mean() if len(top) else 0.0)) ** 2
    return given_.points + base.centre, result


@pytest.mark.parametrize("shape", ["bump", "slab", "pieces"])
def test_it_is_the_sum_over_all_pairs(shape: str) -> None:
    mesh = {
        "bump": bump_on_a_plane(5),
        "slab": block((9.0, 0.25, 0.15)),
        "pieces": merge([block((8.0, 0.15, 0.15)), block((0.2, 0.2, 0.2), (2.0, 0.0, 1.0))]),
    }[shape]
    places, wanted = slow(mesh)
    found = saliency(mesh)
    assert found.points == pytest.approx(places)
    assert found.values == pytest.approx(wanted, abs=1e-6)


def test_points_hold_all_area_and_curvature() -> None:
    for mesh in (lumpy(1, 3), block((3.0, 1.0, 2.0)), bump_on_a_plane()):
        for step in (0.01, 0.1, 5.0):
            found = sample_surface(mesh, step)
            whole = trimesh.Trimesh(*mesh[:2], process=False).area
            assert found.area.sum() == pytest.approx(whole)
            assert found.bend.sum() == pytest.approx(bends(mesh).total().sum())


def test_points_of_a_needle_are_few() -> None:
    needle = Mesh(np.array([[0.0, 0, 0], [100, 0, 0], [50, 1e-3, 0]]), np.array([[0, 1, 2]]))
    assert len(sample_surface(needle, 0.1, 5000).points) < 1200
    assert len(sample_surface(needle, 1e-6, 5000).points) < 7500


@pytest.mark.parametrize("fine", [2, 4, 5])
def test_a_ball_is_dull(fine: int) -> None:
    found = saliency(plain(trimesh.creation.icosphere(fine)))
    assert found.values.max() < 0.5
    assert found.areas @ found.values / found.areas.sum() < 0.1


def test_a_bump_on_a_plane_stands_out() -> None:
    mesh = bump_on_a_plane()
    found = saliency(mesh).vertices
    away = np.linalg.norm(mesh.vertices[:, :2], axis=1)
    assert found[away < 0.03].min() > 1.0
    assert found[away > 0.4].max() < 0.02


def test_a_box_has_corners_before_edges_before_faces() -> None:
    found = saliency(block((4.0, 6.0, 3.0)))
    corner, edge, face = values_at(found, [[2, 3, 1.5], [2, 3, 0], [2, 0, 0]])
    assert corner > 1.2 * edge > 1.2 * 3 * face
    assert values_at(found, [[9.0, 9.0, 9.0]]).tolist() == [0.0]


@settings(max_examples=5)
@given(st.integers(0, 99), st.floats(-3, 3), st.tuples(*[st.floats(-1e3, 1e3)] * 3))
def test_turning_moving_and_scaling_change_nothing(
    seed: int, power: float, shift: tuple[float, float, float]
) -> None:
    mesh = lumpy(seed)
    turn = Rotation.random(random_state=seed).as_matrix()
    scale = 10**power
    other = saliency(Mesh((mesh.vertices @ turn + np.array(shift)) * scale, mesh.faces))
    wanted = saliency(mesh)
    assert other.size == pytest.approx(wanted.size * scale)
    assert other.vertices == pytest.approx(wanted.vertices, abs=1e-6)
    assert visual_quality(other) == pytest.approx(visual_quality(wanted), rel=1e-6)


@settings(max_examples=5)
@given(st.integers(0, 99))
def test_order_changes_nothing(seed: int) -> None:
    mesh, rng = lumpy(seed), np.random.default_rng(seed)
    place = rng.permutation(len(mesh.vertices))
    vertices = np.empty_like(mesh.vertices)
    vertices[place] = mesh.vertices
    order = rng.permutation(len(mesh.faces))
    faces = np.stack([np.roll(f, rng.integers(3)) for f in place[mesh.faces[order]]])
    found, wanted = saliency(Mesh(vertices, faces)), saliency(mesh)
    assert found.vertices[place] == pytest.approx(wanted.vertices, abs=1e-6)
    assert found.faces == pytest.approx(wanted.faces[order], abs=1e-6)


def test_loose_faces_doubled_sheets_and_mixed_windings_change_nothing() -> None:
    mesh = lumpy(3)
    wanted = saliency(mesh)
    corners = mesh.vertices[mesh.faces].reshape(-1, 3)
    faces = np.arange(len(corners)).reshape(-1, 3)
    faces[::2] = faces[::2][:, ::-1]
    doubled = np.concatenate([faces, faces[:, ::-1], faces[:3, [0, 0, 1]]])
    found = saliency(Mesh(corners, doubled))
    expected = wanted.vertices[mesh.faces].reshape(-1)
    assert found.vertices == pytest.approx(expected, abs=1e-6)
    assert found.faces[: len(faces)] == pytest.approx(wanted.faces, abs=1e-6)
    assert not found.faces[len(faces) :].any()


def likeness(one: Saliency, other: Saliency) -> float:
    return float(np.corrcoef(one.values, values_at(other, one.points))[0, 1])


def test_cutting_faces_smaller_changes_little() -> None:
    building = merge([block((4.0, 6.0, 3.0)), block((1.0, 1.0, 1.0), (2.5, 0.5, 0.3))])
    finer = Mesh(*trimesh.remesh.subdivide_to_size(*building[:2], max_edge=0.4, max_iter=20))
    one, other = saliency(building), saliency(finer)
    assert likeness(one, other) > 0.97
    assert visual_quality(other) == pytest.approx(visual_quality(one), rel=0.05)


def test_putting_points_together_changes_little(monkeypatch: pytest.MonkeyPatch) -> None:
    mesh = lumpy(5, 5)
    wanted = saliency(mesh)
    monkeypatch.setattr(subject, "PAIRS", 9e6)
    found = saliency(mesh)
    assert len(found.values) < 0.75 * len(wanted.values)
    assert np.corrcoef(found.vertices, wanted.vertices)[0, 1] > 0.97
    assert visual_quality(found) == pytest.approx(visual_quality(wanted), rel=0.1)


@pytest.mark.parametrize("kind", ["soup", "clump", "far", "fins"])
def test_any_triangles_give_numbers(kind: str) -> None:
    rng = np.random.default_rng(0)
    corners = {
        "soup": rng.random((3000, 3)),
        "clump": np.concatenate([1e-3 * rng.random((30000, 3)), np.eye(3) * 5]),
        "far": rng.random((300, 3)) + 1e8,
        "fins": np.insert(rng.random((99, 2, 3)), 0, 0.5, axis=1).reshape(-1, 3),
    }[kind]
    found = saliency(Mesh(corners, np.arange(len(corners)).reshape(-1, 3)))
    assert np.isfinite(found.vertices).all()
    assert np.isfinite(found.faces).all()
    assert len(found.values) < 150_000


def test_quality_rises_with_ornament() -> None:
    plain_ = block((10.0, 8.0, 12.0))
    balconies = [block((1.5, 1.0, 0.8), (x, -4.5, z)) for x in (-3, 0, 3) for z in (-4, -1, 2)]
    one, other = (visual_quality(saliency(m)) for m in (plain_, merge([plain_, *balconies])))
    assert other > 1.3 * one > 0.0
    assert relative_quality([one, other]).tolist() == [one / other, 1.0]
    assert relative_quality([0.0, 0.0]).tolist() == [1.0, 1.0]
    assert relative_quality([]).tolist() == []


def loaded(folder: Path, name: str) -> Mesh:
    read = trimesh.load(folder / "meshes_classic" / f"{name}.obj", process=False, force="mesh")
    return plain(read)


FEATURES = [
    ("armadillo_simplified", "left ear", (22.4, 95.9, -26.0), 0.03),
    ("armadillo_simplified", "right ear", (-22.4, 96.0, -30.4), 0.03),
    ("armadillo_simplified", "left eye", (7.5, 71.0, -33.0), 0.02),
    ("armadillo_simplified", "right eye", (-6.5, 71.8, -33.8), 0.02),
    ("armadillo_simplified", "right toe", (-55.9, -52.5, 2.9), 0.03),
    ("armadillo_simplified", "left toe", (41.1, -53.5, 6.2), 0.03),
    ("armadillo_simplified", "thumb", (49.1, 89.9, -33.0), 0.03),
    ("armadillo_simplified", "tip of the tail", (-5.5, -12.4, 56.7), 0.03),
    ("stanford-bunny", "ear", (-0.018, 0.187, -0.020), 0.03),
    ("stanford-bunny", "other ear", (-0.078, 0.178, -0.050), 0.03),
    ("stanford-bunny", "foot", (-0.070, 0.034, -0.005), 0.03),
    ("spot", "tail", (0.0, -0.09, 1.044), 0.04),
    ("spot", "left horn", (0.21, 0.762, -0.268), 0.04),
    ("spot", "left ear", (0.46, 0.727, -0.177), 0.04),
    ("spot", "right ear", (-0.46, 0.727, -0.177), 0.04),
    ("suzanne", "left ear", (-1.236, 1.494, 3.612), 0.06),
    ("suzanne", "nostril", (-2.400, 0.502, 4.768), 0.06),
]


@pytest.mark.realdata
@pytest.mark.parametrize("name", sorted({name for name, *_ in FEATURES}))
def test_known_features_light_up(real_data: Path, name: str) -> None:
    """The greatest saliency near each is among the top twentieth of the whole model."""
    mesh = loaded(real_data, name)
    found = saliency(mesh)
    bright = np.quantile(np.repeat(found.values, 1 + (found.areas > 0)), 0.95)
    for other, feature, place, share in FEATURES:
        if other == name:
            near = np.linalg.norm(mesh.vertices - np.array(place), axis=1) < share * found.size
            assert near.any(), feature
            assert found.vertices[near].max() > bright, feature


@pytest.mark.realdata
@pytest.mark.parametrize("name", ["spot", "suzanne", "teapot", "armadillo_simplified"])
def test_real_meshes_are_taken_and_turning_changes_nothing(real_data: Path, name: str) -> None:
    mesh = loaded(real_data, name)
    found = saliency(mesh)
    turn = Rotation.random(random_state=1).as_matrix()
    other = saliency(Mesh(mesh.vertices @ turn, mesh.faces))
    assert 0.5 < found.values.max() < LEVELS
    assert np.median(found.values) < 0.2 * found.values.max()
    assert np.corrcoef(found.vertices, other.vertices)[0, 1] > 0.98
    assert visual_quality(other) == pytest.approx(visual_quality(found), rel=0.03)
