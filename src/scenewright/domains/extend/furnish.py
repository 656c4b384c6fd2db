"""From a filled area to its pieces and scene: buildings old and new, streets, walks to doors."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan
from scenewright.domains.extend.models import footprint_within, model_of
from scenewright.domains.extend.pattern import STOREY, SourcePattern
from scenewright.domains.extend.problem import GrownLayout
from scenewright.domains.extend.works import lay_walks
from scenewright.ground.built import to_frames
from scenewright.ground.surfaces import surfaces


def new_pieces(
    area: AreaPlan, pattern: SourcePattern, layout: GrownLayout, style: str, catalog: Catalog
) -> tuple[Piece, ...]:
    """One piece a building, its front ahead; ids count by kind, past those that stay."""
    taken = {row.id for row in area.fixed}
    counts: dict[str, int] = {}
    found = []
    for pose, origin in zip(layout.poses.tolist(), layout.origin.tolist(), strict=True):
        kind = pattern.kinds[int(pattern.kind[origin])]
        counts[kind.name] = counts.get(kind.name, 0) + 1
        while f"{area.id}/{kind.name}_{counts[kind.name]}" in taken:
            counts[kind.name] += 1
        size = grow_upwards(Size(*kind.size), area.row.storeys)
        asset = model_of(kind._replace(size=(*size,)), style, catalog)
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
                footprint=footprint_within(kind.local, size, catalog.assets.get(asset)),
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


def standing_pieces(area: AreaPlan) -> tuple[Piece, ...]:
    """The buildings of an area that stay where they stand."""
    return tuple(
        Piece(
            id=row.id,
            category="building",
            asset=row.model,
            space=area.id,
            pose=Pose(*row.box[:2], 0.0, row.box[2]),
            size=Size(row.box[3], row.box[4], row.height),
            group=f"{area.id}/buildings",
            function=row.kind or "building",
            fixed=True,
            footprint=row.local,
        )
        for row in area.fixed
    )


def old_pieces(plan: ExtendPlan, style: str, catalog: Catalog) -> tuple[Piece, ...]:
    """The buildings of the sources that stand; they are given, and belong to no area."""
    pattern, found = plan.pattern, []
    for number, (box, k) in enumerate(zip(pattern.boxes.tolist(), pattern.kind, strict=True)):
        source = int(pattern.source[number])
        if not plan.stands[source]:
            continue
        kind = pattern.kinds[int(k)]
        asset = model_of(kind, style, catalog)
        size = Size(box[3], box[4], kind.size[2])
        ring = shapely.get_coordinates(pattern.shapes[number].exterior)[:-1]
        local = to_frames(ring, np.array([box]))
        prefix = OLD if source == 0 else f"{OLD}{source + 1}"
        found.append(
            Piece(
                id=f"{prefix}/{kind.name}_{number + 1}",
                category="building",
                asset=asset,
                space=OLD,
                pose=Pose(box[0], box[1], 0.0, wrap_angle(box[2])),
                size=size,
                group=OLD,
                function=kind.name,
                fixed=True,
                footprint=footprint_within(local, size, catalog.assets.get(asset)),
            )
        )
    return tuple(found)


def wrap_angle(angle: float) -> float:
    """An angle in [-π, π).

    >>> round(wrap_angle(4.0), 3)
    -2.283
    """
    return (angle + math.pi) % (2 * math.pi) - math.pi


def scene_of_extension(solution: Solution, plan: Plan) -> Scene:
    """The scene of a solution: streets and walks, and what stands on the ground, old and new."""
    works = lay_walks(plan.detail, solution.pieces)
    ground = surfaces((plan.detail.ground,), (works,))
    known = plan.spaces[0].id
    ground = tuple(row._replace(space=known) for row in ground)
    return Scene(solution.brief.name, plan.levels, plan.spaces, (), (), solution.pieces, ground, ())
