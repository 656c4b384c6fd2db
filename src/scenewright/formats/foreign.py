"""Files of other programs that are not read: each is named, with what makes it readable.

A row tells how a format is recognised, by what its files begin with or hold, else by suffix, and
the way from it to one that is read. The table is asked wherever a reader refuses.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from scenewright.core.errors import InputError

SEARCHED = 8 * 2**20
"""Bytes at the beginning of a file in which words are looked for."""
DRAW = (
    "draw its rooms in Sweet Home 3D (.sh3d), or write them as a brief (scenewright schema brief)"
)
TRACE = (
    "plans are read from lines (.dxf, .pdf, .svg), not from pixels: trace it in Sweet Home 3D "
    "(Plan, Import background image) and save that as .sh3d, or write its rooms as a brief "
    "(scenewright schema brief)"
)
MODEL = "give the brief of a place, and this file beside it: --catalog {file}"
IFC = "export it as .ifc, or its plan as .dxf"
CONVERT = "save it as .glb; models join a brief with --catalog MODEL.glb"
OGR = "ogr2ogr -t_srs EPSG:4326 map.geojson {file} makes a map that is read"
OSMIUM = "osmium export {file} -o map.geojson makes a map that is read"


class ForeignFormat(NamedTuple):
    """What files of a format are, in words after "is", and what to do with ``{file}``.

    They begin with one of ``begins`` and hold all of ``holds``; ``suffixes`` count only where
    nobody reads that suffix. ``read_as`` is the suffix under which such a file would be read."""

    what: str
    remedy: str
    suffixes: tuple[str, ...] = ()
    begins: tuple[bytes, ...] = ()
    holds: tuple[bytes, ...] = ()
    read_as: tuple[str, ...] = ()


FOREIGN = (
    ForeignFormat(
        "GeoJSON", "name it .geojson", holds=(b'"FeatureCollection"',), read_as=(".geojson",)
    ),
    ForeignFormat(
        "a city model (CityJSON)",
        "name it .city.json",
        holds=(b'"CityJSON"',),
        read_as=(".json", ".jsonl", ".cityjson"),
    ),
    ForeignFormat(
        "a ProcTHOR house",
        "name it .procthor.json",
        holds=(b'"roomType"', b'"floorPolygon"'),
        read_as=(".procthor.json",),
    ),
    ForeignFormat(
        "a Blueprint3D plan",
        DRAW,
        (".blueprint3d",),
        holds=(b'"floorplan"', b'"corners"', b'"walls"'),
    ),
    ForeignFormat(
        "a plan of floorspace.js",
        DRAW,
        holds=(b'"stories"', b'"floor_to_ceiling_height"', b'"spaces"'),
    ),
    ForeignFormat(
        "a scan of RoomPlan",
        DRAW,
        holds=(b'"walls"', b'"openings"', b'"objects"', b'"dimensions"', b'"transform"'),
    ),
    ForeignFormat(
        "a plan of react-planner",
        DRAW,
        holds=(b'"layers"', b'"vertices"', b'"areas"', b'"prototype"'),
    ),
    ForeignFormat(
        "a Honeybee model", DRAW, (".hbjson", ".dfjson"), holds=(b'"Room', b"PropertiesAbridged")
    ),
    ForeignFormat(
        "a scene of the Pascal editor", DRAW, holds=(b'"scene"', b'"nodes"', b'"parentId"')
    ),
    ForeignFormat(
        "a scene of 3D-FRONT", DRAW, holds=(b'"design_version"', b'"furniture"', b'"scene"')
    ),
    ForeignFormat("a plan of HouseExpo", DRAW, holds=(b'"room_category"', b'"verts"')),
    ForeignFormat("a glTF model", MODEL, (".gltf", ".glb"), holds=(b'"asset"', b'"accessors"')),
    ForeignFormat("a glTF model", MODEL, begins=(b"glTF",)),
    ForeignFormat(
        "an IFC building model",
        "name it .ifc",
        begins=(b"ISO-10303-21",),
        holds=(b"IFC",),
        read_as=(".ifc",),
    ),
    ForeignFormat("an IFC building model as XML", IFC, (".ifcxml",), holds=(b"<ifcXML",)),
    ForeignFormat("a STEP model", CONVERT, (".step", ".stp"), (b"ISO-10303-21",)),
    ForeignFormat(
        "a DWG drawing",
        "save it as .dxf in its program, or convert it with the ODA File Converter",
        (".dwg",),
        (b"AC10",),
    ),
    ForeignFormat(
        "a DXF drawing",
        "name it .dxf",
        holds=(b"SECTION", b"ENTITIES", b"ENDSEC", b"EOF"),
        read_as=(".dxf",),
    ),
    ForeignFormat(
        "a SketchUp model", CONVERT, (".skp",), (b"\xff\xfe\xff\x0eS\x00k\x00e\x00t\x00c\x00h",)
    ),
    ForeignFormat("a Revit model", IFC, (".rvt", ".rfa")),
    ForeignFormat("an ArchiCAD plan", IFC, (".pln", ".pla")),
    ForeignFormat(
        "a USD scene", CONVERT, (".usd", ".usda", ".usdc", ".usdz"), (b"PXR-USDC", b"#usda")
    ),
    ForeignFormat("a USD scene", CONVERT, begins=(b"PK",), holds=(b".usdc",)),
    ForeignFormat("changes of OpenStreetMap", OSMIUM, (".osc", ".osc.gz", ".o5m")),
    ForeignFormat(
        "OpenStreetMap data", "name it .osm", holds=(b"<osm ", b"<node "), read_as=(".osm", ".zip")
    ),
    ForeignFormat(
        "OpenStreetMap data", "name it .osm.pbf", holds=(b"OSMHeader",), read_as=(".pbf",)
    ),
    ForeignFormat(
        "a CityGML model",
        "citygml-tools to-cityjson {file} makes a city model that is read",
        (".citygml",),
        holds=(b"opengis.net/citygml",),
    ),
    ForeignFormat("an IndoorGML map", DRAW, holds=(b"opengis.net/indoorgml",)),
    ForeignFormat("a gbXML building model", DRAW, (".gbxml",), holds=(b"<gbXML",)),
    ForeignFormat("a KML map", "name it .kml", holds=(b"<kml",), read_as=(".kml", ".kmz", ".zip")),
    ForeignFormat("a GPX track", OGR, (".gpx",), holds=(b"<gpx",)),
    ForeignFormat("a GML map", OGR, (".gml",), holds=(b"opengis.net/gml",)),
    ForeignFormat(
        "a GeoPackage",
        "name it .gpkg",
        begins=(b"SQLite format 3",),
        holds=(b"gpkg_",),
        read_as=(".gpkg",),
    ),
    ForeignFormat("a part of a shapefile", "give the .shp", (".shx", ".dbf")),
    ForeignFormat(
        "a shapefile", "name it .shp", begins=(b"\0\0\x27\x0a",), read_as=(".shp", ".shx")
    ),
    ForeignFormat(
        "a zipped shapefile", "name it .zip", begins=(b"PK",), holds=(b".shp",), read_as=(".zip",)
    ),
    ForeignFormat("a FlatGeobuf map", OGR, (".fgb",), (b"fgb",)),
    ForeignFormat("a GeoParquet map", OGR, (".parquet", ".geoparquet"), (b"PAR1",)),
    ForeignFormat("a TopoJSON map", OGR, (".topojson",), holds=(b'"Topology"', b'"arcs"')),
    ForeignFormat("a Sweet Home 3D furniture library", MODEL, (".sh3f",)),
    ForeignFormat(
        "a home of Sweet Home 3D",
        "name it .sh3d",
        begins=(b"PK",),
        holds=(b"Home",),
        read_as=(".sh3d",),
    ),
    ForeignFormat("a model", MODEL, (".obj", ".stl")),
    ForeignFormat(
        "a 3D model",
        CONVERT,
        (".fbx", ".dae", ".3ds", ".3dm", ".3mf", ".blend", ".max", ".ply", ".c4d"),
        (b"Kaydara FBX", b"BLENDER", b"ply\n"),
    ),
    ForeignFormat("a PDF document", "name it .pdf", begins=(b"%PDF",), read_as=(".pdf",)),
    ForeignFormat(
        "a picture",
        TRACE,
        (".png", ".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp"),
        (b"\x89PNG", b"\xff\xd8\xff", b"GIF8", b"BM", b"II*\0", b"MM\0*"),
    ),
    ForeignFormat("a drawing in SVG", "name it .svg", holds=(b"<svg",), read_as=(".svg",)),
    ForeignFormat(
        "compressed with gzip", "gunzip {file} first", begins=(b"\x1f\x8b",), read_as=(".osm.gz",)
    ),
    ForeignFormat(
        "an archive",
        "unpack it and give a file in it",
        (".7z", ".rar", ".tar", ".tgz"),
        (b"PK", b"7z\xbc\xaf", b"Rar!"),
        read_as=(".sh3d", ".zip", ".kmz", ".ifczip"),
    ),
)


def find_format(path: Path, by_suffix: bool = False) -> ForeignFormat | None:
    """The format of another program that a file is in, by its content, or ``by_suffix``; none
    where it is read under the name it has."""
    head = _head(path)
    name = path.name.lower()
    for row in FOREIGN:
        known = row.begins or row.holds
        content = known and head.startswith(row.begins or b"") and all(w in head for w in row.holds)
        suffix = by_suffix and name.endswith(row.suffixes)
        if content or suffix:
            return None if row.read_as and name.endswith(row.read_as) else row
    return None


def name_foreign(path: Path, refusal: InputError, by_suffix: bool = False) -> InputError:
    """The refusal of a file: if it is one of another program that says so, else as it was."""
    row = find_format(path, by_suffix)
    if row is None:
        return refusal
    file = path.name if " " not in path.name else f"'{path.name}'"
    what = row.what if row.read_as else f"{row.what}, which is not read"
    return InputError(f"is {what}", row.remedy.format(file=file), file=str(path))


def _head(path: Path) -> bytes:
    """The beginning of a file, nothing if there is no such plain file."""
    if not path.is_file():
        return b""
    try:
        with path.open("rb") as file:
            return file.read(SEARCHED)
    except OSError:
        return b""
