"""The verb ``generate``: floor plans and halls made by a seed, as briefs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scenewright.cli import completion, tables
from scenewright.cli.plan import describe_plan, write_plan
from scenewright.core.atomic_file import recorded_run, whole_together
from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from scenewright.core.brief import Brief

MOST = 100_000
"""Most plans of one call."""


def generate(
    kind: Annotated[str, typer.Argument(metavar="KIND", help="home or hall.")],
    rooms: Annotated[
        int | None, typer.Option(help="Of a home: living room, bedrooms and studies together.")
    ] = None,
    area: Annotated[float | None, typer.Option(help="Square metres of floor.")] = None,
    storeys: Annotated[int | None, typer.Option(help="Of a home: 1 to 3.")] = None,
    outline: Annotated[
        str | None, typer.Option(help="rectangle, l or skew; left out, drawn by the seed.")
    ] = None,
    use: Annotated[
        str | None, typer.Option(help="Of a hall: what it holds, such as clothes, grocery, books.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same plan.")] = 0,
    count: Annotated[
        int, typer.Option(min=1, max=MOST, help="Plans of as many seeds, from --seed on.")
    ] = 1,
    seed_range: Annotated[
        str, typer.Option("--seeds", metavar="FIRST:END", help="Plans of a range of seeds.")
    ] = "",
    outputs: Annotated[
        list[Path] | None,
        typer.Option(
            "-o",
            "--output",
            metavar="OUT",
            help="A .json for the brief, a .svg to see it; with --count or --seeds a folder.",
            autocompletion=completion.outputs,
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Generate floor plans of homes, or halls with what they hold; nothing is furnished."""
    from scenewright.domains import plan_valid
    from scenewright.workflow.generate import generate as make

    asked = {"rooms": rooms, "area": area, "storeys": storeys, "outline": outline, "use": use}
    seeds = _seeds(seed_range, seed, count)
    with recorded_run():
        if count > 1 or seed_range:
            lines = _fill_folder(kind, outputs or [], seeds, asked)
        else:
            brief = make(kind, seed=seed, **asked)
            made = plan_valid(brief)
            write_plan(brief, made, outputs or [])
            lines = [*describe_plan(brief, made), *(f"wrote {path}" for path in outputs or [])]
    if as_json:
        given = {key: value for key, value in asked.items() if value is not None}
        tables.print_json(
            {"kind": kind, "plans": len(seeds), "seeds": [seeds[0], seeds[-1]], **given}
        )
    elif not quiet:
        for line in lines:
            tables.print_line(tables.output_console(), line)
    return 0


def _seeds(seed_range: str, seed: int, count: int) -> range:
    """The seeds asked for, by ``--seeds`` or by ``--seed`` and ``--count``."""
    from scenewright.workflow.manifest import seeds_of

    if not seed_range:
        return range(seed, seed + count)
    if seed or count > 1:
        raise InputError("--seeds says which seeds", "leave --seed and --count out")
    return seeds_of(seed_range, MOST)


def _fill_folder(
    kind: str, outputs: list[Path], seeds: range, asked: dict[str, int | float | str | None]
) -> list[str]:
    """A brief a seed in a folder, ``KIND-SEED.json``, and ``manifest.jsonl``: all or none."""
    from scenewright.formats import brief_json
    from scenewright.workflow.generate import generate as make
    from scenewright.workflow.manifest import manifest_line

    if len(outputs) != 1 or outputs[0].suffix:
        raise InputError("several plans are written into a folder", "give -o FOLDER, once")
    folder = outputs[0]
    if folder.exists() and not folder.is_dir():
        raise InputError("this is a file", "name a folder", file=str(folder))
    paths = [folder / f"{kind}-{seed}.json" for seed in seeds]
    first: Brief = make(kind, seed=seeds[0], **asked)
    folder.mkdir(parents=True, exist_ok=True)
    lines = []
    with whole_together([*paths, folder / "manifest.jsonl"]) as partials:
        for seed, path, partial in zip(seeds, paths, partials[:-1], strict=True):
            brief = first if seed == seeds[0] else make(kind, seed=seed, **asked)
            partial.write_text(brief_json.dumps(brief), encoding="utf-8")
            lines.append(manifest_line(path.name, kind, seed, asked, brief))
        partials[-1].write_text("".join(lines), encoding="utf-8")
    return [f"wrote {len(paths)} plans into {folder}"]
