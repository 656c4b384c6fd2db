"""The input report of a map from what a reader noted of its features."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scenewright.core.brief.input_report import InputReport, report_input
from scenewright.core.projection import Projection
from scenewright.core.reference_system import system_of
from scenewright.ground.geodata.limits import CUT_OFF
from scenewright.ground.maps.chosen_ground import MADE
from scenewright.ground.maps.fates import Note, settle
from scenewright.ground.maps.features import Collection, SkippedFeature
from scenewright.ground.maps.kinds import kind_of, stands


def report_map(
    found: Collection, map_: Projection, notes: Sequence[Note], otherwise: Callable[[str], str]
) -> InputReport:
    """What became of every feature of a map, those that could not be read last; ``otherwise``
    says by the name of one that no note is about why it was left out. ``found`` is the map as the
    file has it, with its own reference system."""
    kinds = {feature.id: feature.kind for feature in found.features if feature.layer != MADE}
    kinds |= {name: kind_of(tags, "feature") for name, tags in found.broken.items()}
    broken = [
        Note(row.feature, "left out", row.reason, _is_lost(row, found)) for row in found.skipped
    ]
    partly = [Note(f.id, "changed", f.lost) for f in found.features if f.lost]
    known = {note.name for note in notes if note.outcome != "left out"}
    stated = system_of(found.crs)
    plane = stated if stated and not stated.degrees else None
    return report_input(
        settle(kinds, [*notes, *broken, *(n for n in partly if n.name in known)], otherwise),
        format=found.format,
        system=plane.label if plane else map_.system_in_words,
        unit=plane.unit if plane and map_.turns else map_.unit_in_words,
    )


def _is_lost(row: SkippedFeature, found: Collection) -> bool:
    """Whether a feature that cannot be read is something built, within the map."""
    return row.reason != CUT_OFF and stands(found.broken.get(row.feature, {}))
