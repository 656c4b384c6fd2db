"""What is done already: a line of JSON for each finished file, so that a batch can go on.

Results appear under their names first and the line is written after, so a batch killed between
the two does that file again and writes the same. A line cut off by a kill is passed over.
"""

from __future__ import annotations

import json
import os
import shutil
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Any, TextIO

from scenewright.batch.jobs import Job
from scenewright.batch.table import FAILED, ResultRow
from scenewright.core.errors import InputError

NAME, PARTS = ".batch.jsonl", ".parts"


class Ledger:
    """The ledger of a folder of results, and ``parts``, where they are before they are whole.

    Used as a context; only one batch at a time may write into a folder.
    """

    def __init__(self, folder: Path) -> None:
        self.path, self.parts = folder / NAME, folder / PARTS
        self._rows: dict[str, tuple[str, ResultRow]] = {}
        self._file: TextIO

    def __enter__(self) -> Ledger:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._file = self.path.open("a+", encoding="utf-8", errors="surrogateescape")
            self._claim()
            shutil.rmtree(self.parts, ignore_errors=True)
            self.parts.mkdir()
        except OSError as error:
            raise self._refusal(error) from None
        self._read()
        return self

    def _refusal(self, error: OSError) -> InputError:
        text = f"cannot be written into: {error.strerror or error}"
        return InputError(text, "choose another folder", file=str(self.path.parent))

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with suppress(OSError):  # what a full disk did not take was reported when it was written
            self._file.close()
        shutil.rmtree(self.parts, ignore_errors=True)

    def find(self, order: Job) -> ResultRow | None:
        """The row of an order that is done, unchanged since, and whose results are still there;
        those that failed are tried again."""
        key, row = self._rows.get(order.name, ("", None))
        if row is None or key != order.key or row.status == FAILED:
            return None
        return row if all(path.is_file() for path in order.outputs) else None

    def write(self, order: Job, row: ResultRow) -> None:
        """Note that an order is done."""
        line = json.dumps({"name": order.name, "key": order.key, **row._asdict()})
        try:
            self._file.write(line + "\n")
            self._file.flush()
        except OSError as error:
            raise self._refusal(error) from None

    def _claim(self) -> None:
        """Refuse a folder another batch is writing into (where the system can tell)."""
        try:
            import fcntl
        except ImportError:
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._file.close()
            raise InputError(
                "another batch is writing into it",
                "wait for it or choose another folder",
                file=str(self.path.parent),
            ) from None

    def _read(self) -> None:
        """Take in what is done; a line that was cut off is ended so that the next stands alone."""
        self._file.seek(0)
        text = self._file.read()
        for line in text.splitlines():
            with suppress(ValueError, KeyError, TypeError):
                entry: dict[str, Any] = json.loads(line)
                values = {field: entry[field] for field in ResultRow._fields}
                row = ResultRow(**values)._replace(outputs=tuple(entry["outputs"]))
                self._rows[str(entry["name"])] = (str(entry["key"]), row)
        self._file.seek(0, os.SEEK_END)
        if text and not text.endswith("\n"):
            self._file.write("\n")
