"""The verb ``evolve``: a numbered contact sheet, a prompt, and better layouts from what is said."""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import typer

from scenewright.cli import completion
from scenewright.cli.reading import OutputsOption
from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from rich.console import Console

    from scenewright.workflow.evolution.candidate import Screen
    from scenewright.workflow.evolve import Evolution

LOG, SHEET = ".evolution", "-sheet.png"
"""What the log and the sheet are called after the first output."""
LOOKED = 0.5
"""Seconds between looks while the person thinks."""


class EvolveRequest(NamedTuple):
    """What the command line asks for."""

    source: str | None
    outputs: tuple[Path, ...]
    log: Path
    sheet: Path
    resumed: bool
    views: bool
    seed: int
    say: str | None
    method: str


def evolve(
    source: Annotated[
        str | None,
        typer.Argument(
            metavar="[INPUT]", help="A file, or sample:NAME.", autocompletion=completion.inputs
        ),
    ] = None,
    outputs: OutputsOption = None,
    resume: Annotated[
        Path | None, typer.Option("--from", metavar="LOG", help="Go on with a saved evolution.")
    ] = None,
    log: Annotated[
        Path | None, typer.Option(metavar="LOG", help="Where all that is said is kept.")
    ] = None,
    sheet: Annotated[
        Path | None, typer.Option(metavar="SHEET.png", help="The contact sheet.")
    ] = None,
    views: Annotated[bool, typer.Option("--views", help="Views instead of plans.")] = False,
    say: Annotated[
        str | None,
        typer.Option(metavar="LINES", help="What to say, instead of the prompt: 3; done"),
    ] = None,
    method: Annotated[
        str, typer.Option(help="By a paper's genetic algorithm: vp, tiga, ciga, siga, sga.")
    ] = "",
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same candidates.")] = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Look at a dozen layouts at a time, say what you think, get better ones; done writes OUT."""
    request = _read_request(source, outputs or [], resume, log, sheet, views, seed, say, method)
    return _run(request, as_json, quiet)


def _read_request(
    source: str | None,
    outputs: list[Path],
    resume: Path | None,
    log: Path | None,
    sheet: Path | None,
    views: bool,
    seed: int,
    say: str | None,
    method: str = "",
) -> EvolveRequest:
    """The request, with names for what is not named."""
    if source is None and resume is None:
        raise InputError("there is nothing to evolve", "give a file, sample:NAME or --from LOG")
    if source is not None and resume is not None:
        raise InputError("INPUT and --from exclude each other", "the log holds its brief")
    first = outputs[0] if outputs else Path(resume or "evolution.json")
    base = first.with_name(first.name.split(".")[0] or "evolution")
    kept = resume or log or base.with_name(base.name + LOG)
    drawn = sheet or base.with_name(base.name + SHEET)
    if drawn.suffix.lower() != ".png":
        raise InputError("sheets are .png files", "choose such a name", file=str(drawn))
    if method and resume is not None:
        raise InputError("--method and --from exclude each other", "the log holds its method")
    return EvolveRequest(
        source, tuple(outputs), kept, drawn, resume is not None, views, seed, say, method
    )


def _run(request: EvolveRequest, as_json: bool, quiet: bool) -> int:
    from scenewright.cli import tables, terminal
    from scenewright.core.atomic_file import check_distinct, check_targets
    from scenewright.formats import check_outputs
    from scenewright.workflow.evolution.best_picture import name_picture
    from scenewright.workflow.evolve import evolve as begin
    from scenewright.workflow.evolve import resume_evolution

    pictures = (request.sheet, name_picture(request.sheet), name_stages(request.sheet))
    check_outputs(request.outputs)
    check_targets(pictures)
    check_distinct([request.log, *request.outputs, *pictures])
    console = terminal.console(stderr=True, quiet=quiet or as_json)
    if request.resumed:
        evolution = resume_evolution(request.log)
    else:
        evolution = begin(
            str(request.source), request.log, seed=request.seed, method=request.method
        )
    with evolution:
        show_stages(evolution, request, console)
        ended = _converse(evolution, request, console)
        code = _write(evolution, request, console) if ended == "done" else 0
        if as_json:
            tables.print_json(document(evolution, request, ended, code))
        elif ended != "done":
            advice = f"nothing written; go on with --from {request.log}"
            tables.print_line(console, advice, "dim", whole=True)
    return code


def show_stages(evolution: Evolution, request: EvolveRequest, console: Console) -> None:
    """Show what a method did before the first sheet, and keep it beside the sheet."""
    from json import dumps

    from scenewright.cli.tables import print_line
    from scenewright.core.atomic_file import write_atomically

    if request.resumed or not (stages := evolution.stages):
        return
    for stage in stages:
        for line in stage.lines:
            print_line(console, f"{stage.name}: {line}", "dim")
    kept, path = {stage.name: dict(stage.facts) for stage in stages}, name_stages(request.sheet)
    write_atomically(path, dumps(kept, ensure_ascii=False, indent=1) + "\n")
    print_line(console, f"stages: {path}", whole=True)


def name_stages(sheet: Path) -> Path:
    """The file that stages are kept in, beside a sheet.

    >>> name_stages(Path("court-sheet.png")).name
    'court-stages.json'
    """
    return sheet.with_name(sheet.stem.removesuffix("-sheet") + "-stages.json")


def _converse(evolution: Evolution, request: EvolveRequest, console: Console) -> str:
    """Show sheets and hear lines until ``done`` or ``quit``; which of them. A line that cannot be
    meant gets a line that says so, and ends a run that was given its lines beforehand."""
    from scenewright.cli.tables import print_line
    from scenewright.workflow.evolution.best_picture import name_picture, watch_best

    screen = evolution.screen or _ask(evolution, console)
    show_screen(screen, evolution, request, console)
    picture = name_picture(request.sheet)
    for line in _lines(request, watch_best(evolution, picture, request.views)):
        try:
            ended = _obey(line, evolution, request, console)
        except InputError as error:
            if request.say is not None:
                raise
            print_line(console, str(error))
            continue
        if ended:
            return ended
    return "quit"


def _lines(request: EvolveRequest, look: Callable[[], None]) -> Iterator[str]:
    """What is said: the lines given, else those typed or piped in; ``look`` is taken now and then
    while the person thinks."""
    if request.say is not None:
        yield from (part.strip() for part in request.say.split(";"))
        return
    while True:
        if sys.stdin.isatty():
            sys.stderr.write("evolve> ")
            sys.stderr.flush()
        wait_for_line(look)
        line = sys.stdin.readline()
        if not line:
            return
        yield line


def wait_for_line(look: Callable[[], None]) -> None:
    """Return when a line was typed at a terminal, looking every :data:`LOOKED` seconds; at once
    where nobody types."""
    if os.name != "posix" or not sys.stdin.isatty():
        return
    while not select.select([sys.stdin], [], [], LOOKED)[0]:
        look()


def _obey(line: str, evolution: Evolution, request: EvolveRequest, console: Console) -> str:
    """Do what a line says; ``done`` or ``quit`` where it ends the evolution."""
    from scenewright.cli.tables import print_line
    from scenewright.workflow.evolution import words

    screen = evolution.screen
    assert screen is not None
    shown = [one.number for one in screen.candidates]
    said = evolution.said_of_screen
    meant = words.parse_line(line, shown, screen.number, said, evolution.reasons, screen.champion)
    if not isinstance(meant, words.Command):
        evolution.tell(*meant)
        for event in meant:
            print_line(console, words.describe_event(event, shown), "dim")
        return ""
    if meant.verb == "done" and evolution.champion is None:
        raise InputError("there is no champion to write", "pick one first: 3")
    if meant.verb in ("done", "quit"):
        return meant.verb
    _do(meant, evolution, request, console, shown)
    return ""


def _do(
    command: Any, evolution: Evolution, request: EvolveRequest, console: Console, shown: list[int]
) -> None:
    """Commands that go on."""
    from math import radians

    from scenewright.cli.tables import print_line
    from scenewright.workflow.evolution import words

    match command:
        case words.Command("next"):
            show_screen(_ask(evolution, console), evolution, request, console)
        case words.Command("undo"):
            event = evolution.undo()
            note = (
                "nothing to take back"
                if event is None
                else "taken back: " + words.describe_event(event, shown)
            )
            print_line(console, note, "dim")
        case words.Command("help"):
            for line in words.HELP.splitlines():
                print_line(console, line)
        case words.Command("best"):
            from scenewright.workflow.evolution.best_picture import (
                draw_best,
                name_picture,
                tell_best,
            )

            picture = name_picture(request.sheet)
            drawn, best = draw_best(evolution, picture, request.views), tell_best(evolution)
            print_line(console, best if drawn is None else f"{picture}: {best}", whole=True)
        case words.Command("names"):
            for line in words.list_names(evolution, shown[0]):
                print_line(console, line, whole=True)
        case words.Command("reasons"):
            print_line(console, ", ".join(evolution.reasons) or "no reasons for this kind of scene")
        case words.Command("auto", rounds):
            count = evolution.rate_itself(rounds)
            print_line(console, f"{count} candidates bred on what is *predicted*", "dim")
            show_screen(_ask(evolution, console), evolution, request, console)
        case words.Command("move", number, name, (x, y, *degrees)):
            pose = (x, y, *(radians(angle) for angle in degrees))
            made = evolution.edit(number, move={name: pose})
            print_line(console, f"moved: candidate {made.number}, better than it was", "dim")


def _ask(evolution: Evolution, console: Console) -> Screen:
    """The next screen, with a bar where it takes long."""
    from scenewright.cli.progress import show_progress

    with show_progress(console, console.quiet) as progress:
        return evolution.ask(progress)


def show_screen(
    screen: Screen, evolution: Evolution, request: EvolveRequest, console: Console
) -> None:
    """Draw the sheet of a screen and tell where it is."""
    from scenewright.cli.tables import print_line
    from scenewright.render.contact_sheet import SheetEntry, draw_sheet, write_sheet

    entries = []
    for place, one in enumerate(screen.candidates, 1):
        picture = one.view() if request.views else one.picture()
        champion = one.number == screen.champion
        note = "" if one.chance is None else f"predicted: picked {100 * one.chance:.0f} %"
        told = ["champion" if champion else "", note, one.faults()]
        text = " · ".join(filter(None, told))
        entries.append(SheetEntry(picture, str(place), text, champion))
    title = f"{evolution.brief.name}: sheet {screen.number + 1}"
    below = f"method: {evolution.method}" if evolution.method else f"predictions: {screen.trust}"
    write_sheet(draw_sheet(entries, title, below), request.sheet)
    print_line(console, f"sheet {screen.number + 1}: {request.sheet}", whole=True)
    for note in evolution.notes:
        print_line(console, note, "dim")
    if request.say is None and sys.stdin.isatty():
        from scenewright.workflow.evolution.best_picture import name_picture

        note = f"best bred so far for the next: {name_picture(request.sheet)}"
        print_line(console, note, "dim", whole=True)
    if screen.trust.screens:
        print_line(console, str(screen.trust), "dim")


def _write(evolution: Evolution, request: EvolveRequest, console: Console) -> int:
    """Write the champion to all outputs, and tell what it is; the exit code."""
    from scenewright.cli import show, tables
    from scenewright.domains import check
    from scenewright.workflow.events import run_to_end
    from scenewright.workflow.writing import write_all

    champion = evolution.champion
    assert champion is not None
    solution, plan = champion.solution, champion.plan
    run_to_end(write_all([(solution, path) for path in request.outputs], plan))
    report = check(solution, plan=plan)
    complete = report.valid and not any(out.required for out in solution.left_out)
    if not console.quiet:
        show.print_arranged(tables.output_console(), request.outputs, solution, plan, report)
    return 0 if complete else 1


def document(evolution: Evolution, request: EvolveRequest, ended: str, code: int) -> dict[str, Any]:
    """What a machine reads: how it ended, the champion, all that was said, and the trust."""
    from scenewright.engine.preference.events import record_of

    champion = evolution.champion
    return {
        "ended": ended,
        "code": code,
        "outputs": [str(path) for path in request.outputs] if ended == "done" else [],
        "log": str(request.log),
        "sheet": str(request.sheet),
        "champion": None if champion is None else champion.figures(),
        "events": [record_of(event) for event in evolution.events],
        "trust": evolution.trust._asdict() | {"enough": evolution.trust.enough},
    }
