"""What the default solver of sites aims at: seen quality, sun, even spread; exchanges and turns."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from benchmarks.shapely_hall import polygon
from benchmarks.shapely_home import rectangle
from benchmarks.site_instances import example_site

from scenewright.domains.site.problem import SiteProblem, sides_of
from scenewright.domains.site.solvers.aims import around, lacking
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.blocks.block import BlockLayout
from scenewright.domains.site.solvers.exchange import exchange_all
from scenewright.domains.site.solvers.fill import fill_site
from scenewright.domains.site.solvers.improve import (
    exchanges,
    improve_layout,
    make_rule,
    make_slots,
    turns,
)
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.terms.measure import lay, make_site_state, prepare_site
from scenewright.domains.site.terms.table import read_site_aims
from scenewright.engine.solve import Budget, BudgetWatch
from scenewright.geometry.box_grid import box_grid
from scenewright.geometry.sun import sun_hours, sun_path
from scenewright.geometry.walker import REACH, look, sights

OFF = {"seen": 0.0, "sun": 0.0, "even": 0.0}
SEEDS = range(7)


def town(count: int = 30, **more: object) -> SiteProblem:
    """A site whose models show different things on each side."""
    problem = example_site(count)
    sides = np.random.default_rng(5).uniform(0.1, 1.0, (5, 5))[problem.buildings.models]
    made = problem.buildings._replace(sides=sides)
    return problem._replace(buildings=made, **more)


def filled(problem: SiteProblem, weights: dict[str, float], seed: int) -> SiteLayout:
    return fill_site(problem._replace(weights=weights), Budget(None, 6), seed).layouts[0]


def scored(problem: SiteProblem, found: SiteLayout, name: str) -> float:
    return score(problem, found.boxes, found.present)[name]


@pytest.mark.parametrize("name", ["seen", "sun"])
def test_what_is_aimed_at_grows(name: str) -> None:
    problem, gains = town(), []
    for seed in SEEDS:
        off, on = (filled(problem, OFF | more, seed) for more in ({}, {name: 3.0}))
        assert on.present.sum() == off.present.sum()
        gains.append(scored(problem, on, name) - scored(problem, off, name))
    assert np.median(gains) > 0.0
    assert min(gains) >= -0.1 * scored(problem, off, name)


def test_blocks_are_filled_about_their_middle_where_that_is_aimed_at() -> None:
    problem, off_middle = town(8), []
    for more in ({}, {"even": 5.0}):
        found = [filled(problem, OFF | more, seed) for seed in SEEDS]
        off_middle.append(np.median([uneven(problem, one) for one in found]))
    assert off_middle[1] < off_middle[0]


def uneven(problem: SiteProblem, found: SiteLayout) -> float:
    """How far the centre of the buildings of a block is off the block's, by exact polygons."""
    total, middles = 0.0, shapely.points(found.boxes[found.present, :2])
    for first, last in problem.ground.block_spans:
        block = polygon(problem.ground.block_edges[first:last])
        inside = found.boxes[found.present][shapely.contains(block, middles)]
        if len(inside):
            area = inside[:, 3] * inside[:, 4]
            middle = (area[:, None] * inside[:, :2]).sum(0) / area.sum()
            total += shapely.distance(block.centroid, shapely.Point(middle)) / block.area**0.5
    return total


def test_without_aims_nothing_changes_places() -> None:
    problem = town(weights=OFF)
    found = filled(problem, OFF, 1)
    watch = BudgetWatch(Budget(steps=1), None, None)
    assert improve_layout(problem, found, 1, watch)[0] is found


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_only_what_changed_is_looked_at_again_and_nothing_is_forgotten(seed: int) -> None:
    """After all moves, rays, hours and the gain are those of a fresh look at everything."""
    problem = town(40, weights={"seen": 3.0, "sun": 3.0})
    found = filled(problem, OFF, seed)
    here = np.flatnonzero(found.present)
    boxes, made = found.boxes[here], make_slots(problem, found.boxes[here], here)
    p, s = prepare_site(problem), make_site_state(problem)
    lay(p, s, np.concatenate([boxes, np.zeros((len(found.boxes) - len(boxes), 5))]))
    rule = make_rule(problem, made, read_site_aims(problem.weights))
    before = made.made.values.sum() * rule.seen + made.hours.sum() * rule.sun
    who, tally = here.copy(), np.zeros(2)
    swaps = exchanges(problem, made, who, found.forms, np.random.default_rng(seed))
    for moves in (swaps, turns(problem, boxes)):
        exchange_all(p, s, made, rule, moves, who, tally)
    assert tally[0] == len(swaps) + len(turns(problem, boxes))
    assert tally[1] > 0.0
    after = made.made.values.sum() * rule.seen + made.hours.sum() * rule.sun
    assert after - before == pytest.approx(tally[1], abs=1e-9)
    frames = made.grid.frames[:, [0, 1, 7, 4, 5]] * (1.0, 1.0, 1.0, 2.0, 2.0)
    fresh = sights(problem.ground.eyes[::2], problem.settings.exchange.rays)
    sides = np.concatenate([problem.buildings.sides[who], made.quality[len(who) :]])
    look(box_grid(frames, made.grid.heights), np.ascontiguousarray(sides), fresh, REACH)
    assert made.made.values == pytest.approx(fresh.values, abs=1e-12)
    assert (made.made.found == fresh.found).all()
    marks = problem.ground.landmarks, problem.ground.landmark_heights
    path = sun_path(problem.latitude, problem.day, minutes=30.0)
    heights = problem.buildings.sizes[who, 2]
    hours = sun_hours(frames[: len(who)], heights, path, marks)[:, 0]
    assert np.mean(np.abs(made.hours - hours) > 1e-9) < 0.2, "but for shadows from afar"


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_rules_hold_after_exchanges_by_exact_polygons(seed: int) -> None:
    problem = town(60, sun_spacing=0.5)
    found = filled(problem, {}, seed)
    sizes, boxes = problem.buildings.sizes[found.present], found.boxes[found.present]
    assert np.allclose(boxes[:, 3:], sizes[:, :2])
    shapes = np.array([rectangle(box) for box in boxes], object)
    blocks = [polygon(problem.ground.block_edges[a:b]) for a, b in problem.ground.block_spans]
    outside = shapely.area(shapely.difference(shapes, shapely.union_all(blocks)))
    assert outside.max() < 0.005
    pairs = shapely.STRtree(shapes).query(shapes, "dwithin", problem.spacing - 0.01)
    assert (pairs[0] == pairs[1]).all()
    for shape, height in zip(shapes, sizes[:, 2], strict=True):
        low_x, _, high_x, high_y = shape.bounds
        shadow = shapely.box(low_x + 1e-3, high_y, high_x - 1e-3, high_y + 0.5 * height - 1e-3)
        behind = [other for other in shapes if other.centroid.y > shape.centroid.y]
        assert not any(shadow.intersects(other) for other in behind)


def test_the_same_seed_gives_the_same_exchanges() -> None:
    one, other = (filled(town(60), {}, 3) for _ in range(2))
    assert (one.boxes == other.boxes).all()
    assert (one.boxes != filled(town(60), {}, 4).boxes).any()


def test_turned_fronts_do_not_leave_the_sun_or_their_way() -> None:
    problem = town(40)
    boxes = filled(problem, OFF, 0).boxes
    moves = turns(problem, boxes)
    headings = boxes[moves[:, 0], 2] + moves[:, 2] * math.pi / 2
    before = np.abs(np.angle(np.exp(1j * (boxes[moves[:, 0], 2] - problem.facing))))
    after = np.abs(np.angle(np.exp(1j * (headings - problem.facing))))
    assert (after <= np.maximum(before, math.radians(30)) + 1e-6).all()


@pytest.mark.parametrize(("good", "heading"), [(0, -math.pi / 2), (2, math.pi / 2)])
def test_a_good_front_turns_to_the_way_and_no_front_turns_away_from_it(
    good: int, heading: float
) -> None:
    """One building, its front to the north or to the way in the south; east is preferred."""
    problem = example_site(5, 160.0)
    ground = problem.ground._replace(
        landmarks=np.zeros((0, 5)), landmark_heights=np.zeros(0), landmark_quality=np.zeros(0)
    )
    first, last = ground.block_spans[int(np.argmax(ground.block_areas))]
    middle = polygon(ground.block_edges[first:last]).representative_point()
    eyes = np.column_stack([np.linspace(-30, 30, 13) + middle.x, np.full(13, middle.y - 25.0)])
    sides = np.full((5, 5), 0.05)
    sides[:, good] = 1.0
    problem = problem._replace(
        buildings=problem.buildings._replace(sides=sides),
        ground=ground._replace(eyes=eyes),
        weights={"sun": 0.0},
        facing=0.0,
    )
    boxes, present = np.zeros((5, 5)), np.arange(5) < 1
    watch = BudgetWatch(Budget(None, 1, threads=None), None, None)
    for before in (math.pi / 2, -math.pi / 2):
        boxes[0] = [middle.x, middle.y, before, *problem.buildings.sizes[0, :2]]
        found = SiteLayout(boxes, present, {}, ("parallel",) * 5)
        after = improve_layout(problem, found, 0, watch)[0].boxes[0, 2]
        wanted = -math.pi / 2 if before < 0.0 else heading
        assert math.cos(after - wanted) == pytest.approx(1.0)


def test_buildings_keep_to_their_forms_when_they_change_places() -> None:
    problem = town(40)
    forms = tuple(frozenset({"parallel"} if k % 2 else {"peripheral"}) for k in range(40))
    made = problem.buildings._replace(forms=forms)
    found = filled(problem, OFF, 0)._replace(
        forms=tuple("parallel" if k % 2 else "peripheral" for k in range(40))
    )
    watch = BudgetWatch(Budget(None, 1, threads=None), None, None)
    after, _ = improve_layout(problem._replace(buildings=made), found, 0, watch)
    assert all(form in may for form, may in zip(after.forms, forms, strict=True))
    assert improve_layout(problem, found, 0, watch)[0].forms != after.forms


def test_a_site_without_ways_or_sun_is_filled_all_the_same() -> None:
    problem = town(12)
    ground = problem.ground._replace(eyes=np.zeros((0, 2)))
    found = filled(problem._replace(ground=ground, latitude=85.0, day=355), {}, 0)
    assert found.present.all()


def test_a_block_lacks_less_the_better_its_models_look() -> None:
    problem = town(10)
    first, last = problem.ground.block_spans[0]
    about = around(
        problem, problem.ground.block_edges[first:last], np.zeros((10, 5)), np.zeros(10, bool)
    )
    found = filled(problem, OFF, 0)
    here = tuple(np.flatnonzero(found.present).tolist())
    placed = BlockLayout(here, found.boxes[list(here)], "parallel")
    plain = problem._replace(
        buildings=problem.buildings._replace(
            sides=sides_of(problem.buildings.sides, problem.buildings.quality) * 0.5
        )
    )
    assert lacking(problem, about, placed, np.inf) < lacking(plain, about, placed, np.inf)
    nothing = BlockLayout((), np.zeros((0, 5)), "")
    assert lacking(problem, about, nothing, np.inf) == about.weights.sum()
