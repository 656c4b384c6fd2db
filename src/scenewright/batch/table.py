"""The table of a batch: one row for each file, as CSV and as JSON."""

from __future__ import annotations

import csv
import io
import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from scenewright._version import __version__
from scenewright.batch.jobs import BatchOptions
from scenewright.core.atomic_file import whole_together
from scenewright.core.errors import InputError
from scenewright.text import neutralize_cell

COMPLETE, LEFT_OUT, NOT_VALID, FAILED = "complete", "left out", "not valid", "failed"
STATES = (COMPLETE, LEFT_OUT, NOT_VALID, FAILED)
CSV, JSON = "summary.csv", "summary.json"


class ResultRow(NamedTuple):
    """The result of one file.

    ``status`` is ``complete`` (all that is essential or asked for stands, and valid), ``left out``
    (valid, but something of that or of the file is not there), ``not valid`` (a rule is broken) or
    ``failed`` (nothing was written); ``message`` says why. ``left_out`` counts what is essential or
    asked for and not there, ``violations`` broken rules. ``facts`` are the scene's line of the
    manifest, as far as whoever arranged it knows.
    """

    file: str
    status: str
    seconds: float
    pieces: int
    left_out: int
    violations: int
    message: str
    outputs: tuple[str, ...]
    facts: dict[str, Any] = {}

    def listed(self) -> dict[str, Any]:
        """What the tables list of it."""
        return {key: value for key, value in self._asdict().items() if key != "facts"}


def make_failed_row(file: str, seconds: float, message: str) -> ResultRow:
    """The row of a file that came to nothing."""
    return ResultRow(file, FAILED, round(seconds, 3), 0, 0, 0, " ".join(message.split()), ())


def totals(rows: Sequence[ResultRow]) -> dict[str, int]:
    """How many files there are of each status.

    >>> totals([make_failed_row("a.json", 0.1, "is empty")])
    {'complete': 0, 'left out': 0, 'not valid': 0, 'failed': 1}
    """
    counted = Counter(row.status for row in rows)
    return {state: counted[state] for state in STATES}


def document(rows: Sequence[ResultRow], options: BatchOptions) -> dict[str, Any]:
    """The table as plain values."""
    return {
        "version": __version__,
        "options": options._asdict(),
        "totals": totals(rows),
        "files": [row.listed() for row in rows],
    }


def write_summary(folder: Path, rows: Sequence[ResultRow], options: BatchOptions) -> None:
    """Write the table as CSV and as JSON; both appear or neither. InputError if they cannot."""
    text = io.StringIO()
    lines = csv.writer(text, lineterminator="\n")
    lines.writerow(ResultRow._fields[:-1])
    cells = ([*row[:-2], " ".join(row.outputs)] for row in rows)
    lines.writerows(map(neutralize_cell, row) for row in cells)
    message = json.dumps(document(rows, options), indent=1, ensure_ascii=False) + "\n"
    with whole_together([folder / CSV, folder / JSON]) as partials:
        for partial, content in zip(partials, (text.getvalue(), message), strict=True):
            _write(partial, content, folder)


def _write(partial: Path, text: str, folder: Path) -> None:
    try:
        partial.write_text(text, encoding="utf-8", errors="backslashreplace", newline="")
    except OSError as error:
        raise InputError(
            f"cannot be written into: {error.strerror or error}",
            "choose another folder",
            file=str(folder),
        ) from None
