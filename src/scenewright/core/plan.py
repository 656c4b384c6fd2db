"""The plan of a brief: valid spaces on levels, and what its domain knows of them besides."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from scenewright.core.space import Level, Space


class Plan(NamedTuple):
    """The spaces to be filled, checked once and handed along.

    ``levels`` in the order listed, ``spaces`` one a room, hall or site, ``names`` what people call
    each by its id, and ``detail`` what only the domain knows (a site's roads and blocks).
    """

    levels: tuple[Level, ...]
    spaces: tuple[Space, ...]
    names: Mapping[str, str]
    detail: Any = None
