"""The verb ``bench``: benchmarks live beside the source, in its folder ``benchmarks``.

A benchmark yields its records as they are measured, so that an interrupted run keeps those it has.
"""

from __future__ import annotations

import inspect
import json
import re
import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stdout
from importlib import import_module
from pathlib import Path
from types import FrameType
from typing import Any, Literal, NamedTuple

from scenewright.core.atomic_file import check_targets, whole_together
from scenewright.core.errors import InputError
from scenewright.core.extras import install_line
from scenewright.workflow.request import check_name

Record = dict[str, Any]
Extent = Literal["quick", "usual", "full"]
KEYS = ("case", "metric", "unit", "ours", "baseline", "baseline_name", "ratio", "runs")
"""What every record holds; ``runs`` is how many runs its medians or means are of."""
SUFFIXES = (".json", ".md")
"""What records can be written as."""
RECORDS = re.compile(r"^def records\(\s*quick\b", re.MULTILINE)
"""How a module that is a benchmark is known."""


MORE = {
    "full": ("--full", "benchmark '{}' always measures everything"),
    "rescaled": ("--rescaled", "benchmark '{}' has no plans to rescale"),
    "everything": ("--all", "benchmark '{}' has no more than it measures"),
    "seed": ("--seed", "benchmark '{}' draws nothing by a seed"),
    "count": ("--count", "benchmark '{}' draws no set"),
    "halls": ("--halls", "benchmark '{}' has no halls of its own"),
    "sheets": ("--sheets", "benchmark '{}' lays out no pictures"),
}
"""What some benchmarks can be asked: the option, and what is said where one cannot."""


class Measured(NamedTuple):
    """The records of a benchmark, and whether it was interrupted before it had them all."""

    records: tuple[Record, ...]
    interrupted: bool


def extent_of(quick: bool, full: bool) -> Extent:
    """How much is measured; InputError where both less and more are asked for."""
    if quick and full:
        raise InputError("--quick and --full exclude each other", "give one of them")
    return "quick" if quick else "full" if full else "usual"


def check_outputs(paths: Sequence[Path]) -> None:
    """InputError unless records can be written to every path, before any is measured."""
    for path in paths:
        if path.suffix not in SUFFIXES:
            raise InputError(
                f"benchmarks are not written as '{path.suffix}'",
                f"use {' or '.join(SUFFIXES)}",
                file=str(path),
            )
    check_targets(paths)


def write(paths: Sequence[Path], name: str, records: Sequence[Record]) -> None:
    """Write the records of a benchmark as JSON and as Markdown, all or none."""
    with whole_together(paths) as partials:
        for path, partial in zip(paths, partials, strict=True):
            lines = [json.dumps(list(records), indent=1)]
            if path.suffix == ".md":
                lines = list(markdown(name, records))
            partial.write_text("\n".join(lines) + "\n", encoding="utf-8")


def check_page(name: str, page: Path | None) -> None:
    """InputError unless a page, if one is given, has a place for the table of a benchmark."""
    if page is not None:
        _open_folder(name)
        import_module("benchmarks.page_tables").check_page(page, name)


def write_into(
    page: Path, name: str, extent: Extent, asked: Mapping[str, Any], records: Sequence[Record]
) -> None:
    """Write the table of a benchmark in its place in a page, with what it was made by."""
    words = ["" if extent == "usual" else f" --{extent}"]
    given = {w: v for w, v in _given(asked).items() if w not in ("everything", "sheets")}
    words += [f" --{w}" if v is True else f" --{w} {v}" for w, v in given.items()]
    command = f"scenewright bench {name}{''.join(words)}"
    import_module("benchmarks.page_tables").write_into(page, name, command, records)


def markdown(name: str, records: Sequence[Record]) -> Iterable[str]:
    """The tables a benchmark makes itself (``markdown_lines``), else one of all records."""
    own = getattr(import_module(f"benchmarks.{name}"), "markdown_lines", None)
    if own is not None:
        return list(own(list(records)))
    rows = [[str(record[key]) for key in KEYS] for record in records]
    cells = [list(KEYS), ["---"] * len(KEYS), *rows]
    return [f"| {' | '.join(row)} |" for row in cells]


def measure(
    name: str,
    extent: Extent,
    progress: Callable[[float, str], None],
    asked: Mapping[str, Any] | None = None,
) -> Measured:
    """Run one benchmark to its end or until Ctrl-C or SIGTERM; whatever it prints goes to the
    standard error. ``asked``: what else its ``records`` is to be given (:data:`MORE`)."""
    records: list[Record] = []
    try:
        with _termination_interrupts(), redirect_stdout(sys.stderr):
            for record in _run(name, extent, progress, asked or {}):
                missing = [key for key in KEYS if key not in record]
                if missing:
                    raise RuntimeError(f"bench {name}: a record lacks {', '.join(missing)}")
                records.append(record)
    except KeyboardInterrupt:
        return Measured(tuple(records), True)
    except ModuleNotFoundError as error:
        raise _missing_package(name, error) from None
    return Measured(tuple(records), False)


def _missing_package(name: str, error: ModuleNotFoundError) -> InputError | ModuleNotFoundError:
    """The refusal of a benchmark that needs a package of others; a module of ours that is missing
    is a fault of ours."""
    package = (error.name or "").partition(".")[0]
    if package in ("", "benchmarks", "scenewright"):
        return error
    return InputError(f"benchmark '{name}' needs the package '{package}'", install_line(package))


def _run(
    name: str, extent: Extent, progress: Callable[[float, str], None], asked: Mapping[str, Any]
) -> Iterable[Record]:
    _open_folder(name)
    function = import_module(f"benchmarks.{name}").records
    known = inspect.signature(function).parameters
    more = _given(asked)
    more |= {"full": True} if extent == "full" else {}
    for word in more:
        if word not in known:
            option, refusal = MORE[word]
            raise InputError(refusal.format(name), f"leave {option} out")
    return function(extent == "quick", progress, **more)


def _given(asked: Mapping[str, Any]) -> dict[str, Any]:
    """What was asked for; a seed of 0 is."""
    return {word: value for word, value in asked.items() if not (value is None or value is False)}


def _open_folder(name: str) -> None:
    """Make the checkout's benchmarks importable; InputError unless one has this name."""
    folder = find_folder()
    check_name("benchmark", name, names(folder))
    root = str(folder.parent)
    if root not in sys.path:
        sys.path.insert(0, root)


@contextmanager
def _termination_interrupts() -> Iterator[None]:
    """In the block Ctrl-C and SIGTERM raise ``KeyboardInterrupt`` and nothing else, so that the
    records measured so far are kept."""

    def interrupt(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = {}
    try:
        for number in (signal.SIGINT, signal.SIGTERM):
            before[number] = signal.signal(number, interrupt)
    except ValueError:  # not the main thread: leave signals alone
        yield
        return
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def names(folder: Path) -> list[str]:
    """Names of the benchmarks in a folder: its modules that have ``records(quick, …)``."""
    files = sorted(folder.glob("*.py"))
    return [f.stem for f in files if RECORDS.search(f.read_text(encoding="utf-8"))]


def find_folder() -> Path:
    """The checkout's benchmarks: from the current folder upwards, else beside this package."""
    here = Path.cwd()
    tops = [here, *here.parents, *Path(__file__).resolve().parents]
    for top in tops:
        if (top / "src" / "scenewright").is_dir() and (top / "benchmarks").is_dir():
            return top / "benchmarks"
    raise InputError("benchmarks need a source checkout", "run this inside one")
