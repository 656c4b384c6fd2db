"""The kinds of map files that are read, each known by its content whatever it is called."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

from scenewright.core.errors import InputError

HEAD = 64 * 1024
"""Bytes at the beginning of a file by which it is known."""


class MapKind(NamedTuple):
    """A kind of map file: its ``name``, the ``suffix`` by which GDAL knows it, whether a file is
    one by its first bytes, and the element that its XML begins with (empty: it is no XML)."""

    name: str
    suffix: str
    holds: Callable[[bytes], bool]
    root: str = ""


def _is_pbf(head: bytes) -> bool:
    """Whether a file begins with the length of a header block and its name, as in OSM PBF."""
    return head[:2] == b"\0\0" and head[4:6] == b"\x0a\x09" and head[6:15] == b"OSMHeader"


KINDS = (
    MapKind("GeoPackage", ".gpkg", lambda head: head.startswith(b"SQLite format 3\0")),
    MapKind("shapefile", ".shp", lambda head: head.startswith(b"\0\0\x27\x0a")),
    MapKind("OpenStreetMap PBF", ".pbf", _is_pbf),
    MapKind("OpenStreetMap XML", ".osm", lambda head: b"<osm" in head, "osm"),
    MapKind("KML", ".kml", lambda head: b"<kml" in head or b":kml" in head, "kml"),
)
PACKED = (".osm.gz", ".osm.bz2", ".kmz", ".zip")
BESIDE = (".shx", ".dbf", ".prj", ".cpg")
"""Files that lie beside a shapefile under the same name."""


def kind_by_suffix(name: str) -> MapKind | None:
    """The kind of a file by the end of its name.

    >>> kind_by_suffix("town.OSM.pbf").name
    'OpenStreetMap PBF'
    """
    return next((kind for kind in KINDS if name.lower().endswith(kind.suffix)), None)


def is_map(name: str) -> bool:
    """Whether a file is a map of GIS or of OpenStreetMap by the end of its name.

    >>> is_map("town.GPKG"), is_map("town.osm.gz"), is_map("town.geojson")
    (True, True, False)
    """
    return kind_by_suffix(name) is not None or name.lower().endswith(PACKED)


def check_content(path: Path, kind: MapKind) -> None:
    """Raise :class:`InputError` unless a file is what it is called: no parser is given anything
    else. XML may declare no document type, so nothing in it can expand or lead elsewhere."""
    with path.open("rb") as stream:
        head = stream.read(HEAD)
    if not head:
        raise InputError("is empty", "export it again")
    if not kind.holds(head):
        raise InputError(f"is no {kind.name} file, though it is called one", "export it again")
    if kind.root:
        _check_root(head, kind)


def _check_root(head: bytes, kind: MapKind) -> None:
    """Raise :class:`InputError` unless XML begins with the element of its kind."""
    found: list[str] = []
    parser = expat.ParserCreate()
    parser.buffer_text = True
    parser.StartElementHandler = lambda name, _: found.append(name)
    parser.StartDoctypeDeclHandler = lambda *_: found.append("!DOCTYPE")
    try:
        parser.Parse(head, False)
    except expat.ExpatError as error:
        if not found:
            where = f"line {error.lineno}, column {error.offset + 1}"
            reason = expat.errors.messages.get(error.code, "damaged")
            raise InputError(f"is broken XML: {reason}", "export it again", place=where) from None
    except (LookupError, ValueError):  # of a coding that Python does not know, or has no bytes of
        raise InputError("has an unknown encoding", "save it as UTF-8") from None
    if "!DOCTYPE" in found:
        raise InputError("declares a document type, which no map needs", "export it again")
    if not found or found[0].rpartition(":")[2] != kind.root:
        first = found[0][:40] if found else "none"
        raise InputError(f"is no {kind.name}: its first element is '{first}'", "export it again")
