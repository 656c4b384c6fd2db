"""From buildings placed by hand or by another program to the solution of an extension."""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import Layouts, NamedBox, check_layouts
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.extend.pattern import SourcePattern
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.presets import PRESETS
from scenewright.domains.extend.problem import GrownLayout
from scenewright.domains.extend.solvers.settling import is_variant
from scenewright.domains.extend.solving import assemble_solution, furnish_area
from scenewright.domains.extend.staging import stage_extension

FITS = 0.01
"""Metres by which a box may differ from the building it is of."""


def solution_of(
    brief: Brief, layouts: Layouts, *, plan: Plan | None = None, seed: int = 0
) -> Solution:
    """The solution whose buildings stand on the boxes given, by the names of their kinds (letters
    of the source). What an area asks for beyond these is left out."""
    started = time.perf_counter()
    made = plan or plan_extend(brief)
    check_layouts(layouts, [area.id for area in made.detail.areas])
    stage, found = stage_extension(brief, made, PRESETS["default"].settings), []
    for staged in stage.areas:
        area, problem = staged.area, staged.problem
        layout = _layout(problem.pattern, layouts.get(area.id, ()), area.id)
        wanted = (problem.number or 0) - len(area.fixed)
        layout = layout._replace(asked=max(wanted, len(layout.poses), 1))
        found.append(furnish_area(staged, layout, 0))
    spent = time.perf_counter() - started
    return assemble_solution(stage, found, "default", "given", seed, spent)


def _layout(pattern: SourcePattern, given: Sequence[NamedBox], area: str) -> GrownLayout:
    """Poses and origins of boxes; InputError for a box that no building fits."""
    names = {kind.name: k for k, kind in enumerate(pattern.kinds)}
    poses, origin, form = [], [], []
    for k, one in enumerate(given):
        place = f"{area}[{k}] '{one.name}'"
        if one.name not in names:
            known = ", ".join(list(names)[:20])
            raise InputError("is no kind of the source", f"use one of: {known}", place=place)
        kind = pattern.kinds[names[one.name]]
        sides, given_sides = np.array(kind.size[:2]), np.array(one.box[3:])
        same = (np.abs(given_sides - sides) <= FITS).all()
        if not same and not is_variant(given_sides / sides):
            raise InputError(
                f"is {one.box[3]:g} x {one.box[4]:g} m, the building {kind.size[0]:g} x "
                f"{kind.size[1]:g} m",
                "give the box the building's size, or that of a variant",
                place=place,
            )
        form.append(np.ones(2) if same else given_sides / sides)
        poses.append(one.box[:3])
        origin.append(int(np.flatnonzero(pattern.kind == names[one.name])[0]))
    return GrownLayout(
        np.array(poses, float).reshape(-1, 3),
        np.array(origin, np.int64),
        ("given",) * len(poses),
        len(poses),
        {},
        np.array(form, float).reshape(-1, 2),
    )
