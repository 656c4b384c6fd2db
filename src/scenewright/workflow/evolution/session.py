"""An evolution: candidates are shown, a person says what she thinks of them, better ones come.

:meth:`Evolution.ask` gives the next screen, :meth:`Evolution.tell` takes what was said. While she
looks, the next candidates are bred: half on what was known when the screen was chosen, half on her
first mark, from then on. So the next screen is there at once, and the same log and seed give the
same screens however fast she is.
"""

from __future__ import annotations

from collections.abc import Sequence
from types import TracebackType
from typing import Any

import numpy as np

from scenewright import domains
from scenewright.core.breeding import BreedingStage, Genome
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.engine.preference.events import (
    Edit,
    Event,
    Lock,
    Undo,
    champion_of,
    counting,
    record_of,
)
from scenewright.engine.preference.screens import ScreenMix
from scenewright.engine.preference.taste import (
    FeatureScale,
    PersonTaste,
    judge_each,
    learn_taste,
    start_from,
)
from scenewright.engine.preference.trust import TrustRecord
from scenewright.workflow.evolution.archive import CandidateArchive
from scenewright.workflow.evolution.by_method import MethodRun, best_rated, make_run, refuse
from scenewright.workflow.evolution.candidate import Screen, ShownCandidate
from scenewright.workflow.evolution.choosing import choose_candidates, predict_candidates
from scenewright.workflow.evolution.history import read_history
from scenewright.workflow.evolution.locking import lock_brief, name_epoch
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.log_records import check_genome
from scenewright.workflow.evolution.nursery import Choose, Nursery, OnCancel, OnProgress
from scenewright.workflow.evolution.population import (
    BreedingPlan,
    choose_genomes,
    fit_breeding,
    measure_solution,
)
from scenewright.workflow.evolution.statement_checks import check_said


class Evolution:
    """One person's evolution of one brief, kept in a log that survives whatever ends the run.

    Use it in a ``with`` block, or :meth:`close` it.
    """

    def __init__(
        self,
        brief: Brief,
        log: EvolutionLog,
        *,
        seed: int = 0,
        start: Sequence[PersonTaste] = (),
        mix: ScreenMix | None = None,
        breeding: BreedingPlan | None = None,
        method: str = "",
    ) -> None:
        self.brief, self.log, self.seed = brief, log, seed
        self.plan = domains.plan_of(brief)
        self.reasons = domains.reasons_of(brief.domain)
        self._mix, self._breeding = mix or ScreenMix(), breeding or BreedingPlan()
        self._others = tuple(start)
        self._names: tuple[str, ...] = ()
        self._learned: tuple[tuple[Event, ...], PersonTaste] | None = None
        self._archive = CandidateArchive(log, self._breeding.first)
        self._history = read_history(log.entries(), len(self._archive.bred))
        self._run = make_run(method, brief, self.plan, seed) if method else None
        self._nursery = Nursery(
            brief,
            self.plan,
            seed,
            lambda epoch: lock_brief(epoch, self.solution_of),
            self._run.matrix.breeder if self._run else None,
        )

    def __enter__(self) -> Evolution:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Stop breeding and close the log."""
        self._nursery.close()
        self.log.close()

    @property
    def events(self) -> tuple[Event, ...]:
        """All that was said and still counts, in order."""
        return counting(self._history.events)

    @property
    def said_of_screen(self) -> tuple[Event, ...]:
        """What was said since the last screen was shown, and still counts."""
        screens = self._history.screens
        return counting(self._history.events[screens[-1].before if screens else 0 :])

    @property
    def trust(self) -> TrustRecord:
        """How often the predicted top held the person's pick, on screens not learned from."""
        return self._history.trust

    @property
    def champion(self) -> ShownCandidate | None:
        """What the person has chosen so far; only what she says changes it."""
        number = self._champion()
        return None if number is None else self._show([number])[0]

    def _champion(self) -> int | None:
        events = self._history.events
        return champion_of(events) if self._run is None else best_rated(events)

    @property
    def method(self) -> str:
        """The method it is evolved by; empty: ours."""
        return self._run.method.name if self._run else ""

    @property
    def stages(self) -> tuple[BreedingStage, ...]:
        """What a method did before its first sheet, where it begins with more than chance."""
        led = self._run is not None and self._run.method.led
        return self._run.matrix.stages() if self._run is not None and led else ()

    @property
    def notes(self) -> tuple[str, ...]:
        """What a method tells of the sheet shown last: what it estimated, and whether its network
        was trusted to rate."""
        sheets = len(self._history.screens) - 1
        if self._run is None or sheets < 0:
            return ()
        return self._run.crowd(self._history, self._archive.bred, sheets).notes

    @property
    def screen(self) -> Screen | None:
        """The screen shown last, with what is predicted now; none before the first."""
        screens = self._history.screens
        if not screens:
            return None
        shown = self._show(screens[-1].shown)
        champion = self._champion()
        return Screen(len(screens) - 1, tuple(shown), champion, self.trust)

    @property
    def taste(self) -> PersonTaste:
        """The taste learned so far."""
        return self._learn(self.events)

    def ready(self) -> bool:
        """Whether the next screen can be shown at once."""
        return bool(self._nursery.batches) and self._nursery.ready()

    def breed_ahead(self) -> None:
        """Begin to breed for the next screen, as is done once one is shown; for resumed ones."""
        if self._run is None:
            self._begin(name_epoch(self.events), len(self._history.screens))

    def busy(self) -> bool:
        """Whether candidates are being bred now."""
        return not self._nursery.ready()

    def bred_so_far(self) -> list[Solution]:
        """The valid candidates bred so far for the next screen. Looking changes nothing."""
        return [solution for _, (bred, solution) in self._nursery.peek() if bred.valid]

    def coming(self) -> list[ShownCandidate]:
        """The valid candidates bred so far for the next screen, under the numbers they will have
        unless one is changed by hand before. Looking changes nothing."""
        before, batches = len(self._archive.bred), self._nursery.batches
        plan = self._nursery.ground(batches[0].epoch if batches else "").plan
        found = [(before + place, one[1]) for place, one in self._nursery.peek() if one[0].valid]
        return [ShownCandidate(number, solution, plan) for number, solution in found]

    def size(self) -> int:
        """How many candidates there are."""
        return len(self._archive.bred)

    @property
    def sheets(self) -> tuple[tuple[int, ...], ...]:
        """The numbers of the candidates of every screen, in their places."""
        return tuple(screen.shown for screen in self._history.screens)

    def candidate(self, number: int) -> ShownCandidate | None:
        """A candidate that was shown, with what is predicted of it now."""
        return self._show([number])[0] if number in self._history.shown else None

    def best_so_far(self) -> ShownCandidate | None:
        """The predicted best of the candidates that are bred so far for the next screen, under the
        number it will have; none while there is nothing to tell. Looking changes nothing."""
        if self._run is not None:
            return None
        batches, taste = self._nursery.batches, self.taste
        known = taste.posterior is not None or bool(taste.start.any())
        found = [(place, *one) for place, one in self._nursery.peek() if one[0].valid]
        if not batches or not found or not known:
            return None
        mean, deviation = judge_each(taste, np.array([bred.values for _, bred, _ in found]))
        best = int(np.argmax(mean))
        number, ground = len(self._archive.bred) + found[best][0], batches[0].epoch
        predicted = float(mean[best]), float(deviation[best])
        return ShownCandidate(number, found[best][2], self._nursery.ground(ground).plan, *predicted)

    def ask(self, progress: OnProgress | None = None, cancel: OnCancel | None = None) -> Screen:
        """The next screen: the champion, favourites, the predicted best, draws and the farthest.
        ``progress`` gets the share bred and what is done, where the screen has to wait for it;
        ``cancel`` ends the waiting (:class:`CancelledError`): nothing is shown or kept then."""
        epoch, number = name_epoch(self.events), len(self._history.screens)
        if self._run is not None:
            return self._ask_by_method(self._run, number, progress, cancel)
        self._adopt(epoch, number, progress, cancel)
        taste = self.taste
        shown = self._choose(taste, epoch, number)
        candidates = self._show(shown, taste)
        predicted = [one.predicted for one in candidates]
        wide = self._mix.wide(taste.statements)
        body = {"screen": number, "shown": shown, "predicted": predicted, "wide": wide}
        self._append("screen", body, shown)
        self._breed(epoch, number + 1, taste)
        return Screen(number, tuple(candidates), champion_of(self._history.events), self.trust)

    def _ask_by_method(
        self, run: MethodRun, number: int, progress: OnProgress | None, cancel: OnCancel | None
    ) -> Screen:
        """The next sheet of a method: what it asks of, developed now."""
        crowd = run.crowd(self._history, self._archive.bred, number)
        self._nursery.begin("", number, lambda _coming: list(crowd.asked))
        shown = self._archive.add(self._nursery.collect(progress, cancel), "")
        body = {"screen": number, "shown": shown, "predicted": [None] * len(shown), "wide": 0}
        self._append("screen", body, shown)
        return Screen(number, tuple(self._show(shown)), self._champion(), self.trust)

    def tell(self, *events: Event) -> None:
        """Hear what was said; it is on disk when this returns. Raises :class:`InputError`, and
        keeps nothing, for what cannot be meant."""
        for k, event in enumerate(events):
            check_said(event, self._history.shown, self.reasons)
            if self._run is not None:
                refuse(event)
            if isinstance(event, Lock):
                self._check_lock(event.name, champion_of((*self._history.events, *events[:k])))
        for event in events:
            self._append("event", record_of(event))
        if self._run is None and self._history.before_mark() is not None:
            self._breed_on_mark(name_epoch(self.events))

    def undo(self) -> Event | None:
        """Take back what was said last; what it was, if anything."""
        events = self.events
        if events:
            self.tell(Undo())
        return events[-1] if events else None

    def edit(self, number: int, **edits: Any) -> ShownCandidate:
        """Change a candidate by hand, as :func:`scenewright.domains.adjust` does: the answer is a
        new candidate that is better than it was."""
        if self._run is not None:
            refuse("move")
        check_said(Edit(number, number), self._history.shown, ())
        solution = domains.adjust(self.solution_of(number), **edits).solution
        plan = domains.plan_of(solution.brief)
        (made,) = self._archive.add(
            [(measure_solution(solution, plan), solution)], name_epoch(self.events)
        )
        self._append("event", record_of(Edit(number, made)), [made])
        return self._show([made])[0]

    def rate_itself(self, rounds: int, progress: OnProgress | None = None) -> int:
        """Breed on for ``rounds`` rounds without asking, the model rating in the person's place;
        only where it may be trusted. Nothing is learned from that and the champion stays; the next
        screen is the person's again. How many candidates were bred."""
        if self._run is not None:
            refuse("auto")
        if not self.trust.enough:
            raise InputError(f"predictions are not good enough yet: {self.trust}", "go on picking")
        before, epoch = len(self._archive.bred), name_epoch(self.events)
        for _ in range(rounds):
            number = len(self._history.screens)
            self._adopt(epoch, number, progress)
            self._append("auto", {"screen": number})
            self._breed(epoch, number, self.taste)
        return len(self._archive.bred) - before

    def solution_of(self, number: int) -> Solution:
        """The solution of a candidate."""
        return self._archive.solution(number, self._develop)

    def _develop(self, number: int) -> Solution:
        ground = self._nursery.ground(self._archive.epochs[number])
        genome = self._archive.bred[number].genome
        check_genome(genome, ground.breeder.genes)
        return ground.breeder.develop(genome)

    def _choose(self, taste: PersonTaste, epoch: str, screen: int) -> list[int]:
        """The numbers of the candidates of a screen."""
        rng = np.random.default_rng([self.seed, 1, screen])
        return choose_candidates(self._archive, self._history, taste, epoch, rng, self._mix)

    def _adopt(
        self, epoch: str, screen: int, progress: OnProgress | None, cancel: OnCancel | None = None
    ) -> None:
        """Take in what was bred for a screen, breeding it now if nobody has."""
        self._begin(epoch, screen)
        self._breed_on_mark(epoch)
        self._archive.add(self._nursery.collect(progress, cancel), epoch)

    def _begin(self, epoch: str, screen: int) -> None:
        """Begin to breed for a screen, unless that was begun."""
        if not self._nursery.count(epoch, screen):
            before = self._history.before_screen(screen - 1)
            known = self._archive.of_epoch(epoch)
            self._breed(epoch, screen, self._learn(counting(before)) if known else None)

    def _breed(self, epoch: str, screen: int, taste: PersonTaste | None) -> None:
        """Begin to breed for a screen, on what was known when the one before was chosen."""
        self._nursery.begin(epoch, screen, self._choosing(epoch, screen, taste, 0))

    def _breed_on_mark(self, epoch: str) -> None:
        """Breed the second half for the next screen, if only the first is: on all that was said
        up to the first mark of the screen shown."""
        screen = len(self._history.screens)
        if self._nursery.count(epoch, screen) == 1 and self._archive.of_epoch(epoch):
            said = self._history.events[: self._history.before_mark()]
            taste = self._learn(counting(said))
            self._nursery.add(self._choosing(epoch, screen, taste, 1))

    def _choosing(self, epoch: str, screen: int, taste: PersonTaste | None, part: int) -> Choose:
        """How the genomes of a half are chosen, once those of the other are."""
        rows = [self._archive.bred[n] for n in self._archive.of_epoch(epoch)]
        autos = self._history.autos
        rng = np.random.default_rng([self.seed, 2 + part, screen, autos, epoch.count(":")])
        breeder = self._nursery.ground(epoch).breeder
        how = fit_breeding(self._breeding, breeder, part)
        for one in rows:
            if one.genome:
                check_genome(one.genome, breeder.genes)
        wide = self._mix.wide(taste.statements) if taste is not None and part == 0 else 0

        def choose(coming: list[Genome]) -> list[Genome]:
            age = screen + autos
            return choose_genomes(breeder, taste, rows, coming, age, rng, how, wide)

        return choose

    def _learn(self, events: Sequence[Event]) -> PersonTaste:
        if not self._archive.bred:
            return PersonTaste(FeatureScale((), np.zeros(0), np.ones(0)), None, np.zeros(0))
        if self._learned is not None and self._learned[0] == events:
            return self._learned[1]
        if not self._names:
            self._names = tuple(domains.features_of(self.solution_of(0), self.plan))
            self._archive.check_features(len(self._names))
        start = start_from(self._others, self._names) if self._others else None
        scale = self._archive.scale(self._names)
        taste = learn_taste(scale, events, self._archive.values(), self.reasons, start)
        self._learned = tuple(events), taste
        return taste

    def _show(
        self, numbers: Sequence[int], taste: PersonTaste | None = None
    ) -> list[ShownCandidate]:
        """Candidates with what is predicted of them, if anything is."""
        if self._run is not None:
            ground = self._nursery.ground("").plan
            valid = {n: self._archive.bred[n].valid for n in numbers}
            return [ShownCandidate(n, self.solution_of(n), ground, valid=valid[n]) for n in numbers]
        grounds = [self._nursery.ground(self._archive.epochs[n]).plan for n in numbers]
        solutions = [self.solution_of(number) for number in numbers]
        return predict_candidates(self._archive, numbers, solutions, grounds, taste or self.taste)

    def _check_lock(self, name: str, champion: int | None) -> None:
        """InputError unless the champion has what is to be locked."""
        if champion is None:
            raise InputError("there is no champion yet to lock anything in", "pick one first")
        domains.adjust(self.solution_of(champion), lock=[name])

    def _append(self, kind: str, body: dict[str, Any], shown: Sequence[int] = ()) -> None:
        self.log.append(self._history.entries, kind, body, self._archive.unwritten(shown))
        self._history = self._history.after(kind, body)
