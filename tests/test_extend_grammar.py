"""Growth by the grammar: strings unfolded, groups kept, whole layouts repeated."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.domains import problems
from scenewright.domains.extend.problem import ExtendProblem, GrownLayout, shapes_at
from scenewright.domains.extend.solvers import EXTEND_SOLVERS
from scenewright.domains.extend.solvers.scene_grammar import read_grammar
from scenewright.engine.solve import Budget
from scenewright.geometry.folding import fold, stretch, unfold
from scenewright.ground.buildings.built import to_frames
from scenewright.ground.buildings.rows import PASSAGE


def grown_by_grammar(name: str) -> tuple[ExtendProblem, GrownLayout]:
    (problem,) = problems(sw.read(f"sample:extend-{name}"), "grammar")
    return problem, EXTEND_SOLVERS["grammar"].run(problem, Budget(), 0).layouts[0]


def test_rows_grow_by_their_folded_strings() -> None:
    problem, layout = grown_by_grammar("terrace")
    pattern = problem.pattern
    grammar = read_grammar(problem, 0)
    unfolded = np.array(layout.how) == "unfolded"
    assert unfolded.mean() > 0.95
    for row in grammar.rows:
        at = to_frames(layout.poses[:, :2], row.frame)
        fronts = at[:, 1] + pattern.boxes[layout.origin, 4] / 2
        mine = np.flatnonzero(unfolded & (np.abs(fronts) < 0.05))
        letters = [pattern.kinds[pattern.kind[layout.origin[k]]].letter for k in mine]
        order = np.argsort(at[mine, 0] * (1 if at[mine, 0].mean() > 0 else -1))
        found = [letters[k] for k in order]
        read = row.elements if at[mine, 0].mean() > 0 else fold(unfold(row.elements)[::-1])
        longer = [s for s in unfold(stretch(read, 60)) if s != PASSAGE]
        assert len(found) > 12
        assert found[:9] == longer[:9]


def test_what_grows_by_the_grammar_overlaps_nothing_and_keeps_groups() -> None:
    problem, layout = grown_by_grammar("court")
    shapes = shapes_at(problem.pattern, layout.poses, layout.origin)
    assert shapely.union_all(shapes).area == pytest.approx(shapely.area(shapes).sum(), abs=0.1)
    assert bool(shapely.covers(problem.outline.buffer(0.01), shapes).all())
    grammar = read_grammar(problem, 0)
    assert len(grammar.grouped) > 0
    assert not set(grammar.others) & {n for held in grammar.grouped.values() for n, _ in held}
    counts = np.bincount(problem.pattern.kind[layout.origin], minlength=len(problem.pattern.kinds))
    assert counts.min() >= 5


def test_a_source_of_scattered_buildings_is_repeated_as_it_stands() -> None:
    rng = np.random.default_rng(3)
    spots = [(0, 0), (30, 22), (61, -3), (5, 44), (40, 60), (70, 41)]
    ring = np.array([[0, 0], [8, 0], [8, 6], [0, 6.0]])
    turns = [
        np.array([[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]]) for t in rng.uniform(0, 3, 6)
    ]
    outlines = [(ring @ turn + at).tolist() for turn, at in zip(turns, spots, strict=True)]
    brief = Brief.model_validate(
        {
            "domain": "extend",
            "sources": [{"buildings": [{"outline": outline} for outline in outlines]}],
            "areas": [{"outline": [[90, -20], [300, -20], [300, 90], [90, 90]]}],
        }
    )
    (problem,) = problems(brief, "grammar")
    assert read_grammar(problem, 0).rows == ()
    layout = EXTEND_SOLVERS["grammar"].run(problem, Budget(), 0).layouts[0]
    made = np.array(layout.how) == "unfolded"
    assert made.sum() >= 8
    shifts = layout.poses[made, :2] - problem.pattern.boxes[layout.origin[made], :2]
    assert len(np.unique(shifts.round(3), axis=0)) < made.sum() / 2
    assert sw.check(sw.solve(brief, preset="grammar")).valid
