"""How soon a person is shown what she likes: ``scenewright bench person``.

**Simulated** persons (:mod:`benchmarks.person_raters`) on a flat and on a site of thirty. 0 is the
mean of layouts by chance, 1 the best that a long search finds which knows the truth (home: a
genetic algorithm of 3,600 layouts; site: the best of a pool of 400, of which whoever looks at many
sees the most; ``--full`` adds the site without a pool). An *action* is one event sent, a
*look* one candidate shown for the first time. *Satisfaction* is that of the champion, what the
person has chosen so far.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from statistics import median
from typing import Any, NamedTuple

from benchmarks import person_genetic, person_methods
from benchmarks.person_methods import SearchStep
from benchmarks.person_raters import SimulatedPerson
from benchmarks.person_world import World, home_world, site_world, wide_site_world

Record = dict[str, Any]
Progress = Callable[[float, str], None]
SCREENS, RATINGS = 12, 284
LONG, WIDE = 60, 8
"""Generations of the search that knows the truth: for a home, and for a site solved anew."""
BRED_SEEDS = 5
POOL = 400
"""Layouts of the site that persons choose from."""
ACTIONS, LOOKS = 60, 120
MARKS = (12, 24, 30, 48, 60)
SEEDS, QUICK_SEEDS, FIRST_SEED = 20, 2, 1000
"""Persons, beginning with a number that was not used for tuning."""
METHODS: dict[str, tuple[Callable[..., Iterator[SearchStep]], int]] = {
    "ours": (person_methods.ours, SCREENS),
    "rated GA": (person_genetic.rated_ga, RATINGS),
    "TIGA": (person_genetic.tiga, RATINGS),
    "paper-repaired": (person_genetic.paper, RATINGS),
    "linear Bradley-Terry": (person_methods.bradley_terry, SCREENS),
    "random": (person_methods.random_search, 24),
}


class PersonRun(NamedTuple):
    """One person and one method: its steps, and the scale of satisfaction."""

    method: str
    steps: tuple[SearchStep, ...]
    person: SimulatedPerson
    top: float

    def satisfaction(self, actions: int) -> float:
        """Satisfaction with the champion after so many actions."""
        done = [s for s in self.steps if s.actions <= actions] or [self.steps[0]]
        return self.person.truth(done[-1].champion) / self.top

    def shown(self) -> float:
        """The best ever shown, as satisfaction."""
        return self.steps[-1].best / self.top


def run(world: World, method: str, seed: int, noise: float = 1.0) -> PersonRun:
    """One method for one person."""
    person = SimulatedPerson(world, FIRST_SEED + seed, noise)
    search, much = METHODS[method]
    top = person_genetic.find_best(world, person, seed, WIDE if "bred" in world.name else LONG)
    return PersonRun(method, tuple(search(world, person, seed, much)), person, top)


def records(quick: bool, progress: Progress, *, full: bool = False) -> Iterator[Record]:
    """Records of all methods on a home and on a site."""
    seeds = QUICK_SEEDS if quick else SEEDS
    worlds: dict[str, Callable[[], World]] = {
        "home": partial(home_world, "home-studio" if quick else "home-flat"),
        "site": partial(site_world, *(("site-courtyards", 40) if quick else ("site-30", POOL))),
    }
    for number, (case, make) in enumerate(worlds.items()):
        progress(number / 2, f"{case}: layouts")
        world, runs = make(), dict[str, list[PersonRun]]()
        for k, method in enumerate(METHODS):
            progress((number + (k + 1) / 8) / 2, f"{case}: {method}")
            runs[method] = [run(world, method, seed) for seed in range(seeds)]
        progress((number + 7 / 8) / 2, f"{case}: twice the noise")
        noisy = [run(world, "ours", seed, 2.0) for seed in range(seeds)]
        yield from summarise(case, runs, noisy)
    if full:
        yield from _bred_site(progress)


def _bred_site(progress: Progress) -> Iterator[Record]:
    """The site without a pool, for a few persons: an hour on two cores. 1 is the best that a
    search which knows the truth, or any method, found."""
    progress(1.0, "site, bred: layouts")
    world, runs = wide_site_world(), dict[str, list[PersonRun]]()
    for method in METHODS:
        progress(1.0, f"site, bred: {method}")
        runs[method] = [run(world, method, seed) for seed in range(BRED_SEEDS)]
    noisy = [run(world, "ours", seed, 2.0) for seed in range(BRED_SEEDS)]
    every = [*runs.values(), noisy]
    tops = [max(max(o[k].top, o[k].steps[-1].best) for o in every) for k in range(BRED_SEEDS)]
    level = [[one._replace(top=top) for one, top in zip(o, tops, strict=True)] for o in every]
    yield from summarise("site, bred", dict(zip(METHODS, level, strict=False)), level[-1])


def summarise(
    case: str, runs: dict[str, list[PersonRun]], noisy: list[PersonRun]
) -> Iterator[Record]:
    """Medians over persons, beside each other method."""
    ours, count = runs["ours"], len(noisy)
    for method in list(runs)[1:]:
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
            s
            for s in _within(mine)
            if mine.person.truth(s.champion) / mine.top >= other.shown() - 1e-9
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
