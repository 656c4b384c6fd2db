"""``catalog cluster``: models sorted into classes by their looks, as a sheet and a table."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scenewright.cli import tables
from scenewright.core.atomic_file import check_targets
from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from scenewright.catalog.models.listing import Listed

MOST = 240
"""Models on a sheet."""
METHODS = ("ward", "k-means", "leader", "art")


def cluster(
    catalogue: Annotated[str, typer.Argument(metavar="CATALOGUE", help="A path or a name.")],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT.png", help="A sheet of pictures.")
    ] = None,
    classes: Annotated[
        int | None, typer.Option(min=1, max=200, help="How many; by default by their number.")
    ] = None,
    method: Annotated[str, typer.Option(help="ward, k-means, leader or art.")] = "ward",
    depths: Annotated[
        bool, typer.Option("--depths", help="Show the first of each class with its depth maps.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
) -> int:
    """Sort models into classes by shape, size and colour; show them as a sheet of pictures, or the
    first of each class as seen from ten sides (a light field)."""
    from scenewright.catalog.loading import read_entry
    from scenewright.core.brief.catalog import entry_of

    if method not in METHODS:
        raise InputError(f"unknown method '{method}'", f"use one of: {', '.join(METHODS)}")
    if depths and output is None:
        raise InputError("depth maps are shown on a sheet", "add -o OUT.png", place="--depths")
    if output is not None:
        if output.suffix.lower() != ".png":
            raise InputError("sheets are written as .png", "choose such a name", file=str(output))
        check_targets([output])
    models = read_entry(entry_of(catalogue)).models
    if len(models) < 2:
        raise InputError(f"holds {len(models)} model", "give at least two", file=catalogue)
    labels = sort_models(models, method, classes)
    order = sorted(range(len(models)), key=lambda k: (labels[k], models[k].model.id))
    rows = [{"class": labels[k] + 1, "model": models[k].model.id} for k in order]
    if output is not None:
        _draw(models, labels, order, output, method, depths)
    if as_json:
        tables.print_json(rows)
        return 0
    console = tables.output_console()
    if output is None:
        tables.table(console, rows, title=f"{max(labels) + 1} classes", whole=("model",))
    else:
        text = f"{len(models)} models in {max(labels) + 1} classes; wrote {output}"
        tables.print_line(console, text, "dim")
    return 0


def sort_models(models: tuple[Listed, ...], method: str, classes: int | None) -> list[int]:
    """The class of each model; without a number of classes as many as the root of twice the
    models."""
    import numpy as np

    from scenewright.catalog.descriptors.compact import compact_descriptor
    from scenewright.engine.clustering.linkage import k_means, leader, ward
    from scenewright.engine.clustering.resonance import fuzzy_art

    vectors = np.array([compact_descriptor(one.model.parts) for one in models])
    count = classes or max(round((2 * len(models)) ** 0.5), 2)
    count = min(count, len(models))
    if method == "k-means":
        return k_means(vectors, count).tolist()
    if method == "art":
        return fuzzy_art(vectors).tolist()
    if method == "ward":
        return ward(vectors, count).tolist()
    gaps = np.linalg.norm(vectors[:, None] - vectors[None], axis=2)
    marks = np.quantile(gaps[np.triu_indices(len(vectors), 1)], np.linspace(0.02, 0.6, 24))
    sorted_ = [leader(vectors, float(mark)) for mark in marks]
    return min(sorted_, key=lambda label: abs(int(label.max()) + 1 - count)).tolist()


def _draw(
    models: tuple[Listed, ...],
    labels: list[int],
    order: list[int],
    output: Path,
    method: str,
    depths: bool,
) -> None:
    from scenewright.render.contact_sheet import SheetEntry, draw_sheet, write_sheet
    from scenewright.render.depth_strip import draw_depth_strip
    from scenewright.render.thumbnail import draw_thumbnail

    draw = draw_depth_strip if depths else draw_thumbnail
    entries, seen = list[SheetEntry](), Counter[int]()
    for k in order:
        seen[labels[k]] += 1
        first = seen[labels[k]] == 1
        if len(entries) < MOST and (first or not depths):
            label, name = str(labels[k] + 1), str(models[k].model.name)[:20]
            picture = draw(models[k].model.parts)
            entries.append(SheetEntry(picture, label, name, first and not depths))
    said = "the first of each from ten sides" if depths else "the first of each framed"
    title = f"{len(models)} models, {max(labels) + 1} classes ({method}); {said}"
    write_sheet(draw_sheet(entries, "Models by what they look like", title), output)
