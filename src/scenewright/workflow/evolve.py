"""Layouts a person likes: shown a dozen at a time, learned from what she says of them.

>>> with evolve("sample:home-room") as evolution:
...     first = evolution.ask()
...     shown = tuple(one.number for one in first.candidates)
...     evolution.tell(Pick(shown[2], shown))
...     evolution.champion.number == shown[2]
True
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.engine.preference.events import Pick
from scenewright.engine.preference.taste import PersonTaste
from scenewright.formats import read
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.population import BreedingPlan
from scenewright.workflow.evolution.session import Evolution

__all__ = ["Evolution", "Pick", "evolve", "resume_evolution"]


def evolve(
    source: str | os.PathLike[str] | Brief,
    log: str | os.PathLike[str] = "",
    *,
    seed: int = 0,
    start: Sequence[PersonTaste] = (),
    breeding: BreedingPlan | None = None,
) -> Evolution:
    """An evolution of a brief, or of the file it is read from.

    Everything said is kept in the file ``log`` (nowhere, if left out). If that is the log of an
    evolution of the same brief, it goes on where it ended, whatever ended it. ``start`` are
    tastes of other people to start from; ``breeding`` how many candidates are bred and how. The
    same log and ``seed`` give the same screens.
    """
    brief = source if isinstance(source, Brief) else read(os.fspath(source))
    book = EvolutionLog(log)
    about = book.about()
    if not about:
        name = "" if isinstance(source, Brief) else os.fspath(source)
        header = {"brief": brief.model_dump_json(), "seed": str(seed), "source": name}
        book.begin(header | {"breeding": json.dumps(breeding or BreedingPlan())})
    elif about["brief"] != brief.model_dump_json():
        book.close()
        raise InputError("is the log of another brief", "choose another name", file=os.fspath(log))
    return _open(brief, book, start)


def resume_evolution(log: str | os.PathLike[str]) -> Evolution:
    """The evolution kept in a log, as it ended; the file it was read from is not needed."""
    if not Path(log).is_file():
        raise InputError("does not exist", "check the path", file=os.fspath(log))
    book = EvolutionLog(log)
    about = book.about()
    if "brief" not in about:
        book.close()
        raise InputError("is not the log of an evolution", "check the path", file=os.fspath(log))
    brief = Brief.model_validate_json(about["brief"])
    return _open(brief, book)


def _open(brief: Brief, book: EvolutionLog, start: Sequence[PersonTaste] = ()) -> Evolution:
    """The evolution of a log with its own seed and ways of breeding."""
    about = book.about()
    breeding = BreedingPlan(*json.loads(about["breeding"]))
    return Evolution(brief, book, seed=int(about["seed"]), start=start, breeding=breeding)
