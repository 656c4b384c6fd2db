"""Sites: groups of buildings on ground between streets, around landmarks that stand.

After Zhang, Yang 2023: buildings of a library fill the ground in planar forms; ours fills block
by block with rows and courts that keep their distances by construction.
"""

from __future__ import annotations

import hashlib
import math
import time
from collections import Counter
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from scenewright._version import __version__
from scenewright.catalog.appearance import facts
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.layout import REPAIR, ROUTES, SETTLED, NamedBox, Watch, name_rows
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution, TermValue
from scenewright.domains.site.access import find_reached_buildings
from scenewright.domains.site.amounts import find_target
from scenewright.domains.site.brief import Site
from scenewright.domains.site.build_problem import Looks, build_problem
from scenewright.domains.site.doors import ServedLayout, serve_doors
from scenewright.domains.site.furnish import buildings, landmark_assets, landmarks
from scenewright.domains.site.given import fixed_buildings
from scenewright.domains.site.holdings import BuildingDemand, collect_buildings
from scenewright.domains.site.paving import list_missing_areas
from scenewright.domains.site.plan import plans_of
from scenewright.domains.site.planting import green
from scenewright.domains.site.presets import PRESETS, SitePreset
from scenewright.domains.site.problem import Flags, SiteProblem
from scenewright.domains.site.reasons import reasons
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solvers.answer import answer
from scenewright.domains.site.solvers.chosen import fill_chosen
from scenewright.domains.site.solvers.outcome import SiteFound, SiteLayout
from scenewright.domains.site.sunlight import solve_in_sun
from scenewright.domains.site.variants import Variant, vary
from scenewright.domains.site.works import gather_works, lay_works
from scenewright.engine.rows import preset_named
from scenewright.engine.solve import Budget, Report
from scenewright.engine.trace import Hear, hear_in
from scenewright.engine.watched import add_watch, show
from scenewright.ground.plan import SitePlan
from scenewright.ground.works import GroundWorks

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]
Show = Callable[[SiteLayout, str, str], None]
"""Shows a layout to who watches, with its stage and what changed it."""

__all__ = ["PRESETS", "problems", "solve"]

CHOOSING = ("vp", "sga")
"""Solvers that choose models of a library while solving."""
BESIDE = 3.0
"""Metres between buildings where walks between them lead to doors: tried where the least distance
asked for leaves doors without one."""
AS_ASKED = Variant()
BEGUN = Report(0.0, math.inf, tuple)
"""The report before any layout is found."""


class Built(NamedTuple):
    """One site built on."""

    site: str
    pieces: tuple[Piece, ...]
    terms: tuple[TermValue, ...]
    left_out: tuple[LeftOut, ...]
    evaluations: int
    works: GroundWorks


def solve(
    brief: Brief,
    *,
    plan: Plan | None = None,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    watch: Watch | None = None,
    variant: Variant = AS_ASKED,
    hear: Hear | None = None,
) -> Solution:
    """Place the buildings of every site of a brief.

    ``steps`` are layouts looked at (of each block, by the default solver); the same seed and
    steps give the same answer. ``plan`` is that of the brief (made unless given). ``progress``
    gets the share done, ``watch`` the best layout of each site; when ``cancel`` answers true, what
    was found so far is returned. ``hear`` gets the steps of a traced solver.
    """
    started = time.perf_counter()
    chosen, catalog = preset_named(PRESETS, preset), catalog_of(brief.catalogs)
    named = solver or chosen.solver
    budget = Budget(seconds, steps, threads=threads, hear=hear)
    found = []
    grounds = plan.detail if plan else plans_of(brief)
    for number, (site, ground) in enumerate(zip(brief.part.sites, grounds, strict=True)):
        place = f"sites[{number}]"
        on_progress = (
            None if progress is None else _part(progress, number, len(grounds), ground.name)
        )
        rng_seed = seed + 7919 * number
        found.append(
            _build(
                site,
                ground,
                place,
                catalog,
                chosen,
                named,
                budget,
                rng_seed,
                on_progress,
                cancel,
                watch,
                variant,
            )
        )
    return assemble_solution(brief, found, preset, named, seed, time.perf_counter() - started)


def assemble_solution(
    brief: Brief, found: list[Built], preset: str, solver: str, seed: int, seconds: float
) -> Solution:
    """The solution of all sites of a brief."""
    return Solution(
        brief=brief,
        pieces=tuple(piece for one in found for piece in one.pieces),
        patches=(),
        terms=tuple(term for one in found for term in one.terms),
        left_out=tuple(out for one in found for out in one.left_out),
        energies={one.site: sum(term.cost for term in one.terms) for one in found},
        preset=preset,
        solver=solver,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=seconds,
        evaluations=sum(one.evaluations for one in found),
        detail=tuple(one.works for one in found),
    )


def _part(progress: Progress, number: int, count: int, name: str) -> Callable[[Report], None]:
    return lambda report: progress((number + report.share) / count, name)


def _build(
    site: Site,
    plan: SitePlan,
    place: str,
    catalog: Catalog,
    preset: SitePreset,
    solver: str,
    budget: Budget,
    seed: int,
    progress: Callable[[Report], None] | None,
    cancel: Cancel | None,
    watch: Watch | None,
    variant: Variant,
) -> Built:
    choose = bool(site.library) and solver in CHOOSING
    rows, problem = build_site_problem(site, plan, place, catalog, preset, progress, choose)
    problem = vary(problem, variant)
    budget = budget._replace(hear=hear_in(budget.hear, plan.id))
    if budget.steps is None and budget.seconds is None and solver == preset.solver:
        budget = budget._replace(steps=preset.steps)
    on_progress = add_watch(progress, watch, plan.id, partial(_building_rows, rows))

    def run(posed: SiteProblem) -> SiteFound:
        if variant.choice is not None:
            return fill_chosen(posed, variant.choice)
        if variant.boxes is not None:
            return answer(posed, variant.boxes, 1, 0)
        found: SiteFound = SITE_SOLVERS[solver].run(posed, budget, seed, on_progress, cancel)
        return found

    def picture(layout: SiteLayout, stage: str, reason: str = "") -> None:
        show(watch, plan.id, lambda: _building_rows(rows, layout), stage, reason)

    found, served, lost = _run_served(site, plan, problem, run, picture)
    again = lost and problem.spacing < BESIDE and budget.seconds is None
    if again and variant.choice is None and variant.boxes is None:
        wider = _run_served(site, plan, problem._replace(spacing=BESIDE), run, picture)
        if wider[1].layout.present.sum() > served.layout.present.sum():
            found, served, lost = wider
    picture(served.layout, SETTLED)
    found = found._replace(layouts=(served.layout,))
    works = gather_works(site, plan, served.network.pathways, served.footprints)
    built = furnish_site(site, plan, rows, problem, found, catalog, seed, works)
    if choose:
        left_out = _find_shortfall(plan, problem, served.layout)
    else:
        left_out = _left_out(plan, rows, served.layout.present, lost)
    return built._replace(left_out=(*left_out, *_find_missing(site, plan)))


def _run_served(
    site: Site,
    plan: SitePlan,
    problem: SiteProblem,
    run: Callable[[SiteProblem], SiteFound],
    picture: Show,
) -> tuple[SiteFound, ServedLayout, dict[int, str]]:
    """What is found, the part of it that ways lead to, and why the rest of it is left out, by
    the number of each building; what changes it after the search is shown by ``picture``."""
    if site.sun_required:
        found, dark = solve_in_sun(run, problem, site.sun_hours)
    else:
        found, dark = run(problem), {}
    layout, lost = _reached_only(site, plan, problem, found.layouts[0])
    served = serve_doors(site, plan, problem, layout, fixed_buildings(plan))
    if dark:
        picture(found.layouts[0], REPAIR, f"without {len(dark)} that lack sun")
    if lost or served.lost:
        told = f"without {len(lost) + len(served.lost)} that no way leads to"
        picture(served.layout, ROUTES, told)
    elif not np.array_equal(layout.boxes, served.layout.boxes):
        picture(served.layout, ROUTES, "fronts look at the ways to them")
    return found, served, dark | lost | served.lost


def _building_rows(rows: list[BuildingDemand], layout: SiteLayout) -> tuple[NamedBox, ...]:
    """The buildings of a layout that have a place, by name."""
    here = np.flatnonzero(layout.present)
    return name_rows([rows[k].name for k in here], layout.boxes[here])


def furnish_site(
    site: Site,
    plan: SitePlan,
    rows: list[BuildingDemand],
    problem: SiteProblem,
    found: SiteFound,
    catalog: Catalog,
    seed: int,
    works: GroundWorks | None = None,
) -> Built:
    """A site as built: its pieces, terms, and what was left out; ``works`` are the ways to the
    buildings (laid out unless given)."""
    standing = (*landmarks(plan, catalog), *fixed_buildings(plan))
    layout = found.layouts[0]
    placed = buildings(plan, rows, layout.boxes, layout.present)
    works = works or lay_works(site, plan, (*standing, *placed))
    grown = green(plan, works, (*standing, *placed), catalog, np.random.default_rng(seed))
    return Built(
        plan.id,
        (*standing, *placed, *grown),
        reasons(problem, layout, plan.id),
        _left_out(plan, rows, layout.present, {}),
        found.evaluations,
        works,
    )


def problems(
    brief: Brief, preset: str = "default", *, plan: Plan | None = None
) -> tuple[SiteProblem, ...]:
    """The sites of a brief as problems, for solvers of :data:`SITE_SOLVERS` run by oneself."""
    catalog = catalog_of(brief.catalogs)
    grounds = plan.detail if plan else plans_of(brief)
    return tuple(
        build_site_problem(site, ground, f"sites[{number}]", catalog, PRESETS[preset], None)[1]
        for number, (site, ground) in enumerate(zip(brief.part.sites, grounds, strict=True))
    )


def build_site_problem(
    site: Site,
    plan: SitePlan,
    place: str,
    catalog: Catalog,
    preset: SitePreset,
    progress: Callable[[Report], None] | None,
    choose: bool = False,
) -> tuple[list[BuildingDemand], SiteProblem]:
    """What a site is to hold, one row a building, and the problem of placing it; candidates to
    ``choose`` from where it states a library."""
    rows = collect_buildings(site, plan, place, catalog, choose)
    looks = _looks(plan, rows, catalog, preset, progress)
    problem, settings = build_problem(site, plan, rows, preset.weights, looks), preset.settings
    problem = problem._replace(form=settings.form, settings=settings)
    if choose:
        cover, floor = find_target(site, plan)
        mean = float(np.mean([row.floors for row in rows])) if rows else 1.0
        problem = problem._replace(target=(cover, min(floor, cover * mean)))
    return rows, problem


def _looks(
    plan: SitePlan,
    rows: list[BuildingDemand],
    catalog: Catalog,
    preset: SitePreset,
    progress: Callable[[Report], None] | None,
) -> Looks:
    """How all models of a site look."""
    stay = (catalog.assets[row.model] for row in plan.fixed)
    marks = (*landmark_assets(plan, catalog), *stay)
    on_progress = None if progress is None else lambda _share, _name: progress(BEGUN)
    found = facts([*(row.asset for row in rows), *(mark for mark in marks if mark)], on_progress)
    return Looks(found, tuple(mark.id if mark else "" for mark in marks), preset.settings.measure)


def _reached_only(
    site: Site, plan: SitePlan, problem: SiteProblem, found: SiteLayout
) -> tuple[SiteLayout, dict[int, str]]:
    """What was found without the buildings that no way leads to, and by the number of each of
    those why it is left out."""
    here = np.flatnonzero(found.present)
    made = problem.buildings
    outlines = [made.outlines()[i] for i in here] if made.footprints else []
    got = find_reached_buildings(plan, found.boxes[here], problem.fire_access, outlines, site.verge)
    if got.all():
        return found, {}
    present = found.present.copy()
    present[here[~got]] = False
    reason = f"no way {site.fire_access:g} m wide leads to where there is room for it"
    return found._replace(present=present, score={}), {int(i): reason for i in here[~got]}


def _find_shortfall(plan: SitePlan, problem: SiteProblem, found: SiteLayout) -> tuple[LeftOut, ...]:
    """The shortfall of a site from its target, if more than a tenth."""
    covered = float(problem.buildings.sizes[found.present, :2].prod(1).sum())
    if covered >= 0.9 * problem.target[0]:
        return ()
    what = f"{covered:.0f} m² of the {problem.target[0]:.0f} m² to be covered found a place"
    return (LeftOut(plan.id, "ground covered by buildings", what, False),)


def _find_missing(site: Site, plan: SitePlan) -> tuple[LeftOut, ...]:
    """Squares and parking for which there is no room beside a street."""
    reason = "no room left beside a street" if plan.roads else "no room left along the border"
    return tuple(
        LeftOut(plan.id, what, reason, True) for what in list_missing_areas(site, plan.areas)
    )


def _left_out(
    plan: SitePlan, rows: list[BuildingDemand], present: Flags, lost: dict[int, str]
) -> tuple[LeftOut, ...]:
    """Buildings without a place, by model, and why: what ``lost`` says by the number of each, else
    that there is no room."""
    room = "no place left for {0:g} x {1:g} m on {2:.0f} m² that can be built on"
    missing = Counter(
        (row, lost.get(k) or room.format(*row.size[:2], plan.buildable))
        for k, (row, there) in enumerate(zip(rows, present, strict=True))
        if not there
    )
    asked = Counter(rows)
    return tuple(
        LeftOut(
            plan.id,
            f"{count} of {asked[row]} {row.name}" if asked[row] > 1 else row.name,
            what,
            row.required,
        )
        for (row, what), count in missing.items()
    )
