"""What became of every feature of a file, from what a reader noted of some.

A reader notes as it goes: this one was used, of that one a part was cut off. :func:`settle` makes
one fate a feature of it, in the order of the file, so that no feature is counted twice or not at
all, whatever a reader noted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

from scenewright.core.brief.input_report import LONGEST, Fate, Outcome


class Note(NamedTuple):
    """What a reader says of a feature by its name in the file; see
    :class:`~scenewright.core.brief.input_report.Fate`."""

    name: str
    outcome: Outcome
    reason: str = ""
    stands: bool = False


def settle(
    kinds: Mapping[str, str], notes: Iterable[Note], otherwise: Callable[[str], str]
) -> tuple[Fate, ...]:
    """The fate of each feature, given the kind of each by name, and why one is left out that no
    note is about, by its name.

    A feature used in part is used, or changed where a note says how; one that is left
    out counts as standing where any note says so.

    >>> notes = [Note("a", "used"), Note("a", "changed", "cut at the border"), Note("c", "used")]
    >>> [(f.name, f.outcome, f.reason) for f in
    ...  settle({"a": "road", "b": "tree"}, notes, lambda name: "trees are planted anew")]
    [('a', 'changed', 'cut at the border'), ('b', 'left out', 'trees are planted anew')]
    """
    about: dict[str, list[Note]] = {}
    for note in notes:
        about.setdefault(note.name, []).append(note)
    return tuple(
        _fate(name, kind, about.get(name) or [Note(name, "left out", otherwise(name))])
        for name, kind in kinds.items()
    )


def _fate(name: str, kind: str, notes: list[Note]) -> Fate:
    outcomes = {note.outcome for note in notes}
    if "used" not in outcomes and "changed" not in outcomes:
        first = max(notes, key=lambda note: note.stands)
        return Fate(name, kind, "left out", first.reason, first.stands)
    partly = [note.reason for note in notes if note.outcome != "used"]
    reasons = "; ".join(dict.fromkeys(filter(None, partly)))
    return Fate(name, kind, "changed" if partly else "used", reasons[:LONGEST])
