"""Models from their best views, plain and by saliency, on one sheet."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from scenewright.catalog.models import report
from scenewright.catalog.models.model import ImportOptions, SkippedModel
from scenewright.core.atomic_file import check_targets
from scenewright.core.catalog import Part
from scenewright.core.errors import CancelledError, InputError
from scenewright.render.portrait import Portrait, portrait
from scenewright.render.portrait_sheet import MOST, sheet, side_of, write
from scenewright.workflow.request import check_name

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]


class ViewRequest(NamedTuple):
    """What the command line asks for."""

    sources: tuple[str, ...]
    output: Path
    measure: str
    options: ImportOptions


class Sitter(NamedTuple):
    """A model to be drawn: its name, where it comes from, its parts."""

    name: str
    source: str
    parts: tuple[Part, ...]


class Viewed(NamedTuple):
    """What was drawn, of how many, and what was left out."""

    sitters: tuple[Sitter, ...]
    portraits: tuple[Portrait, ...]
    of: int
    skipped: tuple[SkippedModel, ...]


def check_view(request: ViewRequest) -> None:
    """InputError unless there is such a measure and the sheet can be a picture."""
    from scenewright.geometry.best_view import MEASURES

    check_name("measure", request.measure, list(MEASURES))
    if request.output.suffix.lower() != ".png":
        raise InputError("sheets are .png files", "choose such a name", file=str(request.output))


def draw_portraits(
    sitters: Sequence[Sitter] | None, request: ViewRequest, progress: Progress, cancel: Cancel
) -> Viewed:
    """Draw sitters, or the models the request names, and write the sheet; InputError if not one
    can be drawn, CancelledError once ``cancel`` says so."""
    given, skipped = collect_models(request, progress) if sitters is None else (list(sitters), [])
    check_targets([request.output])
    drawn = _draw_each(given[:MOST], request.measure, progress, cancel, skipped)
    progress(1.0, f"writing {request.output.name}")
    portraits = tuple(shown for _, shown in drawn)
    write(sheet(portraits, request.measure, len(given)), request.output)
    return Viewed(tuple(s for s, _ in drawn), portraits, len(given), tuple(skipped))


def collect_models(
    request: ViewRequest, progress: Progress
) -> tuple[list[Sitter], list[SkippedModel]]:
    """The models of every source: files, folders and ids of shipped assets."""
    sitters: list[Sitter] = []
    skipped: list[SkippedModel] = []
    for source in request.sources:
        progress(0.0, f"reading {Path(source).name}")
        if Path(source).exists():
            found = report(source, request.options)
            sitters += [Sitter(m.name, m.source, m.parts) for m in found.models]
            skipped += found.skipped
        else:
            sitters.append(_get_shipped_model(source))
    if not sitters:
        raise _nothing(request.sources, skipped)
    return sitters, skipped


def _get_shipped_model(name: str) -> Sitter:
    from scenewright.catalog.assets import shipped

    asset = shipped().assets.get(name)
    if asset is None:
        raise InputError(
            f"there is no file, folder or asset '{name[:80]}'",
            "check the path, or see scenewright list assets",
        )
    return Sitter(asset.name, name, asset.mesh(asset.usual))


def _draw_each(
    sitters: Sequence[Sitter],
    measure: str,
    progress: Progress,
    cancel: Cancel,
    skipped: list[SkippedModel],
) -> list[tuple[Sitter, Portrait]]:
    """The portraits; models that cannot be drawn join the skipped ones."""
    side, found = side_of(len(sitters)), []
    for k, sitter in enumerate(sitters):
        if cancel():
            raise CancelledError
        progress(k / len(sitters), f"drawing {sitter.name}")
        try:
            found.append((sitter, portrait(sitter.name, sitter.parts, side, measure)))
        except InputError as error:
            skipped.append(SkippedModel(sitter.source, f"{error.fault}; {error.remedy}"))
    if not found:
        raise _nothing([sitter.source for sitter in sitters], skipped)
    return found


def _nothing(sources: Sequence[str], skipped: Sequence[SkippedModel]) -> InputError:
    if not skipped:
        return InputError("holds no model files", "see scenewright view --help", file=sources[0])
    first, more = skipped[0], len(skipped) - 1
    return InputError(first.reason + f" (and {more} more)" * bool(more), file=first.name)


def list_skipped(viewed: Viewed) -> list[str]:
    """What was left out, in lines."""
    lines = [f"skipped {one.name}: {one.reason}" for one in viewed.skipped]
    if viewed.of > MOST:
        lines.append(f"drew the first {MOST} of {viewed.of} models: give fewer for the others")
    return lines


def describe_portraits(request: ViewRequest, viewed: Viewed) -> dict[str, Any]:
    """What a machine reads: each model's quality and best view, and what was skipped."""
    return {
        "file": str(request.output),
        "measure": request.measure,
        "models": rows(viewed),
        "of": viewed.of,
        "skipped": [one._asdict() for one in viewed.skipped],
    }


def select_columns(viewed: Viewed) -> list[dict[str, Any]]:
    """The rows a person reads; where a model comes from is in the document."""
    return [{key: row[key] for key in row if key != "source"} for row in rows(viewed)]


def rows(viewed: Viewed) -> list[dict[str, Any]]:
    """One row a model: triangles, visual quality and its share of the greatest, and where the
    eye is for the best view, in degrees: its turn from the front and its rise."""
    import numpy as np

    from scenewright.geometry.saliency import relative_quality

    shares = relative_quality([one.quality for one in viewed.portraits])
    return [
        {
            "name": one.name,
            "source": sitter.source,
            "triangles": one.faces,
            "quality": round(one.quality, 4),
            "share": round(float(share), 3),
            "turn": round(float(np.degrees(np.arctan2(-one.way[0], one.way[1])))),
            "rise": round(float(np.degrees(np.arcsin(np.clip(one.way[2], -1, 1))))),
        }
        for sitter, one, share in zip(viewed.sitters, viewed.portraits, shares, strict=True)
    ]
