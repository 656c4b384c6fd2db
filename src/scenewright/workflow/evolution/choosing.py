"""Which candidates one person is shown next, and what is predicted of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.engine.preference.events import champion_of, favourites_of
from scenewright.engine.preference.screens import ScreenMix, choose_screen
from scenewright.engine.preference.taste import PersonTaste, judge_each
from scenewright.workflow.evolution.archive import CandidateArchive
from scenewright.workflow.evolution.candidate import ShownCandidate, predicted_shares
from scenewright.workflow.evolution.history import History


def choose_candidates(
    archive: CandidateArchive,
    history: History,
    taste: PersonTaste,
    epoch: str,
    rng: np.random.Generator,
    mix: ScreenMix,
) -> list[int]:
    """The numbers of the candidates of a person's next screen: her champion and favourites, the
    predicted best, draws and the farthest of an epoch."""
    rows = archive.sane(epoch)
    champion = champion_of(history.events)
    if champion is not None and champion not in rows:
        rows = [*rows, champion]
    values = np.array([archive.bred[n].values for n in rows])
    seen = np.array([n in history.shown for n in rows])
    liked = [n for n in favourites_of(history.events) if n in rows]
    kept = [n for n in (champion,) if n is not None] + liked[: mix.favourites]
    places = [rows.index(number) for number in kept]
    return [rows[k] for k in choose_screen(taste, values, seen, places, rng, mix)]


def predict_candidates(
    archive: CandidateArchive,
    numbers: Sequence[int],
    solutions: Sequence[Solution],
    plans: Sequence[Plan],
    taste: PersonTaste,
) -> list[ShownCandidate]:
    """Candidates with what is predicted of them, if anything is."""
    values = np.array([archive.bred[number].values for number in numbers])
    known = taste.posterior is not None or bool(taste.start.any())
    mean, deviation = judge_each(taste, values)
    shares = predicted_shares(mean, deviation)
    return [
        ShownCandidate(
            number,
            solutions[k],
            plans[k],
            float(mean[k]) if known else None,
            float(deviation[k]) if known else None,
            float(shares[k]) if known else None,
            archive.bred[number].valid,
        )
        for k, number in enumerate(numbers)
    ]
