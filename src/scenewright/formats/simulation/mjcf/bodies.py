"""Things as bodies of an MJCF model: what is seen, what can be touched, what moves and how."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from scenewright.core.catalog import Catalog, Part
from scenewright.formats.simulation.masses import is_free, is_soft, substance_of, weigh
from scenewright.formats.simulation.mjcf.assets import (
    Assets,
    name_hull,
    name_material,
    name_mesh,
    quaternion,
    write_numbers,
)
from scenewright.formats.simulation.solids import HOLLOW, ConvexSolid, solids_of
from scenewright.geometry.joints import Joint
from scenewright.geometry.mesh import Floats
from scenewright.render.bodies import split_bodies
from scenewright.render.items import RenderItem

SOFT_HOLLOW, SOFT = 0.05, 100.0
"""Hulls of what is lighter than this, in kg/m³, may fill deeper hollows: it gives way."""
HUNG = {"hinge": ("0.6", "0.25", "0.02"), "slide": ("6", "2.5", "0.2")}
"""Damping, dry friction and armature of joints, in N m s, N m, kg m² or N s/m, N, kg."""


@dataclass(frozen=True, slots=True)
class World:
    """A model as it is built: the world and what it refers to; where its joints stand as drawn and
    with all shut, in the order of the model, which is that of the file."""

    element: Element
    assets: Assets
    drawn: list[float] = field(default_factory=list)
    shut: list[float] = field(default_factory=list)


def add_item(world: World, item: RenderItem, elevation: float, catalog: Catalog) -> None:
    """One thing with the bodies that move against it; free where somebody may move it."""
    still, bodies = split_bodies(item.parts)
    x, y, z = item.at
    place = (x, y, z + elevation)
    turn = (np.cos(item.turn / 2), 0.0, 0.0, np.sin(item.turn / 2))
    name = world.assets.free_name(item.name)
    whole = SubElement(world.element, "body", {"name": name, "pos": write_numbers(place)})
    if item.turn:
        whole.set("quat", write_numbers(turn, 9))
    touched = _touches(item, catalog)
    if is_free(item, catalog):
        SubElement(whole, "freejoint", {"name": f"{name} free"})
        for values in (world.drawn, world.shut):
            values += [*place, *turn]
    add_parts(world.assets, whole, item, still, np.zeros(3), touched)
    for body in bodies:
        pivot = np.array(body.joint.pivot)
        called = world.assets.free_name(f"{name} {body.joint.body}")
        child = SubElement(whole, "body", {"name": called, "pos": write_numbers(pivot)})
        _add_joint(child, body.joint)
        world.drawn.append(body.joint.at)
        world.shut.append(0.0)
        add_parts(world.assets, child, item, body.parts, -pivot, touched)


def _add_joint(body: Element, joint: Joint) -> None:
    """The joint of a body that is drawn where it stands ``at``; ``ref`` says so."""
    damping, friction, armature = HUNG[joint.kind]
    SubElement(
        body,
        "joint",
        {
            "name": body.get("name", ""),
            "type": joint.kind,
            "axis": write_numbers(joint.axis, 9),
            "range": write_numbers((joint.lower, joint.upper)),
            "ref": write_numbers((joint.at,)),
            "damping": damping,
            "frictionloss": friction,
            "armature": armature,
        },
    )


def add_parts(
    assets: Assets,
    body: Element,
    item: RenderItem,
    parts: Sequence[Part],
    shift: Floats,
    touched: bool = True,
) -> None:
    """What is seen of a body, and what can be touched, all moved by ``shift`` in its frame."""
    for part in parts:
        key = (item.key, part.joint and part.joint.body, part.material)
        mesh = name_mesh(assets, key, part, shift)
        if mesh is not None:
            material = name_material(assets, part.material)
            SubElement(body, "geom", {"class": "seen", "mesh": mesh, "material": material})
        if touched and not is_soft(part.material.name):
            for number, solid in enumerate(_solids(part)):
                add_solid(assets, body, part, solid, shift, (key, number))


def add_solid(
    assets: Assets, body: Element, part: Part, solid: ConvexSolid, shift: Floats, key: Hashable
) -> None:
    """One solid that can be touched, with its mass and friction."""
    mass = weigh(part.material.name, solid.volume, solid.area)
    facts = {
        "class": "touched",
        "type": solid.form if solid.form != "hull" else "mesh",
        "pos": write_numbers(solid.middle + shift),
        "mass": write_numbers((max(mass, 1e-4),)),
        "friction": write_numbers((substance_of(part.material.name).friction, 0.005, 0.0001)),
    }
    if solid.form == "hull":
        facts["mesh"] = name_hull(assets, key, solid.corners)
    else:
        sides = solid.sides if solid.form == "box" else solid.sides[:2]
        facts["size"] = write_numbers(sides)
        facts["quat"] = write_numbers(quaternion(solid.axes), 7)
    SubElement(body, "geom", facts)


def _solids(part: Part) -> tuple[ConvexSolid, ...]:
    light = substance_of(part.material.name).density < SOFT
    return _solids_of(Shape(part), SOFT_HOLLOW if light else HOLLOW)


class Shape:
    """A part whose triangles are told apart by being the same ones: models are drawn once and kept,
    whatever they are painted in."""

    __slots__ = ("part",)

    def __init__(self, part: Part) -> None:
        self.part = part

    def __hash__(self) -> int:
        return hash((id(self.part.vertices), id(self.part.faces)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Shape):
            return False
        mine, theirs = self.part, other.part
        return mine.vertices is theirs.vertices and mine.faces is theirs.faces


@lru_cache(maxsize=8192)
def _solids_of(shape: Shape, hollow: float) -> tuple[ConvexSolid, ...]:
    return solids_of(shape.part, hollow)


def _touches(item: RenderItem, catalog: Catalog) -> bool:
    """Whether a thing can be bumped into: rugs and what hangs as cloth cannot."""
    kind = catalog.kinds.get(str(item.extras.get("category", "")))
    return item.kind != "piece" or kind is None or not kind.flat
