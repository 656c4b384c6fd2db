"""The folder that all files of a run lie in, where there is one: names that lead out are refused.

The command line works on its user's own files: no folder is set, and every name is good. A server
sets one (:class:`scenewright.workflow.workspace.Workspace`); names are then taken from it, links
are followed before they are judged, and what is refused is refused in the same words whether it is
there or not. What the package ships may be read from anywhere.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from scenewright.core.errors import InputError

_ROOT: ContextVar[Path | None] = ContextVar("workspace_root", default=None)
LONGEST_NAME, MOST_NAMES = 255, 1000
"""Bytes of a name and names of a path, at most."""
SHOWN = 60
"""Letters of a wrong path that are told."""
PACKAGE = Path(os.path.realpath(__file__)).parent.parent
"""Where samples and tables of the package lie."""


@contextmanager
def confined(root: Path | None) -> Iterator[None]:
    """In the block every file that is named must lie in ``root`` (``None``: anywhere)."""
    token = _ROOT.set(None if root is None else Path(os.path.realpath(root)))
    try:
        yield
    finally:
        _ROOT.reset(token)


def is_confined() -> bool:
    """Whether files must lie in a folder."""
    return _ROOT.get() is not None


def check_inside(path: str | os.PathLike[str]) -> None:
    """InputError for a path that leads out of the folder files must lie in, or that no file can
    have; nothing is opened.

    >>> with confined(Path("/srv/plans")):
    ...     check_inside("/srv/plans/../secret/flat.json")
    Traceback (most recent call last):
    scenewright.core.errors.InputError: lies outside the workspace; use names below its folder
    """
    _check_names(path)
    root = _ROOT.get()
    if root is None:
        return
    try:
        real = Path(os.path.realpath(path))
    except (OSError, ValueError):
        real = Path("/")
    if not (real.is_relative_to(root) or real.is_relative_to(PACKAGE)):
        raise InputError("lies outside the workspace", "use names below its folder")


def _check_names(path: str | os.PathLike[str]) -> None:
    """InputError for a path with a name that is too long, or that no system takes."""
    try:
        names = os.fsencode(path).split(os.sep.encode())
    except UnicodeEncodeError:
        names = [b"\0"]
    if any(len(name) > LONGEST_NAME or b"\0" in name for name in names) or len(names) > MOST_NAMES:
        shown = ascii(os.fspath(path))[1:-1]
        told = shown if len(shown) <= SHOWN else f"{shown[:SHOWN]}..."
        raise InputError(f"{told} is no name of a file", f"give at most {LONGEST_NAME} letters")
