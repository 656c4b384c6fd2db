"""The verb ``batch``: sets of scenes, every plan in many homes and every home in many looks."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from scenewright.cli import batch as cli_batch
from scenewright.cli import completion
from scenewright.cli.arguments import check_budget
from scenewright.cli.reading import (
    CatalogOption,
    ClutterOption,
    GroupsOption,
    InputsArgument,
    PresetOption,
    StepsOption,
    StyleOption,
)
from scenewright.core.errors import InputError

MOST_SEEDS, MOST_LOOKS = 1_000_000, 1000


FolderOption = Annotated[
    Path,
    typer.Option(
        "-o", "--output", metavar="FOLDER", help="The set.", autocompletion=completion.outputs
    ),
]
SeedsOption = Annotated[
    str, typer.Option("--seeds", metavar="FIRST:END", help="A home of every plan a seed.")
]
LooksOption = Annotated[int, typer.Option(help="Looks of every home; 0 as it is asked for.")]
VaryOption = Annotated[
    str, typer.Option(help="Of looks: style,light,doors,poses,clutter; of seeds: residents.")
]
FormatsOption = Annotated[str, typer.Option(help="Suffixes, such as .json,.glb,.mjcf.xml.")]
ParquetOption = Annotated[bool, typer.Option("--parquet", help="The manifest as Parquet too.")]
JobsOption = Annotated[int | None, typer.Option(min=1, max=1024, help="Workers; one a core.")]
MemoryOption = Annotated[float | None, typer.Option(help="GiB a worker may take (4).")]
LimitOption = Annotated[float | None, typer.Option(help="Seconds a scene may take (600).")]
SchedulerOption = Annotated[
    str, typer.Option(metavar="ADDRESS", help="A Dask scheduler, such as tcp://host:8786.")
]
ToOption = Annotated[
    str, typer.Option(metavar="ADDRESS", help="Where scenes are put, such as s3://bucket/set.")
]


def batch(
    sources: InputsArgument,
    output: FolderOption,
    seed_range: SeedsOption = "",
    looks: LooksOption = 0,
    vary: VaryOption = "style,light,doors,poses,clutter",
    formats: FormatsOption = ".json",
    parquet: ParquetOption = False,
    preset: PresetOption = "default",
    steps: StepsOption = None,
    catalogs: CatalogOption = None,
    groups: GroupsOption = None,
    style: StyleOption = "",
    clutter: ClutterOption = "none",
    accessible: Annotated[bool, typer.Option(help="Furnish for wheelchair users.")] = False,
    jobs: JobsOption = None,
    memory: MemoryOption = None,
    limit: LimitOption = None,
    scheduler: SchedulerOption = "",
    to: ToOption = "",
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Make a set of scenes: every plan of INPUT in many homes, each in many looks, and a manifest.

    Killed or stopped, the same command goes on where it was."""
    from scenewright.batch import Cluster, Variation
    from scenewright.workflow.manifest import seeds_of
    from scenewright.workflow.request import ArrangeRequest

    check_budget(None, {"steps": steps})
    if not 0 <= looks <= MOST_LOOKS:
        raise InputError(f"--looks {looks} is not possible", f"give 0 to {MOST_LOOKS}")
    seeds = seeds_of(seed_range, MOST_SEEDS) if seed_range else ()
    request = ArrangeRequest(sources[0], (output,), preset, steps=steps)._replace(
        catalogs=tuple(catalogs or ()),
        groups=tuple(groups or ()),
        style=style,
        clutter=clutter,
        accessible=accessible,
    )
    terms = cli_batch.BatchTerms(
        formats,
        jobs,
        memory,
        limit,
        Variation(seeds, looks, tuple(filter(None, vary.split(",")))),
        "parquet" if parquet else "jsonl",
        Cluster(scheduler, to),
    )
    if scheduler and any(given is not None for given in (jobs, memory, limit)):
        fault = "--jobs, --memory and --limit are of this machine"
        raise InputError(fault, "give workers and memory where the cluster is started")
    return cli_batch.run(sources, request, terms, as_json, quiet)
