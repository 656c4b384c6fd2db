"""What maps of all kinds of open ground hold alike: ways and buildings with the tags of
OpenStreetMap, files that appear whole."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import outline_of
from scenewright.core.projection import Projection
from scenewright.core.scene import Piece
from scenewright.ground.buildings.use_words import TAG_OF_USE
from scenewright.ground.buildings.uses import use_of_asset
from scenewright.ground.maps.writing import bearing_of, write_feature, write_points, write_ring
from scenewright.ground.plan import Way


def write_document(made: dict[str, Any], path: str | os.PathLike[str]) -> None:
    """Write a document as JSON; the file appears whole or not at all."""
    write_atomically(path, json.dumps(made, ensure_ascii=False) + "\n")


def check_origin(brief: Brief, what: str) -> None:
    """InputError if it is not known where on earth ``what`` (its blocks) of a brief lies."""
    if brief.part.origin is None:
        raise InputError(
            f"GeoJSON is in degrees, and the brief does not say where its {what} lie",
            'give the brief an "origin": [longitude, latitude]',
        )


def write_way(way: Way, map_: Projection, **more: str) -> dict[str, Any]:
    """A street or path by its middle line, with ``more`` tags."""
    kind = "residential" if way.kind == "road" else "footway"
    tags = {"highway": kind, "name": way.name, "width": way.width, **more}
    return write_feature(way.id, "LineString", write_points(way.line, map_), tags)


PLANTED = {"tree": {"natural": "tree"}, "lamp_post": {"highway": "street_lamp"}}
"""Tags of OpenStreetMap for what is planted or lit, by category."""


def write_planted(pieces: Sequence[Piece], old: str, map_: Projection) -> Iterator[dict[str, Any]]:
    """Trees and street lamps as points, ``new`` where they are not of the ``old`` space."""
    for piece in (p for p in pieces if p.category in PLANTED):
        [at] = write_points(np.array([piece.pose[:2]]), map_)
        tags = {**PLANTED[piece.category], "height": round(piece.size.height, 3)}
        tags["new"] = "" if piece.space == old else "yes"
        yield write_feature(piece.id, "Point", at, tags)


def write_building(piece: Piece, storey: float, map_: Projection, **more: str) -> dict[str, Any]:
    """A building by its footprint, its storeys ``storey`` metres high, with ``more`` tags."""
    use = use_of_asset(piece.asset)
    tags = {
        "building": "yes" if use is None else TAG_OF_USE[use],
        "name": piece.function,
        "height": round(piece.size.height, 3),
        "building:levels": max(1, round(piece.size.height / storey)),
        "model": piece.asset,
        "direction": bearing_of(piece.pose.heading),
        **more,
    }
    return write_feature(piece.id, "Polygon", [write_ring(outline_of(piece), map_)], tags)
