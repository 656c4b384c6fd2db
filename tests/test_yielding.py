"""Rooms may not bar one another: what the exact routes do not reach gives way, and is told."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.attempts.second_try import tried_again
from scenewright.domains.home.cases.library import SHIPPED
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.tasks import task_of, wishes_of
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget


def two_rooms(width: float, depth: float) -> Brief:
    """A small bedroom through which one comes to another room."""
    inner = [(0.0, depth + 0.1), (width, depth + 0.1), (width, depth + 2.1), (0.0, depth + 2.1)]
    bedroom = {
        "id": "bed",
        "function": "single_bedroom",
        "outline": [(0, 0), (width, 0), (width, depth), (0, depth)],
        "doors": [
            {"at": (width / 2, 0), "width": 0.8, "swing": "out"},
            {"at": (width / 2, depth), "width": 0.8, "swing": "slide"},
        ],
    }
    return Brief.model_validate({"rooms": [bedroom, {"id": "in", "outline": inner}]})


@pytest.mark.parametrize(("width", "depth"), [(2.0, 2.1), (2.0, 2.5), (2.1, 2.0)])
def test_what_bars_the_way_to_another_room_gives_way(
    width: float, depth: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    brief = two_rooms(width, depth)
    solution = home.solve(brief, seed=0, steps=2000)
    assert check(solution).valid
    told = [out.reason for out in solution.left_out if "walking route" in out.reason]
    assert any("it would bar the walking route to the room in" in reason for reason in told)
    names = {piece.group for piece in solution.pieces}
    assert {patch.id for patch in solution.patches} <= names
    usual = PRESETS["default"]
    never = usual.settings._replace(retry=usual.settings.retry._replace(rounds=0))
    monkeypatch.setitem(PRESETS, "untouched", usual._replace(settings=never))
    before = home.solve(brief, preset="untouched", seed=0, steps=2000)
    assert not check(before).valid
    standing = {p.id for p in solution.pieces if p.category != "rug"}  # rugs follow other pieces
    assert standing < {p.id for p in before.pieces}


def test_a_room_that_gave_up_what_it_is_for_is_tried_again() -> None:
    """Of a bedroom all is given up at first, so it is furnished anew; then nothing bars a way."""
    (task,), (wishes,) = furnishing(bedroom_alone())
    budget = Budget(threads=1, steps=4000)
    first = furnish_by_use(task, wishes, budget)
    asked: list[RoomAnswer] = []

    def barred_once(answers: Sequence[RoomAnswer]) -> list[RoomAnswer]:
        asked.extend(answers)
        return [given_up(answers[0])] if len(asked) == 1 else list(answers)

    (answer,) = tried_again([task], [wishes], [budget], [first], barred_once)
    assert len(asked) == 2
    assert asked[0] is first
    assert any(p.wish.core for p in answer.placed)
    assert [p.dressed.box.tolist() for p in answer.placed] != [
        p.dressed.box.tolist() for p in first.placed
    ]
    barred = tried_again([task], [wishes], [budget], [first], lambda a: [given_up(a[0])])
    assert barred == [given_up(first)]
    timed = budget._replace(seconds=0.1)
    asked.clear()
    (beside,) = tried_again([task], [wishes], [timed], [first], barred_once)
    assert any(p.wish.core for p in beside.placed)
    assert beside.evaluations < answer.evaluations


def given_up(answer: RoomAnswer) -> RoomAnswer:
    """An answer without all it holds; what it lacked it lacks still."""
    lost = tuple(Missing(placed.wish, "it bars the way") for placed in answer.placed)
    return answer._replace(placed=(), missing=(*answer.missing, *lost))


def bedroom_alone() -> Brief:
    return Brief(rooms=two_rooms(4.0, 3.6).rooms[:1])


def furnishing(brief: Brief) -> tuple[list[RoomTask], list[tuple[Wish, ...]]]:
    """The rooms of a brief as tasks, and what each is wished to hold."""
    catalog, rooms = shipped(), spaces(brief)
    tasks = [
        task_of(brief, room, space, (), catalog, SHIPPED, PRESETS["default"], "anneal", 0)
        for room, space in zip(brief.rooms, rooms, strict=True)
    ]
    wishes = [wishes_of(r, t, rooms, ()) for r, t in zip(brief.rooms, tasks, strict=True)]
    return tasks, wishes
