"""CityJSON documents as one: sequences joined, templates placed where they stand, older names.

A sequence (CityJSONSeq, ``.city.jsonl``) holds a line of metadata and one line a feature, each with
corners of its own. A template is drawn once and placed by a corner and a matrix of four rows
(``GeometryInstance``). Versions before 1.0 name a part's building and a building's parts otherwise.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.files import check_json, json_of
from scenewright.catalog.models.model import FARTHEST, MOST_VERTICES, check_count
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Json = Mapping[str, Any]

INSTANCE = "GeometryInstance"
DEEPEST_LIST = 8
"""Lists within lists of a geometry."""


def document_of(content: bytes, what: str = "CityJSON") -> dict[str, Any]:
    """The CityJSON object of a file: one document, which may be of ``what`` else, or a sequence
    joined to one.

    >>> head = b'{"type": "CityJSON", "version": "2.0", "CityObjects": {}, "vertices": []}'
    >>> one = b'{"type": "CityJSONFeature", "CityObjects": {"a": {}}, "vertices": [[0, 0, 0]]}'
    >>> found = document_of(head + b"\\n" + one)
    >>> list(found["CityObjects"]), found["vertices"]
    (['a'], [[0, 0, 0]])
    """
    check_json(content)
    lines = [
        line.strip(b" \t\r\x1e") for line in content.removeprefix(b"\xef\xbb\xbf").split(b"\n")
    ]
    rows = [(number, line) for number, line in enumerate(lines, 1) if line]
    if len(rows) < 2 or not (rows[0][1].endswith(b"}") and rows[1][1].startswith(b"{")):
        return json_of(content, what)
    return _join([_row(number, line) for number, line in rows])


def _row(number: int, line: bytes) -> dict[str, Any]:
    try:
        return json_of(line, "CityJSON")
    except InputError as error:
        raise error.located(place=f"line {number}") from None


def _join(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """The metadata of the first row with the objects and corners of all."""
    head, objects, vertices = dict(rows[0]), dict[str, Any](), list[Any]()
    for number, row in enumerate(rows):
        kind = row.get("type")
        if kind != ("CityJSON" if number == 0 else "CityJSONFeature"):
            first = "its first line is no CityJSON" if number == 0 else ""
            fault = first or f"the line of its feature {number} is no CityJSONFeature"
            raise InputError(fault, "save it again as CityJSONSeq")
        own, corners = row.get("CityObjects", {}), row.get("vertices", [])
        if not isinstance(own, dict) or not isinstance(corners, list):
            raise InputError(f"the line of its feature {number} holds no objects", "save it again")
        names = {key: _free(key, objects) for key in own}
        for key, one in own.items():
            objects[names[key]] = _moved_object(one, len(vertices), names)
        vertices += corners
        check_count(len(vertices), MOST_VERTICES, "vertices")
    return head | {"CityObjects": objects, "vertices": vertices}


def _free(wish: str, taken: Json) -> str:
    names = (wish if k == 1 else f"{wish}-{k}" for k in range(1, len(taken) + 2))
    return next(name for name in names if name not in taken)


def _moved_object(one: Any, by: int, names: dict[str, str]) -> Any:
    """An object of a feature among those of all: its corners and relatives under new names."""
    if not isinstance(one, dict):
        return one
    found = dict(one)
    for key in ("parents", "children"):
        if isinstance(found.get(key), list):
            found[key] = [names.get(n, n) if isinstance(n, str) else n for n in found[key]]
    found["geometry"] = [
        one | {"boundaries": _moved(one.get("boundaries"), by)} if isinstance(one, dict) else one
        for one in _listed(found.get("geometry"))
    ]
    return found


def _moved(boundaries: Any, by: int, depth: int = 0) -> Any:
    """Corner numbers in lists, ``by`` more each; what is no number stays."""
    if type(boundaries) is int:
        return boundaries + by
    if isinstance(boundaries, list) and depth < DEEPEST_LIST:
        return [_moved(one, by, depth + 1) for one in boundaries]
    return boundaries


def _listed(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def objects_of(document: Json) -> dict[str, Any]:
    """The objects of a document, with relatives named as since version 1.0: a part by ``parents``,
    the parts of a building by ``children``. InputError if they are no objects."""
    objects = document.get("CityObjects")
    if not isinstance(objects, dict) or not all(isinstance(o, dict) for o in objects.values()):
        raise InputError("its CityObjects are no objects", "save it again")
    found = {key: _renamed(one) for key, one in objects.items()}
    for key, one in objects.items():
        parent = one.get("parent")
        if isinstance(parent, str) and parent in found:
            children = found[parent].setdefault("children", [])
            if isinstance(children, list) and key not in children:
                found[parent]["children"] = [*children, key]
    return found


def _renamed(one: dict[str, Any]) -> dict[str, Any]:
    older = {"parent": "parents", "Parts": "children"}
    if not older.keys() & one.keys():
        return one
    found = dict(one)
    for old, new in older.items():
        if old in found and new not in found:
            found[new] = [found[old]] if old == "parent" else found[old]
    return found


def place_templates(
    document: Json, objects: dict[str, Any], corners: Floats
) -> tuple[dict[str, Any], Floats]:
    """Objects with every template as a geometry of its own, and the corners (n, 3), in units of
    the file, with those of the templates. What cannot be placed says why under ``fault``."""
    if not any(_is_instance(g) for one in objects.values() for g in _listed(one.get("geometry"))):
        return objects, corners
    templates = document.get("geometry-templates")
    held = templates if isinstance(templates, dict) else {}
    drawn, table = _listed(held.get("templates")), _points(held.get("vertices-templates"))
    found, more = dict(objects), [corners]
    count = len(corners)
    for key, one in objects.items():
        placed = list[Any]()
        for geometry in _listed(one.get("geometry")):
            if not _is_instance(geometry):
                placed.append(geometry)
                continue
            try:
                template, points = _instance(geometry, drawn, table, corners)
            except InputError as error:
                placed.append({"type": INSTANCE, "fault": error.fault})
                continue
            placed.append(template | {"boundaries": _moved(template.get("boundaries"), count)})
            more.append(points)
            count += len(points)
            check_count(count, MOST_VERTICES, "vertices")
        found[key] = one | {"geometry": placed}
    return found, np.concatenate(more)


def _is_instance(geometry: Any) -> bool:
    return isinstance(geometry, dict) and geometry.get("type") == INSTANCE


def _instance(
    geometry: Json, templates: list[Any], table: Floats, corners: Floats
) -> tuple[dict[str, Any], Floats]:
    """A template and its corners (n, 3) where an instance places them."""
    number, at = geometry.get("template"), _listed(geometry.get("boundaries"))[:1]
    if type(number) is not int or not 0 <= number < len(templates):
        raise InputError("names a template that is not there", "correct it in the city model")
    template = templates[number]
    if not isinstance(template, dict) or not len(table):
        raise InputError("is of a template without corners", "correct it in the city model")
    if not at or type(at[0]) is not int or not 0 <= at[0] < len(corners):
        raise InputError("is placed at a corner that is not there", "correct it in the city model")
    matrix = _matrix(geometry.get("transformationMatrix"))
    turned = np.column_stack([table, np.ones(len(table))]) @ matrix.T
    if not (np.abs(turned) <= FARTHEST).all():
        raise InputError(
            "is placed by a matrix that leads out of the world", "correct it in the city model"
        )
    return template, turned[:, :3] + corners[at[0]]


def _matrix(rows: Any) -> Floats:
    """A matrix (4, 4) listed row by row; that of no change where none is given."""
    if rows is None:
        return np.eye(4)
    try:
        found = np.array(rows, np.float64)
    except (ValueError, TypeError, OverflowError):
        found = np.zeros(0)
    if found.shape != (16,) or not np.isfinite(found).all():
        raise InputError(
            "is placed by a matrix that is not 16 numbers", "correct it in the city model"
        )
    return found.reshape(4, 4)


def _points(rows: Any) -> Floats:
    """Rows of three finite numbers; none if they are not."""
    try:
        found = np.array(rows, np.float64)
    except (ValueError, TypeError, OverflowError):
        return np.zeros((0, 3))
    right = found.ndim == 2 and found.shape[1] == 3 and bool((np.abs(found) <= FARTHEST).all())
    return found if right else np.zeros((0, 3))


def faults_of(geometries: Any) -> Iterator[str]:
    """Why templates of an object could not be placed."""
    for geometry in _listed(geometries):
        if isinstance(geometry, dict) and isinstance(geometry.get("fault"), str):
            yield geometry["fault"]
