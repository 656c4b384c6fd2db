"""The verb ``bench``: benchmarks live beside the source, in its folder ``benchmarks``."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

from scenewright.cli.arrange import named
from scenewright.errors import InputError

Record = dict[str, Any]


def records(name: str, quick: bool, progress: Callable[[float, str], None]) -> list[Record]:
    """Run one benchmark: records of case, metric, unit, ours, baseline, baseline_name, ratio,
    runs."""
    folder = find_folder()
    named("benchmark", name, names(folder))
    root = str(folder.parent)
    if root not in sys.path:
        sys.path.insert(0, root)
    found: list[Record] = import_module(f"benchmarks.{name}").records(quick, progress)
    return found


def names(folder: Path) -> list[str]:
    """Names of the benchmarks in a folder: its modules that have ``records``."""
    files = sorted(folder.glob("*.py"))
    return [f.stem for f in files if "def records(" in f.read_text(encoding="utf-8")]


def find_folder() -> Path:
    """The checkout's benchmarks: from the current folder upwards, else beside this package."""
    here = Path.cwd()
    tops = [here, *here.parents, *Path(__file__).resolve().parents]
    for top in tops:
        if (top / "src" / "scenewright").is_dir() and (top / "benchmarks").is_dir():
            return top / "benchmarks"
    raise InputError("benchmarks need a source checkout", "run this inside one")
