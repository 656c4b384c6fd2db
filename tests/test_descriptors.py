"""Descriptors: what turning and scaling leave alone, and clustering against slow references."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from benchmarks.extend_features import describe_set
from benchmarks.real_data import data_set
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.special import sph_harm_y

from scenewright import cli
from scenewright.catalog.descriptors.compact import compact_descriptor
from scenewright.catalog.descriptors.depth_maps import SIDES, depth_maps, light_field_ways
from scenewright.catalog.descriptors.printed import printed_descriptor
from scenewright.core.catalog import Material, Part
from scenewright.engine.clustering.agreement import (
    adjusted_mutual_information,
    k_entropy,
    nearest_share,
)
from scenewright.engine.clustering.linkage import leader, ward
from scenewright.engine.clustering.resonance import ResonanceSettings, fuzzy_art
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.principal_axes import principal_axes
from scenewright.geometry.solids import block
from scenewright.geometry.spherical import energies, farthest_hits, harmonics, sphere_directions


def chair() -> Mesh:
    return merge(
        [
            block((0, 0.5), (0, 0.5), (0.4, 0.46)),
            block((0, 0.5), (0.44, 0.5), (0.46, 1.0)),
            *(block((x, x + 0.05), (y, y + 0.05), (0, 0.4)) for x in (0, 0.45) for y in (0, 0.45)),
        ]
    )


def turned(mesh: Mesh, rng: np.random.Generator) -> Mesh:
    matrix = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    matrix *= np.sign(np.linalg.det(matrix))
    return Mesh(3.7 * mesh.vertices @ matrix.T + (5, -2, 9), mesh.faces)


def test_harmonics_are_those_of_scipy() -> None:
    rng = np.random.default_rng(0)
    ways = sphere_directions(32)
    theta, phi = np.arccos(ways[..., 2]), np.arctan2(ways[..., 1], ways[..., 0])
    for degree, order in ((0, 0), (2, 1), (5, 3), (7, 7)):
        wave = sph_harm_y(degree, order, theta, phi)
        factor = rng.normal()
        found = harmonics(factor * wave.real, 8)
        expected = np.zeros((8, 8), complex)
        expected[degree, order] = factor * (0.5 if order else 1.0)
        assert np.abs(found - expected).max() < 1e-9


def test_the_printed_descriptor_is_blind_to_size_place_and_turn() -> None:
    rng = np.random.default_rng(1)
    whole = printed_descriptor(chair())
    other = printed_descriptor(block((0, 3), (0, 0.1), (0, 1)))
    for _ in range(4):
        away = np.linalg.norm(printed_descriptor(turned(chair(), rng)) - whole)
        assert away < 0.08 * np.linalg.norm(other - whole)


def test_energies_do_not_change_as_a_function_is_turned() -> None:
    ways = sphere_directions(48)
    axis, other = np.array([0.3, -0.5, 0.8]), np.array([0.9, 0.1, -0.2])
    one, two = (np.exp(ways @ (a / np.linalg.norm(a))) for a in (axis, other))
    assert energies(harmonics(one, 10)) == pytest.approx(energies(harmonics(two, 10)), abs=1e-9)


def test_principal_axes_are_those_of_many_points_of_the_surface() -> None:
    rng = np.random.default_rng(2)
    mesh = turned(block((0, 4), (0, 2), (0, 1)), rng)
    corners = mesh.vertices[mesh.faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1)
    pick = rng.choice(len(area), 400_000, p=area / area.sum())
    u = rng.dirichlet(np.ones(3), len(pick))
    points = (corners[pick] * u[..., None]).sum(1)
    found = principal_axes(mesh)
    assert found.centre == pytest.approx(points.mean(0), abs=0.05)
    spread = np.sqrt(np.linalg.eigvalsh(np.cov(points.T))[::-1])
    assert found.spread == pytest.approx(spread, rel=0.01)
    assert np.linalg.det(found.axes) == pytest.approx(1.0)


def test_refining_triangles_changes_nothing() -> None:
    mesh = chair()
    corners = mesh.vertices[mesh.faces]
    middle = corners.mean(1)
    fine = np.concatenate(
        [np.stack([corners[:, k], corners[:, (k + 1) % 3], middle], 1) for k in range(3)]
    ).reshape(-1, 3)
    finer = Mesh(fine, np.arange(len(fine)).reshape(-1, 3))
    assert printed_descriptor(finer) == pytest.approx(printed_descriptor(mesh), abs=1e-3)


def test_the_farthest_hit_is_that_of_a_convex_body() -> None:
    cube = block((-1, 1), (-1, 1), (-1, 1))
    ways = sphere_directions(24)
    reach = farthest_hits(cube, np.zeros(3), 24)
    assert reach == pytest.approx(1 / np.abs(ways).max(2), abs=1e-5)


def test_ours_is_blind_to_turns_about_the_vertical_alone() -> None:
    paint = Material("oak", (0.7, 0.5, 0.3))

    def part(mesh: Mesh) -> list[Part]:
        return [Part(paint, mesh.vertices, mesh.faces)]

    mesh = chair()
    quarter = Mesh(mesh.vertices[:, [1, 0, 2]] * (-1, 1, 1), mesh.faces)
    cosine, sine = np.cos(0.6), np.sin(0.6)
    aslant = Mesh(mesh.vertices @ [[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]], mesh.faces)
    lying = Mesh(mesh.vertices[:, [0, 2, 1]] * (1, -1, 1), mesh.faces)
    large = Mesh(mesh.vertices * 3, mesh.faces)
    whole = compact_descriptor(part(mesh))
    assert compact_descriptor(part(quarter)) == pytest.approx(whole, abs=0.02)
    assert np.abs(compact_descriptor(part(aslant)) - whole).max() < 0.1
    assert np.abs(compact_descriptor(part(lying)) - whole).max() > 0.2
    assert np.abs(compact_descriptor(part(large)) - whole).max() > 0.3


def test_green_with_brown_is_not_olive() -> None:
    green, brown, olive = ((0.2, 0.7, 0.2), (0.6, 0.3, 0.1), (0.4, 0.5, 0.15))

    def tree(low: tuple[float, float, float], high: tuple[float, float, float]) -> list[Part]:
        trunk, crown = block((0, 1), (0, 1), (0, 1)), block((0, 1), (0, 1), (1, 2))
        paints = (Material("low", low), Material("high", high))
        return [
            Part(paint, mesh.vertices, mesh.faces)
            for paint, mesh in zip(paints, (trunk, crown), strict=True)
        ]

    mixed, plain = compact_descriptor(tree(brown, green)), compact_descriptor(tree(olive, olive))
    assert np.linalg.norm(mixed - plain) > 0.5
    assert compact_descriptor(tree(green, brown)) == pytest.approx(mixed)


def test_depth_maps_are_those_of_solids_one_knows() -> None:
    step = merge([block((0, 1), (0, 1), (0, 1)), block((0, 1), (1, 2), (0, 2))])
    front, back = depth_maps(step, np.array([[0.0, -1, 0], [0, 1, 0]]), 8)
    assert np.unique(front[:4]).tolist() == pytest.approx([0.0], abs=1e-5)
    assert np.unique(front[4:]).tolist() == pytest.approx(
        [0.5] * len(np.unique(front[4:])), abs=1e-5
    )
    assert back == pytest.approx(np.zeros((8, 8)), abs=1e-5)
    table = merge([block((0, 1), (0, 1), (0.8, 1)), block((0.4, 0.6), (0.4, 0.6), (0, 0.8))])
    seen = np.isfinite(depth_maps(table, SIDES, 20))
    assert seen.mean() == pytest.approx(0.2 + 0.8 * 0.2, abs=0.01)
    ways = light_field_ways()
    angles = np.rad2deg(np.arccos(np.clip(ways @ ways.T, -1, 1) - 2 * np.eye(10)))
    assert np.sort(angles.min(1)) == pytest.approx(41.81, abs=0.01)


@pytest.mark.parametrize("count", [2, 3, 6])
def test_ward_is_that_of_scipy(count: int) -> None:
    vectors = np.random.default_rng(count).normal(size=(40, 3))
    ours = ward(vectors, count)
    theirs = fcluster(linkage(vectors, "ward"), count, "maxclust")
    assert adjusted_mutual_information(ours, theirs) == pytest.approx(1.0)


def test_ami_is_nothing_for_labels_at_random_and_does_not_mind_names() -> None:
    rng = np.random.default_rng(0)
    known = np.repeat(np.arange(28), 4)
    found = [adjusted_mutual_information(rng.integers(0, 28, 112), known) for _ in range(20)]
    assert abs(np.mean(found)) < 0.03
    assert adjusted_mutual_information((known * 7 + 3) % 31, known) == pytest.approx(1.0)


def test_online_sorting_finds_classes_that_are_apart() -> None:
    rng = np.random.default_rng(3)
    known = np.repeat(np.arange(4), 12)
    vectors = rng.normal(size=(4, 5))[known] * 6 + 0.05 * rng.normal(size=(48, 5))
    order = rng.permutation(48)
    for found in (leader(vectors[order], 2.0), fuzzy_art(vectors[order], ResonanceSettings(0.8))):
        assert adjusted_mutual_information(found, known[order]) > 0.95
    assert nearest_share(vectors, known) == 1.0
    assert k_entropy(vectors, known) == 0.0


def test_the_leader_hardly_minds_the_order() -> None:
    rng = np.random.default_rng(5)
    vectors = rng.normal(size=(9, 4))[rng.integers(0, 9, 90)] * 3 + 0.45 * rng.normal(size=(90, 4))
    labels = []
    for _ in range(4):
        order = rng.permutation(90)
        label = np.zeros(90, np.int64)
        label[order] = leader(vectors[order], 1.9)
        labels.append(label)
    pairs = [adjusted_mutual_information(a, b) for k, a in enumerate(labels) for b in labels[:k]]
    assert min(pairs) > 0.9
    away = np.linalg.norm(vectors[:, None] - vectors[None], axis=2)
    mean = np.stack([(away * (labels[0] == c)).sum(1) for c in range(labels[0].max() + 1)], 1)
    others = np.bincount(labels[0]) - np.eye(labels[0].max() + 1)[labels[0]]
    mean = np.where(others > 0, mean / np.maximum(others, 1), np.inf)
    content = mean[np.arange(90), labels[0]] <= np.minimum(mean.min(1), 1.9) + 1e-9
    assert content.mean() > 0.95


@pytest.mark.realdata(quick=True)
def test_ours_tells_real_models_better_than_the_papers() -> None:
    found = describe_set("city")
    shares = {key: nearest_share(v, found.classes) for key, v in found.vectors.items()}
    assert shares["ours"] >= 0.9
    assert shares["ours"] >= shares["paper"]
    impurity = {key: k_entropy(v, found.classes) for key, v in found.vectors.items()}
    assert impurity["ours"] < impurity["paper"]


@pytest.mark.realdata
@pytest.mark.parametrize("method", ["ward", "k-means", "leader", "art"])
def test_classes_are_shown(method: str, tmp_path: Path) -> None:
    folder = data_set("kenney_city") / "starter_kit"
    words = ["catalog", "cluster", str(folder), "--method", method]
    assert cli.run([*words, "-o", str(tmp_path / "sheet.png"), "--classes", "4"]) == 0
    assert (tmp_path / "sheet.png").stat().st_size > 2000
    assert cli.run([*words, "--json"]) == 0
    assert cli.run([*words, "--depths"]) == 2
    assert cli.run([*words, "--depths", "-o", str(tmp_path / "depths.png")]) == 0
    assert (tmp_path / "depths.png").stat().st_size > 2000
    assert cli.run(["catalog", "cluster", str(folder), "-o", str(tmp_path / "a.gif")]) == 2
