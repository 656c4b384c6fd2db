"""Files in and out: one file a format, found by the longest suffix that fits.

A row says which suffix a module handles and whether it reads briefs or writes solutions; the
module is imported on first use, so a missing extra is only noticed (and named) then. A module
that reads has ``read(path, keep=False) -> Brief``; one that writes ``write(solution, path)``.
Other packages add rows through the entry point group ``scenewright.formats``: a name that is the
suffix (``.dxf``), and a module.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from importlib import import_module, resources
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, NamedTuple

from scenewright.errors import InputError

if TYPE_CHECKING:
    from scenewright.brief import Brief
    from scenewright.solution import Solution

SAMPLE = "sample:"


class Format(NamedTuple):
    """One row: the suffix, what it is, the modules that read a brief or write a solution, and the
    only domain of which it holds solutions (empty: any)."""

    suffix: str
    about: str
    reader: str = ""
    writer: str = ""
    domain: str = ""


FORMATS = (
    Format(
        ".json",
        "brief (read), solution (read as a brief with its locked pieces, written)",
        "scenewright.formats.brief_json",
        "scenewright.formats.solution_json",
    ),
    Format(".sh3d", "Sweet Home 3D home", "scenewright.formats.sh3d"),
    Format(".xml", "Home.xml of a Sweet Home 3D home", "scenewright.formats.sh3d"),
    Format(
        ".geojson",
        "indoor map or site (OpenStreetMap, read), footprints of a site (written)",
        "scenewright.formats.geojson",
        "scenewright.formats.footprints_geojson",
        "site",
    ),
    Format(".glb", "3D scene, binary glTF 2.0", writer="scenewright.formats.glb"),
    Format(".svg", "plan drawing", writer="scenewright.formats.svg"),
    Format(
        ".cityjson",
        "city model: its buildings as landmarks (read), a site (written)",
        "scenewright.formats.site_cityjson",
        "scenewright.formats.cityjson",
        "site",
    ),
    Format(
        ".credits.txt", "authors and licences of the models", writer="scenewright.formats.credits"
    ),
    Format(".png", "picture from above", writer="scenewright.formats.png"),
    Format(
        ".street.png",
        "picture of a site at eye height",
        writer="scenewright.formats.street",
        domain="site",
    ),
)


def read(
    source: str | os.PathLike[str],
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
) -> Brief:
    """The brief in a file, or a sample (``sample:home-flat``); checked down to its geometry.

    ``keep`` leaves movable furniture of the file where it is, as fixed items; ``catalogs`` are
    further catalogues of models and ``groups`` files of learned groups, below the working folder.
    Anything that cannot be used raises :class:`InputError`, one line that names the file.

    >>> read("sample:home-flat").rooms[1].name
    'Kitchen'
    """
    from pydantic import ValidationError

    from scenewright.document_faults import told
    from scenewright.formats.catalog_paths import with_more
    from scenewright.plan import spaces
    from scenewright.zones import check_halls

    try:
        brief = with_more(_read(source, keep), catalogs, groups)
        check_halls(brief, spaces(brief))
    except InputError as error:
        raise error.located(file=str(source)) from None
    except ValidationError as error:
        raise told(error).located(file=str(source)) from None
    return brief


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write a solution in the format of the suffix of ``path``; missing folders are made."""
    writing = writer(path, solution.brief.domain)
    try:
        Path(path).parent.mkdir(parents=True, exist_ok=True)
        writing(solution, path)
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror or error}", "choose another place", file=str(path)
        ) from None


def writer(
    path: str | os.PathLike[str], domain: str = ""
) -> Callable[[Solution, str | os.PathLike[str]], None]:
    """The function that writes files named like ``path``; InputError if there is none, or if it
    does not hold what is of ``domain``."""
    row = _row(path, "writer")
    if domain and row.domain not in ("", domain):
        raise InputError(f"only {row.domain}s can be written as {row.suffix}",
                         "choose .glb, .svg or .json", file=str(path))  # fmt: skip
    write_function: Callable[[Solution, str | os.PathLike[str]], None] = _module(
        row.writer, path
    ).write
    return write_function


def check_kept(source: str | os.PathLike[str], outputs: Sequence[str | os.PathLike[str]]) -> None:
    """No output is the file that is read, by whatever name; only a saved solution, which is a brief
    as well, may be replaced by another."""
    from scenewright.formats import brief_json

    for path in outputs:
        try:
            same = Path(path).samefile(source)
        except OSError:
            continue
        if same and not brief_json.holds_solution(Path(source)):
            raise InputError("is the file that is read, which the result would replace",
                             "give -o another name", file=str(path))  # fmt: skip


def suffix_of(path: str | os.PathLike[str]) -> str:
    """The suffix by which a file's format is found, as it is written there.

    >>> suffix_of("a/site.street.png"), suffix_of("site.png"), suffix_of("notes.txt")
    ('.street.png', '.png', '.txt')
    """
    name = Path(path).name
    fitting = [len(row.suffix) for row in formats() if _fits(row, name.lower())]
    return name[-max(fitting) :] if fitting else Path(name).suffix


def samples() -> tuple[str, ...]:
    """Names of the sample briefs, as :func:`read` takes them.

    >>> "sample:home-flat" in samples()
    True
    """
    files = resources.files("scenewright.samples").iterdir()
    names = sorted(file.name for file in files if file.name.endswith(".json"))
    return tuple(SAMPLE + name.removesuffix(".json") for name in names)


def formats() -> tuple[Format, ...]:
    """All formats: the rows above and those other packages add."""
    from importlib.metadata import entry_points

    return FORMATS + tuple(
        Format(entry.name, entry.value, entry.value, entry.value)
        for entry in entry_points(group="scenewright.formats")
    )


def _read(source: str | os.PathLike[str], keep: bool) -> Brief:
    if str(source).startswith(SAMPLE):
        return _sample(str(source))
    if f"{SAMPLE}{source}" in samples() and not Path(source).exists():
        raise InputError("is the name of a sample", f"say {SAMPLE}{source}")
    path = Path(source)
    row = _row(source, "reader") if not path.is_dir() else None
    if row is not None and not path.exists():
        raise InputError("there is no such file", "check the path")
    if row is None or not path.is_file():
        remedy = "add --batch for all in it" if path.is_dir() else "give the file itself"
        raise InputError("is a folder" if path.is_dir() else "is not a file", remedy)
    try:
        brief: Brief = _module(row.reader, source).read(path, keep=keep)
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror or error}", "check its rights") from None
    return brief


def _sample(name: str) -> Brief:
    from scenewright.formats import brief_json

    if name not in samples():
        raise InputError("there is no such sample", f"use one of: {', '.join(samples())}")
    file = resources.files("scenewright.samples") / f"{name.removeprefix(SAMPLE)}.json"
    return brief_json.loads(file.read_bytes())


def _row(path: str | os.PathLike[str], part: str) -> Format:
    name = Path(path).name.lower()
    suffix = Path(name).suffix
    fitting = [row for row in FORMATS if _fits(row, name) and getattr(row, part)]
    fitting = fitting or [row for row in formats() if _fits(row, name) and getattr(row, part)]
    found = sorted(fitting, key=lambda row: -len(row.suffix))
    if not found:
        usable = ", ".join(row.suffix for row in formats() if getattr(row, part))
        verb = "read" if part == "reader" else "written"
        told = f"'{suffix}' files cannot be {verb}" if suffix else "the name has no suffix"
        raise InputError(told, f"use one of: {usable}", file=str(path))
    return found[0]


def _fits(row: Format, name: str) -> bool:
    """Whether a file's name ends in a row's suffix, and has more than that."""
    return name.endswith(row.suffix) and len(name) > len(row.suffix)


def _module(name: str, path: str | os.PathLike[str]) -> ModuleType:
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        raise InputError(
            f"this format needs the package '{error.name}'", "install it", file=str(path)
        ) from None
