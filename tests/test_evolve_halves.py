"""What is bred for the next sheet: half before the first mark, half from it on, never too much."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.engine.preference.events import Pick
from scenewright.workflow.evolution.population import BreedingPlan, choose_genomes, fit_breeding
from scenewright.workflow.evolve import evolve, resume_evolution

ROOM = "sample:home-room"
FEW = BreedingPlan(first=8, each=5, rounds=1, brood=8)


def test_half_of_the_next_candidates_follow_from_the_first_mark(tmp_path: Path) -> None:
    """However many marks come after it, and whenever; another first mark leads to others."""

    def breed(log: Path, marks: tuple[int, ...], resumed: bool = False) -> list[Genome]:
        with evolve(ROOM, log, breeding=FEW) as evolution:
            shown = tuple(one.number for one in evolution.ask().candidates)
            for mark in marks:
                evolution.tell(Pick(shown[mark], shown))
            if not resumed:
                evolution.ask()
                return [one.genome for one in evolution._archive.bred.values()][FEW.first :]
        with resume_evolution(log) as evolution:
            evolution.ask()
            return [one.genome for one in evolution._archive.bred.values()][FEW.first :]

    one = breed(tmp_path / "one", (2,))
    assert len(one) == FEW.each
    assert breed(tmp_path / "more", (2, 5)) == one
    assert breed(tmp_path / "resumed", (2, 5), resumed=True) == one
    other = breed(tmp_path / "other", (5,))
    assert other[:3] == one[:3]
    assert other[3:] != one[3:]


def test_no_more_is_bred_for_a_sheet_than_its_breeder_makes() -> None:
    slow = Breeder((Gene("a", 40),), lambda _genome: pytest.fail("developed"), each=13, unseen=50)
    halves = [fit_breeding(BreedingPlan(), slow, part) for part in (0, 1)]
    assert [how.each for how in halves] == [7, 6]
    for how in halves:
        assert (how.rounds + 2) * how.brood * 2 <= slow.unseen
        some = choose_genomes(slow, None, [], [], 0, np.random.default_rng(1), how)
        assert len(some) == how.first
