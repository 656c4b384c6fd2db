"""From a filled area to its pieces and scene: buildings old and new, streets, walks to doors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import NamedTuple

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.core.footprint import Footprint
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import AreaPlan, ExtendPlan
from scenewright.domains.extend.given import footprint_within, source_pieces, wrap_angle
from scenewright.domains.extend.models import model_of
from scenewright.domains.extend.pattern import STOREY, SourcePattern
from scenewright.domains.extend.problem import GrownLayout
from scenewright.domains.extend.works import fence_plots, lay_walks
from scenewright.ground.ways.surfaces import surfaces


class CopyLook(NamedTuple):
    """How the copies of a building of the sources look: model, size and footprint."""

    asset: str
    size: Size
    footprint: Footprint


Look = Callable[[int, tuple[float, float]], CopyLook]
"""Tells how the copies of a building of the sources look, by its number and their form."""


def look_of_copies(area: AreaPlan, pattern: SourcePattern, style: str, catalog: Catalog) -> Look:
    """How copies look in an area; each kind is drawn once in each form."""

    @cache
    def draw(kind: int, told: tuple[str, str], form: tuple[float, float]) -> CopyLook:
        one = pattern.kinds[kind]
        width, depth, high = one.size
        wide, deep = form
        size = grow_upwards(Size(abs(wide) * width, deep * depth, high), area.row.storeys)
        local = one.local * form
        asset = model_of(one._replace(size=(*size,), local=local), style, catalog, told)
        return CopyLook(asset, size, footprint_within(local, size, catalog.assets.get(asset)))

    def look(origin: int, form: tuple[float, float]) -> CopyLook:
        told = pattern.told[origin] if pattern.told else ("", "")
        return draw(int(pattern.kind[origin]), told, form)

    return look


def new_pieces(
    area: AreaPlan, pattern: SourcePattern, layout: GrownLayout, look: Look
) -> tuple[Piece, ...]:
    """One piece a building, its front ahead; ids count by kind, past those that stay."""
    taken = {row.id for row in area.fixed}
    counts: dict[str, int] = {}
    found = []
    forms = np.ones((len(layout.poses), 2)) if layout.form is None else layout.form
    rows = zip(layout.poses.tolist(), layout.origin.tolist(), forms.tolist(), strict=True)
    for pose, origin, form in rows:
        kind = pattern.kinds[int(pattern.kind[origin])]
        counts[kind.name] = counts.get(kind.name, 0) + 1
        while f"{area.id}/{kind.name}_{counts[kind.name]}" in taken:
            counts[kind.name] += 1
        asset, size, footprint = look(origin, (form[0], form[1]))
        found.append(
            Piece(
                id=f"{area.id}/{kind.name}_{counts[kind.name]}",
                category="building",
                asset=asset,
                space=area.id,
                pose=Pose(pose[0], pose[1], 0.0, wrap_angle(pose[2])),
                size=size,
                group=f"{area.id}/buildings",
                function=kind.name,
                footprint=footprint,
            )
        )
    return tuple(found)


def grow_upwards(size: Size, storeys: int) -> Size:
    """A size with some storeys of :data:`STOREY` more, or less; never below one.

    >>> grow_upwards(Size(9.0, 8.0, 7.0), 2).height, grow_upwards(Size(9.0, 8.0, 7.0), -5).height
    (13.0, 3.0)
    """
    if not storeys:
        return size
    return size._replace(height=max(size.height + storeys * STOREY, STOREY))


def old_pieces(plan: ExtendPlan, style: str, catalog: Catalog) -> tuple[Piece, ...]:
    """The buildings of the sources that stand, with the models that draw them."""
    return tuple(
        replace(piece, asset=model_of(kind, style, catalog, plan.pattern.told[number]))
        for number, kind, piece in source_pieces(plan, catalog)
    )


def scene_of_extension(solution: Solution, plan: Plan) -> Scene:
    """The scene of a solution: streets, walks and fences, and buildings, old and new."""
    works = lay_walks(plan.detail, solution.pieces)
    built = polygons_of([piece for piece in solution.pieces if piece.category == "building"])
    ground = surfaces((plan.detail.ground,), (works,), built)
    known = plan.spaces[0].id
    fences = fence_plots(solution, plan, works, known)
    ground = (*(row._replace(space=known) for row in ground), *fences)
    return Scene(solution.brief.name, plan.levels, plan.spaces, (), (), solution.pieces, ground, ())
