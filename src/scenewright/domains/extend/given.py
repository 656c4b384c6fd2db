"""Fixed buildings of an extension's brief, as pieces: its sources, and those that stay."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.catalog import OWN, Asset, Catalog
from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Points
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan
from scenewright.domains.extend.pattern import BuildingKind
from scenewright.ground.buildings.built import to_frames
from scenewright.ground.edits.locks import standing_piece

BOXY = 0.985
"""The share of its box from which a footprint counts as the box."""


def given_pieces(_brief: Brief, plan: Plan, kinds: Catalog) -> tuple[Piece, ...]:
    """What stood before and what stays in the areas of a plan, by its brief alone."""
    stay = (piece for area in plan.detail.areas for piece in standing_pieces(area))
    return (*stay, *(piece for *_, piece in source_pieces(plan.detail, kinds)))


def standing_pieces(area: AreaPlan) -> tuple[Piece, ...]:
    """The buildings of an area that stay where they stand."""
    return tuple(
        standing_piece(row, area.id, row.model, row.kind or "building") for row in area.fixed
    )


def source_pieces(plan: ExtendPlan, catalog: Catalog) -> Iterator[tuple[int, BuildingKind, Piece]]:
    """The buildings of the sources that stand, each with its number and kind; they belong to
    no area. Which model draws each is not said here."""
    pattern = plan.pattern
    for number, (box, k) in enumerate(zip(pattern.boxes.tolist(), pattern.kind, strict=True)):
        source = int(pattern.source[number])
        if not plan.stands[source]:
            continue
        kind = pattern.kinds[int(k)]
        size = Size(box[3], box[4], kind.size[2])
        ring = shapely.get_coordinates(pattern.shapes[number].exterior)[:-1]
        local = to_frames(ring, np.array([box]))
        prefix = OLD if source == 0 else f"{OLD}{source + 1}"
        piece = Piece(
            id=f"{prefix}/{kind.name}_{number + 1}",
            category="building",
            asset="",
            space=OLD,
            pose=Pose(box[0], box[1], 0.0, wrap_angle(box[2])),
            size=size,
            group=OLD,
            function=kind.name,
            fixed=True,
            footprint=footprint_within(local, size, catalog.assets.get(kind.model)),
        )
        yield number, kind, piece


def footprint_within(local: Points, size: Size, asset: Asset | None) -> Footprint:
    """What a building covers in the frame of its box, ``local`` (n, 2); the box of its own model
    where that is not drawn over such a footprint."""
    found = _fill_box(tuple((float(x), float(y)) for x, y in local), *size[:2])
    if asset is not None and asset.id.startswith(OWN):
        return found if asset.over and asset.over(size, found) else asset.footprint(size)
    return () if shapely.Polygon(local).area > BOXY * size.width * size.depth else found


@lru_cache(maxsize=4096)
def _fill_box(corners: Footprint, width: float, depth: float) -> Footprint:
    """An outline stretched to fill a box; that of a building that stands is asked for again and
    again."""
    return read_footprint(read_footprint(corners, width, depth) or corners, width, depth)


def wrap_angle(angle: float) -> float:
    """An angle in [-π, π).

    >>> round(wrap_angle(4.0), 3)
    -2.283
    """
    return (angle + math.pi) % (2 * math.pi) - math.pi
