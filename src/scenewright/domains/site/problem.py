"""The problem of a site as plain arrays, ready for compiled code.

A building is a box ``(x, y, heading, width, depth)`` with a height; its front looks along the
heading. NamedTuples of C-contiguous float64 / int64 arrays.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.footprint import Footprint
from scenewright.domains.site.settings import SiteSettings

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]

NONE: Floats = np.zeros((0, 5))


class SiteGround(NamedTuple):
    """The ground.

    ``edges`` (e, 4): directed edges of outline and holes, the inside on the left.
    ``block_edges`` (f, 4): those of the buildable blocks (outline less setbacks, roads and
    landmarks with their distances), block b owning rows ``block_spans[b]``; ``block_areas`` (b,).
    ``roads`` (r, 5): boxes of the straight pieces of roads and paths, front along the piece.
    ``landmarks`` (l, 5) boxes and ``landmark_heights`` (l,), ``landmark_quality`` (l,),
    ``landmark_sides`` (l, 5) as those of buildings.
    ``eyes`` (k, 2): points along roads and paths where people walk, about 5 m apart.
    ``bounds`` (4,), ``area`` of the site in square metres; ``squares`` (s, 4) edges of squares and
    quads; ``focus`` (k, 2) the middles of squares, without any of landmarks.
    """

    edges: Floats
    block_edges: Floats
    block_spans: Ints
    block_areas: Floats
    roads: Floats
    landmarks: Floats
    landmark_heights: Floats
    landmark_quality: Floats
    eyes: Floats
    bounds: Floats
    area: float
    landmark_sides: Floats = NONE
    squares: Floats = np.zeros((0, 4))
    focus: Floats = np.zeros((0, 2))


class Buildings(NamedTuple):
    """The ``n`` buildings to be placed.

    ``sizes`` (n, 3) width, depth, height; ``quality`` (n,) visual quality relative to the best of
    the library, τ in (0, 1]; ``tone`` and ``symmetry`` (n,) of the facade in [0, 1]; ``models``
    (n,) number of the wish each one is of; ``floors`` (n,); ``forms`` the
    planar forms each may take (empty: all); ``sides`` (n, 5) what front, left, back, right side
    and roof show, as a share of the best mean of four sides in the library (empty: ``quality``);
    ``footprints`` the polygon each covers, where it is no box (empty: all are boxes).
    """

    sizes: Floats
    quality: Floats
    tone: Floats
    symmetry: Floats
    models: Ints
    floors: Ints
    forms: tuple[frozenset[str], ...] = ()
    sides: Floats = NONE
    footprints: tuple[Footprint, ...] = ()

    def outlines(self) -> list[Floats]:
        """Corners (k, 2) of what each building covers, in the frame of its box."""
        halves = [np.array(size[:2]) / 2 for size in self.sizes]
        rows = self.footprints or ((),) * len(halves)
        return [
            np.array(row) if row else half * [(-1, -1), (1, -1), (1, 1), (-1, 1)]
            for row, half in zip(rows, halves, strict=True)
        ]


class SiteProblem(NamedTuple):
    """One site to solve. ``spacing`` is the least distance of buildings to each other,
    ``sun_spacing`` that behind one to the south in heights of it, ``facing`` the preferred
    heading, ``fire_access`` the width of the way to each building, all in metres and radians.
    ``form`` is that of the paper's measures: ``printed``, or ``repaired`` where they need it;
    ``settings`` steer the solvers. ``door_distance`` is kept before doors from the border, but
    where a way runs. ``block_forms`` are the planar forms asked for block by block ("": any).
    ``target`` is the ground to be covered and the floor area, in square metres, where buildings
    are candidates to choose from (0: all are to stand). ``drawn_to`` is the direction of the side
    whose blocks take more than their share. ``court_gap`` is the widest opening of the court of a
    block whose form is ``peripheral`` (0: any)."""

    ground: SiteGround
    buildings: Buildings
    names: tuple[str, ...]
    weights: dict[str, float]
    spacing: float
    sun_spacing: float
    facing: float
    fire_access: float
    latitude: float
    day: int
    form: Literal["printed", "repaired"] = "repaired"
    settings: SiteSettings = SiteSettings()
    door_distance: float = 0.0
    block_forms: tuple[str, ...] = ()
    target: tuple[float, float] = (0.0, 0.0)
    drawn_to: tuple[float, float] = (0.0, 0.0)
    court_gap: float = 0.0


def sides_of(sides: Floats, quality: Floats) -> Floats:
    """What the sides (n, 5) of buildings show; their ``quality`` (n,) where that is not known.

    >>> sides_of(NONE, np.array([0.5])).tolist()
    [[0.5, 0.5, 0.5, 0.5, 0.5]]
    """
    known = len(sides) == len(quality)
    return np.asarray(sides) if known else np.repeat(quality[:, None], 5, axis=1)
