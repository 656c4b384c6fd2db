"""A scene taken away: in one format, or in all as one archive."""

from __future__ import annotations

import tempfile
import zipfile
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.formats import write
from scenewright.formats.table import formats


def pack_scene(solution: Solution, endings: Sequence[str] = ()) -> bytes:
    """A scene in several formats (none named: all) as one zip archive; what cannot be written is
    told in it."""
    kept, faults = BytesIO(), []
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(kept, "w") as archive:
        for ending in endings or list_endings(solution.brief.domain):
            path = Path(folder, f"scene.{ending}")
            try:
                write(solution, path)
            except (InputError, ModuleNotFoundError) as error:
                faults.append(f"{path.name}: {error}")
        for path in sorted(Path(folder).iterdir()):
            archive.write(path, path.name, zipfile.ZIP_DEFLATED)
        if faults:
            archive.writestr("left_out.txt", "\n".join(faults) + "\n")
    return kept.getvalue()


def list_endings(domain: str) -> list[str]:
    """Every format that scenes of a kind are written in; photographs take minutes and are asked
    for by name."""
    rows = [row for row in formats() if row.writer and row.holds(domain)]
    found = dict.fromkeys(row.suffix.removeprefix(".") for row in rows)
    return [ending for ending in found if not ending.endswith(".png")]


def write_scene(solution: Solution, ending: str) -> bytes:
    """A scene in one format."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"scene.{ending}")
        write(solution, path)
        return path.read_bytes()
