"""What a walker sees, as boxes and as meshes."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scenewright.geometry.box_grid import box_grid
from scenewright.geometry.mesh import loft, merge, translate_mesh
from scenewright.geometry.prisms import box, face_normals
from scenewright.geometry.saliency import saliency
from scenewright.geometry.walker import (
    BAND,
    REACH,
    eyes_along,
    look_from,
    seen,
    seen_of,
    sights,
    sights_of_boxes,
    summed_quality,
)
from scenewright.geometry.walker_meshes import (
    SaliencyModel,
    best_spots,
    side_densities,
    sights_of_meshes,
    street,
    to_bounding_box,
    ways_of,
)

Floats = NDArray[np.float64]
MANY = 4096
SOUTH = -np.pi / 2


def block(size: Floats, sides: Floats) -> SaliencyModel:
    """A box with a density on each side."""
    w, d, h = size
    mesh = box((-w / 2, -d / 2, 0.0), (w / 2, d / 2, h))
    x, y, _ = face_normals(*mesh[:2]).T
    side = np.select([y > 0.5, x < -0.5, y < -0.5, x > 0.5], [0, 1, 2, 3], 4)
    return SaliencyModel(mesh, sides[side])


def town(seed: int) -> tuple[Floats, Floats, Floats, Floats]:
    """Boxes on a grid, turned, heights, densities, and eyes in the lanes."""
    rng = np.random.default_rng(seed)
    grid = np.stack(np.meshgrid(np.arange(6) * 40.0, np.arange(5) * 40.0), -1).reshape(-1, 2)
    boxes = np.column_stack(
        [
            grid + rng.uniform(-2, 2, grid.shape),
            rng.uniform(-np.pi, np.pi, 30),
            rng.uniform(8, 26, 30),
            rng.uniform(8, 14, 30),
        ]
    )
    eyes = eyes_along([[(-30, 20 + 40 * k), (230, 20 + 40 * k)] for k in range(4)], 6.0)
    return boxes, rng.choice([1.0, 6.0, 12.0, 40.0], 30), rng.uniform(0, 1, (30, 5)), eyes


def test_a_building_behind_another_is_not_seen() -> None:
    boxes = np.array([[0, 30, SOUTH, 30, 10], [0, 60, SOUTH, 20, 10], [40, 60, SOUTH, 20, 10]])
    found = seen([[0, 0]], boxes, [12.0, 12.0, 12.0], [1.0, 1.0, 1.0], rays=MANY)
    assert found.buildings[0] > 0.0 < found.buildings[2]
    assert found.buildings[1] == 0.0
    assert found.nearest.tolist() == [0, -1, 0]
    over = seen([[0, 0]], boxes, [3.0, 30.0, 12.0], [1.0, 1.0, 1.0], rays=MANY)
    assert over.buildings[1] > 0.0
    boxes[0, 0] = -60.0
    assert seen([[0, 0]], boxes, [12.0, 12.0, 12.0], [1.0] * 3, rays=MANY).buildings[1] > 0.0


@pytest.mark.parametrize("away", [10.0, 40.0, 120.0])
def test_the_value_is_the_integral_over_the_wall(away: float) -> None:
    """V = 1/Ω ∫ q/q* (1 - d/D)² cos²θ / d² dA, by a fine grid on a wall."""
    wide, high, q = 24.0, 9.0, np.array([0.3, 0, 0, 0, 0])
    found = seen([[3.0, 0.0]], [[0, away + 5, SOUTH, wide, 10]], [high], [q], 0.6, 200_000)
    x = np.linspace(-wide / 2, wide / 2, 801)[1::2][:, None] - 3.0
    z = np.linspace(0, high, 801)[1::2][None] - 1.6
    d = np.sqrt(x**2 + z**2 + away**2)
    kept = (z / d > np.sin(BAND[0])) & (z / d < np.sin(BAND[1]))
    cell = (wide / 400) * (high / 400)
    value = 0.5 * (1 - d / REACH) ** 2 * (away / d) ** 2 / d**2 * kept * cell
    whole = 2 * np.pi * (np.sin(BAND[1]) - np.sin(BAND[0]))
    assert found.points[0] == pytest.approx(value.sum() / whole, rel=0.01)


def test_nearer_counts_more_and_far_away_nothing() -> None:
    values = [
        seen([[0, 0]], [[0, y, SOUTH, 20, 10]], [12.0], [1.0], rays=MANY).points[0]
        for y in (20, 30, 60, 120, 190, 210)
    ]
    assert (np.diff(values[:5]) < 0).all()
    assert values[5] == 0.0 < values[4]


def test_it_stays_between_nothing_and_all() -> None:
    walls = np.array([[0, 3, SOUTH, 60, 2], [0, -3, SOUTH, 60, 2]])
    found = seen([[0, 0]], walls, [300.0, 300.0], [2.0, 2.0], rays=MANY)
    assert 0.4 < found.points[0] < 1.0
    assert seen([[0, 0]], walls, [300.0, 300.0], [2.0, 2.0], 0.1, MANY).points[0] == 1.0
    assert seen([[0, 0]], walls, [300.0, 300.0], [0.0, 0.0]).points.tolist() == [0.0]
    inside = seen([[0, 3]], walls, [300.0, 300.0], [2.0, 2.0])
    assert inside.points.tolist() == [0.0]
    empty = seen([[0, 0]], np.zeros((0, 5)), [], np.zeros((0, 5)))
    assert empty.points.tolist() == [0.0]
    assert empty.buildings.shape == (0,)


def test_a_symmetric_scene_has_symmetric_values() -> None:
    half = np.array([[20, 15, 0.3, 14, 9], [50, -20, 1.2, 20, 9], [90, 10, 2.0, 12, 12]])
    boxes = np.concatenate([half, half * [-1, 1, -1, 1, 1] + [0, 0, np.pi, 0, 0]])
    density = np.array([[0.9, 0.4, 0.2, 0.5, 0.1]] * 3)
    heights, quality = [9.0, 14.0, 30.0] * 2, np.concatenate([density, density[:, [0, 3, 2, 1, 4]]])
    eyes = [[-30, 0], [30, 0], [-70, 5], [70, 5], [0, 0]]
    found = seen(eyes, boxes, heights, quality, rays=MANY)
    assert found.points[[0, 2]] == pytest.approx(found.points[[1, 3]], rel=0.02)
    assert found.buildings[:3] == pytest.approx(found.buildings[3:], rel=0.03)
    assert found.nearest[3] in (0, 4) or found.nearest[0] in (1, 4)


def test_the_scene_may_be_moved_and_turned() -> None:
    boxes, heights, density, eyes = town(1)
    before = seen(eyes, boxes, heights, density, rays=1024)
    c, s = np.cos(0.7), np.sin(0.7)
    turn, turned = np.array([[c, s], [-s, c]]), boxes.copy()
    turned[:, :2], turned[:, 2] = boxes[:, :2] @ turn + [900, -300], boxes[:, 2] + 0.7
    after = seen(eyes @ turn + [900, -300], turned, heights, density, rays=1024)
    assert after.points == pytest.approx(before.points, abs=0.006)
    assert after.buildings.sum() == pytest.approx(before.buildings.sum(), rel=0.005)


def test_a_hidden_back_adds_nothing_but_to_the_sum_over_the_mesh() -> None:
    boxes, heights = np.array([[0, 30, SOUTH, 30, 10]]), [12.0]
    bare, rich = np.array([[0.2] * 5]), np.array([[0.2, 0.2, 1.0, 0.2, 0.2]])
    one, other = (seen([[0, 0]], boxes, heights, q, 1.0, 512).points[0] for q in (bare, rich))
    assert one == other > 0.0
    sizes = [[30, 10, 12]]
    assert summed_quality(rich, sizes) - summed_quality(bare, sizes) == pytest.approx(
        [0.8 * 30 * 12]
    )
    boxes[0, 2] += np.pi
    turned = seen([[0, 0]], boxes, heights, rich, 1.0, 512).points[0]
    assert turned == pytest.approx(5 * one)


@pytest.mark.parametrize("seed", [0, 3])
def test_boxes_are_seen_as_their_meshes_are(seed: int) -> None:
    boxes, heights, density, eyes = town(seed)
    sizes = np.column_stack([boxes[:, 3:], heights])
    models = [block(size, sides) for size, sides in zip(sizes, density, strict=True)]
    poses = np.column_stack([boxes[:, :2], np.zeros(30), boxes[:, 2]])
    made = sights_of_boxes(box_grid(boxes, heights), density, eyes, 0.8)
    exact = sights_of_meshes(street(models, np.arange(30), poses), eyes, 0.8, made.ways.shape[0])
    same = made.found == exact.found
    assert same.mean() > 0.999
    assert made.values[same] == pytest.approx(exact.values[same], abs=1e-3)
    assert np.isfinite(made.distances).mean() > 0.2
    near = np.isfinite(made.distances) & same
    assert made.distances[near] == pytest.approx(exact.distances[near], abs=1e-2)
    mine, theirs = seen_of(made, 30), seen_of(exact, 30)
    assert mine.points == pytest.approx(theirs.points, abs=2e-3)
    assert mine.buildings == pytest.approx(theirs.buildings, abs=1e-4)


def test_what_buildings_add_is_what_eyes_see() -> None:
    boxes, heights, density, eyes = town(2)
    made = sights_of_boxes(box_grid(boxes, heights), density, eyes)
    found = seen_of(made, 30)
    assert found.buildings.sum() == pytest.approx(found.points.mean())
    for b in range(30):
        adds = np.where(made.found == b, made.values, 0.0).sum(1) / made.found.shape[1]
        assert found.most[b] == pytest.approx(adds.max())
        assert found.nearest[b] == (-1 if adds.max() == 0 else adds.argmax())
    again = sights(eyes)
    alone = [
        look_from(box_grid(boxes, heights), density / density.max(), again, REACH, e)
        for e in range(len(eyes))
    ]
    assert np.array(alone) == pytest.approx(found.points)


def test_rays_fill_the_band_evenly() -> None:
    ways = ways_of(sights(np.zeros((50, 2))))
    assert np.linalg.norm(ways, axis=-1) == pytest.approx(1.0)
    assert np.abs(ways[..., :2].mean((0, 1))).max() < 0.02
    turned = np.arctan2(ways[..., 1], ways[..., 0]).round(6)
    assert len(np.unique(turned)) == 50 * 64, "no two eyes look the same ways"
    z = np.sort(ways[0, :, 2])
    assert np.diff(z) == pytest.approx(np.full(63, z[1] - z[0]))
    assert (z[0] > np.sin(BAND[0])) & (z[-1] < np.sin(BAND[1]))


def test_eyes_lie_evenly_on_the_paths() -> None:
    eyes = eyes_along([[(0, 0), (30, 40)], [(5, 5), (5, 5)], [(0, 0), (3, 0)]], 5.0)
    assert eyes.shape == (12, 2)
    assert np.hypot(*np.diff(eyes[:10], axis=0).T) == pytest.approx(np.full(9, 5.0))
    assert eyes[10:].tolist() == [[5, 5], [1.5, 0]]
    assert eyes_along([]).shape == (0, 2)


def test_an_ornamented_front_is_what_its_side_shows() -> None:
    """The saliency of a real mesh, reduced to the five faces of its box."""
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) / 2
    body = loft(
        [square * [12, 10] + [0, -0.5], square * [12, 10] + [0, -0.5]] @ np.eye(3)[:2]
        + np.array([[[0, 0, 0]], [[0, 0, 9]]])
    )
    sill = loft([square @ np.eye(3)[:2] * [1.2, 1, 0] + [0, 0, z] for z in (0.0, 0.8)])
    sills = [translate_mesh(sill, x, 4.5, z) for x in (-4, 0, 4) for z in (2, 5, 7)]
    mesh = merge([body, *sills])
    found = saliency(mesh)
    sides = side_densities(SaliencyModel(mesh, found.faces))
    assert sides[0] > 1.2 * sides[2]
    model = SaliencyModel(mesh, found.faces)
    eyes = np.array([[0.0, 30.0], [0.0, -30.0]])
    shown = seen_of(sights_of_meshes(street([model], [0], [[0, 0, 0, np.pi / 2]]), eyes), 1)
    as_box = seen(
        eyes,
        [[0, 0, np.pi / 2, 12, 11]],
        [9.0],
        [sides],
        street([model], [0], [[0, 0, 0, 0]]).best,
        4096,
    )
    assert shown.points[0] > shown.points[1] > 0.0
    assert as_box.points == pytest.approx(shown.points, rel=0.35)


def test_large_models_become_boxes_before_memory_runs_out() -> None:
    fine = block(np.array([10.0, 10.0, 10.0]), np.arange(5.0))
    rough = SaliencyModel(merge([fine.mesh] * 20), np.tile(fine.density, 20))
    poses = np.column_stack([np.arange(6) * 30.0, np.zeros((6, 2)), np.full(6, SOUTH)])
    which = [0, 1, 1, 0, 1, 0]
    assert len(street([fine, rough], which, poses).owner) == 3 * 12 + 3 * 240
    small = street([fine, rough], which, poses, most=200)
    assert np.bincount(small.owner).tolist() == [12] * 6
    assert small.best == pytest.approx(14 / 6)
    assert to_bounding_box(rough).density == pytest.approx(np.full(12, 14 / 6))


def test_the_best_spot_shows_several_buildings_rather_than_one() -> None:
    """The same wall in one piece to the west and as four buildings to the east."""
    one = np.array([[-45.0, 0, 0, 57, 10]])
    four = np.array([[45.0, y, np.pi, 12, 10] for y in (-22.5, -7.5, 7.5, 22.5)])
    made = sights_of_boxes(
        box_grid(np.concatenate([one, four]), np.full(5, 12.0)), np.ones(5), [[0, 0]], rays=2048
    )
    assert made.values[made.found == 0].sum() > made.values[made.found > 0].sum()
    assert best_spots(made)[0].way[0] > 0.9


def test_the_best_spot_looks_at_the_best_facade() -> None:
    """A lane between dull walls; one good facade closes the square at its end."""
    boxes = np.array([[20, 8, SOUTH, 60, 8], [20, -8, -SOUTH, 60, 8], [90, 0, np.pi, 30, 10]])
    density = np.array([[0.05] * 5, [0.05] * 5, [1.0, 0.05, 0.05, 0.05, 0.05]])
    eyes = eyes_along([[(-20, 0), (80, 0)]], 2.0)
    made = sights_of_boxes(box_grid(boxes, [9.0, 9.0, 15.0]), density, eyes, rays=512)
    spot = best_spots(made)[0]
    assert spot.way[0] > 0.95
    assert np.linalg.norm(spot.way) == pytest.approx(1.0)
    assert 15.0 < 85.0 - spot.point[0] < 60.0
    assert spot.point[2] == 1.6
    assert 0.0 < spot.score <= 3 * made.values.mean(1).max()
