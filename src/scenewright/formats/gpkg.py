"""Maps for GIS: GeoPackage, by GDAL (extra ``gis``), of what a scene draws as GeoJSON.

Layers are named after what lies on them; the columns are the tags of OpenStreetMap and those of our
own, so that the file reads again. The reference system is that of the GeoJSON file: longitude and
latitude, or the metres of the system that a map came in; without either the metres of the brief.
"""

from __future__ import annotations

import json
import os
import tempfile
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyogrio
import shapely
from pyogrio.raw import write as write_layer

from scenewright.core.atomic_file import WRITTEN_BY_US, atomic_write
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.table import load_function, row_of

LAYERS = (
    ("site", "sites"),
    ("block", "blocks"),
    ("extend", "areas"),
    ("street_side", "street_sides"),
    ("building", "buildings"),
    ("laid_out", "laid_out"),
    ("highway", "roads"),
    ("plot", "plots"),
)
"""The first tag that a feature has, and its layer."""
NOW = "1970-01-01T00:00:00.000Z"
"""The date of every file: the same solution makes the same bytes."""
Row = dict[str, Any]


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    row = row_of("map.geojson", "writer", solution.brief.domain)
    draw: Callable[..., Row] = load_function(row.writer, "document", path)
    document = draw(solution, plan)
    with tempfile.TemporaryDirectory(prefix="scenewright-") as folder, atomic_write(path) as part:
        made = Path(folder) / "map.gpkg"
        encode(document, made)
        part.write_bytes(made.read_bytes())


def encode(document: Row, path: Path) -> None:
    """Write a FeatureCollection as a new file with a layer a kind of feature and shape."""
    pyogrio.set_gdal_config_options({"OGR_CURRENT_DATE": NOW})
    layers: dict[tuple[str, str], list[Row]] = {}
    for feature in document["features"]:
        tags = feature["properties"]
        name = next((name for key, name in LAYERS if tags.get(key, "no") != "no"), "other")
        layers.setdefault((name, feature["geometry"]["type"]), []).append(feature)
    taken: set[str] = set()
    for (name, shape), rows in layers.items():
        free = name if name not in taken else f"{name}_{shape.lower()}"
        taken.add(free)
        _write_layer(path, free, shape, rows, _system(document))


def _system(document: Row) -> str | None:
    """The reference system of a document as GDAL takes it; ``None`` where there is none."""
    if "crs" not in document:
        return "EPSG:4326"
    stated = document["crs"]
    return None if stated is None else str(stated["properties"]["name"])


def _write_layer(path: Path, name: str, shape: str, rows: Sequence[Row], crs: str | None) -> None:
    keys = ["id", *dict.fromkeys(key for row in rows for key in row["properties"])]
    tables = [{"id": row["id"]} | row["properties"] for row in rows]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # that a file without a system has none
        write_layer(
            path,
            shapely.to_wkb(shapely.from_geojson([json.dumps(row["geometry"]) for row in rows])),
            [_column([table.get(key) for table in tables]) for key in keys],
            keys,
            layer=name,
            driver="GPKG",
            geometry_type=shape,
            crs=crs,
            append=path.exists(),
            layer_options={"DESCRIPTION": WRITTEN_BY_US},
        )


def _column(values: list[Any]) -> np.ndarray[Any, Any]:
    """Values as numbers where all that are there are numbers, else as texts.

    >>> _column([3, 4]).dtype.kind, _column([2.5, None]).dtype.kind, _column(["a", 1]).tolist()
    ('i', 'f', ['a', '1'])
    """
    kinds = {type(value) for value in values} - {type(None)}
    if kinds == {int} and None not in values:
        return np.array(values, np.int64)
    if kinds and kinds <= {int, float}:
        return np.array([np.nan if value is None else value for value in values], float)
    return np.array([None if value is None else str(value) for value in values], object)
