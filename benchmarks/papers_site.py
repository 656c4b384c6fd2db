"""The experiments of Zhang and Yang (2023) repeated with simulated raters, and ours beside them.

``scenewright bench papers_site`` takes some minutes, ``--quick`` two scenes and two runs. No panel
of people was at hand: *liked* is what simulated raters (:mod:`.papers_site_raters`) truly think of
a layout, 0 as one by chance and 1 as the best any method found for them in that scene.

1. Liking on scenes of 6, 15, 30, 70 and 120 buildings: the paper's method and TIGA are rated by
   each rater anew, all others are led by F_eva (22).
2. Each of F_eva's aims leading in turn, weight 0.7 against 0.1 of the others, where models are
   chosen of a library: R and H are constants where all that is asked for stands.

Ratings and generations to a common liking: :mod:`.papers_raters`.
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
from benchmarks.papers_raters import run_method
from benchmarks.papers_raters_worlds import site_world
from benchmarks.papers_site_raters import SiteTaste, like, make_taste
from benchmarks.papers_site_tables import markdown_lines
from benchmarks.site_scenes import SIZES, Scene, posed, scene_brief
from scenewright import domains
from scenewright.domains.site.matrix_breeding import SiteMatrix, prepare_matrix
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.genetic import MatrixGenetic, evolve
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
    "benchmarks/papers_raters*.py",
    "benchmarks/site_scenes.py",
    "benchmarks/person_raters.py",
    "src/scenewright/domains/site/**/*.py",
    "src/scenewright/engine/preference/**/*.py",
)
"""What the figures are of: parts measured on other code are not kept."""
NAMES = {"vp": "the paper's, with the rater", "tiga": "TIGA, with the rater"}
RATERS, SEEDS, RATED = 6, 3, 284
"""Simulated raters, seeds of what nobody rates, ratings of a run."""
STEPS, SCENE = 2000, 30
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
    raters, sizes = (2, SIZES[:2]) if quick else (RATERS, SIZES)
    scene, seeds = (15, 1) if quick else (SCENE, SEEDS)
    for size in sizes:
        yield f"{size} buildings", partial(liking_records, size, raters, seeds)
    yield "aims", partial(aim_records, scene, raters, seeds)


def liking_records(size: int, raters: int, seeds: int) -> Iterator[Record]:
    """How much each method's layouts are liked."""
    scene = posed(scene_brief(size))
    problem, world = scene.problems["default"], site_world(size)
    led = {name: [_boxes(run_led(scene, name, seed)) for seed in range(seeds)] for name in LED}
    liked: dict[str, list[float]] = {name: [] for name in ("vp", "tiga", *LED)}
    for number in range(raters):
        taste = make_taste(problem, number)
        told = {name: [like(taste, boxes) for boxes in led[name]] for name in LED}
        for method in NAMES:
            told[method] = [run_method(world, method, True, number, RATED).end()]
        most = max(max(values) for values in told.values())
        for name, values in told.items():
            liked[name].append(statistics.median(values) / most if most > 0.0 else 0.0)
    mine = statistics.median(liked["vp"])
    for name, values in liked.items():
        yield _record(
            f"{size} buildings",
            f"liked, {NAMES.get(name, name)}",
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
    brief = scene_brief(size, library=True)
    matrix = prepare_matrix(brief, domains.plan_of(brief))
    tastes = [make_taste(matrix.problem, number) for number in range(raters)]
    rows = {
        aim: [lead(matrix, number, seed, tastes) for seed in range(seeds)]
        for number, aim in enumerate(AIMS)
    }
    for aim, told in rows.items():
        for metric in (*PARTS, "liked"):
            ours, base = (
                statistics.median(row[metric] for row in one) for one in (told, rows[AIMS[1]])
            )
            case = f"{aim} leads, {size} buildings"
            yield _record(case, metric, "1", ours, base, "M leads", seeds)


def lead(matrix: SiteMatrix, aim: int, seed: int, tastes: list[SiteTaste]) -> dict[str, float]:
    """A run of the repaired algorithm with one aim at 0.7."""
    problem, cells = matrix.problem, matrix.cells
    parents = seed_layouts(problem, cells, problem.settings.matrix.templates, seed)
    quality = problem.buildings.quality
    solver = MatrixGenetic(cells, quality, parents=parents, amount=matrix.amount)
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
