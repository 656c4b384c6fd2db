"""The table of a batch: one row for each file, as CSV and as JSON."""

from __future__ import annotations

import csv
import io
import json
import os
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from scenewright._version import __version__
from scenewright.batch.orders import Options

COMPLETE, LEFT_OUT, NOT_VALID, FAILED = "complete", "left out", "not valid", "failed"
STATES = (COMPLETE, LEFT_OUT, NOT_VALID, FAILED)
CSV, JSON = "summary.csv", "summary.json"


class Row(NamedTuple):
    """What became of one file.

    ``status`` is ``complete`` (all that is essential or asked for stands, and valid), ``left
    out`` (valid, but something of that is not there), ``not valid`` (a rule is broken) or
    ``failed`` (nothing was written); ``message`` says why. ``left_out`` counts what is essential
    or asked for and not there, ``violations`` broken rules.
    """

    file: str
    status: str
    seconds: float
    pieces: int
    left_out: int
    violations: int
    message: str
    outputs: tuple[str, ...]


def failed(file: str, seconds: float, message: str) -> Row:
    """The row of a file that came to nothing."""
    return Row(file, FAILED, round(seconds, 3), 0, 0, 0, " ".join(message.split()), ())


def totals(rows: Sequence[Row]) -> dict[str, int]:
    """How many files there are of each status.

    >>> totals([failed("a.json", 0.1, "is empty")])
    {'complete': 0, 'left out': 0, 'not valid': 0, 'failed': 1}
    """
    counted = Counter(row.status for row in rows)
    return {state: counted[state] for state in STATES}


def document(rows: Sequence[Row], options: Options) -> dict[str, Any]:
    """The table as plain values."""
    return {
        "version": __version__,
        "options": options._asdict(),
        "totals": totals(rows),
        "files": [row._asdict() for row in rows],
    }


def write_summary(folder: Path, rows: Sequence[Row], options: Options) -> None:
    """Write the table as CSV and as JSON; each file appears whole."""
    text = io.StringIO()
    lines = csv.writer(text, lineterminator="\n")
    lines.writerow(Row._fields)
    lines.writerows([*row[:-1], " ".join(row.outputs)] for row in rows)
    _replace(folder / CSV, text.getvalue())
    told = json.dumps(document(rows, options), indent=1, ensure_ascii=False)
    _replace(folder / JSON, told + "\n")


def _replace(path: Path, text: str) -> None:
    part = path.with_name(f".{os.getpid()}-{path.name}")
    part.write_text(text, encoding="utf-8", errors="backslashreplace", newline="")
    os.replace(part, path)
