"""A format that can be damaged, and how a file of it is used: by a command, else by a function.

Each answers with an exit code: 0 or 1 where the file was accepted, 2 where it was refused.
"""

from __future__ import annotations

import contextlib
import io
import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from benchmarks.damage import Damage, Draw
from benchmarks.damaged_samples import Json


class DamagedFormat(NamedTuple):
    """One format: its name, how many files of 2,000, the suffix, the ``sound`` content (made from
    a folder for spare files), how it is damaged, and how it is ``used`` (path, folder for
    results): an exit code."""

    name: str
    share: int
    suffix: str
    sound: Callable[[Path], bytes]
    damage: Callable[[bytes, Draw, Path], bytes]
    use: Callable[[Path, Path], int]


def given(content: Json) -> Callable[[Path], bytes]:
    data = content if isinstance(content, bytes) else json.dumps(content).encode()
    return lambda _: data


def plain(damage: Damage) -> Callable[[bytes, Draw, Path], bytes]:
    return lambda data, draw, _: damage(data, draw)


def run_quietly(words: Sequence[str]) -> int:
    """The exit code of a command, without what it prints."""
    from scenewright import cli

    with (
        contextlib.redirect_stdout(io.StringIO()),
        contextlib.redirect_stderr(io.StringIO()) as said,
    ):
        code = cli.run(list(words))
    if code == 3:
        raise RuntimeError(said.getvalue()[-300:])
    return code


def arrange_with(steps: int, *options: str) -> Callable[[Path, Path], int]:
    def use(path: Path, folder: Path) -> int:
        out = folder / "out.json"
        words = ["arrange", str(path), "-o", str(out), "--steps", str(steps), *options, "-q"]
        return _written(run_quietly(words), out)

    return use


def _written(code: int, out: Path) -> int:
    """The code, if what was to be written is there just when it should be."""
    there = out.is_file() and out.stat().st_size > 0
    if there != (code in (0, 1)):
        raise RuntimeError(f"exit {code}, and {'something' if there else 'nothing'} written")
    return code


def read_it(path: Path, _: Path) -> int:
    from scenewright import formats

    formats.read_planned(path)
    return 0


def check_it(path: Path, _: Path) -> int:
    run_quietly(["explain", str(path)])
    return run_quietly(["check", str(path)])


def evolve_from(path: Path, folder: Path) -> int:
    out = folder / "out.json"
    code = run_quietly(
        ["evolve", "--from", str(path), "-o", str(out), "--say", "1; next; done", "-q"]
    )
    return _written(code, out)


def arrange_beside(option: str, brief: Json, *more: str) -> Callable[[Path, Path], int]:
    def use(path: Path, folder: Path) -> int:
        source, out = folder / "brief.json", folder / "out.json"
        source.write_text(json.dumps(brief))
        words = ["arrange", str(source), option, str(path), "-o", str(out), *more, "-q"]
        return _written(run_quietly(words), out)

    return use


def show_models(path: Path, folder: Path) -> int:
    code = run_quietly(["catalog", "show", str(path)])
    return code if code else run_quietly(["view", str(path), "-o", str(folder / "view.png")])


def learn_groups(path: Path, folder: Path) -> int:
    return run_quietly(["catalog", "learn", str(path), "-o", str(folder / "groups.json")])


def learn_blocks(path: Path, _: Path) -> int:
    from scenewright.domains.village.learning.real_blocks import read_blocks
    from scenewright.domains.village.learning.tables import learn_manner, learn_mix

    blocks = read_blocks(path)
    if blocks:
        learn_manner(blocks)
        learn_mix(blocks)
    return 0


def read_corrections(path: Path, _: Path) -> int:
    from scenewright.catalog.models.listing import table_of

    table_of(path)
    return 0


def resume(path: Path, _: Path) -> int:
    from scenewright.domains.village.learning.interrupted_run import resume_training
    from scenewright.domains.village.learning.pose_training import start_training

    _state, seconds = resume_training(path, "key", start_training(0))
    return 0 if seconds else 2


def plan_it(path: Path, folder: Path, *options: str) -> int:
    out = folder / "out.json"
    return _written(run_quietly(["plan", str(path), "-o", str(out), *options, "-q"]), out)


def plan_site(path: Path, folder: Path) -> int:
    return plan_it(path, folder, "--site", "11.571,48.141")
