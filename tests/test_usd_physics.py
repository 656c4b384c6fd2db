"""What moves in USD files: as many bodies and joints as in the scene, where they are drawn."""

from __future__ import annotations

from math import degrees, inf

import numpy as np
import pytest

pytest.importorskip("pxr")

from pxr import Gf, Usd, UsdGeom, UsdPhysics

from flat import flat_solution
from scenewright.catalog.assets import shipped
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.formats import write
from scenewright.formats.simulation.masses import is_free, mass_of
from scenewright.formats.usd.names import prim_name
from scenewright.geometry.joints import Joint
from scenewright.render.bodies import split_bodies
from scenewright.render.items import RenderItem, things
from test_joints import moved
from test_usd import EVERYTHING, by_id, faults, prims


def furnished() -> Solution:
    """The flat of two rooms with things that open, slide and turn."""
    from dataclasses import replace

    flat = flat_solution()
    new = (
        Piece("chest", "chest_of_drawers", "", "living", Pose(1, 3, 0, 0.0), Size(1, 0.45, 0.85)),
        Piece("closet", "wardrobe", "", "living", Pose(3, 3.5, 0, -1.57), Size(1.5, 0.6, 2.2)),
        Piece("swivel", "office_chair", "", "bedroom", Pose(6, 2, 0, 0.3), Size(0.6, 0.6, 0.95)),
        Piece("stool", "stool", "", "bedroom", Pose(7, 2, 0, 0.3), Size(0.4, 0.4, 0.45)),
    )
    return replace(flat, pieces=(*flat.pieces, *new))


@pytest.fixture(scope="module")
def items() -> tuple[RenderItem, ...]:
    return things(scene_of(furnished()), shipped())


@pytest.fixture(scope="module")
def stage(tmp_path_factory: pytest.TempPathFactory) -> Usd.Stage:
    path = tmp_path_factory.mktemp("usd") / "flat.usda"
    write(furnished(), path)
    return Usd.Stage.Open(str(path))


def test_bodies_and_joints_are_as_many_as_in_the_scene(
    stage: Usd.Stage, items: tuple[RenderItem, ...]
) -> None:
    assert faults(stage) == []
    joints = [body.joint for item in items for body in split_bodies(item.parts)[1]]
    free = [item for item in items if is_free(item, shipped())]
    bodies = [p for p in stage.Traverse() if p.HasAPI(UsdPhysics.RigidBodyAPI)]
    assert len(bodies) == len(joints) + len(free)
    assert len(free) >= 3
    hinges = [joint for joint in joints if joint.kind == "hinge"]
    assert len(prims(stage, UsdPhysics.RevoluteJoint)) == len(hinges) > 4
    assert len(prims(stage, UsdPhysics.PrismaticJoint)) == len(joints) - len(hinges) > 2


def test_openusd_finds_the_same_bodies(stage: Usd.Stage) -> None:
    """What the library that engines load scenes with makes of it."""
    loaded = UsdPhysics.UsdPhysicsLoadStageFromPrimRange(stage, ["/"])
    kinds = UsdPhysics.ObjectType
    counted = {kind: len(loaded[kind][0]) for kind in loaded}
    bodies = [p for p in stage.Traverse() if p.HasAPI(UsdPhysics.RigidBodyAPI)]
    assert counted[kinds.RigidBody] == len(bodies)
    assert counted[kinds.RevoluteJoint] == len(prims(stage, UsdPhysics.RevoluteJoint))
    assert counted[kinds.PrismaticJoint] == len(prims(stage, UsdPhysics.PrismaticJoint))
    assert counted[kinds.Scene] == 1
    meshes = prims(stage, UsdGeom.Mesh)
    touched = [mesh for mesh in meshes if mesh.HasAPI(UsdPhysics.CollisionAPI)]
    assert len(meshes) >= counted[kinds.MeshShape] == len(touched) > 0.8 * len(meshes)


def frame(joint: Usd.Prim, number: int) -> np.ndarray:
    """A frame of a joint in that of its body, as a matrix for columns."""
    turn = Gf.Matrix3d(joint.GetAttribute(f"physics:localRot{number}").Get())
    found = np.eye(4)
    found[:3, :3] = np.array(turn).T
    found[:3, 3] = joint.GetAttribute(f"physics:localPos{number}").Get()
    return found


def travel(joint: Joint, value: float) -> np.ndarray:
    """From frame to frame of a joint at a value: along or about x."""
    found = np.eye(4)
    if joint.kind == "slide":
        found[0, 3] = value
    else:
        cos, sin = np.cos(value), np.sin(value)
        found[1:3, 1:3] = [[cos, -sin], [sin, cos]]
    return found


def test_joints_stand_and_move_as_the_models_do(
    stage: Usd.Stage, items: tuple[RenderItem, ...]
) -> None:
    found = by_id(stage)
    for item in items:
        for body in split_bodies(item.parts)[1]:
            joint = body.joint
            path = found[item.name].GetPath().AppendChild(f"{prim_name(joint.body)}_joint")
            prim = stage.GetPrimAtPath(path)
            first, second = frame(prim, 0), frame(prim, 1)
            assert np.allclose(first @ travel(joint, joint.at), second, atol=1e-5)
            value = min(joint.upper, 0.7)
            moving = first @ travel(joint, value) @ np.linalg.inv(second)
            for part in body.parts:
                there = part.vertices @ moving[:3, :3].T + moving[:3, 3]
                assert np.allclose(there, moved(part, joint, value), atol=1e-4)
            api = (
                UsdPhysics.RevoluteJoint(prim)
                if joint.kind == "hinge"
                else UsdPhysics.PrismaticJoint(prim)
            )
            unit = degrees(1.0) if joint.kind == "hinge" else 1.0
            for limit, attribute in (
                (joint.lower, api.GetLowerLimitAttr()),
                (joint.upper, api.GetUpperLimitAttr()),
            ):
                assert attribute.Get() == pytest.approx(limit * unit, abs=1e-4)
                assert attribute.HasAuthoredValue() == (abs(limit) < inf)


def test_bodies_weigh_what_their_parts_weigh(
    stage: Usd.Stage, items: tuple[RenderItem, ...]
) -> None:
    found = by_id(stage)
    for item in items:
        for body in split_bodies(item.parts)[1]:
            prim = found[item.name].GetChild(prim_name(body.joint.body))
            mass = UsdPhysics.MassAPI(prim).GetMassAttr().Get()
            assert mass == pytest.approx(mass_of(body.parts), abs=1e-3)


def test_what_moves_is_touched_by_convex_pieces(stage: Usd.Stage) -> None:
    kinds = set()
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), EVERYTHING):
        if prim.HasAPI(UsdPhysics.MeshCollisionAPI):
            above = prim
            while above and not above.HasAPI(UsdPhysics.RigidBodyAPI):
                above = above.GetParent()
            touched = UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get()
            assert (touched == "none") == (not above), prim.GetPath()
            kinds.add(touched)
    assert kinds == {"none", "convexHull", "convexDecomposition"}


def test_a_swivel_chair_turns_and_rolls(stage: Usd.Stage) -> None:
    chair = by_id(stage)["swivel"]
    assert chair.GetChild("Frame").HasAPI(UsdPhysics.RigidBodyAPI)
    (joint,) = [child for child in chair.GetChildren() if child.IsA(UsdPhysics.RevoluteJoint)]
    assert joint.GetName() == "seat_1_joint"
