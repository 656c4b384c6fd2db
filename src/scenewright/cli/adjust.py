"""The verb ``adjust``: move, swap, lock and let go pieces of a saved home, and solve the rest."""

from __future__ import annotations

from math import isfinite, radians
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer
from rich.console import Console

from scenewright.errors import InputError

if TYPE_CHECKING:
    from scenewright.solution import Solution


Names = list[str] | None


class Request(NamedTuple):
    """What the command line asks for."""

    file: Path
    outputs: list[Path]
    move: dict[str, tuple[float, ...]]
    swap: list[tuple[str, str]]
    lock: list[str]
    unlock: list[str]
    again: list[str]
    steps: int | None
    seed: int | None


def adjust(
    file: Annotated[Path, typer.Argument(metavar="SOLUTION.json", help="A saved home.")],
    outputs: Annotated[
        list[Path],
        typer.Option("-o", "--output", metavar="OUT", help="File to write; may be repeated."),
    ],
    move: Annotated[
        Names, typer.Option(metavar="PIECE=X,Y[,DEGREES]", help="Put a piece there and lock it.")
    ] = None,
    swap: Annotated[
        Names, typer.Option(metavar="PIECE,PIECE", help="Exchange two, and lock them.")
    ] = None,
    lock: Annotated[
        Names, typer.Option(metavar="PIECE", help="Keep it where it is from now on.")
    ] = None,
    unlock: Annotated[Names, typer.Option(metavar="PIECE", help="Let it go.")] = None,
    again: Annotated[
        Names, typer.Option(metavar="ROOM", help="Furnish a room anew around what is locked.")
    ] = None,
    steps: Annotated[int | None, typer.Option(min=1, help="Steps to solve for.")] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="Another seed, another answer.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Change a saved home by hand; only the rooms touched are solved again, all else stays.

    Pieces are named by id or enough of it: sofa, bedroom/bed, living/seating. May be repeated.
    """
    request = Request(
        file, outputs, dict(_pose(told) for told in move or ()), [_pair(p) for p in swap or ()],
        lock or [], unlock or [], again or [], steps, seed,
    )  # fmt: skip
    return _run(request, as_json, quiet)


def _run(request: Request, as_json: bool, quiet: bool) -> int:
    """Solve again, judge, write and tell; the exit code."""
    from scenewright.check import check
    from scenewright.cli import show, tables
    from scenewright.cli.arrange import check_outputs, write_together
    from scenewright.cli.progress import tell_if_cold, watching
    from scenewright.formats import solution_json

    check_outputs(request.outputs)
    before = solution_json.read(request.file)
    console = Console(stderr=True, quiet=quiet)
    tell_if_cold(console)
    with watching(console, console.quiet) as watch:
        solution = _resolved(before, request)
        report = check(solution)
        write_together(solution, request.outputs, watch)
    lost = any(out.required for out in set(solution.left_out) - set(before.left_out))
    code = 0 if report.valid and not lost else 1
    change = changed(before, solution)
    if as_json:
        shown = show.arranged_document(str(request.file), request.outputs, solution, report, code)
        tables.print_json(shown | {"changed": change})
    elif not quiet:
        show.adjusted(Console(), request.outputs, solution, report, change)
    return code


def _resolved(before: Solution, request: Request) -> Solution:
    from scenewright.domains import resolve

    try:
        return resolve(
            before, move=request.move, swap=request.swap, lock=request.lock,
            unlock=request.unlock, again=request.again, steps=request.steps, seed=request.seed,
        )  # fmt: skip
    except InputError as error:
        raise error.located(file=str(request.file)) from None


def changed(before: Solution, after: Solution) -> dict[str, list[str]]:
    """Ids of the pieces that are ``new``, ``moved`` or ``gone``, lamps and curtains left out."""
    old = {p.id: p for p in before.pieces if p.function != "light"}
    now = {p.id: p for p in after.pieces if p.function != "light"}
    return {
        "moved": [i for i, p in now.items() if i in old and p.pose != old[i].pose],
        "new": [i for i in now if i not in old],
        "gone": [i for i in old if i not in now],
    }


def _pose(told: str) -> tuple[str, tuple[float, ...]]:
    """``bed=1.2,3.4,90`` as a name and a pose in metres and radians.

    >>> _pose("bed=1.2,3.4")
    ('bed', (1.2, 3.4))
    """
    name, _, pose = told.partition("=")
    try:
        numbers = [float(part) for part in pose.split(",")]
    except ValueError:
        numbers = []
    if not name or len(numbers) not in (2, 3) or not all(isfinite(n) for n in numbers):
        raise InputError(
            f"--move {told} is no place", "say PIECE=X,Y or PIECE=X,Y,DEGREES, as bed=1.2,3.4,90"
        )
    return name, (*numbers[:2], *(radians(angle) for angle in numbers[2:]))


def _pair(told: str) -> tuple[str, str]:
    names = [part.strip() for part in told.split(",")]
    if len(names) != 2 or not all(names):
        raise InputError(f"--swap {told} is no pair", "say two pieces, as sofa,tv")
    return names[0], names[1]
