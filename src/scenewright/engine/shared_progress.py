"""Progress of a run that is made of parts, some of them side by side: one share that only rises."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from threading import Lock

from scenewright.engine.solve import Progress, Report

STEP = 0.002
"""How much a share must have risen to be reported again."""


class SharedProgress:
    """Brings the reports of several parts, of some ``work`` each, to one ``progress`` of share and
    name.

    A part may run solvers one after another without knowing how many there will be: the first
    takes half of it, the next half of the rest, and so on, until the part has :meth:`ended`.

    >>> reported = []
    >>> both = SharedProgress(lambda share, name: reported.append((share, name)), [1.0, 3.0])
    >>> both.part(1, "hall")(Report(1.0, 0.0, tuple))
    >>> both.part(0, "bath")(Report(0.5, 0.0, tuple))
    >>> both.ended(1, "hall")
    >>> reported
    [(0.375, 'hall'), (0.4375, 'bath'), (0.8125, 'hall')]
    """

    def __init__(self, progress: Callable[[float, str], None], work: Sequence[float]) -> None:
        whole = sum(work) or 1.0
        self.progress, self.work = progress, [part / whole for part in work]
        self.begun, self.last = [0.0 for _ in work], [0.0 for _ in work]
        self.reported, self.lock = 0.0, Lock()

    def part(self, number: int, name: str) -> Progress:
        """The listener to the solvers of a part."""

        def pass_on(report: Report) -> None:
            self.hear(number, report.share, name)

        return pass_on

    def hear(self, number: int, share: float, name: str) -> None:
        """A part has done a share of its present run."""
        with self.lock:
            if share < self.last[number]:
                self.begun[number] = 0.5 * (1.0 + self.begun[number])
            self.last[number] = share
            self._tell(name, STEP)

    def ended(self, number: int, name: str) -> None:
        """All of a part is done."""
        with self.lock:
            self.begun[number] = 1.0
            self._tell(name, 0.0)

    def _tell(self, name: str, step: float) -> None:
        """Tell the share of all that is done: of each part, what was before its present run and
        half of what is left times the share of that run."""
        done = [
            begun + 0.5 * (1.0 - begun) * last
            for begun, last in zip(self.begun, self.last, strict=True)
        ]
        share = min(sum(w * d for w, d in zip(self.work, done, strict=True)), 1.0)
        share = 1.0 if min(done, default=0.0) >= 1.0 else share  # whatever the shares add up to
        if share >= self.reported + step:
            self.reported = share
            self.progress(share, name)
