"""A scene under work: verbs that change it, one after another, each a version of its project."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from threading import Event, RLock, Thread
from typing import Any, NamedTuple

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.core.edits import Adjusted, Change
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution, unfurnished
from scenewright.formats import solution_json
from scenewright.studio.breeding import Breeding, keep_locked
from scenewright.studio.delta import States
from scenewright.studio.draft_faults import DraftFault, read_draft
from scenewright.studio.drafting import FORMAT, complete_draft, draw_act, keep_asked, new_draft
from scenewright.studio.drawable import describe_finding, draw, tell_by_key
from scenewright.studio.people import AUTHOR, RATE, People, Person
from scenewright.studio.photos import Photos, View
from scenewright.studio.raters import RaterDesk, Raters
from scenewright.studio.readiness import Readiness
from scenewright.studio.shapes import Json, Shapes
from scenewright.studio.shelf import draw_shelf, list_shelf
from scenewright.studio.solid import tell_solid
from scenewright.studio.streaming import stream_layouts
from scenewright.studio.taking import pack_scene, write_scene
from scenewright.studio.wishing import list_wishes, with_wishes
from scenewright.workflow import project
from scenewright.workflow.dressing import change_look
from scenewright.workflow.fitting import find_nearest_fit
from scenewright.workflow.judging import MoveJudge
from scenewright.workflow.scene_project import describe_result, dump_edits
from scenewright.workflow.workspace import Workspace

Tell = Callable[[Json], None]
"""Called with every event: progress, and that another version is shown."""
BUSY = InputError("something is being arranged", "wait, or stop it first")


class Shown(NamedTuple):
    """The version on the page, with what is worked out of it once."""

    version: int
    solution: Solution
    plan: Plan
    report: Report


class Drawn(NamedTuple):
    """The drawing that the version on the page is, or was furnished from, with its faults."""

    draft: Json
    faults: list[DraftFault]


class Session:
    """One project, the version it shows, and the search that runs, if any. Verbs come from any
    thread and are done one at a time; ``tell`` hears what happens meanwhile."""

    def __init__(self, db: sqlite3.Connection, tell: Tell) -> None:
        self.db, self.tell = db, tell
        self.lock, self.stopping = RLock(), Event()
        self.running = False
        self.worker: Thread | None = None
        beside, self.shapes = project.path_of(db), Shapes()
        self.breeding = Breeding(beside, tell, self.shapes)
        self.people = People(db)
        self.photos, self.readiness = Photos(tell), Readiness(tell)
        self.raters = Raters(self.people, beside, tell, self.shapes)
        self.shown: Shown | None = None
        self.mover: MoveJudge | None = None
        self.states = States()
        self.sketched: tuple[Shown, Json] | None = None
        self.drawn: Drawn | None = None
        version = project.shown_version(db)
        if version is not None:
            self._load(version.id)

    def state(self) -> Json:
        """All that the page shows."""
        with self.lock:
            version, shown, drawn = project.shown_version(self.db), self.shown, self.drawn
            if version is None:
                return {"running": self.running, "version": 0, "history": []}
            steps = [row._asdict() for row in project.list_versions(self.db)]
            redo = project.next_version(self.db, version.id)
        where = {"version": version.id, "history": steps, "undo": version.parent, "redo": redo}
        scene: Json = self._draw(shown) if shown else {"name": "", "levels": [], "pieces": []}
        scene["wishes"] = list_wishes(shown.solution.brief) if shown else {}
        if drawn:
            scene["name"], scene["draft"] = drawn.draft["name"], drawn.draft
            scene["faults"] = [one._asdict() for one in drawn.faults]
        return {"running": self.running, **where, **scene}

    def kind(self) -> str:
        """The kind of scene that is open or drawn; a home if nothing is."""
        if self.shown:
            return self.shown.solution.brief.domain
        return str(self.drawn.draft["domain"]) if self.drawn else "home"

    def _draw(self, shown: Shown) -> Json:
        """What is shown, drawn once a version."""
        if self.sketched is None or self.sketched[0] is not shown:
            self.sketched = shown, draw(*shown[1:])
        return {**self.sketched[1]}

    def state_since(self, stamp: int) -> Json:
        """How the state changed since one that was told (:mod:`.delta`); all of it if that is not
        known any more."""
        with self.lock:
            return self.states.tell(tell_by_key(self.state(), self.shapes), stamp)

    def solid(self) -> Json:
        """The scene in 3D: poses and keys of meshes (:mod:`.solid`)."""
        shown = self.must_show()
        scene = domains.scene_of(shown.solution, shown.plan)
        return tell_solid(scene, catalog_of(shown.solution.brief.catalogs), self.shapes)

    def open(self, source: str, root: Path | None = None) -> None:
        """Begin with a file or a sample: its plan, with what is fixed in it. All it names lies
        below a ``root``, if there is one."""
        with self._turn():
            brief, plan = Workspace(root).read_planned(source)
            self._keep(0, f"opened {Path(source).name}", unfurnished(brief), plan)

    def begin(self, domain: str = "home") -> None:
        """Begin a plan to be drawn: of a home, a hall, a site or a village."""
        with self._turn():
            self._keep_draft(0, "began a plan", new_draft(domain))

    def sketch(self, asked: Json) -> None:
        """Change the drawn plan (:mod:`.drafting`); what was furnished in it is arranged anew."""
        with self._turn():
            version = project.shown_version(self.db)
            if version is None or self.drawn is None:
                raise InputError("this plan was not drawn here", "begin a new one")
            known = list_wishes(self.shown.solution.brief) if self.shown else {}
            draft, done = draw_act(keep_asked(self.drawn.draft, known), asked)
            self._keep_draft(version.id, done, draft)

    def arrange(self, seed: int = 0) -> None:
        """Furnish the plan anew in a thread of its own; locked pieces stay."""
        with self._turn():
            shown = self.must_show()
            self.running = True
        self.stopping.clear()
        self.worker = Thread(target=self._arrange, args=(shown, seed, AUTHOR.get()), daemon=True)
        self.worker.start()

    def stop(self) -> None:
        """Ask the search that runs to end with the best so far."""
        self.stopping.set()
        self.breeding.stop()
        self.photos.stop()

    def wait(self) -> None:
        """Wait for what a verb began: a search, a sheet."""
        for worker in (self.worker, self.breeding.worker, self.photos.worker):
            if worker is not None:
                worker.join()

    def breed(self) -> None:
        """Breed layouts of the plan shown, with what is locked in it: the sheet, or the first."""
        with self._turn():
            self.breeding.begin(keep_locked(self.must_show().solution))

    def choose(self, number: int) -> None:
        """Take over a layout that was bred."""
        with self._turn():
            parent = self.must_show().version
            self._keep(parent, f"took layout {number + 1}", *self.breeding.choose(number))

    def give(self) -> None:
        """Give the plan out to be rated, with what is locked in it."""
        self.raters.begin(keep_locked(self.must_show().solution))
        self.tell({"rated": True})

    def take(self, number: int) -> None:
        """Take over a layout that people rated."""
        with self._turn():
            parent = self.must_show().version
            self._keep(parent, f"took rated layout {number + 1}", *self.raters.choose(number))

    def invite(self, name: str, right: str) -> Json:
        """The token of a link for a person; for one who rates there is a pool from now on."""
        if right == RATE and self.raters.pool is None:
            self.give()
        return {"token": self.people.invite(name, right)}

    def desk_of(self, person: Person) -> RaterDesk:
        """What the verbs of someone who may not edit work on."""
        return RaterDesk(self.raters, person)

    def close(self) -> None:
        """Stop what runs; all is kept."""
        self.stop()
        self.readiness.stop()
        self.breeding.close()
        self.raters.close()
        self.people.close()

    def _arrange(self, shown: Shown, seed: int, author: str) -> None:
        AUTHOR.set(author)
        try:
            brief = keep_locked(shown.solution)
            plan = domains.plan_of(brief)
            solution = domains.solve(
                brief,
                plan=plan,
                seed=seed,
                progress=lambda share, what: self.tell({"share": share, "what": what}),
                cancel=self.stopping.is_set,
                watch=stream_layouts(self.tell),
            )
            with self.lock:
                self._keep(shown.version, f"arranged, seed {seed}", solution, plan)
        except CancelledError:
            self.tell({"notice": "stopped before anything was found"})
        except InputError as error:
            self.tell({"fault": str(error)})
        finally:
            self.running = False
            self.tell({"changed": True})

    def change(
        self, what: str, edits: Mapping[str, Any], by: Callable[..., Adjusted] = domains.adjust
    ) -> Json:
        """Change the scene by hand (the edits of :func:`scenewright.domains.adjust`, or of another
        function like it); every change with its reason."""
        with self._turn():
            shown = self.must_show()
            self.stopping.clear()
            more = {"cancel": self.stopping.is_set} if by is domains.adjust else {}
            adjusted = by(shown.solution, plan=shown.plan, **edits, **more)
            same = adjusted.solution.brief is shown.solution.brief
            plan = shown.plan if same else domains.plan_of(adjusted.solution.brief)
            told = adjusted.changes, dump_edits(edits, None)
            self._keep(shown.version, what, adjusted.solution, plan, *told)
        return {"changes": [change._asdict() for change in adjusted.changes]}

    def wish(self, room: str, wishes: Any) -> None:
        """Change what is wished for in a room, hall, site or block; it is heeded when that is
        arranged."""
        with self._turn():
            shown = self.must_show()
            brief = with_wishes(shown.solution.brief, room, wishes)
            plan = domains.plan_of(brief)
            solution = replace(shown.solution, brief=brief)
            self._keep(shown.version, f"wishes for {room}", solution, plan)

    def judge(self, poses: Mapping[str, Sequence[float]]) -> list[Json]:
        """What the referee would say if pieces, with all that lies on them, were put there."""
        return [describe_finding(found) for found in self._mover().find_new(poses)]

    def fit(self, piece: str, pose: Sequence[float]) -> Json:
        """The nearest place to a wanted one where the referee has nothing to say of a piece."""
        place = find_nearest_fit(self._mover(), piece, pose)
        return {"pose": None if place is None else [round(number, 4) for number in place]}

    def _mover(self) -> MoveJudge:
        shown = self.must_show()
        if self.mover is None or self.mover.solution is not shown.solution:
            self.mover = MoveJudge(shown.solution, shown.plan)
        return self.mover

    def go(self, version: int) -> None:
        """Show another version: one further back, or one that was undone."""
        with self._turn():
            self._load(version)
            project.show_version(self.db, version)
        self.tell({"changed": True})

    def undo(self) -> None:
        """Go back to the version that this one was made from."""
        with self.lock:
            version = project.shown_version(self.db)
            if version is None or not version.parent:
                raise InputError("there is nothing to undo", "change something first")
            self.go(version.parent)

    def redo(self) -> None:
        """Go forward again to what was undone last."""
        with self.lock:
            version = project.shown_version(self.db)
            following = project.next_version(self.db, version.id) if version else 0
            if not following:
                raise InputError("there is nothing to redo", "undo something first")
            self.go(following)

    def shelf(self) -> list[Json]:
        """What can be put in, by the catalog of the brief."""
        return list_shelf(self.must_show().solution.brief) if self.shown else []

    def thumb(self, asset: str) -> bytes:
        """The picture of a model of the shelf."""
        return draw_shelf(self.must_show().solution.brief, asset)

    def export(self, endings: Sequence[str] = ()) -> bytes:
        """The scene in several formats as one zip archive; what cannot be written is told in it."""
        return pack_scene(self.must_show().solution, endings)

    def file(self, ending: str) -> bytes:
        """The scene in one format: its picture from above at an angle, its model."""
        return write_scene(self.must_show().solution, ending)

    def photograph(self, view: View) -> None:
        """Photograph what is shown from a view, in a thread of its own."""
        shown = self.must_show()
        self.photos.begin(shown.solution, shown.plan, view)

    def restyle(self, style: str, palette: str = "") -> Json:
        """Models of a style, and a palette of it, for the whole home; what is locked stays."""
        with self._turn():
            shown = self.must_show()
            solution, changes = change_look(shown.solution, style, palette)
            self._keep(shown.version, f"restyled, {style} {palette}".strip(), solution, shown.plan)
        return {"changes": changes}

    @contextmanager
    def _turn(self) -> Iterator[None]:
        """One verb at a time, and none while something is arranged."""
        with self.lock:
            if self.running:
                raise BUSY
            yield

    def must_show(self) -> Shown:
        """What is shown, if it can be furnished; InputError otherwise."""
        if self.shown is None:
            faults = [one.message for one in self.drawn.faults] if self.drawn else []
            fault = f"the plan is not ready: {faults[0]}" if faults else "nothing is drawn or open"
            raise InputError(fault, "mend it first" if faults else "open or draw a plan first")
        return self.shown

    def _keep(
        self,
        parent: int,
        what: str,
        solution: Solution,
        plan: Plan,
        changes: Sequence[Change] = (),
        edit: str = "",
    ) -> None:
        report = domains.check(solution, plan=plan, figures=False)
        text, said = solution_json.dumps(solution), describe_result(report, changes)
        number = project.add_version(
            self.db, parent, _by(what), text, who=AUTHOR.get(), edit=edit, entries=said
        )
        self.shown = Shown(number, solution, plan, report)
        self.drawn = self.drawn if parent else None
        self.tell({"changed": True})

    def _keep_draft(self, parent: int, what: str, draft: Json) -> None:
        number = project.add_version(self.db, parent, _by(what), json.dumps(draft))
        self._show_draft(number, draft)
        self.tell({"changed": True})

    def _show_draft(self, number: int, draft: Json) -> None:
        brief, plan, faults = read_draft(draft)
        self.drawn, self.shown = Drawn(draft, faults), None
        if brief is not None and plan is not None:
            empty = unfurnished(brief)
            self.shown = Shown(number, empty, plan, domains.check(empty, plan=plan, figures=False))

    def _load(self, version: int) -> None:
        """Show a version: a drawn plan, or a scene with the drawing it was made from, if any."""
        text, known = project.solution_text(self.db, version), self.shown
        if _is_draft(text):
            self._show_draft(version, complete_draft(json.loads(text)))
            return
        solution = solution_json.loads(text)
        same = known is not None and known.solution.brief == solution.brief
        plan = known.plan if known is not None and same else domains.plan_of(solution.brief)
        self.shown = Shown(
            version, solution, plan, domains.check(solution, plan=plan, figures=False)
        )
        parents = (project.solution_text(self.db, one) for one in project.trace(self.db, version))
        text = next(filter(_is_draft, parents), "")
        self.drawn = Drawn(complete_draft(json.loads(text)), []) if text else None


def _by(what: str) -> str:
    """What was done, with the name of who did it if that was a guest."""
    author = AUTHOR.get()
    return f"{author}: {what}" if author else what


def _is_draft(text: str) -> bool:
    return text.startswith(f'{{"format": "{FORMAT}"')
