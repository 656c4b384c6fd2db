"""An extension made ready to be filled any number of times: what its brief alone decides."""

from __future__ import annotations

import hashlib
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.domains.extend.areas import AreaPlan, ExtendPlan
from scenewright.domains.extend.build_problem import build_problem
from scenewright.domains.extend.furnish import Look, look_of_copies, old_pieces
from scenewright.domains.extend.models import (
    as_drawn,
    check_models,
    keep_alike,
    local_style,
    use_catalogue,
    with_source_models,
)
from scenewright.domains.extend.prepared import prepare_sources
from scenewright.domains.extend.problem import ExtendProblem
from scenewright.domains.extend.settings import GrowthSettings


class StagedArea(NamedTuple):
    """An area with its problem, its sources prepared, and what tells how copies look."""

    area: AreaPlan
    problem: ExtendProblem
    look: Look


class StagedExtension(NamedTuple):
    """A brief with the models of its sources and the digest of what it was without them, its plan,
    the catalogue, the buildings that stood before as pieces, and all areas."""

    brief: Brief
    brief_hash: str
    plan: ExtendPlan
    catalog: Catalog
    old: tuple[Piece, ...]
    areas: tuple[StagedArea, ...]


def stage_extension(brief: Brief, plan: Plan, settings: GrowthSettings) -> StagedExtension:
    """A brief, with its plan, ready to be filled: whoever fills it many times over stages it once.

    Raises InputError for a style or a model there is not.
    """
    made: ExtendPlan = plan.detail
    catalog, style = check_models(brief, made), local_style(brief, made)
    old = old_pieces(made, style, catalog)
    covered = polygons_of(old)

    def stage(area: AreaPlan) -> StagedArea:
        problem = prepare_sources(_pose_problem(made, area, settings, catalog, covered))
        return StagedArea(area, problem, look_of_copies(area, problem.pattern, style, catalog))

    digest = hashlib.sha256(brief.model_dump_json().encode()).hexdigest()
    whole, areas = with_source_models(brief, made), tuple(map(stage, made.areas))
    return StagedExtension(whole, digest, made, catalog, old, areas)


def _pose_problem(
    plan: ExtendPlan,
    area: AreaPlan,
    settings: GrowthSettings,
    catalog: Catalog,
    covered: NDArray[np.object_],
) -> ExtendProblem:
    """The problem of an area, with the models it asks for. What stands and what is placed covers
    what its pieces will: the old ones are ``covered``."""
    problem = build_problem(plan, area, settings)
    shapes, count = problem.standing.shapes.copy(), len(covered)
    shapes[:count] = [keep_alike(a, b) for a, b in zip(shapes[:count], covered, strict=True)]
    change = use_catalogue if area.row.use == "catalogue" else as_drawn
    standing = problem.standing._replace(shapes=shapes)
    return problem._replace(pattern=change(problem.pattern, catalog), standing=standing)
