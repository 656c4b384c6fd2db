"""What every pattern promises: all are placed, none overlap, and the shape it is named for."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import pytest
import shapely
from benchmarks.hall_instances import example_hall

from scenewright.domains.hall.energy import capacity, make_state, prepare
from scenewright.domains.hall.measures import AISLE
from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, CODE, NUMBER, PART, PATTERNS
from scenewright.domains.hall.patterns.expand import expand, seed, stretch
from scenewright.domains.hall.patterns.fan import BLOCK
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.solvers.moves import reseed, scatter
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.place import unfold
from scenewright.domains.hall.terms.state import make_scratch
from scenewright.engine.draws import streams

CODES = {name: code for code, name in enumerate(PATTERNS)}
FREE = [name for name in PATTERNS if name != "wall"]
MANY = [name for name in FREE if name != "single"]
COUNTS = range(1, 61)
SHAPES = (0.0, 0.3, 0.6, 0.99)
WIDE, DEEP, GAPS = 1.2, 0.6, (0.5, 0.9)
NEAR = 2.5


class Pattern(NamedTuple):
    """A seeded pattern: its code, layers and extra measure, sizes, and places x, y, turn."""

    code: int
    layers: Floats
    extra: float
    sizes: Floats
    places: Floats

    @property
    def rows(self) -> list[Floats]:
        """Places by layer."""
        return np.split(self.places, np.cumsum(self.layers[:, NUMBER]).astype(int)[:-1])


def seeded(
    name: str,
    number: int,
    shape: float,
    sizes: Floats | None = None,
    gaps: tuple[float, float] = GAPS,
) -> Pattern:
    sizes = np.tile([WIDE, DEEP], (number, 1)) if sizes is None else sizes
    layers = np.zeros((int(capacity(np.array([number]))[0]), 5))
    wide, deep = (float(side) for side in sizes.max(0))
    used, extra = seed(CODES[name], number, shape, wide, deep, *gaps, NEAR, layers)
    assert used <= len(layers)
    return laid(CODES[name], layers[:used], extra, sizes)


def laid(code: int, layers: Floats, extra: float, sizes: Floats) -> Pattern:
    out = np.full((len(sizes) + 1, 3), np.nan)
    placed = expand(code, layers, extra, sizes, 0, out)
    assert placed == len(sizes)
    assert np.isfinite(out[:placed]).all()
    assert np.isnan(out[placed:]).all()
    return Pattern(code, layers, extra, sizes, out[:placed])


def bodies(found: Pattern) -> np.ndarray:
    """Footprints as polygons in the pattern's own frame."""
    turn = found.places[:, 2]
    right = np.stack([np.cos(turn), np.sin(turn)], 1) * found.sizes[:, :1] / 2
    ahead = np.stack([-np.sin(turn), np.cos(turn)], 1) * found.sizes[:, 1:] / 2
    middle = found.places[:, :2]
    corners = [
        middle + right + ahead,
        middle - right + ahead,
        middle - right - ahead,
        middle + right - ahead,
    ]
    return np.asarray(shapely.polygons(np.stack(corners, 1)))


def overlap(found: Pattern) -> float:
    """The largest area two objects share."""
    shapes = bodies(found)
    first, second = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    pairs = first < second
    shared = shapely.area(shapely.intersection(shapes[first[pairs]], shapes[second[pairs]]))
    return float(shared.max(initial=0.0))


def fronts(places: Floats) -> Floats:
    return np.stack([-np.sin(places[:, 2]), np.cos(places[:, 2])], 1)


def forms(name: str, least: int = 1) -> list[Pattern]:
    counts = [1] if name == "single" else [n for n in COUNTS if n >= least]
    return [seeded(name, number, shape) for number in counts for shape in SHAPES]


@pytest.mark.parametrize("name", FREE)
def test_every_object_is_placed_and_none_overlaps(name: str) -> None:
    for found in forms(name):
        assert found.layers[:, NUMBER].min() >= 1
        assert found.layers[:, NUMBER].sum() == len(found.sizes)
        assert overlap(found) < 1e-9, (len(found.sizes), found.layers)


@pytest.mark.parametrize("name", MANY)
@pytest.mark.parametrize("gaps", [(0.0, 0.9), (0.3, 0.3)])
def test_close_gaps_do_not_overlap_either(name: str, gaps: tuple[float, float]) -> None:
    for number in (2, 3, 5, 8, 13, 30, 60):
        for shape in SHAPES:
            assert overlap(seeded(name, number, shape, gaps=gaps)) < 1e-9, (number, shape)


@pytest.mark.parametrize("name", MANY)
def test_unequal_objects_are_placed_and_none_overlaps(name: str) -> None:
    rng = np.random.default_rng(5)
    for number in (2, 5, 7, 12, 31):
        sizes = rng.uniform((0.4, 0.3), (1.8, 1.2), (number, 2))
        for shape in SHAPES:
            assert overlap(seeded(name, number, shape, sizes)) < 1e-9, (number, shape)


@pytest.mark.parametrize("name", MANY)
def test_patterns_are_the_same_wherever_their_sizes_are_kept(name: str) -> None:
    """Objects may start anywhere in the list of all sizes."""
    found, before = seeded(name, 9, 0.6), np.full((4, 2), 7.0)
    out = np.zeros((9, 3))
    expand(found.code, found.layers, found.extra, np.vstack([before, found.sizes]), 4, out)
    assert np.array_equal(out, found.places)


def test_many_shapes_are_seeded() -> None:
    for name in ("chain", "grid", "radiation", "circulation", "fan"):
        kinds = {len(seeded(name, 48, shape).layers) for shape in np.linspace(0, 0.99, 12)}
        assert len(kinds) > 1, name


@pytest.mark.parametrize("name", ["chain", "grid"])
def test_rows_are_parallel_and_as_far_apart_as_said(name: str) -> None:
    for found in forms(name):
        assert not found.places[:, 2].any()
        for row in found.rows:
            assert np.ptp(row[:, 1]) < 1e-9
            assert np.diff(row[:, 0]) == pytest.approx(WIDE + GAPS[0])
        levels = [row[0, 1] for row in found.rows]
        assert -np.diff(levels) == pytest.approx(DEEP + GAPS[1])


def test_rows_of_a_chain_are_in_the_middle() -> None:
    for found in forms("chain"):
        assert [row[:, 0].mean() for row in found.rows] == pytest.approx([0.0] * len(found.rows))


def test_rows_of_a_chain_keep_their_gaps_between_unequal_objects() -> None:
    sizes = np.random.default_rng(1).uniform((0.4, 0.3), (1.8, 1.2), (12, 2))
    found = seeded("chain", 12, 0.5, sizes)
    assert len(found.rows) > 1
    parts = np.split(sizes, np.cumsum(found.layers[:, NUMBER]).astype(int)[:-1])
    for row, part in zip(found.rows, parts, strict=True):
        gaps = np.diff(row[:, 0]) - (part[1:, 0] + part[:-1, 0]) / 2
        assert gaps == pytest.approx(GAPS[0])
    shapes = bodies(found)
    tops = np.split(shapely.bounds(shapes)[:, 3], np.cumsum(found.layers[:, NUMBER]).astype(int))
    lows = np.split(shapely.bounds(shapes)[:, 1], np.cumsum(found.layers[:, NUMBER]).astype(int))
    for upper, lower in zip(lows[:-2], tops[1:-1], strict=True):
        assert upper.min() - lower.max() == pytest.approx(GAPS[1])


def test_columns_of_a_grid_are_aligned_whatever_the_sizes() -> None:
    rng = np.random.default_rng(2)
    for number in COUNTS:
        sizes = rng.uniform((0.4, 0.3), (1.8, 1.2), (number, 2))
        found = seeded("grid", number, 0.5, sizes)
        columns = found.rows[0][:, 0]
        for row in found.rows:
            assert row[:, 0] == pytest.approx(columns[: len(row)])
            assert len(row) <= len(columns)
        assert {len(row) for row in found.rows[:-1]} <= {len(columns)}


@pytest.mark.parametrize("name", ["radiation", "circulation"])
def test_rings_are_round_and_look_outwards(name: str) -> None:
    for found in forms(name):
        for row, layer in zip(found.rows, found.layers, strict=True):
            radius = np.hypot(row[:, 0], row[:, 1])
            assert radius == pytest.approx(layer[ACROSS])
            if layer[ACROSS] > 0.0:
                away = row[:, :2] / radius[:, None]
                assert fronts(row) == pytest.approx(away, abs=1e-9)
            else:
                assert len(row) == 1


def test_radiations_are_regular_polygons() -> None:
    for found in forms("radiation"):
        for row in (row for row in found.rows if len(row) > 1):
            steps = np.diff(np.append(row[:, 2], row[0, 2] + 2 * math.pi))
            assert steps == pytest.approx(2 * math.pi / len(row))


def test_rings_of_a_circulation_close_up_but_for_the_way_in() -> None:
    for found in forms("circulation", 3):
        for row, layer in zip(found.rows, found.layers, strict=True):
            steps = np.diff(np.append(row[:, 2], row[0, 2] + 2 * math.pi))
            assert np.ptp(steps[:-1]) < 1e-9
            assert row[:, 2].mean() == pytest.approx(math.pi)  # one goes in from ahead
            opening = (steps[-1] - steps[0]) * layer[ACROSS]
            assert opening == pytest.approx(layer[ALONG], abs=1e-6)
            if len(found.rows) == 1 and len(row) > 3:
                chord = 2 * (layer[ACROSS] - DEEP / 2) * math.tan(steps[0] / 2)
                assert WIDE <= chord < WIDE + 0.2, (len(row), chord)


def test_fans_look_at_their_apex_from_behind() -> None:
    for found in forms("fan"):
        apexes = []
        for row, layer in zip(found.rows, found.layers, strict=True):
            assert layer[ACROSS] >= NEAR
            apexes.append(row[:, :2] + layer[ACROSS] * fronts(row))
            assert np.ptp(row[:, 2]) < found.extra <= math.pi
        assert np.ptp(np.vstack(apexes), axis=0) == pytest.approx([0, 0], abs=1e-9)


def test_arcs_have_aisles_between_blocks() -> None:
    seen = 0
    sizes = np.tile([0.55, 0.65], (400, 1))
    for number in (60, 140, 400):
        for shape in SHAPES:
            found = seeded("fan", number, shape, sizes[:number], (0.0, 0.45))
            shapes = np.split(bodies(found), np.cumsum(found.layers[:, NUMBER]).astype(int)[:-1])
            for row, layer in zip(shapes, found.layers, strict=True):
                apart = shapely.distance(row[1:], row[:-1])
                aisles = apart[apart > 0.5 * AISLE]
                blocks = np.diff([-1, *np.flatnonzero(apart > 0.5 * AISLE), len(row) - 1])
                assert len(aisles) == min(layer[ALONG], len(row) - 1)
                assert blocks.max() <= BLOCK + 1
                assert aisles.min(initial=AISLE) >= 0.85 * AISLE
                seen += len(aisles)
            assert overlap(found) < 1e-9
    assert seen > 10


def test_parts_of_a_mixture_stand_side_by_side() -> None:
    kinds = set()
    for found in forms("mixture", 6):
        numbers = np.repeat(found.layers[:, PART], found.layers[:, NUMBER].astype(int))
        shapes = bodies(found)
        bounds = [shapely.total_bounds(shapes[numbers == part]) for part in np.unique(numbers)]
        assert len(bounds) == 3
        assert [(numbers == part).sum() for part in (0, 2)] == [len(found.sizes) // 3] * 2
        for left, right in pairwise(bounds):
            assert right[0] - left[2] == pytest.approx(found.extra)
        middles = [(low + high) / 2 for _, low, _, high in bounds]
        assert middles == pytest.approx([0.0] * 3, abs=1e-9)
        kinds |= set(found.layers[:, CODE])
    assert kinds == {CODES["chain"], CODES["radiation"]}


@pytest.mark.parametrize("name", MANY)
@pytest.mark.parametrize(("along", "across"), [(0.25, 0.0), (0.0, 0.25), (0.3, 0.4), (-0.2, -0.1)])
def test_expanding_enlarges_the_gaps_by_as_much(name: str, along: float, across: float) -> None:
    for number in (6, 13, 30):
        before = seeded(name, number, 0.6)
        layers = before.layers.copy()
        extra = stretch(before.code, layers, before.extra, along, across)
        after = laid(before.code, layers, extra, before.sizes)
        if name in ("chain", "grid"):
            for old, new in zip(before.rows, after.rows, strict=True):
                wider = np.diff(new[:, 0]) - np.diff(old[:, 0])
                assert wider == pytest.approx(along, abs=1e-9)
            levels = [np.array([row[0, 1] for row in one.rows]) for one in (before, after)]
            assert np.diff(levels[0]) - np.diff(levels[1]) == pytest.approx(across, abs=1e-9)
        else:
            assert math.copysign(1, along + across) * (reach(after) - reach(before)) >= -1e-9
        assert overlap(after) < 1e-9 or along + across < 0


def reach(found: Pattern) -> float:
    """Perimeter of the box around a pattern."""
    x0, y0, x1, y1 = shapely.total_bounds(bodies(found))
    return float(x1 - x0 + y1 - y0)


def test_rings_grow_by_their_rank() -> None:
    found = seeded("circulation", 40, 0.99)
    layers = found.layers.copy()
    stretch(found.code, layers, found.extra, 0.0, 0.5)
    assert len(layers) > 1
    grown = layers[:, ACROSS] - found.layers[:, ACROSS]
    assert grown == pytest.approx(0.5 * np.arange(1, len(layers) + 1))


def test_nothing_shrinks_below_nothing() -> None:
    for name in MANY:
        found = seeded(name, 20, 0.6)
        extra = stretch(found.code, found.layers, found.extra, -50.0, -50.0)
        assert extra >= 0.0
        assert found.layers[:, ALONG:CODE].min() >= 0.0
        laid(found.code, found.layers, extra, found.sizes)


def test_a_pose_moves_all_boxes_rigidly() -> None:
    """The pattern's own right and ahead become the pose's; headings turn along."""
    p = prepare(example_hall())
    s, work, stream = make_state(p), make_scratch(p), streams(3, 1)[0]
    boxes, checked = [np.zeros((len(p.sizes), 5)) for _ in range(2)], 0
    for unit, code in zip(*p.choices.nonzero(), strict=True):
        if code == CODES["wall"]:
            continue
        reseed(p, s, unit, code, 0.6, 1.0)
        mine = slice(*p.spans[unit])
        for k in range(2):
            scatter(p, s, unit, stream)
            s.pose[unit, 2] += 0.3 * (k + 1)
            assert unfold(p, s, work, unit)
            copy_frames(s, boxes[k])
            boxes[k][mine, :2] -= s.pose[unit, :2]
            turn = s.pose[unit, 2]
            boxes[k][mine, 2] = np.exp(1j * (boxes[k][mine, 2] - turn)).imag
            spun = (boxes[k][mine, 0] + 1j * boxes[k][mine, 1]) * np.exp(-1j * turn)
            boxes[k][mine, 0], boxes[k][mine, 1] = spun.real, spun.imag
        assert boxes[0][mine] == pytest.approx(boxes[1][mine], abs=1e-9)
        checked += 1
    assert checked >= 4


def test_aisles_divide_long_rows_of_a_chain_and_no_others() -> None:
    layers = np.array([[30.0, 0.0, 1.0, CHAIN, 0.0], [14.0, 0.0, 1.0, CHAIN, 0.0]])
    sizes, out = np.full((44, 2), 0.5), np.zeros((44, 3))
    assert expand(CHAIN, layers, 1.2, sizes, 0, out) == 44
    gaps = np.diff(out[:30, 0]) - 0.5
    assert np.flatnonzero(gaps > 1e-9).tolist() == [9, 19]
    assert gaps[[9, 19]] == pytest.approx(1.2)
    assert np.diff(out[30:, 0]) == pytest.approx(0.5)
    assert [out[:30, 0].mean(), out[30:, 0].mean()] == pytest.approx([0.0, 0.0])
