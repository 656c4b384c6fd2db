"""How a home looks: one style and one palette, stated by the brief or drawn by the seed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache

from scenewright.building.palettes import STYLES, Palette, choose_palette, style_of
from scenewright.building.regions import REGIONS, region_of
from scenewright.building.shell import scene_of_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Scene
from scenewright.core.solution import Solution
from scenewright.domains.home.furnishing.rugs import match_rugs
from scenewright.domains.home.furnishing.style_words import knows_style

MANY = 24
"""Seeds that draw more than one palette wherever there is a choice."""


def palette_of(brief: Brief, seed: int) -> Palette:
    """The palette of a home: by the words of its brief, among those by its seed."""
    return choose_palette(brief.style, brief.colour, brief.name, seed)


def tell_palette(solution: Solution) -> str:
    """The style and palette of a home, and what chose them: the brief, or the seed among those
    that are left to it."""
    brief = solution.brief
    palette = palette_of(brief, solution.seed)
    others = {choose_palette(brief.style, brief.colour, brief.name, k) for k in range(MANY)}
    by = f" (drawn by seed {solution.seed})" if len(others) > 1 else ""
    return f"style {palette.style}, palette {palette.name}{by}"


def keep_palette(brief: Brief, before: int, after: int) -> Brief:
    """A brief that keeps the palette it had with the seed ``before`` when another is used."""
    palette = palette_of(brief, before)
    if palette_of(brief, after) == palette:
        return brief
    words = f"{brief.style} {palette.style} {palette.name}".strip()
    return brief.model_copy(update={"style": words})


def refuse_style(brief: Brief) -> None:
    """InputError where the style of a home means nothing: the seed would draw another."""
    if not knows_style(brief.style, catalog_of(brief.catalogs)):
        raise InputError(
            f"'{brief.style[:40]}' is no style of homes",
            f"use one of: {', '.join((*STYLES, *REGIONS))}, or none: then the seed draws one",
            place="style",
        )


def apply_style(
    pieces: Iterable[Piece], brief: Brief, spaces: Iterable[str], catalog: Catalog, seed: int
) -> tuple[Piece, ...]:
    """Pieces drawn by the models of the home's style, or of their room's if it names one.
    ``spaces`` are the ids of the brief's rooms. What stands there already, what is drawn by a model
    of the user's and what a style has no model of stays as it is. A style's rug lies before a sofa
    (:mod:`scenewright.domains.home.furnishing.rugs`).
    """
    home = palette_of(brief, seed).style
    rooms = {k: style_of(room.style) for k, room in zip(spaces, brief.rooms, strict=True)}
    return tuple(
        _restyle(piece, rooms.get(piece.space) or home, catalog) for piece in match_rugs(pieces)
    )


def _restyle(piece: Piece, style: str, catalog: Catalog) -> Piece:
    model = None if piece.fixed else _models(catalog, style).get(piece.asset)
    return replace(piece, asset=model) if model else piece


@lru_cache(maxsize=64)
def _models(catalog: Catalog, style: str) -> dict[str, str]:
    """By the model that has no style the one like it that is made in a style."""
    ours = (asset.id for asset in catalog.assets.values() if asset.style == style)
    end = f"_{style}"
    return {name.removesuffix(end): name for name in ours if name.endswith(end)}


def scene_of_home(solution: Solution, plan: Plan) -> Scene:
    """The scene of a home, in its palette and the finishes of its region."""
    palette = palette_of(solution.brief, solution.seed)
    look = f"{palette.id} {region_of(solution.brief.style)}".rstrip()
    return replace(scene_of_rooms(solution, plan), palette=look)
