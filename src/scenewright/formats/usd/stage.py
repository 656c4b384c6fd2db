"""The stage of a scene: levels with rooms and their pieces, the shell, lights, cameras."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

import numpy as np
from pxr import Gf, Kind, Sdf, Usd, UsdGeom, UsdPhysics, UsdSemantics

from scenewright._version import __version__
from scenewright.catalog import credits as authorship
from scenewright.core.catalog import Catalog, Part
from scenewright.core.scene import Scene
from scenewright.formats.png import OPEN
from scenewright.formats.simulation.masses import is_free
from scenewright.formats.usd.cameras import define_cameras
from scenewright.formats.usd.lights import define_daylight, define_lamps
from scenewright.formats.usd.materials import MaterialScope
from scenewright.formats.usd.meshes import define_parts
from scenewright.formats.usd.names import free_path, prim_name
from scenewright.formats.usd.physics import define_joint, make_body
from scenewright.render.bodies import split_bodies
from scenewright.render.items import RenderItem, things
from scenewright.render.observations.ceilings import ceilings
from scenewright.render.observations.world import category_of

ROOT = Sdf.Path("/Scene")
MATERIALS, PROTOTYPES = ROOT.AppendChild("Materials"), ROOT.AppendChild("Prototypes")
GRAVITY = 9.81
"""Metres a second squared."""
BRANCHES = {"wall": "Walls", "opening": "Openings", "stairs": "Stairs", "ceiling": "Ceilings"}
"""Scopes of a level for what belongs to no room."""


@dataclass(frozen=True, slots=True)
class Building:
    """A stage as it is built: the ``stage``, how often each key is ``drawn``, its ``materials``,
    the ``catalog``, the paths of what is drawn more than once as ``prototypes`` by key and body,
    and the ``places`` of items by name."""

    stage: Usd.Stage
    drawn: Counter[Hashable]
    materials: MaterialScope
    catalog: Catalog
    prototypes: dict[Hashable, Sdf.Path] = field(default_factory=dict)
    places: dict[str, Sdf.Path] = field(default_factory=dict)


def build_stage(
    scene: Scene, catalog: Catalog, pictures: dict[str, bytes] | None = None
) -> Usd.Stage:
    """The stage in memory; the files of its textures are added to ``pictures``, by the paths under
    which it names them (None: plain colours)."""
    stage = _new_stage(scene, catalog)
    open_air = any(OPEN & set(space.functions) for space in scene.spaces)
    items = [one for one in (*things(scene, catalog), *ceilings(scene)) if one.parts]
    built = Building(
        stage, Counter(one.key for one in items), MaterialScope(MATERIALS, pictures), catalog
    )
    for level in scene.levels:
        path = free_path(stage, ROOT, level.name or f"level {level.id or 1}")
        xform = _define_group(stage, path, level.name)
        xform.AddTranslateOp().Set(Gf.Vec3d(0.0, 0.0, float(level.elevation)))
        _add_level(built, path, [one for one in items if one.level == level.id], scene)
    define_lamps(stage, items, built.places, catalog)
    define_daylight(stage, ROOT, scene.hour)
    if not open_air:
        cameras = _define_scope(stage, ROOT.AppendChild("Cameras"))
        define_cameras(stage, cameras, scene, catalog)
    return stage


def _new_stage(scene: Scene, catalog: Catalog) -> Usd.Stage:
    """A stage with its units, axes, credits, gravity and scopes."""
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdPhysics.SetStageKilogramsPerUnit(stage, 1.0)
    root = UsdGeom.Xform.Define(stage, ROOT)
    Usd.ModelAPI(root).SetKind(Kind.Tokens.assembly)
    root.GetPrim().SetDisplayName(scene.name or "scene")
    stage.SetDefaultPrim(root.GetPrim())
    made = authorship.credits_of(scene.pieces, catalog)
    authors = authorship.with_sources(made, scene.sources)
    facts = {"creator": f"Scenewright {__version__}"}
    stage.GetRootLayer().customLayerData = facts | (
        {"copyright": authorship.line(authors)} if authors else {}
    )
    _define_scope(stage, MATERIALS)
    stage.CreateClassPrim(PROTOTYPES)
    physics = UsdPhysics.Scene.Define(stage, ROOT.AppendChild("Physics"))
    physics.CreateGravityDirectionAttr(Gf.Vec3f(0.0, 0.0, -1.0))
    physics.CreateGravityMagnitudeAttr(GRAVITY)
    return stage


def _define_scope(stage: Usd.Stage, path: Sdf.Path) -> Sdf.Path:
    return UsdGeom.Scope.Define(stage, path).GetPath()


def _define_group(stage: Usd.Stage, path: Sdf.Path, name: str) -> UsdGeom.Xform:
    """A place in the tree of models: things below it are chosen as one, or each."""
    xform = UsdGeom.Xform.Define(stage, path)
    Usd.ModelAPI(xform).SetKind(Kind.Tokens.group)
    if name:
        xform.GetPrim().SetDisplayName(name)
    return xform


def _add_level(built: Building, top: Sdf.Path, items: Sequence[RenderItem], scene: Scene) -> None:
    """The rooms of a level with their floors and pieces, and the scopes of what is built."""
    rooms: dict[str, Sdf.Path] = {}
    spaces = {space.id: space for space in scene.spaces}
    for item in items:
        space = spaces.get(item.space)
        parent = rooms.get(item.space, top)
        if item.kind in BRANCHES:
            name = BRANCHES[item.kind]
            parent = (
                rooms.get(name)
                or _define_group(built.stage, free_path(built.stage, top, name), "").GetPath()
            )
            rooms[name] = parent
        elif space is not None and item.space not in rooms:
            path = free_path(built.stage, top, space.name or space.id)
            parent = _define_group(built.stage, path, space.name or space.id).GetPath()
            _label(built.stage.GetPrimAtPath(path), "room", space.functions)
            rooms[item.space] = parent
        _add_item(built, parent, item)


def _add_item(built: Building, parent: Sdf.Path, item: RenderItem) -> None:
    """An item at its place, with what is known of it and its shape."""
    stage = built.stage
    name = "Floor" if item.kind == "space" else item.name.rpartition("/")[2] or item.name
    path = free_path(stage, parent, name)
    xform = UsdGeom.Xform.Define(stage, path)
    if any(item.at):
        xform.AddTranslateOp().Set(Gf.Vec3d(*(float(value) for value in item.at)))
    if item.turn:
        xform.AddRotateZOp(UsdGeom.XformOp.PrecisionDouble).Set(float(np.rad2deg(item.turn)))
    prim = xform.GetPrim()
    Usd.ModelAPI(prim).SetKind(Kind.Tokens.component)
    prim.SetDisplayName(item.name)
    facts = {key: fact for key, fact in item.extras.items() if key != "space"}
    prim.SetCustomDataByKey("scenewright", {"id": item.name, **facts})
    _label(prim, "class", (category_of(item),))
    built.places[item.name] = path
    _add_bodies(built, path, item)


def _add_bodies(built: Building, path: Sdf.Path, item: RenderItem) -> None:
    """The shape of an item; of one that has bodies the frame that they move against, the bodies
    and their joints."""
    stage = built.stage
    still, bodies = split_bodies(item.parts)
    free = is_free(item, built.catalog)
    frame = path.AppendChild("Frame") if bodies else path
    if bodies:
        UsdGeom.Xform.Define(stage, frame)
    if free:
        make_body(stage.GetPrimAtPath(frame), still)
    _add_shape(built, frame.AppendChild("Shape"), item, still, "", free)
    for body in bodies:
        name = prim_name(body.joint.body)
        moved = UsdGeom.Xform.Define(stage, path.AppendChild(name))
        make_body(moved.GetPrim(), body.parts)
        _add_shape(built, moved.GetPath().AppendChild("Shape"), item, body.parts, name, True)
        joint = path.AppendChild(f"{name}_joint")
        define_joint(stage, joint, body.joint, frame, moved.GetPath())


def _add_shape(
    built: Building, path: Sdf.Path, item: RenderItem, parts: Sequence[Part], body: str, moves: bool
) -> None:
    """The meshes of a body of an item, or an instance of those it shares with others."""
    stage, key = built.stage, (item.key, body, moves)
    shape = UsdGeom.Xform.Define(stage, path).GetPrim()
    if built.drawn[item.key] == 1 or not parts:
        define_parts(stage, path, parts, built.materials, moves)
        return
    if key not in built.prototypes:
        name = str(item.extras.get("asset") or category_of(item)).rpartition(":")[2]
        proto = free_path(stage, PROTOTYPES, f"{name} {body}".strip())
        UsdGeom.Xform.Define(stage, proto)
        define_parts(stage, proto, parts, built.materials, moves)
        built.prototypes[key] = proto
    shape.GetReferences().AddInternalReference(built.prototypes[key])
    shape.SetInstanceable(True)


def _label(prim: Usd.Prim, kind: str, words: Sequence[str]) -> None:
    """What it is, for a machine that learns to see: labels of a kind."""
    labels = UsdSemantics.LabelsAPI.Apply(prim, kind)
    labels.CreateLabelsAttr([word for word in words if word])
