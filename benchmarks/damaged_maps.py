"""Sound maps of one quarter in every format of GIS, to be damaged: a site, two houses, a street."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.damage import Damage, damage_bytes, damage_text, damage_zip, zipped

MAPS: dict[str, Damage] = {
    ".gpkg": damage_bytes,
    ".shp": damage_bytes,
    ".zip": damage_zip(damage_bytes),
    ".kml": damage_text,
    ".osm": damage_text,
    ".pbf": damage_bytes,
}
"""How files of a suffix are damaged."""
DRIVERS = {".gpkg": "GPKG", ".shp": "ESRI Shapefile", ".kml": "LIBKML"}
LAYERS: dict[str, tuple[str, list[Any]]] = {
    "site": ("Polygon", [[[11.57, 48.14, 0.002]]]),
    "buildings": ("Polygon", [[[11.5705, 48.1403, 0.0002]], [[11.5712, 48.1406, 0.0003]]]),
    "roads": ("LineString", [[[11.5695, 48.1399], [11.573, 48.1399]]]),
}


def sound_map(suffix: str) -> Callable[[Path], bytes]:
    """What makes the content of a sound map of a suffix, given a folder for spare files."""

    def make(folder: Path) -> bytes:
        if suffix in (".osm", ".pbf"):
            return _osm(folder, suffix)
        if suffix == ".zip":
            for name in LAYERS:
                _write(folder / f"{name}.shp", (name,))
            parts = sorted(file for file in folder.iterdir() if file.stem in LAYERS)
            return zipped({file.name: file.read_bytes() for file in parts})
        path = folder / f"buildings{suffix}"
        _write(path, ("site",) if suffix == ".shp" else tuple(LAYERS))
        return path.read_bytes()

    return make


def _write(path: Path, names: tuple[str, ...]) -> None:
    """Layers in a file, as GDAL writes it."""
    import shapely
    from pyogrio.raw import write

    for name in names:
        kind, shapes = LAYERS[name]
        drawn = [shapely.from_geojson(json.dumps(_geometry(kind, shape))) for shape in shapes]
        write(
            path,
            shapely.to_wkb(drawn),
            [np.array([name] * len(drawn), object)],
            ["kind"],
            layer=None if path.suffix == ".shp" else name,
            driver=DRIVERS[path.suffix],
            geometry_type=kind,
            crs="EPSG:4326",
            append=path.suffix != ".shp" and path.exists(),
        )


def _geometry(kind: str, shape: Any) -> dict[str, Any]:
    coordinates = [_ring(*shape[0])] if kind == "Polygon" else shape
    return {"type": kind, "coordinates": coordinates}


def _ring(west: float, south: float, side: float) -> list[list[float]]:
    east, north = west + side, south + side
    return [[west, south], [east, south], [east, north], [west, north], [west, south]]


def _osm(folder: Path, suffix: str) -> bytes:
    """The layers as OpenStreetMap has them."""
    nodes, ways = list[str](), list[str]()
    tags = {"site": "site", "buildings": "building", "roads": "highway"}
    for name, (kind, shapes) in LAYERS.items():
        for shape in shapes:
            line = _ring(*shape[0])[:-1] if kind == "Polygon" else shape
            ids = list(range(len(nodes) + 1, len(nodes) + 1 + len(line)))
            nodes += [
                f'<node id="{n}" lon="{x}" lat="{y}"/>' for n, (x, y) in zip(ids, line, strict=True)
            ]
            ids += ids[:1] if kind == "Polygon" else []
            drawn = "".join(f'<nd ref="{n}"/>' for n in ids)
            value = "residential" if kind == "LineString" else "yes"
            tag = f'<tag k="{tags[name]}" v="{value}"/>'
            ways.append(f'<way id="{len(ways) + 1}">{drawn}{tag}</way>')
    text = "<?xml version='1.0'?>\n<osm version='0.6'>" + "\n".join([*nodes, *ways]) + "</osm>"
    if suffix == ".osm":
        return text.encode()
    import osmium

    (folder / "sound.osm").write_text(text, encoding="utf-8")
    with osmium.SimpleWriter(str(folder / "sound.osm.pbf")) as writer:
        for one in osmium.FileProcessor(str(folder / "sound.osm")):
            writer.add(one)
    return (folder / "sound.osm.pbf").read_bytes()
