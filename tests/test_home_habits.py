"""Learned habits as targets: how they weigh, and that layouts follow them."""

from __future__ import annotations

from math import isnan, nan, pi
from pathlib import Path

import numpy as np
import pytest
from benchmarks.home_learned import WAYS, records

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief, Room
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.domains.home.learned import habits
from scenewright.domains.home.learned.groups import Learned, write
from scenewright.domains.home.learned.habits import TRUST, WISHED_MOST, habits_of
from scenewright.domains.home.learned.learning import FurnishedSpace, found_in
from scenewright.domains.home.learned.rows import Beside, Clearance, Distance, Share, Targets
from scenewright.domains.home.learned.targets import targets_of

PAIR = ("seating", "media")


def told(
    distances: tuple[Distance, ...] = (),
    clearances: tuple[Clearance, ...] = (),
    shares: tuple[Share, ...] = (),
) -> habits.Habits:
    return habits_of([Targets(distances, clearances, shares)])


@pytest.mark.parametrize("seen", [0, 1, 5, 20, 1000])
def test_a_distance_is_the_weighted_mean_of_learned_and_usual(seen: int) -> None:
    known = told((Distance(*PAIR, 4.0, 3.0, 5.0, seen),))
    found = habits.distance(known, PAIR, 2.5)
    weight = seen / (seen + TRUST)
    assert found == pytest.approx(weight * 4.0 + (1 - weight) * 2.5)
    assert habits.distance(known, ("media", "seating"), 2.5) == 2.5


def test_an_angle_follows_the_most_seen_quarter_turn() -> None:
    few, many = ((0, n, 1) for n in (3, 9))
    for turns, wanted in ((few, pi), (many, pi / 2)):
        known = told((Distance(*PAIR, 2.0, 2.0, 2.0, 9, turns),))
        assert habits.angle(known, PAIR, pi) == pytest.approx(wanted)
    assert isnan(habits.angle(known, PAIR, nan))
    assert habits.angle(habits.NONE, PAIR, pi) == pi


def test_clearances_stay_between_a_walking_route_and_what_one_can_wish() -> None:
    usual = (0.75, 0.0, 0.0, 0.0)

    def clear(low: float, seen: int, side: Beside = "front") -> tuple[float, ...]:
        return habits.clear(
            told((), (Clearance("wardrobe", side, low, 9.0, seen),)), "wardrobe", usual
        )

    assert clear(1.0, 5)[0] == pytest.approx(0.875)
    assert clear(0.0, 10**6)[0] == pytest.approx(0.6)
    assert clear(20.0, 10**6)[0] == pytest.approx(WISHED_MOST, abs=1e-3)
    assert clear(0.4, 5, "beside") == pytest.approx((0.75, 0.2, 0.0, 0.2))
    known = told((), (Clearance("desk", "front", 0.0, 0.0, 10**6),))
    assert habits.clear(known, "desk", (0.25, 0, 0, 0))[0] == 0.25, "never below the least usual"


def test_shares_count_by_how_alike_the_rooms_are() -> None:
    known = told((), (), (Share("bedroom", 10.0, 0.5, ("shelf",)), Share("bedroom", 90.0, 0.1)))
    near, far = (habits.share(known, "double_bedroom", area, 0.3) for area in (10.0, 90.0))
    assert near == pytest.approx((0.5 + TRUST * 0.3) / (1 + TRUST))
    assert far == pytest.approx((0.1 + TRUST * 0.3) / (1 + TRUST))
    assert habits.share(known, "kitchen", 10.0, 0.3) == 0.3
    common = habits.common(known, "bedroom", 10.0, ["sleeping"])
    assert common["shelf"] == pytest.approx(1 / (1 + TRUST), abs=1e-6)
    assert common["sleeping"] == pytest.approx(TRUST / (1 + TRUST), abs=1e-6)


BEDROOM = {
    "id": "bed",
    "function": "double_bedroom",
    "doors": [{"at": [0.0, 0.8], "width": 0.85}],
    "outline": [[0, 0], [4.6, 0], [4.6, 4.2], [0, 4.2]],
    "windows": [{"at": [4.6, 2.0], "width": 1.4}],
}


def furnished(tmp_path: Path, targets: Targets, seed: int = 1) -> Solution:
    """A bedroom furnished with the shipped groups and some habits."""
    write(Learned(1, (), targets), tmp_path / "groups.json")
    brief = Brief(rooms=[Room.model_validate(BEDROOM)], groups=[str(tmp_path / "groups.json")])
    answer = home.solve(brief, steps=2000, seed=seed)
    assert check(answer).valid
    return answer


def share_and_front(answer: Solution) -> tuple[float, float]:
    """The furnished share, and the free floor before the wardrobe."""
    room = FurnishedSpace("", spaces(answer.brief)[0], answer.pieces)
    rows = targets_of([room], list(found_in(room, shipped())), shipped())
    front = [c.low for c in rows.clearances if (c.function, c.side) == ("wardrobe", "front")]
    return rows.shares[0].share, front[0]


def test_rooms_hold_what_people_hold_in_such_rooms(tmp_path: Path) -> None:
    """Thirty rooms half empty, or half full, and shelves in all of the latter."""
    area = 4.6 * 4.2
    sparse = Targets((), (), (Share("bedroom", area, 0.12, ("sleeping",)),) * 30)
    full = Targets((), (), (Share("bedroom", area, 0.45, ("sleeping", "shelf")),) * 30)
    usual, less, more = (furnished(tmp_path, t) for t in (Targets((), (), ()), sparse, full))
    shares = [share_and_front(s)[0] for s in (less, usual, more)]
    assert shares[0] < shares[1] - 0.02
    assert shares[2] > shares[1] + 0.01
    assert "shelf" in {p.function for p in more.patches} - {p.function for p in usual.patches}
    assert {"sleeping", "wardrobe"} <= {p.function for p in less.patches}


def test_free_floor_follows_what_was_learned(tmp_path: Path) -> None:
    rows = tuple(Clearance(f, "front", 1.5, 2.0, 200) for f in ("wardrobe", "chest", "vanity"))
    usual, wide = (share_and_front(furnished(tmp_path, Targets((), r, ())))[1] for r in ((), rows))
    assert wide >= max(usual, 1.2) - 1e-6
    others = [
        share_and_front(furnished(tmp_path, Targets((), rows, ()), k))[1] for k in range(2, 8)
    ]
    assert min(others) >= 1.2
    assert np.isfinite(usual)


@pytest.mark.realdata
@pytest.mark.usefixtures("real_data")
def test_homes_held_out() -> None:
    rows = list(records(quick=True))
    assert {row["case"] for row in rows} == set(WAYS)
    valid = [row["ours"] for row in rows if row["metric"] == "homes valid"]
    assert valid == [1.0] * len(WAYS)
    assert all(np.isfinite(row["ours"]) for row in rows)
