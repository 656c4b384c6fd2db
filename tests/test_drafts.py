"""Studios are furnished several times, and the best of it is kept."""

from __future__ import annotations

import pytest

import scenewright as sw
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.domains import check
from scenewright.domains.home.attempts import drafts
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer
from scenewright.domains.home.needs.stated import AskedRooms
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms

STUDIO = (Wish("seating", 0), Wish("sleeping", 0), Wish("kitchen", 0), Wish("media", 1))


@pytest.fixture(scope="module")
def task():
    brief, preset = sw.read("sample:home-studio"), PRESETS["default"]
    return prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)[0][0]


def _answer(*lacking: Wish) -> RoomAnswer:
    missing = tuple(Missing(wish, "no place") for wish in lacking)
    return RoomAnswer(0.0, (), missing, (), None, 0.0, 0)


def _furnish(answers, seeds):
    """Answers in turn, the seeds they are asked for with noted."""

    def furnish(draft):
        seeds.append(draft.seed)
        return answers[len(seeds) - 1]

    return furnish


def test_best_of_several_drafts_is_kept(task):
    lacking = (STUDIO, STUDIO[:3], STUDIO[:2], *(STUDIO[:3] for _ in range(drafts.DRAFTS - 3)))
    answers, seeds = [_answer(*wishes) for wishes in lacking], []
    best = drafts.furnish_best(task, STUDIO[:3], _furnish(answers, seeds))
    assert best.missing == answers[2].missing
    assert best.drafts == (answers[1], *answers[3:], answers[0])
    assert len(set(seeds)) == drafts.DRAFTS
    assert seeds[0] == task.seed


def test_first_of_equal_drafts_is_kept(task):
    answers = [_answer(*STUDIO[:2])._replace(score=k) for k in range(drafts.DRAFTS)]
    assert drafts.furnish_best(task, STUDIO[:3], _furnish(answers, [])).score == 0


def test_a_draft_that_loses_something_to_the_ways_gives_way_to_the_best_that_does_not(task):
    fine, worse, worst = (_answer(*STUDIO[:k])._replace(score=k) for k in (1, 2, 3))
    every = AskedRooms((task,), (STUDIO[:3],), ())

    def chosen(*lost):
        """The draft that is chosen where those of some scores lose all there is."""
        whole = fine._replace(drafts=(worse, worst))
        return drafts.choose_open(every, [whole], lambda found: _opened(found, lost))[0].score

    assert [chosen(), chosen(1), chosen(1, 2)] == [1, 2, 3]
    assert chosen(1, 2, 3) == 1


def _opened(found, lost):
    missing = _answer(*STUDIO).missing
    return [a._replace(missing=missing) if a.score in lost else a for a in found]


def test_what_is_there_in_another_kind_is_worse_than_what_is_wished_for(task):
    lacks = _answer(*STUDIO[:3])
    other = drafts.cost_of_draft(task, (*STUDIO[:3], Wish("wardrobe", 0)), lacks)
    assert other == drafts.cost_of_draft(task, STUDIO[:3], lacks) + task.costs.fallback


@pytest.mark.parametrize(
    ("wishes", "several"),
    [(STUDIO, True), (STUDIO[1:], False), (STUDIO[:2], False), ((*STUDIO[:1], STUDIO[2]), False)],
    ids=["studio", "no-seats", "no-kitchen", "no-bed"],
)
def test_rooms_of_one_or_two_uses_are_furnished_once(task, wishes, several):
    assert drafts.is_studio(task, wishes) == several
    seeds, usual = [], tuple(wish._replace(rank=1) for wish in wishes)
    drafts.furnish_best(
        task, wishes if several else usual, _furnish([_answer(*wishes)] * drafts.DRAFTS, seeds)
    )
    assert len(seeds) == (drafts.DRAFTS if several else 1)


def test_no_studio_is_tried_again_where_the_first_draft_is_good(task):
    seeds = []
    plant = Wish("plant", 2)
    assert drafts.cost_of_draft(task, (plant,), _answer(plant)) < drafts.GOOD
    wishes = tuple(w._replace(rank=2) for w in STUDIO)
    drafts.furnish_best(task, wishes, _furnish([_answer(plant)], seeds))
    assert seeds == [task.seed]


def test_a_studio_holds_more_than_in_one_draft(monkeypatch):
    brief = sw.read("sample:home-studio")
    best = sw.solve(brief, seed=1)
    monkeypatch.setattr(drafts, "DRAFTS", 1)
    once = sw.solve(brief, seed=1)
    assert len(best.left_out) < len(once.left_out)
    assert check(best).valid


def test_a_large_room_that_lacks_something_essential_is_furnished_again(task):
    wishes = (Wish("seating", 0), Wish("dining", 0))
    other = _answer(Wish("dining", 0))
    seeds = []
    drafts.furnish_best(task, wishes, _furnish([other] * drafts.DRAFTS, seeds))
    assert len(seeds) == drafts.DRAFTS
    drafts.furnish_best(task, (Wish("plant", 2),), _furnish([_answer()], seeds := []))
    assert len(seeds) == 1
