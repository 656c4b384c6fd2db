"""Levels of detail and collision meshes, for engines: what ``.game.glb`` adds to a scene.

Coarser forms are nodes of their own that stand in no tree: the node they stand for names them
(MSFT_lod), so that a reader that does not know them draws the model alone. What one runs into
hangs below one node of each level: ``NAME-colonly``, as Godot reads it.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from typing import Any, NamedTuple

from scenewright.core.catalog import Part
from scenewright.formats.gltf.tree import LONGEST, Drawn, Tree, node_of
from scenewright.render.coarse_parts import GONE, Coarseness, list_coarser, obstacle_of
from scenewright.render.items import RenderItem

LOD, HIDDEN = "MSFT_lod", "KHR_node_visibility"
COLLISION = "collision"
END = "-colonly"
"""How the names of collision meshes end."""
SOLID = ("slab", "space", "wall", "stairs", "surface")
"""What of a building or the ground one stands on or runs into, drawn as it is."""
Json = dict[str, Any]
Forms = list[tuple[Coarseness, tuple[Part, ...]]]


class Added(NamedTuple):
    """What was added for the node of a thing: nodes of its coarser forms with the shares of the
    screen from which each is drawn, and that of its collision mesh (-1: none), all by number."""

    node: int
    forms: tuple[int, ...]
    below: tuple[float, ...]
    collision: int


def add_forms(tree: Tree, found: Sequence[RenderItem], levels: Sequence[str]) -> list[Added]:
    """Add the coarser forms and collision meshes of things to a tree that draws each by itself and
    holds no more yet than its ``levels``, named by their ids in order."""
    numbers = {node["name"]: number for number, node in enumerate(tree.nodes)}
    branches = _add_branches(tree, levels)
    forms: dict[Hashable, Forms] = {}
    added = []
    for thing in found:
        number = numbers.get(thing.name)
        if number is None or number not in tree.drawn:
            continue
        if thing.kind == "piece" and thing.key not in forms:
            forms[thing.key] = list_coarser(thing.parts)
        rows = forms.get(thing.key, [])
        nodes = tuple(_add_form(tree, thing, k, form) for k, (_, form) in enumerate(rows, 1))
        below = tuple(level.below for level, _ in rows)
        solid = _solid_of(thing, rows)
        collision = tree.add(branches[thing.level], _bare(thing), solid) if solid else -1
        added.append(Added(number, nodes, below, collision))
    return added


def _add_branches(tree: Tree, levels: Sequence[str]) -> dict[str, int]:
    """A node for the collision meshes of each level, by the level's id."""
    found = {}
    for level, number in zip(levels, [*tree.nodes[0].get("children", ())], strict=True):
        name = tree.free(f"{COLLISION} of {tree.nodes[number]['name']}")
        extras = {"category": COLLISION, "layer": COLLISION}
        found[level] = tree.add(number, {"name": name, "extras": extras})
    return found


def _add_form(tree: Tree, thing: RenderItem, number: int, form: tuple[Part, ...]) -> int:
    """A node that stands in no tree and draws a coarser form of a thing at its place."""
    name = str(thing.extras.get("asset", thing.name))
    tree.nodes.append(_bare(thing))
    tree.drawn[len(tree.nodes) - 1] = Drawn((thing.key, number), f"{name}_LOD{number}", form)
    return len(tree.nodes) - 1


def _solid_of(thing: RenderItem, rows: Forms) -> Drawn | None:
    """What one runs into of a thing: its coarsest form where it is a building, the same mesh."""
    name = str(thing.extras.get("asset", thing.name))
    if thing.kind in SOLID:
        return Drawn((thing.key, ""), name, thing.parts)
    if thing.kind != "piece":
        return None
    if thing.extras.get("category") == "building":
        form, number = (rows[-1][1], len(rows)) if rows else (thing.parts, "")
        return Drawn((thing.key, number), f"{name}_LOD{number}", form)
    made = obstacle_of(thing.parts)
    return Drawn((thing.key, COLLISION), f"{name}{END}", made) if made else None


def _bare(thing: RenderItem) -> Json:
    node = node_of(thing)
    node.pop("extras", None)
    return node


def name_forms(nodes: Sequence[Json], added: Sequence[Added]) -> None:
    """Name what was added after the nodes it stands for, and say there what it is."""
    for row in added:
        node = nodes[row.node]
        for number, form in enumerate(row.forms, 1):
            nodes[form]["name"] = _ended(node["name"], f"_LOD{number}")
        if row.collision >= 0:
            nodes[row.collision]["name"] = _ended(node["name"], END)
        if row.forms:
            node.setdefault("extensions", {})[LOD] = {"ids": list(row.forms)}
            node.setdefault("extras", {})["MSFT_screencoverage"] = [*row.below, GONE]
    for node in nodes:
        if node.get("extras", {}).get("layer") == COLLISION:
            node["extensions"] = {HIDDEN: {"visible": False}}


def _ended(name: str, end: str) -> str:
    """A name with an ending, cut to what viewers keep.

    >>> _ended("house 1", "_LOD1")
    'house 1_LOD1'
    """
    return name.encode()[: LONGEST - len(end)].decode(errors="ignore") + end


def extensions_used(added: Sequence[Added]) -> Iterator[str]:
    """Names of the extensions by which levels and collision meshes are told."""
    if any(row.forms for row in added):
        yield LOD
    if any(row.collision >= 0 for row in added):
        yield HIDDEN
