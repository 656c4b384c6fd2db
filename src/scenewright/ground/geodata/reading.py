"""A map in a file of GIS or of OpenStreetMap as features, as a GeoJSON file is read."""

from __future__ import annotations

import re
import tempfile
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from scenewright.core.errors import InputError
from scenewright.core.extras import install_line
from scenewright.core.isolated_reading import Allowance, read_apart
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.ground.geodata.extract import OSM_FILES
from scenewright.ground.geodata.kinds import kind_by_suffix
from scenewright.ground.geodata.layer_tags import tags_of_row
from scenewright.ground.geodata.unpacking import unpack
from scenewright.ground.maps.features import Collection, collection

ALLOWANCE = Allowance(1024, 0, 60, "export it again, or cut the place out of it")
SHAPES = {"Polygon": "polygon", "LineString": "line", "Point": "point"}


def load_map(path: Path, options: MapOptions = AS_IT_IS) -> Collection:
    """The features of a map file, of the layers that the ``options`` name. Raises
    :class:`InputError` for whatever cannot be read, or where the package for it is missing."""
    with tempfile.TemporaryDirectory(prefix="scenewright-") as folder:
        files = unpack(path, Path(folder))
        _check_installed(files)
        order: dict[str, Any] = {"files": [str(file) for file in files], "turn": not options.crs}
        order["layers"] = list(options.layers)
        document = read_apart("scenewright.ground.geodata.extract", path, ALLOWANCE, order)
    _check_not_empty(document)
    document["features"] = [_with_tags(row) for row in document["features"]]
    kinds = dict.fromkeys(kind.name for file in files if (kind := kind_by_suffix(file.name)))
    return collection(document)._replace(format=" and ".join(kinds), plane=not document["crs"])


def _check_installed(files: tuple[Path, ...]) -> None:
    osm = all(file.suffix in OSM_FILES for file in files)
    package = "osmium" if osm else "pyogrio"
    if find_spec(package) is None:
        raise InputError(f"this format needs the package '{package}'", install_line(package))


def _check_not_empty(document: dict[str, Any]) -> None:
    if not document["features"]:
        names = ", ".join(repr(name[:60]) for name, _, _ in document["layers"] if name)
        about = f" in its layers {names}" if names else ""
        raise InputError(f"holds no features{about}", "export it again with what is to be seen")


def _with_tags(row: dict[str, Any]) -> dict[str, Any]:
    """A row of a layer with the tags that its columns and its layer stand for."""
    layer = row.get("scenewright", {}).get("layer", "")
    if not layer:
        return row
    shape = SHAPES.get(str((row["geometry"] or {}).get("type", "")).removeprefix("Multi"), "")
    return row | {"properties": tags_of_row(row["properties"], layer, shape)}


def name_of(path: Path) -> str:
    """The name of a map file without the suffixes of its kind.

    >>> name_of(Path("maps/Oslo.west.osm.gz"))
    'Oslo.west'
    """
    return re.sub(r"(\.osm)?\.(gz|bz2|pbf|osm|zip|kmz|kml|gpkg|shp)$", "", path.name, flags=re.I)
