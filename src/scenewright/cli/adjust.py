"""The verb ``adjust``: move, swap, lock and release pieces of a saved scene; solve the rest."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from math import isfinite, pi, radians
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scenewright.cli import completion
from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from scenewright.core.edits import Change
    from scenewright.workflow.adjust import AdjustRequest


Names = list[str] | None
MOST_OF_ONE = 6
"""Pieces of one group that are named one by one."""
RADIANS_MEANT = 0.003
"""A heading so near to eighths of a turn in radians, 1.57 as well as 1.5708, is not in degrees."""


def adjust(
    file: Annotated[Path, typer.Argument(metavar="SOLUTION.json", help="A saved scene.")],
    outputs: Annotated[
        list[Path],
        typer.Option(
            "-o",
            "--output",
            metavar="OUT",
            help="Output file; may be repeated.",
            autocompletion=completion.outputs,
        ),
    ],
    move: Annotated[
        Names, typer.Option(metavar="PIECE=X,Y[,DEGREES]", help="Put a piece there and lock it.")
    ] = None,
    swap: Annotated[
        Names, typer.Option(metavar="PIECE,PIECE", help="Swap two pieces and lock them.")
    ] = None,
    lock: Annotated[
        Names, typer.Option(metavar="PIECE", help="Keep the piece where it is.")
    ] = None,
    unlock: Annotated[Names, typer.Option(metavar="PIECE", help="Release a locked piece.")] = None,
    again: Annotated[
        Names, typer.Option(metavar="SPACE", help="Arrange a space again around its locked pieces.")
    ] = None,
    steps: Annotated[int | None, typer.Option(min=1, help="Search budget in steps.")] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="Seed of the random numbers.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Change a saved scene by hand: only what the change affects is solved again.

    A piece is named by its id or an unambiguous part of it: sofa, bedroom/bed, living/seating.
    Options may be repeated.
    """
    from scenewright.workflow.adjust import AdjustRequest

    both = sorted(set(lock or ()) & set(unlock or ()))
    if both:
        raise InputError(f"{both[0]} is to be locked and released", "leave out one of the two")
    request = AdjustRequest(
        file,
        tuple(outputs),
        dict(_pose(text) for text in move or ()),
        tuple(_pair(p) for p in swap or ()),
        tuple(lock or ()),
        tuple(unlock or ()),
        tuple(again or ()),
        steps,
        seed,
    )
    return _run(request, as_json, quiet)


def _run(request: AdjustRequest, as_json: bool, quiet: bool) -> int:
    """Solve again, check, write and report; the exit code."""
    from scenewright.cli import show, tables, terminal
    from scenewright.cli.arrange import follow
    from scenewright.workflow.adjust import adjust_file

    console = terminal.console(stderr=True, quiet=quiet)
    done, _ = follow(lambda _: adjust_file(request), console, stoppable=False)
    solution, plan, report, changes, complete = done
    code = 0 if complete else 1
    if as_json:
        shown = show.arranged_document(
            str(request.file), request.outputs, solution, plan, report, code
        )
        listed = [change._asdict() for change in changes]
        tables.print_json(shown | {"changed": list_changes(changes), "changes": listed})
    elif not quiet:
        show.print_adjusted(
            tables.output_console(),
            request.outputs,
            solution,
            plan,
            report,
            lines(changes) or _tell_same(request, solution.seed),
        )
    return code


def _tell_same(request: AdjustRequest, seed: int) -> list[str]:
    """What helps where a room arranged again is as it was: its seed was that of the file."""
    return [f"nothing changed; try --seed {seed + 1}"] if request.again else []


def list_changes(changes: Sequence[Change]) -> dict[str, list[str]]:
    """Ids of the pieces that are ``moved``, ``new`` or ``gone``."""
    return {how: [c.piece for c in changes if c.change == how] for how in ("moved", "new", "gone")}


def lines(changes: Sequence[Change]) -> list[str]:
    """The changes in words, those of one kind and reason on one line."""
    values: dict[tuple[str, str], list[str]] = {}
    for change in changes:
        renamed = change.was not in ("", change.piece)
        name = f"{change.was} -> {change.piece}" if renamed else change.piece
        values.setdefault((change.change, change.reason), []).append(name)
    return [f"{how}: {', '.join(_join(names))} ({why})" for (how, why), names in values.items()]


def _join(names: Sequence[str]) -> list[str]:
    """Names of pieces, those of one group together where there are more than :data:`MOST_OF_ONE`.

    >>> _join(["a/bed", *(f"hall/seats/seat_{k}" for k in range(40))])
    ['a/bed', 'hall/seats (40 pieces)']
    """
    groups = Counter(name.rpartition("/")[0] for name in names)
    many = {group for group, count in groups.items() if group and count > MOST_OF_ONE}
    owners = {name: name.rpartition("/")[0] for name in names}
    shown = (
        f"{owners[name]} ({groups[owners[name]]} pieces)" if owners[name] in many else name
        for name in names
    )
    return list(dict.fromkeys(shown))


def _pose(argument: str) -> tuple[str, tuple[float, ...]]:
    """``bed=1.2,3.4,90`` as a name and a pose in metres and radians.

    >>> _pose("bed=1.2,3.4")
    ('bed', (1.2, 3.4))
    """
    name, _, pose = argument.partition("=")
    name = name.strip()
    try:
        numbers = [float(part) for part in pose.split(",")]
    except ValueError:
        numbers = []
    if not name or len(numbers) not in (2, 3) or not all(isfinite(n) for n in numbers):
        raise InputError(
            f"--move {argument} is not a place",
            "give PIECE=X,Y or PIECE=X,Y,DEGREES, as bed=1.2,3.4,90",
        )
    for angle in numbers[2:]:
        _check_degrees(angle, argument)
    return name, (*numbers[:2], *(radians(angle) for angle in numbers[2:]))


def _check_degrees(angle: float, argument: str) -> None:
    """InputError for what is no angle in degrees: beyond a full turn, or an eighth of a turn or
    several written in radians.

    >>> _check_degrees(90.0, "bed=1,2,90"), _check_degrees(1.5, "bed=1,2,1.5")
    (None, None)
    """
    if abs(angle) > 360:
        raise InputError(f"--move {argument}: {angle:g} is no heading", "give degrees, -360 to 360")
    eighths = round(angle / (pi / 4))
    if eighths and abs(eighths) <= 8 and abs(angle - eighths * pi / 4) < RADIANS_MEANT:
        raise InputError(
            f"--move {argument}: the heading seems to be in radians",
            f"give degrees: {45 * eighths}",
        )


def _pair(argument: str) -> tuple[str, str]:
    names = [part.strip() for part in argument.split(",")]
    if len(names) != 2 or not all(names):
        raise InputError(f"--swap {argument} is not a pair", "give two pieces, as sofa,tv")
    return names[0], names[1]
