"""Real residential compounds: the ReCo sample (91 compounds, 2,547 buildings, CC BY-NC-SA 4.0).

    python benchmarks/site_reco.py PATH/reco_sample.json

Chen et al. 2022, "ReCo: A Dataset for Residential Community Layout Planning". Boundaries and
footprints in metres, storeys. The file cuts buildings along the tiles of a map; the pieces
are joined again. Footprints become their least rectangles, the front of
each the long side nearest to south, three metres a storey; what lies outside the boundary is left
out.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from scenewright.core.errors import InputError
from scenewright.domains.site.brief import Site
from scenewright.domains.site.plan import site_plan
from scenewright.ground.plan import SitePlan

Floats = NDArray[np.float64]
STOREY, TOUCH, LEAST, LONGEST, TILT = 3.0, 0.02, 1.0, 400.0, 0.01
"""Metres a storey; how near touching is; the length of a border that counts; what stays in pieces
because it would be longer; how much of its length a cut may run aside."""


BENT, ROUGH = 0.9, 0.005
"""Share of its rectangle below which a building's own footprint is told, and metres by which it is
told more simply."""


class Designed(NamedTuple):
    """What the designer built: boxes (n, 5) x, y, heading, width, depth; storeys (n,), heights
    (n,); the true footprints; how many buildings of the file lie outside the boundary."""

    boxes: Floats
    floors: NDArray[np.int64]
    heights: Floats
    footprints: tuple[shapely.Polygon, ...]
    outside: int


def compounds(path: Path, **more: Any) -> list[tuple[Site, Designed]]:
    """Every compound as a site (``more`` are further fields of it) and what stands on it."""
    return [_compound(row, more) for row in json.loads(Path(path).read_text())]


def asked(site: Site, designed: Designed, model: str) -> Site:
    """The site with the designer's buildings as wishes, all of one model: one for every size, and
    one for each building that is no rectangle (:func:`find_bent`), with its footprint."""
    sizes, bent = sizes_of(designed), find_bent(designed)
    counted = Counter(size for number, size in enumerate(sizes) if number not in bent)
    rows: list[dict[str, Any]] = [
        {"model": model, "count": count, "floors": floors, "size": (width, depth, STOREY * floors)}
        for (width, depth, floors), count in counted.items()
    ]
    for number, footprint in bent.items():
        floors = int(designed.floors[number])
        size = (*np.round(designed.boxes[number, 3:], 6).tolist(), STOREY * floors)
        row = {"name": name_bent(number), "footprint": footprint.tolist(), "size": size}
        rows.append({"model": model, "floors": floors, **row})
    return Site.model_validate(site.model_dump() | {"buildings": rows})


def name_bent(number: int) -> str:
    """What a building that is no rectangle is called.

    >>> name_bent(3)
    'building 3'
    """
    return f"building {number}"


def find_bent(designed: Designed) -> dict[int, Floats]:
    """The buildings that fill less than :data:`BENT` of their rectangle, by number, with their
    outlines (k, 2) in the frame of that."""
    found = {}
    for number, (shape, box) in enumerate(zip(designed.footprints, designed.boxes, strict=True)):
        if shape.geom_type == "Polygon" and shape.area < BENT * box[3] * box[4]:
            drawn = shapely.simplify(shapely.Polygon(shape.exterior), ROUGH)
            s, c = np.sin(box[2]), np.cos(box[2])
            turn = np.array([[s, c], [-c, s]])
            found[number] = (shapely.get_coordinates(drawn)[:-1] - box[:2]) @ turn
    return found


def sizes_of(designed: Designed) -> list[tuple[float, float, int]]:
    """Width and depth, up to the next 10 cm, and storeys of every building."""
    wide = np.round(np.ceil(designed.boxes[:, 3:] * 10.0 - 1e-6) / 10.0, 1)
    rows = zip(wide.tolist(), designed.floors.tolist(), strict=True)
    return [(width, depth, floors) for (width, depth), floors in rows]


def _compound(row: dict[str, Any], more: dict[str, Any]) -> tuple[Site, Designed]:
    site = Site.model_validate(
        {"id": row["_id"], "name": f"{row['city']} {row['_id'][-4:]}", "outline": row["boundary"]}
        | more
    )
    boundary = shapely.make_valid(shapely.Polygon(row["boundary"]))
    drawn = [
        (shapely.make_valid(shapely.Polygon(b["coords"])), b["floor"])
        for b in row["buildings"]
        if len(b["coords"]) > 2
    ]
    joined = _joined(drawn)
    inside = [(s, f) for s, f in joined if s.area > 1.0 and boundary.contains(s.centroid)]
    shapes, floors = tuple(s for s, _ in inside), np.array([f for _, f in inside], np.int64)
    boxes = np.array([_box(shape) for shape in shapes]).reshape(-1, 5)
    return site, Designed(
        boxes, floors, STOREY * floors.astype(float), shapes, len(joined) - len(inside)
    )


def _joined(drawn: list[tuple[shapely.Geometry, int]]) -> list[tuple[shapely.Geometry, int]]:
    """Shapes with storeys, those cut along a tile made one again: they have as many storeys and
    share a border that runs due north or east."""
    shapes, floors = np.array([s for s, _ in drawn], object), np.array([f for _, f in drawn])
    i, j = shapely.STRtree(shapes).query(shapes, predicate="dwithin", distance=TOUCH)
    pairs = (i < j) & (floors[i] == floors[j])
    i, j = i[pairs], j[pairs]
    shared = shapely.intersection(
        shapely.buffer(shapes[i], TOUCH), shapely.buffer(shapes[j], TOUCH)
    )
    boxes = shapely.bounds(shared).reshape(-1, 4)
    sides = boxes[:, 2:] - boxes[:, :2]
    cut = (sides.min(1) < 4.0 * TOUCH + TILT * sides.max(1)) & (sides.max(1) > LEAST)
    links = coo_array((np.ones(cut.sum()), (i[cut], j[cut])), shape=(len(shapes),) * 2)
    part = connected_components(links, directed=False)[1]
    found = []
    for k in range(part.max() + 1):
        pieces = shapes[part == k]
        whole = _one(pieces)
        kept = [whole] if _box(whole)[3] <= LONGEST else list(pieces)
        found += [(shape, int(floors[part == k][0])) for shape in kept]
    return found


def _one(shapes: NDArray[np.object_]) -> shapely.Geometry:
    wide = shapely.union_all(shapely.buffer(shapes, TOUCH, join_style="mitre"))
    return wide.buffer(-TOUCH, join_style="mitre") if len(shapes) > 1 else shapes[0]


def _box(shape: shapely.Geometry) -> Floats:
    """The least rectangle about a shape, its front the long side nearest to south."""
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shape))
    sides = np.diff(frame[:3], axis=0)
    lengths = np.hypot(*sides.T)
    long = int(np.argmax(lengths))
    heading = np.arctan2(sides[long][1], sides[long][0]) - np.pi / 2
    heading += np.pi * (np.sin(heading) > 1e-9)
    middle = frame[:4].mean(0)
    return np.array([*middle, heading, lengths[long], lengths[1 - long]])


def plans(path: Path, **more: Any) -> tuple[list[SitePlan], list[str]]:
    """The plans of all compounds, and what is wrong with those that have none."""
    found, faults = [], []
    for site, _ in compounds(path, **more):
        try:
            found.append(site_plan(site))
        except InputError as error:
            faults.append(str(error))
    return found, faults


def main() -> None:
    """Tells how many compounds make a plan, and what the designers built."""
    path = Path(sys.argv[1])
    found, faults = plans(path)
    print(f"{len(found)} plans, {len(faults)} faults")
    print("\n".join(faults))
    rows = [designed for _, designed in compounds(path)]
    built, outside = sum(len(row.boxes) for row in rows), sum(row.outside for row in rows)
    print(f"{built} buildings, {outside} outside")
    areas = np.array([plan.area for plan in found])
    print("ha:", np.percentile(areas / 1e4, [0, 25, 50, 75, 100]).round(2))
    print("blocks:", sorted(Counter(len(plan.blocks) for plan in found).items()))


if __name__ == "__main__":
    main()
