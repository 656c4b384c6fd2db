"""The verb ``arrange``: a bar while it works, Ctrl-C that keeps the best so far."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import ExitStack
from typing import NamedTuple, TypeVar

from rich.console import Console

from scenewright.cli.progress import SolverWatch, watching
from scenewright.cli.show_input import print_input
from scenewright.cli.tables import print_line
from scenewright.workflow.arrange import Arranged, arrange_file
from scenewright.workflow.events import Event, Notice, Planned, Progress, run_to_end
from scenewright.workflow.request import ArrangeRequest

T = TypeVar("T")
Cancel = Callable[[], bool]


class Followed(NamedTuple):
    """What a run came to; ``interrupted`` if Ctrl-C ended the search early."""

    arranged: Arranged
    interrupted: bool


def arrange(request: ArrangeRequest, console: Console) -> Followed:
    """Solve the request, write its outputs, and return what came of it.

    Interrupted before anything was found it raises ``CancelledError`` and writes nothing.
    """
    return Followed(*follow(lambda cancel: arrange_file(request, cancel=cancel), console))


def follow(
    run: Callable[[Cancel], Generator[Event, None, T]], console: Console, stoppable: bool = True
) -> tuple[T, bool]:
    """What a run returns, shown on ``console`` while it works, and whether it was interrupted.

    Once the brief is planned a bar appears, and the first Ctrl-C asks a ``stoppable`` run to stop;
    before, it ends it.
    """
    watches: list[SolverWatch] = []

    def cancelled() -> bool:
        return any(watch.cancelled() for watch in watches)

    with ExitStack() as stack:

        def hear(event: Event) -> None:
            if isinstance(event, Planned):
                print_input(console, event.brief.input_report)
                watches.append(stack.enter_context(watching(console, console.quiet, stoppable)))
            elif isinstance(event, Progress):
                watches[-1].progress(*event)
            elif isinstance(event, Notice):
                print_line(console, event.text, "dim")

        result = run_to_end(run(cancelled), hear)
        return result, cancelled()
