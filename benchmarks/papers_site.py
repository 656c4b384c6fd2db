"""The experiments of Zhang and Yang (2023) repeated with simulated raters, and ours beside them.

``scenewright bench papers_site`` takes some minutes, ``--quick`` two scenes and two runs. No panel
of people was at hand: *liked* is what simulated raters (:mod:`.papers_site_raters`) truly think of
a layout, 0 as one by chance and 1 as the best any method found for them in that scene.

1. Generations and ratings to converge, on thirty buildings, beside the printed ones: a run has
   converged once the best layout so far is within 5 % of what it gains in the end.
2. Liking on scenes of 6, 15, 30, 70 and 120 buildings: the paper's method and TIGA are rated by
   each rater anew, all others are led by F_eva (22).
3. Each of F_eva's aims leading in turn, weight 0.7 against 0.1 of the others.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.comparison import ratio
from benchmarks.kept import open_runs
from benchmarks.papers_site_raters import SiteRater, SiteTaste, like, make_taste
from benchmarks.papers_site_search import Generation, Name, search
from benchmarks.papers_site_tables import markdown_lines
from benchmarks.site_scenes import SIZES, Scene, posed, scene_brief
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.genetic import MatrixGenetic, evolve
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.domains.site.solvers.outcome import SiteFound
from scenewright.domains.site.solvers.seed_layouts import seed_layouts
from scenewright.engine.solve import Budget

__all__ = ["markdown_lines", "records"]

Record = dict[str, Any]
Floats = NDArray[np.float64]
Progress = Callable[[float, str], None]
Part = Callable[[], Iterator[Record]]
CODE = (
    "benchmarks/papers_site*.py",
    "benchmarks/site_scenes.py",
    "benchmarks/person_raters.py",
    "src/scenewright/domains/site/**/*.py",
    "src/scenewright/engine/preference/alleles/*.py",
)
"""What the figures are of: parts measured on other code are not kept."""
PRINTED: dict[Name, tuple[float | None, float | None]] = {
    "vp": (46.5, 195.8),
    "tiga": (63.8, 283.5),
    "sga": (89.4, None),
}
"""Generations to converge and layouts rated, means of ten runs."""
NAMES = {"vp": "the paper's, with the rater", "tiga": "TIGA, with the rater", "sga": "SGA"}
RUNS, RATERS, SEEDS = 10, 6, 3
MOST, MOST_RATINGS = 100, 600
"""Generations and ratings of a run to converge."""
RATED, BRED = 284, 60
"""Ratings and generations where methods are compared."""
STEPS, WITHIN, SCENE = 2000, 0.05, 30
LED = ("fill", "paper", "sga", "sa", "pso", "random")
"""What is led by F_eva: ours, the paper's preset as printed without the person, and the others."""
AIMS = ("R, use of space", "M, visual quality", "C, texture", "H, height")
PARTS = ("use", "shown", "texture", "height", "seen")


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """All records, part by part; parts that are kept are not run again."""
    kept, parts = open_runs("papers_site", CODE), list(list_parts(quick))
    for k, (told, make) in enumerate(parts):
        if progress:
            progress(k / len(parts), told)
        yield from kept.have(f"{told}{', quick' if quick else ''}", partial(_list_records, make))


def _list_records(make: Part) -> list[Record]:
    return list(make())


def list_parts(quick: bool) -> Iterator[tuple[str, Part]]:
    """What is measured, in words, and how."""
    runs, raters, sizes = (2, 2, SIZES[:2]) if quick else (RUNS, RATERS, SIZES)
    scene, seeds = (15, 1) if quick else (SCENE, SEEDS)
    for name in PRINTED:
        yield f"to converge: {name}", partial(convergence_records, name, runs, scene)
    for size in sizes:
        yield f"{size} buildings", partial(liking_records, size, raters, seeds)
    yield "aims", partial(aim_records, scene, raters, seeds)


def convergence_records(name: Name, runs: int, size: int) -> Iterator[Record]:
    """Generations, ratings and layouts searched until a run has converged: means."""
    problem = posed(scene_brief(size)).problems["default"]
    ended = [
        converged(search(problem, name, SiteRater(problem, run), run, MOST, MOST_RATINGS))
        for run in range(runs)
    ]
    printed = dict(zip(("generations", "ratings"), PRINTED[name], strict=True))
    for number, metric in enumerate(("generations", "ratings", "layouts searched")):
        mean = statistics.fmean(row[number] for row in ended)
        if name != "sga" or metric != "ratings":
            yield _record(
                f"to converge, {size} buildings",
                f"{metric}, {NAMES[name]}",
                "1",
                mean,
                printed.get(metric),
                "the paper",
                runs,
            )


def converged(run: list[Generation]) -> tuple[int, int, int]:
    """The first generation that is within 5 % of what a run gains, its ratings and layouts.

    >>> none = np.zeros((0, 5))
    >>> steps = [Generation(10 * k, 5 * k, best, none) for k, best in enumerate((0.0, 0.7, 1.0), 1)]
    >>> converged(steps)
    (3, 15, 30)
    """
    first, last = run[0].best, run[-1].best
    bar = last - WITHIN * (last - first)
    number = next(k for k, one in enumerate(run) if one.best >= bar)
    return number + 1, run[number].ratings, run[number].searched


def liking_records(size: int, raters: int, seeds: int) -> Iterator[Record]:
    """How much each method's layouts are liked."""
    scene = posed(scene_brief(size))
    problem = scene.problems["default"]
    led = {name: [_boxes(run_led(scene, name, seed)) for seed in range(seeds)] for name in LED}
    liked: dict[str, list[float]] = {name: [] for name in ("vp", "tiga", *LED)}
    for number in range(raters):
        taste = make_taste(problem, number)
        told = {name: [like(taste, boxes) for boxes in led[name]] for name in LED}
        asked: tuple[Name, Name] = ("vp", "tiga")
        for method in asked:
            run = search(problem, method, SiteRater(problem, number), number, BRED, RATED)
            told[method] = [like(taste, run[-1].champion)]
        most = max(max(values) for values in told.values())
        for name, values in told.items():
            liked[name].append(statistics.median(values) / most if most > 0.0 else 0.0)
    mine = statistics.median(liked["vp"])
    for name, values in liked.items():
        yield _record(
            f"{size} buildings",
            f"liked, {NAMES.get(name, name) if name in ('vp', 'tiga') else name}",
            "1",
            statistics.median(values),
            mine,
            "the paper's, with the rater",
            raters,
        )


def run_led(scene: Scene, name: str, seed: int) -> SiteFound:
    """A layout by a method that F_eva leads; our default looks at as many as it usually does."""
    if name in PRESETS:
        chosen = PRESETS[name]
        return SITE_SOLVERS[chosen.solver].run(scene.problems[name], Budget(None, STEPS), seed)
    budget = Budget(None, None if name == "fill" else STEPS)
    return SITE_SOLVERS[name].run(scene.problems["default"], budget, seed)


def _boxes(found: SiteFound) -> Floats:
    """Boxes (n, 5) of a layout, of no width where nothing stands."""
    layout = found.layouts[0]
    return np.where(layout.present[:, None], layout.boxes, 0.0)


def aim_records(size: int, raters: int, seeds: int) -> Iterator[Record]:
    """The paper's algorithm with each aim leading: the parts of F_eva, and liking."""
    problem = posed(scene_brief(size)).problems["default"]
    tastes = [make_taste(problem, number) for number in range(raters)]
    rows = {
        aim: [lead(problem, number, seed, tastes) for seed in range(seeds)]
        for number, aim in enumerate(AIMS)
    }
    for aim, told in rows.items():
        for metric in (*PARTS, "liked"):
            ours, base = (
                statistics.median(row[metric] for row in one) for one in (told, rows[AIMS[1]])
            )
            case = f"{aim} leads, {size} buildings"
            yield _record(case, metric, "1", ours, base, "M leads", seeds)


def lead(problem: SiteProblem, aim: int, seed: int, tastes: list[SiteTaste]) -> dict[str, float]:
    """A run of the repaired algorithm with one aim at 0.7."""
    cells = make_cells(problem)
    parents = seed_layouts(problem, cells, problem.settings.matrix.templates, seed)
    solver = MatrixGenetic(cells, problem.buildings.quality, parents=parents)
    weights = tuple(0.7 if k == aim else 0.1 for k in range(4))
    judge = make_judge(problem, cells)._replace(omega=weights)
    found = evolve(problem, solver, judge, Budget(None, STEPS), seed, None, None)
    told = score(problem, found.layouts[0].boxes, found.layouts[0].present)
    boxes = _boxes(found)
    liked = statistics.median(like(taste, boxes) for taste in tastes)
    return {name: told[name] for name in PARTS} | {"liked": liked}


def _record(
    case: str, metric: str, unit: str, ours: float, base: float | None, name: str, runs: int
) -> Record:
    return Record(
        case=case,
        metric=metric,
        unit=unit,
        ours=round(ours, 3),
        baseline=None if base is None else round(base, 3),
        baseline_name=name,
        ratio=ratio(ours, base, unit),
        runs=runs,
    )
