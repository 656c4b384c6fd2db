"""Runs of long benchmarks, kept as they come: one that was cut short goes on where it ended.

Runs are kept as lines of JSON in ``benchmarks/.kept``, in a file named after the benchmark and the
code it measures: a change of that code begins anew.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from hashlib import blake2b
from pathlib import Path
from typing import Any, NamedTuple

FOLDER = Path(__file__).parent / ".kept"
SOURCES = Path(__file__).parent.parent


class KeptRuns(NamedTuple):
    """Values by name in a file of lines, each written when it is known."""

    path: Path
    values: dict[str, Any]

    def keep(self, name: str, value: Any) -> None:
        """Write a value down."""
        self.path.parent.mkdir(exist_ok=True)
        with self.path.open("a", encoding="utf-8") as file:
            file.write(json.dumps([name, value]) + "\n")
        self.values[name] = value

    def have(self, name: str, make: Callable[[], Any]) -> Any:
        """A value that is kept, or made now and kept."""
        if name not in self.values:
            self.keep(name, make())
        return self.values[name]


def open_runs(name: str, code: Iterable[str], folder: Path = FOLDER) -> KeptRuns:
    """What is kept of a benchmark for the code in files of such patterns; a last line cut short
    counts for nothing."""
    digest = blake2b(digest_size=6)
    for path in sorted({found for pattern in code for found in SOURCES.glob(pattern)}):
        digest.update(path.read_bytes())
    path, values = folder / f"{name}-{digest.hexdigest()}.jsonl", dict[str, Any]()
    whole = path.read_text("utf-8") if path.exists() else ""
    if whole and not whole.endswith("\n"):
        whole = whole[: whole.rfind("\n") + 1]
        path.write_text(whole, "utf-8")
    for line in whole.splitlines():
        key, value = json.loads(line)
        values[key] = value
    return KeptRuns(path, values)
