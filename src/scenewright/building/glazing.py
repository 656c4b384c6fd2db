"""Framed panes: what windows and glazed doors are made of."""

from __future__ import annotations

from scenewright.core.catalog import Material, Part
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.prisms import box

FRAME, LINING = 0.06, 0.03
"""Widths of a frame's bars and of the lining of an opening, metres."""

DARK_FRAME = Material("frame graphite", (0.24, 0.25, 0.27), roughness=0.5)
GLASS = Material("window glass", (0.74, 0.86, 0.92), roughness=0.05, opacity=0.28)

Span = tuple[float, float]


def make_part(material: Material, *meshes: Mesh) -> Part:
    """Meshes of one material as one part."""
    return Part(material, *merge(meshes))


def make_glazing(xs: Span, ys: Span, zs: Span, width: float) -> tuple[list[Mesh], Mesh]:
    """A framed pane in the box of three spans: four bars, and the glass between them."""
    (x0, x1), (y0, y1), (z0, z1) = xs, ys, zs
    bars = [
        box((x0, y0, z0), (x0 + width, y1, z1)),
        box((x1 - width, y0, z0), (x1, y1, z1)),
        box((x0 + width, y0, z0), (x1 - width, y1, z0 + width)),
        box((x0 + width, y0, z1 - width), (x1 - width, y1, z1)),
    ]
    middle = (y0 + y1) / 2
    pane = box((x0 + width, middle - 0.006, z0 + width), (x1 - width, middle + 0.006, z1 - width))
    return bars, pane
