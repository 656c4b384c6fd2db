"""What a person says of a map beside its file: its reference system, its origin, its layers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple


class MapOptions(NamedTuple):
    """The reference system that coordinates are taken to be of (``crs``, instead of what the file
    says), the place that becomes 0, 0 (``origin``, x and y of that system or longitude and
    latitude), the ``layers`` that are read (all, if none), and the ``site`` to build on: the id of
    an area, or a place in it as "x,y"."""

    crs: str = ""
    origin: tuple[float, float] | None = None
    layers: tuple[str, ...] = ()
    site: str = ""

    def name_given(self) -> str:
        """The options that are given, as they are typed.

        >>> MapOptions("EPSG:25832", layers=("buildings",)).name_given()
        '--crs, --layer'
        """
        given = {"--crs": self.crs, "--origin": self.origin is not None, "--layer": self.layers}
        given |= {"--site": self.site}
        return ", ".join(name for name, value in given.items() if value)


AS_IT_IS = MapOptions()
"""Nothing is said of a map but by its file."""


def restore_options(values: Sequence[Any]) -> MapOptions:
    """The options from their values as JSON keeps them.

    >>> restore_options(["EPSG:25832", [11.0, 49.0], [], ""])
    MapOptions(crs='EPSG:25832', origin=(11.0, 49.0), layers=(), site='')
    """
    crs, origin, layers, site = values
    return MapOptions(crs, (origin[0], origin[1]) if origin else None, tuple(layers), site)


def place_in(text: str) -> tuple[float, float] | None:
    """The place that a text states as two numbers; ``None`` if it states none.

    >>> place_in("11.07, 49.45"), place_in("way/123")
    ((11.07, 49.45), None)
    """
    try:
        x, y = (float(part) for part in text.split(","))
    except ValueError:
        return None
    return (x, y) if math.isfinite(x) and math.isfinite(y) else None
