"""The real data sets, which are not part of the project: where they lie, and a word where not."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from scenewright.core.errors import InputError

Row = dict[str, Any]


def data_folder() -> Path:
    """``SCENEWRIGHT_DATA``, else ``shared/data`` beside this checkout, wherever one works."""
    given = os.environ.get("SCENEWRIGHT_DATA")
    return Path(given) if given else Path(__file__).resolve().parents[2] / "shared" / "data"


def data_set(name: str) -> Path:
    """A folder or file of the data; an :class:`InputError` where there is none."""
    return _there(data_folder(), name)


def data_files(name: str, pattern: str) -> list[Path]:
    """The files of a folder of the data, by name; an :class:`InputError` where there are none."""
    found = sorted(data_set(name).glob(pattern))
    if not found:
        raise _missing(f"{name}/{pattern}", data_folder())
    return found


def instance(name: str) -> Path:
    """A file of the folder ``instances`` beside the data."""
    return _there(data_folder().parent / "instances", name)


def skipped(part: str, fault: InputError) -> Row:
    """What a benchmark of several parts tells of one whose data are not there."""
    told = dict.fromkeys(("unit", "ours", "baseline", "baseline_name", "ratio"))
    return {"case": f"{part}: {fault}", "metric": "skipped"} | told | {"runs": 0}


def _there(folder: Path, name: str) -> Path:
    if not (folder / name).exists():
        raise _missing(name, folder)
    return folder / name


def _missing(name: str, folder: Path) -> InputError:
    remedy = "set SCENEWRIGHT_DATA to the folder that holds the real data sets"
    return InputError(f"the real data {name} are not in {folder}", remedy)
