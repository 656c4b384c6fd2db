"""The features of map files as one GeoJSON document; run in a process apart.

GDAL and osmium are compiled code that a damaged file can bring down: they work in a process apart,
with a limit of memory and time. Beside the members of GeoJSON the document has ``crs`` as a text,
``layers`` (the name, number of features and reference system of each), and in features a member
``scenewright`` with their ``layer`` and what of them was ``lost``.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from scenewright.core.errors import InputError
from scenewright.ground.geodata.limits import CUT, MOST_CORNERS, MOST_FEATURES, MOST_LAYERS

LONGEST_TEXT = 500
AGAIN = "export it again"
SORT = "osmium sort sorts it, JOSM does when it saves"
DEGREES = "OGC:CRS84"
OSM_FILES = (".osm", ".pbf")
UNKNOWN = ("ENGCRS", "LOCAL_CS", "ENGINEERINGCRS")
"""How the definition of a system begins that lies nowhere on earth."""


Document = dict[str, Any]


class Layer(NamedTuple):
    """One layer: its name, its reference system as GDAL names it, geometries (shapely; ``None``
    where one cannot be parsed), ids, and the values of each field."""

    name: str
    crs: str
    shapes: Any
    ids: list[str]
    fields: dict[str, list[Any]]


def extract(path: str, files: list[str], layers: list[str], turn: bool) -> Document:
    """The document of the ``files`` that a map at ``path`` is made of: data of OpenStreetMap, or
    the ``layers`` named (all, if none), which become longitude and latitude where they lie in
    different systems and are to ``turn``. Raises :class:`InputError` for what cannot be read."""
    del path
    paths = [Path(file) for file in files]
    try:
        if all(file.suffix in OSM_FILES for file in paths):
            return _osm_document(paths)
        return _document(list(_layers(paths, layers)), turn)
    except (InputError, MemoryError):
        raise
    except Exception as error:  # whatever a parser says of a file that it cannot read
        reason = " ".join(str(error).split()) or type(error).__name__
        for file in paths:
            reason = reason.replace(f"{file.parent}/", "")
        remedy = SORT if "out of order" in reason else AGAIN
        raise InputError(f"cannot be read: {reason[:200]}", remedy) from None


def _osm_document(files: list[Path]) -> Document:
    from scenewright.ground.geodata.openstreetmap import list_rows

    rows = [row for file in files for row in list_rows(file)]
    return _collection(rows, DEGREES, [["", len(rows), DEGREES]])


def _collection(rows: list[Document], crs: str, layers: list[Any]) -> Document:
    return {"type": "FeatureCollection", "crs": crs, "layers": layers, "features": rows}


def _layers(files: list[Path], wanted: list[str]) -> Iterator[Layer]:
    """The layers of files that hold shapes."""
    for unused in ("pandas", "geopandas", "pyarrow"):  # pyogrio loads them if they are there
        sys.modules[unused] = None  # type: ignore[assignment]
    import pyogrio

    pyogrio.set_gdal_config_options({"SHAPE_RESTORE_SHX": "YES", "OGR_SQLITE_LOAD_EXTENSIONS": ""})
    known: list[str] = []
    found = 0
    for file in files:
        names = [name for name, kind in pyogrio.list_layers(file).tolist() if kind is not None]
        known += names
        if len(known) > MOST_LAYERS:
            raise InputError(f"holds more than {MOST_LAYERS} layers", "give some of them")
        for name in names:
            if not wanted or name in wanted:
                found += 1
                yield _layer(file, name)
    missing = [name for name in wanted if name not in known]
    if missing:
        there = ", ".join(known)[:300]
        raise InputError(f"holds no layer '{missing[0][:60]}'", f"give --layer one of: {there}")
    if not found:
        raise InputError("holds no layer with shapes", AGAIN)


def _layer(file: Path, name: str) -> Layer:
    import shapely
    from pyogrio.raw import read

    told, numbers, shapes, columns = read(
        file,
        layer=name,
        return_fids=True,
        force_2d=True,
        max_features=MOST_FEATURES + 1,
        datetime_as_string=True,
    )
    if len(numbers) > MOST_FEATURES:
        raise InputError(f"holds more than {MOST_FEATURES:,} features", CUT)
    fields = {str(key): _values(one) for key, one in zip(told["fields"], columns, strict=True)}
    ids = _stated_ids(fields) or [f"{name}/{number}" for number in numbers.tolist()]
    crs = str(told["crs"] or "")
    made = shapely.from_wkb(shapes, on_invalid="ignore")
    return Layer(name, "" if crs.startswith(UNKNOWN) else crs, made, ids, fields)


def _stated_ids(fields: dict[str, list[Any]]) -> list[str]:
    """The texts of a column ``id``, if every row has one of its own; otherwise none."""
    stated = fields.get("id", [])
    texts = [value for value in stated if isinstance(value, str) and value]
    return texts if texts and len(set(texts)) == len(stated) else []


def _values(column: Any) -> list[Any]:
    """Values as JSON has them, texts cut; what is no text and no number is nothing."""
    return [_plain(value) for value in column.tolist()]


def _plain(value: Any) -> Any:
    if isinstance(value, str):
        return value[:LONGEST_TEXT]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, int | float) else None


def _document(layers: list[Layer], turn: bool) -> Document:
    import shapely

    corners = sum(int(shapely.get_num_coordinates(layer.shapes).sum()) for layer in layers)
    count = sum(len(layer.shapes) for layer in layers)
    if count > MOST_FEATURES or corners > MOST_CORNERS:
        what = f"{count:,} features" if count > MOST_FEATURES else f"{corners:,} corners"
        raise InputError(f"holds {what}", CUT)
    systems = sorted({layer.crs for layer in layers if layer.crs})
    crs = systems[0] if len(systems) == 1 else DEGREES if systems else ""
    rows = [row for layer in layers for row in _features(layer, turn and len(systems) > 1)]
    return _collection(rows, crs, [[one.name, len(one.shapes), one.crs] for one in layers])


def _features(layer: Layer, turned: bool) -> Iterator[Document]:
    """The features of a layer as GeoJSON, in longitude and latitude if they are to be ``turned``:
    layers of one file may lie in different systems."""
    import shapely

    shapes = layer.shapes
    if turned and layer.crs:
        from pyproj import Transformer

        turning = Transformer.from_crs(layer.crs, DEGREES, always_xy=True)
        shapes = shapely.transform(shapes, lambda x, y: turning.transform(x, y), interleaved=False)
    keys = list(layer.fields)
    for row, (name, shape) in enumerate(zip(layer.ids, shapes, strict=True)):
        stated = {key: layer.fields[key][row] for key in keys}
        yield {
            "type": "Feature",
            "id": name,
            "scenewright": {"layer": layer.name},
            "properties": {key: value for key, value in stated.items() if value is not None},
            "geometry": json.loads(shapely.to_geojson(shape)) if _is_finite(shape) else None,
        }


def _is_finite(shape: Any) -> bool:
    import numpy as np
    import shapely

    return shape is not None and bool(np.isfinite(shapely.get_coordinates(shape)).all())
