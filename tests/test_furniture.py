"""What a model is: kinds by names in several languages, front by shape, metres by size."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import KINDS, SIZES
from scenewright.catalog.kinds.other_words import GENERIC
from scenewright.catalog.models import library
from scenewright.catalog.models.front import SIDES, front
from scenewright.catalog.models.furniture import OTHER, REFINED, understood, unit_of
from scenewright.catalog.models.model import Model
from scenewright.catalog.models.words import match, phrases
from scenewright.core.catalog import Asset, Part
from scenewright.core.scene import Size

SHAPED = [a for a in shipped().assets.values() if KINDS[a.category].back]


def model(
    name: str, size: Size, *, category: str = "", sized: bool = False, **more: float
) -> Model:
    return Model(
        name, name, (), size, "", "", "x.glb", category, more.get("elevation", 0.0), sized=sized
    )


def turned(parts: tuple[Part, ...], quarters: int) -> tuple[Part, ...]:
    """Parts turned clockwise by quarters."""
    cos, sin = ((1, 0), (0, -1), (-1, 0), (0, 1))[quarters]
    matrix = np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]], np.float64)
    return tuple(Part(p.material, p.vertices @ matrix.T, p.faces) for p in parts)


def test_the_words_are_of_known_kinds() -> None:
    known = set(KINDS) | set(GENERIC) | {OTHER}
    assert {kind for phrase in phrases() for kind in phrase.kinds} <= known
    assert {kind for kinds in REFINED.values() for kind in kinds} <= known
    assert {kind for row in GENERIC.values() for kind in row.kinds} <= known
    assert {language for _, language, _ in phrases()} >= {"en", "fr", "de", "es", "zh", "ja"}


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("Desk lamp", ("desk_lamp",)),
        ("lampRoundTable", ("table_lamp",)),
        ("tableCoffeeGlass", ("coffee_table",)),
        ("Piano bench", ()),
        ("Chair with cushion", ("dining_chair", "armchair")),
        ("Shower head and faucet", ()),
        ("Canapé d’angle", ("corner_sofa",)),
        ("Schreibtischlampe", ("desk_lamp",)),
        ("Mesita de noche", ("nightstand",)),
        ("转角沙发", ("corner_sofa",)),
        ("ナイトテーブル", ("nightstand",)),
        ("Wall flat TV", ("tv",)),
    ],
)
def test_the_longest_phrase_names_the_kind(name: str, kinds: tuple[str, ...]) -> None:
    found = match(name)
    assert found is not None
    assert found.kinds == kinds
    shown = match(f"  {name.upper() if ' ' in name else name}_3 ".strip())
    assert shown is not None
    assert shown.kinds == kinds


@pytest.mark.parametrize(
    ("made", "category"),
    [
        (model("Armchair", Size(0.6, 0.62, 1.05), category="Office"), "office_chair"),
        (model("Armchair", Size(0.8, 0.8, 0.85), category="Living room"), "armchair"),
        (model("Cabinet", Size(0.6, 0.35, 0.7), category="Kitchen", elevation=1.4), "wall_cabinet"),
        (model("Cabinet", Size(0.6, 0.6, 0.88), category="Kitchen"), "base_cabinet"),
        (model("Shelves", Size(0.8, 0.25, 0.4), elevation=1.5), "wall_shelf"),
        (model("Lamp", Size(0.5, 0.5, 0.6), sized=True, elevation=1.9), "pendant_lamp"),
        (model("Lamp", Size(0.3, 0.3, 0.5), sized=True), "table_lamp"),
        (model("Sofa", Size(1.5, 0.85, 0.8)), "loveseat"),
        (model("Chair", Size(1.8, 4.5, 1.4), category="Vehicles"), OTHER),
        (model("Chair", Size(0.5, 0.5, 0.04), sized=True), OTHER),
        (model("Zorble", Size(0.5, 0.5, 0.5)), OTHER),
    ],
)
def test_room_height_and_size_tell_kinds_of_one_name_apart(made: Model, category: str) -> None:
    assert understood(made).category == category


@pytest.mark.parametrize("unit", [0.001, 0.01, 0.1, 0.0254, 10.0, 100.0, 1000.0])
def test_a_chair_in_any_unit_is_a_chair_in_metres(unit: float) -> None:
    size = SIZES["dining_chair"][1]
    found = understood(model("chair", Size(*(side / unit for side in size))))
    assert found.category == "dining_chair"
    assert found.scale == pytest.approx(unit)


@pytest.mark.parametrize("factor", [0.01, 2.0, 0.0254])
def test_a_catalogue_has_the_unit_most_of_its_models_agree_on(factor: float) -> None:
    kinds = ("sofa", "desk", "wardrobe", "bookcase", "dining_chair", "fridge", "toilet")
    sizes = [Size(*(side / factor for side in SIZES[kind][1])) for kind in kinds]
    made = tuple(model(k.replace("_", " "), s) for k, s in zip(kinds, sizes, strict=True))
    assert unit_of((*made, model("sofa", Size(900, 900, 900)))) == pytest.approx(factor)
    assert unit_of(tuple(m._replace(sized=True) for m in made)) == 1.0


@pytest.mark.parametrize("asset", SHAPED, ids=[a.id for a in SHAPED])
def test_the_front_by_shape_turns_with_the_model(asset: Asset) -> None:
    """A shape never tells a wrong side of our own assets, however they are turned."""
    parts, size = asset.mesh(asset.usual), asset.usual
    for quarters in range(4):
        across = Size(size.depth, size.width, size.height) if quarters % 2 else size
        found = front(turned(parts, quarters), across, asset.category)
        assert found.sure == 0.0 or found.turn == quarters


def test_fronts_by_shape_are_told_of_most_seats_and_beds() -> None:
    seats = [a for a in SHAPED if a.category in ("sofa", "armchair", "dining_chair", "double_bed")]
    told = [front(a.mesh(a.usual), a.usual, a.category).sure > 0 for a in seats]
    assert all(told)
    assert len(SIDES) == 4


@pytest.mark.realdata(quick=True)
def test_names_of_a_large_catalogue_in_two_languages(real_data: Path) -> None:
    """Of 820 pieces the English and the Chinese name rarely say different things."""
    table = real_data / "furniture_sweethome3d" / "catalogue_820.csv"
    with table.open(encoding="utf-8") as text:
        rows = [row for row in csv.DictReader(text) if row["name_zh"] != row["name"]]
    pairs = [(match(row["name"]), match(row["name_zh"])) for row in rows]
    both = [(a.kinds, b.kinds) for a, b in pairs if a and b and a.kinds and b.kinds]
    agree = sum(bool(set(a) & set(b)) for a, b in both)
    assert len(both) > 100
    assert agree > 0.85 * len(both)


@pytest.mark.realdata
def test_a_real_kit_in_its_own_unit_is_understood(real_data: Path) -> None:
    models = library(real_data / "kenney_furniture_nature")
    unit = unit_of(models)
    assert unit == 2.0
    found = [understood(m, unit) for m in models]
    assert sum(u.category != OTHER for u in found) > 90
    turned = [u for u in found if u.turn and u.category != "staircase"]
    assert len(turned) <= 1, "the kit has its fronts where glTF has them, but its stairs go aside"
