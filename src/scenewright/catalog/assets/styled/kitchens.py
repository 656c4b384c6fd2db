"""Kitchen units in the forms of styles: the usual units behind other fronts and handles."""

from __future__ import annotations

from functools import partial
from math import pi

from scenewright.catalog.assets.bodies import attach_joint
from scenewright.catalog.assets.declared import drawings_of
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture import kitchen
from scenewright.catalog.assets.joinery import GAP
from scenewright.catalog.assets.materials import BLACK, CREAM, SAGE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.styled.forms import FORMS, Form, add, draw_fronts, draw_handles
from scenewright.core.catalog import Mesher
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Floats, Mesh, rotate_mesh
from scenewright.geometry.solids import block

FURNITURE = "scenewright.catalog.assets.furniture"
UNITS = (
    "base_cabinet",
    "drawer_cabinet",
    "tall_cabinet",
    "wall_cabinet",
    "sink_cabinet",
    "hob_cabinet",
    "oven_cabinet",
    "corner_cabinet",
    "kitchen_island",
)
TALL = 0.5
"""Fronts higher than this and higher than wide are doors, metres."""


def _boxes(vertices: Floats) -> list[tuple[Floats, Floats]]:
    """The lowest and highest corner of each of the boxes that fronts are drawn as."""
    return [(box.min(0), box.max(0)) for box in vertices.reshape(-1, 8, 3)]


def _front(form: Form, low: Floats, high: Floats, hung: bool) -> Stuff:
    """A front of the form in the place of a plain one, which looks to +y or, at the back of an
    island, to -y; one that looks aside stays plain. Those of ``hung`` cabinets have no handle."""
    wide, deep, _ = high - low
    if deep > wide:
        return add({}, {SAGE: [_box(low, high)]})
    turned = bool(low[1] + high[1] < 0)
    x = (float(-high[0]), float(-low[0])) if turned else (float(low[0]), float(high[0]))
    y = (float(-high[1]), float(-low[1])) if turned else (float(low[1]), float(high[1]))
    x, z = (x[0] - GAP, x[1] + GAP), (float(low[2]) - GAP, float(high[2]) + GAP)
    door = z[1] - z[0] > max(TALL, x[1] - x[0])
    found = draw_fronts(form, x, z, 1, 1, y, SAGE)
    if not hung:
        add(found, draw_handles(form, x, z, 1, 1, y[1], kitchen.HANDLE, door))
    if not turned:
        return found
    return {m: [rotate_mesh(one, "z", pi) for one in meshes] for m, meshes in found.items()}


def _box(low: Floats, high: Floats) -> Mesh:
    return block(*((float(a), float(b)) for a, b in zip(low, high, strict=True)))


def _unit(form: Form, plain: Mesher, size: Size) -> Parts:
    """The plain unit with the fronts and handles of a form."""
    found: Stuff = {}
    for part in plain(size):
        if part.material in (SAGE, CREAM):
            for low, high in _boxes(part.vertices):
                made = _front(form, low, high, part.material is CREAM)
                add(found, {material: attach_joint(part.joint, m) for material, m in made.items()})
        elif part.material is not BLACK:
            add(found, {part.material: [Mesh(part.vertices, part.faces, part.joint)]})
    return parts(size, found)


def _units() -> tuple[Drawing, ...]:
    plain = {
        row.category: row
        for name in ("kitchen", "cooking")
        for row in drawings_of(f"{FURNITURE}.{name}")
    }
    return tuple(
        plain[category]._replace(
            mesh=partial(_unit, form, plain[category].mesh),
            id=f"{category}_{form.name}",
            name=f"{form.name.capitalize()} {category.replace('_', ' ')}",
            style=form.name,
        )
        for category in UNITS
        for form in FORMS.values()
    )


ASSETS = _units()
