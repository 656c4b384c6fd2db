"""Meadows with blankets: brief, plan, solver, referee, scene and drawing."""

from __future__ import annotations

import hashlib
from typing import Annotated

import numpy as np
import shapely
from pydantic import Field

from scenewright.building import outlines
from scenewright.catalog.loading import catalog_of
from scenewright.check.bodies import bodies_of, rooms_of
from scenewright.check.bounds import find_out_of_bounds
from scenewright.check.collisions import find_collisions
from scenewright.core.brief.fields import Outline, StrictModel, Whole
from scenewright.core.plan import Plan
from scenewright.core.report import Report, count_by_kind
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.solution import LeftOut, Solution, TermValue
from scenewright.core.space import Level, Space
from scenewright.drawing import rooms
from scenewright.engine.rows import Preset, SolverRow

BLANKET = Size(1.5, 2.0, 0.01)


class Meadow(StrictModel):
    """One meadow: its outline and how many blankets it is to hold."""

    id: str = "meadow"
    outline: Outline
    blankets: Annotated[Whole, Field(ge=0, le=200)] = 6


class MeadowPart(StrictModel):
    """The keys only meadows have."""

    meadows: Annotated[list[Meadow], Field(min_length=1, max_length=20)]


PRESETS = {"default": Preset("the best of many throws", "throw", 200, {"near": 1.0}, ())}
SOLVERS = {"throw": SolverRow("throw", "blankets thrown at random", "ours", f"{__name__}:_throw")}
TERMS = {"near": "blankets near each other, in metres missing to 3 m"}


def plan(brief):
    """Open ground without walls."""
    spaces = []
    for number, row in enumerate(brief.part.meadows):
        try:
            ring, holes = outlines.rings(outlines.polygon(row.outline, []))
        except Exception as error:
            raise error.located(place=f"meadows[{number}]") from None
        spaces.append(Space(row.id, row.id, ("meadow",), "0", ring, holes, 100.0))
    level = Level("0", "", 0.0, 2.6)
    return Plan((level,), tuple(spaces), {space.id: space.name for space in spaces})


def solve(
    brief,
    *,
    plan,
    preset="default",
    solver=None,
    seconds=None,
    steps=None,
    seed=0,
    threads=None,
    progress=None,
    cancel=None,
):
    """Throw blankets until enough lie apart, or the steps are spent."""
    rng, pieces, left_out, terms = np.random.default_rng(seed), [], [], []
    spaces, tries = plan.spaces, steps or PRESETS[preset].steps
    for number, (row, space) in enumerate(zip(brief.part.meadows, spaces, strict=True)):
        found, near = _throw(row, space, rng, tries, cancel)
        pieces += found
        terms.append(TermValue(space.id, "", "near", near, 1.0, near))
        if len(found) < row.blankets:
            missing = f"{row.blankets - len(found)} of {row.blankets} blankets"
            left_out.append(LeftOut(space.id, missing, "no room apart from the others", True))
        if progress:
            progress((number + 1) / len(spaces), space.name)
    digest = hashlib.sha256(brief.model_dump_json().encode()).hexdigest()
    energies = {term.space: term.cost for term in terms}
    return Solution(
        brief,
        tuple(pieces),
        (),
        tuple(terms),
        tuple(left_out),
        energies,
        preset,
        solver or "throw",
        seed,
        "1.0",
        digest,
        0.0,
        tries * len(spaces),
    )


def _throw(row, space, rng, tries, cancel):
    floor, taken, found, near = shapely.Polygon(space.outline), [], [], 0.0
    low, high = space.outline.min(0), space.outline.max(0)
    for _ in range(tries):
        if len(found) == row.blankets or (cancel and cancel()):
            break
        x, y = rng.uniform(low, high)
        shape = shapely.box(x - 0.75, y - 1.0, x + 0.75, y + 1.0)
        if floor.covers(shape) and all(shape.distance(other) > 0.5 for other in taken):
            taken.append(shape)
            name = f"{space.id}/blanket_{len(found) + 1}"
            found.append(
                Piece(
                    name,
                    "rug",
                    "",
                    space.id,
                    Pose(float(x), float(y), 0.0, np.pi / 2),
                    BLANKET,
                    space.id,
                    "blanket",
                )
            )
    gaps = [a.distance(b) for k, a in enumerate(taken) for b in taken[:k]]
    return found, float(np.maximum(3.0 - np.array(gaps), 0.0).sum()) if gaps else near


def check(solution, plan, kinds):
    """Blankets lie in their meadow and not on each other."""
    spaces = rooms_of(plan.spaces)
    bodies, malformed = bodies_of(solution.pieces, spaces, kinds)
    findings = (
        *malformed,
        *find_collisions(bodies, spaces.levels),
        *find_out_of_bounds(bodies, spaces),
    )
    return Report(findings, (), {"pieces": len(solution.pieces), "counts": count_by_kind(findings)})


def scene(solution, plan):
    """Blankets on grass."""
    return Scene(solution.brief.name, plan.levels, plan.spaces, (), (), solution.pieces, (), ())


def draw(solution, plan, judge):
    """The plan with the outlines of meadows and the signs of blankets."""
    return rooms.plan(scene(solution, plan), catalog_of(solution.brief.catalogs))
