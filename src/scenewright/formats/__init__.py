"""Files in and out: one file a format, found by the longest suffix that fits.

A row says which suffix a module handles and whether it reads briefs or writes solutions; the
module is imported on first use, so a missing extra is only noticed (and named) then. A module
that reads has ``read(path, keep=False) -> Brief``; one that writes ``write(solution, path)``, or
``write(solution, path, plan)`` if it draws what the brief tells: ``plan`` is made once a run.
Other packages add rows through the entry point group ``scenewright.formats``: a name that is the
suffix (``.dxf``), and a module; it may have only one of the two functions. A module that writes
may have ``check(brief)``, which raises :class:`InputError` for what it cannot write. What a format
does not hold of a solution is a column of its row (:func:`losses`).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any

from scenewright.core.atomic_file import check_targets
from scenewright.core.errors import InputError
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.core.registry import Format
from scenewright.formats.foreign import name_foreign
from scenewright.formats.losses import losses
from scenewright.formats.opening import SAMPLE, Opened, open_source, samples
from scenewright.formats.table import (
    FORMATS,
    SWEET_HOME,
    domains,
    formats,
    load_function,
    load_module,
    row_of,
    suffix_of,
)

if TYPE_CHECKING:
    from scenewright.core.brief import Brief
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution

__all__ = [
    "FORMATS",
    "SAMPLE",
    "SWEET_HOME",
    "check_output",
    "check_outputs",
    "domains",
    "extends",
    "formats",
    "losses",
    "read",
    "read_planned",
    "samples",
    "suffix_of",
    "write",
    "writer",
]


def read_planned(
    source: str | os.PathLike[str],
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
    scale: float = 1.0,
    hidden_levels: bool = False,
    style: str = "",
    map_options: MapOptions = AS_IT_IS,
) -> tuple[Brief, Plan]:
    """The brief in a file, or a sample (``sample:home-flat``), and its plan, which checks it down
    to its geometry.

    ``keep`` leaves movable furniture of the file where it is, as fixed items; ``catalogs`` are
    further catalogues of models and ``groups`` files of learned groups, below the working folder.
    ``scale`` multiplies every length in plan, for a plan drawn too small or too large;
    ``hidden_levels`` includes the levels that are hidden in a Sweet Home 3D file; ``style`` takes
    the place of the brief's and must be known; ``map_options`` say what a map does not. Anything
    that cannot be used raises :class:`InputError`, one line that names the file.

    >>> brief, plan = read_planned("sample:home-flat")
    >>> brief.rooms[1].name, plan.spaces[1].name
    ('Kitchen', 'Kitchen')
    """
    from pydantic import ValidationError

    from scenewright.core.brief.variations import add_named_files
    from scenewright.core.document_faults import to_input_error
    from scenewright.domains import plan_valid
    from scenewright.formats.catalog_paths import absolute_names

    try:
        named = absolute_names(catalogs, groups, style)
        opened = open_source(source)
        drawn = _parse(opened, keep, hidden_levels, scale, map_options)
        brief = add_named_files(drawn, *named)
        return brief, plan_valid(brief, style)
    except InputError as error:
        raise error.located(file=str(source)) from None
    except ValidationError as error:
        raise to_input_error(error).located(file=str(source)) from None


def read(
    source: str | os.PathLike[str],
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
    scale: float = 1.0,
    hidden_levels: bool = False,
    map_options: MapOptions = AS_IT_IS,
) -> Brief:
    """The brief in a file, or a sample (``sample:home-flat``), checked down to its geometry.

    ``keep`` leaves movable furniture of the file where it is, as fixed items; ``catalogs`` are
    further catalogues of models and ``groups`` files of learned groups. ``scale`` multiplies every
    length in plan, for a plan drawn too small or too large; ``hidden_levels`` includes the levels
    that are hidden in a Sweet Home 3D file. Raises :class:`InputError`, one line that names file,
    place, fault and remedy. What became of each feature of the file is in ``input_report``.

    >>> read("sample:home-flat").rooms[1].name
    'Kitchen'
    """
    return read_planned(
        source, keep, catalogs, groups, scale, hidden_levels, map_options=map_options
    )[0]


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write a solution in the format of the suffix of ``path``; missing folders are made.
    ``plan`` is that of its brief (made by what draws, unless given)."""
    writing = writer(path, solution.brief.domain)
    try:
        Path(path).parent.mkdir(parents=True, exist_ok=True)
        if plan is not None and "plan" in signature(writing).parameters:
            writing(solution, path, plan)
        else:
            writing(solution, path)
    except InputError as error:
        raise error.located(file=str(path)) from None
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror or error}", "choose another place", file=str(path)
        ) from None


def writer(path: str | os.PathLike[str], domain: str = "") -> Callable[..., Any]:
    """The function that writes files named like ``path``; InputError if there is none, or if it
    does not hold what is of ``domain``."""
    row = row_of(path, "writer", domain)
    if domain and not row.holds(domain):
        raise InputError(
            f"only {row.domain}s can be written as {row.suffix}",
            "choose .glb, .svg or .json",
            file=str(path),
        )
    return load_function(row.writer, "write", path)


def extends(source: str | os.PathLike[str], path: str | os.PathLike[str]) -> bool:
    """Whether what is read from ``source`` is written to ``path`` as a copy of it with more.

    >>> extends("office.ifc", "furnished.ifc"), extends("office.ifc", "furnished.glb")
    (True, False)
    """
    row = row_of(path, "writer")
    return row.extends and Path(source).name.lower().endswith(row.suffix)


def check_outputs(paths: Sequence[Path], brief: Brief | None = None) -> None:
    """Raise :class:`InputError` unless the scene of a brief can be written to every path: in its
    format, in the place of no brief, folder or file that this run reads, and none twice. Before a
    brief is known only that there is such a format is asked."""
    from scenewright.core.document_faults import check_text
    from scenewright.formats import brief_json

    for path in paths:
        check_output(path, brief) if brief else writer(path)
    check_targets(paths)
    for path in paths:
        if brief_json.holds_brief(path):
            fault = "is a brief and would be replaced"
            raise InputError(fault, "give -o another name", file=str(path))
        check_text(os.fspath(path), "the name of a file")


def check_output(path: str | os.PathLike[str], brief: Brief) -> None:
    """Raise :class:`InputError` if no solution of a brief can be written to ``path``: there is no
    such format, it does not hold what is of this domain, or its module's ``check(brief)`` says."""
    writer(path, brief.domain)
    module = load_module(row_of(path, "writer", brief.domain).writer, path)
    try:
        getattr(module, "check", lambda _: None)(brief)
    except InputError as error:
        raise error.located(file=str(path)) from None


def _parse(
    opened: Opened, keep: bool, hidden_levels: bool, scale: float, map_options: MapOptions
) -> Brief:
    """The brief that a file holds, at its scale; a file of another program, if it is refused, is
    named."""
    from scenewright.core.brief.variations import report_scale, scale_brief

    path, row = opened
    reading = load_function(row.reader, "read", path)
    known = signature(reading).parameters
    wishes = {"scale": scale, "hidden_levels": hidden_levels, "map_options": map_options}
    if map_options != AS_IT_IS and "map_options" not in known:
        fault = f"is no map: {map_options.name_given()} cannot be used"
        raise InputError(fault, "leave it out")
    try:
        found: Any = reading(path, keep=keep, **{k: v for k, v in wishes.items() if k in known})
    except OSError as error:
        fault = f"cannot be read: {error.strerror or error}"
        raise InputError(fault, "check file permissions") from None
    except InputError as error:
        raise name_foreign(path, error) from None
    brief = _check_brief(found, row)
    return report_scale(brief, scale) if "scale" in known else scale_brief(brief, scale)


def _check_brief(found: Any, row: Format) -> Brief:
    """The brief a format has read, if it is one."""
    from scenewright.core.brief import Brief

    if not isinstance(found, Brief):
        raise InputError(f"the format's module {row.reader} reads no brief", "use another format")
    return found
