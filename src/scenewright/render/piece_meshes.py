"""The parts pieces are drawn of: those of their models, over the footprints they cover."""

from __future__ import annotations

from functools import lru_cache

from scenewright.building.finishes import UNKNOWN
from scenewright.catalog.assets.extruded import extrude_model
from scenewright.core.catalog import Asset, Part
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Piece, Size
from scenewright.geometry.prisms import box, face_normals


@lru_cache(maxsize=4096)
def _shape_asset(asset: Asset, size: Size) -> tuple[Part, ...]:
    return tuple(p for p in asset.mesh(size) if face_normals(p.vertices, p.faces).any())


@lru_cache(maxsize=4096)
def _shape_outline(asset: Asset, size: Size, footprint: Footprint) -> tuple[Part, ...]:
    found = asset.over(size, footprint) if asset.over else ()
    return tuple(p for p in found if face_normals(p.vertices, p.faces).any())


def mesh_asset(asset: Asset | None, size: Size) -> tuple[Part, ...]:
    """The parts of a model as large as asked for; a box where there is none."""
    if asset is not None:
        return _shape_asset(asset, size)
    width, depth, height = size
    return (Part(UNKNOWN, *box((-width / 2, -depth / 2, 0), (width / 2, depth / 2, height))),)


def mesh_outline(
    piece: Piece, size: Size, asset: Asset | None, parts: tuple[Part, ...]
) -> tuple[Part, ...]:
    """The mesh of a piece over a footprint that is not its model's."""
    if asset is not None and (found := _shape_outline(asset, size, piece.footprint)):
        return found
    w, d = size.width / 2, size.depth / 2
    outline = piece.footprint or ((-w, -d), (w, -d), (w, d), (-w, d))
    return extrude_model(outline, size, parts, piece.category == "building")
