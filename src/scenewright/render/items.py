"""From a scene to things with a mesh and a place: what every writer of 3D or pictures draws.

Walls, floors and openings get their triangles here; pieces get theirs from the catalog.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from math import inf
from typing import Literal, NamedTuple

import numpy as np
import shapely

from scenewright.building import joinery
from scenewright.building.door_uses import DoorUse, classify_doors
from scenewright.building.finishes import CONCRETE, LID, PLASTER, SECTION, SURFACES, floor_of
from scenewright.building.gables import cut_off, height_at
from scenewright.building.masonry import polygons
from scenewright.building.palettes import paint
from scenewright.building.shafts import is_shaft
from scenewright.building.stair_parts import flight_parts, railing_parts, wells
from scenewright.catalog.assets.tints import apply_tint, tint_of
from scenewright.core.catalog import Asset, Catalog, Part, asset_of, footprint_of
from scenewright.core.scene import STAIRS, GroundSurface, Piece, Prism, Scene, Size, Terrain, Wall
from scenewright.core.space import Level, Opening, Space
from scenewright.geometry.mesh import Floats, Mesh, merge
from scenewright.geometry.prisms import prism, sheet
from scenewright.render.cut_part import cut_part, leave_out_hanging
from scenewright.render.draping import drape_floor, drape_surface, lay_surface, lay_terrain
from scenewright.render.hiding import find_hanging_over, find_hiding, make_clear
from scenewright.render.lighter import lighten
from scenewright.render.near_walls import (
    ENCLOSED,
    NearWalls,
    cut_of_enclosure,
    cut_of_opening,
    cut_of_piece,
    find_lid_height,
    find_near_walls,
    split_prism,
)
from scenewright.render.piece_meshes import mesh_asset, mesh_outline

Direction = tuple[float, float, float]
BuiltKind = Literal["slab", "space", "ceiling", "skirting", "light row", "sign", "surface", "wall"]
ThingKind = Literal[BuiltKind, "opening", "stairs", "piece"]

SLAB = 0.22
"""Thickness in metres of the slab drawn under each level."""
SKIN = 0.012
"""Thickness in metres of a room's floor finish; its top is the floor level."""
LOW = 1.2
"""Walls up to this height, in metres, are parapets: their tops are not drawn as a section."""

SEEN = 1.3
"""How far down one sees stairs through their well in a picture, metres."""
LEFT = 1.3
"""How high stairs up go on in a picture of a level from above, metres: things behind the rest
would be hidden."""


class RenderItem(NamedTuple):
    """One drawable: parts in its own frame, moved by ``at`` (above the level's floor) after a
    turn of ``turn`` radians about z. Things with equal ``key`` have equal parts. ``space`` is the
    id of the space a piece stands in; ``extras`` are facts to be kept with it."""

    name: str
    kind: ThingKind
    level: str
    space: str
    key: Hashable
    parts: tuple[Part, ...]
    at: tuple[float, float, float]
    turn: float
    extras: dict[str, str | float]


def things(
    scene: Scene, catalog: Catalog, cut: float | None = None, towards: Direction | None = None
) -> tuple[RenderItem, ...]:
    """Everything to draw, level by level: slab, floors, walls, openings, pieces.

    ``cut`` (metres above each floor) leaves out what walls, openings and pieces that hang on
    them have above it, and all that hangs from the ceiling; of walls that stand before a room for
    an eye that looks ``towards`` a direction, more (:mod:`scenewright.render.near_walls`), and what
    hides other pieces from it is as if of glass or left out (:mod:`scenewright.render.hiding`).
    Shafts are closed there.
    """
    level_of = {space.id: space.level for space in scene.spaces}
    first = scene.levels[0].id if scene.levels else ""
    uses = classify_doors(scene.openings, scene.spaces)
    slept_in = {piece.space for piece in scene.pieces if _is_bed(piece, catalog)}
    found: list[RenderItem] = []
    for level in scene.levels:
        near = NearWalls()
        if cut is not None and towards is not None:
            near = find_near_walls(scene, level.id, towards)
        found += _terrain(scene, level) if scene.terrain else _slab(scene, level)
        well = wells(scene.stairs, level.id)
        rooms = (
            _floor(space, well, _lid_of(space, near, cut), space.id in slept_in, scene.terrain)
            for space in scene.spaces
            if space.level == level.id
        )
        found += [floor for floor in rooms if floor.parts]
        found += [
            _surface(s, level.id, scene.terrain)
            for s in scene.surfaces
            if level_of.get(s.space, first) == level.id
        ]
        walls = (_wall(wall, cut, near) for wall in scene.walls if wall.level == level.id)
        found += [wall for wall in walls if wall.parts]
        found += [
            _opening(o, uses.get(o.id, "inner"), cut and cut_of_opening(o, near, cut))
            for o in scene.openings
            if o.level == level.id
        ]
        found += _stairs(scene, level, cut)
        pieces = [
            p
            for p in scene.pieces
            if level_of.get(p.space, first) == level.id and p.function != STAIRS
        ]
        seen = towards if cut is not None else None
        clear = find_hiding(pieces, seen) if seen else frozenset()
        over = find_hanging_over(pieces, seen) if seen else frozenset()
        bearing = {piece.on for piece in pieces}  # a shelf with a screen on it stays under it
        for piece in (p for p in pieces if p.id not in over):
            top = cut if piece.id in bearing else cut and _cut_of(piece, near, cut)
            one = _piece(piece, level.id, catalog, top)
            if piece.id in clear:
                one = one._replace(key=(one.key, "clear"), parts=make_clear(one.parts))
            found += [one] if one.parts or cut is None else []
    if scene.palette:
        found = [one._replace(parts=paint(one.parts, scene.palette)) for one in found]
    return lighten(tuple(_make_names_unique(found)))


def _cut_of(piece: Piece, near: NearWalls, cut: float) -> float:
    enclosed = piece.category in ENCLOSED
    return (cut_of_enclosure if enclosed else cut_of_piece)(piece, near, cut)


def _lid_of(space: Space, near: NearWalls, cut: float | None) -> float:
    """How high a room is filled: shafts in a cut picture, no others."""
    return find_lid_height(space, near, cut) if cut is not None and is_shaft(space) else 0.0


def to_level_coordinates(thing: RenderItem, vertices: Floats) -> Floats:
    """Points ``(n, 3)`` of a thing's own frame in its level's frame."""
    cos, sin = np.cos(thing.turn), np.sin(thing.turn)
    turned = vertices @ np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return turned + np.asarray(thing.at)


def _slab(scene: Scene, level: Level) -> Iterator[RenderItem]:
    """One plate under all rooms and walls of a level."""
    prisms = [p for wall in scene.walls if wall.level == level.id for p in wall.prisms]
    shapes = [shapely.Polygon(p.outline, p.holes) for p in prisms if p.base == 0]
    shapes += [shapely.Polygon(s.outline) for s in scene.spaces if s.level == level.id]
    shapes += [
        shapely.Polygon(joinery.to_plan_coordinates(o, _corners(o))[:, :2])
        for o in scene.openings
        if o.level == level.id
    ]
    with np.errstate(divide="ignore", invalid="ignore"):  # at needles, which have no mitre
        region = shapely.union_all(shapely.buffer(shapes, 0.002, join_style="mitre"))
    region = region.difference(wells(scene.stairs, level.id))
    meshes = [extrude_polygon(part.simplify(0.003), -SLAB, -SKIN) for part in polygons(region)]
    if meshes:
        name = f"slab of {level.name or level.id or 'the floor'}"
        plate = Part(CONCRETE, *merge(meshes))
        yield RenderItem(name, "slab", level.id, "", name, (plate,), (0, 0, 0), 0.0, {})


def extrude_polygon(shape: shapely.Polygon, base: float, top: float) -> Mesh:
    """A plate over a polygon with its holes, between two heights in metres."""
    ordered = shapely.orient_polygons(shape)
    rings = [shapely.get_coordinates(r)[:-1] for r in (ordered.exterior, *ordered.interiors)]
    return prism(rings[0], base, top, rings[1:])


def _stairs(scene: Scene, level: Level, cut: float | None) -> Iterator[RenderItem]:
    """Stairs up from a level, and railings round the wells in its floor; in a cut picture, where
    levels stand side by side, also what is seen of stairs through the well."""
    floors = [shapely.Polygon(s.outline, s.holes) for s in scene.spaces if s.level == level.id]
    for one in scene.stairs:
        made = []
        if one.level == level.id:
            upto = inf if cut is None else LEFT
            made.append((one.id, flight_parts(one, upto=upto), 0.0))
        if one.upper == level.id:
            made.append((f"{one.id} railing", railing_parts(one, floors), 0.0))
            rise = one.rises * one.rise
            if cut is not None:
                made.append((f"{one.id} below", flight_parts(one, rise - SEEN), -rise))
        facts: dict[str, str | float] = {"category": "staircase", "label": one.name}
        for name, parts, z in made:
            if parts:
                yield RenderItem(name, "stairs", level.id, "", name, parts, (0, 0, z), 0.0, facts)


def _corners(opening: Opening) -> Floats:
    half, face = opening.width / 2, opening.thickness / 2
    return np.array([[-half, -face, 0], [half, -face, 0], [half, face, 0], [-half, face, 0]])


def _is_bed(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(piece.category)
    return kind is not None and "bed" in kind.essential


def _floor(
    space: Space, well: shapely.Geometry, lid: float, slept_in: bool, terrain: Terrain | None
) -> RenderItem:
    """The floor finish of a room; of a shaft that is closed, what fills it up to its ``lid``."""
    whole = shapely.Polygon(space.outline, space.holes)
    area, meshes = whole.area, [prism(space.outline, -SKIN, lid, space.holes)]
    if terrain:
        meshes = [drape_floor(whole, terrain)]
    elif whole.intersects(well):
        meshes = [extrude_polygon(part, -SKIN, 0.0) for part in polygons(whole.difference(well))]
    extras: dict[str, str | float] = {
        "function": ", ".join(space.functions),
        "category": "space",
        "label": space.name,
        "area": round(area, 3),
        "height": space.height,
    }
    parts = (Part(LID if lid else floor_of(space, slept_in), *merge(meshes)),) if meshes else ()
    return RenderItem(
        space.id, "space", space.level, space.id, ("space", space.id), parts, (0, 0, 0), 0.0, extras
    )


def _terrain(scene: Scene, level: Level) -> Iterator[RenderItem]:
    """Ground beyond the spaces, water and plinths of ground that is not flat."""
    for name, part in lay_terrain(scene):
        facts: dict[str, str | float] = {"category": "surface", "function": name}
        yield RenderItem(name, "surface", level.id, "", name, (part,), (0, 0, 0), 0.0, facts)


def _surface(surface: GroundSurface, level: str, terrain: Terrain | None) -> RenderItem:
    """The surfaces of the ground, one mesh a kind."""
    mesh = drape_surface(surface, terrain) if terrain else lay_surface(surface)
    part = Part(SURFACES[surface.kind], *mesh)
    extras: dict[str, str | float] = {"category": "surface", "function": surface.kind}
    key, at = ("surface", surface.id), (0, 0, 0)
    return RenderItem(surface.id, "surface", level, surface.space, key, (part,), at, 0.0, extras)


def _wall(wall: Wall, cut: float | None, near: NearWalls) -> RenderItem:
    highest = max((p.top for p in wall.prisms), default=0.0)
    top = highest if cut is None else min(highest, cut)
    caps: list[Mesh] = []
    sides: list[Mesh] = []
    shares = (share for whole in wall.prisms for share in split_prism(whole, near, top))
    for solid, level in ((part, low) for whole, low in shares for part in cut_off(whole, low)):
        if cut is None or solid.base < level - 1e-6:
            side, cap = _open_prism(solid, min(solid.top, level))
            sides.append(side)
            section = top > LOW and solid.top >= level - 1e-6
            (caps if section or solid.tilt is not None else sides).append(cap)
    parts = [Part(PLASTER, *merge(sides))] if sides else []
    parts += [Part(SECTION, *merge(caps))] if caps else []
    extras: dict[str, str | float] = {"category": "wall", "height": top}
    key = ("wall", wall.level, wall.id)
    return RenderItem(wall.id, "wall", wall.level, "", key, tuple(parts), (0, 0, 0), 0.0, extras)


def _open_prism(solid: Prism, top: float) -> tuple[Mesh, Mesh]:
    """The sides and underside of a prism, and its upper face."""
    vertices, faces, _ = prism(solid.outline, solid.base, top, solid.holes)
    cap = sheet(solid.outline, solid.holes, top)
    if solid.tilt is not None:
        cap.vertices[:, 2] = height_at(solid.tilt, cap.vertices[:, :2])
        vertices[len(cap.vertices) :, 2] = cap.vertices[:, 2]
    return Mesh(vertices, faces[len(cap.faces) :]), cap


def _opening(opening: Opening, use: DoorUse, cut: float | None) -> RenderItem:
    whole = joinery.parts(opening, use)
    parts = tuple(p for part in whole if (p := cut_part(part, cut)) is not None)
    extras: dict[str, str | float] = {
        "category": opening.kind,
        "width": opening.width,
        "sill": opening.sill,
        "head": opening.head,
        "space": ", ".join(opening.spaces),
    }
    shape = (
        opening.kind,
        use,
        opening.width,
        opening.thickness,
        opening.sill,
        opening.head,
        opening.hinge,
        opening.swing,
        cut,
    )
    turn = float(np.arctan2(opening.uy, opening.ux))
    at = (opening.x, opening.y, 0.0)
    return RenderItem(opening.id, "opening", opening.level, "", shape, parts, at, turn, extras)


def parts_of(piece: Piece, catalog: Catalog) -> tuple[Part, ...]:
    """The parts that a piece is drawn of, in its own frame."""
    return _piece(piece, "", catalog, None).parts


def _piece(piece: Piece, level: str, catalog: Catalog, cut: float | None) -> RenderItem:
    asset = asset_of(piece, catalog)
    size = Size(*(round(length, 4) for length in piece.size))
    key: Hashable = (asset.id if asset else piece.category, size)
    x, y, z, heading = piece.pose
    parts = mesh_asset(asset, size)
    if piece.footprint != footprint_of(asset, size):
        key = (key, piece.footprint)
        parts = mesh_outline(piece, size, asset, parts)
    if piece.category == "building" and piece.function != "landmark":
        tint = tint_of(piece.id, parts)
        key, parts = (key, tint), apply_tint(parts, tint)
    kind = catalog.kinds.get(piece.category)
    held = piece.category in ENCLOSED or (kind is not None and kind.support in ("wall", "ceiling"))
    if cut is not None and held:
        top = 0.0 if kind is not None and kind.support == "ceiling" else cut - z
        parts = tuple(p for part in parts if (p := cut_part(part, top)) is not None)
        key = (key, round(top, 4))
    elif cut is not None and cut <= z:
        key, parts = (key, "low"), leave_out_hanging(parts)
    return RenderItem(
        piece.id,
        "piece",
        level,
        piece.space,
        key,
        parts,
        (x, y, z),
        heading - np.pi / 2,
        _facts(piece, asset),
    )


def _facts(piece: Piece, asset: Asset | None) -> dict[str, str | float]:
    values: dict[str, str | float] = {
        "function": piece.function,
        "category": piece.category,
        "asset": asset.id if asset else piece.asset,
        "group": piece.group,
        "space": piece.space,
        "licence": asset.licence if asset else "",
        "author": asset.author if asset else "",
        "on": piece.on or "",
    }
    return {name: fact for name, fact in values.items() if fact != ""}


def _make_names_unique(found: Sequence[RenderItem]) -> Iterator[RenderItem]:
    """Names made unique by a number behind the second of a kind and later."""
    taken: set[str] = set()
    for thing in found:
        name, count = thing.name or thing.kind, 1
        while name in taken:
            count += 1
            name = f"{thing.name or thing.kind} {count}"
        taken.add(name)
        yield thing._replace(name=name)
