"""People who rate: one pool of layouts for all, a sheet for each, and what they liked together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from threading import Event, RLock, Thread

from scenewright.core.brief import Brief
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.engine.preference import events as said
from scenewright.formats import brief_json
from scenewright.studio.breeding import describe_card, name_brief, share
from scenewright.studio.drawable import draw_card
from scenewright.studio.people import People, Person
from scenewright.studio.shapes import Json, Shapes
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.raters import RaterPool
from scenewright.workflow.evolution.words import Command, parse_line

Tell = Callable[[Json], None]
MOST_LIKED = 12
"""Layouts that the list of results shows."""


class Raters:
    """The pool that is rated, opened for the last brief that was given out to be rated."""

    def __init__(self, people: People, beside: Path | None, tell: Tell, shapes: Shapes) -> None:
        self.people, self.beside, self.tell, self.shapes = people, beside, tell, shapes
        self.lock, self.stopping = RLock(), Event()  # an event of its own for each pool
        self.pool: RaterPool | None = None
        self.cards: dict[int, Json] = {}
        last = people.last_pool()
        if last is not None:
            self._open(last[0], brief_json.loads(last[1]))

    def begin(self, brief: Brief) -> None:
        """Give a brief out to be rated; its pool is bred in a thread of its own."""
        with self.lock:
            if self.pool is None or self.pool.brief != brief:
                self._open(self.people.begin_pool(brief.model_dump_json()), brief)

    def _open(self, number: int, brief: Brief) -> None:
        self.close()
        beside = self.beside
        path = beside.with_name(f"{beside.stem}-{name_brief(brief)}.raters") if beside else ""
        self.stopping, self.cards = Event(), {}
        self.pool = pool = RaterPool(
            brief,
            EvolutionLog(path),
            lambda who, kind, body: self.people.keep(number, who, kind, body),
            self.people.marks(number),
        )
        Thread(target=self._prepare, args=(pool, self.stopping), daemon=True).start()

    def _prepare(self, pool: RaterPool, stopping: Event) -> None:
        try:
            pool.prepare(cancel=stopping.is_set)
        except CancelledError:
            return
        except InputError as error:
            self.tell({"fault": str(error)})
        self.tell({"bred": True})

    def must_rate(self) -> RaterPool:
        """The pool, once it can be rated."""
        pool = self.pool
        if pool is None or not pool.is_ready():
            raise InputError("the layouts are still being made", "wait a little")
        return pool

    def card(self, number: int) -> Json:
        """The small picture of a layout, drawn once for all."""
        if number not in self.cards:
            one = self.must_rate().candidate(number)
            self.cards[number] = draw_card(one.solution, one.plan, self.shapes)
        return self.cards[number]

    def results(self) -> Json:
        """Who said how much, and what they liked together."""
        pool = self.pool
        counts = pool.raters() if pool is not None else {}
        people = [
            {
                "id": one.id,
                "name": one.name,
                "right": one.right,
                "marks": counts.get(str(one.id), 0),
            }
            for one in self.people.all()
        ]
        if pool is None or not pool.is_ready():
            return {"people": people, "liked": [], "pool": 0} | share({})
        liked = pool.liked()[:MOST_LIKED]
        cards = share({one.number: self.card(one.number) for one in liked})
        rows = [one._asdict() for one in liked]
        return {"people": people, "liked": rows, "pool": pool.size()} | cards

    def choose(self, number: int) -> tuple[Solution, Plan]:
        """A layout of the pool to take over into the project."""
        one = self.must_rate().candidate(number)
        return one.solution, one.plan

    def close(self) -> None:
        """Let the pool go; all is kept."""
        self.stopping.set()
        if self.pool is not None:
            self.pool.close()
        self.pool = None


class RaterDesk:
    """What the verbs of one rater work on: her sheets of the pool, as a project's
    :class:`~.breeding.Breeding` is worked on."""

    def __init__(self, raters: Raters, person: Person) -> None:
        self.raters, self.who, self.breeding = raters, str(person.id), self

    def breed(self) -> None:
        """Show a first sheet, if there is none and the pool is ready."""
        pool = self.raters.pool
        if pool is not None and pool.is_ready() and pool.screen(self.who) is None:
            self.next()

    def next(self) -> None:
        """Ask for the next sheet."""
        self.raters.must_rate().ask(self.who)

    def state(self) -> Json:
        """Her sheet, what she said, what is predicted."""
        pool = self.raters.pool
        if pool is None:
            return {"running": False, "open": False, "early": share({}), "brief": ""}
        screen = pool.screen(self.who) if pool.is_ready() else None
        name = name_brief(pool.brief)
        if screen is None:
            waits = not pool.is_ready()
            return {"running": waits, "open": True, "early": share({}), "brief": name}
        history = pool.history(self.who)
        events = said.counting(history.events)
        return {
            "running": False,
            "open": True,
            "brief": name,
            "sheet": screen.number,
            "sheets": [list(one.shown) for one in history.screens],
            "shown": [describe_card(one) for one in screen.candidates],
            "champion": screen.champion,
            "favourites": list(said.favourites_of(events)),
            "said": [said.record_of(event) for event in events],
            "reasons": list(pool.reasons),
            "trust": str(screen.trust),
            "lockable": [],
        }

    def say(self, line: str, sheet: int) -> None:
        """Hear a line about the sheet shown."""
        pool = self.raters.must_rate()
        history = pool.history(self.who)
        if len(history.screens) - 1 != sheet:
            raise InputError("another sheet is shown by now", "look at it first")
        last = history.screens[-1]
        events = said.counting(history.events)
        here = said.counting(history.events[last.before :])
        champion = said.champion_of(events)
        meant = parse_line(line, last.shown, sheet, here, pool.reasons, champion)
        if not isinstance(meant, Command):
            pool.tell(self.who, *meant)
        elif meant.verb == "undo":
            pool.undo(self.who)
        else:
            raise InputError(f"'{line[:60]}' says nothing of a layout", "use the buttons")

    def draw(self, numbers: Sequence[int]) -> Json:
        """Layouts she was shown, by number."""
        shown = self.raters.must_rate().history(self.who).shown
        return share({number: self.raters.card(number) for number in numbers if number in shown})

    def compare(self, one: int, other: int) -> list[str]:
        """What one layout is or has against another."""
        pool = self.raters.must_rate()
        shown = pool.history(self.who).shown
        if not {one, other} <= shown:
            raise InputError("that layout was not shown", "name two of your sheets")
        return pool.candidate(one).differences(pool.candidate(other))
