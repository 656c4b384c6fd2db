"""Homes furnished from a user's own catalogue: real sizes, like chairs, valid by the referee."""

from __future__ import annotations

import shutil
import subprocess
from collections import Counter
from math import pi
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from scenewright import formats
from scenewright.catalog.assets import shipped
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import OWN, Catalog, Group, Member
from scenewright.core.scene import Size
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.domains.home.cases.furnishing import Taste, anchor_of
from scenewright.domains.home.cases.library import SHIPPED, cases, fitting, index_cases
from scenewright.domains.home.cases.own_library import library_of, taste_of
from scenewright.domains.home.cases.refit import CARRIED, Chosen, reach, refit_case
from scenewright.domains.home.groups import GROUPS
from test_catalogues import obj
from thoroughness import only_thorough

CATALOG = shipped()
MODELS = {
    "sofa": Size(2.13, 0.87, 0.74),
    "coffee_table": Size(0.93, 0.61, 0.41),
    "armchair": Size(0.83, 0.77, 0.81),
    "tv_stand": Size(1.52, 0.37, 0.52),
    "dining_table": Size(1.53, 0.87, 0.75),
    "dining_chair": Size(0.43, 0.52, 0.91),
    "chair_chrome": Size(0.5, 0.56, 0.86),
    "double_bed": Size(1.66, 2.13, 0.97),
    "nightstand": Size(0.47, 0.37, 0.46),
    "wardrobe": Size(1.83, 0.63, 2.13),
}


class Furnished(NamedTuple):
    """A home on a user's own models, and two files made of it."""

    catalog: Catalog
    solution: Solution
    scene: Path
    names: Path


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A catalogue of cuboids of odd sizes, in millimetres."""
    place = tmp_path_factory.mktemp("furniture")
    for name, size in MODELS.items():
        (place / f"{name}.obj").write_text(obj(Size(*(side * 1000 for side in size))))
    (place / "catalog.csv").write_text(
        "id,front,style,colour\nchair_chrome,front,bauhaus,black\ndining_chair,front,farm,brown\n"
        + "".join(f"{name},front,,\n" for name in MODELS if "chair" not in name)
    )
    return place


def room(name: str, width: float, depth: float, left: float = 0.0, style: str = "") -> Room:
    """A room with a door at its left and a window at its upper wall."""
    right = left + width
    return Room.model_validate(
        {
            "id": name,
            "function": name,
            "style": style,
            "outline": [[left, 0], [right, 0], [right, depth], [left, depth]],
            "doors": [{"at": [left, 0.7], "width": 0.85}],
            "windows": [{"at": [left + width / 2, depth], "width": 1.2}],
        }
    )


def overlaps(group: Group) -> set[tuple[int, int]]:
    """Pairs of solid members of a group that share more than 2 cm of floor and some height."""
    found = set()
    for i, a in enumerate(group.members):
        for k, b in enumerate(group.members[:i]):
            flat = CATALOG.kinds[a.category].flat or CATALOG.kinds[b.category].flat
            level = a.z < b.z + b.size.height - 0.02 and b.z < a.z + a.size.height - 0.02
            gap = max(
                abs(a.x - b.x) - reach(a)[0] - reach(b)[0],
                abs(a.y - b.y) - reach(a)[1] - reach(b)[1],
            )
            if not flat and level and gap < -0.03:
                found.add((i, k))
    return found


@pytest.mark.parametrize("function", GROUPS)
@pytest.mark.parametrize("seed", range(3))
def test_a_refitted_case_is_sound(function: str, seed: int) -> None:
    """Nothing newly overlaps or sticks out of the box, backs stay at the back edge, members on
    others stay on them, and chosen members have their own sizes."""
    rng = np.random.default_rng(seed)
    for case in cases(function).groups[::3]:
        scale = {c: rng.uniform(0.85, 1.2, 3) for c in sorted({m.category for m in case.members})}
        chosen = {
            i: Chosen("model:x", Size(*(np.array(m.size) * scale[m.category]).tolist()))
            for i, m in enumerate(case.members)
            if CATALOG.kinds[m.category].support == "floor"
        }
        found = refit_case(case, chosen, anchor_of(case), CATALOG)
        if found is None:
            continue
        assert overlaps(found) <= overlaps(case)
        for i, (old, new) in enumerate(zip(case.members, found.members, strict=True)):
            assert i not in chosen or new.size == chosen[i].size
            if new.on < 0 and new.z < CARRIED and old.category != "rug":
                assert abs(new.x) + reach(new)[0] <= found.width / 2 + 1e-6
                assert abs(new.y) + reach(new)[1] <= found.depth / 2 + 1e-6
            if new.on >= 0:
                under = found.members[new.on]
                assert new.z == pytest.approx(under.z + under.size.height)
                assert abs(new.x - under.x) <= reach(under)[0]
            back = -case.depth / 2 - (old.y - reach(old)[1])
            if i == anchor_of(case) and abs(back) < 0.03:
                assert -found.depth / 2 - (new.y - reach(new)[1]) == pytest.approx(back, abs=0.02)


def test_the_same_sizes_give_the_same_case() -> None:
    for function in GROUPS:
        for case in cases(function).groups:
            chosen = {i: Chosen("", m.size) for i, m in enumerate(case.members)}
            found = refit_case(case, chosen, anchor_of(case), CATALOG)
            assert found is not None
            assert (found.width, found.depth) == pytest.approx((case.width, case.depth))
            for old, new in zip(case.members, found.members, strict=True):
                assert (new.x, new.y) == pytest.approx((old.x, old.y), abs=1e-9)


def test_a_wider_bed_pushes_its_nightstands_out() -> None:
    bed = Member("double_bed", 0, 0, 0, 0, Size(1.6, 2.05, 0.9))
    stands = [Member("nightstand", x, -0.8, 0, 0, Size(0.4, 0.4, 0.5)) for x in (-1.05, 1.05)]
    lamp = Member("table_lamp", 1.05, -0.8, 0.5, 0, Size(0.2, 0.2, 0.4), on=2)
    case = Group("sleeping", "bed", 2.6, 2.1, (bed, *stands, lamp))
    found = refit_case(case, {0: Chosen("model:b", Size(1.8, 2.05, 0.9))}, 0, CATALOG)
    assert found is not None
    assert found.width == pytest.approx(2.8)
    assert [m.x for m in found.members] == pytest.approx([0, -1.15, 1.15, 1.15])


def test_chairs_at_a_turned_side_keep_their_tuck() -> None:
    table = Member("dining_table", 0, 0, 0, 0, Size(1.0, 0.8, 0.74))
    chair = Member("dining_chair", 0.55, 0, 0, pi / 2, Size(0.4, 0.5, 0.9))
    case = Group("dining", "table", 2.0, 1.0, (table, chair))
    found = refit_case(case, {0: Chosen("t", Size(1.4, 0.9, 0.74))}, 0, CATALOG)
    assert found is not None
    tuck = found.members[1].x - found.members[0].x - 0.7
    assert tuck == pytest.approx(0.55 - 0.5)


def test_chairs_too_wide_for_their_table_are_refused() -> None:
    table = Member("dining_table", 0, 0, 0, 0, Size(1.0, 0.8, 0.74))
    chairs = [Member("dining_chair", x, -0.6, 0, 0, Size(0.45, 0.5, 0.9)) for x in (-0.25, 0.25)]
    case = Group("dining", "table", 1.2, 1.8, (table, *chairs))
    wide = Chosen("c", Size(0.6, 0.5, 0.9))
    assert refit_case(case, {1: wide, 2: wide}, 0, CATALOG) is None
    lamp = Member("table_lamp", 0, 0, 0.74, 0, Size(0.3, 0.3, 0.4), on=0)
    lit = case._replace(members=(*case.members, lamp))
    assert refit_case(lit, {3: Chosen("l", Size(0.9, 0.9, 0.4))}, 0, CATALOG) is None
    assert refit_case(lit, {3: Chosen("l", Size(0.5, 0.5, 0.4))}, 0, CATALOG) is not None


def test_without_models_the_library_is_the_shipped_one() -> None:
    assert library_of(CATALOG, Taste()) is SHIPPED
    assert not any(cases(name).real.any() for name in GROUPS)


def test_real_cases_come_first_and_may_be_a_little_larger(folder: Path) -> None:
    library = library_of(catalog_of([str(folder)]), Taste())
    found = fitting("wardrobe", 1.7, 0.6, library)
    assert found[0].members[0].asset == "model:wardrobe"
    assert not fitting("wardrobe", 1.2, 0.6, library)[0].members[0].asset
    assert index_cases(cases("bath").groups).real.sum() == 0


def test_a_home_stands_on_its_own_models_unstretched(folder: Path) -> None:
    brief = Brief(
        catalogs=[str(folder)],
        rooms=[room("living", 5.2, 6.4), room("double_bedroom", 3.8, 4.2, 7.0)],
    )
    solution = home.solve(brief, steps=4000)
    assert check(solution).valid
    own = [p for p in solution.pieces if p.asset.startswith(OWN)]
    for piece in own:
        assert piece.size == pytest.approx(MODELS[piece.asset.removeprefix(OWN)])
    assert {p.category for p in own} >= {"sofa", "dining_table", "double_bed", "wardrobe"}
    again = home.solve(brief, steps=4000)
    assert [(p.asset, p.pose) for p in again.pieces] == [(p.asset, p.pose) for p in solution.pieces]


@pytest.mark.parametrize(
    ("style", "colour", "chair"),
    [
        ("Bauhaus", "", "model:chair_chrome"),
        ("farm", "", "model:dining_chair"),
        ("", "black", "model:chair_chrome"),
        ("", "brown", "model:dining_chair"),
    ],
)
def test_style_and_colour_choose_among_models(
    folder: Path, style: str, colour: str, chair: str
) -> None:
    catalog: Catalog = catalog_of([str(folder)])
    library = library_of(catalog, Taste(style, colour))
    for case in library.own["dining"].groups:
        chairs = {m.asset for m in case.members if m.category == "dining_chair" and m.asset}
        assert chairs <= {chair}


def test_a_room_has_its_own_taste_or_the_homes() -> None:
    brief = Brief(
        style="oak",
        colour="white",
        rooms=[room("living", 4, 5), room("bedroom", 4, 4, style="steel")],
    )
    assert [taste_of(brief, r) for r in brief.rooms] == [("oak", "white"), ("steel", "white")]


@pytest.fixture(scope="module")
def furnished(real_data: Path, tmp_path_factory: pytest.TempPathFactory) -> Furnished:
    """The sample flat with 175 CC0 models, and its scene with the names of their authors."""
    library = str(real_data / "furniture_sweethome3d" / "BlendSwap-CC-0.sh3f")
    solution = home.solve(formats.read("sample:home-flat", catalogs=[library]), steps=2000)
    scene = tmp_path_factory.mktemp("flat") / "flat.glb"
    names = scene.with_name("flat.credits.txt")
    for file in (scene, names):
        formats.write(solution, file)
    return Furnished(catalog_of([library]), solution, scene, names)


@only_thorough
@pytest.mark.realdata
def test_a_flat_of_a_whole_library_is_valid_light_and_credits_everybody(
    furnished: Furnished,
) -> None:
    """175 CC0 models: every one is listed, all pieces drawn once, every author named."""
    assets = furnished.catalog.assets
    counts = Counter(asset.category for asset in assets.values() if asset.id.startswith(OWN))
    assert counts.total() == 175
    assert counts["other"] < 100
    assert len(counts) > 35
    assert check(furnished.solution).valid
    used = {p.asset for p in furnished.solution.pieces if p.asset.startswith(OWN)}
    assert len(used) >= 18
    assert furnished.scene.stat().st_size < 40e6
    told = furnished.names.read_text(encoding="utf-8")
    assert [assets[a].author for a in used if assets[a].author not in told] == []


@only_thorough
@pytest.mark.realdata
def test_its_scene_is_as_the_standard_asks(furnished: Furnished) -> None:
    assert errors(furnished.scene) == 0


def errors(scene: Path) -> int:
    """How much the Khronos validator finds wrong; skips where it is not installed (npm
    gltf-validator)."""
    node = shutil.which("node")
    code = """const v = require('gltf-validator'), fs = require('fs');
        v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))
         .then(r => console.log(r.issues.numErrors))"""
    if node is None:
        pytest.skip("no node: install it and npm gltf-validator to validate the scene")
    done = subprocess.run([node, "-e", code, str(scene)], capture_output=True, text=True)
    if "Cannot find module 'gltf-validator'" in done.stderr:
        pytest.skip("no gltf-validator: npm install gltf-validator, and set NODE_PATH")
    assert done.returncode == 0, done.stderr
    return int(done.stdout)


@pytest.mark.skipif(shutil.which("node") is None, reason="needs node")
def test_only_a_validator_that_is_not_there_is_skipped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene, package = tmp_path / "scene.glb", tmp_path / "gltf-validator"
    scene.write_bytes(b"glTF")
    monkeypatch.setenv("NODE_PATH", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    with pytest.raises(pytest.skip.Exception, match="npm install"):
        errors(scene)
    package.mkdir()
    told = "exports.validateBytes = async b => ({issues: {numErrors: b.length}})"
    (package / "index.js").write_text(told)
    assert errors(scene) == 4
    for broken in (
        "exports.validateBytes = async b => { throw new Error('cannot read') }",
        "require('another-module')",
    ):
        (package / "index.js").write_text(broken)
        with pytest.raises(BaseException, match=r"cannot read|another-module") as raised:
            errors(scene)
        assert raised.type is AssertionError, "a skip would be no test"
