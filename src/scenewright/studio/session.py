"""A scene under work: verbs that change it, one after another, each a version of its project."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from threading import Event, RLock, Thread
from typing import Any

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.core.edits import Adjusted
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.solution import unfurnished
from scenewright.studio.breeding import Breeding, keep_locked
from scenewright.studio.delta import States
from scenewright.studio.draft_taken import TAKEN, draft_of
from scenewright.studio.drafting import draw_act, keep_asked, new_draft
from scenewright.studio.drawable import describe_finding, draw, tell_by_key, tell_reading
from scenewright.studio.people import AUTHOR, RATE, People, Person
from scenewright.studio.photos import Photos, View
from scenewright.studio.raters import RaterDesk, Raters
from scenewright.studio.readiness import Readiness
from scenewright.studio.shapes import Json, Shapes
from scenewright.studio.shelf import draw_shelf, list_shelf
from scenewright.studio.solid import tell_solid
from scenewright.studio.streaming import stream_layouts
from scenewright.studio.taking import pack_scene, write_scene
from scenewright.studio.versions import Drawn, Shown, Versions
from scenewright.studio.wishing import FORMS, list_wishes, with_wishes
from scenewright.workflow import project
from scenewright.workflow.dressing import change_look
from scenewright.workflow.fitting import find_nearest_fit
from scenewright.workflow.judging import MoveJudge
from scenewright.workflow.scene_project import dump_edits
from scenewright.workflow.workspace import Workspace

Tell = Callable[[Json], None]
"""Called with every event: progress, and that another version is shown."""
BUSY = InputError("something is being arranged", "wait, or stop it first")


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
        self.versions = Versions(db, lambda: self.tell({"changed": True}))
        self.mover: MoveJudge | None = None
        self.states = States()
        self.sketched: tuple[Shown, Json] | None = None

    @property
    def shown(self) -> Shown | None:
        """The scene on the page, if there is one."""
        return self.versions.shown

    @property
    def drawn(self) -> Drawn | None:
        """The drawing of it, if it was drawn."""
        return self.versions.drawn

    def state(self) -> Json:
        """All that the page shows."""
        with self.lock:
            where, shown, drawn = self.versions.describe(), self.shown, self.drawn
        if not where["version"]:
            return {"running": self.running, **where}
        scene: Json = self._draw(shown) if shown else {"name": "", "levels": [], "pieces": []}
        scene["wishes"] = list_wishes(shown.solution.brief) if shown else {}
        scene["read"] = tell_reading(shown.solution.brief) if shown else []
        form = FORMS.get(self.kind())
        scene |= {"walls": bool(form and form.walls), "storeys": bool(form and form.storeys)}
        scene["redraws"] = self.kind() in TAKEN
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
        shown = self.versions.must_show()
        scene = domains.scene_of(shown.solution, shown.plan)
        return tell_solid(scene, catalog_of(shown.solution.brief.catalogs), self.shapes)

    def open(self, source: str, root: Path | None = None) -> None:
        """Begin with a file or a sample: its plan, with what is fixed in it. All it names lies
        below a ``root``, if there is one."""
        with self._turn():
            brief, plan = Workspace(root).read_planned(source)
            self.versions.keep(0, f"opened {Path(source).name}", unfurnished(brief), plan)

    def begin(self, domain: str = "home") -> None:
        """Begin a plan to be drawn, of a kind of scene that is."""
        with self._turn():
            self.versions.keep_draft(0, "began a plan", new_draft(domain))

    def sketch(self, asked: Json) -> None:
        """Change the drawn plan (:mod:`.drafting`); what was furnished in it is arranged anew."""
        with self._turn():
            if self.drawn is None:
                raise InputError("this plan was not drawn here", "draw over it first (redraw)")
            known = list_wishes(self.shown.solution.brief) if self.shown else {}
            draft, done = draw_act(keep_asked(self.drawn.draft, known), asked)
            self.versions.keep_draft(self.versions.number, done, draft)

    def redraw(self) -> Json:
        """Draw over the plan that is open, with what is locked in it; what a drawing cannot hold is
        listed."""
        with self._turn():
            draft = draft_of(keep_locked(self.versions.must_show().solution))
            self.versions.keep_draft(self.versions.number, "took the plan over to draw", draft)
        return {"lost": draft["lost"]}

    def arrange(self, seed: int = 0) -> None:
        """Furnish the plan anew in a thread of its own; locked pieces stay."""
        with self._turn():
            shown = self.versions.must_show()
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
            self.breeding.begin(keep_locked(self.versions.must_show().solution))

    def choose(self, number: int) -> None:
        """Take over a layout that was bred."""
        with self._turn():
            parent = self.versions.must_show().version
            self.versions.keep(parent, f"took layout {number + 1}", *self.breeding.choose(number))

    def give(self) -> None:
        """Give the plan out to be rated, with what is locked in it."""
        self.raters.begin(keep_locked(self.versions.must_show().solution))
        self.tell({"rated": True})

    def take(self, number: int) -> None:
        """Take over a layout that people rated."""
        with self._turn():
            parent = self.versions.must_show().version
            self.versions.keep(
                parent, f"took rated layout {number + 1}", *self.raters.choose(number)
            )

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
            for out in solution.left_out:
                told = {"space": out.space, "stage": "left out"}
                self.tell({**told, "reason": f"{out.what}: {out.reason}"})
            with self.lock:
                self.versions.keep(shown.version, f"arranged, seed {seed}", solution, plan)
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
            shown = self.versions.must_show()
            self.stopping.clear()
            more = {"cancel": self.stopping.is_set} if by is domains.adjust else {}
            adjusted = by(shown.solution, plan=shown.plan, **edits, **more)
            same = adjusted.solution.brief is shown.solution.brief
            plan = shown.plan if same else domains.plan_of(adjusted.solution.brief)
            told = adjusted.changes, dump_edits(edits, None)
            self.versions.keep(shown.version, what, adjusted.solution, plan, *told)
        return {"changes": [change._asdict() for change in adjusted.changes]}

    def wish(self, room: str, wishes: Any) -> None:
        """Change what is wished for in a room, hall, site or block; it is heeded when that is
        arranged."""
        with self._turn():
            shown = self.versions.must_show()
            brief = with_wishes(shown.solution.brief, room, wishes)
            plan = domains.plan_of(brief)
            solution = replace(shown.solution, brief=brief)
            self.versions.keep(shown.version, f"wishes for {room}", solution, plan)

    def judge(self, poses: Mapping[str, Sequence[float]]) -> list[Json]:
        """What the referee would say if pieces, with all that lies on them, were put there."""
        return [describe_finding(found) for found in self._mover().find_new(poses)]

    def fit(self, piece: str, pose: Sequence[float]) -> Json:
        """The nearest place to a wanted one where the referee has nothing to say of a piece."""
        place = find_nearest_fit(self._mover(), piece, pose)
        return {"pose": None if place is None else [round(number, 4) for number in place]}

    def _mover(self) -> MoveJudge:
        shown = self.versions.must_show()
        if self.mover is None or self.mover.solution is not shown.solution:
            self.mover = MoveJudge(shown.solution, shown.plan)
        return self.mover

    def go(self, version: int) -> None:
        """Show another version: one further back, or one that was undone."""
        with self._turn():
            self.versions.go(version)
        self.tell({"changed": True})

    def undo(self) -> None:
        """Go back to the version that this one was made from."""
        with self.lock:
            self.go(self.versions.find_undo())

    def redo(self) -> None:
        """Go forward again to what was undone last."""
        with self.lock:
            self.go(self.versions.find_redo())

    def shelf(self) -> list[Json]:
        """What can be put in, by the catalog of the brief."""
        return list_shelf(self.versions.must_show().solution.brief) if self.shown else []

    def thumb(self, asset: str) -> bytes:
        """The picture of a model of the shelf."""
        return draw_shelf(self.versions.must_show().solution.brief, asset)

    def export(self, endings: Sequence[str] = ()) -> bytes:
        """The scene in several formats as one zip archive; what cannot be written is told in it."""
        return pack_scene(self.versions.must_show().solution, endings)

    def file(self, ending: str) -> bytes:
        """The scene in one format: its picture from above at an angle, its model."""
        return write_scene(self.versions.must_show().solution, ending)

    def photograph(self, view: View) -> None:
        """Photograph what is shown from a view, in a thread of its own."""
        shown = self.versions.must_show()
        self.photos.begin(shown.solution, shown.plan, view)

    def restyle(self, style: str, palette: str = "") -> Json:
        """Models of a style, and a palette of it, for the whole home; what is locked stays."""
        with self._turn():
            shown = self.versions.must_show()
            solution, changes = change_look(shown.solution, style, palette)
            self.versions.keep(
                shown.version, f"restyled, {style} {palette}".strip(), solution, shown.plan
            )
        return {"changes": changes}

    @contextmanager
    def _turn(self) -> Iterator[None]:
        """One verb at a time, and none while something is arranged."""
        with self.lock:
            if self.running:
                raise BUSY
            yield
