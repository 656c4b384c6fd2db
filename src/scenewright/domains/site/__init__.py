"""Sites: groups of buildings on ground between streets, around landmarks that stand.

After Zhang, Yang 2023: buildings of a library fill the ground in planar forms; ours fills block
by block with rows and courts that keep their distances by construction.
"""

from __future__ import annotations

import hashlib
import time
from collections import Counter
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from scenewright._version import __version__
from scenewright.appearance import facts
from scenewright.brief import Brief
from scenewright.brief.site import Site
from scenewright.catalog import Catalog
from scenewright.domains.site.dress import buildings, landmark_assets, landmarks
from scenewright.domains.site.green import green
from scenewright.domains.site.pose import Looks, pose
from scenewright.domains.site.presets import PRESETS, SitePreset
from scenewright.domains.site.reached import reached
from scenewright.domains.site.reasons import reasons
from scenewright.domains.site.wanted import Wanted, wanted
from scenewright.errors import InputError
from scenewright.scene import Piece
from scenewright.site.plan import SitePlan, site_plans
from scenewright.site_problem import Flags, SiteProblem
from scenewright.solution import LeftOut, Solution, TermValue
from scenewright.solve import Budget
from scenewright.solvers.site_found import SiteFound
from scenewright.solvers.sites import SITE_SOLVERS
from scenewright.stock import catalog_of

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

__all__ = ["PRESETS", "problems", "solve"]


class Built(NamedTuple):
    """One site built on."""

    site: str
    pieces: tuple[Piece, ...]
    terms: tuple[TermValue, ...]
    left_out: tuple[LeftOut, ...]
    evaluations: int


def solve(
    brief: Brief,
    *,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Solution:
    """Place the buildings of every site of a brief.

    ``steps`` are layouts looked at (of each block, by the default solver); the same seed and
    steps give the same answer. ``progress`` hears the share done; when ``cancel`` answers true,
    what was found so far is returned.
    """
    started = time.perf_counter()
    if preset not in PRESETS:
        raise InputError(f"there is no preset '{preset}'", "one of " + ", ".join(PRESETS))
    chosen, catalog = PRESETS[preset], catalog_of(brief.catalogs)
    named = solver or chosen.solver
    budget = Budget(seconds, steps, threads=threads)
    found = []
    for number, (site, plan) in enumerate(
        zip(brief.sites, site_plans(brief.sites, catalog), strict=True)
    ):
        place = f"sites[{number}]"
        heard = None if progress is None else _part(progress, number, len(brief.sites), plan.name)
        rng_seed = seed + 7919 * number
        found.append(_build(site, plan, place, catalog, chosen, named, budget, rng_seed, heard,
                            cancel))  # fmt: skip
    return Solution(
        brief=brief,
        pieces=tuple(piece for one in found for piece in one.pieces),
        patches=(),
        terms=tuple(term for one in found for term in one.terms),
        left_out=tuple(out for one in found for out in one.left_out),
        energies={one.site: sum(term.cost for term in one.terms) for one in found},
        preset=preset,
        solver=named,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=time.perf_counter() - started,
        evaluations=sum(one.evaluations for one in found),
    )


def _part(progress: Progress, number: int, count: int, name: str) -> Callable[[float, float], None]:
    return lambda share, _best: progress((number + share) / count, name)


def _build(
    site: Site, plan: SitePlan, place: str, catalog: Catalog, preset: SitePreset, solver: str,
    budget: Budget, seed: int, progress: Callable[[float, float], None] | None,
    cancel: Cancel | None,
) -> Built:  # fmt: skip
    rows, problem = _posed(site, plan, place, catalog, preset, progress)
    if budget.steps is None and budget.seconds is None and solver == preset.solver:
        budget = budget._replace(steps=preset.steps)
    found = SITE_SOLVERS[solver].run(problem, budget, seed, progress, cancel)
    found, cut_off = _reached_only(plan, found, site.fire_access)
    standing = landmarks(plan, catalog)
    placed = buildings(plan, rows, found.boxes, found.present)
    grown = green(plan, (*standing, *placed), catalog, np.random.default_rng(seed))
    return Built(
        plan.id, (*standing, *placed, *grown), reasons(problem, found, plan.id),
        (*_left_out(plan, rows, found.present | cut_off), *_cut_off(site, plan, rows, cut_off)),
        found.evaluations,
    )  # fmt: skip


def problems(brief: Brief, preset: str = "default") -> tuple[SiteProblem, ...]:
    """The sites of a brief as problems, for solvers of :data:`SITE_SOLVERS` run by oneself."""
    catalog = catalog_of(brief.catalogs)
    return tuple(
        _posed(site, plan, f"sites[{number}]", catalog, PRESETS[preset], None)[1]
        for number, (site, plan) in enumerate(
            zip(brief.sites, site_plans(brief.sites, catalog), strict=True)
        )
    )


def _posed(
    site: Site, plan: SitePlan, place: str, catalog: Catalog, preset: SitePreset,
    progress: Callable[[float, float], None] | None,
) -> tuple[list[Wanted], SiteProblem]:  # fmt: skip
    rows = wanted(site, plan, place, catalog)
    looks = _looks(plan, rows, catalog, preset, progress)
    return rows, pose(site, plan, rows, preset.weights, looks)._replace(form=preset.form)


def _looks(
    plan: SitePlan, rows: list[Wanted], catalog: Catalog, preset: SitePreset,
    progress: Callable[[float, float], None] | None,
) -> Looks:  # fmt: skip
    """How all models of a site look."""
    marks = landmark_assets(plan, catalog)
    heard = None if progress is None else lambda _share, _name: progress(0.0, 0.0)
    found = facts([*(row.asset for row in rows), *(mark for mark in marks if mark)], heard)
    return Looks(found, tuple(mark.id if mark else "" for mark in marks), preset.measure)


def _reached_only(plan: SitePlan, found: SiteFound, width: float) -> tuple[SiteFound, Flags]:
    """What was found without the buildings that no way leads to, and which those are."""
    cut_off = np.zeros(len(found.present), np.bool_)
    cut_off[found.present] = ~reached(plan, found.boxes[found.present], width)
    if cut_off.any():
        found = found._replace(present=found.present & ~cut_off, score={})
    return found, cut_off


def _cut_off(site: Site, plan: SitePlan, rows: list[Wanted], cut_off: Flags) -> tuple[LeftOut, ...]:
    """Buildings that no way leads to where they would stand, by model."""
    told = f"no way {site.fire_access:g} m wide leads to where there is room for it"
    missing = Counter(row for row, lost in zip(rows, cut_off, strict=True) if lost)
    return tuple(
        LeftOut(plan.id, f"{count} of {row.name}" if count > 1 else row.name, told, row.required)
        for row, count in missing.items()
    )


def _left_out(plan: SitePlan, rows: list[Wanted], present: Flags) -> tuple[LeftOut, ...]:
    """Buildings without a place, by model, and how much ground they lack."""
    missing = Counter(row for row, there in zip(rows, present, strict=True) if not there)
    asked = Counter(rows)
    return tuple(
        LeftOut(
            plan.id, f"{count} of {asked[row]} {row.name}" if asked[row] > 1 else row.name,
            f"no place left for {row.size.width:g} x {row.size.depth:g} m on "
            f"{plan.buildable:.0f} m² that can be built on", row.required,
        )
        for row, count in missing.items()
    )  # fmt: skip
