"""The verb ``adjust``: change a saved scene by hand; solve what that touches."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scenewright.cli import completion
from scenewright.cli.edit_arguments import (
    check_locks,
    read_addition,
    read_pair,
    read_pose,
    read_size,
    read_word,
)

if TYPE_CHECKING:
    from scenewright.workflow.adjust import AdjustRequest


Names = list[str] | None
Move = Annotated[
    Names, typer.Option(metavar="PIECE=X,Y[,DEGREES]", help="Put a piece there and lock it.")
]
Swap = Annotated[Names, typer.Option(metavar="PIECE,PIECE", help="Swap two pieces and lock them.")]
Lock = Annotated[Names, typer.Option(metavar="PIECE", help="Keep the piece where it is.")]
Unlock = Annotated[Names, typer.Option(metavar="PIECE", help="Release a locked piece.")]
Again = Annotated[
    Names, typer.Option(metavar="SPACE", help="Arrange a space again around its locked pieces.")
]
Add = Annotated[
    Names,
    typer.Option(metavar="MODEL=X,Y[,DEGREES]", help="Put a model of the catalog in, and lock it."),
]
Remove = Annotated[Names, typer.Option(metavar="PIECE", help="Take a piece away.")]
Duplicate = Annotated[Names, typer.Option(metavar="PIECE", help="Put another like it beside it.")]
Exchange = Annotated[
    Names, typer.Option(metavar="PIECE=MODEL", help="Put another model in its place.")
]
Resize = Annotated[
    Names, typer.Option(metavar="PIECE=W,D,H", help="Make a piece another size, in metres.")
]
Restyle = Annotated[
    Names,
    typer.Option(metavar="PIECE=STYLE", help="Exchange a piece, or all of a space, by style."),
]
Accept = Annotated[
    Names, typer.Option(metavar="KIND[:PIECE]=REASON", help="Accept findings of a kind, or of one.")
]


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
    move: Move = None,
    swap: Swap = None,
    lock: Lock = None,
    unlock: Unlock = None,
    again: Again = None,
    remove: Remove = None,
    exchange: Exchange = None,
    resize: Resize = None,
    restyle: Restyle = None,
    duplicate: Duplicate = None,
    add: Add = None,
    accept: Accept = None,
    steps: Annotated[int | None, typer.Option(min=1, help="Search budget in steps.")] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="Seed of the random numbers.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Change a saved scene by hand: only what the change affects is solved again.

    A piece is named by its id or an unambiguous part of it: sofa, bedroom/bed, living/seating.
    Options may be repeated. Models and styles: scenewright list assets, scenewright list styles.
    """
    from scenewright.workflow.adjust import AdjustRequest

    check_locks(lock or (), unlock or ())
    asked = {
        "move": dict(map(read_pose, move or ())),
        "swap": tuple(map(read_pair, swap or ())),
        "lock": tuple(lock or ()),
        "unlock": tuple(unlock or ()),
        "again": tuple(again or ()),
        "remove": tuple(remove or ()),
        "exchange": dict(read_word(text, "--exchange", "PIECE=MODEL") for text in exchange or ()),
        "resize": dict(map(read_size, resize or ())),
        "restyle": dict(read_word(text, "--restyle", "PIECE=STYLE") for text in restyle or ()),
        "duplicate": tuple(duplicate or ()),
        "add": tuple(map(read_addition, add or ())),
        "accept": dict(read_word(text, "--accept", "KIND=REASON") for text in accept or ()),
    }
    edits = {verb: what for verb, what in asked.items() if what}
    return _run(AdjustRequest(file, tuple(outputs), edits, steps, seed), as_json, quiet)


def _run(request: AdjustRequest, as_json: bool, quiet: bool) -> int:
    """Solve again, check, write and report; the exit code."""
    from scenewright.cli import show, tables, terminal
    from scenewright.cli.arrange import follow
    from scenewright.workflow.adjust import adjust_file
    from scenewright.workflow.changes import describe_changes, list_changes
    from scenewright.workflow.documents import arranged_document

    console = terminal.console(stderr=True, quiet=quiet)
    done, _ = follow(lambda _: adjust_file(request), console, stoppable=False)
    solution, plan, report, changes, complete = done
    code = 0 if complete else 1
    if as_json:
        shown = arranged_document(str(request.file), request.outputs, solution, plan, report, code)
        listed = [change._asdict() for change in changes]
        tables.print_json(shown | {"changed": list_changes(changes), "changes": listed})
    elif not quiet:
        show.print_adjusted(
            tables.output_console(),
            request.outputs,
            solution,
            plan,
            report,
            describe_changes(changes) or _tell_same(request, solution.seed),
        )
    return code


def _tell_same(request: AdjustRequest, seed: int) -> list[str]:
    """What helps where a room arranged again is as it was: its seed was that of the file."""
    return [f"nothing changed; try --seed {seed + 1}"] if "again" in request.edits else []
