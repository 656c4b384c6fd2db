"""The nodes of a document: home -> level -> rooms with their pieces, walls, openings, ceilings.

What is built of one level is drawn as a whole by the node that holds it: its walls, its openings,
its ceilings and its skirting each are one mesh, and nodes of their names hang below. What moves
(leaves, sashes, doors, drawers) is a node of its own with its hinge or runner as origin.
"""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.classes import RUN
from scenewright.core.catalog import Part, transform_part
from scenewright.core.scene import Piece, Scene, Size
from scenewright.render.bodies import Body, split_bodies
from scenewright.render.items import RenderItem, to_level_coordinates

RESERVED = re.compile(r"[\[\].:/%@\"\\]+")
"""What three.js and Godot drop from the names of nodes."""
LONGEST = 63
"""Bytes of a name that Blender keeps."""
SMALL = 0.45
"""Longest side, in metres, of what is drawn with the other small things of a room."""
TOGETHER, MANY, HUNG = 2, 8, 0.25
"""From this number on, small or fixed things of a room are drawn as one, and equal pieces are
instances of one node; so are small or fixed ones where they are many and alike. What begins so far
above the floor, in metres, and stands on nothing is fixed."""
FIXED = RUN | {"curtain", "blind", "toilet", "basin", "pedestal_basin", "double_basin", "bathtub"}
"""Kinds that are fixed to a building and stand on its floor."""
WHOLE: dict[Hashable, str] = {
    SMALL: "small things",
    FIXED: "fixtures",
    "surface": "grounds",
    "tree": "planting",
}
"""What of a room is drawn as one, and how the node that draws it is called: of trees those of
which there are not many alike."""
BRANCHES = {
    "wall": "walls",
    "opening": "openings",
    "stairs": "stairs",
    "ceiling": "ceilings",
    "skirting": "skirting",
    "light row": "light rows",
    "sign": "signs",
}
"""What is drawn as a whole by level, and how the node that draws it is called."""
Json = dict[str, Any]


class Drawn(NamedTuple):
    """What a node draws: parts in its frame, equal for equal keys, the name of their mesh, and
    where its instances are, as places and turns (none: once, at the node)."""

    key: Hashable
    name: str
    parts: tuple[Part, ...]
    places: tuple[tuple[list[float], list[float]], ...] = ()


class Tree(NamedTuple):
    """Nodes by number, what some of them draw, and names that are taken."""

    nodes: list[Json]
    drawn: dict[int, Drawn]
    taken: set[str]

    def add(self, parent: int, node: Json, drawn: Drawn | None = None) -> int:
        """The number of a new node below another."""
        self.nodes.append(node)
        number = len(self.nodes) - 1
        self.nodes[parent].setdefault("children", []).append(number)
        if drawn is not None and drawn.parts:
            self.drawn[number] = drawn
        return number

    def free(self, wish: str) -> str:
        """A name nobody has yet."""
        names = (wish if n == 1 else f"{wish} {n}" for n in range(1, len(self.taken) + 2))
        name = next(name for name in names if name not in self.taken)
        self.taken.add(name)
        return name


def build_tree(scene: Scene, found: Sequence[RenderItem], domain: str, batched: bool) -> Tree:
    """All nodes, the root first; children by number. Unless ``batched`` everything draws itself."""
    tree = Tree([], {}, {thing.name for thing in found})
    tree.nodes.append({"name": tree.free(scene.name or domain), "extras": {"category": domain}})
    pieces = {piece.id: piece for piece in scene.pieces}
    for level in scene.levels:
        extras = {"category": "level", "height": level.height, "elevation": level.elevation}
        name = tree.free(level.name or f"level {level.id or 1}")
        node: Json = {"name": name, "extras": extras}
        if level.elevation:
            node["translation"] = [0.0, float(level.elevation), 0.0]
        mine = [thing for thing in found if thing.level == level.id]
        _add_storey(tree, tree.add(0, node), mine, name, batched)
        _add_pieces(tree, [t for t in mine if t.kind in ("surface", "piece")], pieces, batched)
    return tree


def _add_storey(
    tree: Tree, top: int, found: Sequence[RenderItem], name: str, batched: bool
) -> None:
    """One level's branch but for its pieces: slab, spaces, stairs and what is drawn as a whole."""
    for thing in found:
        if thing.kind in ("slab", "space"):
            _add_thing(tree, top, thing)
    for kind, label in BRANCHES.items():
        mine = [thing for thing in found if thing.kind == kind]
        if mine:
            head = tree.free(f"{label} of {name}")
            whole = Drawn((kind, name), head, tuple(_in_level(mine))) if batched else None
            extras = {"category": label, "layer": label}
            branch = tree.add(top, {"name": head, "extras": extras}, whole)
            for thing in mine:
                _add_thing(tree, branch, thing, still=not batched)


def _in_level(found: Iterable[RenderItem]) -> Iterator[Part]:
    """What of things stands still, in the frame of their level."""
    for thing in found:
        for part in split_bodies(thing.parts)[0]:
            moved = to_level_coordinates(thing, part.vertices)
            yield Part(part.material, moved, part.faces)


def _add_thing(
    tree: Tree, parent: int, thing: RenderItem, size: Size | None = None, still: bool = True
) -> None:
    """A node with the ``still`` parts of a thing, and below it one for each body that moves."""
    name = str(thing.extras.get("asset", thing.name) if thing.kind == "piece" else thing.name)
    rest, bodies = split_bodies(thing.parts)
    drawn = Drawn((thing.key, ""), name, rest) if still else None
    number = tree.add(parent, node_of(thing, size), drawn)
    for body in bodies:
        moving = Drawn(_shape_key(body), f"{name} {body.joint.body}", _about_pivot(body))
        tree.add(number, _body_node(thing, body), moving)


def _body_node(thing: RenderItem, body: Body) -> Json:
    """A node about whose origin a body turns or from which it slides; what it may do is in its
    ``extras``: axis in glTF's frame, limits in radians or metres, and where it is ``at`` now."""
    joint = body.joint
    (x, y, z), (ax, ay, az) = joint.pivot, joint.axis
    facts = {
        "type": joint.kind,
        "axis": [ax, az, -ay if ay else 0.0],
        "lower": joint.lower,
        "upper": joint.upper,
        "at": joint.at,
    }
    place = [x, z, -y if y else 0.0]
    extras = {"category": "body", "joint": facts}
    return {"name": f"{thing.name} {joint.body}", "translation": place, "extras": extras}


def _about_pivot(body: Body) -> tuple[Part, ...]:
    shift = -np.array(body.joint.pivot)
    return tuple(transform_part(part, np.eye(3), shift) for part in body.parts)


def _shape_key(body: Body) -> Hashable:
    """Equal for bodies of one shape: drawers above one another share their mesh."""
    rows = ((p.material, np.round(p.vertices, 5), p.faces) for p in _about_pivot(body))
    return tuple((material, (v + 0.0).tobytes(), f.tobytes()) for material, v, f in rows)


def _add_pieces(
    tree: Tree, found: Sequence[RenderItem], pieces: Mapping[str, Piece], batched: bool
) -> None:
    """Pieces below their rooms. Equal ones are instances of a node; small ones, those fixed to the
    building and the ground are drawn as a whole; all have named nodes of their own."""
    rooms = {node["name"]: number for number, node in enumerate(tree.nodes)}
    batches: dict[tuple[str, Hashable], list[RenderItem]] = {}
    for thing in found:
        batches.setdefault(_batch_key(thing, pieces.get(thing.name)), []).append(thing)
    for key, group in [*batches.items()]:
        if len(group) < MANY and group[0].extras.get("category") == "tree" and key[1] not in WHOLE:
            batches.setdefault((key[0], "tree"), []).extend(batches.pop(key))
    for key, group in batches.items():
        parent = rooms.get(group[0].space, 1)
        held = batched and len(group) >= TOGETHER and bool(group[0].parts)
        if held:
            _add_batch(tree, parent, group, key)
        for thing in group:
            piece = pieces.get(thing.name)
            _add_thing(tree, parent, thing, piece.size if piece else None, still=not held)


def _batch_key(thing: RenderItem, piece: Piece | None) -> tuple[str, Hashable]:
    """What things of a room have in common that may be drawn at once: being small, being fixed to
    the building, or the key."""
    if piece is None:
        return thing.space, thing.kind
    if max(piece.size) <= SMALL and not split_bodies(thing.parts)[1]:
        return thing.space, SMALL
    hung = piece.on is None and piece.pose.z >= HUNG
    return thing.space, FIXED if hung or piece.category in FIXED else thing.key


def _add_batch(
    tree: Tree, parent: int, group: Sequence[RenderItem], key: tuple[str, Hashable]
) -> None:
    """A node that draws a group: instances of one mesh, or different things as one."""
    first = group[0]
    if key[1] in WHOLE and (len({t.key for t in group}) > 1 or len(group) < MANY):
        kind = WHOLE[key[1]]
        name = tree.free(f"{kind} of {first.space}")
        drawn = Drawn(key, name, tuple(_in_level(group)))
        extras: Json = {"category": kind, "space": first.space, "holds": len(group)}
    else:
        name = str(first.extras.get("asset", first.name))
        drawn = Drawn(first.key, name, first.parts, tuple(map(place_of, group)))
        extras = first.extras | {"instances": len(group)}
        name = tree.free(f"{name} x {len(group)}")
    tree.add(parent, {"name": name, "extras": extras}, drawn)


def place_of(thing: RenderItem) -> tuple[list[float], list[float]]:
    """Where a thing is in glTF's axes, and its turn as a quaternion; a turn about our z is the same
    turn about glTF's y."""
    x, y, z = (float(v) for v in thing.at)
    half = thing.turn / 2
    turn = [0.0, float(np.sin(half)), 0.0, float(np.cos(half))]
    return [x, z, -y if y else 0.0], turn


def node_of(thing: RenderItem, size: Size | None = None) -> Json:
    """A node at its place, with what is known of the thing."""
    place, turn = place_of(thing)
    node: Json = {"name": thing.name}
    extras = dict[str, Any](thing.extras)
    if size is not None:
        extras["dimensions"] = [round(float(length), 4) for length in size]
    if extras:
        node["extras"] = extras
    if any(place):
        node["translation"] = place
    if thing.turn:
        node["rotation"] = turn
    return node


def name_safely(nodes: Sequence[Json]) -> None:
    """Give nodes names that viewers keep; ``extras`` has the ``id`` where it was another one."""
    names = safe_names([node["name"] for node in nodes])
    for node, name in zip(nodes, names, strict=True):
        if node["name"] != name and "extensions" not in node:
            node["extras"] = node.get("extras", {}) | {"id": node["name"]}
        node["name"] = name


def safe_names(names: Sequence[str]) -> Iterator[str]:
    """Names that viewers keep as they are: unique, without signs they drop, not too long.

    >>> list(safe_names(["living/wall-1", "living-wall-1", "sofa"]))
    ['living-wall-1', 'living-wall-1 2', 'sofa']
    """
    taken: set[str] = set()
    for name in names:
        plain, count = RESERVED.sub("-", name), 1
        safe = plain.encode()[:LONGEST].decode(errors="ignore")
        while safe in taken:
            count += 1
            end = f" {count}"
            safe = plain.encode()[: LONGEST - len(end)].decode(errors="ignore") + end
        taken.add(safe)
        yield safe
