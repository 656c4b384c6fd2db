"""The forms of a style: how its legs stand, its doors are made and its handles look.

A :class:`Form` is one row; the modules beside this one draw sofas, beds, tables, cases, kitchens
and lamps from it. Forms are shapes alone: colours come from the palette a home is painted in
(:mod:`scenewright.building.palettes`), which takes the place of the materials named here.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Literal, NamedTuple

from scenewright.catalog.assets.bodies import Opens, attach_joint, front_joint
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import (
    GAP,
    door_pulls,
    drawer_pulls,
    four_legs,
    knobs,
    spread,
)
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    CREAM,
    LEATHER,
    OAK,
    RATTAN,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.core.catalog import Covering, Material, Symbol, covers_box
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, frame, lathe, rod

Legs = Literal["tapered", "turned", "sled", "board", "splayed", "cross"]
Front = Literal["lipped", "framed", "planked", "slatted", "inset", "cane"]
Handle = Literal["none", "knob", "bar", "tab", "disc"]


class Form(NamedTuple):
    """A style's shapes: ``legs`` of furniture that stands on four, ``front`` of doors and drawers
    with their ``handle``, the material the doors of cases are of (``panel``), the ``lift`` of cases
    above the floor and the ``edge`` radius of tops, metres."""

    name: str
    legs: Legs
    front: Front
    handle: Handle
    panel: Material
    lift: float
    edge: float


FORMS: dict[str, Form] = {
    form.name: form
    for form in (
        Form("nordic", "tapered", "lipped", "none", WHITE, 0.16, 0.06),
        Form("classic", "turned", "framed", "knob", CREAM, 0.08, 0.012),
        Form("industrial", "sled", "planked", "bar", OAK, 0.14, 0.004),
        Form("japandi", "board", "slatted", "none", OAK, 0.05, 0.02),
        Form("retro", "splayed", "inset", "disc", WALNUT, 0.2, 0.12),
        Form("boho", "cross", "cane", "tab", RATTAN, 0.12, 0.04),
    )
}

FormedMesher = Callable[[Form, Size], Parts]


def draw_forms(
    category: str, mesh: FormedMesher, symbol: Symbol, footprint: Covering = covers_box
) -> tuple[Drawing, ...]:
    """One drawing a form of a kind.

    >>> [row.id for row in draw_forms("stool", lambda form, size: (), lambda size: ())][:2]
    ['stool_nordic', 'stool_classic']
    """
    label = category.replace("_", " ")
    return tuple(
        Drawing(
            category,
            partial(mesh, form),
            symbol,
            id=f"{category}_{form.name}",
            name=f"{form.name.capitalize()} {label}",
            footprint=footprint,
            style=form.name,
        )
        for form in FORMS.values()
    )


TALL = 0.55
"""What is higher is a table with seats at it: its legs stay in :data:`CORNER` of its corners."""
CORNER = 0.055
"""How far legs of tables reach in from a short side, metres: a chair stands beside each."""
PUSHED_IN = 0.22
"""How far under a table its chairs reach, metres: legs and aprons stay clear of it."""


def add(found: Stuff, more: Stuff) -> Stuff:
    """The meshes of both by material, in the first."""
    for material, meshes in more.items():
        found.setdefault(material, []).extend(meshes)
    return found


def stand(
    form: Form, w: float, d: float, high: float, wood: Material = OAK, around: bool = False
) -> Stuff:
    """What holds a thing of half sizes ``w`` and ``d`` up to the height ``high``, as its form has
    it: of wood, or of steel. Nothing of a tall one is in the way of chairs that are pushed under
    it from the front, or from all sides ``around``."""
    if high > TALL:
        return _stand_among_chairs(form, w, d, high, wood, around)
    thick = 0.018 if high < 0.3 else 0.026
    match form.legs:
        case "tapered":
            lean = min(0.03, 0.1 * high)
            return {wood: four_legs(w, d, (0, high), thick, 0.6 * thick, 0.03, lean)}
        case "splayed":
            lean = min(0.09, 0.3 * high, 0.4 * min(w, d))
            return {wood: four_legs(w, d, (0, high), thick, 0.5 * thick, 0.01, lean)}
        case "turned":
            return {wood: _turned_legs(w, d, high, 1.5 * thick, 0.015)}
        case "sled":
            return {BLACK: _make_sled(w, d, high, 0.5 * thick, 0.05)}
        case "board":
            return {wood: _boards(w, d - 0.03, high, min(0.14, 0.3 * w))}
    if high < 0.3:
        return {wood: four_legs(w, d, (0, high), thick, thick, 0.02, square=True)}
    return {wood: _crossed_legs(w, d - 0.06, high, thick, 0.14)}


def _stand_among_chairs(
    form: Form, w: float, d: float, high: float, wood: Material, around: bool
) -> Stuff:
    thick = CORNER / 2
    inset, deep = (PUSHED_IN, max(d - PUSHED_IN, 0.3 * d)) if around else (0.03, d - 0.03)
    match form.legs:
        case "tapered" | "splayed":
            lean = 0.03 if form.legs == "tapered" else min(0.09, 0.4 * d)
            return {wood: four_legs(w, d, (0, high), 0.9 * thick, 0.5 * thick, 0, lean, aside=0.01)}
        case "turned":
            return {wood: _turned_legs(w, d, high, thick, 0.0)}
        case "sled":
            return {BLACK: _make_sled(w, d, high, 0.5 * thick, 0.02)}
        case "board":
            return {wood: _boards(w, deep, high, inset)}
    return {wood: _crossed_legs(w, deep, high, 0.9 * thick, inset)}


def _turned_legs(w: float, d: float, high: float, thick: float, edge: float) -> list[Mesh]:
    """Legs off the lathe, ``edge`` from the sides: a foot, a neck, a vase, a square head."""
    rows = [(0.55, 0), (0.75, 0.06), (0.5, 0.14), (0.62, 0.3), (1.0, 0.66), (0.6, 0.8), (1.0, 0.86)]
    rows = rows if high > 0.3 else [(0.5, 0), (0.95, 0.35), (0.6, 0.75)]
    inset = thick + edge
    return [
        lathe(
            [(thick * r, high * z) for r, z in (*rows, (1.0, 1.0))],
            (sx * (w - inset), sy * (d - inset)),
            8,
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]


def _make_sled(w: float, d: float, high: float, half: float, edge: float) -> list[Mesh]:
    """A closed frame of square steel at each end."""
    found = []
    for sign in (-1, 1):
        x = sign * (w - edge - half)
        upright = frame((-d + 0.03, d - 0.03), (x - half, x + half), (0, high), 2 * half)
        found.append(Mesh(upright.vertices[:, [1, 0, 2]], upright.faces[:, ::-1]))
    return found


def _boards(w: float, deep: float, high: float, inset: float) -> list[Mesh]:
    """A board across at each end, drawn in, and a rail between them."""
    ends = [
        block((s * (w - inset) - 0.018, s * (w - inset) + 0.018), (-deep, deep), (0, high))
        for s in (-1, 1)
    ]
    rail = (0.7 * high, 0.9 * high) if high > TALL else (0.35 * high, 0.6 * high)
    return [*ends, block((-w + inset, w - inset), (-0.015, 0.015), rail)]


def _crossed_legs(w: float, deep: float, high: float, thick: float, inset: float) -> list[Mesh]:
    """Two crossed bars at each end and a rail where they meet."""
    level = 0.85 * high if high > TALL else high / 2
    found = [rod((-w + inset, 0, level), (w - inset, 0, level), 0.7 * thick)]
    for sx in (-1, 1):
        x = sx * (w - inset)
        for sy in (-1, 1):
            found.append(rod((x, sy * deep, 0.004), (x, -sy * deep, high), thick))
    return found


def draw_fronts(
    form: Form,
    x: Interval,
    z: Interval,
    columns: int,
    rows: int,
    y: Interval,
    panel: Material,
    opens: Opens = "drawer",
) -> Stuff:
    """A grid of doors or drawers of a ``panel`` material between two depths, made as the form has
    it, with gaps between; each is a body, as in :func:`~.joinery.fronts`."""
    found: Stuff = {}
    for i, (a, b) in enumerate(spread(*x, columns)):
        for c, e in spread(*z, rows):
            across, up = (a + GAP, b - GAP), (c + GAP, e - GAP)
            joint = front_joint(opens, across, up, y, right=bool(i % 2))
            plain = min(across[1] - across[0], up[1] - up[0]) < 0.12
            made = {panel: [block(across, y, up)]}
            made = made if plain else _draw_front(form, across, up, y, panel)
            add(found, {material: attach_joint(joint, own) for material, own in made.items()})
    return found


def _draw_front(form: Form, x: Interval, z: Interval, y: Interval, panel: Material) -> Stuff:
    deep = y[1] - y[0]
    back, middle = (y[0], y[0] + 0.55 * deep), y[0] + 0.55 * deep
    rim = min(0.06, 0.22 * min(x[1] - x[0], z[1] - z[0]))
    inner = ((x[0] + rim, x[1] - rim), (z[0] + rim, z[1] - rim))
    match form.front:
        case "lipped":
            lip = block(
                (x[0] + 0.2 * (x[1] - x[0]), x[1] - 0.2 * (x[1] - x[0])), y, (z[1] - 0.02, z[1])
            )
            return {panel: [block(x, y, (z[0], z[1] - 0.022))], OAK: [lip]}
        case "framed":
            flat = block((inner[0][0] - 0.004, inner[0][1] + 0.004), back, _widen(inner[1], 0.004))
            return {panel: [frame(x, y, z, rim), flat]}
        case "planked":
            boards = spread(*z, max(1, min(5, round((z[1] - z[0]) / 0.16))))
            return {panel: [block(x, y, (a + 0.002, b - 0.002)) for a, b in boards]}
        case "slatted":
            strips = spread(*x, max(3, min(18, round((x[1] - x[0]) / 0.045))))
            fins = [
                block((a + 0.25 * (b - a), b - 0.25 * (b - a)), (middle - 0.001, y[1]), z)
                for a, b in strips
            ]
            return {panel: [block(x, back, z), *fins]}
        case "inset":
            return {
                WALNUT: [frame(x, y, z, 0.4 * rim)],
                panel: [block(_widen(x, -0.4 * rim), back, _widen(z, -0.4 * rim))],
            }
    return {OAK: [frame(x, y, z, rim)], panel: [block(*_flat(inner, back))]}


def _widen(span: Interval, by: float) -> Interval:
    return span[0] - by, span[1] + by


def _flat(inner: tuple[Interval, Interval], y: Interval) -> tuple[Interval, Interval, Interval]:
    return _widen(inner[0], 0.004), y, _widen(inner[1], 0.004)


def draw_handles(
    form: Form,
    x: Interval,
    z: Interval,
    columns: int,
    rows: int,
    y: float,
    reach: float,
    door: bool,
) -> Stuff:
    """The handles of a grid of doors or drawers, standing out from ``y`` by ``reach``."""
    match form.handle:
        case "knob":
            return {BRASS: knobs(x, z, columns, rows, y, reach, 0.0 if door else 0.5)}
        case "disc":
            round_knobs = knobs(x, z, columns, rows, y, 0.7 * reach)
            return {BRASS: round_knobs}
        case "bar" if door and rows == 1:
            return {BLACK: door_pulls(x, z, columns, y, reach, 0.5, 0.3)}
        case "bar":
            return {BLACK: drawer_pulls(x, z, columns, rows, y, reach, 0.7)}
        case "tab":
            return {LEATHER: drawer_pulls(x, z, columns, rows, y, reach, 0.16)}
    return {}
