"""The version of a project that is shown: a scene, or a drawn plan; kept, loaded, gone back to."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable, Sequence
from typing import NamedTuple

from scenewright import domains
from scenewright.core.edits import Change
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution, unfurnished
from scenewright.formats import solution_json
from scenewright.studio.draft_faults import DraftFault, read_draft
from scenewright.studio.drafting import FORMAT, complete_draft
from scenewright.studio.people import AUTHOR
from scenewright.studio.shapes import Json
from scenewright.workflow import project
from scenewright.workflow.scene_project import describe_result


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


class Versions:
    """What is shown of a project; ``changed`` is called when that is another version. Whoever calls
    it sees to it that nobody else does meanwhile."""

    def __init__(self, db: sqlite3.Connection, changed: Callable[[], None]) -> None:
        self.db, self.changed = db, changed
        self.shown: Shown | None = None
        self.drawn: Drawn | None = None
        if self.number:
            self.load(self.number)

    @property
    def number(self) -> int:
        """The version that is shown; 0 while there is none."""
        version = project.shown_version(self.db)
        return version.id if version is not None else 0

    def must_show(self) -> Shown:
        """What is shown, if it can be furnished; InputError otherwise."""
        if self.shown is None:
            faults = [one.message for one in self.drawn.faults] if self.drawn else []
            fault = f"the plan is not ready: {faults[0]}" if faults else "nothing is drawn or open"
            raise InputError(fault, "mend it first" if faults else "open or draw a plan first")
        return self.shown

    def describe(self) -> Json:
        """Which version is shown, and those before and after it."""
        version = project.shown_version(self.db)
        if version is None:
            return {"version": 0, "history": []}
        steps = [row._asdict() for row in project.list_versions(self.db)]
        redo = project.next_version(self.db, version.id)
        return {"version": version.id, "history": steps, "undo": version.parent, "redo": redo}

    def keep(
        self,
        parent: int,
        what: str,
        solution: Solution,
        plan: Plan,
        changes: Sequence[Change] = (),
        edit: str = "",
    ) -> None:
        """Add a scene as a version below another one, and show it."""
        report = domains.check(solution, plan=plan, figures=False)
        text, said = solution_json.dumps(solution), describe_result(report, changes)
        number = project.add_version(
            self.db, parent, _by(what), text, who=AUTHOR.get(), edit=edit, entries=said
        )
        self.shown = Shown(number, solution, plan, report)
        self.drawn = self.drawn if parent else None
        self.changed()

    def keep_draft(self, parent: int, what: str, draft: Json) -> None:
        """Add a drawn plan as a version below another one, and show it."""
        number = project.add_version(self.db, parent, _by(what), json.dumps(draft))
        self._show_draft(number, draft)
        self.changed()

    def load(self, version: int) -> None:
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

    def go(self, version: int) -> None:
        """Show a version, and begin with it when the project is opened again."""
        self.load(version)
        project.show_version(self.db, version)

    def find_undo(self) -> int:
        """The version that this one was made from; InputError if there is none."""
        version = project.shown_version(self.db)
        if version is None or not version.parent:
            raise InputError("there is nothing to undo", "change something first")
        return version.parent

    def find_redo(self) -> int:
        """What was undone last; InputError if nothing was."""
        following = project.next_version(self.db, self.number) if self.number else 0
        if not following:
            raise InputError("there is nothing to redo", "undo something first")
        return following

    def _show_draft(self, number: int, draft: Json) -> None:
        brief, plan, faults = read_draft(draft)
        self.drawn, self.shown = Drawn(draft, faults), None
        if brief is not None and plan is not None:
            empty = unfurnished(brief)
            self.shown = Shown(number, empty, plan, domains.check(empty, plan=plan, figures=False))


def _by(what: str) -> str:
    """What was done, with the name of who did it if that was a guest."""
    author = AUTHOR.get()
    return f"{author}: {what}" if author else what


def _is_draft(text: str) -> bool:
    return text.startswith(f'{{"format": "{FORMAT}"')
