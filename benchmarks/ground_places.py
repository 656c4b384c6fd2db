"""Real places for the ground: villages told their streets alone, and halves of towns to continue.

Ten villages: those held out by a split that have most blocks, the first blocks by a fixed order.
Extensions: squares of 160 m cut out of city models and maps where most is built, the western half
the source, the eastern one the area. Nothing was tuned to single places. The subset of Zürich gives
none: its 49 buildings lie one by one over 9 by 10 km.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from benchmarks.real_data import data_set
from benchmarks.village import path_of_style
from benchmarks.village_data import SPLITS, real_blocks
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.ground.buildings.built import BuiltScene
from scenewright.ground.reading import read_built

PLACES, BLOCKS, QUICK_PLACES, QUICK_BLOCKS = 10, 8, 4, 3
SIDE, EACH, FEWEST = 80.0, 4, 3
"""Metres of half of a square, most squares of a file, least buildings of a source."""
FILES = (
    "citymodels_cityjson/delft.json",
    "citymodels_cityjson/zurich_subset_lod2.json",
    "citymodels_cityjson/rotterdam_subset.json",
    "professional_files/osm/bristol_contraflow_cycleway.osm",
    "professional_files/osm/campo_grande_br.osm.gz",
    "professional_files/osm/iller_hamlet.osm",
    "professional_files/osm/moscow_block.osm.gz",
    "professional_files/osm/northgate_dual_carriageway.osm",
    "professional_files/osm/taipei.osm.gz",
    "professional_files/gis/bubenec.gpkg",
    "professional_files/gis/luneray_shp.zip",
    "professional_files/cityjson/denhaag_01_v08.city.json",
    "professional_files/cityjson/montreal_energy_ext.city.json",
)


class Place(NamedTuple):
    """A case: its name, the brief, and the share that is really built (``None``: not known)."""

    name: str
    brief: Brief
    coverage: float | None


def village_places(quick: bool) -> Iterator[Place]:
    """Villages as briefs of blocks side by side, with the real coverage of these."""
    every = real_blocks()
    split_of = {place: name for name, held in SPLITS.items() for place in held}
    number = {place: sum(b.place == place for b in every) for place in split_of}
    chosen = sorted(split_of, key=lambda place: -number[place])[: QUICK_PLACES if quick else PLACES]
    for place in chosen:
        blocks = [b for b in every if b.place == place]
        order = np.random.default_rng(5).permutation(len(blocks))
        kept = [blocks[k] for k in order[: QUICK_BLOCKS if quick else BLOCKS]]
        area = sum(b.floor.area for b in kept)
        built = sum(shapely.union_all(b.standing.shapes).area for b in kept)
        rows, west = [], 0.0
        for block in kept:
            low = np.array(block.floor.bounds[:2])
            rows.append(_block(block, np.array([west, 0.0]) - low))
            west += float(np.ptp(np.array(block.floor.bounds)[[0, 2]])) + 60.0
        document = {
            "domain": "village",
            "name": place,
            "style": str(path_of_style(split_of[place])),
            "region": kept[0].region,
            "blocks": rows,
        }
        yield Place(place, Brief.model_validate(document), built / area)


def _block(block: Any, shift: np.ndarray) -> dict[str, Any]:
    ring = shapely.get_coordinates(shapely.orient_polygons(block.floor).exterior)[:-1]
    lines = shapely.union_all(shapely.linestrings(block.streets))
    after = np.roll(ring, -1, axis=0)
    spots = np.stack([ring, (ring + after) / 2, after], 1)
    on = (shapely.distance(shapely.points(spots), lines) < 0.6).all(1)
    streets = np.flatnonzero(on).tolist() or [
        int(np.argmin(shapely.distance(shapely.points(spots[:, 1]), lines)))
    ]
    return {"outline": (ring + shift).round(3).tolist(), "streets": streets}


def extension_places(quick: bool) -> Iterator[Place]:
    """Halves of real places to be continued, with the share that is built in the source."""
    for name in FILES[:6] if quick else FILES:
        path = data_set(name)
        try:
            scene = read_built(path)
        except InputError as fault:
            raise InputError(f"{name}: {fault.fault}", fault.remedy) from None
        for k, place in enumerate(_cut(path, scene, 1 if quick else EACH), 1):
            yield place._replace(name=f"{path.name.partition('.')[0]} {k}")


def _cut(path: Path, scene: BuiltScene, most: int) -> Iterator[Place]:
    """The fullest squares of a scene that do not overlap, each as a brief."""
    middles = np.array([one.outline.mean(0) for one in scene.buildings])
    shapes = np.array([shapely.Polygon(one.outline) for one in scene.buildings], object)
    left, made = np.ones(len(middles), bool), 0
    while left.any() and made < most:
        away = np.abs(middles[:, None] - middles[None]).max(2)
        full = np.where(left, (away < SIDE).sum(1), -1)
        at = middles[int(np.argmax(full))]
        left &= np.abs(middles - at).max(1) >= 2 * SIDE
        west = shapely.box(at[0] - SIDE, at[1] - SIDE, at[0], at[1] + SIDE)
        area = shapely.box(at[0], at[1] - SIDE, at[0] + SIDE, at[1] + SIDE)
        rows = [k for k in range(len(shapes)) if west.covers(shapes[k])]
        if len(rows) < FEWEST:
            continue
        made, built = made + 1, shapely.union_all(shapes[rows]).area
        source = {
            "outline": _ring(west),
            "stands": True,
            "buildings": [
                {
                    "id": f"b{k}",
                    "outline": scene.buildings[k].outline.round(3).tolist(),
                    "height": min(scene.buildings[k].height, 300.0),
                }
                for k in rows
            ],
            "roads": list(_roads(scene, west)),
        }
        document = {
            "domain": "extend",
            "name": path.stem[:60],
            "sources": [source],
            "areas": [{"outline": _ring(area)}],
        }
        yield Place("", Brief.model_validate(document), built / west.area)


def _ring(shape: shapely.Polygon) -> list[list[float]]:
    ring = shapely.get_coordinates(shapely.orient_polygons(shape).exterior)[:-1]
    return ring.round(3).tolist()


def _roads(scene: BuiltScene, west: shapely.Polygon) -> Iterator[dict[str, Any]]:
    for road in scene.roads:
        for part in shapely.get_parts(shapely.intersection(shapely.LineString(road.line), west)):
            if part.geom_type == "LineString" and part.length > 1.0:
                line = shapely.get_coordinates(part).round(3).tolist()
                yield {"line": line, "width": min(road.width, 60.0), "kind": road.kind}
