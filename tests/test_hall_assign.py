"""Demands go to zones by utilisation bands: nothing is lost, nobody is overfilled."""

from __future__ import annotations

from collections import Counter

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from scenewright.core.scene import Size
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.zoning.assign import KAPPA, area_of, assign

NAMES = ("a", "b", "c")


def wish(count: int, zones: tuple[str, ...] = (), wall: bool = False) -> HallDemand:
    return HallDemand(
        "w",
        "w",
        "box",
        (Size(1.0, 1.0, 1.0),) * count,
        (0.0, 0.0, 0.0, 0.0),
        ("wall",) if wall else ("chain",),
        zones,
        "",
        True,
    )


def counts(wishes: list[HallDemand], areas: list[float], walls: list[float], whole: bool = False):
    units = assign(wishes, NAMES, np.array(areas), np.array(walls), whole)
    return units, Counter({(u.demand, u.zone): u.last - u.first for u in units})


wishes_of = st.lists(
    st.builds(
        wish, st.integers(1, 60), st.sampled_from([(), ("a",), ("b", "c"), NAMES]), st.booleans()
    ),
    min_size=1,
    max_size=5,
)


@given(
    wishes_of,
    st.lists(st.floats(5, 500), min_size=3, max_size=3),
    st.lists(st.floats(0, 80), min_size=3, max_size=3),
    st.booleans(),
)
def test_every_object_goes_to_one_allowed_zone(wishes, areas, walls, whole) -> None:
    units, _ = counts(wishes, areas, walls, whole)
    for number, asked in enumerate(wishes):
        mine = sorted((u for u in units if u.demand == number), key=lambda u: u.first)
        assert [u.first for u in mine] == [0, *(u.last for u in mine[:-1])]
        assert mine[-1].last == len(asked.sizes)
        assert {NAMES[u.zone] for u in mine} <= set(asked.zones or NAMES)
        assert len({u.zone for u in mine}) == len(mine)
        assert len(mine) == 1 or not whole


def test_a_demand_for_anywhere_fills_zones_alike() -> None:
    areas = [100.0, 200.0, 300.0]
    _, found = counts([wish(120)], areas, [0.0, 0.0, 0.0])
    for zone, area in enumerate(areas):
        assert found[0, zone] / area <= 120 / 600 + KAPPA + 1e-9
    assert sum(found.values()) == 120


def test_a_whole_group_goes_to_the_first_zone_it_keeps_in_the_band() -> None:
    asked = [wish(40), wish(20), wish(20)]
    _, found = counts(asked, [100.0, 100.0, 100.0], [0.0, 0.0, 0.0], whole=True)
    share = 80 / 300 + KAPPA
    filled = Counter()
    for (number, zone), count in found.items():
        filled[zone] += count * area_of(asked[number])
    assert found[0, 0] == 40  # over the band anywhere: the emptiest, which is the first
    assert all(filled[zone] <= 100 * share for zone in (1, 2))


def test_what_finds_no_wall_is_shared_by_all_zones() -> None:
    """Walls are built afterwards, in every zone; one zone alone could not take them all."""
    _, found = counts([wish(100, wall=True)], [200.0, 200.0, 200.0], [10.0, 10.0, 10.0])
    assert sum(found.values()) == 100
    assert max(found.values()) - min(found.values()) <= 2
