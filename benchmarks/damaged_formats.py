"""What can be damaged: every stored format and every reader, with sound files and how each is used.

A format makes a sound file by name, damages it by a draw and uses it as a person would: by the
command line where that is quick, else by the function behind it. Using answers with an exit code:
0 or 1 where the file was accepted, 2 where it was refused.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
from collections.abc import Callable, Sequence
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.damage import (
    Damage,
    Draw,
    damage_arrays,
    damage_bytes,
    damage_database,
    damage_json,
    damage_text,
    damage_zip,
    zipped,
)
from benchmarks.damaged_maps import MAPS, sound_map
from benchmarks.damaged_samples import (
    BLOCKS,
    CITY,
    CORRECTIONS,
    GROUPS,
    HALL,
    HOME,
    INDOOR,
    LAND,
    OBJ,
    SITE,
    TABLE,
    VILLAGE,
    XML,
    Json,
)


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


def _arrange(steps: int, *options: str) -> Callable[[Path, Path], int]:
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


def _read(path: Path, _: Path) -> int:
    from scenewright import formats

    formats.read_planned(path)
    return 0


def _check(path: Path, _: Path) -> int:
    run_quietly(["explain", str(path)])
    return run_quietly(["check", str(path)])


def _evolve(path: Path, folder: Path) -> int:
    out = folder / "out.json"
    code = run_quietly(
        ["evolve", "--from", str(path), "-o", str(out), "--say", "1; next; done", "-q"]
    )
    return _written(code, out)


def _with(option: str, brief: Json, *more: str) -> Callable[[Path, Path], int]:
    def use(path: Path, folder: Path) -> int:
        source, out = folder / "brief.json", folder / "out.json"
        source.write_text(json.dumps(brief))
        words = ["arrange", str(source), option, str(path), "-o", str(out), *more, "-q"]
        return _written(run_quietly(words), out)

    return use


def _models(path: Path, folder: Path) -> int:
    code = run_quietly(["catalog", "show", str(path)])
    return code if code else run_quietly(["view", str(path), "-o", str(folder / "view.png")])


def _learn_groups(path: Path, folder: Path) -> int:
    return run_quietly(["catalog", "learn", str(path), "-o", str(folder / "groups.json")])


def _learn_blocks(path: Path, _: Path) -> int:
    from scenewright.domains.village.learning.real_blocks import read_blocks
    from scenewright.domains.village.learning.tables import learn_manner, learn_mix

    blocks = read_blocks(path)
    if blocks:
        learn_manner(blocks)
        learn_mix(blocks)
    return 0


def _corrections(path: Path, _: Path) -> int:
    from scenewright.catalog.models.listing import table_of

    table_of(path)
    return 0


def _training(path: Path, _: Path) -> int:
    from scenewright.domains.village.learning.interrupted_run import resume_training
    from scenewright.domains.village.learning.pose_training import start_training

    _state, seconds = resume_training(path, "key", start_training(0))
    return 0 if seconds else 2


def _ledger(path: Path, folder: Path) -> int:
    from scenewright.batch.jobs import BatchOptions, Job
    from scenewright.batch.ledger import NAME, Ledger
    from scenewright.batch.table import write_summary

    home = folder / "batch"
    home.mkdir()
    if os.path.lexists(path):
        path.rename(home / NAME)
    _results(home)
    with Ledger(home) as ledger:
        jobs = [Job(f"{k}.json", str(k), (home / f"{k}.json",), f"key{k}") for k in range(3)]
        rows = [row for job in jobs if (row := ledger.find(job)) is not None]
        for job in jobs:
            ledger.write(job, _row(job))
    write_summary(home, rows, BatchOptions((".json",), "default", None, None, None, 0, False))
    return 0 if len(rows) == 3 else 1


def _row(job: Any) -> Any:
    from scenewright.batch.table import COMPLETE, ResultRow

    return ResultRow(job.source, COMPLETE, 0.5, 3, 0, 0, "", tuple(map(str, job.outputs)))


def _results(home: Path) -> None:
    for k in range(3):
        (home / f"{k}.json").write_text(f"result {k}")


def _sound_ledger(folder: Path) -> bytes:
    from scenewright.batch.jobs import Job
    from scenewright.batch.ledger import NAME, Ledger

    home = folder / "sound"
    home.mkdir()
    _results(home)
    with Ledger(home) as ledger:
        for k in range(3):
            job = Job(f"{k}.json", str(k), (home / f"{k}.json",), f"key{k}")
            ledger.write(job, _row(job))
    return (home / NAME).read_bytes()


def _sound_log(folder: Path) -> bytes:
    from scenewright.core.brief import Brief
    from scenewright.engine.preference.events import Pick, Stars
    from scenewright.workflow.evolution.population import BreedingPlan
    from scenewright.workflow.evolve import evolve

    path = folder / "sound.evolution"
    few = BreedingPlan(first=4, each=2, rounds=1, brood=4)
    with evolve(Brief.model_validate(HOME), path, breeding=few) as evolution:
        shown = tuple(one.number for one in evolution.ask().candidates)
        evolution.tell(Pick(shown[1], shown), Stars(shown[0], 4, 0))
        evolution.ask()
    return path.read_bytes()


@cache
def _solution() -> Any:
    from scenewright.core.brief import Brief
    from scenewright.domains import solve

    return solve(Brief.model_validate(HOME), steps=50, threads=1)


def _sound_solution(_: Path) -> bytes:
    from scenewright.formats import solution_json

    return solution_json.dumps(_solution()).encode()


def _sound_glb(folder: Path) -> bytes:
    from scenewright import formats

    formats.write(_solution(), folder / "sound.glb")
    return (folder / "sound.glb").read_bytes()


def _sound_plan(suffix: str) -> Callable[[Path], bytes]:
    def sound(folder: Path) -> bytes:
        from scenewright import formats

        formats.write(_solution(), folder / f"sound.{suffix}")
        return (folder / f"sound.{suffix}").read_bytes()

    return sound


def _plan(path: Path, folder: Path, *options: str) -> int:
    out = folder / "out.json"
    return _written(run_quietly(["plan", str(path), "-o", str(out), *options, "-q"]), out)


def _plan_site(path: Path, folder: Path) -> int:
    return _plan(path, folder, "--site", "11.571,48.141")


def _sound_style(_: Path) -> bytes:
    return files("scenewright.domains.village.learned").joinpath("europe.npz").read_bytes()


def _sound_training(folder: Path) -> bytes:
    from scenewright.domains.village.learning.interrupted_run import save_training
    from scenewright.domains.village.learning.pose_training import start_training

    save_training(folder / "sound.npz", "key", start_training(0)._replace(losses=(1.0,)), 2.0)
    return (folder / "sound.npz").read_bytes()


def _sample(domain: str, name: str) -> Callable[[Path], bytes]:
    place = files(f"scenewright.domains.{domain}").joinpath("samples", f"{name}.json")
    return lambda _: place.read_bytes()


def _given(content: Json) -> Callable[[Path], bytes]:
    data = content if isinstance(content, bytes) else json.dumps(content).encode()
    return lambda _: data


def _plain(damage: Damage) -> Callable[[bytes, Draw, Path], bytes]:
    return lambda data, draw, _: damage(data, draw)


LIBRARY = zipped(
    {"PluginFurnitureCatalog.properties": TABLE.encode(), "kit/table.obj": OBJ.encode()}
)
SHORT = ("--steps", "10")
FORMATS: tuple[DamagedFormat, ...] = (
    DamagedFormat("evolution logs", 250, "", _sound_log, damage_database, _evolve),
    DamagedFormat("ledgers", 150, "", _sound_ledger, _plain(damage_text), _ledger),
    DamagedFormat(
        "styles",
        220,
        ".npz",
        _sound_style,
        _plain(damage_arrays),
        _with("--style", VILLAGE, "--layouts", "1"),
    ),
    DamagedFormat("trainings", 50, ".npz", _sound_training, _plain(damage_arrays), _training),
    DamagedFormat(
        "groups", 150, ".json", _given(GROUPS), _plain(damage_json), _with("--groups", HOME, *SHORT)
    ),
    DamagedFormat("solutions", 180, ".json", _sound_solution, _plain(damage_json), _check),
    DamagedFormat(
        "solutions again", 60, ".json", _sound_solution, _plain(damage_json), _arrange(10)
    ),
    DamagedFormat("homes", 120, ".json", _given(HOME), _plain(damage_json), _arrange(10)),
    DamagedFormat("halls", 60, ".json", _given(HALL), _plain(damage_json), _arrange(10)),
    DamagedFormat("sites", 60, ".json", _given(SITE), _plain(damage_json), _arrange(10)),
    DamagedFormat(
        "villages", 40, ".json", _sample("village", "village-hamlet"), _plain(damage_json), _read
    ),
    DamagedFormat(
        "extensions", 40, ".json", _sample("extend", "extend-village"), _plain(damage_json), _read
    ),
    DamagedFormat(
        "sweet homes",
        90,
        ".sh3d",
        _given(zipped({"Home.xml": XML.encode()})),
        _plain(damage_zip(damage_text)),
        _arrange(10, "--keep"),
    ),
    DamagedFormat("home XML", 60, ".xml", _given(XML.encode()), _plain(damage_text), _arrange(10)),
    DamagedFormat("indoor maps", 70, ".geojson", _given(INDOOR), _plain(damage_json), _arrange(10)),
    DamagedFormat("maps", 70, ".geojson", _given(LAND), _plain(damage_json), _arrange(10)),
    *(
        DamagedFormat(
            f"maps as {suffix}", 25, suffix, sound_map(suffix), _plain(damage), _plan_site
        )
        for suffix, damage in MAPS.items()
    ),
    DamagedFormat("city sites", 60, ".city.json", _given(CITY), _plain(damage_json), _arrange(10)),
    DamagedFormat("city models", 40, ".cityjson", _given(CITY), _plain(damage_json), _models),
    DamagedFormat("IFC models", 60, ".ifc", _sound_plan("ifc"), _plain(damage_text), _plan),
    DamagedFormat("GLB", 70, ".glb", _sound_glb, _plain(damage_bytes), _models),
    DamagedFormat("DXF plans", 60, ".dxf", _sound_plan("dxf"), _plain(damage_text), _plan),
    DamagedFormat("SVG plans", 60, ".svg", _sound_plan("svg"), _plain(damage_text), _plan),
    DamagedFormat("PDF plans", 60, ".pdf", _sound_plan("pdf"), _plain(damage_bytes), _plan),
    DamagedFormat("OBJ", 30, ".obj", _given(OBJ.encode()), _plain(damage_text), _models),
    DamagedFormat(
        "libraries", 40, ".sh3f", _given(LIBRARY), _plain(damage_zip(damage_text)), _models
    ),
    DamagedFormat(
        "corrections", 20, ".csv", _given(CORRECTIONS.encode()), _plain(damage_text), _corrections
    ),
    DamagedFormat(
        "blocks to learn", 30, ".json", _given(BLOCKS), _plain(damage_json), _learn_blocks
    ),
    DamagedFormat(
        "homes to learn",
        40,
        ".sh3d",
        _given(zipped({"Home.xml": XML.encode()})),
        _plain(damage_zip(damage_text)),
        _learn_groups,
    ),
)
"""Every format but plug-ins, and how many of some 2,000 files are of it."""
