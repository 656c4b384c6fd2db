"""The features of map files as one GeoJSON document; run as a program of its own.

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

from scenewright.ground.geodata.limits import CUT, MOST_CORNERS, MOST_FEATURES, MOST_LAYERS, Refusal

LONGEST_TEXT = 500
AGAIN = "export it again"
DEGREES = "OGC:CRS84"
OSM_FILES = (".osm", ".pbf")
UNKNOWN = ("ENGCRS", "LOCAL_CS", "ENGINEERINGCRS")
"""How the definition of a system begins that lies nowhere on earth."""


class Layer(NamedTuple):
    """One layer: its name, its reference system as GDAL names it, geometries (shapely; ``None``
    where one cannot be parsed), ids, and the values of each field."""

    name: str
    crs: str
    shapes: Any
    ids: list[str]
    fields: dict[str, list[Any]]


def main() -> int:
    """Print the document of the files that the first argument lists, of the layers that the second
    lists (all, if none), or ``{"fault": …}``; the third says whether layers in different systems
    become longitude and latitude."""
    files, wanted, turn = (json.loads(text) for text in sys.argv[1:4])
    sys.stdout.write(extract([Path(file) for file in files], wanted, turn))
    return 0


def extract(files: list[Path], wanted: list[str], turn: bool = True) -> str:
    """The document of files as text: of data of OpenStreetMap, or of layers."""
    try:
        if all(file.suffix in OSM_FILES for file in files):
            return _osm_document(files)
        return _document(list(_layers(files, wanted)), turn)
    except Refusal as error:
        return _refuse(error.fault, error.remedy)
    except MemoryError:
        return _refuse("holds more than can be held", CUT)
    except Exception as error:  # whatever a parser says of a file that it cannot read
        reason = " ".join(str(error).split()) or type(error).__name__
        for file in files:
            reason = reason.replace(f"{file.parent}/", "")
        return _refuse(f"cannot be read: {reason[:200]}", AGAIN)


def _refuse(fault: str, remedy: str) -> str:
    return json.dumps({"fault": fault, "remedy": remedy})


def _osm_document(files: list[Path]) -> str:
    from scenewright.ground.geodata.openstreetmap import list_rows

    rows = [row for file in files for row in list_rows(file)]
    return _collection(map(json.dumps, rows), DEGREES, [["", len(rows), DEGREES]])


def _collection(rows: Iterator[str], crs: str, layers: list[Any]) -> str:
    members = json.dumps({"type": "FeatureCollection", "crs": crs, "layers": layers})
    return f'{members[:-1]}, "features": [{",".join(rows)}]}}'


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
            raise Refusal(f"holds more than {MOST_LAYERS} layers")
        for name in names:
            if not wanted or name in wanted:
                found += 1
                yield _layer(file, name)
    missing = [name for name in wanted if name not in known]
    if missing:
        there = ", ".join(known)[:300]
        raise Refusal(f"holds no layer '{missing[0][:60]}'", f"give --layer one of: {there}")
    if not found:
        raise Refusal("holds no layer with shapes", AGAIN)


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
        raise Refusal(f"holds more than {MOST_FEATURES:,} features")
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


def _document(layers: list[Layer], turn: bool) -> str:
    import shapely

    corners = sum(int(shapely.get_num_coordinates(layer.shapes).sum()) for layer in layers)
    count = sum(len(layer.shapes) for layer in layers)
    if count > MOST_FEATURES or corners > MOST_CORNERS:
        what = f"{count:,} features" if count > MOST_FEATURES else f"{corners:,} corners"
        raise Refusal(f"holds {what}")
    systems = sorted({layer.crs for layer in layers if layer.crs})
    crs = systems[0] if len(systems) == 1 else DEGREES if systems else ""
    rows = (row for layer in layers for row in _features(layer, turn and len(systems) > 1))
    return _collection(rows, crs, [[one.name, len(one.shapes), one.crs] for one in layers])


def _features(layer: Layer, turned: bool) -> Iterator[str]:
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
        feature = {"type": "Feature", "id": name, "scenewright": {"layer": layer.name}}
        feature |= {"properties": {k: v for k, v in stated.items() if v is not None}}
        geometry = shapely.to_geojson(shape) if _is_finite(shape) else "null"
        yield f'{json.dumps(feature)[:-1]}, "geometry": {geometry}}}'


def _is_finite(shape: Any) -> bool:
    import numpy as np
    import shapely

    return shape is not None and bool(np.isfinite(shapely.get_coordinates(shape)).all())
