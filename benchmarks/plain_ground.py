"""A plain referee of sites, villages and extensions: what is grossly wrong, from the saved JSON.

Like :mod:`.plain_rooms` it shares nothing with the product's referee and has wide tolerances:
buildings on each other, outside, on roads and lanes, before doors, out of reach, and what the
brief says stands or asks for.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import shapely
from scipy import ndimage

from benchmarks.plain_rooms import Document, Fault, is_thick, outline

GROSS, ROAD = 0.05, 0.1
CELL = 0.5
"""Side of a cell of the raster on which one walks, in metres."""


def faults(document: Document) -> set[Fault]:
    """All that is grossly wrong with a solution of open ground."""
    brief = document["brief"]
    pieces = [p for p in document["pieces"] if p["category"] == "building" and min(p["size"]) > 0]
    shapes = [outline(piece) for piece in pieces]
    found = {*_overlaps(pieces, shapes)}
    for area in brief.get("sites") or brief.get("blocks") or brief["areas"]:
        rows = [k for k, piece in enumerate(pieces) if piece["space"] == area["id"]]
        here, mine = [pieces[k] for k in rows], [shapes[k] for k in rows]
        floor = shapely.Polygon(area["outline"], area.get("holes") or [])
        found |= {
            ("outside", p["id"]) for p, s in zip(here, mine, strict=True) if _leaves(s, floor)
        }
        found |= {("ground", p["id"]) for p in here if abs(p["pose"][2]) > GROSS}
        ways = [*(area.get("roads") or []), *brief.get("lanes", [])]
        found |= {*_on_ways(here, mine, ways), *_uncounted(document, area, here)}
        found |= {*_changed(area, here)}
        if "setback" in area:
            found |= {*_too_near(area, here, mine, floor), *_fire(area, here, mine, floor)}
        if "classes" in area:
            found |= {*_doors(here, mine), *_cut_off(brief["lanes"], here, mine, floor)}
    return found | {*_sources(brief, pieces, shapes)}


def _overlaps(pieces: list[Document], shapes: list[Any]) -> Iterator[Fault]:
    """Pairs that share ground, but for two of the source."""
    for a, b in shapely.STRtree(shapes).query(shapes, predicate="intersects").T:
        old = pieces[a]["space"] == pieces[b]["space"] == "source"
        if a < b and not old and is_thick(shapes[a] & shapes[b], GROSS):
            yield ("overlap", *sorted((pieces[a]["id"], pieces[b]["id"])))


def _leaves(shape: Any, floor: Any) -> bool:
    return not shapely.difference(shape, floor.buffer(GROSS)).is_empty


def _on_ways(here: list[Document], mine: list[Any], ways: list[Document]) -> Iterator[Fault]:
    """Buildings on a road or lane."""
    for number, way in enumerate(ways):
        strip = shapely.LineString(way["line"]).buffer(way["width"] / 2, cap_style="flat")
        for piece, shape in zip(here, mine, strict=True):
            if is_thick(shape & strip, ROAD):
                yield ("way", piece["id"], str(number))


def _uncounted(document: Document, area: Document, here: list[Document]) -> Iterator[Fault]:
    """Fewer or more buildings than asked for, where nothing was left out."""
    marks = {mark["id"] for mark in area.get("landmarks", [])}
    own = [p for p in here if p["id"].rpartition("/")[2] not in marks]
    silent = any(out["space"] == area["id"] for out in document["left_out"])
    asked = area.get("count")
    if area.get("buildings"):
        asked = sum(row["count"] for row in area["buildings"])
    if asked is not None and asked != len(own) and not silent:
        yield ("count", area["id"])
    if not own and not silent:
        yield ("empty", area["id"])


def _changed(area: Document, here: list[Document]) -> Iterator[Fault]:
    """Landmarks and buildings that stay that are not where the brief has them."""
    there = {piece["id"]: piece for piece in here}
    marks = [row for row in area.get("landmarks", []) if row["at"]]
    names = [f"{area['id']}/{row['id']}" for row in marks]
    for name, row in [*zip(names, marks, strict=True), *((r["id"], r) for r in area["fixed"])]:
        piece = there.get(name)
        apart = np.abs(np.subtract(piece["pose"][:2], row["at"])).max() if piece else np.inf
        if apart > GROSS:
            yield ("given", name)


def _sources(brief: Document, pieces: list[Document], shapes: list[Any]) -> Iterator[Fault]:
    """Drawn buildings of a source that stands which are not there, and others among them."""
    drawn = [
        shapely.Polygon(row["outline"])
        for scene in brief.get("sources", [])
        for row in (scene["buildings"] if scene["stands"] is not False else ())
    ]
    old = [k for k, piece in enumerate(pieces) if piece["space"] == "source"]
    if not old or not drawn:
        yield from (("source", "none") for _ in drawn[:1])
        return
    tree = shapely.STRtree([shapes[k] for k in old])
    for number, shape in enumerate(drawn):
        near = [shapes[old[k]] for k in tree.query(shape)]
        if not any((shape & one).area > 0.9 * (shape | one).area for one in near):
            yield ("source", str(number))
    if len(old) > len(drawn):
        yield ("source", "more")


def _too_near(site: Document, here: list[Document], mine: list[Any], floor: Any) -> Iterator[Fault]:
    """Buildings of a site nearer to its border, its roads or each other than asked for."""
    marks = {f"{site['id']}/{mark['id']}" for mark in site["landmarks"]}
    border = floor.boundary
    for k, (piece, shape) in enumerate(zip(here, mine, strict=True)):
        if piece["id"] in marks:
            continue
        if shape.distance(border) < site["setback"] - GROSS and floor.covers(shape):
            yield ("setback", piece["id"])
        for j, other in enumerate(mine):
            if (j > k or here[j]["id"] in marks) and 0 < shape.distance(other) < (
                site["spacing"] - GROSS
            ):
                yield ("spacing", *sorted((piece["id"], here[j]["id"])))


def _front(piece: Document, ahead: float) -> np.ndarray:
    """The point so far before the middle of a front: of the sides that lie farthest ahead."""
    x, y, _, heading = piece["pose"]
    ring = np.array(piece.get("footprint") or [[0.0, piece["size"][1] / 2]])
    front = ring[np.isclose(ring[:, 1], ring[:, 1].max())]
    ahead_of, right = front[0, 1] + ahead, front[:, 0].mean()
    out = np.array([np.cos(heading), np.sin(heading)])
    return np.array([x, y]) + ahead_of * out + right * np.array([out[1], -out[0]])


def _doors(here: list[Document], mine: list[Any]) -> Iterator[Fault]:
    """Houses that stand right before the door of another."""
    for k, piece in enumerate(here):
        court = shapely.LineString([_front(piece, 0.1), _front(piece, 0.8)]).buffer(0.3)
        for j, shape in enumerate(mine):
            if j != k and is_thick(shape & court, 2 * GROSS):
                yield ("door", piece["id"], here[j]["id"])


def _flood(ground: Any, solid: Any, start: Any, radius: float) -> tuple[np.ndarray, np.ndarray]:
    """The middles (n, 2) of the cells of some ground that one comes to from a ``start``, ``radius``
    off all that is solid, and those of all cells."""
    west, south, east, north = ground.bounds
    x, y = np.arange(west - CELL, east + CELL, CELL), np.arange(south - CELL, north + CELL, CELL)
    grid = np.meshgrid(x, y)
    inside = [np.asarray(shapely.contains_xy(s, *grid)) for s in (ground, solid, start)]
    open_ = ndimage.distance_transform_edt(inside[0] & ~inside[1]) * CELL >= radius
    label, _ = ndimage.label(open_, np.ones((3, 3)))
    seen = np.unique(label[inside[2] & open_])
    points = np.stack(grid, -1)
    return points[np.isin(label, seen[seen > 0])], points[inside[0]]


def _fire(site: Document, here: list[Document], mine: list[Any], floor: Any) -> Iterator[Fault]:
    """Buildings of a site that no way comes near to which is a metre narrower than asked for."""
    roads = [shapely.LineString(r["line"]).buffer(r["width"] / 2 + 1.0) for r in site["roads"]]
    start = shapely.union_all(roads) if roads else floor
    ground = shapely.union_all([floor.buffer(1.0), *roads])
    radius = max(site["fire_access"] / 2 - 1.0, CELL)
    reached, _ = _flood(ground, shapely.union_all(mine), start, radius)
    tree = shapely.STRtree(shapely.points(reached))
    for piece, shape in zip(here, mine, strict=True):
        if not len(tree.query(shape, predicate="dwithin", distance=6.0)):
            yield ("reach", piece["id"])


def _cut_off(
    lanes: list[Document], here: list[Document], mine: list[Any], floor: Any
) -> Iterator[Fault]:
    """Houses of a block to whose door no way leads that is half as wide as asked for."""
    strips = [shapely.LineString(r["line"]).buffer(r["width"] / 2 + 6.0) for r in lanes]
    start = shapely.union_all(strips) if strips else floor.boundary.buffer(2.0)
    reached, _ = _flood(floor.buffer(1.0), shapely.union_all(mine), start, CELL / 2)
    tree = shapely.STRtree(shapely.points(reached))
    for piece in here:
        spot = shapely.Point(_front(piece, 0.5))
        if not len(tree.query(spot, predicate="dwithin", distance=2.0)):
            yield ("reach", piece["id"])
