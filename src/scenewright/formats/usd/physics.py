"""What moves: rigid bodies with their mass, joints with their limits, how materials rub.

Both frames of a joint lie on its axis, which is their x. What it turns by or slides by is that of
the second against the first: so where a body is drawn open, its frame is turned or moved by that.
A body that moves is touched by convex pieces, one that stands still by its triangles.
"""

from __future__ import annotations

from math import degrees, isfinite

import numpy as np
from pxr import Gf, Sdf, Usd, UsdPhysics

from scenewright.core.catalog import Part
from scenewright.formats.simulation.masses import mass_of, substance_of
from scenewright.geometry.joints import Joint
from scenewright.geometry.mesh import Floats

CONVEX = 1e-4
"""How far a corner may stand before a face of a solid that is taken as convex, in metres."""
DAMPING = {"hinge": 0.6, "slide": 6.0}
"""What slows a joint, in N m s a radian or N s a metre: a front stays where it is left."""


def make_body(prim: Usd.Prim, parts: tuple[Part, ...]) -> None:
    """A rigid body of the mass of its parts, at rest until something touches it."""
    body = UsdPhysics.RigidBodyAPI.Apply(prim)
    body.CreateStartsAsleepAttr(True)
    UsdPhysics.MassAPI.Apply(prim).CreateMassAttr(round(mass_of(parts), 3))


def approximation_of(part: Part, moves: bool) -> str:
    """How a mesh is touched."""
    if not moves:
        return "none"
    return "convexHull" if is_convex(part) else "convexDecomposition"


def is_convex(part: Part) -> bool:
    """Whether no corner of a mesh stands before one of its faces.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.prisms import box
    >>> is_convex(Part(Material("oak", (0.7, 0.5, 0.3)), *box((0, 0, 0), (0.8, 0.04, 2.0))[:2]))
    True
    """
    a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    normals = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12)
    ahead = part.vertices @ normals.T - np.einsum("ij,ij->i", normals, a)
    return bool(ahead.max() < CONVEX)


def define_joint(
    stage: Usd.Stage, path: Sdf.Path, joint: Joint, frame: Sdf.Path, body: Sdf.Path
) -> None:
    """The joint by which a body moves against the frame of its model, where it is drawn."""
    hinge = joint.kind == "hinge"
    kind = UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint
    made = kind.Define(stage, path)
    made.CreateBody0Rel().SetTargets([frame])
    made.CreateBody1Rel().SetTargets([body])
    made.CreateAxisAttr(UsdPhysics.Tokens.x)
    along = Gf.Rotation(Gf.Vec3d(1, 0, 0), Gf.Vec3d(*joint.axis))
    turn = Gf.Rotation(Gf.Vec3d(1, 0, 0), degrees(joint.at) if hinge else 0.0)
    pivot = np.array(joint.pivot)
    shut = pivot if hinge else pivot - joint.at * np.array(joint.axis)
    for place, at, rotation in ((0, shut, along), (1, pivot, turn * along)):
        made.GetPrim().GetAttribute(f"physics:localPos{place}").Set(_point(at))
        made.GetPrim().GetAttribute(f"physics:localRot{place}").Set(Gf.Quatf(rotation.GetQuat()))
    if isfinite(joint.lower):
        made.CreateLowerLimitAttr(_reach(joint.lower, hinge))
    if isfinite(joint.upper):
        made.CreateUpperLimitAttr(_reach(joint.upper, hinge))
    drive = UsdPhysics.DriveAPI.Apply(made.GetPrim(), "angular" if hinge else "linear")
    drive.CreateDampingAttr(DAMPING[joint.kind] / (degrees(1.0) if hinge else 1.0))


def rub(prim: Usd.Prim, name: str) -> None:
    """The friction and density of a material."""
    substance = substance_of(name)
    made = UsdPhysics.MaterialAPI.Apply(prim)
    made.CreateStaticFrictionAttr(substance.friction)
    made.CreateDynamicFrictionAttr(substance.friction)
    made.CreateDensityAttr(substance.density)


def _point(values: Floats) -> Gf.Vec3f:
    return Gf.Vec3f(*(round(float(value), 6) for value in values))


def _reach(value: float, hinge: bool) -> float:
    return round(degrees(value) if hinge else value, 5)
