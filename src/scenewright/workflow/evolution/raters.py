"""Many people who rate layouts of one brief: one pool of candidates, a taste for each.

The pool is bred once for all. Each rater is shown what suits what that rater said
(:class:`RaterPool`); while they look, more is bred in the background for those who have seen most
of it. Nobody waits for another: asking takes from the pool that is there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from threading import BoundedSemaphore, RLock, Thread
from typing import Any, NamedTuple

import numpy as np

from scenewright import domains
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.engine.preference.events import (
    Edit,
    Event,
    Lock,
    Pick,
    Stars,
    Undo,
    Worst,
    champion_of,
    counting,
    record_of,
)
from scenewright.engine.preference.screens import ScreenMix
from scenewright.engine.preference.taste import PersonTaste, judge_each, learn_taste
from scenewright.workflow.evolution.archive import CandidateArchive
from scenewright.workflow.evolution.candidate import Screen, ShownCandidate
from scenewright.workflow.evolution.choosing import choose_candidates, predict_candidates
from scenewright.workflow.evolution.history import History
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.nursery import Choose, Nursery, OnCancel, OnProgress
from scenewright.workflow.evolution.population import BreedingPlan, choose_genomes, fit_breeding
from scenewright.workflow.evolution.statement_checks import check_said

Keep = Callable[[str, str, dict[str, Any]], None]
"""Called with every entry of a rater: who, of what kind, what it says; it is kept when this
returns."""
SEEN, AHEAD = 0.5, 96
"""Share of the pool that a rater has seen when more is bred for her; candidates up to which more
is bred whoever asks."""
AT_ONCE = 2
"""Raters whose sheets are chosen at the same time; the others wait their turn, so that what is
said meanwhile is heard at once."""


class Mark(NamedTuple):
    """An entry of a rater: a sheet that was shown or an event."""

    rater: str
    kind: str
    body: dict[str, Any]


class Liked(NamedTuple):
    """What all raters together said of a candidate: how often it was the best of a sheet, how often
    the worst, and its mean stars (none: nobody gave any)."""

    number: int
    best: int
    worst: int
    stars: float | None


class RaterPool:
    """Raters of one brief, by name. Every method may be called from any thread; ``keep`` is called
    outside the pool's lock and may be slow."""

    def __init__(
        self,
        brief: Brief,
        log: EvolutionLog,
        keep: Keep,
        marks: Iterable[Mark] = (),
        *,
        seed: int = 0,
        mix: ScreenMix | None = None,
        breeding: BreedingPlan | None = None,
    ) -> None:
        self.brief, self.seed, self._keep, self._log = brief, seed, keep, log
        self.plan = domains.plan_of(brief)
        self.reasons = domains.reasons_of(brief.domain)
        self._mix, self._breeding = mix or ScreenMix(), breeding or BreedingPlan()
        self._lock, self._begun = RLock(), RLock()
        self._archive = CandidateArchive(log, self._breeding.first)
        self._batches = len(log.entries())
        self._nursery = Nursery(brief, self.plan, seed, lambda _epoch: brief)
        self._names: tuple[str, ...] = ()
        self._histories: dict[str, History] = {}
        self._turns: dict[str, RLock] = {}
        self._tastes: dict[str, tuple[tuple[Event, ...], PersonTaste]] = {}
        self._asking, self._adopting = BoundedSemaphore(AT_ONCE), False
        for mark in marks:
            self._histories[mark.rater] = self._of(mark.rater).after(mark.kind, mark.body)

    def ask(
        self, rater: str, progress: OnProgress | None = None, cancel: OnCancel | None = None
    ) -> Screen:
        """The next sheet of a rater. The first of all waits until the pool is bred."""
        self.prepare(progress, cancel)
        self._adopt()
        with self._turn(rater):
            history = self._of(rater)
            with self._asking:
                taste = self._taste(rater, history)
                candidates = self._choose(rater, history, taste)
            shown = [one.number for one in candidates]
            predicted = [one.predicted for one in candidates]
            wide = self._mix.wide(taste.statements)
            number = len(history.screens)
            body = {"screen": number, "shown": shown, "predicted": predicted, "wide": wide}
            self._add(rater, "screen", body)
            self._breed_for(rater, taste)
            return self._screen_of(rater, candidates)

    def _choose(self, rater: str, history: History, taste: PersonTaste) -> list[ShownCandidate]:
        rng = np.random.default_rng([self.seed, len(history.screens), *rater.encode()[:64]])
        with self._lock:
            shown = choose_candidates(self._archive, history, taste, "", rng, self._mix)
            shown += self._seen_best(shown, taste)
        return self._predict(shown, taste)

    def tell(self, rater: str, *events: Event) -> None:
        """Hear what a rater says; it is kept when this returns. InputError, and nothing is kept,
        for what cannot be meant."""
        with self._turn(rater):
            for event in events:
                if isinstance(event, Lock | Edit):
                    raise InputError("the pool is the same for all raters", "rate what is shown")
                check_said(event, self._of(rater).shown, self.reasons)
            for event in events:
                self._add(rater, "event", record_of(event))

    def undo(self, rater: str) -> None:
        """Take back what a rater said last, if anything."""
        if counting(self._of(rater).events):
            self.tell(rater, Undo())

    def screen(self, rater: str) -> Screen | None:
        """The sheet a rater was shown last, with what is predicted now; none before the first."""
        history = self._of(rater)
        if not history.screens:
            return None
        taste = self._taste(rater, history)
        return self._screen_of(rater, self._predict(history.screens[-1].shown, taste))

    def history(self, rater: str) -> History:
        """All that a rater was shown and said."""
        return self._of(rater)

    def raters(self) -> dict[str, int]:
        """How many statements of each rater count."""
        return {name: len(counting(one.events)) for name, one in self._histories.items()}

    def liked(self) -> list[Liked]:
        """What all raters said together, the most liked first: by picks less worsts, then stars."""
        best: Counter[int] = Counter()
        worst: Counter[int] = Counter()
        stars: dict[int, list[int]] = {}
        for history in [*self._histories.values()]:
            for event in counting(history.events):
                match event:
                    case Pick(one, _):
                        best[one] += 1
                    case Worst(one, _):
                        worst[one] += 1
                    case Stars(one, count, _):
                        stars.setdefault(one, []).append(count)
        found = [
            Liked(n, best[n], worst[n], float(np.mean(stars[n])) if n in stars else None)
            for n in {*best, *worst, *stars}
        ]
        return sorted(
            found, key=lambda one: (one.worst - one.best, -(one.stars or 3.0), one.number)
        )

    def candidate(self, number: int) -> ShownCandidate:
        """A candidate of the pool. InputError for one there is not."""
        return ShownCandidate(number, self.solution_of(number), self.plan)

    def solution_of(self, number: int) -> Solution:
        """The solution of a candidate."""
        return self._archive.solution(
            number, lambda n: self._breeder().develop(self._archive.bred[n].genome)
        )

    def is_ready(self) -> bool:
        """Whether there are candidates to show."""
        return bool(self._archive.bred)

    def size(self) -> int:
        """How many candidates there are."""
        return len(self._archive.bred)

    def close(self) -> None:
        """Stop breeding and close the log."""
        self._nursery.close()
        self._log.close()

    def _breeder(self) -> Any:
        return self._nursery.ground("").breeder

    def _of(self, rater: str) -> History:
        return self._histories.get(rater, History())

    def _turn(self, rater: str) -> RLock:
        with self._lock:
            return self._turns.setdefault(rater, RLock())

    def _add(self, rater: str, kind: str, body: dict[str, Any]) -> None:
        self._keep(rater, kind, body)
        self._histories[rater] = self._of(rater).after(kind, body)

    def _screen_of(self, rater: str, candidates: Sequence[ShownCandidate]) -> Screen:
        history = self._of(rater)
        champion = champion_of(history.events)
        return Screen(len(history.screens) - 1, tuple(candidates), champion, history.trust)

    def _predict(self, numbers: Sequence[int], taste: PersonTaste) -> list[ShownCandidate]:
        solutions = [self.solution_of(number) for number in numbers]
        plans: list[Plan] = [self.plan] * len(numbers)
        return predict_candidates(self._archive, numbers, solutions, plans, taste)

    def _seen_best(self, shown: Sequence[int], taste: PersonTaste) -> list[int]:
        """What fills a sheet when little of the pool is new to a rater: the best of the rest."""
        rest = [number for number in self._archive.sane("") if number not in shown]
        lacking = self._mix.size - len(shown)
        if not rest or lacking <= 0:
            return []
        mean, _ = judge_each(taste, np.array([self._archive.bred[n].values for n in rest]))
        return [rest[k] for k in np.argsort(-mean, kind="stable")[:lacking].tolist()]

    def _taste(self, rater: str, history: History) -> PersonTaste:
        events, taste = self._tastes.get(rater, ((), None))
        if taste is not None and events == history.events:
            return taste
        with self._lock:
            values = self._archive.values()
            if not self._names:
                self._names = tuple(domains.features_of(self.solution_of(0), self.plan))
                self._archive.check_features(len(self._names))
            scale = self._archive.scale(self._names)
        learned = learn_taste(scale, history.events, values, self.reasons)
        self._tastes[rater] = history.events, learned
        return learned

    def prepare(self, progress: OnProgress | None = None, cancel: OnCancel | None = None) -> None:
        """Breed the first candidates, once; whoever comes meanwhile waits for them."""
        with self._begun:
            if self._archive.bred:
                return
            self._nursery.begin("", 0, self._choosing(np.random.default_rng([self.seed, 2])))
            self._take_in(self._nursery.collect(progress, cancel))

    def _take_in(self, found: Sequence[Any]) -> None:
        with self._lock:
            numbers = self._archive.add(found, "")
            unwritten = self._archive.unwritten(numbers)
            self._log.append(self._batches, "auto", {"screen": self._batches}, unwritten)
            self._batches += 1

    def _adopt(self) -> None:
        """Take in what was bred meanwhile, if it is ready; whoever asks does not wait for it."""
        with self._lock:
            batches = self._nursery.batches
            if self._adopting or not batches or not self._nursery.ready():
                return
            self._adopting = True
        Thread(target=self._take_bred, daemon=True).start()

    def _take_bred(self) -> None:
        try:
            self._take_in(self._nursery.collect(None, None))
        finally:
            self._adopting = False

    def _breed_for(self, rater: str, taste: PersonTaste) -> None:
        """Breed more for a rater who has seen much of the pool, unless something is being bred."""
        with self._lock:
            seen = len(self._of(rater).shown)
            full = len(self._archive.bred) >= AHEAD and seen < SEEN * len(self._archive.bred)
            if self._nursery.batches or self._adopting or full:
                return
            rng = np.random.default_rng([self.seed, 3, self._batches])
            self._nursery.begin("", self._batches, self._choosing(rng, taste))

    def _choosing(self, rng: np.random.Generator, taste: PersonTaste | None = None) -> Choose:
        """How the next genomes are chosen: for one taste, the first by chance."""
        rows, age, breeder = [*self._archive.bred.values()], self._batches, self._breeder()
        how = fit_breeding(self._breeding, breeder)
        wide = self._mix.wide(taste.statements) if taste is not None else 0
        return lambda coming: choose_genomes(breeder, taste, rows, coming, age, rng, how, wide)
