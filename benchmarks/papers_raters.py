"""The interactive genetic algorithms of two papers to a common liking: ``bench papers_raters``.

Ten **simulated** raters with tastes of their own (:mod:`.papers_raters_worlds`) rate a site of
thirty buildings by the methods of Zhang and Yang (2023), and the plots of an extension by those of
Zhang and Fei (2017), as ``evolve --method`` runs them, until each has given 150 ratings
(``--full``: as many as the papers tell of, 284, and 30 generations of eight). Told are ratings and
generations until the best layout shown is liked as much as

* the *common level*: what every method reaches with this rater;
* the *usual method's end*: what TIGA (sites) or SIGA (extensions) has shown in the end;

and how much the best rated is liked in the end. A method begins by its own first layouts, and from
the same random ones as all others. The network of ``vp`` rates 3 generations in its first stage and
10 in its second (``alone``); as printed the second goes on to the end. ``taste`` is ours: of 48
children those few are rated that a taste learned from the stars likes best. Intervals are of 95 %,
by Student's t over raters; what differs from the usual method by less is *not told apart*.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from benchmarks.comparison import ratio
from benchmarks.kept import open_runs
from benchmarks.papers_raters_tables import markdown_lines, page_lines
from benchmarks.papers_raters_worlds import RatedWorld, Rater, plots_world, site_world
from benchmarks.spread import Progress
from scenewright.core.breeding import Genome, MatrixBreeder
from scenewright.engine.preference.events import Stars
from scenewright.engine.preference.interactive.crowd import CrowdRun, begin_crowd, hear_sheet
from scenewright.engine.preference.interactive.methods import InteractiveMethod, method_named
from scenewright.engine.preference.taste import judge, learn_taste

__all__ = ["markdown_lines", "page_lines", "records"]

Record = dict[str, Any]
RATERS, QUICK, USUAL = 10, 2, 150
CHILDREN, FEW, PARENTS = 48, 3, 4
"""Children that a taste chooses from, those it has rated, and the parents of the next."""
STUDENT = {2: 12.706, 10: 2.262}
"""Half of a 95 % interval in standard errors, by the number of raters."""
CODE = (
    "benchmarks/papers_raters*.py",
    "benchmarks/papers_site_raters.py",
    "benchmarks/person_raters.py",
    "benchmarks/site_scenes.py",
    "src/scenewright/engine/preference/**/*.py",
    "src/scenewright/domains/site/**/*.py",
    "src/scenewright/domains/extend/**/*.py",
)
"""What the runs are of: those of other code are not kept."""
VP = method_named("vp")
METHODS = {name: method_named(name) for name in ("vp", "tiga", "ciga", "siga", "sga")} | {
    "vp, network to the end": VP._replace(alone=10**6)
}
OURS = "taste"


class Compared(NamedTuple):
    """A comparison: where, by which methods, the ``usual`` one first, and ratings of a run."""

    name: str
    world: Callable[[], RatedWorld]
    methods: tuple[str, ...]
    ratings: int


def list_compared(quick: bool, full: bool = False) -> tuple[Compared, ...]:
    """The site and the extension."""
    size, area = 15 if quick else 30, "extend-terrace"
    of_site = ("tiga", "vp", "vp, network to the end", "sga")
    of_area = ("siga", "ciga", "sga", OURS)
    return (
        Compared(
            f"site of {size}",
            partial(site_world, size),
            of_site,
            60 if quick else 284 if full else USUAL,
        ),
        Compared(
            area, partial(plots_world, area), of_area, 48 if quick else 240 if full else USUAL
        ),
    )


class RatedRun(NamedTuple):
    """What was rated, in order: how much each layout is truly liked, its stars, the generation it
    was shown in, from 1, and the generations a network had rated until then."""

    liked: tuple[float, ...]
    stars: tuple[float, ...]
    ages: tuple[int, ...]
    alone: tuple[int, ...]

    def reach(self, level: float) -> int | None:
        """Ratings until a layout liked so much has been shown; none if there is none.

        >>> RatedRun((0.0, 2.0, 1.0), (3, 4, 3), (1, 1, 2), (0, 0, 0)).reach(1.5)
        2
        """
        there = [k for k, one in enumerate(self.liked, 1) if one >= level - 1e-9]
        return there[0] if there else None

    def end(self) -> float:
        """How much the best rated is liked, of several the last."""
        best = max(self.stars)
        return [one for one, given in zip(self.liked, self.stars, strict=True) if given == best][-1]


def run_method(world: RatedWorld, name: str, led: bool, seed: int, ratings: int) -> RatedRun:
    """One rater by number and one method, from its own first layouts (``led``) or random ones."""
    rater, matrix = world.rater(seed), world.matrix(seed)
    if name == OURS:
        return _run_taste(world, rater, matrix, seed, ratings)
    method = METHODS[name]
    return run_crowd(rater, method if led else method._replace(led=False), matrix, seed, ratings)


def run_crowd(
    rater: Rater, method: InteractiveMethod, matrix: MatrixBreeder, seed: int, ratings: int
) -> RatedRun:
    """A run of a shipped method."""
    run, rows = CrowdRun(method, matrix, seed), list[tuple[float, float, int, int]]()
    crowd = begin_crowd(run)
    while len(rows) < ratings:
        asked = crowd.asked[: ratings - len(rows)]
        stars = rater.rate(asked).tolist()
        rows += [
            (rater.truth(one), given, crowd.age + 1, crowd.alone)
            for one, given in zip(asked, stars, strict=True)
        ]
        crowd = hear_sheet(run, crowd, dict(zip(asked, stars, strict=True)))
    return RatedRun(*zip(*rows, strict=True))


def _run_taste(
    world: RatedWorld, rater: Rater, matrix: MatrixBreeder, seed: int, ratings: int
) -> RatedRun:
    rng = np.random.default_rng([seed, 7, 0])
    asked, rows = matrix.draw(matrix.population, False, rng), list[tuple[float, float, int, int]]()
    known: dict[Genome, Stars] = {}
    while len(rows) < ratings:
        asked, age = asked[: ratings - len(rows)], rows[-1][2] + 1 if rows else 1
        for one, given in zip(asked, rater.rate(asked).tolist(), strict=True):
            rows.append((rater.truth(one), given, age, 0))
            known[one] = Stars(len(known), round(given), age)
        asked = _choose_by_taste(world, matrix, known, rng)
    return RatedRun(*zip(*rows, strict=True))


def _choose_by_taste(
    world: RatedWorld, matrix: MatrixBreeder, known: dict[Genome, Stars], rng: np.random.Generator
) -> list[Genome]:
    """The children that the taste of what was rated likes best, of parents it likes best."""
    assert world.look is not None
    assert world.scale is not None
    values = {event.candidate: world.look(one) for one, event in known.items()}
    taste = learn_taste(world.scale, list(known.values()), values, {})

    def rank(some: Sequence[Genome]) -> list[Genome]:
        mean = judge(taste, np.array([world.look(one) for one in some])).mean  # type: ignore[misc]
        return [some[k] for k in np.argsort(-mean, kind="stable").tolist()]

    parents, children = rank(list(known))[:PARENTS], dict[Genome, None]()
    while len(children) < CHILDREN:
        one, other = (parents[k] for k in rng.integers(len(parents), size=2).tolist())
        child = matrix.cross(one, other, 2, rng)[0] if rng.random() < matrix.crossover else one
        child = matrix.mutate(child, rng, None)
        if child not in known:
            children[child] = None
    return rank(list(children))[:FEW]


def records(
    quick: bool = False, progress: Progress | None = None, full: bool = False
) -> Iterator[Record]:
    """All records; runs once done are kept."""
    raters, kept = QUICK if quick else RATERS, open_runs("papers_raters", CODE)
    for compared in list_compared(quick, full):
        world, runs = compared.world(), dict[tuple[str, bool], list[RatedRun]]()
        jobs = [(name, led) for name in compared.methods for led in starts_of(name)]
        for number, (name, led) in enumerate(jobs):
            if progress:
                progress(number / len(jobs), f"{compared.name}: {name}")
            for seed in range(raters):
                told = f"{compared.name}, {name}, {led}, {seed}, {compared.ratings}"
                make = partial(run_method, world, name, led, seed, compared.ratings)
                runs.setdefault((name, led), []).append(RatedRun(*kept.have(told, make)))
        for led in (True, False):
            rows = {n: runs.get((n, led)) or runs[n, False] for n in compared.methods}
            yield from compare_runs(f"{compared.name}, {START[led]}", rows, compared.methods[0])


START = {True: "own first layouts", False: "the same random first layouts"}


def starts_of(name: str) -> tuple[bool, ...]:
    """Whether a method has first layouts of its own beside random ones."""
    return (True, False) if name in METHODS and METHODS[name].led else (False,)


def compare_runs(case: str, runs: dict[str, list[RatedRun]], usual: str) -> Iterator[Record]:
    """The figures of every method over raters, beside the usual one."""
    levels = list(zip(*([max(one.liked) for one in rows] for rows in runs.values()), strict=True))
    ends = [max(one.liked) for one in runs[usual]]
    told = {name: figures_of(rows, [min(r) for r in levels], ends) for name, rows in runs.items()}
    for name, figures in told.items():
        for metric, values in figures.items():
            yield _record(case, f"{metric}, {name}", values, told[usual][metric], usual)


def figures_of(
    runs: Sequence[RatedRun], common: Sequence[float], ends: Sequence[float]
) -> dict[str, list[float]]:
    """What is told of each run. One that never reaches a level counts with all its ratings."""
    found: dict[str, list[float]] = {}
    for run, level, end in zip(runs, common, ends, strict=True):
        first, last = run.reach(level), run.reach(end)
        place, whole = (first or len(run.liked)) - 1, (last or len(run.liked)) - 1
        row = {
            "ratings to the common level": place + 1,
            "generations to the common level": run.ages[place],
            "ratings to the usual method's end": whole + 1,
            "generations to the usual method's end": run.ages[whole],
            "reached the usual method's end": float(last is not None),
            "liked in the end": run.end(),
            "generations rated by the network": run.alone[-1],
            "generations in all": run.ages[-1],
        }
        for metric, value in row.items():
            found.setdefault(metric, []).append(float(value))
    return found


def spread_of(values: Sequence[float]) -> float:
    """Half of the 95 % interval of a mean.

    >>> spread_of([1.0] * 10)
    0.0
    """
    return STUDENT[len(values)] * statistics.stdev(values) / len(values) ** 0.5


def _record(case: str, metric: str, ours: list[float], base: list[float], usual: str) -> Record:
    apart = [a - b for a, b in zip(ours, base, strict=True)]
    mean, other = statistics.fmean(ours), statistics.fmean(base)
    return Record(
        case=f"{case}, simulated raters",
        metric=metric,
        unit="1",
        ours=round(mean, 3),
        baseline=round(other, 3),
        baseline_name=usual,
        ratio=ratio(mean, other, "1"),
        runs=len(ours),
        half=round(spread_of(ours), 3),
        told_apart=abs(statistics.fmean(apart)) > spread_of(apart),
    )
