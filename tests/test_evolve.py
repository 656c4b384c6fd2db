"""Evolutions: the same whenever and however often they are resumed, nothing said is lost."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from itertools import pairwise
from pathlib import Path

import pytest

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.domains import breeder_of, check, features_of, plan_of, reasons_of
from scenewright.engine.preference.events import (
    Keep,
    Lock,
    Pick,
    Prefer,
    Reason,
    Stars,
    Undo,
    Worst,
)
from scenewright.formats import solution_json
from scenewright.workflow.evolution.candidate import Screen
from scenewright.workflow.evolution.history import History
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.population import BreedingPlan
from scenewright.workflow.evolve import Evolution, evolve, resume_evolution
from thoroughness import few_or_many, only_thorough

HOME = sw.Brief.model_validate(
    {"rooms": [{"function": "study", "outline": [[0, 0], [3.2, 0], [3.2, 2.8], [0, 2.8]]}]}
)
"""A room that is furnished in a third of the time the samples take."""
SMALL_HALL = sw.Brief.model_validate(
    {
        "domain": "hall",
        "rooms": [
            {
                "id": "hall",
                "function": "hall",
                "outline": [[0, 0], [14, 0], [14, 10], [0, 10]],
                "doors": [{"at": [7, 0], "width": 2, "use": "both"}],
                "demands": [
                    {"id": name, "category": "showcase", "count": count, "size": [1.2, 0.7, 1.5]}
                    for name, count in (("old", 4), ("new", 3))
                ],
            }
        ],
    }
)
SMALL_VILLAGE = sw.Brief.model_validate(
    {
        "domain": "village",
        "blocks": [{"outline": [[0, 0], [60, 0], [60, 50], [0, 50]], "streets": [0], "count": 4}],
    }
)
SMALL_SITE = sw.Brief.model_validate(
    {
        "domain": "site",
        "sites": [
            {
                "outline": [[0, 0], [70, 0], [70, 50], [0, 50]],
                "roads": [{"name": "Road", "line": [[-5, 24], [75, 26]], "width": 6}],
                "buildings": [{"model": "villa", "count": 4}],
            }
        ],
    }
)
SOURCES: dict[str, str | sw.Brief] = {
    "home": HOME,
    "hall": SMALL_HALL,
    "site": SMALL_SITE,
    "village": SMALL_VILLAGE,
    "extend": "sample:extend-village",
}
FEW = BreedingPlan(first=8, each=5, rounds=1, brood=8)
CHOICE = FEW._replace(first=13)
"""One candidate more than a screen holds: it has to be chosen from the first on."""


def numbers(screen: Screen) -> tuple[int, ...]:
    return tuple(one.number for one in screen.candidates)


def play(evolution: Evolution, screens: int) -> list[tuple[int, ...]]:
    """Screens asked for and spoken of as somebody would who likes what is third."""
    found = []
    for _ in range(screens):
        shown = numbers(evolution.ask())
        evolution.tell(Pick(shown[2], shown), Worst(shown[-1], shown))
        evolution.tell(Reason(shown[1], "too dense"))
        found.append(shown)
    return found


@pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)
def test_every_domain_is_evolved_by_the_same_words(source: str | sw.Brief, tmp_path: Path) -> None:
    with evolve(source, tmp_path / "log", breeding=FEW) as evolution:
        first = evolution.ask()
        assert 4 <= len(first.candidates) <= 12
        assert all(one.predicted is None for one in first.candidates)
        shown = numbers(first)
        evolution.tell(Pick(shown[1], shown))
        second = evolution.ask()
        assert second.champion == numbers(second)[0] == shown[1]
        assert sum(one.chance or 0.0 for one in second.candidates) == pytest.approx(1.0)
        fresh = set(numbers(second)) - set(shown)
        assert fresh
        for one in second.candidates:
            assert check(one.solution, plan=one.plan).valid
            assert one.solution.brief == evolution.brief
        picture = second.candidates[0].picture(120)
        assert picture.shape[1:] == (120, 3)
        assert picture.std() > 10
        assert second.candidates[0].plan_svg().startswith("<?xml")


@pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)
def test_genes_and_features_keep_the_contract(source: str | sw.Brief) -> None:
    """The same genome gives the same layout, names of features do not depend on the layout, and
    every reason speaks of features there are."""
    brief = sw.read(source) if isinstance(source, str) else source
    plan = plan_of(brief)
    one, other = (breeder_of(brief, plan) for _ in range(2))
    genome = tuple(min(1, gene.alleles - 1) for gene in one.genes)
    solution = one.develop(genome)
    assert solution_json.dumps(solution) == solution_json.dumps(other.develop(genome))
    assert solution.brief == brief
    told = features_of(solution, plan)
    assert list(features_of(one.develop(tuple(0 for _ in one.genes)), plan)) == list(told)
    assert all(abs(value) < 1e6 for value in told.values())
    for words, wanted in reasons_of(brief.domain).items():
        assert set(wanted) <= set(told), words


def test_the_best_so_far_is_told_and_changes_nothing(tmp_path: Path) -> None:
    """What is bred for the next screen can be looked at before it is asked for."""
    with (
        evolve(HOME, tmp_path / "one", breeding=FEW) as one,
        evolve(HOME, tmp_path / "other", breeding=FEW) as other,
    ):
        assert one.best_so_far() is None
        assert play(one, 1) == play(other, 1)
        while not one.ready():
            time.sleep(0.01)
        best = one.best_so_far()
        assert best is not None
        assert best.predicted is not None
        assert numbers(one.ask()) == numbers(other.ask())
        assert one.solution_of(best.number).pieces == best.solution.pieces


def test_the_same_words_lead_to_the_same_screens(tmp_path: Path) -> None:
    with (
        evolve(HOME, tmp_path / "one", breeding=CHOICE) as one,
        evolve(HOME, tmp_path / "other", breeding=CHOICE) as other,
    ):
        screens = range(few_or_many(1, 3))
        found = [play(evolution, 1)[0] for _ in screens for evolution in (one, other)]
    assert found[::2] == found[1::2]
    with evolve(HOME, tmp_path / "third", seed=5, breeding=CHOICE) as third:
        values = [one.figures() for one in third.ask().candidates]
    with resume_evolution(tmp_path / "one") as again:
        assert values != [again.ask().candidates[0].figures()]


@pytest.mark.parametrize(
    "source", [HOME, pytest.param(SMALL_SITE, marks=only_thorough)], ids=["home", "site"]
)
def test_a_resumed_evolution_goes_on_as_if_never_ended(source: sw.Brief, tmp_path: Path) -> None:
    screens = few_or_many(2, 4)
    with evolve(source, tmp_path / "whole", breeding=CHOICE) as whole:
        expected = play(whole, screens)
        events = whole.events
    for k in range(screens):
        with evolve(source, tmp_path / "parts", breeding=CHOICE) as part:
            assert play(part, 1) == [expected[k]]
    with resume_evolution(tmp_path / "parts") as last:
        assert last.events == events
        assert numbers(last.screen) == expected[-1]
        champion = last.champion
        assert champion is not None
        assert champion.number == expected[-1][2]
        taken = last.undo()
        assert taken == events[-1]
        assert last.events == events[:-1]


def test_what_is_locked_stands_in_all_that_comes(tmp_path: Path) -> None:
    with evolve(HOME, tmp_path / "log", breeding=FEW) as evolution:
        shown = numbers(evolution.ask())
        desks = [
            next(p for p in one.solution.pieces if p.category == "desk")
            for one in evolution.screen.candidates
        ]
        assert len({desk.pose for desk in desks}) > 1, "it would stand there anyway"
        evolution.tell(Pick(shown[0], shown), Lock(desks[0].id))
        second = evolution.ask()
        for one in second.candidates[1:]:
            assert any(p.pose == desks[0].pose and p.fixed for p in one.solution.pieces)
        evolution.undo()
        third = evolution.ask()
        poses = {p.pose for one in third.candidates for p in one.solution.pieces}
        assert len(poses) > 1
        assert not any(p.fixed for p in third.candidates[-1].solution.pieces)


def test_a_hand_made_change_is_a_candidate(tmp_path: Path) -> None:
    with evolve(HOME, tmp_path / "log", breeding=FEW) as evolution:
        shown = numbers(evolution.ask())
        evolution.tell(Pick(shown[0], shown))
        solution = evolution.solution_of(shown[0])
        lead = max(solution.pieces, key=lambda p: p.size.width * p.size.depth)
        made = evolution.edit(shown[0], lock=[lead.id])
        assert evolution.champion is not None
        assert evolution.champion.number == made.number
    with resume_evolution(tmp_path / "log") as again:
        assert again.champion is not None
        assert solution_json.dumps(again.champion.solution) == solution_json.dumps(made.solution)


def test_the_model_rates_only_when_it_may(tmp_path: Path) -> None:
    many = FEW._replace(first=16, each=8)
    with evolve(HOME, tmp_path / "log", breeding=many) as evolution:
        play(evolution, 1)
        with pytest.raises(InputError, match="not good enough yet"):
            evolution.rate_itself(2)
        for _ in range(8):  # a person who always says what is predicted
            if evolution.trust.enough:
                break
            screen = evolution.ask()
            told = sorted(screen.candidates, key=lambda one: -(one.predicted or 0.0))
            order = [one.number for one in told]
            better = [Prefer(one, other) for one, other in pairwise(order)]
            evolution.tell(Pick(order[0], numbers(screen)), *better)
        assert evolution.trust.late[0] < evolution.trust.screens  # the first are to learn from
        assert evolution.trust.enough
        champion, said = evolution.champion, evolution.events
        assert evolution.rate_itself(2) >= 0
        assert evolution.events == said
        assert evolution.champion is not None
        assert evolution.champion.number == champion.number  # type: ignore[union-attr]
        assert evolution.ask().champion == champion.number  # type: ignore[union-attr]


def test_taking_back_a_worst_leaves_the_pick_in_the_count_of_hits() -> None:
    shown = {"screen": 0, "shown": [0, 1, 2, 3], "predicted": [0.9, 0.1, 0.2, 0.3]}
    said = [
        {"event": "pick", "best": 0, "among": [0, 1, 2, 3]},
        {"event": "worst", "worst": 1, "among": [1, 2, 3]},
        {"event": "undo"},
    ]
    history = History().after("screen", shown)
    for body in said:
        history = history.after("event", body)
    assert (history.trust.screens, history.trust.hits) == (1, 1)
    assert history.after("event", {"event": "undo"}).trust.screens == 0


def test_nonsense_is_refused_in_one_line_and_not_kept(tmp_path: Path) -> None:
    with evolve(HOME, tmp_path / "log", breeding=FEW) as evolution:
        with pytest.raises(InputError, match="no champion"):
            evolution.tell(Lock("bed"))
        shown = numbers(evolution.ask())
        wrong = [
            Pick(999, shown),
            Pick(999, (*shown, 999)),
            Pick(shown[0], (shown[0],)),
            Prefer(shown[0], shown[0]),
            Stars(shown[0], 6, 0),
            Reason(shown[0], "too purple"),
            Keep(999),
        ]
        for event in wrong:
            with pytest.raises(InputError) as caught:
                evolution.tell(Stars(shown[0], 3, 0), event)
            assert "\n" not in str(caught.value)
        evolution.tell(Pick(shown[0], shown))
        with pytest.raises(InputError, match="zeppelin"):
            evolution.tell(Lock("zeppelin"))
        assert evolution.events == (Pick(shown[0], shown),)


def test_two_runs_on_one_log_do_not_mix(tmp_path: Path) -> None:
    with (
        evolve(HOME, tmp_path / "log", breeding=FEW) as one,
        evolve(HOME, tmp_path / "log", breeding=FEW) as other,
    ):
        shown = numbers(one.ask())
        one.tell(Pick(shown[0], shown))
        with pytest.raises(InputError, match="another run"):
            other.ask()
    with resume_evolution(tmp_path / "log") as again:
        assert again.events == (Pick(shown[0], shown),)


def test_logs_that_are_none_are_refused_in_one_line(tmp_path: Path) -> None:
    (tmp_path / "text").write_text("no database" * 100)
    for action in (
        lambda: resume_evolution(tmp_path / "nothing"),
        lambda: resume_evolution(tmp_path / "text"),
        lambda: evolve(HOME, tmp_path / "text", breeding=FEW),
        lambda: evolve(HOME, tmp_path),
    ):
        with pytest.raises(InputError) as caught:
            action()
        assert "\n" not in str(caught.value)
    with evolve(HOME, tmp_path / "log", breeding=FEW):
        pass
    with pytest.raises(InputError, match="another brief"):
        evolve("sample:home-studio", tmp_path / "log", breeding=FEW)


SAYING = """
import os, sys
from scenewright.engine.preference.events import Stars
from scenewright.workflow.evolve import resume_evolution
for _ in sys.stdin:
    if os.fork():
        os.wait()
        print("ended", flush=True)
        continue
    print(os.getpid(), flush=True)
    with resume_evolution(sys.argv[1]) as evolution:
        shown = [one.number for one in evolution.screen.candidates]
        for k in range(10_000):
            evolution.tell(Stars(shown[k % len(shown)], 1 + k % 5, 0))
            print(len(evolution.events), flush=True)
    os._exit(0)
"""
"""One run for each line it reads, in a process of its own that has all modules loaded."""


def test_killed_at_random_moments_no_event_is_lost(tmp_path: Path) -> None:
    """What a run had told that it heard is there after it is killed, whenever that is."""
    log, rng = tmp_path / "log", random.Random(0)
    with evolve(HOME, log, breeding=FEW) as evolution:
        evolution.ask()
    known = 0
    command = [sys.executable, "-c", SAYING, str(log)]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as runs:
        assert runs.stdin is not None
        assert runs.stdout is not None
        for _ in range(few_or_many(3, 10)):
            runs.stdin.write("\n")
            runs.stdin.flush()
            run, heard = int(runs.stdout.readline()), [runs.stdout.readline()]
            time.sleep(rng.uniform(0.0, 0.15))
            os.kill(run, signal.SIGKILL)
            heard += iter(runs.stdout.readline, "ended\n")
            told = [int(line) for line in heard]
            with resume_evolution(log) as again:
                assert len(again.events) >= told[-1] > known
                known = len(again.events)
    with resume_evolution(log) as last:
        assert all(isinstance(event, Stars) for event in last.events)
        last.undo()
        assert len(last.events) == known - 1
    book = EvolutionLog(log)
    assert [entry.number for entry in book.entries()] == list(range(known + 2))
    assert book.entries()[-1].body == {"event": Undo.__name__.lower()}
    book.close()
