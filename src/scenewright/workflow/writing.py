"""All files of a run at once: either all appear or none."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from scenewright.core.atomic_file import whole_together
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.checked_write import write_checked
from scenewright.workflow.events import Progress, Wrote


def write_all(
    solutions: Sequence[tuple[Solution, Path]], plan: Plan | None = None, parts: Path | None = None
) -> Generator[Progress | Wrote, None, None]:
    """Write each solution to its file under a temporary name, two at a time; when all are whole
    they are renamed. ``plan`` is that of their one brief (made unless given); temporary files lie
    beside their targets, or in the folder ``parts``."""
    paths = [path for _, path in solutions]
    with whole_together(paths, parts) as partials, ThreadPoolExecutor(2) as pool:
        pending = [
            pool.submit(write_checked, solution, partial, path, plan)
            for (solution, path), partial in zip(solutions, partials, strict=True)
        ]
        for path, writing in zip(paths, pending, strict=True):
            yield Progress(1.0, f"writing {path.name}")
            writing.result()
    for path in paths:
        yield Wrote(path)
