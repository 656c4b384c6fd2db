"""The scene: what is exported. Levels, spaces, walls, openings and placed pieces.

Local frame of a piece: x to its width, y to its depth, z up, origin in the middle of the
footprint on the underside. The **front** looks along local +y, the back edge is at -depth/2.
``heading`` is the direction of the front in plan, counter-clockwise from +x, so a local point
``(px, py)`` lies at ``(x, y) + px * (sin h, -cos h) + py * (cos h, sin h)``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from scenewright.core.footprint import Footprint
from scenewright.core.heights import HeightGrid
from scenewright.core.space import Level, Opening, Points, Space
from scenewright.core.stairs import Stairs
from scenewright.core.views import describe, show

STAIRS = "stairs"
"""The function of pieces that stand for what stairs take of a floor."""
CLUTTER = "clutter"
"""The function of small objects that stand on others; a scene has them, a solution does not."""


class Pose(NamedTuple):
    """Centre of the footprint, height of the underside above the level's floor, and heading."""

    x: float
    y: float
    z: float
    heading: float


class Size(NamedTuple):
    """Width (local x), depth (local y, front to back) and height, in metres."""

    width: float
    depth: float
    height: float


@dataclass(frozen=True, slots=True)
class Piece:
    """One placed object.

    ``category`` is a row of the catalog's table of kinds (``sofa``, ``double_bed`` …) and tells
    how the piece is used; ``asset`` the model that draws it; ``group`` the id of the furniture
    group it belongs to (``living/seating``); ``function`` that group's function. ``on`` is the id
    of the piece it stands on (a lamp on a nightstand), else ``None``.
    ``fixed`` pieces came with the brief (kept or locked) and are not to be moved. ``footprint`` is
    the polygon it covers, where that is less than its box.
    """

    id: str
    category: str
    asset: str
    space: str
    pose: Pose
    size: Size
    group: str = ""
    function: str = ""
    on: str | None = None
    fixed: bool = False
    footprint: Footprint = ()


@dataclass(frozen=True, slots=True)
class Prism:
    """A vertical prism over a simple polygon ``outline`` (n, 2), counter-clockwise, with holes.
    Under a sloped ceiling its upper face is tilted: a + b x + c y high by ``tilt`` (3,), ``top``
    at most."""

    outline: Points
    base: float
    top: float
    holes: tuple[Points, ...] = ()
    tilt: Points | None = None


@dataclass(frozen=True, slots=True)
class Wall:
    """One wall, as prisms that already leave out its openings; heights above the level's floor."""

    id: str
    level: str
    prisms: tuple[Prism, ...]


class Fall(NamedTuple):
    """How a top falls: to a height ``low`` at ``lines`` (n, 2), from ``reach`` metres off them."""

    lines: tuple[Points, ...]
    low: float
    reach: float


class GroundSurface(NamedTuple):
    """What lies on the ground of a space: ``kind`` (``asphalt``, ``pavement``, ``path``, ``lane``,
    ``walk``, ``square``, ``parking``, ``marking`` …) and the polygons it covers, each an outline
    with holes, between two heights; ``fall`` says where the upper one falls (none: nowhere)."""

    id: str
    space: str
    kind: str
    areas: tuple[tuple[Points, tuple[Points, ...]], ...]
    base: float
    top: float
    fall: Fall | None = None


class Terrain(NamedTuple):
    """The ground of a scene that is not flat: its heights as ``natural`` and as ``finished`` for
    what stands on it, and with ways led over water (``deck``); ``plinths`` are prisms between the
    ground and floors, with steps at doors; ``waters`` the outlines of water and its levels."""

    natural: HeightGrid
    finished: HeightGrid
    deck: HeightGrid
    plinths: tuple[Prism, ...] = ()
    waters: tuple[tuple[Points, float], ...] = ()


@dataclass(frozen=True, slots=True, repr=False)
class Scene:
    """Everything that is drawn: the shell (levels, spaces, walls, openings), what lies on open
    ground, the pieces, and the stairs; ``palette`` names the colours it is drawn in and the region
    of its finishes (empty: those of the models), ``hour`` the time of day it is lit for (empty:
    none); ``sources`` the author and licence of data that the layout was learned from, and what was
    learned; ``terrain`` the heights of its ground, on which surfaces lie and pieces stand (none: it
    is flat)."""

    name: str
    levels: tuple[Level, ...]
    spaces: tuple[Space, ...]
    walls: tuple[Wall, ...]
    openings: tuple[Opening, ...]
    pieces: tuple[Piece, ...]
    surfaces: tuple[GroundSurface, ...] = ()
    stairs: tuple[Stairs, ...] = ()
    palette: str = ""
    hour: str = ""
    sources: tuple[tuple[str, str, str], ...] = ()
    terrain: Terrain | None = None

    def __repr__(self) -> str:
        """One line: the name, and how much there is."""
        return describe(
            "Scene",
            self.name,
            levels=len(self.levels),
            spaces=len(self.spaces),
            pieces=len(self.pieces),
        )

    def _repr_png_(self) -> bytes | None:
        """In notebooks: the scene from above at an angle, with the models shipped."""
        picture: bytes | None = show("scene_png", self)
        return picture
