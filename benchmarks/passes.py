"""What each pass is worth: ``scenewright bench passes``.

Flats of ``floorplans_r2v`` at their true scale (100, 8 if quick) and all samples, for halls also
:mod:`benchmarks.new_halls`, are solved as usual, then once more without each pass and each group of
passes that changed anything there; where a pass changes nothing, solving without it is the same
work and is not done. Faults are those of :mod:`benchmarks.composition_faults`, counted by simple
geometry that shares nothing with the passes; those of halls are metres, as their retouches count
them.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.composition_faults import FAULTS, list_rooms
from benchmarks.new_halls import NEW_HALLS, new_halls
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.rescaled_r2v import rescale
from benchmarks.spread import spread
from scenewright.core.brief import Brief
from scenewright.core.passes import Pass, PassOptions, PassRun, tally_passes
from scenewright.core.report import Report
from scenewright.core.solution import Solution

Record = dict[str, Any]
FLATS, QUICK = 100, 8
FIRST, STEP = 1, 10
"""Flats that no other benchmark of composition counts: every tenth, from the second on."""
ALL = ""
"""The name of a run with every pass."""


class PassSubject(NamedTuple):
    """A brief by its name, of the flats by its number."""

    name: str
    flat: int | None = None


class PassDomain(NamedTuple):
    """A domain with passes: its table, how a brief is solved with options, how many faults a
    solution has by itself and by what was heard of its passes, and what it is measured on, fewer if
    quick."""

    name: str
    passes: Callable[[], Sequence[Pass[Any]]]
    solve: Callable[[Brief, PassOptions], Solution]
    faults: Callable[[Solution, Sequence[PassRun]], float]
    subjects: Callable[[bool], Sequence[PassSubject]]


class Outcome(NamedTuple):
    """What a solution comes to: faults, findings, energy, what is left out, pieces, and the
    processor's seconds it took."""

    faults: float
    findings: float
    energy: float
    left_out: float
    pieces: float
    seconds: float


class PassedSubject(NamedTuple):
    """One subject: the outcome without each pass and each group that changed it, and with
    :data:`ALL`; the runs heard of then."""

    outcomes: Mapping[str, Outcome]
    heard: tuple[PassRun, ...]


def records(quick: bool = False, progress: stages.Progress | None = None) -> Iterator[Record]:
    """Records of every pass of every domain: rooms changed, gain, seconds, and each figure with
    the pass off beside that with all on."""
    for name, domain in DOMAINS.items():
        subjects = domain.subjects(quick)
        jobs = [partial(measure_subject, name, subject) for subject in subjects]
        measured = stages_of(spread(jobs), len(jobs), name, progress)
        yield from stages.tally(measured, partial(tally_domain, domain))


def stages_of(
    measured: Iterable[PassedSubject], count: int, name: str, progress: stages.Progress | None
) -> Iterator[PassedSubject]:
    """The subjects as they are measured; ``progress`` hears of each."""
    for done, subject in enumerate(measured):
        if progress:
            progress((done + 1) / count, f"{name}: {done + 1} of {count}")
        yield subject


def measure_subject(name: str, subject: PassSubject) -> PassedSubject:
    """A subject solved with all passes, then without each that changed it."""
    domain, brief = DOMAINS[name], read_subject(subject)
    usual, heard = measure_run(domain, brief, frozenset())
    changed = {run.name for run in heard if run.changes}
    rows = [each for each in domain.passes() if each.name in changed]
    names = sorted({name for each in rows for name in (each.name, each.group)})
    outcomes = {off: measure_run(domain, brief, frozenset((off,)))[0] for off in names}
    return PassedSubject({ALL: usual, **outcomes}, tuple(heard))


def measure_run(
    domain: PassDomain, brief: Brief, off: frozenset[str]
) -> tuple[Outcome, list[PassRun]]:
    """The outcome of a brief solved with some passes off, and the runs heard of."""
    from scenewright.domains import check

    begun, heard = time.process_time(), list[PassRun]()
    solution = domain.solve(brief, PassOptions(off, heard.append))
    seconds = time.process_time() - begun
    report: Report = check(solution)
    outcome = Outcome(
        domain.faults(solution, heard),
        len(report.findings),
        sum(solution.energies.values()),
        len(solution.left_out),
        len(solution.pieces),
        seconds,
    )
    return outcome, heard


def read_subject(subject: PassSubject) -> Brief:
    """The brief of a subject."""
    from scenewright.formats import read

    if subject.name in NEW_HALLS:
        return new_halls()[subject.name]
    if subject.flat is None:
        return read(subject.name)
    brief = adapt(rescale(raw_plans()[subject.flat])).brief
    if brief is None:
        raise ValueError(f"flat {subject.flat} has no brief")
    return brief


def tally_domain(domain: PassDomain, measured: list[PassedSubject]) -> list[Record]:
    """Records of the passes of a domain, then of its groups."""
    rows, found = domain.passes(), list[Record]()
    heard = [run for subject in measured for run in subject.heard]
    whole = sum(subject.outcomes[ALL].seconds for subject in measured)
    for tally in tally_passes(rows, heard):
        changed = sum(_has_changed(subject, tally.name) for subject in measured)
        figures = {
            "scenes changed": (changed, len(measured)),
            "gain": (tally.gain, 0.0),
            "share of time": (tally.seconds / whole, 1.0),
        }
        found += [_record(domain, tally.name, m, *v, len(measured)) for m, v in figures.items()]
    names = [*(each.name for each in rows), *dict.fromkeys(each.group for each in rows)]
    for name in names:
        off = [subject.outcomes.get(name, subject.outcomes[ALL]) for subject in measured]
        usual = [subject.outcomes[ALL] for subject in measured]
        for k, figure in enumerate(Outcome._fields):
            ours, baseline = (sum(each[k] for each in outcomes) for outcomes in (off, usual))
            metric = f"{figure} without it"
            found.append(_record(domain, name, metric, ours, baseline, len(measured)))
    return found


def _has_changed(subject: PassedSubject, name: str) -> bool:
    return any(run.changes for run in subject.heard if run.name == name)


def _record(
    domain: PassDomain, name: str, metric: str, ours: float, baseline: float, runs: int
) -> Record:
    return {
        "case": f"{domain.name}: {name}",
        "metric": metric,
        "unit": "1",
        "ours": round(ours, 4),
        "baseline": round(baseline, 4),
        "baseline_name": "all passes",
        "ratio": round(ours / baseline, 4) if baseline else None,
        "runs": runs,
    }


def markdown_lines(found: Sequence[Record]) -> Iterator[str]:
    """A row a pass and a group: how much more there is of each figure without it."""
    figures = ("faults", "findings", "energy", "left_out", "pieces", "seconds")
    heads = ("pass", "scenes changed", "gain", "share of time", *figures)
    yield f"| {' | '.join(head.replace('_', ' ') for head in heads)} |"
    yield f"|{' --- |' * len(heads)}"
    cells = {(each["case"], each["metric"]): each for each in found}
    for case in dict.fromkeys(each["case"] for each in found):
        own = [cells.get((case, metric)) for metric in heads[1:4]]
        more = [cells[case, f"{figure} without it"] for figure in figures]
        row = [*("" if each is None else f"{each['ours']:.4g}" for each in own)]
        row += [f"{each['ours'] - each['baseline']:+.4g}" for each in more]
        yield f"| {' | '.join([case, *row])} |"


def _list_home_passes() -> Sequence[Pass[Any]]:
    from scenewright.domains.home.passes import PASSES

    return PASSES


def _solve_home(brief: Brief, options: PassOptions) -> Solution:
    from scenewright.domains.home.solving import solve

    return solve(brief, seed=0, threads=1, passes=options)


def _count_home_faults(solution: Solution, _heard: Sequence[PassRun]) -> float:
    from scenewright.building import plan

    home = list_rooms(plan.spaces(solution.brief), solution.pieces)
    return float(sum(count(home)[0] for count in FAULTS.values()))


def _list_homes(quick: bool) -> Sequence[PassSubject]:
    from scenewright.formats.opening import samples

    data_set(PLANS)
    flats = range(FIRST, len(raw_plans()), STEP)[: QUICK if quick else FLATS]
    names = [name for name in samples() if name.startswith("sample:home-")]
    usable = [k for k in flats if adapt(rescale(raw_plans()[k])).brief is not None]
    return [*(PassSubject(f"flat {k}", k) for k in usable), *map(PassSubject, names)]


def _list_hall_passes() -> Sequence[Pass[Any]]:
    from scenewright.domains.hall.retouch import RETOUCHES

    return RETOUCHES


def _solve_hall(brief: Brief, options: PassOptions) -> Solution:
    from scenewright.domains.hall.solving import solve

    return solve(brief, seed=0, threads=1, passes=options)


def _count_hall_faults(_solution: Solution, heard: Sequence[PassRun]) -> float:
    """Metres left; of a hall laid out several times those of the best."""
    from scenewright.domains.hall.retouch import LEFT

    return min((-run.changes[0].faults for run in heard if run.name == LEFT), default=0.0)


def _list_halls(quick: bool) -> Sequence[PassSubject]:
    from scenewright.formats.opening import samples

    names = [name for name in samples() if name.startswith("sample:hall-")]
    return [PassSubject(name) for name in [*names, *NEW_HALLS][:: 4 if quick else 1]]


DOMAINS = {
    "home": PassDomain("home", _list_home_passes, _solve_home, _count_home_faults, _list_homes),
    "hall": PassDomain("hall", _list_hall_passes, _solve_hall, _count_hall_faults, _list_halls),
}
