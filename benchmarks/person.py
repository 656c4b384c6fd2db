"""How soon a person is shown what she likes: ``scenewright bench person``.

**Simulated** persons (:mod:`benchmarks.person_raters`) on a flat and on a site of thirty. 0 is the
mean of layouts by chance, 1 the best that a search finds which knows the truth (a genetic
algorithm of 60 layouts and 60 generations) or that anybody was shown. An *action* is one event
sent, a *look* one candidate shown for the first time. *Satisfaction* is that of the champion, what
the person has chosen so far. Four persons a case, ``--full`` twenty, on two processes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from functools import partial
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from statistics import median
from typing import Any, NamedTuple

from benchmarks import person_genetic, person_methods
from benchmarks.kept import KeptRuns, open_runs
from benchmarks.person_methods import SearchStep
from benchmarks.person_raters import SimulatedPerson
from benchmarks.person_world import World, home_world, site_world
from scenewright.engine.preference.trust import TrustRecord

Record = dict[str, Any]
Progress = Callable[[float, str], None]
SCREENS, RATINGS = 11, 284
LONG = 60
"""Generations of the search that knows the truth."""
ACTIONS, LOOKS = 60, 120
MARKS = (12, 24, 30, 48, 60)
FULL_SEEDS, SEEDS, QUICK_SEEDS = 20, 4, 2
CONJUNCTIVE, NOISY = "home, conjunctive tastes", "ours, noise doubled"
FIRST_SEEDS = {"home": 7000, "site": 5000, CONJUNCTIVE: 5000}
"""The first person of each case; nothing was tuned on those that follow."""
PROCESSES = 2
CODE = (
    *(f"benchmarks/person{part}.py" for part in ("_genetic", "_methods", "_raters", "_world")),
    "src/scenewright/engine/preference/**/*.py",
    "src/scenewright/workflow/evolution/population.py",
    "src/scenewright/geometry/composition.py",
)
"""What the persons see and are learned by, beside their domain: runs of other code are not
theirs."""
TOP = "the best"
METHODS: dict[str, tuple[Callable[..., Iterator[SearchStep]], int]] = {
    "ours": (person_methods.ours, SCREENS),
    NOISY: (person_methods.ours, SCREENS),
    "rated GA": (person_genetic.rated_ga, RATINGS),
    "TIGA": (person_genetic.tiga, RATINGS),
    "paper-repaired": (person_genetic.paper, RATINGS),
    "paper-local": (person_genetic.paper_local, RATINGS),
    "linear Bradley-Terry": (person_methods.bradley_terry, SCREENS),
    "random": (person_methods.random_search, 24),
}


class PersonRun(NamedTuple):
    """One person and one method: its steps, how much the champion is liked after each, and how
    much the best of all is."""

    steps: tuple[SearchStep, ...]
    liked: tuple[float, ...]
    top: float

    def satisfaction(self, actions: int) -> float:
        """Satisfaction with the champion after so many actions."""
        done = [k for k, step in enumerate(self.steps) if step.actions <= actions] or [0]
        return self.liked[done[-1]] / self.top

    def shown(self) -> float:
        """The best ever shown, as satisfaction."""
        return self.steps[-1].best / self.top

    def record(self) -> list[Any]:
        """Plain values, ready for JSON."""
        return [[list(step) for step in self.steps], self.liked, self.top]


def run_of(record: list[Any]) -> PersonRun:
    """The run a record holds."""
    rows, liked, top = record
    steps = [
        SearchStep(
            actions,
            looks,
            tuple(champion),
            best,
            TrustRecord(trust[0], trust[1], trust[2], tuple(trust[3])),
        )
        for actions, looks, champion, best, trust in rows
    ]
    return PersonRun(tuple(steps), tuple(liked), top)


def run_person(
    world: World, case: str, seed: int, have: Collection[str]
) -> Iterator[tuple[str, Any]]:
    """What is kept of one person, by name: what the search that knows the truth finds, and the run
    of each method; less what there is already."""
    number, conjunctive = FIRST_SEEDS[name_kind(case)] + seed, name_kind(case) == CONJUNCTIVE
    if TOP not in have:
        knows = SimulatedPerson(world, number, 1.0, conjunctive)
        yield TOP, person_genetic.find_best(world, knows, seed, LONG)
    for method, (search, much) in METHODS.items():
        if method not in have:
            noise = 2.0 if method == NOISY else 1.0
            person = SimulatedPerson(world, number, noise, conjunctive)
            steps = tuple(search(world, person, seed, much))
            liked = tuple(person.truth(step.champion) for step in steps)
            yield method, PersonRun(steps, liked, 0.0).record()


def name_kind(case: str) -> str:
    """The case that a quick one is of.

    >>> name_kind("site, quick")
    'site'
    """
    return case.removesuffix(", quick")


def join_runs(kept: dict[str, Any]) -> dict[str, PersonRun]:
    """The runs of a person of which all is kept, with the best there was for any of them."""
    runs = {method: run_of(kept[method]) for method in METHODS}
    top = max(kept[TOP], *(run.steps[-1].best for run in runs.values()))
    return {method: run._replace(top=top) for method, run in runs.items()}


def records(quick: bool, progress: Progress, *, full: bool = False) -> Iterator[Record]:
    """Records of all methods on a home and on a site, and on the home for persons whose taste is
    of another form than the model's."""
    seeds = QUICK_SEEDS if quick else FULL_SEEDS if full else SEEDS
    home = partial(home_world, "home-studio" if quick else "home-flat")
    worlds: dict[str, Callable[[], World]] = {
        "home": home,
        CONJUNCTIVE: home,
        "site": partial(site_world, "site-courtyards" if quick else "site-30"),
    }
    for number, (case, make) in enumerate(worlds.items()):
        progress(number / len(worlds), f"{case}: layouts")
        persons = []
        domain = case[:4]
        code = (*CODE, f"src/scenewright/domains/{domain}/**/*.py")
        kept = open_runs(f"person-{domain}", code)
        for one in run_persons(make, f"{case}, quick" if quick else case, range(seeds), kept):
            persons.append(one)
            progress(
                (number + len(persons) / seeds) / len(worlds), f"{case}: {len(persons)} persons"
            )
        yield from summarise(case, {name: [one[name] for one in persons] for name in METHODS})


def run_persons(
    make: Callable[[], World], case: str, seeds: Iterable[int], kept: KeptRuns
) -> Iterator[dict[str, PersonRun]]:
    """All methods for persons on :data:`PROCESSES` processes that share the world, as they are
    done; what is kept is not run again."""
    wanted = {TOP, *METHODS}
    have = {seed: {n for n in wanted if f"{case}, {seed}, {n}" in kept.values} for seed in seeds}
    left = [seed for seed, names in have.items() if names != wanted]
    for seed in have.keys() - left:
        yield join_runs({name: kept.values[f"{case}, {seed}, {name}"] for name in wanted})
    for seed, name, value in _fork_persons(make(), case, left, have) if left else ():
        kept.keep(f"{case}, {seed}, {name}", value)
        have[seed].add(name)
        if have[seed] == wanted:
            yield join_runs({name: kept.values[f"{case}, {seed}, {name}"] for name in wanted})


def _fork_persons(
    world: World, case: str, seeds: list[int], have: dict[int, set[str]]
) -> Iterator[tuple[int, str, Any]]:
    forks = get_context("fork")
    lines = [forks.Pipe(duplex=False) for _ in range(PROCESSES)]
    running = [
        forks.Process(
            target=_send_persons,
            args=(line[1], world, case, seeds[k::PROCESSES], have),
            daemon=True,
        )
        for k, line in enumerate(lines)
    ]
    for process in running:
        process.start()
    open_ = [line[0] for line in lines]
    for line in lines:
        line[1].close()
    while open_:
        wait(open_)
        for told in [line for line in open_ if line.poll()]:
            try:
                yield told.recv()
            except EOFError:
                open_.remove(told)
    for process in running:
        process.join()


def _send_persons(
    line: Connection, world: World, case: str, seeds: list[int], have: dict[int, set[str]]
) -> None:
    for seed in seeds:
        for name, value in run_person(world, case, seed, have[seed]):
            line.send((seed, name, value))


def summarise(case: str, runs: dict[str, list[PersonRun]]) -> Iterator[Record]:
    """Medians over persons, beside each other method."""
    ours, noisy, count = runs["ours"], runs[NOISY], len(runs["ours"])
    for method in [name for name in runs if name not in ("ours", NOISY)]:
        for mark in MARKS:
            mine = median(one.satisfaction(mark) for one in ours)
            theirs = median(one.satisfaction(mark) for one in runs[method])
            yield _record(case, f"satisfaction, {mark} actions", mine, theirs, method, count)
        theirs = median(one.satisfaction(RATINGS) for one in runs[method])
        mine = median(one.satisfaction(ACTIONS) for one in ours)
        told = f"satisfaction, {ACTIONS} actions; theirs after all"
        yield _record(case, told, mine, theirs, method, count)
    for rival in ("rated GA", "TIGA"):
        yield from _reached(case, ours, runs[rival], rival)
    worse = median(one.satisfaction(ACTIONS) for one in noisy)
    mine = median(one.satisfaction(ACTIONS) for one in ours)
    yield _record(
        case, f"satisfaction, {ACTIONS} actions, noise doubled", worse, mine, "ours", count
    )
    looks = median(_within(one)[-1].looks for one in ours)
    yield _record(case, f"looks, {ACTIONS} actions", looks, None, "", count, "1")
    hits = sum(one.steps[-1].trust.hits for one in ours)
    screens = sum(one.steps[-1].trust.screens for one in ours)
    chance = sum(one.steps[-1].trust.chance for one in ours)
    told = "screens whose pick was in the predicted top 3"
    yield _record(case, told, hits / screens, chance / screens, "guessing", screens)


def _within(one: PersonRun) -> list[SearchStep]:
    """The steps of a run within the actions and looks there are."""
    return [s for s in one.steps if s.actions <= ACTIONS and s.looks <= LOOKS]


def _reached(
    case: str, ours: list[PersonRun], theirs: list[PersonRun], rival: str
) -> Iterator[Record]:
    """On how many persons the champion reaches the best that a rival ever showed, and when."""
    first = []
    for mine, other in zip(ours, theirs, strict=True):
        enough = [
            step
            for step, liked in zip(_within(mine), mine.liked, strict=False)
            if liked / mine.top >= other.shown() - 1e-9
        ]
        first.append(enough[0] if enough else None)
    got = [s for s in first if s is not None]
    told = f"persons, best ever shown in {RATINGS} ratings reached"
    yield _record(case, told, len(got), None, rival, len(first), "1")
    shown = median(one.shown() for one in theirs)
    best = median(max(s.best for s in _within(one)) / one.top for one in ours)
    yield _record(case, "best ever shown; ours within 60 actions", best, shown, rival, len(first))
    if got:
        yield _record(
            case, "actions until then", median(s.actions for s in got), None, rival, len(got), "1"
        )
        looks = median(s.looks for s in got)
        yield _record(case, "looks until then", looks, None, rival, len(got), "1")


def _record(
    case: str,
    metric: str,
    ours: float,
    baseline: float | None,
    name: str,
    runs: int,
    unit: str = "satisfaction",
) -> Record:
    ratio = None if not baseline else round(ours / baseline, 3)
    return {
        "case": f"{case}, simulated persons",
        "metric": metric,
        "unit": unit,
        "ours": round(float(ours), 3),
        "baseline": None if baseline is None else round(float(baseline), 3),
        "baseline_name": name,
        "ratio": ratio,
        "runs": runs,
    }
