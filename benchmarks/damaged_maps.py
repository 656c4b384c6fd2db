"""Sound maps of one quarter in every format of GIS, to be damaged: a site, two houses, a street."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.damage import Draw, damage_bytes, damage_database, damage_json, damage_zip, zipped
from benchmarks.damage_structure import BZIP, GZIP, damage_json_lines, damage_packed, damage_xml
from benchmarks.damaged_samples import CITY, CITY_LINES, IMDF, INDOOR, LAND
from benchmarks.damaged_uses import DamagedFormat, arrange_with, given, plain, plan_site

SHARE = 500
"""Files of each kind."""
PACKINGS = {".osm.gz": GZIP, ".osm.bz2": BZIP}
PLAIN_PBF = "pbf,pbf_compression=none"
"""Not packed: what is damaged is the content and not its checksum."""
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
        if suffix in PACKINGS:
            return PACKINGS[suffix][1](_osm(folder, ".osm"))
        if suffix == ".kmz":
            _write(folder / "doc.kml", tuple(LAYERS))
            return zipped({"doc.kml": (folder / "doc.kml").read_bytes()})
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
    with osmium.SimpleWriter(osmium.io.File(str(folder / "sound.osm.pbf"), PLAIN_PBF)) as writer:
        for one in osmium.FileProcessor(str(folder / "sound.osm")):
            writer.add(one)
    return (folder / "sound.osm.pbf").read_bytes()


def _damage_seldom(data: bytes, draw: Draw, path: Path) -> bytes:
    """A database of a map damaged by its cells and tables, or its bytes."""
    return damage_database(data, draw, path) if draw.random() < 0.7 else damage_bytes(data, draw)


def _row(suffix: str, damage: Any, share: int = SHARE) -> DamagedFormat:
    return DamagedFormat(f"maps as {suffix}", share, suffix, sound_map(suffix), damage, plan_site)


_JSON = plain(damage_json)
MAP_FORMATS = (
    _row(".gpkg", _damage_seldom),
    _row(".shp", plain(damage_bytes)),
    _row(".zip", plain(damage_zip(damage_bytes))),
    _row(".kml", plain(damage_xml)),
    _row(".kmz", plain(damage_zip(damage_xml))),
    _row(".osm", plain(damage_xml)),
    _row(".osm.gz", plain(damage_packed(damage_xml, GZIP)), 60),
    _row(".osm.bz2", plain(damage_packed(damage_xml, BZIP)), 60),
    _row(".pbf", plain(damage_bytes)),
    DamagedFormat("indoor maps", 120, ".geojson", given(INDOOR), _JSON, arrange_with(10)),
    DamagedFormat("IMDF", SHARE, ".geojson", given(IMDF), _JSON, arrange_with(10)),
    DamagedFormat("maps", SHARE, ".geojson", given(LAND), _JSON, arrange_with(10)),
    DamagedFormat("city sites", 120, ".city.json", given(CITY), _JSON, arrange_with(10)),
    DamagedFormat(
        "CityJSONSeq",
        SHARE,
        ".city.jsonl",
        given(CITY_LINES),
        plain(damage_json_lines),
        arrange_with(10),
    ),
    DamagedFormat(
        "CityJSONSeq as .jsonl",
        60,
        ".jsonl",
        given(CITY_LINES),
        plain(damage_json_lines),
        arrange_with(10),
    ),
)
