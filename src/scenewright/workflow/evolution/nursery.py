"""Where candidates are bred while the person looks: threads, and what they breed on."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from typing import NamedTuple

from scenewright import domains
from scenewright.core.breeding import Breeder, Genome
from scenewright.core.brief import Brief
from scenewright.core.errors import CancelledError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.workflow.evolution.population import BredLayout, BreedingGround, develop_all

OnProgress = Callable[[float, str], None]
OnCancel = Callable[[], bool]
Developed = tuple[BredLayout, Solution]
WORKERS = 2
"""Threads that breed."""
PARTS = 24
"""Parts that a batch is developed in: what one holds can be looked at before the next is made."""
PATIENCE = 0.05
"""Seconds after which whoever waits for a part is told again, and may give up."""


class Batch(NamedTuple):
    """Candidates being bred for a ``screen`` of an ``epoch``: the ``genomes`` once they are
    chosen, and what they develop into, in order."""

    epoch: str
    screen: int
    genomes: Future[list[Genome]]
    parts: tuple[Future[list[Developed]], ...]

    def ready(self) -> bool:
        """Whether all are bred."""
        return all(part.done() for part in self.parts)

    def size(self) -> int:
        """How many candidates it has; 0 while they are being chosen."""
        return len(self.genomes.result()) if self.genomes.done() else 0


class Nursery:
    """Breeds one batch at a time in the background. ``locked`` gives the brief of an epoch;
    ``breeder`` is what it breeds by (that of the domain, if left out)."""

    def __init__(
        self,
        brief: Brief,
        plan: Plan,
        seed: int,
        locked: Callable[[str], Brief],
        breeder: Breeder | None = None,
    ) -> None:
        self._brief, self._plan, self._seed, self._locked = brief, plan, seed, locked
        self._breeder = breeder
        self._pool = ThreadPoolExecutor(WORKERS, thread_name_prefix="breeding")
        self._grounds: dict[str, BreedingGround] = {}
        self.batch: Batch | None = None

    def ground(self, epoch: str) -> BreedingGround:
        """The values an epoch's candidates are bred on."""
        if epoch not in self._grounds:
            brief = self._locked(epoch) if epoch else self._brief
            plan = domains.plan_of(brief) if epoch else self._plan
            breeder = self._breeder or domains.breeder_of(brief, plan, self._seed)
            self._grounds[epoch] = BreedingGround(plan, breeder)
        return self._grounds[epoch]

    def begin(self, epoch: str, screen: int, choose: Callable[[], list[Genome]]) -> None:
        """Begin to breed the genomes that ``choose`` gives; what was being bred is given up."""
        self.give_up()
        ground = self.ground(epoch)
        genomes = self._pool.submit(choose)
        parts = tuple(
            self._pool.submit(_develop_part, ground, genomes, part) for part in range(PARTS)
        )
        self.batch = Batch(epoch, screen, genomes, parts)

    def is_breeding(self, epoch: str, screen: int) -> bool:
        """Whether the batch is for this screen of this epoch."""
        return self.batch is not None and self.batch[:2] == (epoch, screen)

    def peek(self) -> list[tuple[int, Developed]]:
        """The candidates of the batch bred so far, each with its place in it."""
        found, parts = [], self.batch.parts if self.batch else ()
        done = [k for k, part in enumerate(parts) if part.done() and not part.cancelled()]
        for k in done:
            count = self.batch.size() if self.batch else 0
            first = count * k // len(parts)
            found += [(first + n, one) for n, one in enumerate(parts[k].result())]
        return found

    def collect(self, progress: OnProgress | None, cancel: OnCancel | None) -> list[Developed]:
        """What was bred, when all is; ``progress`` gets how much is. Once ``cancel`` says so
        the batch is given up: :class:`CancelledError`."""
        found: list[Developed] = []
        parts = self.batch.parts if self.batch else ()
        for k, part in enumerate(parts):
            while not part.done():
                if progress is not None:
                    progress(k / len(parts), "breeding candidates")
                if cancel is not None and cancel():
                    self.give_up()
                    raise CancelledError("cancelled while breeding")
                wait([part], PATIENCE)
            found += part.result()
        self.batch = None
        return found

    def give_up(self) -> None:
        """Breed no more of what was begun."""
        for part in self.batch.parts if self.batch else ():
            part.cancel()
        self.batch = None

    def close(self) -> None:
        """Let the threads go when they have done what they are at."""
        self._pool.shutdown(wait=False, cancel_futures=True)


def _develop_part(
    ground: BreedingGround, genomes: Future[list[Genome]], part: int
) -> list[Developed]:
    """One of :data:`PARTS` equal parts of the genomes, developed when they are chosen."""
    chosen = genomes.result()
    first, last = (len(chosen) * k // PARTS for k in (part, part + 1))
    return develop_all(ground, chosen[first:last])
