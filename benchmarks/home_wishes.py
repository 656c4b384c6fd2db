"""What hearing wishes and outlets is worth: the share that is met, heard against ignored.

The sample with radiators, outlets and wishes is solved as it is, and with its outlets left out and
its wishes for places reduced to the things wished for; both are judged by the whole brief.
``scenewright bench home_wishes``; twenty seeds.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from benchmarks.comparison import ratio
from benchmarks.stages import tally
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.wishes import WishBrief
from scenewright.core.solution import Solution
from scenewright.domains import check, solve
from scenewright.formats import read

Record = dict[str, Any]
HOME = "sample:home-services"
SEEDS = 20
PLACES = ("by", "near", "face", "away_from")


def records(quick: bool, progress: Callable[[float, str], None] | None = None) -> Iterator[Record]:
    """The share of wishes met by kind, of pieces within reach by kind of outlet, of valid homes."""
    brief, seeds = read(HOME), 3 if quick else SEEDS
    plain = ignoring(brief)

    def runs() -> Iterator[tuple[Counter[str], Counter[str]]]:
        for seed in range(seeds):
            if progress:
                progress(seed / seeds, f"seed {seed}")
            ours, theirs = (solve(asked, seed=seed) for asked in (brief, plain))
            yield met(brief, ours), met(brief, theirs)

    return tally(runs(), _told)


def _told(runs: list[tuple[Counter[str], Counter[str]]]) -> list[Record]:
    heard, ignored = (sum(found, Counter[str]()) for found in zip(*runs, strict=True))
    kinds = sorted({key.removeprefix("of ") for key in heard})
    return [_record(kind, heard, ignored, len(runs)) for kind in kinds]


def ignoring(brief: Brief) -> Brief:
    """The brief without outlets, its wishes without places."""
    return brief.model_copy(update={"rooms": [_plain(room) for room in brief.rooms]})


def _plain(room: Room) -> Room:
    wishes = [wish.model_copy(update=dict.fromkeys(PLACES)) for wish in room.wishes]
    return room.model_copy(update={"outlets": [], "wishes": wishes})


def met(brief: Brief, solution: Solution) -> Counter[str]:
    """How many of each kind are met, and ``of`` how many, by the whole brief."""
    report = check(replace(solution, brief=brief))
    found = Counter({"homes valid": int(report.valid), "of homes valid": 1})
    wishes = [wish for room in brief.rooms for wish in room.wishes]
    for wish, told in zip(wishes, report.figures["wishes"], strict=True):
        for kind in _kinds(wish):
            found[kind] += told["fulfilled"]
            found[f"of {kind}"] += 1
    for each in report.figures["outlets"]:
        found[f"{each['outlet']} within reach"] += each["within"]
        found[f"of {each['outlet']} within reach"] += 1
    return found


def _kinds(wish: WishBrief) -> Iterator[str]:
    for place in PLACES:
        if getattr(wish, place):
            yield f"wish {place.replace('_', ' ')}"


def _record(kind: str, heard: Counter[str], ignored: Counter[str], seeds: int) -> Record:
    ours, base = (found[kind] / max(found[f"of {kind}"], 1) for found in (heard, ignored))
    return {
        "case": HOME,
        "metric": kind,
        "unit": "share",
        "ours": ours,
        "baseline": base,
        "baseline_name": "ignored",
        "ratio": ratio(ours, base, "share"),
        "runs": seeds,
    }
