"""The papers' interactive genetic algorithms as a person runs them: sheets, stars, takeover."""

from __future__ import annotations

import json
from hashlib import sha256
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import scenewright as sw
from scenewright import cli
from scenewright.core.breeding import Breeder, Gene, Genome, MatrixBreeder
from scenewright.core.errors import InputError
from scenewright.domains import plan_of
from scenewright.engine.preference.events import Lock, Stars
from scenewright.engine.preference.interactive.crowd import Crowd, follow
from scenewright.engine.preference.interactive.methods import INTERACTIVE_METHODS, method_named
from scenewright.workflow.evolution.by_method import make_run
from scenewright.workflow.evolve import Evolution, evolve, resume_evolution
from thoroughness import spread

AREA, SITE = "sample:extend-court", "sample:site-square"
CELLS, KINDS = 12, 3


def toy() -> MatrixBreeder:
    """Rows of twelve cells with one of three kinds each; nothing is built."""

    def draw(count: int, led: bool, rng: np.random.Generator) -> list[Genome]:
        return [tuple(row) for row in rng.integers(0, KINDS, (count, CELLS)).tolist()]

    def cross(one: Genome, other: Genome, points: int, rng: np.random.Generator):
        cut = int(rng.integers(CELLS))
        return one[:cut] + other[cut:], other[:cut] + one[cut:]

    def change(genome: Genome, rng: np.random.Generator, worth: object = None) -> Genome:
        cell, kind = int(rng.integers(CELLS)), int(rng.integers(KINDS))
        return (*genome[:cell], kind, *genome[cell + 1 :])

    breeder = Breeder((Gene("cell", KINDS),) * CELLS, lambda _: pytest.fail("developed"))
    taus = (0.0, 0.5, 0.5)
    return MatrixBreeder(breeder, taus, 10, 0.75, draw, cross, change, change, lambda one: one)


def like(genome: Genome) -> float:
    """Somebody who likes the second kind."""
    return float(np.clip(1 + sum(kind == 2 for kind in genome) // 2, 1, 5))


def rate_sheets(name: str, sheets: int, seed: int = 0) -> list[Crowd]:
    """Where a method is after each of some sheets that were rated whole."""
    heard: list[dict[Genome, float]] = []
    crowds = [follow(method_named(name), toy(), seed, heard)]
    for _ in range(sheets):
        heard.append({genome: like(genome) for genome in crowds[-1].asked})
        crowds.append(follow(method_named(name), toy(), seed, heard))
    return crowds


@pytest.mark.parametrize("name", INTERACTIVE_METHODS)
def test_what_is_rated_well_comes_more(name: str) -> None:
    crowds = [rate_sheets(name, 12, seed) for seed in range(3)]
    first = np.mean([like(one) for run in crowds for one in run[0].genomes])
    last = np.mean([like(one) for run in crowds for one in run[-1].genomes])
    assert last > first + (0.3 if INTERACTIVE_METHODS[name].keep else 0.0)


@pytest.mark.parametrize("name", INTERACTIVE_METHODS)
def test_nothing_is_asked_twice_and_no_more_than_the_method_asks_of(name: str) -> None:
    row, crowds = INTERACTIVE_METHODS[name], rate_sheets(name, 6)
    asked = [genome for crowd in crowds[:-1] for genome in crowd.asked]
    assert len(asked) == len(set(asked)) == len(crowds[-1].rated)
    for crowd in crowds[1:]:
        assert 0 < len(crowd.asked) <= (row.asked or 10)


def test_the_network_takes_over_for_a_while_and_says_so() -> None:
    crowds = rate_sheets("vp", 25)
    stages = [crowd.stage for crowd in crowds]
    assert stages[0] == 0 < stages[-1]
    taken = next(k for k, (a, b) in enumerate(pairwise(stages)) if b > a) + 1
    assert crowds[taken].age >= crowds[taken - 1].age + 4
    (note,) = [note for note in crowds[taken].notes if "for you" in note]
    assert note.startswith("network of ")
    assert any("go on rating" in note for crowd in crowds for note in crowd.notes)
    assert any("estimated" in note for crowd in crowds for note in crowd.notes)


def sheets_of(evolution: Evolution, count: int, first: int = 0) -> list[list[Genome]]:
    """The genomes of some sheets, every candidate given stars by its place."""
    found = []
    for number in range(first, first + count):
        screen = evolution.ask()
        shown = [one.number for one in screen.candidates]
        found.append([evolution._archive.bred[n].genome for n in shown])
        evolution.tell(*(Stars(n, 1 + k % 5, number) for k, n in enumerate(shown)))
    return found


@pytest.mark.parametrize("name", spread(tuple(INTERACTIVE_METHODS), 2))
def test_a_killed_evolution_goes_on_with_the_same_sheets(name: str, tmp_path: Path) -> None:
    with evolve(AREA, method=name) as whole:
        wanted = sheets_of(whole, 3)
    log = tmp_path / "court.evolution"
    with evolve(AREA, log, method=name) as begun:
        first = sheets_of(begun, 1)
    with resume_evolution(log) as resumed:
        assert resumed.method == name
        assert first + sheets_of(resumed, 2, 1) == wanted


def test_what_was_taken_back_is_as_if_it_had_not_been_said() -> None:
    with evolve(AREA, method="siga") as plain, evolve(AREA, method="siga") as other:
        for one in (plain, other):
            shown = [c.number for c in one.ask().candidates]
            one.tell(Stars(shown[0], 5, 0), Stars(shown[1], 1, 0))
        other.tell(Stars(shown[2], 5, 0))
        assert other.undo() == Stars(shown[2], 5, 0)
        assert sheets_of(plain, 1) == sheets_of(other, 1)


def test_the_best_rated_is_the_champion_and_is_written(tmp_path: Path) -> None:
    out = tmp_path / "site.json"
    said = "1=2; 2=4; 3=1; next; done"
    told = ["evolve", SITE, "--method", "vp", "-o", str(out), "--say", said, "-q"]
    assert cli.run(told) in (0, 1)
    assert out.exists()
    assert (tmp_path / "site-sheet.png").exists()
    with resume_evolution(tmp_path / "site.evolution") as kept:
        assert kept.champion is not None
        assert kept.champion.number == 1


@pytest.mark.parametrize(("brief", "name"), [(SITE, "vp"), (AREA, "ciga")])
def test_what_the_referee_does_not_pass_is_marked(brief: str, name: str) -> None:
    with evolve(brief, method=name) as evolution:
        shown = evolution.ask().candidates
    for one in shown:
        assert one.valid == one.figures()["valid"] == sw.check(one.solution).valid
        lacking = sum(out.required for out in one.solution.left_out)
        assert ("breaks a rule" in one.faults()) == (not one.valid)
        assert (f"lacks {lacking}" in one.faults()) == (lacking > 0)
    assert any(one.faults() for one in shown) == (name == "vp")


def test_what_a_method_cannot_do_is_refused() -> None:
    with pytest.raises(InputError, match="unknown method 'pv'"):
        evolve(AREA, method="pv")
    with pytest.raises(InputError, match="for sites and extensions"):
        evolve("sample:home-room", method="vp")
    with evolve(AREA, method="sga") as evolution:
        evolution.ask()
        with pytest.raises(InputError, match="'lock' is not heard"):
            evolution.tell(Lock("house"))
        with pytest.raises(InputError, match="'auto' is not heard"):
            evolution.rate_itself(1)


def test_other_methods_do_not_share_a_log(tmp_path: Path) -> None:
    log = tmp_path / "a.evolution"
    evolve(AREA, log, method="siga").close()
    with pytest.raises(InputError, match="another method"):
        evolve(AREA, log, method="sga")
    with evolve(AREA, log) as kept:
        assert kept.method == "siga"


def test_an_extension_runs_from_classes_to_the_person_as_one(tmp_path: Path) -> None:
    out = tmp_path / "court.json"
    told = ["evolve", AREA, "--method", "ciga", "-o", str(out), "--say", "1=5; next; done", "-q"]
    assert cli.run(told) in (0, 1)
    kept = json.loads((tmp_path / "court-stages.json").read_text("utf-8"))
    assert list(kept) == ["cluster", "grammar", "symmetry", "ants"]
    letters = set(kept["cluster"]["classes"])
    assert kept["grammar"]["productions"][0].startswith("LayoutConstruction → ")
    assert letters & set(kept["grammar"]["productions"][0].split("(")[1].replace(")", "").split())
    assert kept["symmetry"]["values"][0] > 0.0
    assert kept["ants"]["ants"] == 6000
    with resume_evolution(tmp_path / "court.evolution") as evolution:
        first = evolution._archive.bred[0].genome
        assert first == tuple(np.ravel(kept["ants"]["layouts"][0]).tolist())
        assert evolution.champion is not None
        assert evolution.champion.number == 0


@pytest.mark.parametrize("name", ["vp", "siga"])
def test_an_evolution_by_hand_gives_its_sheets_again(name: str) -> None:
    """Stars that somebody gave looking at the sheets: rows and closed fronts liked, scatter not.
    Developed are none: what is asked of is a matter of the matrices alone."""
    kept = json.loads((Path(__file__).parent / "data" / "evolved_by_hand.json").read_text())[name]
    brief = sw.read(kept["source"])
    run = make_run(name, brief, plan_of(brief), 0)
    heard: list[dict[Genome, float]] = []
    for sheet in kept["sheets"]:
        crowd = follow(run.method, run.matrix, run.seed, heard)
        digests = [sha256(repr(one).encode()).hexdigest()[:12] for one in crowd.asked]
        assert digests == [digest for digest, _ in sheet]
        told = zip(crowd.asked, sheet, strict=True)
        heard.append({genome: stars for genome, (_, stars) in told if stars is not None})
    assert kept["champion"] >= len(kept["sheets"][0])
    if name == "vp":
        assert any("it rates generations 3 to 5 for you" in note for note in crowd.notes)
