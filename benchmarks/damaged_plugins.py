"""Broken plug-ins: packages whose entry points cannot be loaded, are no rows, or fail when used.

Each is installed in a folder of its own that a new process finds first. A plug-in that is broken
is named in one line and left out; one that fails when it is used ends the run with one line that
names it.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from benchmarks.damaged_runs import DamagedRun

BROKEN_ROWS = {
    "missing module": "nowhere:ROW",
    "missing name": "broken:NOWHERE",
    "no name": "broken",
    "syntax": "syntax:ROW",
    "raises": "raising:ROW",
    "exits": "leaving:ROW",
    "interrupts": "interrupting:ROW",
    "recursion": "deep:ROW",
    "a number": "broken:NUMBER",
    "a text": "broken:TEXT",
    "a function": "broken:function",
    "a module": "broken:os",
}
"""Values of entry points that name nothing that can be used."""
GROUPS = {
    "scenewright.terms": "home.broken",
    "scenewright.solvers": "home.broken",
    "scenewright.patterns": "hall.broken",
    "scenewright.kinds": "broken",
    "scenewright.domains": "broken",
    "scenewright.formats": ".broken",
}
MODULES = {
    "broken": (
        "import os\nNUMBER, TEXT = 7, 'text'\ndef function(*a, **k):\n    raise OSError('odd')\n"
    ),
    "syntax": "def\n",
    "raising": "raise ZeroDivisionError('by hand')\n",
    "leaving": "import sys\nsys.exit(5)\n",
    "interrupting": "raise KeyboardInterrupt\n",
    "deep": "def f():\n    return f()\nROW = f()\n",
    "failing": (
        "from scenewright.engine.rows import SolverRow\n"
        "ROW = SolverRow('failing', 'fails', 'x', 'failing:run')\n"
        "def run(*a, **k):\n    raise ZeroDivisionError('while it runs')\n"
        "def read(path, keep=False):\n    raise KeyError('while it reads')\n"
        "def write(solution, path):\n    raise IndexError('while it writes')\n"
    ),
    "silent": "def write(solution, path):\n    pass\ndef read(path, keep=False):\n    return 7\n",
    "kinds": (
        "from scenewright.core.kind import Kind\n"
        "TWICE = (Kind('sofa'),)\nODD = (Kind('fine'), 7)\n"
        "WORDS = (Kind('x', words=7),)\n"
    ),
}


class BrokenPlugin(NamedTuple):
    """A plug-in: its name, its entry points, the command that meets it, and whether it ought to be
    left out (exit 0 or 1, named on the standard error) or may end the run (exit 2)."""

    name: str
    entries: str
    words: tuple[str, ...]
    left_out: bool = True


def list_plugins() -> tuple[BrokenPlugin, ...]:
    """All broken plug-ins."""
    found = [
        BrokenPlugin(f"{group} {name}", f"[{group}]\n{entry} = {value}\n", ("list", _listed(group)))
        for group, entry in GROUPS.items()
        for name, value in BROKEN_ROWS.items()
        if not (group == "scenewright.formats" and ":" in value and "nowhere" not in value)
    ]
    home, formats = "sample:home-room", "[scenewright.formats]\n"
    solver = "[scenewright.solvers]\nhome.failing = failing:ROW\n"
    steps = ("--steps", "20", "-q")
    return (
        *found,
        BrokenPlugin("kinds twice", "[scenewright.kinds]\nx = kinds:TWICE\n", ("list", "assets")),
        BrokenPlugin("kinds odd", "[scenewright.kinds]\nx = kinds:ODD\n", ("list", "assets")),
        BrokenPlugin("kinds words", "[scenewright.kinds]\nx = kinds:WORDS\n", ("list", "assets")),
        BrokenPlugin("format raises", formats + ".odd = raising\n", ("list", "formats")),
        BrokenPlugin("format exits", formats + ".odd = leaving\n", ("list", "formats")),
        BrokenPlugin("format syntax", formats + ".odd = syntax\n", ("list", "formats")),
        BrokenPlugin("format without dot", formats + "odd = silent\n", ("list", "formats")),
        BrokenPlugin(
            "solver fails",
            solver,
            ("arrange", home, "-o", "x.json", "--solver", "failing", *steps),
            False,
        ),
        BrokenPlugin(
            "writer fails",
            formats + ".odd = failing\n",
            ("arrange", home, "-o", "x.odd", *steps),
            False,
        ),
        BrokenPlugin(
            "writer silent",
            formats + ".odd = silent\n",
            ("arrange", home, "-o", "x.odd", *steps),
            False,
        ),
        BrokenPlugin(
            "reader fails",
            formats + ".odd = failing\n",
            ("arrange", "in.odd", "-o", "x.json"),
            False,
        ),
        BrokenPlugin(
            "reader odd", formats + ".odd = silent\n", ("arrange", "in.odd", "-o", "x.json"), False
        ),
    )


def _listed(group: str) -> str:
    """What to list to meet a group."""
    name = group.partition(".")[2]
    return {"kinds": "assets", "domains": "samples"}.get(name, name)


def run_plugins(spare: Path, quick: bool) -> Iterator[DamagedRun]:
    """What each broken plug-in led to."""
    for number, one in enumerate(list_plugins()):
        if quick and number % 8:
            continue
        folder = spare / f"plugin-{number}"
        run = run_plugin(one, folder)
        if run.outcome in ("error", "hang"):
            print(f"plug-in {one.name}: {run}", flush=True)
        yield run


def run_plugin(one: BrokenPlugin, folder: Path) -> DamagedRun:
    """Meet one plug-in in a new process."""
    folder.mkdir()
    for name, text in MODULES.items():
        (folder / f"{name}.py").write_text(text)
    (folder / "in.odd").write_text("x")
    info = folder / "broken_plugin-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: broken-plugin\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(one.entries)
    path = os.pathsep.join([str(folder), *filter(None, [os.environ.get("PYTHONPATH")])])
    command = [sys.executable, "-m", "scenewright", *one.words]
    try:
        done = subprocess.run(
            command, cwd=folder, env=os.environ | {"PYTHONPATH": path},
            capture_output=True, text=True, timeout=600, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return DamagedRun("hang", 600.0, 0.0, "")
    said = done.stderr.strip()
    named = "broken" in said or "odd" in said or "failing" in said or "entry point" in said
    wanted = (0, 1) if one.left_out else (2,)
    lines = said.splitlines()
    fine = done.returncode in wanted and named and len(lines) <= 2
    nothing = not list(folder.glob("x.*"))
    if not fine or not (one.left_out or nothing):
        return DamagedRun("error", 0.0, 0.0, f"exit {done.returncode}: {said[-300:]}")
    return DamagedRun("accepted" if one.left_out else "refused", 0.0, 0.0, "")
