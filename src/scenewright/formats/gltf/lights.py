"""Lights of a document: lamps, rows of lights, the sun; candela and lux (KHR_lights_punctual)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.formats.gltf.tree import Tree
from scenewright.render.daylight import sun_at
from scenewright.render.items import RenderItem
from scenewright.render.lamps import lamps_of
from scenewright.render.light_rows import LightRow

LIGHTS = "KHR_lights_punctual"
Json = dict[str, Any]
Light = tuple[float, float, float]


def add_lamps(
    tree: Tree, lights: list[Json], found: Sequence[RenderItem], catalog: Catalog
) -> None:
    """A node with a light below each lamp. A ball of light gives its flux evenly: candela are
    lumens by 4 pi."""
    index = {node["name"]: number for number, node in enumerate(tree.nodes)}
    for lamp in lamps_of(found, catalog):
        light = _point(lamp.color, lamp.lumens / (4 * np.pi))
        _add(tree, lights, index[lamp.item.name], f"{lamp.item.name} light", lamp.at, light)


def add_rows(tree: Tree, lights: list[Json], rows: Iterable[LightRow]) -> None:
    """Nodes with lights below the rows of lights of rooms."""
    index = {node["name"]: number for number, node in enumerate(tree.nodes)}
    for row in rows:
        light = _point(row.color, row.candela)
        for place in row.places:
            name = tree.free(f"{row.name} light")
            _add(tree, lights, index[row.name], name, place, light)


def add_sun(tree: Tree, lights: list[Json], hour: str) -> None:
    """A node with the sun of an hour, where it has risen: a light along the node's own -z."""
    sun = sun_at(hour)
    if sun is not None:
        x, y, z = sun.towards.tolist()
        color = [round(share, 4) for share in sun.color]
        lights.append({"type": "directional", "color": color, "intensity": sun.lux})
        turn = turn_of(float(np.arctan2(x, -y)), -float(np.arcsin(z)))
        held = {"extensions": {LIGHTS: {"light": len(lights) - 1}}}
        tree.add(0, {"name": tree.free("sun"), "rotation": turn} | held)


def turn_of(yaw: float, pitch: float) -> list[float]:
    """The quaternion of a turn by ``pitch`` about x, then by ``yaw`` about y, in radians.

    >>> turn_of(0.0, 0.0)
    [0.0, 0.0, -0.0, 1.0]
    """
    a, b = pitch / 2, yaw / 2
    turn = (np.sin(a) * np.cos(b), np.cos(a) * np.sin(b), -np.sin(a) * np.sin(b))
    return [round(float(share), 7) for share in (*turn, np.cos(a) * np.cos(b))]


def _point(color: Light, candela: float) -> Json:
    """A point of light of a colour of luminance 1."""
    top = max(color)
    shares = [round(share / top, 4) for share in color]
    return {"type": "point", "color": shares, "intensity": round(float(candela) * top, 3)}


def _add(
    tree: Tree, lights: list[Json], parent: int, name: str, place: Sequence[float], light: Json
) -> None:
    if light not in lights:
        lights.append(light)
    x, y, z = (float(length) for length in place)
    node = {"name": name, "translation": [x, z, -y if y else 0.0]}
    tree.add(parent, node | {"extensions": {LIGHTS: {"light": lights.index(light)}}})
