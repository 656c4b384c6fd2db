"""Real blocks of villages to learn from: read, cleaned, their outlines rebuilt.

Outlines that were drawn about the houses leak the answer: their sides that are no street are an
offset of these. Such sides are grown by 3 to 12 m at random (by the block's id) and simplified;
houses that then stand partly outside, those below 10 and above 1,000 m² and those that cross
themselves are dropped, and blocks with fewer than three houses left.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import shapely

from scenewright.catalog.models.files import check_json
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.stored_file import MEBIBYTE, read_plain, report_damage
from scenewright.domains.village.house import House, own_door, to_own_frame
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.library import classify_house

LEAST, LARGEST, FEWEST = 10.0, 1000.0, 3
GROWN, SIMPLE, ACROSS = (3.0, 12.0), 2.5, 20.0
"""Metres by which sides without a street grow, tolerance of their simplification, and how far
beyond streets nothing grows."""
OUTSIDE = 0.02
"""The share of a house that may lie outside the rebuilt outline."""
CORNERS, LONGEST = 60, 80
"""Corners of a footprint and letters of the name of a region, at most."""
MATERIALS = ("brick", "other", "mixed")
"""Words for the three classes of material."""
LARGEST_FILE = 256 * MEBIBYTE
REMEDY = "give a list of blocks: place, outline, outline_on_street, houses with polygon"


def read_blocks(path: Path, kinds: Sequence[str] = ()) -> tuple[RealBlock, ...]:
    """The blocks of a file that are left after cleaning; ``kinds`` are kinds of places (empty:
    all). A file is a JSON list of blocks: ``id``, ``place``, ``outline`` in metres,
    ``outline_on_street`` (a flag for each corner), ``houses`` with their ``polygon``, if known its
    ``door`` and ``material`` (:data:`MATERIALS`), and the ``region`` (or ``source``) it is of.
    InputError for another one."""
    with report_damage(path, "JSON of blocks", REMEDY):
        content = read_plain(path, LARGEST_FILE)
        check_json(content)
        rows = json.loads(content)
        if not isinstance(rows, list):
            raise InputError("is no list of blocks", REMEDY)
        return clean_blocks(rows, kinds)


def clean_blocks(rows: Iterable[Any], kinds: Sequence[str] = ()) -> tuple[RealBlock, ...]:
    """Blocks as read that are left after cleaning."""
    found = []
    for number, row in enumerate(rows):
        try:
            if not kinds or row["place_kind"] in kinds:
                found.append(rebuild(row))
        except (KeyError, TypeError, ValueError, IndexError, shapely.errors.ShapelyError):
            raise InputError("is no block", REMEDY, place=f"[{number}]") from None
    return tuple(block for block in found if block is not None)


def blocks_of_plan(plan: Plan, place: str) -> tuple[RealBlock, ...]:
    """The blocks of a village with the houses that stand there; outlines are as they are."""
    found = []
    for block in plan.detail.blocks:
        rings = [np.asarray(row.outline) for row in block.fixed]
        floor = shapely.Polygon(block.outline)
        kept = tuple(ring for ring in rings if shapely.Polygon(ring).area >= LEAST)
        if len(kept) >= FEWEST:
            found.append(RealBlock(block.id, place, floor, block.streets, kept))
    return tuple(found)


def rebuild(row: dict[str, Any]) -> RealBlock | None:
    """A block of the data with its outline rebuilt; None if too little is left."""
    corners = np.array(row["outline"], float)
    on = np.array(row["outline_on_street"], bool)
    street = on & np.roll(on, -1)
    sides = np.stack([corners, np.roll(corners, -1, axis=0)], 1)
    if not street.any():
        return None
    floor = grow_outline(corners, sides, street, crc32(str(row["id"]).encode()))
    houses = [(ring, told) for told in row["houses"] if (ring := _ring(told)) is not None]
    kept = [
        (ring, told)
        for ring, told in houses
        if shapely.Polygon(ring).difference(floor).area <= OUTSIDE * shapely.Polygon(ring).area
    ]
    if len(kept) < FEWEST:
        return None
    region = str(row.get("region") or row.get("source") or "")[:LONGEST]
    rings, rows = tuple(ring for ring, _ in kept), [told for _, told in kept]
    doors, materials = _doors(rows), _materials(rows)
    name, place = str(row["id"]), str(row["place"])
    return RealBlock(name, place, floor, sides[street], rings, region, doors, materials)


def _doors(houses: Sequence[dict[str, Any]]) -> tuple[np.ndarray, ...]:
    """The doors of houses, if all are known. ValueError for one that is no point."""
    known = all("door" in told for told in houses)
    found = tuple(np.array(told["door"], float).reshape(2) for told in houses if known)
    if not np.isfinite(np.array(found)).all():
        raise ValueError("no point")
    return found


def _materials(houses: Sequence[dict[str, Any]]) -> tuple[int, ...]:
    """The classes of the materials of houses, if all are known."""
    known = all("material" in told for told in houses)
    return tuple(MATERIALS.index(told["material"]) for told in houses if known)


def grow_outline(
    corners: np.ndarray, sides: np.ndarray, street: np.ndarray, seed: int
) -> shapely.Polygon:
    """The ground of a block, its sides (n, 2, 2) that are no street grown outwards."""
    floor = shapely.Polygon(corners).buffer(0)
    rng = np.random.default_rng(seed)
    others = sides[~street]
    if len(others):
        merged = shapely.get_parts(
            shapely.line_merge(shapely.union_all(shapely.linestrings(others)))
        )
        by = rng.uniform(*GROWN, len(merged))
        grown = shapely.union_all([floor, *shapely.buffer(merged, by)])
        lines = shapely.union_all(shapely.linestrings(sides[street]))
        beyond = shapely.difference(shapely.buffer(lines, ACROSS, cap_style="flat"), floor)
        grown = shapely.difference(grown, shapely.buffer(beyond, 0.01))
        floor = max(shapely.get_parts(grown), key=lambda part: part.area)
    return shapely.Polygon(floor.exterior).simplify(SIMPLE)


def _ring(house: dict[str, Any]) -> np.ndarray | None:
    """The footprint of a house, counter-clockwise without corners on straight sides."""
    shape = shapely.Polygon(house["polygon"]).simplify(0.05)
    if not shape.is_valid or not LEAST <= shape.area <= LARGEST:
        return None
    ring = shapely.get_coordinates(shapely.orient_polygons(shape).exterior)[:-1]
    return np.asarray(ring) if len(ring) <= CORNERS else None


def library_of(blocks: Sequence[RealBlock]) -> tuple[House, ...]:
    """Every house of some blocks as a library."""
    found = []
    for block in blocks:
        for number, ring in enumerate(block.houses):
            local = to_own_frame(ring)[0]
            house = classify_house(f"{block.name}/{number}", local, 2, 7.0, "", 1.0)
            door = own_door(ring, block.doors[number]) if block.doors else None
            material = block.materials[number] if block.materials else 0
            found.append(house._replace(door=door, material=material))
    return tuple(found)
