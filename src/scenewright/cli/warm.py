"""Compile beforehand: one small run a kind of scene, kinds side by side in processes of their own.

The compiler works on one thread a process. A kind's run reads a sample, solves it briefly, judges
the answer and draws it, which compiles what the default preset, the referee and the pictures need.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import typer
from rich.console import Console

from scenewright.cli import completion, tables, terminal
from scenewright.core.errors import InputError

OUTPUTS = ("scene.glb", "plan.svg", "picture.png", "solution.json")


PLURALS = {"extend": "extensions"}
"""The plural of a kind of scene, where that is not its name with an s."""


class Warmed(NamedTuple):
    """What compiling one kind took: ``kernels`` compiled now, seconds of compiling and of the
    whole run."""

    kind: str
    kernels: int
    compiling: float
    seconds: float


def check_kinds(kinds: Sequence[str]) -> tuple[str, ...]:
    """The kinds given, each once; all if none is given."""
    from scenewright.workflow.warming import SAMPLES

    for kind in kinds:
        if kind not in SAMPLES:
            raise InputError(f"unknown kind of scene {kind!r}", f"give {', '.join(SAMPLES)}")
    return tuple(dict.fromkeys(kinds)) or tuple(SAMPLES)


def warm_here(kind: str) -> Warmed:
    """Compile one kind in this process."""
    begun = time.perf_counter()
    from scenewright.geometry.compile_clock import compile_clock
    from scenewright.workflow.warming import SAMPLES

    with compile_clock() as clock, tempfile.TemporaryDirectory() as folder:
        for name in SAMPLES[kind]:
            _run_once(kind, name, Path(folder))
    seconds = round(time.perf_counter() - begun, 2)
    return Warmed(kind, clock.kernels, round(clock.seconds, 2), seconds)


def _run_once(kind: str, name: str, folder: Path) -> None:
    from scenewright import formats
    from scenewright.workflow.warming import solve_briefly

    solution = solve_briefly(kind, name)
    for output in OUTPUTS:
        formats.write(solution, folder / output)


def warm_all(kinds: Sequence[str], done: Callable[[Warmed], None]) -> list[Warmed]:
    """Compile several kinds, as many at once as there are processors; ``done`` is called as each
    ends."""
    with ThreadPoolExecutor(min(len(kinds), os.cpu_count() or 1)) as pool:
        waiting = [pool.submit(_warm_there, kind) for kind in reversed(kinds)]
        results = []
        for each in as_completed(waiting):
            results.append(each.result())
            done(results[-1])
    return sorted(results, key=lambda row: kinds.index(row.kind))


def _warm_there(kind: str) -> Warmed:
    """Compile one kind in a process of its own."""
    command = [sys.executable, "-m", "scenewright", "warm", kind, "--json"]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode:
        reason = ended.stderr.strip().rpartition("\n")[2] or f"exit {ended.returncode}"
        raise InputError(f"compiling for {_plural(kind)} failed: {reason}", "run it again")
    return Warmed(**json.loads(ended.stdout)[0])


def run(kinds: Sequence[str], console: Console) -> list[Warmed]:
    """Compile the kinds given, or all, and say of each when it is done."""
    chosen = check_kinds(kinds)
    ended: list[Warmed] = []

    def done(row: Warmed) -> None:
        ended.append(row)
        console.print(f"{tell(row)} ({len(ended)} of {len(chosen)})", highlight=False)

    names = ", ".join(map(_plural, chosen))
    console.print(f"compiling for {names}; once, up to a minute or two", style="dim")
    if len(chosen) > 1:
        return warm_all(chosen, done)
    done(warm_here(chosen[0]))
    return ended


def document(rows: Sequence[Warmed]) -> list[dict[str, Any]]:
    """The rows as plain values."""
    return [row._asdict() for row in rows]


def tell(row: Warmed) -> str:
    """One line on a kind.

    >>> tell(Warmed("home", 31, 19.5, 22.04))
    'homes: 31 kernels compiled, 22.0 s'
    >>> tell(Warmed("extend", 0, 0.0, 1.9))
    'extensions: already compiled, 1.9 s'
    """
    work = f"{row.kernels} kernels compiled" if row.kernels else "already compiled"
    return f"{_plural(row.kind)}: {work}, {row.seconds:.1f} s"


def _plural(kind: str) -> str:
    return PLURALS.get(kind, f"{kind}s")


def warm(
    kinds: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[KIND]...",
            help="home, hall, site, village, extend; or all.",
            autocompletion=completion.domains,
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Compile ahead of time what the first run of each kind of scene needs."""
    rows = run(kinds or (), terminal.console(stderr=True, quiet=quiet or as_json))
    if as_json:
        tables.print_json(document(rows))
    return 0
