"""One row a kind: what it takes to add one, and single pieces that are placed by their row."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.catalog.kinds import KINDS
from scenewright.catalog.kinds.small import KINDS as SMALL
from scenewright.catalog.models.words import ASIDE, match, phrases
from scenewright.core.brief import Brief
from scenewright.core.space import Space
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.alone import own_groups
from scenewright.domains.home.learned.words import ANCHORS
from scenewright.domains.home.programme import programme

PLUGINS = Path(__file__).parent / "plugins"
LANGUAGES = {"en", "fr", "de", "es", "zh", "ja"}
NAMES = (
    "Rebounder",
    "petit trampoline",
    "Gartentrampolin",
    "Cama elástica",
    "蹦床",
    "トランポリン",
)
USED = """
import json, sys
import scenewright as sw
from scenewright.catalog.models.words import match
from scenewright.workflow.lists import rows
home, hall = (sw.solve(sw.Brief.model_validate(d), preset="quick", seed=1, steps=400)
              for d in json.load(sys.stdin))
for name in ("home.glb", "home.svg", "home.json"):
    sw.write(home, name)
print(json.dumps({
    "home": [piece.category for piece in home.pieces],
    "valid": sw.check(home).valid,
    "hall": [piece.category for piece in hall.pieces],
    "assets": [row["name"] for row in rows("assets") if row["category"] == "trampoline"],
    "groups": [row["holds"] for row in rows("groups") if row["name"] == "bouncing"],
    "words": [list(found.kinds) for name in sys.argv[1:] if (found := match(name))],
}))
"""


def room(domain: str = "home", **more: Any) -> dict[str, Any]:
    outline = [[0, 0], [5, 0], [5, 4], [0, 4]]
    wanted = {"name": "Room", "outline": outline, "doors": [{"at": [2.5, 0], "width": 0.9}]}
    return {"domain": domain, "name": "Room", "rooms": [wanted | more]}


@pytest.fixture(scope="module")
def used(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What becomes of a kind that another package adds by one row and one function."""
    briefs = [
        room(function="study", ask=[], wishes=[{"what": "trampoline", "required": True}]),
        room("hall", demands=[{"category": "trampoline", "count": 4}]),
    ]
    paths = os.pathsep.join([str(PLUGINS), *filter(None, [os.environ.get("PYTHONPATH")])])
    folder = tmp_path_factory.mktemp("gym")
    done = subprocess.run(
        [sys.executable, "-c", USED, *NAMES],
        input=json.dumps(briefs),
        capture_output=True,
        text=True,
        cwd=folder,
        env=os.environ | {"PYTHONPATH": paths},
    )
    assert done.returncode == 0, done.stderr
    drawn = b"trampoline" in (folder / "home.glb").read_bytes()
    return json.loads(done.stdout) | {"drawn": drawn, "svg": (folder / "home.svg").read_text()}


def test_a_kind_of_another_package_is_placed(used: dict[str, Any]) -> None:
    assert "trampoline" in used["home"]
    assert used["valid"]
    assert used["hall"].count("trampoline") == 4


def test_it_is_drawn_and_listed(used: dict[str, Any]) -> None:
    assert used["drawn"]
    assert "trampoline" in used["svg"].lower()
    assert used["assets"] == ["Trampoline"]
    assert used["groups"] == ["trampoline"]


def test_it_is_recognised_in_every_language(used: dict[str, Any]) -> None:
    assert used["words"] == [["trampoline"]] * len(LANGUAGES)


@pytest.mark.parametrize("kind", ["exercise_bike", "piano", "ironing_board", "cot"])
def test_single_pieces_are_placed_where_they_are_wished_for(kind: str) -> None:
    wishes = [{"what": kind, "required": True}]
    brief = Brief.model_validate(room(function="study", ask=[], wishes=wishes))
    found = scenewright.solve(brief, preset="quick", seed=1, steps=400)
    assert kind in [piece.category for piece in found.pieces]
    assert found.left_out == ()
    assert scenewright.check(found).valid


def test_a_large_study_may_hold_an_exercise_bike() -> None:
    def groups(width: float, *functions: str) -> set[str]:
        outline = np.array([[0, 0], [width, 0], [width, 4], [0, 4]], float)
        space = Space("r", "", functions, "0", outline)
        return {wish.group for wish in programme(space, 4 * width, frozenset())}

    assert "exercise" in groups(5.0, "study")
    assert "exercise" not in groups(4.0, "study")
    assert "exercise" not in groups(20.0, "living", "study")


def test_one_lives_in_a_large_bedroom_where_no_room_is_for_living() -> None:
    outline = np.array([[0, 0], [5, 0], [5, 4], [0, 4]], float)
    space = Space("r", "", ("bedroom",), "0", outline)

    def groups(area: float, *home: str) -> set[str]:
        wishes = programme(space, area, frozenset(home))
        return {wish.group for wish in wishes} & {"seating", "media", "reading"}

    assert groups(20.0, "kitchen") == {"seating", "media"}
    assert groups(20.0, "kitchen", "living") == {"reading"}
    assert groups(16.0, "kitchen") == set()
    assert groups(20.0) == {"reading"}


def test_groups_of_single_pieces_have_names_of_their_own() -> None:
    assert set(own_groups()) <= set(GROUPS)
    assert set(ANCHORS.values()) <= set(GROUPS)


@pytest.mark.parametrize("kind", KINDS.values(), ids=lambda kind: kind.category)
def test_every_row_is_whole(kind: Any) -> None:
    assert kind.sizes
    assert kind.drawn_by
    assert "_" not in kind.name
    assert {other for said in kind.words for other in said.also} <= set(KINDS)
    assert set(kind.under) <= set(KINDS)
    assert kind.chairs is None or kind.chairs.category in KINDS
    assert kind.hall is None or kind.support == "floor"


NAMELESS = {"obstacle", "partition", "building", "house", "road"} | {
    kind.category for kind in SMALL
}
"""Made by the program or told by size: no model is recognised as one by its name."""


@pytest.mark.parametrize("kind", sorted(set(KINDS) - NAMELESS))
def test_every_kind_is_recognised_in_every_language(kind: str) -> None:
    """By phrases of its own, or those it shares with its like."""
    found = {phrase.language: phrase for phrase in phrases() if kind in phrase.kinds}
    assert set(found) == LANGUAGES
    for phrase in found.values():
        told = match(" ".join(phrase.words))
        assert told is not None
        assert kind in told.kinds


def test_every_phrase_can_be_met() -> None:
    """None goes on after a *with* or the like, which ends what a name says."""
    assert [p.words for p in phrases() if ASIDE.intersection(p.words[1:])] == []


def test_no_phrase_names_two_things() -> None:
    named: dict[tuple[str, ...], set[tuple[str, ...]]] = {}
    for phrase in phrases():
        named.setdefault(phrase.words, set()).add(phrase.kinds)
    assert [words for words, kinds in named.items() if len(kinds) > 1] == []
