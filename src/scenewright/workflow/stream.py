"""A function that calls back while it works, as a generator of what it calls back with.

The work runs in a thread of its own, so that the one who listens gets it at once. A listener
that goes away (Ctrl-C, or a generator closed early) asks the work to stop and does not wait.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextvars import copy_context
from queue import SimpleQueue
from threading import Event as Flag
from threading import Thread
from typing import NamedTuple, TypeVar

from scenewright.workflow.events import Changed, Progress

T = TypeVar("T")
Tell = Callable[[float, str], None]
Cancel = Callable[[], bool]


class _End(NamedTuple):
    """How the work ended: by a result, or by an error."""

    results: tuple[object, ...] = ()
    error: BaseException | None = None


def stream_progress(
    work: Callable[[Tell, Cancel], T], cancel: Cancel | None = None
) -> Generator[Progress | Changed, None, T]:
    """What ``work(tell, cancelled)`` returns; every ``tell(share, what)`` is yielded meanwhile, as
    :func:`stream_events` does.

    >>> def work(tell, cancelled):
    ...     tell(0.5, "half")
    ...     return cancelled()
    >>> events = stream_progress(work)
    >>> next(events)
    Progress(share=0.5, what='half')
    >>> try:
    ...     next(events)
    ... except StopIteration as end:
    ...     end.value
    False
    """

    def pass_on(tell: Callable[[Progress | Changed], None], cancelled: Cancel) -> T:
        return work(lambda share, what: tell(Progress(share, what)), cancelled)

    return stream_events(pass_on, cancel)


def stream_events(
    work: Callable[[Callable[[Progress | Changed], None], Cancel], T], cancel: Cancel | None = None
) -> Generator[Progress | Changed, None, T]:
    """What ``work(tell, cancelled)`` returns; every ``tell(event)`` is yielded meanwhile.

    ``cancelled`` answers true when ``cancel`` does, or nobody listens any more. An error of the
    work is raised here.
    """
    queue: SimpleQueue[Progress | Changed | _End] = SimpleQueue()
    left = Flag()

    def cancelled() -> bool:
        return left.is_set() or (cancel is not None and cancel())

    def run() -> None:
        try:
            result = work(queue.put, cancelled)
        except BaseException as error:  # raised again where it is listened to
            queue.put(_End(error=error))
        else:
            queue.put(_End((result,)))

    Thread(target=copy_context().run, args=(run,), daemon=True).start()
    try:
        while not isinstance(event := queue.get(), _End):
            yield event
    finally:
        left.set()
    if event.error is not None:
        raise event.error
    (result,) = event.results
    return result  # type: ignore[return-value]
