"""Scenes of generated homes and halls, one after the other: the loop of ``bench mujoco``,
``bench usd`` and ``bench meshes``."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, TypeVar

from benchmarks.generated_plans import asked_of
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains import solve
from scenewright.workflow.generate import generate

Record = dict[str, Any]
Measured = TypeVar("Measured")
Progress = Callable[[float, str], None]
HOMES, HALLS = 100, 20
QUICK_HOMES, QUICK_HALLS = 3, 1


def measure_scenes(
    measure: Callable[[Solution], Measured],
    tally: Callable[[str, list[Measured]], Iterable[Record]],
    steps: int,
    quick: bool = False,
    progress: Progress | None = None,
    count: int | None = None,
) -> Iterator[Record]:
    """The records that ``tally`` makes of measured homes, then of halls, each laid out in ``steps``
    steps; ``count`` homes and a fifth as many halls."""
    homes, halls = (QUICK_HOMES, QUICK_HALLS) if quick else (HOMES, HALLS)
    if count is not None:
        homes, halls = count, max(count // 5, 1)
    done = 0
    for kind, number in (("home", homes), ("hall", halls)):
        found: list[Measured] = []
        for brief in generated_briefs(kind, number):
            if progress is not None:
                progress(done / (homes + halls), f"{kind} {len(found) + 1} of {number}")
            found.append(measure(solve(brief, steps=steps)))
            done += 1
        yield from tally(f"{kind}s", found)


def generated_briefs(kind: str, number: int) -> Iterator[Brief]:
    """Generated plans by seed."""
    for seed in range(number):
        yield generate(kind, seed=seed, **(asked_of(seed) if kind == "home" else {}))
