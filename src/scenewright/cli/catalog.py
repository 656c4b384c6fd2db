"""The verb ``catalog``: furniture of one's own, looked through, registered, learned from homes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console

from scenewright.cli import clusters, tables, terminal
from scenewright.core.atomic_file import check_targets, write_atomically
from scenewright.core.errors import InputError
from scenewright.text import quantity

if TYPE_CHECKING:
    from scenewright.catalog.loading import ReadCatalog
    from scenewright.catalog.models.listing import Listed

app = typer.Typer(
    help="Your own furniture: inspect it, register it, learn groups from furnished homes.",
    no_args_is_help=True,
)

app.command()(clusters.cluster)

Json = Annotated[bool, typer.Option("--json", help="Print one JSON document only.")]
Named = Annotated[str, typer.Argument(metavar="CATALOGUE", help="A path or a registered name.")]
FURNISHED = (".sh3d", ".xml")
"""Homes that tell how they are furnished, by suffix."""
SHOWN = ("id", "category", "front", "size", "sure", "colour", "author", "why")


@app.command()
def add(
    path: Annotated[Path, typer.Argument(help="A folder of models, a library or one file.")],
    name: Annotated[
        str | None, typer.Option(help="Name of the catalogue; by default that of the file.")
    ] = None,
    replace: Annotated[bool, typer.Option(help="Take the place of one of that name.")] = False,
    as_json: Json = False,
) -> int:
    """Register a catalogue: remember where it is and what each of its models is taken for."""
    from scenewright.catalog.loading import read_entry
    from scenewright.catalog.models import register
    from scenewright.catalog.models.listing import csv_text, rows
    from scenewright.core.brief.catalog import entry_of

    called = register.check_name(name or path.stem or path.absolute().name)
    if called in register.names() and not replace:
        raise InputError(f"'{called}' is registered already", "give --replace or another --name")
    before = register.read_saved_files(called)
    folder = register.register(called, path, csv_text([]))
    try:
        found = read_entry(entry_of(called))
    except InputError:
        register.restore(called, before)
        raise
    register.register(called, path, csv_text(rows(found.models)))
    counts = _counts(found)
    if as_json:
        tables.print_json({"name": called, "table": str(folder / register.TABLE)} | counts)
        return 0
    console = tables.output_console()
    tables.print_line(console, f"{called}: {_summary(counts)}")
    tables.print_line(console, f"edit {folder / register.TABLE} to correct it", "dim", whole=True)
    return 0


@app.command("list")
def list_(as_json: Json = False) -> int:
    """List the registered catalogues."""
    from scenewright.catalog.models import register
    from scenewright.catalog.models.listing import table_of

    found = []
    for name in register.names():
        file = register.table_file(name)
        table = table_of(file) if file.is_file() else {}
        used = [c for c in table.values() if c.get("category") not in ("", "other")]
        path = register.where(name)
        found.append(
            {
                "name": name,
                "models": len(table),
                "usable": len(used),
                "path": str(path),
                "there": path.exists(),
            }
        )
    if as_json:
        tables.print_json(found)
    elif found:
        tables.table(tables.output_console(), found, title="catalogues", whole=("name", "path"))
    else:
        tables.print_line(tables.output_console(), "none yet: scenewright catalog add PATH", "dim")
    return 0


@app.command("show")
def show_(
    catalogue: Named,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT", help="A .png sheet or a .csv.")
    ] = None,
    category: Annotated[str | None, typer.Option(help="Only models of this category.")] = None,
    as_json: Json = False,
) -> int:
    """Show what each model of a catalogue is taken for, as a table or a sheet of pictures."""
    from scenewright.catalog.loading import read_entry
    from scenewright.catalog.models.listing import rows
    from scenewright.cli.show_input import print_input
    from scenewright.core.brief.catalog import entry_of
    from scenewright.workflow.documents import report_document

    found = read_entry(entry_of(catalogue))
    if output is not None:
        check_targets([output])
    models = [one for one in found.models if category in (None, one.category)]
    if not models:
        known = ", ".join(sorted({one.category for one in found.models}))
        raise InputError(f"holds no model of category '{category}'", f"it has: {known}")
    console = tables.output_console()
    if output is not None:
        _write(models, output, console, as_json)
    if as_json:
        tables.print_json(
            {"models": rows(models), "skipped": [s._asdict() for s in found.skipped]}
            | _counts(found)
            | report_document(found.report)
        )
        return 0
    if output is None:
        tables.table(console, [_row(one) for one in models], title=catalogue, whole=("id",))
        print_input(console, found.report)
    tables.print_line(console, _summary(_counts(found)))
    return 0


@app.command()
def learn(
    homes: Annotated[list[str], typer.Argument(metavar="HOME...", help="Furnished .sh3d or .xml.")],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="GROUPS.json")],
    as_json: Json = False,
) -> int:
    """Learn furniture groups from furnished homes: what goes together, how, in which sizes."""
    from scenewright import formats
    from scenewright.domains import learn_groups

    for home in homes:
        if not home.lower().endswith(FURNISHED):
            remedy = f"give files of Sweet Home 3D: {' or '.join(FURNISHED)}"
            raise InputError("is not a furnished home to learn from", remedy, file=home)
    check_targets([output])
    briefs = {home: formats.read(home, keep=True) for home in homes}
    check_targets([output])
    found = learn_groups(briefs, output)
    if as_json:
        tables.print_json(found.document)
        return 0
    console = tables.output_console()
    tables.table(console, list(found.rows), title="learned groups")
    rooms, read = quantity(found.rooms, "furnished room"), quantity(len(homes), "home")
    text = f"{rooms} of {read}; wrote {output}"
    tables.print_line(console, text, "dim")
    return 0


def _write(models: Sequence[Listed], output: Path, console: Console, quiet: bool) -> None:
    """The sheet of pictures or the table."""
    from scenewright.catalog.models.as_asset import lighter
    from scenewright.catalog.models.listing import csv_text, rows
    from scenewright.catalog.models.model import ImportOptions
    from scenewright.cli.view import draw_watched
    from scenewright.workflow.portraits import Sitter, ViewRequest, list_skipped

    if output.suffix.lower() == ".csv":
        try:
            write_atomically(output, csv_text(rows(models)))
        except OSError as error:
            raise InputError(
                f"cannot be written: {error.strerror or error}",
                "choose another place",
                file=str(output),
            ) from None
    else:
        if output.suffix.lower() != ".png":
            raise InputError("is neither .png nor .csv", "choose such a name", file=str(output))
        order = sorted(models, key=lambda one: (one.category == "other", one.category))
        sitters = [
            Sitter(f"{one.category}: {one.model.name}", one.model.source, lighter(one.model.parts))
            for one in order
        ]
        request = ViewRequest((), output, "picture", ImportOptions())
        viewed = draw_watched(sitters, request, terminal.console(stderr=True, quiet=quiet))
        for line in [] if quiet else list_skipped(viewed):
            tables.print_line(console, line, "dim")
    if not quiet:
        tables.print_line(console, f"wrote {output}", "dim", whole=True)


def _row(one: Listed) -> dict[str, Any]:
    size = " x ".join(f"{side:.2f}" for side in one.model.size)
    cells = {
        "id": one.model.id,
        "category": "skipped" if one.skip else one.category,
        "front": one.front,
        "size": size,
        "sure": one.sure,
        "colour": one.colour,
        "author": one.model.author,
        "why": one.why,
    }
    return {key: cells[key] for key in SHOWN}


def _counts(found: ReadCatalog) -> dict[str, Any]:
    """How many models can be used, by category, how many only where named, how many not at all."""
    usable = Counter(m.category for m in found.models if m.category != "other" and not m.skip)
    return {
        "usable": usable.total(),
        "other": sum(m.category == "other" and not m.skip for m in found.models),
        "skipped": len(found.skipped) + sum(m.skip for m in found.models),
        "categories": dict(sorted(usable.items())),
    }


def _summary(counts: dict[str, Any]) -> str:
    models, kinds = counts["usable"], len(counts["categories"])
    text = f"{quantity(models, 'model')} of {quantity(kinds, 'category')}"
    return f"{text}, {counts['other']} used only where named, {counts['skipped']} skipped"
