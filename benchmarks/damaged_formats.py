"""What can be damaged: every stored format and every reader, with sound files and how each is used.

A format makes a sound file by name, damages it by a draw and uses it as a person would: by the
command line where that is quick, else by the function behind it. Using answers with an exit code:
0 or 1 where the file was accepted, 2 where it was refused.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any

from benchmarks.damage import (
    damage_arrays,
    damage_bytes,
    damage_database,
    damage_json,
    damage_text,
    damage_zip,
    zipped,
)
from benchmarks.damage_structure import damage_lines
from benchmarks.damaged_maps import MAP_FORMATS
from benchmarks.damaged_plans import PLAN_FORMATS, solution, written
from benchmarks.damaged_samples import (
    BLOCKS,
    CITY,
    CORRECTIONS,
    GLTF,
    GROUPS,
    HALL,
    HOME,
    OBJ,
    SITE,
    STL,
    TABLE,
    VILLAGE,
)
from benchmarks.damaged_uses import (
    DamagedFormat,
    arrange_beside,
    arrange_with,
    check_it,
    evolve_from,
    given,
    learn_blocks,
    plain,
    read_corrections,
    read_it,
    resume,
    show_models,
)


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


def _sound_solution(_: Path) -> bytes:
    from scenewright.formats import solution_json

    return solution_json.dumps(solution()).encode()


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


LIBRARY = zipped(
    {"PluginFurnitureCatalog.properties": TABLE.encode(), "kit/table.obj": OBJ.encode()}
)
SHORT = ("--steps", "10")
FORMATS: tuple[DamagedFormat, ...] = (
    *MAP_FORMATS,
    *PLAN_FORMATS,
    DamagedFormat("evolution logs", 250, "", _sound_log, damage_database, evolve_from),
    DamagedFormat("ledgers", 150, "", _sound_ledger, plain(damage_text), _ledger),
    DamagedFormat(
        "styles",
        220,
        ".npz",
        _sound_style,
        plain(damage_arrays),
        arrange_beside("--style", VILLAGE, "--layouts", "1"),
    ),
    DamagedFormat("trainings", 50, ".npz", _sound_training, plain(damage_arrays), resume),
    DamagedFormat(
        "groups",
        150,
        ".json",
        given(GROUPS),
        plain(damage_json),
        arrange_beside("--groups", HOME, *SHORT),
    ),
    DamagedFormat("solutions", 180, ".json", _sound_solution, plain(damage_json), check_it),
    DamagedFormat(
        "solutions again", 60, ".json", _sound_solution, plain(damage_json), arrange_with(10)
    ),
    DamagedFormat("homes", 120, ".json", given(HOME), plain(damage_json), arrange_with(10)),
    DamagedFormat("halls", 60, ".json", given(HALL), plain(damage_json), arrange_with(10)),
    DamagedFormat("sites", 60, ".json", given(SITE), plain(damage_json), arrange_with(10)),
    DamagedFormat(
        "villages", 40, ".json", _sample("village", "village-hamlet"), plain(damage_json), read_it
    ),
    DamagedFormat(
        "extensions", 40, ".json", _sample("extend", "extend-village"), plain(damage_json), read_it
    ),
    DamagedFormat("city models", 40, ".cityjson", given(CITY), plain(damage_json), show_models),
    DamagedFormat("GLB", 70, ".glb", written("glb"), plain(damage_bytes), show_models),
    DamagedFormat("glTF", 60, ".gltf", given(GLTF), plain(damage_json), show_models),
    DamagedFormat("STL", 60, ".stl", given(STL.encode()), plain(damage_lines), show_models),
    DamagedFormat("OBJ", 30, ".obj", given(OBJ.encode()), plain(damage_text), show_models),
    DamagedFormat(
        "libraries", 40, ".sh3f", given(LIBRARY), plain(damage_zip(damage_text)), show_models
    ),
    DamagedFormat(
        "corrections", 20, ".csv", given(CORRECTIONS.encode()), plain(damage_text), read_corrections
    ),
    DamagedFormat("blocks to learn", 30, ".json", given(BLOCKS), plain(damage_json), learn_blocks),
)
"""Every format but plug-ins, and how many of some 2,000 files are of it."""
