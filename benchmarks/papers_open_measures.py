"""What comes of a paper's method when one thing that it leaves open is chosen otherwise.

Each function runs a method once, on a small instance and by a seed, and gives one figure, measured
as the preset ``paper`` has it whatever was chosen.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

import scenewright as sw
from benchmarks.hall_measure import posed as pose_hall
from benchmarks.papers_home_readings import AS_RUN, LIVING, genetic
from benchmarks.papers_home_rooms import case_of
from benchmarks.papers_site_raters import SiteRater
from benchmarks.site_scenes import Scene, scene_brief
from benchmarks.site_scenes import posed as pose_site
from scenewright.domains import problems
from scenewright.domains.extend.printed import PlotGrid
from scenewright.domains.extend.solvers.ants import run_ants
from scenewright.domains.extend.solvers.colony import ColonySettings
from scenewright.domains.extend.solvers.paper import WEIGHTS, grid_of
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.solvers.printed_metropolis import run_printed
from scenewright.domains.hall.terms.state import PreparedHall
from scenewright.domains.site.encodings.cells import KIND, PART
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.genetic import MatrixGenetic
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.domains.village.paper.filling import fill_as_paper
from scenewright.domains.village.paper.nets_file import shipped_nets
from scenewright.engine.clustering.agreement import adjusted_mutual_information
from scenewright.engine.clustering.resonance import ResonanceSettings, fuzzy_art
from scenewright.engine.draws import streams
from scenewright.engine.preference.alleles.art1 import (
    Art1Settings,
    begin_network,
    learn_ratings,
    measure_rmse,
    present,
    rate_pattern,
)
from scenewright.engine.preference.interactive.estimates import MIDDLE, mark_alleles
from scenewright.engine.solve import Budget

Floats = NDArray[np.float64]
BUILT_BY = ("scenewright.domains.extend.build_problem", "scenewright.domains.village.solving")
"""What domains are asked for by their contract."""
EVALUATIONS, SITE_STEPS, MOVES, ITERATIONS = 600, 1000, 60_000, 1000
"""Matrices that ants build, layouts bred and moves annealed on a site, iterations in a hall."""
RATED, TESTED, BLOBS = 40, 20, 6


@contextmanager
def constant(place: str, value: Any) -> Iterator[None]:
    """In the block the constant ``module:NAME`` of plain code has another value."""
    name, _, word = place.partition(":")
    module = import_module(name)
    before = getattr(module, word)
    setattr(module, word, value)
    try:
        yield
    finally:
        setattr(module, word, before)


@cache
def _site() -> Scene:
    return pose_site(scene_brief(15))


def breed_site(delta: float, seed: int) -> float:
    """F_eva (22) of the best layout, by δ of (12)."""
    problem = _site().problems["paper"]
    matrix = problem.settings.matrix._replace(alike=delta)
    return _value_of(
        "vp", problem._replace(settings=problem.settings._replace(matrix=matrix)), seed
    )


def anneal_site(most: float, seed: int) -> float:
    """F_eva (22) of what annealing by f_cost (6) lets stand, by E_max."""
    problem = _site().problems["paper"]
    chain = problem.settings.chain._replace(most=most)
    return _value_of("sa", problem._replace(settings=problem.settings._replace(chain=chain)), seed)


def _value_of(solver: str, problem: Any, seed: int) -> float:
    steps = SITE_STEPS if solver == "vp" else MOVES
    found = SITE_SOLVERS[solver].run(problem, Budget(steps=steps), seed).layouts[0]
    return float(score(_site().problems["default"], found.boxes, found.present)["value"])


def try_network(vigilance: float, rate: float, seed: int) -> float:
    """σ (24) of an ART1 network on stars of a simulated rater it did not learn from."""
    problem = _site().problems["default"]
    cells, rng = make_cells(problem), np.random.default_rng(seed)
    judge, rater = make_judge(problem, cells), SiteRater(problem, seed)
    solver = MatrixGenetic(cells, problem.buildings.quality, mutation=0.5, local=False)
    width = np.zeros(cells.fits.shape[2] * 3)
    state, rows, given = solver.init(rng, width, width), [], list[float]()
    while len(given) < RATED + TESTED:
        genes, state = solver.ask(state, rng)
        told = rater.rate(judge.boxes(genes))
        state = solver.tell(state, genes, -told)
        whole = genes.reshape(len(genes), -1, 3).astype(np.int64)
        rows.append(np.where(whole[:, :, PART] == 0, whole[:, :, KIND], 0))
        given += told.tolist()
    stars, settings = np.array(given), Art1Settings(vigilance, rate)
    bits = mark_alleles(np.concatenate(rows), len(cells.counts()))
    network = learn_ratings(bits[:RATED], stars[:RATED], settings)
    guessed = [rate_pattern(network, row, MIDDLE, settings) for row in bits[RATED:]]
    return measure_rmse(stars[RATED:], np.array(guessed))


@cache
def _plots() -> PlotGrid:
    return grid_of(problems(sw.read("sample:extend-terrace"))[0])


def walk_plots(chosen: dict[str, float], seed: int) -> float:
    """F (22) of the best matrix that ants build, by settings of the colony."""
    settings = ColonySettings()._replace(**chosen)  # type: ignore[arg-type]
    rng = np.random.default_rng(seed)
    return run_ants(_plots(), WEIGHTS, EVALUATIONS, rng, settings).value


def sort_blobs(form: str, vigilance: float, seed: int) -> float:
    """AMI of the classes that ART makes of six blobs with the true ones, by its form."""
    rng = np.random.default_rng(seed)
    known = np.repeat(np.arange(BLOBS), 10)
    vectors = rng.normal(size=(BLOBS, 8))[known] * 3 + 0.3 * rng.normal(size=(len(known), 8))
    order = rng.permutation(len(known))
    if form == "products":
        found = _sort_by_products(vectors[order], Art1Settings(vigilance, 0.8))
    else:
        settings = ResonanceSettings(vigilance, complements=form == "minima, complements")
        found = fuzzy_art(vectors[order], settings)
    return adjusted_mutual_information(found, known[order])


def _sort_by_products(vectors: Floats, settings: Art1Settings) -> NDArray[np.int64]:
    low, high = vectors.min(0), vectors.max(0)
    network, found = begin_network(vectors.shape[1]), []
    for row in (vectors - low) / np.maximum(high - low, 1e-12):
        network, category = present(network, row, 0.0, settings)
        found.append(category)
    return np.array(found)


@cache
def _hall(kappa: float = 0.1) -> Fitted:
    with constant("scenewright.domains.hall.zoning.assign:KAPPA", kappa):
        return pose_hall(sw.read("sample:hall-shop"), 0, printed=True).fitted


def lay_hall(chosen: dict[str, float], seed: int) -> float:
    """The four printed energies of the answer of GD-MH, by what is chosen:
    κ, δ_min as a share, Z, or a setting of the chain."""
    fitted = _hall(chosen.get("kappa", 0.1))
    problem = fitted.problem
    usual = problem.settings.guided
    more: dict[str, Any] = {name: v for name, v in chosen.items() if name in usual._fields}
    guided = usual._replace(**more)
    chain = begin_chain(problem, fitted.start, streams(seed, 1)[0])
    p = _prepare(chain.p, chosen)
    schedule = np.array([guided.rate, guided.rate, float(ITERATIONS), 0.0])
    run_printed(
        p,
        *chain[2:4],
        chain.grid,
        chain.bits,
        chain.inset,
        chain.stream,
        chain.tally,
        schedule,
        guided,
        np.zeros(len(p.spans), np.int64),
        0,
        ITERATIONS,
        chain.last,
        chain.best,
    )
    return float(begin_chain(problem, chain.best, streams(0, 1)[0]).tally[0])


def _prepare(p: PreparedHall, chosen: dict[str, float]) -> PreparedHall:
    """δ_min is that of 0.75 stretched; Z is in μ_max = ι + ι′ + 1 m, so half of the difference is
    added to each ι."""
    least = p.least * chosen.get("least", 0.75) / 0.75
    return p._replace(least=least, iota=p.iota + (chosen.get("z", 1.0) - 1.0) / 2.0)


def breed_room(changed: dict[str, Any], seed: int) -> float:
    """The printed cost of the genetic algorithm's best layout of a living room, by reading."""
    return genetic(case_of(LIVING[0]).problem, AS_RUN._replace(**changed), seed)


@cache
def _village() -> tuple[Any, Any]:
    return shipped_nets(), problems(sw.read("sample:village-hamlet"))[0]


def fill_block(name: str, value: float, seed: int) -> float:
    """Houses on a block that is filled until *continue* says no, by a constant of the loop."""
    nets, problem = _village()
    with constant(f"scenewright.domains.village.paper.filling:{name}", value):
        free = problem._replace(asked=None, coverage=None)
        return float(len(fill_as_paper(nets, free, np.random.default_rng(seed)).houses))
