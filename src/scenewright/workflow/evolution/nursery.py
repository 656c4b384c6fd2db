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
from scenewright.workflow.evolution.population import BredLayout, BreedingGround, develop

OnProgress = Callable[[float, str], None]
OnCancel = Callable[[], bool]
Choose = Callable[[list[Genome]], list[Genome]]
"""Chooses what is bred, beside the genomes that are being bred for the same screen."""
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
    """Breeds for one screen at a time in the background, one batch after the other. ``locked``
    gives the brief of an epoch; ``breeder`` is what it breeds by (that of the domain, if left
    out)."""

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
        self._made: dict[tuple[str, Genome], Developed] = {}
        self.batches: tuple[Batch, ...] = ()

    def ground(self, epoch: str) -> BreedingGround:
        """The values an epoch's candidates are bred on."""
        if epoch not in self._grounds:
            brief = self._locked(epoch) if epoch else self._brief
            plan = domains.plan_of(brief) if epoch else self._plan
            breeder = self._breeder or domains.breeder_of(brief, plan, self._seed)
            self._grounds[epoch] = BreedingGround(plan, breeder)
        return self._grounds[epoch]

    def begin(self, epoch: str, screen: int, choose: Choose) -> None:
        """Begin to breed the genomes that ``choose`` gives; what was being bred is given up."""
        self.give_up()
        self._submit(epoch, screen, choose)

    def add(self, choose: Choose) -> None:
        """Breed more for the same screen, after what is being bred."""
        self._submit(*self.batches[0][:2], choose)

    def count(self, epoch: str, screen: int) -> int:
        """How many batches are being bred for this screen of this epoch."""
        return sum(batch[:2] == (epoch, screen) for batch in self.batches)

    def ready(self) -> bool:
        """Whether all that was begun is bred."""
        return all(batch.ready() for batch in self.batches)

    def peek(self) -> list[tuple[int, Developed]]:
        """The candidates bred so far, each with its place among all that will be."""
        found, before = list[tuple[int, Developed]](), 0
        for batch in self.batches:
            count = batch.size()
            done = [k for k, part in enumerate(batch.parts) if part.done() and not part.cancelled()]
            for k in done:
                first = before + count * k // PARTS
                found += [(first + n, one) for n, one in enumerate(batch.parts[k].result())]
            before += count
        return found

    def collect(self, progress: OnProgress | None, cancel: OnCancel | None) -> list[Developed]:
        """What was bred, when all is; ``progress`` gets how much is. Once ``cancel`` says so
        it is given up: :class:`CancelledError`; what is developed by then is not made again."""
        found: list[Developed] = []
        parts = [part for batch in self.batches for part in batch.parts]
        for k, part in enumerate(parts):
            while not part.done():
                if progress is not None:
                    progress(k / len(parts), "breeding candidates")
                if cancel is not None and cancel():
                    self.give_up()
                    raise CancelledError("cancelled while breeding")
                wait([part], PATIENCE)
            found += part.result()
        self.batches = ()
        self._made.clear()
        return found

    def give_up(self) -> None:
        """Breed no more of what was begun."""
        for batch in self.batches:
            batch.genomes.cancel()
            for part in batch.parts:
                part.cancel()
        self.batches = ()

    def close(self) -> None:
        """Let the threads go when they have done what they are at."""
        self._pool.shutdown(wait=False, cancel_futures=True)

    def _submit(self, epoch: str, screen: int, choose: Choose) -> None:
        ground, before = self.ground(epoch), [batch.genomes for batch in self.batches]
        genomes = self._pool.submit(lambda: choose([g for one in before for g in one.result()]))
        parts = tuple(
            self._pool.submit(self._develop_part, epoch, ground, genomes, part)
            for part in range(PARTS)
        )
        self.batches = (*self.batches, Batch(epoch, screen, genomes, parts))

    def _develop_part(
        self, epoch: str, ground: BreedingGround, genomes: Future[list[Genome]], part: int
    ) -> list[Developed]:
        """One of :data:`PARTS` equal parts of the genomes, developed when they are chosen."""
        chosen = genomes.result()
        first, last = (len(chosen) * k // PARTS for k in (part, part + 1))
        for genome in chosen[first:last]:
            if (epoch, genome) not in self._made:
                self._made[epoch, genome] = develop(ground, genome)
        return [self._made[epoch, genome] for genome in chosen[first:last]]
