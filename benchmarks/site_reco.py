"""Real residential compounds: the ReCo sample (91 compounds, 2,547 buildings, CC BY-NC-SA 4.0).

    python benchmarks/site_reco.py PATH/reco_sample.json

Chen et al. 2022, "ReCo: A Dataset for Residential Community Layout Planning". Boundaries and
footprints in metres, storeys. Footprints become their least rectangles, the front of each the
long side nearest to south, three metres a storey; what lies outside the boundary is left out.
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

from scenewright.brief_site import Site
from scenewright.errors import InputError
from scenewright.site_plan import SitePlan, site_plan

Floats = NDArray[np.float64]
STOREY = 3.0


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
    """The site with the designer's buildings as wishes: one for every size, all of one model."""
    counted = Counter(sizes_of(designed))
    buildings = [
        {"model": model, "count": count, "floors": floors,
         "size": (width, depth, STOREY * floors)}
        for (width, depth, floors), count in counted.items()
    ]  # fmt: skip
    return Site.model_validate(site.model_dump() | {"buildings": buildings})


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
    drawn = [(shapely.make_valid(shapely.Polygon(b["coords"])), b["floor"])
             for b in row["buildings"] if len(b["coords"]) > 2]  # fmt: skip
    inside = [(s, f) for s, f in drawn if s.area > 1.0 and boundary.contains(s.centroid)]
    shapes, floors = tuple(s for s, _ in inside), np.array([f for _, f in inside], np.int64)
    boxes = np.array([_box(shape) for shape in shapes]).reshape(-1, 5)
    return site, Designed(
        boxes, floors, STOREY * floors.astype(float), shapes, len(drawn) - len(inside)
    )


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
