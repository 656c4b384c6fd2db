"""Files that appear whole or not at all: written under another name beside it, then renamed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def whole(path: str | os.PathLike[str]) -> Iterator[Path]:
    """The name to write to in the block. It becomes ``path`` at the end; if anything fails it is
    removed, and what was there before stays.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with whole(Path(folder, "plan.svg")) as partial:
    ...         _ = partial.write_text("<svg/>")
    ...     [file.name for file in Path(folder).iterdir()]
    ['plan.svg']
    """
    final = Path(path)
    partial = final.with_name(f".{final.name}.{os.getpid()}.partial")
    try:
        yield partial
        os.replace(partial, final)
    finally:
        partial.unlink(missing_ok=True)


def write_whole(path: str | os.PathLike[str], text: str) -> None:
    """Write a text as UTF-8."""
    with whole(path) as partial:
        partial.write_text(text, encoding="utf-8")
