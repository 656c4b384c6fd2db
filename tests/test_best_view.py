"""From where a model shows most."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

from scenewright.geometry.best_view import (
    HIGHEST,
    MEASURES,
    best_view,
    directions,
    pictured_saliency,
    subject,
    viewpoint_entropy,
    visible_saliency,
)
from scenewright.geometry.mesh import Mesh, loft, merge, rotate_mesh, translate_mesh
from scenewright.geometry.saliency import saliency

Floats = NDArray[np.float64]
SIX = np.array([[1.0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0.6, 0.8], [0.8, 0, 0.6]])


def block(x: float, y: float, z: float) -> Mesh:
    square = [(-x / 2, -y / 2), (x / 2, -y / 2), (x / 2, y / 2), (-x / 2, y / 2)]
    return loft([[(a, b, c) for a, b in square] for c in (0.0, z)])


def house(angle: float = 0.0) -> Mesh:
    """A plain house with balconies at one side, +x before it is turned."""
    sills = [translate_mesh(block(1.0, 1.5, 0.8), 4.5, y, z) for y in (-3, 0, 3) for z in (2, 5, 8)]
    return rotate_mesh(merge([block(8.0, 10.0, 12.0), *sills]), "z", angle)


@pytest.mark.parametrize("angle", [0.0, 1.0, 2.5, -2.0])
def test_the_ornamented_side_is_shown(angle: float) -> None:
    mesh = rotate_mesh(house(angle), "z", 0.0)
    found = best_view(
        translate_mesh(mesh, 4e5, 5e6, 30.0), saliency(translate_mesh(mesh, 4e5, 5e6, 30.0))
    )
    front = np.array([np.cos(angle), np.sin(angle)])
    assert found.way[:2] @ front > 0.35
    assert best_view(mesh, saliency(mesh), "saliency").way[:2] @ front > 0.2
    assert np.linalg.norm(found.way) == pytest.approx(1.0)
    assert 0.0 <= found.way[2] <= np.sin(HIGHEST) + 1e-9
    assert found.score >= found.scores.max()


def test_visible_saliency_is_the_share_of_faces_turned_to_the_eye_on_a_convex_body() -> None:
    ball = trimesh.creation.icosphere(2)
    rough = np.array(ball.vertices) * np.array([1.0, 0.7, 1.3])
    mesh = Mesh(rough, np.array(ball.faces, np.int64))
    found = saliency(mesh)
    shares = visible_saliency(subject(mesh, found), SIX)
    held = found.areas * found.values
    normal = found.points / np.array([1.0, 0.7, 1.3]) ** 2
    wanted = [(held * (normal @ way > 0)).sum() / held.sum() for way in SIX]
    assert shares == pytest.approx(np.array(wanted), abs=0.06)
    assert shares[0] + shares[1] == pytest.approx(1.0, abs=0.08)


def test_a_picture_shows_walls_by_how_they_face() -> None:
    """A box: saliency of the visible faces, each by the cosine."""
    mesh = block(4.0, 6.0, 5.0)
    found = saliency(mesh)
    held, whole = found.areas * found.values, found.areas @ found.values
    sides = [held[found.points[:, k] > top].sum() for k, top in enumerate((1.999, 2.999, 4.999))]
    wanted = np.abs(np.array([[1, 0, 0], [0, 1, 0], [0.6, 0.8, 0], [0.48, 0.64, 0.6]])) @ sides
    ways = np.array([[1.0, 0, 0], [0, 1, 0], [0.6, 0.8, 0], [0.48, 0.64, 0.6]])
    assert pictured_saliency(subject(mesh, found), ways) == pytest.approx(wanted / whole, rel=0.08)
    best = best_view(mesh, found).way
    assert np.abs(best).min() > 0.2


def test_what_hides_behind_a_wall_is_not_seen() -> None:
    """From before the wall its near face alone is seen, from the side the house as well."""
    mesh = merge(
        [translate_mesh(block(0.2, 20.0, 20.0), 8.0), translate_mesh(house(), 0.0, 0.0, 1.0)]
    )
    found = saliency(mesh)
    held = found.areas * found.values
    near_face = held[found.points[:, 0] > 8.09].sum() / held.sum()
    ways = np.array([[1.0, 0, 0], [0, 0.9, np.sqrt(1 - 0.81)]])
    hidden, shown = visible_saliency(subject(mesh, found), ways)
    assert hidden == pytest.approx(near_face, abs=0.02)
    assert shown > 1.5 * hidden


def test_entropy_of_a_cube_is_known() -> None:
    """Along an axis: two triangles and the ground. Twice as much from a corner is not far off."""
    cube = translate_mesh(block(2.0, 2.0, 2.0), 0.0, 0.0, -1.0)
    about = subject(cube, saliency(cube))
    area = 4.0 / (3.0 * np.pi)  # of the face in a disc as wide as the diagonal
    share = np.array([area / 2, area / 2, 1 - area])
    wanted = -(share * np.log2(share)).sum()
    along, corner = viewpoint_entropy(about, np.array([[1.0, 0, 0], np.ones(3) / np.sqrt(3)]))
    assert along == pytest.approx(wanted, abs=0.03)
    assert corner > along


@pytest.mark.parametrize("measure", sorted(MEASURES))
def test_an_open_sheet_and_a_single_triangle_have_a_best_view(measure: str) -> None:
    mesh = Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]]))
    assert np.isfinite(best_view(mesh, saliency(mesh), measure).score)


def test_directions_are_evenly_spread() -> None:
    ways = directions(400)
    nearest = np.sort(ways @ ways.T, axis=1)[:, -2]
    assert np.arccos(nearest).min() > 0.5 * np.arccos(nearest).max()


@pytest.mark.realdata
@pytest.mark.parametrize("measure", ["saliency", "picture"])
@pytest.mark.parametrize("name", ["spot", "suzanne"])
def test_best_view_holds_when_faces_are_cut(real_data: Path, name: str, measure: str) -> None:
    """The view chosen on the finer mesh shows almost as much of the given one as its own best."""
    read = trimesh.load(real_data / "meshes_classic" / f"{name}.obj", process=False, force="mesh")
    upright = np.array(read.vertices)[:, [0, 2, 1]] * [1.0, -1.0, 1.0]
    mesh = Mesh(upright, np.array(read.faces, np.int64))
    finer = Mesh(*trimesh.remesh.subdivide(*mesh[:2]))
    found = saliency(mesh)
    one, other = best_view(mesh, found, measure), best_view(finer, saliency(finer), measure)
    again = MEASURES[measure](subject(mesh, found), other.way[None])[0]
    assert again > 0.97 * one.score
