"""How villages are filled: relations against slow references, proposals, weights, doors."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.domains import problems, solvers
from scenewright.domains.village.doors import assign_doors
from scenewright.domains.village.house import rectangle_about, to_own_frame
from scenewright.domains.village.library import LOOKS, our_houses
from scenewright.domains.village.measures import relations_of, void
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.proposals import draw_values, is_legal, propose, shapes_at, shrink
from scenewright.domains.village.settings import OURS
from scenewright.domains.village.solvers.growing import standing_of
from scenewright.domains.village.standing import place, stand
from scenewright.domains.village.weights import log_ratio
from scenewright.engine.solve import Budget


@pytest.fixture(scope="module")
def problem() -> VillageProblem:
    outline = [[0, 0], [70, -4], [90, 40], [40, 70], [-5, 50]]
    block = {"id": "b", "outline": outline, "streets": [0, 1], "count": 9}
    return problems(Brief.model_validate({"domain": "village", "blocks": [block]}))[0]


def boxes(rng: np.random.Generator, count: int) -> list[np.ndarray]:
    outlines = [house.outline for house in our_houses("rural")[:count]]
    poses = rng.uniform((0, 0, -3), (200, 200, 3), (count, 3))
    return [place(ring, pose[None])[0] for ring, pose in zip(outlines, poses, strict=True)]


def test_relations_do_not_change_when_all_is_turned_and_moved() -> None:
    rings, streets = boxes(np.random.default_rng(3), 8), np.array([[[0.0, -9.0], [200.0, -20.0]]])
    one = relations_of(stand(rings, [1] * 8), streets)
    cos, sin = np.cos(0.7), np.sin(0.7)
    turn = np.array([[cos, sin], [-sin, cos]])
    moved = [ring @ turn + (40.0, -7.0) for ring in rings]
    other = relations_of(stand(moved, [1] * 8), streets @ turn + (40.0, -7.0))
    for a, b in zip(one, other, strict=True):
        assert a == pytest.approx(b, abs=1e-6)


def test_relations_are_those_of_a_slow_reference() -> None:
    rings, street = boxes(np.random.default_rng(5), 7), np.array([[[-99.0, -9.0], [299.0, -9.0]]])
    standing = stand(rings, [1] * 7)
    found = relations_of(standing, street)
    for k, ring in enumerate(rings):
        gaps = [shapely.Polygon(ring).distance(s) for s in standing.shapes]
        gaps[k] = np.inf
        near = int(np.argmin(gaps))
        assert found.gap[k] == pytest.approx(gaps[near])
        angles = [rectangle_about(rings[j])[0] for j in (k, near)]
        off = abs(angles[0] - angles[1]) % (np.pi / 2)
        assert found.turn[k] == pytest.approx(min(off, np.pi / 2 - off), abs=1e-9)
        assert found.street[k] == pytest.approx(ring[:, 1].min() + 9.0)


def test_legal_is_what_shapely_says_of_each(problem: VillageProblem) -> None:
    rng = np.random.default_rng(0)
    others = stand([r * 0.4 for r in boxes(rng, 6)], [1] * 6)
    house = our_houses("rural")[16]
    poses = propose(problem, others, house, rng)
    shapes, rings = shapes_at(house, poses)
    found = is_legal(problem.floor, shrink(others.shapes), shapes, rings)
    for shape, legal in zip(shapes, found, strict=True):
        shared = max(shape.intersection(other).area for other in others.shapes)
        inside = shape.difference(problem.floor).area < 1e-9
        assert legal == inside and shared < 0.5 if legal else (not inside or shared > 1e-4)
    assert 0 < found.sum() < len(found)


def test_drawn_values_follow_their_table() -> None:
    table = OURS.gap
    values = draw_values(table, table.large, 20_000, np.random.default_rng(1))
    held = np.histogram(values, np.array(table.edges[:-1]) + 1e-12 * (np.arange(15) > 0))[0]
    shares = np.array(table.large[:-1]) / sum(table.large[:-1])
    assert held / 20_000 == pytest.approx(shares, abs=0.012)


def test_weights_turn_what_was_proposed_into_what_is_real() -> None:
    rng, table = np.random.default_rng(2), OURS.turn
    values = rng.uniform(0, np.pi / 4, 4000)
    odds = np.exp(log_ratio(table, 1, values))
    bins = np.searchsorted(np.array(table.edges[1:-1]), values, side="right")
    shares = np.bincount(bins, odds, minlength=9) / odds.sum()
    assert shares == pytest.approx(np.array(table.large) / sum(table.large), abs=0.01)


def test_void_of_one_house_in_the_middle() -> None:
    floor = shapely.box(0, 0, 100, 4)
    standing = stand([np.array([[48.0, 0], [52, 0], [52, 4], [48, 4]])], [0])
    assert void(floor, standing) == pytest.approx(0.95 * 48, abs=2.5)


@pytest.mark.parametrize("look", LOOKS)
def test_houses_of_the_library_lie_in_their_own_frame(look: str) -> None:
    for house in our_houses(look):
        again, turn = to_own_frame(house.outline)
        assert turn == pytest.approx(0.0, abs=1e-9)
        assert again == pytest.approx(house.outline, abs=1e-6)
        assert house.extent[0] >= house.extent[1]
        assert house.area == pytest.approx(shapely.Polygon(house.outline).area)


def test_doors_look_to_the_street_and_never_at_a_neighbour() -> None:
    walk = shapely.box(0, -4, 60, 50)
    street = np.array([[[0.0, 0.0], [60.0, 0.0]]])
    first, behind, close = (box_at(y) for y in (8.0, 21.0, 16.3))
    assert assign_doors(walk, street, [first, behind], [-1, -1]).side.tolist() == [0, 0]
    found = assign_doors(walk, street, [first, close], [-1, -1]).side.tolist()
    assert found[0] == 0
    assert found[1] in (1, 3)
    assert assign_doors(walk, street, [first, close], [-1, 0]).side.tolist() == [0, -1]


def box_at(y: float) -> np.ndarray:
    return np.array([[15.0, y - 4], [25.0, y - 4], [25.0, y + 4], [15.0, y + 4]])


@pytest.mark.parametrize("name", solvers("village"))
def test_every_solver_answers_with_legal_layouts(name: str, problem: VillageProblem) -> None:
    found = solvers("village")[name].run(problem, Budget(steps=2), 3)
    layout = found.layouts[0]
    assert found.evaluations == 2
    standing = standing_of(problem, layout)
    assert problem.floor.buffer(1e-6).covers(shapely.union_all(standing.shapes))
    shared = shapely.area(shapely.intersection(standing.shapes[:, None], standing.shapes[None]))
    np.fill_diagonal(shared, 0.0)
    assert shared.max() < 0.1
    assert (layout.doors >= 0).all()


def test_houses_stand_as_the_tables_say_more_than_as_they_are_proposed() -> None:
    brief = sw.read("sample:village-street")
    shares = {}
    for name in ("grow", "proposals"):
        turns = []
        for seed in range(3):
            for one in problems(brief):
                layout = solvers("village")[name].run(one, Budget(steps=1), seed).layouts[0]
                turns.append(relations_of(standing_of(one, layout), one.streets).turn)
        shares[name] = float((np.concatenate(turns) < np.deg2rad(5)).mean())
    assert shares["grow"] > 0.5
