"""What is asked for of a home: obeyed, or refused with a word on what is possible."""

from __future__ import annotations

from typing import Any

import pytest

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains.home import solving as home
from scenewright.domains.home.cases.library import SHIPPED, cases, index_cases, subset
from scenewright.domains.home.groups import GROUPS
from scenewright.formats.brief_json import loads


def living(**more: Any) -> Brief:
    outline = [(0, 0), (6, 0), (6, 4.4), (0, 4.4)]
    asked = {
        "id": "r",
        "name": "Living room",
        "outline": outline,
        "doors": [{"at": (5.2, 0), "width": 0.9}],
        "windows": [{"at": (0, 2.2), "width": 1.6}],
    }
    return Brief.model_validate({"rooms": [asked | more]})


def refusal(brief: Brief) -> str:
    with pytest.raises(InputError) as caught:
        home.solve(brief, steps=50)
    return str(caught.value)


@pytest.mark.parametrize(
    ("wishes", "told"),
    [
        (
            [{"what": "sofa", "forbid": True}, {"what": "sofa", "required": True}],
            "wishes[1] wants 'sofa', but wishes[0] forbids 'sofa'",
        ),
        (
            [{"what": "media", "required": True}, {"what": "tv", "forbid": True}],
            "wishes[0] wants 'media', but wishes[1] forbids 'tv'",
        ),
        (
            [{"what": "seating", "forbid": True}, {"what": "sofa", "by": "wall"}],
            "wishes[1] wants 'sofa', but wishes[0] forbids 'seating'",
        ),
    ],
)
def test_nothing_is_both_wanted_and_forbidden(wishes: list[dict[str, Any]], told: str) -> None:
    said = refusal(living(wishes=wishes))
    assert told in said
    assert "rooms[0] 'Living room'" in said


def test_what_is_asked_for_is_not_forbidden() -> None:
    brief = living(ask=[{"group": "desk"}], wishes=[{"what": "desk", "forbid": True}])
    assert "ask[0] wants 'desk', but wishes[0] forbids 'desk'" in refusal(brief)


def test_a_part_may_be_forbidden_of_what_is_wanted() -> None:
    wishes = [{"what": "media", "required": True}, {"what": "rug", "forbid": True}]
    found = home.solve(living(wishes=wishes), steps=200)
    assert any(p.function == "media" for p in found.pieces)


@pytest.mark.parametrize("group", ["desk", "dining", "sleeping"])
def test_smaller_than_any_there_is_is_refused(group: str) -> None:
    known = cases(group)
    width, depth = known.sizes[known.smallest]
    said = refusal(living(ask=[{"group": group, "size": [0.3, 0.3], "required": False}]))
    assert f"no {group} is as small as 0.3 x 0.3 m; the smallest is " in said
    assert f"{width:.2f}"[:3] in said
    assert f"{depth:.2f}"[:3] in said


@pytest.mark.parametrize("group", sorted(GROUPS))
def test_the_smallest_there_is_may_be_asked_for(group: str) -> None:
    """The size a refusal names is accepted."""
    with pytest.raises(InputError) as caught:
        home.solve(living(ask=[{"group": group, "size": [0.01, 0.01]}]), steps=50)
    told = caught.value.fault.rpartition("the smallest is ")[2].removesuffix(" m")
    size = [float(side) for side in told.split(" x ")]
    home.solve(living(ask=[{"group": group, "size": size}]), preset="quick", steps=5)


@pytest.mark.parametrize(
    ("group", "size"), [("desk", (1.4, 1.4)), ("seating", (2.6, 2.2)), ("dining", (2.0, 1.8))]
)
def test_what_stands_is_no_larger_than_asked_for(group: str, size: tuple[float, float]) -> None:
    """In a room for which one would choose a larger one."""
    for seed in range(3):
        free = home.solve(living(ask=[{"group": group}]), steps=300, seed=seed)
        bound = home.solve(living(ask=[{"group": group, "size": size}]), steps=300, seed=seed)
        (patch,) = bound.patches
        assert patch.box[3] <= size[0] + 0.005
        assert patch.box[4] <= size[1] + 0.005
        assert any(p.function == group for p in bound.pieces)
        assert free.patches[0].box[3:] != patch.box[3:]


def test_those_of_the_cases_keep_what_is_known_of_them() -> None:
    known = index_cases(
        cases("desk").groups, areas=tuple(map(float, range(len(cases("desk").sizes))))
    )
    some = subset(known, known.sizes[:, 0] < 1.4)
    assert len(some.sizes) == int((known.sizes[:, 0] < 1.4).sum())
    assert some.areas.tolist() == known.areas[known.sizes[:, 0] < 1.4].tolist()
    assert SHIPPED.own == {}


def test_centimetres_are_noticed() -> None:
    document = (
        living().model_dump_json().replace('"ask":null', '"ask":[{"group":"desk","size":[140,80]}]')
    )
    with pytest.raises(InputError, match=r"ask\[0\]\.size\[0\]: 140 .* metres"):
        loads(document)
