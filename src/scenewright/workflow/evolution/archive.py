"""All candidates of an evolution by number, and what is known of each."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.core.stored_file import report_damage
from scenewright.engine.preference.taste import FeatureScale, Floats, measure_scale
from scenewright.formats import solution_json
from scenewright.workflow.evolution.log import EvolutionLog, NewCandidates
from scenewright.workflow.evolution.log_records import check_epochs
from scenewright.workflow.evolution.population import BredLayout, bred_of, is_sane


class CandidateArchive:
    """Candidates by number, each of an epoch: what held (the locks) when it was bred.

    Features of all are measured by the scale of the first ``scaled``, for good.
    """

    def __init__(self, log: EvolutionLog, scaled: int) -> None:
        self._log, self._scaled = log, scaled
        self.bred: dict[int, BredLayout] = {}
        self.epochs: dict[int, str] = {}
        self._solutions: dict[int, Solution] = {}
        self._unwritten: list[int] = []
        self._documents: set[int] = set()
        for number, epoch, body in log.read_candidates():
            self.bred[number], self.epochs[number] = bred_of(body), epoch
        check_epochs(set(self.epochs.values()), len(self.bred))
        if self.bred:
            self.check_features(len(self.bred[0].values))

    def check_features(self, count: int) -> None:
        """InputError unless every candidate has ``count`` features."""
        if any(len(one.values) != count for one in self.bred.values()):
            raise InputError(
                "is damaged, or of another version: features do not fit", "start a new one"
            )

    def add(self, found: Sequence[tuple[BredLayout, Solution]], epoch: str) -> list[int]:
        """Number candidates; their numbers. They are written down with the next entry."""
        numbers = [len(self.bred) + k for k in range(len(found))]
        for number, (bred, solution) in zip(numbers, found, strict=True):
            self.bred[number], self.epochs[number] = bred, epoch
            self._solutions[number] = solution
        self._unwritten += numbers
        return numbers

    def unwritten(self, shown: Sequence[int]) -> NewCandidates:
        """What is to be written down with the next entry: candidates that are new, and the whole
        solutions of those ``shown``."""
        rows = [(n, self.epochs[n], self.bred[n].record()) for n in self._unwritten]
        self._unwritten = []
        new = [n for n in shown if n in self._solutions and n not in self._documents]
        self._documents |= set(new)
        documents = [(n, solution_json.dumps(self._solutions[n])) for n in new]
        return NewCandidates(tuple(rows), tuple(documents))

    def solution(self, number: int, develop: Callable[[int], Solution]) -> Solution:
        """The solution of a candidate: at hand, written down, or developed again."""
        if number not in self.bred:
            raise InputError(f"there is no candidate {number}", "name one that was shown")
        if number not in self._solutions:
            document = self._log.solution(number)
            self._solutions[number] = develop(number) if document is None else self._read(document)
        return self._solutions[number]

    def _read(self, document: str) -> Solution:
        """The solution written down, of the same kind of scene as the others."""
        with report_damage(self._log.path, "the log of an evolution", "start a new one"):
            return solution_json.loads(document)

    def of_epoch(self, epoch: str) -> list[int]:
        """The candidates bred in an epoch, in order."""
        return [number for number in self.bred if self.epochs[number] == epoch]

    def sane(self, epoch: str) -> list[int]:
        """Those of an epoch that may be shown: no rule broken, and nothing lacking that others
        have; all, where none is so good."""
        numbers = self.of_epoch(epoch)
        least = min((self.bred[n].lacking for n in numbers if self.bred[n].valid), default=0)
        return [n for n in numbers if is_sane(self.bred[n], least)] or numbers

    def values(self) -> dict[int, Floats]:
        """The features (D,) of every candidate."""
        return {number: one.values for number, one in self.bred.items()}

    def scale(self, names: Sequence[str]) -> FeatureScale:
        """How features vary over the first sane candidates."""
        first = [self.bred[number] for number in sorted(self.bred)[: self._scaled]]
        rows = [one.values for one in first if one.valid] or [one.values for one in first]
        return measure_scale(names, np.array(rows))
