"""Breeding on the page: a sheet of layouts at a time, what is said of them, and better ones."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from threading import Event, RLock, Thread
from time import sleep

from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution
from scenewright.engine.preference import events as said
from scenewright.engine.preference.features import stands_on_floor
from scenewright.studio.drawable import draw_card
from scenewright.studio.shapes import Json, Shapes
from scenewright.workflow.evolution.candidate import Screen, ShownCandidate
from scenewright.workflow.evolution.words import Command, parse_line
from scenewright.workflow.evolve import Evolution, evolve

Tell = Callable[[Json], None]
FIRST_LOOK = 4
"""Layouts that are shown as soon as they are bred, before a sheet is chosen."""
PAUSE = 0.1
"""Seconds between looks for layouts that can be drawn for the next sheet."""


class Breeding:
    """The evolution of a project's brief, with its log beside the project. Its sheets are bred in
    a thread; what is said meanwhile is refused."""

    def __init__(self, beside: Path | None, tell: Tell, shapes: Shapes) -> None:
        self.beside, self.tell, self.shapes = beside, tell, shapes
        self.lock, self.stopping = RLock(), Event()
        self.running = False
        self.worker: Thread | None = None
        self.evolution: Evolution | None = None
        self.cards: dict[int, tuple[Solution, Json]] = {}
        self.drawing: Thread | None = None
        self.early: list[Json] = []

    def begin(self, brief: Brief) -> None:
        """Go on with the evolution of a brief, or begin it; a first sheet is bred if there is
        none."""
        with self.lock:
            if self.evolution is None or self.evolution.brief != brief:
                self.close()
                self.evolution = evolve(brief, name_log(self.beside, brief))
            if self.evolution.screen is None:
                self.next()
            elif not self.running:
                self.evolution.breed_ahead()
                self._draw_on(self.evolution)
        self.tell({"bred": True})

    def next(self) -> None:
        """Breed the next sheet in a thread of its own."""
        with self.lock:
            evolution = self._must_breed()
            self.running, self.early = True, []
        self.stopping.clear()
        self.worker = Thread(target=self._ask, args=(evolution,), daemon=True)
        self.worker.start()

    def stop(self) -> None:
        """Give up the sheet that is being bred."""
        self.stopping.set()

    def _ask(self, evolution: Evolution) -> None:
        def progress(share: float, what: str) -> None:
            self.tell({"share": share, "what": what})
            self._look_early(evolution)

        try:
            evolution.ask(progress, self.stopping.is_set)
        except CancelledError:
            self.tell({"notice": "stopped: no sheet was bred"})
        except InputError as error:
            self.tell({"fault": str(error)})
        finally:
            self.running, self.early = False, []
            self.tell({"bred": True})
        self._draw_on(evolution)

    def _draw_on(self, evolution: Evolution) -> None:
        """Draw what is bred for the next sheet while this one is looked at, in a thread."""
        if self.drawing is None or not self.drawing.is_alive():
            self.drawing = Thread(target=self._draw_ahead, args=(evolution,), daemon=True)
            self.drawing.start()

    def _draw_ahead(self, evolution: Evolution) -> None:
        while self.evolution is evolution and not self.running:
            busy = evolution.busy()
            new = [one for one in evolution.coming() if one.number not in self.cards]
            if new:
                self._draw_card(new[0])
            elif busy:
                sleep(PAUSE)
            else:
                return

    def _draw_card(self, one: ShownCandidate) -> Json:
        """The card of a layout, drawn once."""
        solution, card = self.cards.get(one.number, (None, {}))
        if solution is not one.solution:
            card = draw_card(one.solution, one.plan, self.shapes)
            self.cards[one.number] = one.solution, card
        return card

    def _look_early(self, evolution: Evolution) -> None:
        """Draw the first few layouts of the first sheet while the others are bred."""
        if len(self.early) >= FIRST_LOOK or evolution.screen is not None:
            return
        bred = evolution.bred_so_far()[:FIRST_LOOK]
        if len(bred) > len(self.early):
            self.early = [draw_card(one, evolution.plan, self.shapes) for one in bred]
            self.tell({"bred": True})

    def state(self) -> Json:
        """Sheets, marks and predictions; layouts by number are told by :meth:`draw`."""
        with self.lock:
            evolution, running = self.evolution, self.running
            if evolution is None or running or evolution.screen is None:
                early = share(dict(enumerate(self.early)))
                name = name_brief(evolution.brief) if evolution is not None else ""
                return {"running": running, "early": early, "open": bool(name), "brief": name}
            screen = evolution.screen
            return {
                "running": False,
                "open": True,
                "brief": name_brief(evolution.brief),
                "sheet": screen.number,
                "sheets": [list(one) for one in evolution.sheets],
                "shown": [describe_card(one) for one in screen.candidates],
                "champion": screen.champion,
                "favourites": list(said.favourites_of(evolution.events)),
                "said": [said.record_of(event) for event in evolution.events],
                "reasons": list(evolution.reasons),
                "trust": str(screen.trust),
                "lockable": _list_lockable(evolution.champion),
            }

    def say(self, line: str, sheet: int) -> None:
        """Hear a line of ``evolve`` about a sheet, which must be the one shown."""
        with self.lock:
            evolution, screen = self._must_show(sheet)
            shown = [one.number for one in screen.candidates]
            meant = parse_line(
                line,
                shown,
                screen.number,
                evolution.said_of_screen,
                evolution.reasons,
                screen.champion,
            )
            if not isinstance(meant, Command):
                evolution.tell(*meant)
            elif meant.verb == "undo":
                evolution.undo()
            else:
                raise InputError(f"'{line[:60]}' says nothing of a layout", "use the buttons")
        self._draw_on(evolution)
        self.tell({"bred": True})

    def draw(self, numbers: Sequence[int]) -> Json:
        """Layouts by number: poses, and the shells that they share."""
        with self.lock:
            evolution = self._must_breed()
            return share({n: self._draw_card(self._shown(evolution, n)) for n in numbers})

    def compare(self, one: int, other: int) -> list[str]:
        """What one layout is or has against another."""
        with self.lock:
            evolution = self._must_breed()
            return self._shown(evolution, one).differences(self._shown(evolution, other))

    def choose(self, number: int) -> tuple[Solution, Plan]:
        """A layout to take over into the project."""
        with self.lock:
            one = self._shown(self._must_breed(), number)
            return one.solution, one.plan

    def close(self) -> None:
        """Let the evolution go; its log keeps all."""
        if self.evolution is not None:
            self.evolution.close()
        self.evolution, self.cards = None, {}

    def _must_breed(self) -> Evolution:
        if self.running:
            raise InputError("a sheet is being bred", "wait, or stop it first")
        if self.evolution is None:
            raise InputError("nothing is bred yet", "press Breed first")
        return self.evolution

    def _must_show(self, sheet: int) -> tuple[Evolution, Screen]:
        evolution = self._must_breed()
        screen = evolution.screen
        if screen is None or screen.number != sheet:
            raise InputError("another sheet is shown by now", "look at it first")
        return evolution, screen

    def _shown(self, evolution: Evolution, number: int) -> ShownCandidate:
        shown = evolution.candidate(number)
        if shown is None:
            raise InputError(f"layout {number} was not shown", "name one of the sheets")
        return shown


def share(cards: Mapping[int, Json]) -> Json:
    """Cards whose shells are told once.

    >>> card = {"levels": [], "pieces": [["a bed", 0, 1, 1, 0]]}
    >>> share({4: card, 7: card})["cards"][7]
    {'shell': 0, 'pieces': [['a bed', 0, 1, 1, 0]]}
    """
    shells: list[Json] = []
    found: dict[int, Json] = {}
    for number, card in cards.items():
        if card["levels"] not in shells:
            shells.append(card["levels"])
        found[number] = {"shell": shells.index(card["levels"]), "pieces": card["pieces"]}
    return {"cards": found, "shells": shells}


def describe_card(one: ShownCandidate) -> Json:
    """What a sheet says of a layout beside its picture."""
    chance = None if one.chance is None else round(one.chance, 3)
    return {"number": one.number, "predicted": chance, "faults": one.faults()}


def _list_lockable(champion: ShownCandidate | None) -> list[Json]:
    """What of the champion can be kept where it stands."""
    if champion is None:
        return []
    solution = champion.solution
    kinds = catalog_of(solution.brief.catalogs).kinds
    return [
        {"id": one.id, "name": kinds[one.category].name, "space": one.space}
        for one in solution.pieces
        if stands_on_floor(one) and one.category in kinds
    ]


def name_brief(brief: Brief) -> str:
    """A short name for a brief, another for each."""
    return hashlib.sha256(brief.model_dump_json().encode()).hexdigest()[:8]


def name_log(beside: Path | None, brief: Brief, suffix: str = ".evolution") -> Path | str:
    """The log of a brief's evolution, beside the project; none for a project in memory."""
    return "" if beside is None else beside.with_name(f"{beside.stem}-{name_brief(brief)}{suffix}")


def keep_locked(solution: Solution) -> Brief:
    """The brief to arrange, with what a person locked standing where it is."""
    domain = domain_of(solution.brief.domain)
    if not domain.has("locked") or not any(piece.fixed for piece in solution.pieces):
        return solution.brief
    brief: Brief = domain.verb("locked")(solution)
    return brief
