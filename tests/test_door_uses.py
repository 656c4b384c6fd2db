"""Doors are made by what they join: glass to the open air, plain before closets, whatever width."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.building.door_uses import DoorUse, classify_doors
from scenewright.building.joinery import parts
from scenewright.building.shell import shell
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Scene
from scenewright.core.space import Opening
from scenewright.domains import plan_of
from scenewright.render.items import things

CLEAR, FROSTED, PANEL, WOOD = "window glass", "frosted glass", "cupboard panel", "door oak"
LEAVES = {CLEAR, FROSTED, PANEL, WOOD}


def leaves(width: float, use: DoorUse, hinge: int = 0) -> set[str]:
    door = Opening("d", "door", "0", 0, 0, 1, 0, width, 0.12, 0.0, 2.05, hinge, hinge)
    return {part.material.name for part in parts(door, use)} & LEAVES


@pytest.mark.parametrize("hinge", [0, 1])
@pytest.mark.parametrize("width", [0.6, 1.0, 1.49, 1.5, 2.4])
def test_a_leaf_is_of_what_it_joins_at_any_width(width: float, hinge: int) -> None:
    assert leaves(width, "garden", hinge) == {CLEAR}
    assert leaves(width, "closet", hinge) == {PANEL}
    assert leaves(width, "inner", hinge) == {FROSTED if width >= 1.5 and not hinge else WOOD}


def test_people_come_in_through_wood() -> None:
    assert leaves(0.9, "entrance", 1) == {WOOD}


@pytest.mark.parametrize("use", ["garden", "closet", "inner"])
@pytest.mark.parametrize("width", [0.35, 0.9, 1.6, 3.0])
def test_panels_stay_in_their_opening(use: DoorUse, width: float) -> None:
    door = Opening("d", "door", "0", 0, 0, 1, 0, width, 0.12, 0.0, 2.05)
    points = np.vstack([part.vertices for part in parts(door, use)])
    assert np.abs(points[:, 0]).max() <= width / 2 + 1e-9
    assert points[:, 2].max() <= 2.05 + 1e-9


def flat(*doors: tuple[str, list[float], str, str]) -> Scene:
    """A hall, a living room north of it, a closet west of that and a balcony north of it."""
    boxes = {
        "hall": (0.0, 0.0, 4.0, 2.0),
        "living": (0.0, 2.12, 4.0, 6.0),
        "storage": (-1.12, 2.12, -0.12, 6.0),
        "balcony": (0.0, 6.12, 4.0, 7.5),
    }
    rooms = [
        {
            "id": name,
            "function": name,
            "outline": [[x, y], [x1, y], [x1, y1], [x, y1]],
            "doors": [
                {"at": at, "width": 0.8, "swing": swing} | ({"to": to} if to else {})
                for of, at, to, swing in doors
                if of == name
            ],
        }
        for name, (x, y, x1, y1) in boxes.items()
    ]
    brief = Brief.model_validate({"rooms": rooms})
    plan = plan_of(brief)
    walls, openings = shell(brief, plan.spaces)
    return Scene("home", plan.levels, plan.spaces, walls, openings, ())


def test_the_doors_of_a_flat() -> None:
    home = flat(
        ("hall", [2.0, 0.0], "", "in"),
        ("hall", [2.0, 2.0], "living", "in"),
        ("living", [2.0, 6.0], "balcony", "slide"),
        ("living", [0.0, 4.0], "storage", "slide"),
        ("living", [4.0, 4.0], "", "in"),
    )
    uses = classify_doors(home.openings, home.spaces)
    told = [(sorted(o.spaces), uses[o.id]) for o in home.openings]
    assert sorted(told) == [
        (["balcony", "living"], "garden"),
        (["hall"], "entrance"),
        (["hall", "living"], "inner"),
        (["living"], "garden"),
        (["living", "storage"], "closet"),
    ]
    drawn = {t.name: {p.material.name for p in t.parts} for t in things(home, shipped())}
    glazed = {o.id for o in home.openings if CLEAR in drawn[o.id]}
    assert glazed == {name for name, use in uses.items() if use == "garden"}


def test_the_only_door_of_a_studio_is_its_entrance() -> None:
    home = flat(("living", [4.0, 4.0], "", "in"))
    assert list(classify_doors(home.openings, home.spaces).values()) == ["entrance"]
