"""Projects: any verbs and as many undos are the start; threads; what survives a kill."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from contextlib import closing
from pathlib import Path
from threading import Thread

import pytest

import scenewright as sw
from scenewright import cli
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.formats import solution_json
from scenewright.workflow import project
from scenewright.workflow.scene_project import Project
from thoroughness import few_or_many

SCENES = {
    "home-room": 200,
    "hall-shop": 1500,
    "site-30": 100,
    "village-hamlet": 1,
    "extend-village": 1,
}


def scene_of(name: str) -> Solution:
    preset = "quick" if name.startswith("extend") else "default"
    return sw.solve(sw.read(f"sample:{name}"), steps=SCENES[name], preset=preset)


def draw_edit(solution: Solution, rng: random.Random) -> dict[str, object]:
    """Any verb, on any piece."""
    pieces = [p for p in solution.pieces if p.on is None and not p.group.endswith("/green")]
    one, other = rng.sample(pieces, 2)
    to = (one.pose.x + rng.uniform(-1, 1), one.pose.y + rng.uniform(-1, 1), rng.uniform(-3, 3))
    return rng.choice(
        [
            {"move": {one.id: to[:2]}},
            {"move": {one.id: to}},
            {"swap": [(one.id, other.id)]},
            {"lock": [one.id]},
            {"unlock": [one.id]},
            {"remove": [one.id]},
            {"duplicate": [one.id]},
            {"exchange": {one.id: other.asset or other.function}},
            {"resize": {one.id: (*one.size[:2], one.size.height * 0.99)}},
            {"add": [sw.Addition(one.asset or one.function, *to[:2])]},
        ]
    )


@pytest.mark.parametrize("name", SCENES)
def test_any_verbs_and_as_many_undos_are_the_start(name: str) -> None:
    work, rng = Project(), random.Random(name)
    start = solution_json.dumps(work.begin(scene_of(name)))
    made = []
    for _ in range(few_or_many(12, 60)):
        before = solution_json.dumps(work.solution)
        try:
            work.edit(**draw_edit(work.solution, rng))
        except InputError:
            assert solution_json.dumps(work.solution) == before
        else:
            made.append(solution_json.dumps(work.solution))
    assert len(made) > 2
    for text in (*made[-2::-1], start):
        assert solution_json.dumps(work.undo()) == text
    with pytest.raises(InputError, match="nothing to undo"):
        work.undo()
    for text in made:
        assert solution_json.dumps(work.redo()) == text


def test_threads_share_a_project_and_each_edit_is_kept_with_who_and_what(tmp_path: Path) -> None:
    work = Project(tmp_path / "room.studio", who="ann")
    work.begin(scene_of("home-room"))
    names = [p.id for p in work.solution.pieces if p.on is None][:4]
    threads = [Thread(target=work.edit, kwargs={"lock": [name]}) for name in names]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    locked = {p.id for p in work.solution.pieces if p.fixed}
    assert {*names} <= locked
    work.mark(5, "as it was")
    with pytest.raises(InputError, match="says nothing"):
        work.mark(6)
    assert [(m["who"], m["stars"], m["version"]) for m in work.marks()] == [("ann", 5, 5)]
    assert all(work.report(number)["findings"] is not None for number in range(1, 6))
    acts = [act for _, act in work.history() if act]
    assert {act.who for act in acts} == {"ann"}
    assert sorted(act.edit for act in acts)[1:] == sorted(f'{{"lock": ["{n}"]}}' for n in names)
    work.close()
    with closing(project.open_project(tmp_path / "room.studio")) as db:
        assert len(project.list_versions(db)) == 5


def test_adjust_changes_a_project_and_adds_a_version(tmp_path: Path) -> None:
    path = tmp_path / "room.studio"
    work = Project(path)
    work.begin(scene_of("home-room"))
    bed = next(p for p in work.solution.pieces if p.category == "single_bed")
    out = tmp_path / "out.json"
    assert cli.run(["adjust", str(path), "-o", str(out), "--lock", bed.id, "-q"]) in (0, 1)
    assert next(p for p in work.solution.pieces if p.id == bed.id).fixed
    assert [row.what for row, _ in work.history()] == ["began", f"lock {bed.id}"]
    assert work.report()["valid"]
    assert solution_json.read(out).pieces == work.solution.pieces
    desk = next(p for p in work.solution.pieces if p.category == "desk")
    work.edit(remove=[desk.id])
    assert [(one.piece, one.change) for one in work.reasons()][:1] == [(desk.id, "gone")]
    assert work.reasons(1) == []


KILLED = """
import sys
from pathlib import Path
from scenewright.workflow import project
db = project.open_project(Path(sys.argv[1]))
shown = project.shown_version(db)
number = shown.id if shown else 0
while True:
    number = project.add_version(db, number, "step", str(number) * 2000, edit="{}")
    print(number, flush=True)
"""


def test_killed_at_any_moment_nothing_acknowledged_is_lost(tmp_path: Path) -> None:
    path, rng, told = tmp_path / "killed.studio", random.Random(7), [0]
    for _ in range(few_or_many(6, 200)):
        command = [sys.executable, "-c", KILLED, str(path)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as worker:
            assert worker.stdout is not None
            told.append(int(worker.stdout.readline()))
            time.sleep(rng.uniform(0, 0.05))
            os.kill(worker.pid, signal.SIGKILL)
            told += [int(line) for line in worker.stdout.read().splitlines() if line]
        with closing(project.open_project(path)) as db:
            rows = project.list_versions(db)
            assert {row.id for row in rows} >= {*told[1:]}
            assert [act.version for act in project.list_acts(db)] == [row.id for row in rows]
            shown = project.shown_version(db)
            assert shown == rows[-1]
            assert project.solution_text(db, rows[-1].id) == str(rows[-1].parent) * 2000
