"""A catalogue as listed: what each model is taken for, and the table that corrects it.

The table lies beside the models (``catalog.csv`` in a folder, ``NAME.catalog.csv`` beside the file
``NAME.sh3f``; or ``.json``) and has a row a model; an empty cell leaves what was inferred.
"""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePath
from typing import NamedTuple

import numpy as np

from scenewright.catalog.kinds import KINDS
from scenewright.catalog.models import SIDECARS
from scenewright.catalog.models.categories import BUILDING, CITY, building
from scenewright.catalog.models.files import MEBIBYTE, json_of, whole
from scenewright.catalog.models.furniture import (
    OTHER,
    Understood,
    library_turn,
    understood,
    unit_of,
)
from scenewright.catalog.models.hues import main_colour
from scenewright.catalog.models.likeness import UPS, turn_matrix
from scenewright.catalog.models.model import LARGEST, Model, clean
from scenewright.catalog.models.orientation import turn_model
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError
from scenewright.core.scene import Size
from scenewright.text import neutralize_cell, restore_cell

FRONTS = ("front", "right", "back", "left")
"""Which side of a model, once upright, is its front, by the quarter turns that bring it there."""
COLUMNS = (
    "id",
    "name",
    "category",
    "up",
    "front",
    "width",
    "depth",
    "height",
    "scale",
    "licence",
    "author",
    "style",
    "colour",
    "skip",
    "sure",
    "why",
    "faces",
)
TOLD = ("sure", "why", "faces")
"""Columns that tell and correct nothing."""
YES, NO = ("yes", "true", "1", "x", "skip"), ("no", "false", "0", "")
MOST_BYTES = 8 * MEBIBYTE
MOST_ROWS = 20_000

Cells = Mapping[str, str]
Table = Mapping[str, Cells]


class Listed(NamedTuple):
    """A model in metres, upright, its front to +y, and its row: category, how sure and why, which
    of its sides was up and the front, style and colour in words, and whether it is to be left
    out."""

    model: Model
    category: str
    sure: float
    why: str
    up: str
    front: str
    scale: float
    style: str
    colour: str
    skip: bool


def list_models(models: Sequence[Model], table: Table, fixed: bool = False) -> tuple[Listed, ...]:
    """Every model, understood and corrected; with ``fixed`` units and fronts stay as read."""
    unit = 1.0 if fixed else unit_of(tuple(models))
    turn = 0 if fixed else library_turn(models, unit)
    known = {key.casefold(): cells for key, cells in table.items()}
    return tuple(_list_model(model, unit, turn, fixed, _cells(model, known)) for model in models)


def _cells(model: Model, table: Table) -> Cells:
    """The row of a model: by its id, or by the last part of it."""
    key = model.id.casefold()
    return table.get(key) or table.get(PurePath(key).name) or {}


def _list_model(model: Model, unit: float, turn: int, fixed: bool, cells: Cells) -> Listed:
    taken = _guess(model, unit, turn)
    if fixed:
        taken = taken._replace(turn=0, scale=1.0, up=UPS[0])
    category = cells.get("category") or taken.category
    if category != taken.category:
        taken = taken._replace(sure=1.0, why="by the table")
    up, front = cells.get("up") or taken.up, cells.get("front") or FRONTS[taken.turn]
    if up != UPS[0]:
        model = turn_model(model, turn_matrix(UPS.index(up), 0))
    scale = _number(cells, "scale", taken.scale)
    size = Size(*(side * scale for side in model.size))
    size = size if FRONTS.index(front) % 2 == 0 else Size(size.depth, size.width, size.height)
    size = Size(*(_number(cells, key, side) for key, side in zip(Size._fields, size, strict=True)))
    ready = _set(model, FRONTS.index(front), size)._replace(
        name=cells.get("name") or model.name,
        author=cells.get("author") or model.author,
        licence=cells.get("licence") or model.licence,
    )
    return Listed(
        ready,
        category,
        taken.sure,
        taken.why,
        up,
        front,
        scale,
        cells.get("style", ""),
        cells.get("colour") or main_colour(ready.parts),
        cells.get("skip", "").lower() in YES,
    )


def _guess(model: Model, unit: float, turn: int) -> Understood:
    """A building if it is of a city model or large, unless its name is a piece of furniture's."""
    if PurePath(model.source).suffix.lower() in CITY:
        return Understood(BUILDING, 1.0, "of a city model", scale=unit)
    found = understood(model, unit, turn)
    if found.category == OTHER and found.sure < 1.0 and building(model.size, unit):
        return Understood(BUILDING, 0.7, "as large as a building", scale=unit)
    return found


def _set(model: Model, turn: int, size: Size) -> Model:
    """The model turned counter-clockwise by quarters and stretched to a size."""
    if turn == 0 and size == model.size:
        return model
    cos, sin = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turn]
    width, depth, height = model.size
    old = np.array([depth, width, height] if turn % 2 else [width, depth, height])
    matrix = np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]) * (np.array(size) / old)[:, None]
    parts = tuple(Part(p.material, p.vertices @ matrix.T, p.faces) for p in model.parts)
    return model._replace(parts=parts, size=size)


def _number(cells: Cells, key: str, otherwise: float) -> float:
    return float(cells[key]) if cells.get(key) else otherwise


def table_beside(path: Path) -> Table:
    """The corrections beside a catalogue; none if there is no such file."""
    names = (
        [path / name for name in SIDECARS]
        if path.is_dir()
        else [path.with_name(f"{path.stem}.{name}") for name in SIDECARS]
    )
    found = next((name for name in names if name.is_file()), None)
    return table_of(found) if found else {}


def table_of(file: Path) -> Table:
    """The corrections of a table; InputError where it says what cannot be."""
    try:
        content = whole(file, MOST_BYTES)
        rows = _json_rows(content) if file.suffix.lower() == ".json" else _csv_rows(content)
        return {cells["id"]: cells for cells in rows}
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror}", "check file permissions", file=str(file)
        ) from None
    except InputError as error:
        raise error.located(file=str(file)) from None


def _csv_rows(content: bytes) -> list[Cells]:
    try:
        reader = csv.DictReader(io.StringIO(content.decode("utf-8-sig"), newline=""))
        return _check_rows({str(k): _restore(v) for k, v in row.items()} for row in reader)
    except UnicodeDecodeError:
        raise InputError("is not UTF-8 text", "save it as CSV in UTF-8") from None
    except csv.Error as error:
        raise InputError(f"is no CSV table ({error})", "save it again") from None


def _restore(cell: object) -> object:
    """A cell as it was before it was made harmless to spreadsheets."""
    return restore_cell(cell) if isinstance(cell, str) else cell


def _json_rows(content: bytes) -> list[Cells]:
    rows = json_of(content, "a table").get("models")
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise InputError("has no list of 'models'", 'write {"models": [{"id": …}, …]}')
    return _check_rows(rows)


def _check_rows(rows: Iterable[Mapping[str, object]]) -> list[Cells]:
    found: list[Cells] = []
    for number, row in enumerate(rows, 1):
        if number > MOST_ROWS:
            raise InputError(f"has more than {MOST_ROWS:,} rows", "split the catalogue")
        place = f"row {number}"
        strange = sorted(set(row) - set(COLUMNS))
        if strange:
            raise InputError(
                f"has a column '{clean(strange[0], 'without a name')}'",
                f"use: {', '.join(COLUMNS)}",
                place=place,
            )
        cells = {key: clean(_text(value)) for key, value in row.items() if key not in TOLD}
        _check(cells, place)
        found.append(cells)
    return found


def _text(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.9g}" if isinstance(value, int | float) else str(value or "")


def _check(cells: Cells, place: str) -> None:
    """Raise unless a row says only what can be."""
    if not cells.get("id"):
        raise InputError("a row has no id", "give the id that catalog show lists", place=place)
    category = cells.get("category", "")
    if category and category not in KINDS and category != OTHER:
        raise InputError(
            f"unknown category '{category}'",
            "use one of scenewright list assets, or other",
            place=place,
        )
    for key, sides in (("up", UPS), ("front", FRONTS)):
        if cells.get(key, "") not in ("", *sides):
            raise InputError(
                f"{key} '{cells[key]}' is not a side",
                f"use one of: {', '.join(sides)}",
                place=place,
            )
    if cells.get("skip", "").lower() not in (*YES, *NO):
        raise InputError(f"skip is '{cells['skip']}'", "write yes or no", place=place)
    for key in ("width", "depth", "height", "scale"):
        try:
            right = not cells.get(key) or 1e-4 <= float(cells[key]) <= LARGEST
        except ValueError:
            right = False
        if not right:
            raise InputError(f"{key} '{cells[key]}' is not possible", "give metres", place=place)


def rows(models: Iterable[Listed]) -> list[dict[str, str]]:
    """The table of a catalogue: one row a model, a cell for each of :data:`COLUMNS`."""
    return [
        {
            "id": one.model.id,
            "name": one.model.name,
            "category": one.category,
            "up": one.up,
            "front": one.front,
            **_measures(one),
            "licence": one.model.licence,
            "author": one.model.author,
            "style": one.style,
            "colour": one.colour,
            "skip": "yes" if one.skip else "",
            "sure": f"{one.sure:.2f}",
            "why": one.why,
            "faces": str(sum(len(part.faces) for part in one.model.parts)),
        }
        for one in models
    ]


def _measures(one: Listed) -> dict[str, str]:
    sides = zip(Size._fields, one.model.size, strict=True)
    return {key: f"{side:.4g}" for key, side in sides} | {"scale": f"{one.scale:g}"}


def csv_text(table: Sequence[Mapping[str, str]]) -> str:
    """The table as CSV, to be written beside the models and edited."""
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: neutralize_cell(cell) for key, cell in row.items()} for row in table)
    return text.getvalue()


def json_text(table: Sequence[Mapping[str, str]]) -> str:
    """The table as JSON."""
    return json.dumps({"models": list(table)}, indent=1, ensure_ascii=False) + "\n"
