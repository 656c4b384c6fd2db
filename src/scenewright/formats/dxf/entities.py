"""The contents of a DXF file: lines, arcs and words by layer, blocks taken apart."""

from __future__ import annotations

import logging
import os
from collections.abc import Iterator
from typing import Any

import ezdxf
import numpy as np
from ezdxf import path as dxf_path
from ezdxf.disassemble import recursive_decompose
from ezdxf.document import Drawing

from scenewright.building.drawn.drawing import Arc, Word
from scenewright.building.drawn.plan import plan_sheet
from scenewright.building.drawn.sheet import FARTHEST, Layer, Sheet
from scenewright.core.errors import InputError

logging.getLogger("ezdxf").addHandler(logging.NullHandler())
"""What the library mends in a file is no message for the terminal."""
MOST_ENTITIES, MOST_BYTES = 400_000, 200_000_000
QUARTER = (70.0, 110.0)
"""Degrees of the arcs that leaves of doors sweep."""
CURVED = 0.05
"""Curves are cut into lines no farther from them than this share of their size."""
METRES = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0, 14: 0.1}
"""Metres of the units of ``$INSUNITS``."""


def extract(path: str, scale: float) -> dict[str, Any]:
    """The plan of a file as plain values (:func:`scenewright.building.drawn.plan.plan_sheet`)."""
    return plan_sheet(read_entities(path), scale)


def read_entities(path: str | os.PathLike[str]) -> Sheet:
    """The model of a DXF file, blocks taken apart.

    Raises :class:`InputError` for what is no DXF, damaged, encrypted, or too large.
    """
    document = _open(path)
    model = document.blocks.get("*Model_Space") or document.blocks.get("*MODEL_SPACE")
    if model is None:
        raise InputError("has no model space", "save it again as DXF from the CAD program")
    layers: dict[str, Layer] = {}
    rooms = []
    for count, entity in enumerate(_take_apart(model), 1):
        if count > MOST_ENTITIES:
            raise InputError(
                f"holds more than {MOST_ENTITIES:,} entities", "save only the plan's layers"
            )
        layer = layers.setdefault(str(entity.dxf.get("layer", "0")), Layer())
        kind = entity.dxftype()
        layer.count(kind)
        _add(layer, entity, kind)
        rooms += _marked_room(entity, kind)
    unit = METRES.get(int(document.header.get("$INSUNITS", 0) or 0))
    return Sheet(layers, unit, tuple(rooms))


def _open(path: str | os.PathLike[str]) -> Drawing:
    if os.path.getsize(path) > MOST_BYTES:
        raise InputError("is larger than 200 MB", "save only the plan's layers")
    with open(path, "rb") as file:
        start = file.read(64)
    if start.startswith(b"AC10"):
        raise InputError(
            "is a DWG file", "save it as DXF (in AutoCAD: SAVEAS; else ODA File Converter)"
        )
    try:
        return ezdxf.readfile(path)
    except (MemoryError, PermissionError):
        raise
    except Exception as error:  # a damaged file: the library raises many kinds of error
        return _recover(path, error)


def _recover(path: str | os.PathLike[str], first: Exception) -> Drawing:
    """The document as far as it can be read."""
    from ezdxf import recover

    try:
        return recover.readfile(path)[0]
    except Exception as error:  # whatever the library stumbles over in a damaged file
        reason = " ".join(str(first or error).split())[:120] or type(error).__name__
        raise InputError(
            f"is no readable DXF ({reason})", "open it in a CAD program and save it as DXF again"
        ) from None


def _take_apart(model: Any) -> Iterator[Any]:
    """All entities, those of blocks in place; what cannot be taken apart is passed over."""
    found = iter(recursive_decompose(model))
    faults = 0
    while True:
        try:
            yield next(found)
        except StopIteration:
            return
        except Exception:  # a damaged block: the library raises many kinds of error
            faults += 1
            if faults > 3:
                return


def _add(layer: Layer, entity: Any, kind: str) -> None:
    """The lines, arcs and words of an entity; what is broken or of another kind adds none."""
    try:
        if kind == "LINE":
            start, end = entity.dxf.start, entity.dxf.end
            layer.add_path([(start.x, start.y), (end.x, end.y)])
        elif kind in ("TEXT", "MTEXT", "ATTRIB"):
            _add_words(layer, entity, kind)
        elif kind in ("LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "SOLID"):
            _add_curve(layer, entity, kind)
        elif kind == "HATCH":
            for outline in dxf_path.from_hatch(entity):
                _add_curve_points(layer, outline)
    except (ezdxf.DXFError, ValueError, TypeError, AttributeError, ArithmeticError, IndexError):
        return


def _tolerance(curve: Any) -> float:
    box = np.array([p.xyz for p in curve.control_vertices()])
    if not np.abs(box).max() <= FARTHEST:
        raise ValueError
    return max(CURVED * float(np.ptp(box, axis=0).max()), 1e-9 * float(np.abs(box).max()), 1e-6)


def _add_curve(layer: Layer, entity: Any, kind: str) -> None:
    if kind == "ARC":
        sweep = (entity.dxf.end_angle - entity.dxf.start_angle) % 360.0
        if QUARTER[0] <= sweep <= QUARTER[1]:
            middle, start, end = entity.ocs().to_wcs(entity.dxf.center), *_ends(entity)
            layer.add_arc(Arc((middle.x, middle.y), float(entity.dxf.radius), start, end))
            return
    if kind == "LWPOLYLINE" and len(entity) == 2 and abs(entity[0][4]) > 0.3:
        _add_bulge(layer, entity)
        return
    curve = dxf_path.make_path(entity)
    _add_curve_points(layer, curve)


def _ends(entity: Any) -> tuple[tuple[float, float], tuple[float, float]]:
    return (entity.start_point.x, entity.start_point.y), (entity.end_point.x, entity.end_point.y)


def _add_bulge(layer: Layer, entity: Any) -> None:
    """A polyline of one bulge: the arc of a leaf if it is a quarter of a circle."""
    arcs = [part for part in entity.virtual_entities() if part.dxftype() == "ARC"]
    for arc in arcs:
        _add_curve(layer, arc, "ARC")


def _add_curve_points(layer: Layer, curve: Any) -> None:
    layer.add_path([(p.x, p.y) for p in curve.flattening(_tolerance(curve))])


def _add_words(layer: Layer, entity: Any, kind: str) -> None:
    size = float(entity.dxf.get("char_height" if kind == "MTEXT" else "height", 1.0))
    words = entity.plain_text() if hasattr(entity, "plain_text") else str(entity.dxf.text)
    place = entity.dxf.insert
    if kind != "MTEXT" and entity.dxf.hasattr("align_point") and entity.dxf.get("halign", 0):
        place = entity.dxf.align_point
    layer.add_word(Word(" ".join(words.split()), float(place.x), float(place.y), size))


def _marked_room(entity: Any, kind: str) -> list[tuple[str, str, np.ndarray]]:
    """A room as Scenewright writes it: a closed polyline with its id and name."""
    if kind != "LWPOLYLINE" or not entity.has_xdata("SCENEWRIGHT"):
        return []
    words = [str(tag.value) for tag in entity.get_xdata("SCENEWRIGHT") if tag.code == 1000]
    if len(words) != 2 or len(entity) < 3:
        return []
    return [(words[0], words[1], np.array(entity.get_points("xy"), dtype=float))]
