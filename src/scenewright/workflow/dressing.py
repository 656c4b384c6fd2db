"""Another look for a scene that stays as it is: models of a style, and a palette of materials."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from scenewright.building.palettes import PALETTES
from scenewright.catalog.loading import catalog_of
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution
from scenewright.workflow.by_hand import find_like


def list_looks(domain: str) -> dict[str, dict[str, list[str]]]:
    """The styles of a kind of scene that can be changed without arranging it anew, with the
    palettes of each and some colours of these; none for those whose style says what stands there.

    >>> list_looks("home")["nordic"]["fjord"][0][0], list_looks("village")
    ('#', {})
    """
    found: dict[str, dict[str, list[str]]] = {}
    if domain_of(domain).has("appearance"):
        for one in PALETTES.values():
            colours = [one.wood, one.cloth, one.second, one.first, one.fronts, one.wall]
            found.setdefault(one.style, {})[one.name] = [f"#{code.strip('#')}" for code in colours]
    return found


def change_look(
    solution: Solution, style: str, palette: str = ""
) -> tuple[Solution, list[dict[str, Any]]]:
    """A scene in another style: its materials in a ``palette`` of it (left out: one by the seed),
    and each piece that is not locked by the model of the style that is like it. Every change with
    its reason. InputError for a style or palette there is not."""
    looks = list_looks(solution.brief.domain)
    if style not in looks:
        raise InputError(f"'{style}' is no style of this", f"use one of: {', '.join(looks)}")
    if palette and palette not in looks[style]:
        raise InputError(
            f"'{palette}' is no palette of {style}", f"use one of: {', '.join(looks[style])}"
        )
    catalog = catalog_of(solution.brief.catalogs)
    pieces, changes = [], []
    for piece in solution.pieces:
        like = "" if piece.fixed else find_like(piece.asset, style, catalog)
        pieces.append(replace(piece, asset=like or piece.asset))
        if like and like != piece.asset:
            row = {"piece": piece.id, "was": piece.id, "change": "exchanged", "room": piece.space}
            changes.append({**row, "reason": f"a model of the style {style}"})
    words = {"style": f"{style} {palette}".strip(), "colour": ""}
    brief = solution.brief.model_copy(update=words)
    return replace(solution, brief=brief, pieces=tuple(pieces)), changes
