"""What became of every model of a catalogue: used, changed and how, or left out and why."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from scenewright.catalog.models.as_asset import HEAVY
from scenewright.catalog.models.categories import BUILDING
from scenewright.catalog.models.furniture import OTHER
from scenewright.catalog.models.likeness import UPS
from scenewright.catalog.models.listing import FRONTS, Listed
from scenewright.catalog.models.model import SkippedModel
from scenewright.core.brief.input_report import Fate

MODEL, UNKNOWN = "model", "model of no known kind"


def list_fates(models: Iterable[Listed], skipped: Iterable[SkippedModel]) -> Iterator[Fate]:
    """The fate of each model as listed, and of those that could not be used."""
    for one in models:
        kind = UNKNOWN if one.category == OTHER else MODEL
        changes = "; ".join(_list_changes(one))
        if one.skip:
            yield Fate(one.model.id, kind, "left out", "the table skips it")
        elif changes:
            yield Fate(one.model.id, kind, "changed", changes)
        else:
            reason = "only where a brief names it" if kind == UNKNOWN else ""
            yield Fate(one.model.id, kind, "used", reason)
    for fault in skipped:
        yield Fate(fault.name, MODEL, "left out", fault.reason)


def _list_changes(one: Listed) -> Iterator[str]:
    if one.up != UPS[0]:
        yield f"set upright: its {one.up} was its top"
    if one.front != FRONTS[0]:
        yield "turned to its front"
    if one.scale != 1.0:
        yield f"taken {one.scale:g} times as large"
    faces = sum(len(part.faces) for part in one.model.parts)
    if faces > HEAVY and one.category != BUILDING:
        yield "drawn with fewer triangles"
