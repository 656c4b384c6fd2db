"""A scene under work in Python: edits by name, each a version of its project; undo and redo."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from threading import RLock
from typing import Any

from scenewright.core.edits import Adjusted, Change
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains import adjust, check, plan_of
from scenewright.formats import solution_json
from scenewright.workflow import project
from scenewright.workflow.accepting import accept_findings_by_hand
from scenewright.workflow.editing import edit_pieces

BY_PLACE = ("move", "swap", "lock", "unlock", "again")
BY_PIECE = ("remove", "exchange", "resize", "restyle", "duplicate", "add")
BY_FINDING = ("accept",)
EDITS = BY_PLACE + BY_PIECE + BY_FINDING
"""Verbs by what does them: :func:`scenewright.domains.adjust`, :func:`scenewright.edit_pieces`, and
:func:`.accepting.accept_findings_by_hand`."""
IN_MEMORY = Path(":memory:")


class Project:
    """The versions of one scene in a file, or in memory: nothing is overwritten, what returns is on
    disk, and any thread may use it, one at a time.

    >>> import scenewright as sw
    >>> work = Project()
    >>> room = work.begin(sw.solve(sw.read("sample:home-room"), steps=200))
    >>> changed = work.edit(remove=["wardrobe"])
    >>> work.mark(4, "airy"), [mark["stars"] for mark in work.marks()], work.report()["complete"]
    (None, [4], True)
    >>> work.undo().pieces == room.pieces
    True
    """

    def __init__(self, path: Path | str = IN_MEMORY, who: str = "") -> None:
        self._db, self.who, self._lock = project.open_project(Path(path)), who, RLock()

    def begin(self, solution: Solution) -> Solution:
        """Begin with a solution."""
        with self._lock:
            self._add(0, "began", Adjusted(solution, ()), "")
        return solution

    @property
    def solution(self) -> Solution:
        """The version shown; InputError where there is none yet."""
        return self._shown()[1]

    def edit(self, seed: int | None = None, **edits: Any) -> Adjusted:
        """Change the scene by verbs of :func:`scenewright.domains.adjust` (move, swap, lock,
        unlock, again), :func:`scenewright.edit_pieces` (remove, exchange, resize, restyle,
        duplicate, add) and ``accept`` (findings, with a reason each), all as one step;
        InputError, and nothing is kept, where one cannot be."""
        with self._lock:
            number, before = self._shown()
            done = change_scene(before, edits, seed=seed)
            self._add(number, name_edits(edits), done, dump_edits(edits, seed))
        return done

    def undo(self) -> Solution:
        """Show the version that this one was made from."""
        with self._lock:
            parent = self._must_show().parent
            if not parent:
                raise InputError("there is nothing to undo", "change something first")
            return self._go(parent)

    def redo(self) -> Solution:
        """Show again what was undone last."""
        with self._lock:
            following = project.next_version(self._db, self._must_show().id)
            if not following:
                raise InputError("there is nothing to redo", "undo something first")
            return self._go(following)

    def history(self) -> list[tuple[project.Version, project.Act | None]]:
        """All versions in the order in which they were made, and how each came about."""
        with self._lock:
            acts = {act.version: act for act in project.list_acts(self._db)}
            return [(row, acts.get(row.id)) for row in project.list_versions(self._db)]

    def report(self, version: int = 0) -> dict[str, Any]:
        """What the referee said of a version, or of the one shown, as
        :meth:`scenewright.Report.to_dict` tells it."""
        return dict(self._said(project.REPORT, version, {}))

    def reasons(self, version: int = 0) -> list[Change]:
        """What changed by the edit that made a version, or the one shown, and why."""
        return [Change(**row) for row in self._said(project.WHY, version, [])]

    def mark(self, stars: int | None = None, words: str = "") -> None:
        """Say what one thinks of the version shown: one to five ``stars``, or ``words``."""
        if (stars is not None and stars not in range(1, 6)) or (stars is None and not words):
            raise InputError("says nothing", "give one to five stars, or words")
        body = json.dumps({"stars": stars, "words": words}, ensure_ascii=False)
        with self._lock:
            shown = self._must_show().id
            project.add_entry(self._db, shown, project.MARK_MADE, body, self.who)

    def marks(self) -> list[dict[str, Any]]:
        """All marks in the order in which they were made: of which version, by whom and when
        (seconds since 1970), stars and words."""
        with self._lock:
            rows = project.list_entries(self._db, project.MARK_MADE)
        about = [{"version": row.version, "who": row.who, "at": row.at} for row in rows]
        return [one | json.loads(row.body) for one, row in zip(about, rows, strict=True)]

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._db.close()

    def _must_show(self) -> project.Version:
        version = project.shown_version(self._db)
        if version is None:
            raise InputError("the project is empty", "begin with a solution")
        return version

    def _shown(self) -> tuple[int, Solution]:
        with self._lock:
            number = self._must_show().id
            return number, self._load(number)

    def _load(self, number: int) -> Solution:
        return solution_json.loads(project.solution_text(self._db, number))

    def _go(self, number: int) -> Solution:
        solution = self._load(number)
        project.show_version(self._db, number)
        return solution

    def _add(self, parent: int, what: str, done: Adjusted, edit: str) -> None:
        text = solution_json.dumps(done.solution)
        report = check(done.solution, figures=False)
        entries = describe_result(report, done.changes)
        project.add_version(self._db, parent, what, text, who=self.who, edit=edit, entries=entries)

    def _said(self, kind: str, version: int, otherwise: Any) -> Any:
        """What is said last of a version, or of the one shown."""
        with self._lock:
            found = project.list_entries(self._db, kind, version or self._must_show().id)
        return json.loads(found[-1].body) if found else otherwise


def describe_result(report: Report, changes: Sequence[Change] = ()) -> dict[str, str]:
    """The entries of a version: what the referee says of it, and why what changed."""
    rows = [change._asdict() for change in changes]
    return {
        project.REPORT: json.dumps(report.to_dict(), ensure_ascii=False),
        project.WHY: json.dumps(rows, ensure_ascii=False),
    }


def change_scene(
    before: Solution,
    edits: Mapping[str, Any],
    *,
    plan: Plan | None = None,
    steps: int | None = None,
    seed: int | None = None,
) -> Adjusted:
    """A scene after edits by name: those of :func:`scenewright.domains.adjust` first, with its
    ``steps`` and ``seed``, then those of :func:`scenewright.edit_pieces`, then what is accepted of
    the answer. InputError for others."""
    strange = [name for name in edits if name not in EDITS]
    if strange:
        raise InputError(f"unknown edit '{strange[0]}'", f"use one of: {', '.join(EDITS)}")
    plan = plan or plan_of(before.brief)
    by_place, *others = (
        {name: edits[name] for name in names if edits.get(name)}
        for names in (BY_PLACE, BY_PIECE, BY_FINDING)
    )
    done = Adjusted(before, ())
    if by_place or not any(others):
        done = adjust(before, plan=plan, steps=steps, seed=seed, **by_place)
    verbs: tuple[Callable[..., Adjusted], ...] = (edit_pieces, accept_findings_by_hand)
    for change, asked in zip(verbs, others, strict=True):
        if asked:
            after = done.solution
            plan = plan if after.brief is before.brief else plan_of(after.brief)
            more = change(after, plan=plan, **asked)
            done = Adjusted(more.solution, (*done.changes, *more.changes))
    return done


def name_edits(edits: Mapping[str, Any]) -> str:
    """What was done, for the history.

    >>> name_edits({"remove": ["living/sofa"], "move": {"bed": (1.0, 2.0)}})
    'remove living/sofa, move bed'
    """
    return ", ".join(f"{verb} {' '.join(map(_name, asked))}" for verb, asked in edits.items())


def dump_edits(edits: Mapping[str, Any], seed: int | None = None) -> str:
    """Edits by name, and the seed they were made with, as JSON.

    >>> dump_edits({"remove": ["living/sofa"]}, 3)
    '{"remove": ["living/sofa"], "seed": 3}'
    """
    asked = edits if seed is None else {**edits, "seed": seed}
    return json.dumps(asked, default=_plain)


def _name(asked: Any) -> str:
    return str(getattr(asked, "asset", asked))


def _plain(value: Any) -> Any:
    return value._asdict() if hasattr(value, "_asdict") else str(value)
