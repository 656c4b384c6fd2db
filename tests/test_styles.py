"""Styles and palettes: every main kind has its model, seeds differ, what is the user's stays."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from scenewright.building.palettes import (
    MODERN,
    PALETTES,
    STYLES,
    choose_palette,
    list_coats,
    paint,
)
from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.materials import LEAF, OAK
from scenewright.catalog.assets.styled.forms import FORMS
from scenewright.core.brief import Brief
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import check, scene_of, solution_of, solve
from scenewright.domains.home.furnishing.look import apply_style, keep_palette, palette_of
from scenewright.formats import read_planned
from scenewright.render.items import things

MAIN = [
    "sofa",
    "loveseat",
    "corner_sofa",
    "armchair",
    "dining_chair",
    "dining_table",
    "round_table",
    "coffee_table",
    "double_bed",
    "single_bed",
    "nightstand",
    "wardrobe",
    "chest_of_drawers",
    "sideboard",
    "tv_stand",
    "bookcase",
    "desk",
    "base_cabinet",
    "sink_cabinet",
    "hob_cabinet",
    "wall_cabinet",
    "floor_lamp",
    "table_lamp",
    "pendant_lamp",
    "rug",
]
ROOM = {
    "id": "a",
    "function": "living",
    "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
    "doors": [{"at": [1, 0]}],
}


def brief_of(**keys: object) -> Brief:
    return Brief.model_validate({"name": "home", "rooms": [ROOM], **keys})


def piece_of(asset: str, fixed: bool = False, category: str = "sofa") -> Piece:
    pose, size = Pose(2, 2, 0, 0), Size(2.0, 0.9, 0.8)
    return Piece("a/sofa", category, asset, "a", pose, size, fixed=fixed)


@pytest.mark.parametrize("category", MAIN)
def test_every_main_kind_is_drawn_in_every_style(category: str) -> None:
    models = {asset.style: asset for asset in shipped().of(category) if asset.style}
    assert set(models) == set(FORMS) == set(STYLES) - {MODERN}
    usual = shipped().choose(category, models["nordic"].usual)
    assert usual is not None
    assert not usual.style, "halls and readers still get the plain model"


@pytest.mark.parametrize("category", ["sofa", "double_bed", "dining_chair", "base_cabinet"])
def test_models_of_two_styles_differ_in_shape(category: str) -> None:
    size = shipped().assets[category].usual
    shapes = [
        np.sort(np.concatenate([p.vertices for p in asset.mesh(size)]).round(3), axis=0)
        for asset in shipped().of(category)
    ]
    for k, one in enumerate(shapes):
        assert all(one.shape != other.shape or (one != other).any() for other in shapes[:k])


def test_there_are_enough_palettes_and_all_are_drawn_in_turn() -> None:
    assert len(PALETTES) >= 30
    drawn = [choose_palette("", "", "home", seed) for seed in range(len(PALETTES))]
    assert {row.id for row in drawn} == set(PALETTES)
    assert all(one.style != after.style for one, after in pairwise(drawn))


@pytest.mark.parametrize("row", PALETTES.values(), ids=lambda row: row.id)
def test_the_colours_of_a_palette_are_told_apart(row: object) -> None:
    coats = list_coats(row)  # type: ignore[arg-type]
    assert all(0 <= share <= 1 for coat in coats.values() for share in coat.color)
    assert len({coat.name for coat in coats.values()}) == len(coats)
    seen = {name: coat.color for name, coat in ((m.name, c) for m, c in coats.items())}
    shown = ("oak", "warm grey fabric", "terracotta fabric", "navy fabric", "wall plaster")
    for k, name in enumerate(shown):
        for other in shown[:k]:
            assert max(abs(np.subtract(seen[name], seen[other]))) > 0.04, (name, other)


def test_paint_changes_the_materials_of_the_palette_alone() -> None:
    none = np.zeros((0, 3))
    parts = tuple(Part(m, none, none.astype(np.int64)) for m in (OAK, LEAF))
    oak, leaf = paint(parts, "nordic/fjord")
    assert leaf.material == LEAF
    assert oak.material != OAK
    assert oak.material.roughness == OAK.roughness
    assert paint(parts, "") == parts


def test_words_of_the_brief_choose_the_style_and_the_palette() -> None:
    assert choose_palette("Scandi, calm", "", "x", 3).style == "nordic"
    assert choose_palette("retro teal", "", "x", 8).id == "retro/teal"
    assert choose_palette("", "green", "x", 5).hues.split(",").count("green") == 1
    assert choose_palette("unheard of", "", "x", 0) == choose_palette("", "", "x", 0)


def test_what_stands_there_and_what_is_the_users_keeps_its_model() -> None:
    brief = brief_of(style="boho")
    given = [piece_of("sofa"), piece_of("sofa", fixed=True), piece_of("model:mine")]
    after = apply_style(given, brief, ["a"], shipped(), 0)
    assert [piece.asset for piece in after] == ["sofa_boho", "sofa", "model:mine"]
    assert replace(after[0], asset="sofa") == given[0]
    rooms = [{**ROOM, "style": "japanese"}]
    one = apply_style(given[:1], brief_of(style="boho", rooms=rooms), ["a"], shipped(), 0)
    assert one[0].asset == "sofa_japandi"


@pytest.mark.parametrize("keys", [{}, {"style": "boho"}, {"colour": "green"}, {"style": "oak"}])
def test_another_seed_for_a_change_keeps_the_palette(keys: dict[str, str]) -> None:
    brief = brief_of(**keys)
    for seed in range(1, 8):
        kept = keep_palette(brief, 0, seed)
        assert palette_of(kept, seed) == palette_of(brief, 0)


@pytest.fixture(scope="module")
def homes() -> tuple[Solution, Solution]:
    return solve(brief_of(), seed=0, steps=200), solve(brief_of(), seed=1, steps=200)


def test_two_seeds_are_two_families(homes: tuple[Solution, Solution]) -> None:
    styles = []
    for home in homes:
        models = {shipped().assets[p.asset].style for p in home.pieces if p.category in MAIN}
        assert len(models) == 1
        styles.append(models)
        scene = scene_of(home)
        names = {p.material.name for t in things(scene, shipped()) for p in t.parts}
        style, name = scene.palette.split("/")
        assert f"wall plaster, {style} {name}" in names
    assert styles[0] != styles[1]
    abroad = homes[0].brief.model_copy(update={"style": "mediterranean boho"})
    scene = scene_of(replace(homes[0], brief=abroad))
    assert scene.palette.startswith("boho/")
    names = {p.material.name for t in things(scene, shipped()) for p in t.parts}
    assert {"terracotta floor", "lime wash"} <= names


def test_a_style_that_means_nothing_is_refused_as_an_option_and_noted_in_a_brief() -> None:
    with pytest.raises(InputError, match=r"'baroque' is no style of homes; use one of: modern"):
        read_planned("sample:home-room", style="baroque")
    assert read_planned("sample:home-room", style="zen")[0].style == "zen"

    def told(style: str, room: str) -> list[str]:
        brief = brief_of(style=style, rooms=[{**ROOM, "style": room}])
        report = check(solution_of(brief, {}))
        return [note.message for note in report.notes if note.missing == "style"]

    assert told("retro teal", "fjord") == []
    assert [text[:25] for text in told("baroque", "gothic")] == [
        "style 'baroque' means not",
        "style 'gothic' means noth",
    ]
