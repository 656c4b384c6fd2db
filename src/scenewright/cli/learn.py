"""The verb ``learn``: from real blocks, a style of villages, a file that ``--style`` takes, or the
networks of a paper, which ``--nets`` takes."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from scenewright.cli import tables, terminal
from scenewright.cli.progress import watching
from scenewright.core.errors import InputError


def learn(
    domain: Annotated[str, typer.Argument(metavar="KIND", help="village.")],
    sources: Annotated[
        list[Path],
        typer.Argument(metavar="DATA...", help="Blocks with houses: .json lists, maps, folders."),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="OUT.npz")],
    paper: Annotated[
        bool, typer.Option("--paper", help="Networks of Zhu, Jiang and Li (2022) instead.")
    ] = False,
    size: Annotated[str | None, typer.Option(help="Of these: printed (default) or small.")] = None,
    device: Annotated[str | None, typer.Option(help="Of these: cpu (default) or cuda.")] = None,
    jobs: Annotated[
        int | None, typer.Option(min=0, help="Of these: processes that make views.")
    ] = None,
    hold_out: Annotated[
        list[str] | None,
        typer.Option("--hold-out", metavar="PLACE", help="Not to learn from; may be repeated."),
    ] = None,
    kind: Annotated[
        list[str] | None, typer.Option(metavar="KIND", help="Kinds of places to learn from.")
    ] = None,
    epochs: Annotated[
        int | None, typer.Option(min=1, max=1000, help="How often blocks are seen.")
    ] = None,
    budget: Annotated[
        float | None, typer.Option(min=0, help="Processor seconds of training, at most.")
    ] = None,
    look: Annotated[str | None, typer.Option(help="Look of houses built in the style.")] = None,
    licence: Annotated[str, typer.Option(help="Licence of the data, for the card.")] = "",
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same style.")] = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Learn a style from real blocks. A run that was stopped goes on where it was."""
    from scenewright.domains import learn_from
    from scenewright.formats import read_planned

    options: dict[str, Any] = {"held": tuple(hold_out or ()), "kinds": tuple(kind or ())}
    options |= {"seed": seed, "epochs": epochs, "budget": budget, "licence": licence}
    options |= _own_options(paper, {"size": size, "device": device, "jobs": jobs}, look)
    with watching(terminal.console(stderr=True, quiet=quiet or as_json), quiet) as watch:
        learned = learn_from(
            "nets" if paper else "style",
            domain,
            sources,
            output,
            {key: value for key, value in options.items() if value is not None},
            lambda path: read_planned(path)[1],
            watch.progress,
            watch.cancelled,
        )
    if as_json:
        tables.print_json({"file": str(output), **learned._asdict()})
    elif not quiet:
        console = tables.output_console()
        rows = [{"figure": key, "value": _text(value)} for key, value in learned.card.items()]
        tables.table(console, rows, title="networks" if paper else "style")
        done = f"wrote {output}" if learned.written else "stopped; the same command goes on"
        tables.print_line(console, f"{learned.seconds:.0f} s of training; {done}", "dim")
    return 0 if learned.written else 130


def _own_options(paper: bool, own: dict[str, Any], look: str | None) -> dict[str, Any]:
    """The options of networks or of a style; InputError for those of the other."""
    if not paper and any(value is not None for value in own.values()):
        raise InputError("--size, --device and --jobs are of the networks", "add --paper")
    if paper and look is not None:
        raise InputError("--look is of a style", "leave it or --paper out")
    return own if paper else {"look": look}


def _text(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {row}" for key, row in value.items())
    return ", ".join(map(str, value)) if isinstance(value, list) else str(value)
