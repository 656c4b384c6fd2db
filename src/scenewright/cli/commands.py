"""The command line: a thin layer over the façade.

Exit codes: 0 everything required is placed and valid; 1 done, but something required was not
placed or a rule is broken; 2 the input cannot be used; 130 interrupted, 143 terminated.
"""

from __future__ import annotations

import os
import sys
from functools import cache
from pathlib import Path
from typing import Annotated, Any, cast

import typer
from rich.console import Console

from scenewright._version import __version__
from scenewright.cli import adjust as cli_adjust
from scenewright.cli import agents as cli_agents
from scenewright.cli import batch as cli_batch
from scenewright.cli import catalog as cli_catalog
from scenewright.cli import compare as cli_compare
from scenewright.cli import completion, listing, schemes, show, tables, terminal
from scenewright.cli import evolve as cli_evolve
from scenewright.cli import fold as cli_fold
from scenewright.cli import generate as cli_generate
from scenewright.cli import learn as cli_learn
from scenewright.cli import photo as cli_photo
from scenewright.cli import plan as cli_plan
from scenewright.cli import render as cli_render
from scenewright.cli import sets as cli_sets
from scenewright.cli import studio as cli_studio
from scenewright.cli import warm as cli_warm
from scenewright.cli.arguments import check_budget, check_repeated, check_words
from scenewright.cli.faults import describe_usage_fault, drop_output, is_output_full, write_fault
from scenewright.cli.pass_table import print_passes
from scenewright.cli.reading import (
    AlternativesOption,
    CatalogOption,
    ClutterOption,
    CrsOption,
    GroupsOption,
    HiddenOption,
    InputsArgument,
    KeepOption,
    LayerOption,
    LayoutsOption,
    OriginOption,
    OutputsOption,
    PresetOption,
    ScaleOption,
    SiteOption,
    SolverOption,
    StepsOption,
    StyleOption,
    map_options_of,
)
from scenewright.cli.show_input import print_input, print_warnings
from scenewright.cli.termination import Terminated, orderly_termination
from scenewright.core.atomic_file import recorded_run
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.plugins import REMEDY, blame_plugin
from scenewright.workflow import documents
from scenewright.workflow.schemes import find_schemes

app = typer.Typer(
    name="scenewright",
    help="Automatic 3D scene layout: furnished homes, halls, sites, villages and extensions.",
    pretty_exceptions_enable=False,
    no_args_is_help=True,
)

USAGE_FAULT = cast(type[Exception], typer.BadParameter.__mro__[2])
"""What the parser raises for arguments it cannot use (its own ``ClickException``)."""

TraceOption = Annotated[
    Path | None, typer.Option(help="Write a paper's run step by step to this file, JSON Lines.")
]
JsonOption = Annotated[bool, typer.Option("--json", help="Print one JSON document only.")]
QuietOption = Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")]


def main(arguments: list[str] | None = None) -> None:
    """Run the command line and leave with its exit code; every fault is one line."""
    sys.exit(run(arguments))


@cache
def _command() -> Any:
    """The tree of commands, made once a process: that takes longer than most of them run."""
    return typer.main.get_command(app)


def run(arguments: list[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    try:
        check_words(arguments)
        completion.split_colon(os.environ)
        command = _command()
        check_repeated(sys.argv[1:] if arguments is None else arguments, command)
        with orderly_termination(), recorded_run():
            code = int(command(arguments, standalone_mode=False) or 0)
            sys.stdout.flush()
            return code
    except Terminated as stop:
        return write_fault("terminated", stop.code)
    except InputError as error:
        return write_fault(str(error))
    except USAGE_FAULT as error:
        message = describe_usage_fault(error)
        return write_fault(f"{message}; see scenewright --help") if message else 2
    except (CancelledError, KeyboardInterrupt, typer.Abort):
        return write_fault("interrupted", 130)
    except SystemExit as end:
        if not isinstance(end.__context__, BrokenPipeError):
            raise
        return 0
    except BrokenPipeError:
        drop_output()
        return 0
    except Exception as error:
        if is_output_full(error):
            drop_output()
            return write_fault(f"the output cannot be written: {error}; write it elsewhere")
        if os.environ.get("SCENEWRIGHT_DEBUG"):
            raise
        cause = f"{type(error).__name__}: {error}"
        if plugin := blame_plugin(error.__traceback__):
            return write_fault(f"a plug-in failed: {plugin}: {cause}; {REMEDY}")
        return write_fault(
            f"internal error, please report: {cause} (SCENEWRIGHT_DEBUG=1 shows where)", 3
        )


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"scenewright {__version__}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    pass


@app.command()
def arrange(
    sources: InputsArgument,
    outputs: OutputsOption = None,
    preset: PresetOption = "default",
    solver: SolverOption = None,
    seconds: Annotated[float | None, typer.Option(help="Search budget in seconds.")] = None,
    steps: StepsOption = None,
    layouts: LayoutsOption = None,
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same result.")] = 0,
    keep: KeepOption = False,
    accessible: Annotated[bool, typer.Option(help="Furnish for wheelchair users.")] = False,
    scale: ScaleOption = 1.0,
    hidden_levels: HiddenOption = False,
    catalogs: CatalogOption = None,
    groups: GroupsOption = None,
    style: StyleOption = "",
    clutter: ClutterOption = "none",
    crs: CrsOption = "",
    origin: OriginOption = "",
    layers: LayerOption = None,
    site: SiteOption = "",
    alternatives: AlternativesOption = 1,
    many: cli_batch.BatchOption = False,
    formats: cli_batch.FormatOption = None,
    jobs: cli_batch.JobsOption = None,
    memory: cli_batch.MemoryOption = None,
    limit: cli_batch.LimitOption = None,
    trace: TraceOption = None,
    nets: Annotated[str, typer.Option(metavar="FILE", help="Of learn village --paper.")] = "",
    as_json: JsonOption = False,
    quiet: QuietOption = False,
) -> int:
    """Lay out a home, hall, site, village or extension: read INPUT, solve it, write each OUT."""
    from scenewright.workflow.request import ArrangeRequest

    check_budget(seconds, {"steps": steps, "layouts": layouts})
    how = (preset, solver, seconds, steps, seed, keep, alternatives, tuple(catalogs or ()))
    request = ArrangeRequest(sources[0], tuple(outputs or ()), *how)._replace(
        groups=tuple(groups or ()),
        accessible=accessible,
        scale=scale,
        hidden_levels=hidden_levels,
        style=style,
        clutter=clutter,
        layouts=layouts,
        map_options=map_options_of(crs, origin, layers, site),
        trace=trace,
        nets=nets,
    )
    terms = cli_batch.BatchTerms(formats, jobs, memory, limit)
    if trace is not None and (many or alternatives > 1):
        raise InputError("--trace is of one run", "leave --batch and --alternatives out")
    if many:
        return cli_batch.run(sources, request, terms, as_json, quiet)
    cli_batch.check_single(sources, terms)
    console = terminal.console(stderr=True, quiet=quiet)
    if alternatives > 1:
        return _alternatives(request, console, as_json, quiet)
    return _arrange_one(request, console, as_json, quiet)


def _arrange_one(request: Any, console: Console, as_json: bool, quiet: bool) -> int:
    """One result with its report and its files."""
    from scenewright.cli import arrange as cli_arrange

    arranged, interrupted = cli_arrange.arrange(request, console)
    code = 130 if interrupted else 0 if arranged.complete else 1
    if as_json:
        tables.print_json(
            documents.arranged_document(request.source, request.outputs, *arranged, code)
        )
    elif not quiet:
        show.print_arranged(tables.output_console(), request.outputs, *arranged, interrupted)
    return write_fault(show.describe_interruption(request.outputs), code) if interrupted else code


def _alternatives(request: Any, console: Console, as_json: bool, quiet: bool) -> int:
    """Several plans, ranked, each with its numbers and its files."""
    from scenewright.cli import alternatives as cli_alternatives

    plans, interrupted = cli_alternatives.arrange_all(request, console)
    code = 130 if interrupted else 0 if any(plan.complete for plan in plans) else 1
    if as_json:
        tables.print_json([cli_alternatives.document(request.source, plan) for plan in plans])
    elif not quiet:
        console = tables.output_console()
        tables.table(console, cli_alternatives.rows(plans), title="plans")
        for line in filter(None, map(cli_alternatives.patterns, plans)):
            tables.print_line(console, line, "dim")
        if len(plans) < request.alternatives and not interrupted:
            tables.print_line(
                console, f"found {len(plans)} of {request.alternatives} distinct plans"
            )
    return code


@app.command()
def check(
    file: Annotated[Path, typer.Argument(metavar="SOLUTION.json", help="A saved solution.")],
    meshes: Annotated[bool, typer.Option("--meshes", help="Model against model, too.")] = False,
    as_json: JsonOption = False,
    quiet: QuietOption = False,
) -> int:
    """Check a solution exactly: collisions, doors, routes, bounds."""
    from scenewright.domains import check as judge
    from scenewright.formats import solution_json

    solution, plan = solution_json.read_planned(file)
    show.print_scale(terminal.console(stderr=True, quiet=quiet), file, solution.brief, plan)
    report = judge(solution, plan=plan)
    if meshes:
        from scenewright.workflow.meshes import add_meshes

        report = add_meshes(report, solution, plan)
    read = solution.brief.input_report
    if as_json:
        tables.print_json(
            {"file": str(file), **report.to_dict(), **documents.input_document(solution.brief)}
        )
    elif not quiet:
        console = tables.output_console()
        print_input(console, read)
        show.print_report(console, report, show.SCALE)
        print_warnings(console, read)
    return 0 if report.complete and solution.brief.is_read_whole else 1


@app.command()
def explain(
    file: Annotated[Path, typer.Argument(metavar="SOLUTION.json", help="A saved solution.")],
    passes: Annotated[
        bool, typer.Option("--passes", help="Solve it again: what each pass changed and gained.")
    ] = False,
    with_terms: Annotated[
        bool, typer.Option("--terms", help="Add the cost of each term for each item.")
    ] = False,
    as_json: JsonOption = False,
) -> int:
    """Explain a solution: what was not placed, what it gives up, and what helps."""
    from scenewright.core.registry import domain_of
    from scenewright.formats import solution_json

    solution, plan = solution_json.read_planned(file)
    show.print_scale(terminal.console(stderr=True), file, solution.brief, plan)
    noun = domain_of(solution.brief.domain).noun
    if passes:
        print_passes(tables.output_console(), solution, plan, as_json)
    elif as_json:
        grounds = find_schemes(solution, plan)
        told = documents.explained_document(solution, plan)
        tables.print_json(told | ({f"{noun}s": grounds} if grounds else {}))
    else:
        show.print_explanation(tables.output_console(), solution, plan, with_terms)
        schemes.print_schemes(tables.output_console(), find_schemes(solution, plan), noun)
    return 0


for verb in (
    *(cli_adjust.adjust, cli_evolve.evolve, cli_compare.compare, cli_fold.fold),
    *(cli_generate.generate, cli_learn.learn, cli_plan.plan, cli_render.render, cli_photo.photo),
    *(cli_sets.batch, cli_studio.studio, cli_agents.mcp, cli_warm.warm),
):
    app.command()(verb)
app.command("list")(listing.list_)
app.command()(listing.schema)
app.add_typer(cli_catalog.app, name="catalog")


@app.command()
def bench(
    name: Annotated[
        str,
        typer.Argument(
            metavar="NAME",
            help="Which benchmark, such as home.",
            autocompletion=completion.benchmarks,
        ),
    ],
    quick: Annotated[bool, typer.Option("--quick", help="Fewer runs.")] = False,
    full: Annotated[bool, typer.Option("--full", help="All, however long it takes.")] = False,
    rescaled: Annotated[
        bool,
        typer.Option("--rescaled", help="Real flats at their true scale: hinged doors of 0.75 m."),
    ] = False,
    everything: Annotated[bool, typer.Option("--all", help="All that belongs to it.")] = False,
    seed: Annotated[int | None, typer.Option(min=0, help="Draws the set it measures.")] = None,
    count: Annotated[int | None, typer.Option(min=1, help="How many are drawn.")] = None,
    sheets: Annotated[Path | None, typer.Option(help="A folder for pictures to look at.")] = None,
    halls: Annotated[bool, typer.Option("--halls", help="Of halls, not of homes.")] = False,
    outputs: Annotated[
        list[Path] | None,
        typer.Option("-o", "--output", metavar="OUT", help="A .json or .md; may be repeated."),
    ] = None,
    into: Annotated[
        Path | None,
        typer.Option("--into", metavar="PAGE.md", help="Write its table in its place in a page."),
    ] = None,
    as_json: JsonOption = False,
    quiet: QuietOption = False,
) -> int:
    """Measure against the baselines (needs a source checkout)."""
    from scenewright.cli import bench as cli_bench
    from scenewright.cli.progress import show_progress

    extent = cli_bench.extent_of(quick, full)
    cli_bench.check_outputs(outputs or ())
    cli_bench.check_page(name, into)
    drawn: dict[str, object] = {"seed": seed, "count": count, "sheets": sheets}
    more = drawn | {"rescaled": rescaled, "everything": everything, "halls": halls}
    with show_progress(terminal.console(stderr=True), quiet) as progress:
        measured = cli_bench.measure(name, extent, progress, more)
    cli_bench.write(outputs or (), name, measured.records)
    if into is not None and not measured.interrupted:
        cli_bench.write_into(into, name, extent, more, measured.records)
    if as_json:
        tables.print_json(list(measured.records))
    elif not quiet:
        rows = [{key: record[key] for key in cli_bench.KEYS} for record in measured.records]
        tables.table(tables.output_console(), rows, title=f"bench {name}")
    if measured.interrupted:
        return write_fault(f"interrupted after {len(measured.records)} records", 130)
    return 0


@app.command()
def view(
    models: Annotated[
        list[str], typer.Argument(metavar="MODEL...", help="Files, folders or ids of assets.")
    ],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="OUT.png")],
    measure: Annotated[str, typer.Option(help="picture, saliency or entropy.")] = "picture",
    up: Annotated[str, typer.Option(help="Up direction in the files' axes, such as +z.")] = "",
    front: Annotated[
        str, typer.Option(help="Front direction in the files' axes, such as -y.")
    ] = "",
    as_json: JsonOption = False,
    quiet: QuietOption = False,
) -> int:
    """Draw models from their best views, plain and coloured by saliency, on one sheet."""
    from scenewright.catalog.models.model import ImportOptions
    from scenewright.cli import view as cli_view
    from scenewright.workflow.portraits import ViewRequest

    request = ViewRequest(tuple(models), output, measure, ImportOptions(up, front))
    viewed = cli_view.view(request, terminal.console(stderr=True, quiet=quiet))
    cli_view.tell_viewed(request, viewed, as_json, quiet)
    return 1 if viewed.skipped else 0
