"""What the log of an evolution says, as a value that grows entry by entry."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from scenewright.engine.preference.events import Edit, Event, Judgement, Pick, counting, event_of
from scenewright.engine.preference.trust import TrustRecord, count_hit
from scenewright.workflow.evolution.log import Entry
from scenewright.workflow.evolution.log_records import check_known
from scenewright.workflow.evolution.statement_checks import candidates_in


class ShownScreen(NamedTuple):
    """Candidates shown together, what was predicted of each beforehand (none: nothing), how
    many events had been said before, and whether most were to learn from."""

    shown: tuple[int, ...]
    predicted: tuple[float | None, ...]
    before: int
    wide: bool = False


class History(NamedTuple):
    """How many ``entries`` there are, the ``events`` among them, the ``screens``, all candidates
    ever ``shown``, and how often the model was left to rate alone (``autos``)."""

    entries: int = 0
    events: tuple[Event, ...] = ()
    screens: tuple[ShownScreen, ...] = ()
    shown: frozenset[int] = frozenset()
    autos: int = 0

    def after(self, kind: str, body: dict[str, Any]) -> History:
        """The history with one more entry."""
        grown = self._replace(entries=self.entries + 1)
        if kind == "event":
            event = event_of(body)
            more = {event.after} if isinstance(event, Edit) else set()
            return grown._replace(events=(*self.events, event), shown=self.shown | more)
        if kind == "auto":
            return grown._replace(autos=self.autos + 1)
        shown, predicted = tuple(body["shown"]), tuple(body["predicted"])
        screen = ShownScreen(
            shown, predicted, len(self.events), 2 * body.get("wide", 0) > len(shown)
        )
        return grown._replace(
            screens=(*self.screens, screen), shown=self.shown | frozenset(screen.shown)
        )

    def before_screen(self, number: int) -> tuple[Event, ...]:
        """The events said before a screen was chosen."""
        return self.events[: self.screens[number].before] if number >= 0 else ()

    def before_mark(self) -> int | None:
        """How many events there are up to the first mark of the last screen, which is one of them;
        none before that."""
        first = self.screens[-1].before if self.screens else 0
        events = enumerate(self.events[first:], first + 1)
        return next((k for k, event in events if isinstance(event, Judgement)), None)

    @property
    def trust(self) -> TrustRecord:
        """How often the predicted top of a screen held what was picked first on it, counted where
        something had been predicted and the pick still counts."""
        record = TrustRecord()
        ends = [screen.before for screen in self.screens[1:]] + [len(self.events)]
        for screen, end in zip(self.screens, ends, strict=True):
            pick = _first_pick(self.events[screen.before : end], screen.shown)
            if pick is not None and None not in screen.predicted:
                place = screen.shown.index(pick.best)
                predicted = [value for value in screen.predicted if value is not None]
                record = count_hit(record, predicted, place, not screen.wide)
        return record


def _first_pick(events: Sequence[Event], shown: Sequence[int]) -> Pick | None:
    """The first pick among all of a screen that was not taken back on it."""
    picks = [event for event in counting(events) if isinstance(event, Pick)]
    return next((pick for pick in picks if set(pick.among) == set(shown)), None)


def read_history(entries: Sequence[Entry], candidates: int) -> History:
    """The history of all entries of a log that holds ``candidates`` candidates; InputError where
    they speak of others.

    >>> shown = {"screen": 0, "shown": [0, 1], "predicted": [None, None]}
    >>> said = {"event": "pick", "best": 1, "among": [0, 1]}
    >>> read_history([Entry(0, "screen", shown), Entry(1, "event", said)], 2).events
    (Pick(best=1, among=(0, 1)),)
    """
    history = History()
    for entry in entries:
        history = history.after(entry.kind, entry.body)
    check_known(history.shown, candidates)
    check_known({n for event in history.events for n in candidates_in(event)}, candidates)
    return history
