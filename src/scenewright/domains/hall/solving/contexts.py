"""Halls before anything is placed: their zones, walls, fixed objects and seeds."""

from __future__ import annotations

from zlib import crc32

import numpy as np

from scenewright.building.standing import fixed_pieces, reaching_in
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.hall.build_problem import HallContext, hall_of
from scenewright.domains.hall.settings import USUAL_ZONING, ZoningSettings
from scenewright.domains.hall.zoning.zones import HallPlan, borders_of, zones_of


def hall_contexts(
    brief: Brief,
    rooms: tuple[Space, ...],
    catalog: Catalog,
    seed: int,
    variant: int,
    zoning: ZoningSettings = USUAL_ZONING,
) -> list[HallContext]:
    """Every hall of a brief: its zones, walls and fixed objects."""
    pairs = zip(brief.rooms, rooms, strict=True)
    standing = [tuple(fixed_pieces(room, space, catalog)) for room, space in pairs]
    beside = reaching_in(standing, rooms)
    plans = [zones_of(brief, k, space, seed, variant, zoning) for k, space in enumerate(rooms)]
    return [
        _hall(brief, plan, *there)
        for plan, there in zip(plans, zip(rooms, standing, beside, strict=True), strict=True)
    ]


def _hall(
    brief: Brief, plan: HallPlan, space: Space, fixed: tuple[Piece, ...], beside: tuple[Piece, ...]
) -> HallContext:
    borders, passage = borders_of(plan, space), brief.passage_width
    return hall_of(space, plan, borders, fixed, brief.route_width, beside, passage)


def seed_of(seed: int, space: Space) -> int:
    """The seed of one hall of a brief: another hall, another stream."""
    sequence = np.random.SeedSequence([seed, crc32(space.id.encode())])
    return int(sequence.generate_state(1)[0]) % 2**31
