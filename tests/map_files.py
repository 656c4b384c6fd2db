"""Small maps of one quarter in every format that is read, in longitude and latitude or UTM 32."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

UTM = "EPSG:25832"
EAST, NORTH = 650_000.0, 5_480_000.0
Ring = list[tuple[float, float]]


def box(x: float, y: float, width: float, depth: float) -> Ring:
    ring = [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth), (x, y)]
    return [(EAST + a, NORTH + b) for a, b in ring]


SITE = box(0, 0, 120, 90)
HOUSES = [box(10, 10, 12, 9), box(40, 12, 10, 10), box(80, 60, 14, 9)]
STREET = [(EAST - 30, NORTH - 8), (EAST + 150, NORTH - 8)]
PLOTS = [box(0, 0, 60, 90), box(60, 0, 60, 90)]
LAYERS: dict[str, tuple[str, list[Any], dict[str, list[Any]]]] = {
    "Baufeld": ("Polygon", [[SITE]], {}),
    "Gebäude": ("Polygon", [[ring] for ring in HOUSES], {"HOEHE": [9.5, 6.0, None]}),
    "Straßen": ("LineString", [STREET], {"name": ["Hauptstraße"]}),
    "Flurstücke": ("Polygon", [[ring] for ring in PLOTS], {"area": [5400.0, 5400.0]}),
    "Höhenlinien": ("LineString", [[(x, y + 40) for x, y in STREET]], {"elevation": [312.0]}),
}
"""Layers of an office in Germany: shapes, and columns."""
FEATURES = sum(len(shapes) for _, shapes, _ in LAYERS.values())


def write_layers(
    path: Path, crs: str | None = UTM, only: tuple[str, ...] = (), site: str = ""
) -> Path:
    """The layers as one file, or as a shapefile of the first of them."""
    for name, (kind, shapes, columns) in LAYERS.items():
        if only and name not in only:
            continue
        columns = columns | ({"site": [site]} if site and name == "Baufeld" else {})
        write_layer(path, name, kind, shapes, columns, crs)
    return path


def write_layer(
    path: Path, name: str, kind: str, shapes: list[Any], columns: dict[str, Any], crs: str | None
) -> Path:
    """One layer in a file, beside those that it has."""
    import shapely
    from pyogrio.raw import write

    typed = {
        key: np.array(values, object if isinstance(values[0], str) else float)
        for key, values in columns.items()
    }
    geometries = [shapely.from_geojson(geometry(kind, shape)) for shape in shapes]
    write(
        path,
        shapely.to_wkb(geometries),
        list(typed.values()),
        list(typed),
        layer=name if path.suffix != ".shp" else None,
        driver={".gpkg": "GPKG", ".shp": "ESRI Shapefile", ".kml": "LIBKML"}[path.suffix],
        geometry_type=kind,
        crs=crs,
        append=path.suffix != ".shp" and path.exists(),
    )
    return path


def geometry(kind: str, coordinates: Any) -> str:
    return json.dumps({"type": kind, "coordinates": coordinates})


def zip_shapefiles(path: Path, folder: Path) -> Path:
    """All layers as shapefiles in one archive, in a folder within it."""
    with zipfile.ZipFile(path, "w") as archive:
        for number, name in enumerate(LAYERS):
            own = folder / str(number)
            own.mkdir()
            write_layers(own / f"{name}.shp", only=(name,))
            for file in sorted(own.iterdir()):
                archive.write(file, f"Lieferung/{file.name}")
    return path


def write_rows(path: Path) -> Path:
    """A layer of two rows of five like houses."""
    houses = [box(20.0 * k, 40.0 * row, 10, 8) for row in range(2) for k in range(5)]
    return write_layer(path, "houses", "Polygon", [[ring] for ring in houses], {}, UTM)


def to_degrees(ring: Any) -> list[tuple[float, float]]:
    from scenewright.core.reference_system import system_of
    from scenewright.core.reference_system import to_degrees as turn

    system = system_of(UTM)
    assert system is not None
    return [(x, y) for x, y in turn(system, np.array(ring, float)).tolist()]


def osm_xml() -> str:
    """The quarter as OpenStreetMap has it, with what an extract cuts off."""
    ways = [({"landuse": "residential", "site": "yes"}, SITE), ({"highway": "residential"}, STREET)]
    ways += [({"building": "yes", "building:levels": "2"}, ring) for ring in HOUSES]
    nodes: dict[tuple[float, float], int] = {}
    rows = []
    for number, (tags, ring) in enumerate(ways, 1):
        refs = [nodes.setdefault(place, len(nodes) + 1) for place in to_degrees(ring)]
        rows.append(_way(number, tags, refs))
    rows.append(_way(90, {"building": "yes"}, [7001, 7002, 7003, 7001]))
    rows.append(_way(91, {"highway": "service"}, [1, 2, 7004]))
    member = '<member type="way" ref="1" role=""/><tag k="type" v="route"/>'
    rows.append(f'<relation id="1">{member}</relation>')
    drawn = [f'<node id="{n}" lon="{x:.9f}" lat="{y:.9f}"/>' for (x, y), n in nodes.items()]
    drawn.append('<node id="8000" lon="11.0700" lat="49.4500"><tag k="natural" v="tree"/></node>')
    body = "\n".join([*drawn, *rows])
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<osm version="0.6">\n{body}\n</osm>\n'


OSM_FEATURES = 9
"""Objects with tags: seven ways, a relation and a node."""


def _way(number: int, tags: dict[str, str], refs: list[int]) -> str:
    inner = "".join(f'<nd ref="{ref}"/>' for ref in refs)
    inner += "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
    return f'<way id="{number}">{inner}</way>'


def write_pbf(source: Path, path: Path) -> Path:
    """A file of OpenStreetMap again as PBF."""
    import osmium

    with osmium.SimpleWriter(str(path)) as writer:
        for one in osmium.FileProcessor(str(source)):
            writer.add(one)
    return path
