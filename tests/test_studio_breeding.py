"""Breeding: sheets on the page, what is said of them, cancelling, and differences in words."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from threading import Thread

import pytest

import scenewright as sw
from scenewright.core.breeding import Genome
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.solution import Solution, unfurnished
from scenewright.engine.preference.events import Pick
from scenewright.formats import solution_json
from scenewright.workflow.evolution.nursery import WORKERS
from scenewright.workflow.evolution.population import BreedingPlan

pytest.importorskip("starlette")
from scenewright.studio.breeding import name_log, share
from scenewright.studio.drawable import draw_card
from scenewright.studio.session import Session
from scenewright.workflow import project
from studio_asking import ask

HOME = "sample:home-room"
FEW = BreedingPlan(first=4, each=2, rounds=1, brood=4)


def wait(session: Session) -> None:
    for _ in range(1200):
        if not session.breeding.running:
            return
        time.sleep(0.05)
    raise AssertionError("no sheet was bred")


@pytest.fixture(scope="module")
def bred(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    """A session with its first sheet, of few layouts."""
    db = project.open_project(tmp_path_factory.mktemp("bred") / "room.studio")
    brief = sw.read(HOME)
    project.add_version(db, 0, "opened", solution_json.dumps(unfurnished(brief)))
    session = Session(db, lambda _event: None)
    log = name_log(session.breeding.beside, brief)
    sw.evolve(brief, log, breeding=FEW).close()
    ask(session, verb="breed")
    wait(session)
    yield session
    session.breeding.close()
    db.close()


def test_what_is_said_leads_the_next_sheet_and_is_there_again(bred: Session) -> None:
    first = bred.breeding.state()
    assert len(first["shown"]) == 4
    ask(bred, verb="say", line="2", sheet=0)
    ask(bred, verb="say", line="worst 1", sheet=0)
    chosen = first["shown"][1]["number"]
    assert bred.breeding.state()["champion"] == chosen
    ask(bred, verb="next")
    wait(bred)
    second = bred.breeding.state()
    assert second["sheet"] == 1
    assert second["shown"][0]["number"] == chosen
    assert all(0 < one["predicted"] < 1 for one in second["shown"])
    with pytest.raises(InputError, match="another sheet"):
        ask(bred, verb="say", line="3", sheet=0)
    with pytest.raises(InputError, match="says nothing of a layout"):
        ask(bred, verb="say", line="done", sheet=1)
    again = Session(bred.db, lambda _event: None)
    bred.breeding.close()
    ask(again, verb="breed")
    assert again.breeding.state() == second
    again.breeding.close()
    ask(bred, verb="breed")


def test_a_layout_is_a_few_kilobytes_and_can_be_taken(bred: Session) -> None:
    numbers = bred.breeding.state()["sheets"][0]
    told = bred.breeding.draw(numbers)
    assert len(told["shells"]) == 1
    assert all(len(json.dumps(card)) < 5000 for card in told["cards"].values())
    before = bred.state()["version"]
    ask(bred, verb="choose", number=numbers[2])
    assert bred.state()["version"] == before + 1
    assert bred.state()["pieces"]
    ask(bred, verb="undo")
    with pytest.raises(InputError, match="was not shown"):
        ask(bred, verb="choose", number=999)


def test_differences_are_told_from_either_side(bred: Session) -> None:
    one, other = bred.breeding.state()["sheets"][0][:2]
    here = ask(bred, verb="compare", one=one, other=other)["differences"]
    there = ask(bred, verb="compare", one=other, other=one)["differences"]
    assert here
    assert here != there
    nearer = [text for text in here if "nearer" in text]
    assert all(text.replace("nearer", "further from") in there for text in nearer)
    assert ask(bred, verb="compare", one=one, other=one)["differences"] == []


def test_what_is_bred_is_drawn_before_it_is_asked_for(bred: Session) -> None:
    breeding, evolution = bred.breeding, bred.breeding.evolution
    assert evolution is not None
    sheet = breeding.state()["sheet"]
    ask(bred, verb="say", line="2", sheet=sheet)
    while evolution.busy() or breeding.drawing is None or breeding.drawing.is_alive():
        time.sleep(0.05)
    coming = {one.number: one.solution for one in evolution.coming()}
    assert len(coming) == FEW.each
    assert coming.keys() <= breeding.cards.keys()
    ask(bred, verb="next")
    wait(bred)
    shown = [one["number"] for one in breeding.state()["shown"]]
    assert set(shown) & coming.keys()
    for number in shown:
        one = evolution.candidate(number)
        assert one is not None
        assert breeding.draw([number]) == share(
            {number: draw_card(one.solution, one.plan, breeding.shapes)}
        )


def test_cancelled_breeding_develops_no_more_and_shows_nothing() -> None:
    developed: list[Genome] = []
    with sw.evolve(HOME, breeding=FEW) as evolution:
        ground = evolution._nursery.ground("")

        def develop(genome: Genome) -> Solution:
            developed.append(genome)
            return ground.breeder.develop(genome)

        slow = ground._replace(breeder=ground.breeder._replace(develop=develop))
        evolution._nursery._grounds[""] = slow
        with pytest.raises(CancelledError):
            evolution.ask(cancel=lambda: True)
        assert len(developed) <= WORKERS
        assert evolution.screen is None
        first = evolution.ask()
    with sw.evolve(HOME, breeding=FEW) as other:
        assert [one.number for one in other.ask().candidates] == [
            one.number for one in first.candidates
        ]


def test_an_evolution_is_told_from_another_thread(tmp_path: Path) -> None:
    with sw.evolve(HOME, tmp_path / "my.evolution", breeding=FEW) as evolution:
        shown = tuple(one.number for one in evolution.ask().candidates)
        other = Thread(target=evolution.tell, args=(Pick(shown[1], shown),))
        other.start()
        other.join()
        assert evolution.champion is not None
        assert evolution.champion.number == shown[1]
