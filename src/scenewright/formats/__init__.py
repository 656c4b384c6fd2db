"""Files in and out: one file a format, found by the longest suffix that fits.

A row says which suffix a module handles and whether it reads briefs or writes solutions; the
module is imported on first use, so a missing extra is only noticed (and named) then. A module
that reads has ``read(path, keep=False) -> Brief``; one that writes ``write(solution, path)``, or
``write(solution, path, plan)`` if it draws what the brief tells: ``plan`` is made once a run.
Other packages add rows through the entry point group ``scenewright.formats``: a name that is the
suffix (``.dxf``), and a module; it may have only one of the two functions. A module that writes
may have ``check(brief)``, which raises :class:`InputError` for what it cannot write.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from importlib import import_module, resources
from inspect import signature
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from scenewright.core.atomic_file import note_read
from scenewright.core.errors import InputError
from scenewright.core.registry import Format, domain_names, domain_of

if TYPE_CHECKING:
    from scenewright.core.brief import Brief
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution
    from scenewright.domains.contract import Domain

SAMPLE = "sample:"
SWEET_HOME = (".sh3d", ".xml")
"""Suffixes of files whose levels may be hidden."""
EXTRAS = {"ifcopenshell": "bim", "ezdxf": "dxf", "fpdf": "pdf", "fontpkg_noto_sans": "pdf"}
"""The extra that brings a package which a format needs."""

FORMATS = (
    Format(
        ".json",
        "brief (read), solution (read as a brief with its locked pieces, written)",
        "scenewright.formats.brief_json",
        "scenewright.formats.solution_json",
    ),
    Format(".sh3d", "Sweet Home 3D home", "scenewright.formats.sh3d"),
    Format(".xml", "Home.xml of a Sweet Home 3D home", "scenewright.formats.sh3d"),
    Format(".geojson", "indoor map or site (OpenStreetMap, read)", "scenewright.formats.geojson"),
    Format(".glb", "3D scene, binary glTF 2.0", writer="scenewright.formats.glb"),
    Format(
        ".ifc",
        "building model (IFC2x3 or IFC4, read; IFC4, written)",
        "scenewright.formats.ifc",
        "scenewright.formats.ifc",
    ),
    Format(".svg", "plan drawing", writer="scenewright.formats.svg"),
    Format(
        ".dxf",
        "plan for CAD (read; written in metres)",
        "scenewright.formats.dxf_plan",
        "scenewright.formats.dxf",
    ),
    Format(".mm.dxf", "plan for CAD in millimetres", writer="scenewright.formats.dxf_millimetres"),
    Format(".3d.dxf", "3D scene for CAD, meshes", writer="scenewright.formats.dxf_3d"),
    Format(".pdf", "set of sheets to print", writer="scenewright.formats.pdf"),
    Format(
        ".credits.txt", "authors and licences of the models", writer="scenewright.formats.credits"
    ),
    Format(".png", "picture from above", writer="scenewright.formats.png"),
)


def read_planned(
    source: str | os.PathLike[str],
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
    scale: float = 1.0,
    hidden_levels: bool = False,
    style: str = "",
) -> tuple[Brief, Plan]:
    """The brief in a file, or a sample (``sample:home-flat``), and its plan, which checks it down
    to its geometry.

    ``keep`` leaves movable furniture of the file where it is, as fixed items; ``catalogs`` are
    further catalogues of models and ``groups`` files of learned groups, below the working folder.
    ``scale`` multiplies every length in plan, for a plan drawn too small or too large;
    ``hidden_levels`` includes the levels that are hidden in a Sweet Home 3D file; ``style`` takes
    the place of the brief's and must be known. Anything that
    cannot be used raises :class:`InputError`, one line that names the file.

    >>> brief, plan = read_planned("sample:home-flat")
    >>> brief.rooms[1].name, plan.spaces[1].name
    ('Kitchen', 'Kitchen')
    """
    from pydantic import ValidationError

    from scenewright.core.document_faults import check_text, to_input_error
    from scenewright.domains import plan_of
    from scenewright.formats.catalog_paths import with_more

    for path in (source, *catalogs, *groups):
        check_text(os.fspath(path), "the name of a file")
    try:
        brief = with_more(_read(source, keep, hidden_levels, scale), catalogs, groups, style)
        plan, domain = plan_of(brief), domain_of(brief.domain)
        if style and domain.has("refuse_style"):
            domain.verb("refuse_style")(brief)
        if domain.has("validate"):
            domain.verb("validate")(brief, plan)
    except InputError as error:
        raise error.located(file=str(source)) from None
    except ValidationError as error:
        raise to_input_error(error).located(file=str(source)) from None
    return brief, plan


def read(
    source: str | os.PathLike[str],
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
    scale: float = 1.0,
    hidden_levels: bool = False,
) -> Brief:
    """The brief in a file, or a sample, checked as by :func:`read_planned`.

    >>> read("sample:home-flat").rooms[1].name
    'Kitchen'
    """
    return read_planned(source, keep, catalogs, groups, scale, hidden_levels)[0]


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


def writer(path: str | os.PathLike[str], domain: str = "") -> Callable[..., None]:
    """The function that writes files named like ``path``; InputError if there is none, or if it
    does not hold what is of ``domain``."""
    from scenewright.core.document_faults import check_text

    check_text(os.fspath(path), "the name of a file")
    row = _row(path, "writer", domain)
    if domain and not row.holds(domain):
        raise InputError(
            f"only {row.domain}s can be written as {row.suffix}",
            "choose .glb, .svg or .json",
            file=str(path),
        )
    write_function: Callable[..., None] = _function(row.writer, "write", path)
    return write_function


def check_output(path: str | os.PathLike[str], brief: Brief) -> None:
    """Raise :class:`InputError` if no solution of a brief can be written to ``path``: there is no
    such format, it does not hold what is of this domain, or its module's ``check(brief)`` says."""
    writer(path, brief.domain)
    module = _module(_row(path, "writer", brief.domain).writer, path)
    try:
        getattr(module, "check", lambda _: None)(brief)
    except InputError as error:
        raise error.located(file=str(path)) from None


def omissions(path: str | os.PathLike[str], domain: str = "") -> tuple[str, ...]:
    """What the format of ``path`` does not hold of a solution, where its module says so.

    >>> "lamps and cameras" in omissions("flat.3d.dxf")
    True
    """
    return tuple(getattr(_module(_row(path, "writer", domain).writer, path), "OMITTED", ()))


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
    return tuple(sorted(SAMPLE + name for name in _sample_files()))


def formats() -> tuple[Format, ...]:
    """All formats: the rows above, those of the domains, and those other packages add."""
    from importlib.metadata import entry_points

    own = tuple(row for kind in domains() for row in kind.formats)
    return (
        FORMATS
        + own
        + tuple(
            _read_row(entry.name, entry.value)
            for entry in entry_points(group="scenewright.formats")
        )
    )


def _read_row(suffix: str, module: str) -> Format:
    """The row of a module of another package, which may only read or only write. One that cannot
    be imported is said to do both, so that its fault is reported when it is used."""
    try:
        found: ModuleType | None = import_module(module)
    except ImportError:
        found = None
    reads, writes = (found is None or hasattr(found, name) for name in ("read", "write"))
    return Format(suffix, module, module * reads, module * writes)


def _read(source: str | os.PathLike[str], keep: bool, hidden_levels: bool, scale: float) -> Brief:
    from scenewright.formats.brief_json import apply_scale

    if str(source).startswith(SAMPLE):
        return apply_scale(_sample(str(source)), scale)
    if f"{SAMPLE}{source}" in samples() and not Path(source).exists():
        raise InputError("is the name of a sample", f"say {SAMPLE}{source}")
    path = Path(source)
    if not path.suffix and not path.exists():
        raise InputError("there is no such file or folder", "check the path")
    row = _row(source, "reader") if not path.is_dir() else None
    if row is not None and not path.exists():
        raise InputError("there is no such file", "check the path")
    if row is None or not path.is_file():
        remedy = "add --batch for all in it" if path.is_dir() else "give the file itself"
        raise InputError("is a folder" if path.is_dir() else "is not a file", remedy)
    note_read(path)
    more: dict[str, Any] = {"hidden_levels": hidden_levels} if row.suffix in SWEET_HOME else {}
    reading = _function(row.reader, "read", source)
    scales = "scale" in signature(reading).parameters
    try:
        brief: Brief = reading(path, keep=keep, **more, **({"scale": scale} if scales else {}))
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror or error}", "check file permissions"
        ) from None
    return brief if scales else apply_scale(brief, scale)


def _sample(name: str) -> Brief:
    from scenewright.formats import brief_json

    if name not in samples():
        stems = [sample.removeprefix(SAMPLE) for sample in samples()]
        near = get_close_matches(name.removeprefix(SAMPLE), stems, 6, 0.5)
        some = ", ".join(SAMPLE + stem for stem in near or stems[:: len(stems) // 6])
        raise InputError(
            "there is no such sample", f"use one of: {some}; all: scenewright list samples"
        )
    return brief_json.loads(_sample_files()[name.removeprefix(SAMPLE)].read_bytes())


def _sample_files() -> dict[str, Any]:
    """The briefs in the folders ``samples`` of the domains, by name."""
    folders = [resources.files(kind.package) / "samples" for kind in domains()]
    return {
        file.name.removesuffix(".json"): file
        for folder in folders
        if folder.is_dir()
        for file in folder.iterdir()
        if file.name.endswith(".json")
    }


def domains() -> tuple[Domain, ...]:
    """All domains."""
    return tuple(domain_of(name) for name in domain_names())


def _row(path: str | os.PathLike[str], part: str, domain: str = "") -> Format:
    """The row of the longest suffix that fits, and of those the one of the domain."""
    name = Path(path).name.lower()
    suffix = Path(name).suffix
    fitting = [row for row in formats() if _fits(row, name) and getattr(row, part)]
    found = sorted(fitting, key=lambda row: (-len(row.suffix), not row.holds(domain)))
    if not found:
        rows = [
            row for row in formats() if getattr(row, part) and (not domain or row.holds(domain))
        ]
        usable = ", ".join(dict.fromkeys(row.suffix for row in rows))
        verb = "read" if part == "reader" else "written"
        text = f"'{suffix}' files cannot be {verb}" if suffix else "the name has no suffix"
        raise InputError(text, f"use one of: {usable}", file=str(path))
    return found[0]


def _fits(row: Format, name: str) -> bool:
    """Whether a file's name ends in a row's suffix, and has more than that."""
    return name.endswith(row.suffix) and len(name) > len(row.suffix)


def _function(module: str, name: str, path: str | os.PathLike[str]) -> Callable[..., Any]:
    """A function of the module of a format."""
    found: Callable[..., Any] | None = getattr(_module(module, path), name, None)
    if found is None:
        raise InputError(
            f"the format's module {module} has no function '{name}'",
            "use another format",
            file=str(path),
        )
    return found


def _module(name: str, path: str | os.PathLike[str]) -> ModuleType:
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        package = str(error.name).split(".")[0]
        remedy = f"pip install 'scenewright[{EXTRAS[package]}]'" if package in EXTRAS else ""
        raise InputError(
            f"this format needs the package '{package}'", remedy or "install it", file=str(path)
        ) from None
