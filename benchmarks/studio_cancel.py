"""How soon work ends that nobody waits for any more, at moments spread over the whole of it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Event, Thread
from typing import Any, NamedTuple

from scenewright.core.errors import CancelledError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains import adjust, check, plan_of, solve
from scenewright.formats import read
from scenewright.studio.breeding import Breeding
from scenewright.studio.shapes import Shapes

Work = Callable[[Callable[[], bool]], Solution | None]
"""Something that is asked whether it goes on; a layout, or nothing, where it was ended."""
TICK = 0.002
"""Seconds between two looks at the clock."""
SEED = 3
BRED = 2.0
"""Processor seconds of breeding a sheet that are looked at."""


class Ended(NamedTuple):
    """After how many milliseconds work came back once it was told to end, by ``processor`` and
    ``clock``, at most; how many layouts ended at once were said to lack nothing; and how many
    times it was ended."""

    processor: float
    clock: float
    whole: int
    times: int


def list_work(name: str) -> Iterator[tuple[str, float, Work]]:
    """All that goes on for a while in a scene, and for how many processor seconds it is looked at:
    arranging, changing by hand, breeding a sheet."""
    brief = read(f"sample:{name}")
    plan = plan_of(brief)
    begun = time.process_time()
    scene = solve(brief, plan=plan, seed=SEED)
    whole = time.process_time() - begun
    yield "arrange", whole, lambda cancel: solve(brief, plan=plan, seed=SEED, cancel=cancel)
    space = plan.spaces[0].id if brief.rooms else scene.pieces[0].space
    yield "arrange again", whole, _changing(scene, plan, space)
    yield "breed", BRED, lambda cancel: _breed(brief, cancel)


def _changing(scene: Solution, plan: Plan, space: str) -> Work:
    def work(cancel: Callable[[], bool]) -> Solution | None:
        adjust(scene, plan=plan, again=[space], seed=SEED, cancel=cancel)
        return None

    return work


def _breed(brief: Any, cancel: Callable[[], bool]) -> None:
    breeding = Breeding(None, lambda _event: None, Shapes())
    breeding.begin(brief)
    worker = breeding.worker
    while worker is not None and worker.is_alive():
        if cancel():
            breeding.stop()
            break
        time.sleep(TICK)
    if worker is not None:
        worker.join()
    breeding.close()


def end_early(work: Work, moments: int, whole: float) -> Ended:
    """End work at so many moments of its ``whole`` length in processor seconds."""
    waits, clocks, complete = list[float](), list[float](), 0
    for number in range(moments):
        with _telling(whole * number / moments) as (told, asked):
            try:
                found = work(told.is_set)
            except CancelledError:
                found = None
            processor, clock = time.process_time(), time.perf_counter()
        if not asked:
            continue
        waits.append(processor - asked[0])
        clocks.append(clock - asked[1])
        if number == 0 and found is not None:
            complete += check(found, figures=False).complete
    return Ended(
        1000 * max(waits, default=0.0), 1000 * max(clocks, default=0.0), complete, len(waits)
    )


@contextmanager
def _telling(seconds: float) -> Iterator[tuple[Event, list[float]]]:
    """An event that is set after so many processor seconds, and when it was."""
    told, over, asked = Event(), Event(), list[float]()
    begun = time.process_time()

    def wait() -> None:
        while time.process_time() - begun < seconds:
            if over.wait(TICK):
                return
        asked.extend((time.process_time(), time.perf_counter()))
        told.set()

    waiting = Thread(target=wait)
    waiting.start()
    try:
        yield told, asked
    finally:
        over.set()
        waiting.join()
