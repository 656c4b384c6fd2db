"""The ground of a site as values: blocks, roads, landmarks, entrances."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.ground.works import Pathway, PavedArea


class Area(NamedTuple):
    """A polygon: ``outline`` (n, 2) counter-clockwise, ``holes`` clockwise, square metres."""

    outline: Points
    holes: tuple[Points, ...]
    area: float


class Block(NamedTuple):
    """One connected piece of ground that can be built on. ``direction`` is that of most of its
    edges, in [0, pi/2); ``radius`` of the largest circle in it."""

    outline: Points
    holes: tuple[Points, ...]
    area: float
    direction: float
    radius: float


class Way(NamedTuple):
    """A road or path: its middle line ``(n, 2)`` as given, the parts of it inside the site, and
    the areas of the site it covers. ``beside`` are the parts of it that run outside beside the
    border, and ``mouths`` the stretches of the outline that are open to it (see
    :func:`~scenewright.ground.streetside.border.open_border`)."""

    id: str
    name: str
    kind: str
    width: float
    line: Points
    inside: tuple[Points, ...]
    areas: tuple[Area, ...]
    beside: tuple[Points, ...] = ()
    mouths: tuple[Points, ...] = ()


class Entrance(NamedTuple):
    """Where a road or path crosses or meets the outline: the point and the index of the way."""

    x: float
    y: float
    way: int


class SitePlan(NamedTuple):
    """A valid site. ``area`` is that of the ground (outline less holes), ``buildable`` what is
    left of it by ``setback`` from the outline and holes, ``road_setback`` from roads and paths
    and ``spacing`` from landmarks; ``blocks`` are its connected pieces, the largest first.
    ``models`` are the assets that draw the buildings asked for, a row each;
    ``fixed`` are buildings of those that stay where they stand, ``free`` what is left of the
    blocks at a distance of ``spacing`` from them. ``areas`` and ``drives`` are the ground set apart
    for squares, forecourts and parking, and the drives of the latter; ``waters`` rivers and lakes.
    """

    id: str
    name: str
    outline: Points
    holes: tuple[Points, ...]
    area: float
    buildable: float
    blocks: tuple[Block, ...]
    roads: tuple[Way, ...]
    landmarks: tuple[Standing, ...]
    entrances: tuple[Entrance, ...]
    models: tuple[str, ...] = ()
    fixed: tuple[Standing, ...] = ()
    free: tuple[Block, ...] = ()
    areas: tuple[PavedArea, ...] = ()
    drives: tuple[Pathway, ...] = ()
    waters: tuple[Points, ...] = ()


class Standing(NamedTuple):
    """A landmark, or a building that stays: its footprint, the box (x, y, heading, width, depth)
    of its model, height; ``model`` is the id of the asset that draws it, empty if none is named;
    ``local`` the footprint in the frame of the box, empty where that is the box, ``drawn`` the id
    of the shipped asset that draws one without a model."""

    id: str
    name: str
    model: str
    footprint: Points
    box: tuple[float, float, float, float, float]
    height: float
    local: Footprint = ()
    drawn: str = ""
