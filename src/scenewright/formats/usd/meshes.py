"""Parts as meshes: points, normals, triangles, a bound material; solid to what moves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from pxr import Sdf, Usd, UsdGeom, UsdPhysics, UsdShade, Vt

from scenewright.core.catalog import Part
from scenewright.formats.gltf.meshes import surfaces_of
from scenewright.formats.gltf.surfaces import GlbSurface, surface
from scenewright.formats.simulation.masses import is_soft
from scenewright.formats.usd.materials import PLACES, MaterialScope, linear_color, material_path
from scenewright.formats.usd.names import free_path
from scenewright.formats.usd.physics import approximation_of
from scenewright.geometry.prisms import normals_of


def define_parts(
    stage: Usd.Stage,
    parent: Sdf.Path,
    parts: Sequence[Part],
    scope: MaterialScope,
    moves: bool = False,
) -> None:
    """A mesh a part below ``parent``, of a body that ``moves`` or not; materials are made once."""
    for part, found in zip(parts, _surfaces(parts, scope), strict=True):
        points, ways = (rows[:, [0, 2, 1]] * [1, -1, 1] for rows in found[:2])
        mesh = UsdGeom.Mesh.Define(stage, free_path(stage, parent, part.material.name))
        mesh.CreatePointsAttr(_vectors(points))
        mesh.CreateNormalsAttr(_vectors(ways))
        mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
        indices = found.indices.astype(np.int32)
        mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(indices))
        mesh.CreateFaceVertexCountsAttr(Vt.IntArray(len(indices) // 3, 3))
        mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
        mesh.CreateExtentAttr(_vectors(np.stack([points.min(0), points.max(0)])))
        mesh.CreateDisplayColorAttr([linear_color(part.material)])
        if found.places is not None:
            _place_texture(mesh, found.places)
        if not is_soft(part.material.name):
            UsdPhysics.CollisionAPI.Apply(mesh.GetPrim())
            touched = UsdPhysics.MeshCollisionAPI.Apply(mesh.GetPrim())
            touched.CreateApproximationAttr(approximation_of(part, moves))
        path = material_path(stage, scope, part.material)
        binding = UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim())
        binding.Bind(UsdShade.Material(stage.GetPrimAtPath(path)))


def _surfaces(parts: Sequence[Part], scope: MaterialScope) -> Iterator[GlbSurface]:
    """The surfaces of parts, with places on textures where these can be held."""
    if scope.pictures is not None:
        return surfaces_of(parts)
    normals = normals_of([(part.vertices, part.faces) for part in parts])
    return (surface(part, corners) for part, corners in zip(parts, normals, strict=True))


def _place_texture(mesh: UsdGeom.Mesh, places: np.ndarray) -> None:
    """Places on the texture: across, and up from its lower edge (theirs are down)."""
    rows = np.ascontiguousarray(places * np.array([1.0, -1.0], np.float32))
    kind = Sdf.ValueTypeNames.TexCoord2fArray
    primvar = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(PLACES, kind, UsdGeom.Tokens.vertex)
    primvar.Set(Vt.Vec2fArray.FromNumpy(rows))


def _vectors(rows: np.ndarray) -> Vt.Vec3fArray:
    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(rows, np.float32))
