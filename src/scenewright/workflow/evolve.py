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

from scenewright import domains
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.stored_file import report_damage
from scenewright.engine.preference.events import Pick
from scenewright.engine.preference.interactive.methods import method_named
from scenewright.engine.preference.taste import PersonTaste
from scenewright.formats import read
from scenewright.formats.json_document import parse_document
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.log_records import AboutRecord, read_breeding
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
    method: str = "",
) -> Evolution:
    """An evolution of a brief, or of the file it is read from.

    Everything said is kept in the file ``log`` (nowhere, if left out). If that is the log of an
    evolution of the same brief, it goes on where it ended, whatever ended it. ``start`` are
    tastes of other people to start from; ``breeding`` how many candidates are bred and how.
    ``method`` is one of the papers' interactive genetic algorithms by name
    (:data:`~scenewright.engine.preference.interactive.methods.INTERACTIVE_METHODS`; left out:
    ours). The same log and ``seed`` give the same screens.
    """
    brief = source if isinstance(source, Brief) else read(os.fspath(source))
    if method:
        check_method(method, brief)
    book = EvolutionLog(log)
    try:
        about = book.about()
        if not about:
            name = "" if isinstance(source, Brief) else os.fspath(source)
            header = {"brief": brief.model_dump_json(), "seed": str(seed), "source": name}
            more = {"breeding": json.dumps(breeding or BreedingPlan())}
            book.begin(header | more | ({"method": method} if method else {}))
        elif about.get("brief") != brief.model_dump_json():
            raise InputError("is the log of another brief", "choose another name")
        elif method and about.get("method", "") != method:
            raise InputError("is the log of another method", "choose another name")
        return _open(brief, book, start)
    except InputError as error:
        book.close()
        raise error.located(file=os.fspath(log)) from None


def check_method(name: str, brief: Brief) -> None:
    """Raise :class:`InputError` unless there is such a method, and for such a brief."""
    method_named(name)
    domains.matrix_breeder_of(brief, domains.plan_of(brief))


def resume_evolution(log: str | os.PathLike[str]) -> Evolution:
    """The evolution kept in a log, as it ended; the file it was read from is not needed."""
    if not Path(log).exists():
        raise InputError("does not exist", "check the path", file=os.fspath(log))
    if Path(log).is_file() and not Path(log).stat().st_size:
        raise InputError("is empty", "check the path", file=os.fspath(log))
    book = EvolutionLog(log)
    try:
        with report_damage(log, "the log of an evolution", "check the path"):
            record = AboutRecord.model_validate(book.about())
            brief = Brief.model_validate(parse_document(record.brief, "a brief"))
            return _open(brief, book)
    except InputError:
        book.close()
        raise


def _open(brief: Brief, book: EvolutionLog, start: Sequence[PersonTaste] = ()) -> Evolution:
    """The evolution of a log with its own seed and ways of breeding."""
    with report_damage(book.path, "the log of an evolution", "start a new one"):
        about = AboutRecord.model_validate(book.about())
        breeding = read_breeding(about.breeding)
        seed, method = int(about.seed), about.method
        return Evolution(brief, book, seed=seed, start=start, breeding=breeding, method=method)
