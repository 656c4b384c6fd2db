"""Rooms may not bar one another: what the exact routes do not reach gives way, and is told."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from scenewright.brief import Brief
from scenewright.check import check
from scenewright.domains import home
from scenewright.domains.home import second_try, yielding
from scenewright.domains.home.attempt import Furnished, Missing
from scenewright.scene import Piece


def two_rooms(width: float, depth: float) -> Brief:
    """A small bedroom through which one comes to another room."""
    inner = [(0.0, depth + 0.1), (width, depth + 0.1), (width, depth + 2.1), (0.0, depth + 2.1)]
    bedroom = {
        "id": "bed", "function": "single_bedroom",
        "outline": [(0, 0), (width, 0), (width, depth), (0, depth)],
        "doors": [{"at": (width / 2, 0), "width": 0.8, "swing": "out"},
                  {"at": (width / 2, depth), "width": 0.8, "swing": "slide"}],
    }  # fmt: skip
    return Brief.model_validate({"rooms": [bedroom, {"id": "in", "outline": inner}]})


@pytest.mark.parametrize(("width", "depth"), [(1.8, 2.1), (2.0, 2.5), (2.1, 1.8)])
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
    monkeypatch.setattr(yielding, "ROUNDS", 0)
    before = home.solve(brief, seed=0, steps=2000)
    assert not check(before).valid
    assert {p.id for p in solution.pieces} < {p.id for p in before.pieces}


def test_a_room_that_gave_up_what_it_is_for_is_tried_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The first answer is said to bar a way with all it holds."""
    walks: list[int] = []

    def barred_once(
        standing: Sequence[tuple[Piece, ...]], answers: Sequence[Furnished], **told: Any
    ) -> list[Furnished]:
        walks.append(len(answers))
        if len(walks) > 1:
            return yielding.yielded(standing, answers, **told)
        lost = [tuple(Missing(p.wish, "it bars the way") for p in a.placed) for a in answers]
        return [a._replace(placed=(), missing=m) for a, m in zip(answers, lost, strict=True)]

    monkeypatch.setattr(home, "yielded", barred_once)
    solution = home.solve(two_rooms(4.0, 3.6), steps=2000)
    assert any(piece.category == "single_bed" for piece in solution.pieces)
    assert check(solution).valid
    monkeypatch.setattr(second_try, "WIDER", ())
    walks.clear()
    assert not home.solve(two_rooms(4.0, 3.6), steps=2000).patches
