"""No generator of furniture draws a piece below its least useful size."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from scenewright.core.catalog import Group
from scenewright.domains.home.composing.filling.widths import GROWING
from scenewright.domains.home.composing.kitchens.corners import _between, _units_of_arm
from scenewright.domains.home.composing.places.forms import FURTHER, IN_KITCHEN
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.fitted_kitchen import cook, wash
from scenewright.domains.home.groups.kitchen import FILLER, Unit, fill, sequence
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.groups.low_fridges import SHORTEST, pantry, take_in
from scenewright.domains.home.groups.mini_kitchens import bare, mini_kitchens
from scenewright.domains.home.least_sizes import CABINET, LEAST_SIZES, is_useful
from scenewright.domains.home.needs.household import FURTHER as FOR_MANY


def list_all_cases() -> Iterator[Group]:
    for kind in GROUPS.values():
        yield from kind.cases()
    for table in (FURTHER, IN_KITCHEN, LEAST, FOR_MANY):
        for generate in table.values():
            yield from generate()
    for growing in GROWING.values():
        for growth in growing.values():
            yield from growth.forms()
    yield from mini_kitchens()


def test_no_case_of_any_generator_is_below_its_use() -> None:
    cases = list(list_all_cases())
    useless = {
        (case.name, m.category, m.size[:2])
        for case in cases
        for m in case.members
        if m.z < 0.1 and not is_useful(m.category, m.size.width, m.size.depth, m.asset)
    }
    assert not useless
    assert {m.category for case in cases for m in case.members} >= LEAST_SIZES.keys()


LENGTHS = np.arange(16, 80) / 20
RUNS = {
    "a whole run": (sequence, 0.8, LENGTHS),
    "a hob": (cook, 0.95, LENGTHS),
    "a sink": (wash, 0.5, LENGTHS),
    "a mini kitchen": (bare, 0.8, LENGTHS[LENGTHS < 1.29]),
    "a pantry": (pantry, SHORTEST, LENGTHS[LENGTHS < 2.0]),
    "an arm with a hob": (lambda wide: _units_of_arm("h", wide), 0.6, LENGTHS),
    "an arm with a sink": (lambda wide: _units_of_arm("s", wide), 0.5, LENGTHS),
    "an arm with both": (lambda wide: _units_of_arm("hs", wide), 1.1, LENGTHS),
    "a sink in a U": (lambda wide: _between("s", wide), 0.5, LENGTHS[LENGTHS < 1.81]),
    "a hob in a U": (lambda wide: _between("h", wide), 0.3, LENGTHS[LENGTHS < 1.81]),
}


@pytest.mark.parametrize("name", RUNS)
def test_units_fill_their_length_and_none_is_below_its_use(name: str) -> None:
    lay, least, lengths = RUNS[name]
    for length in lengths[lengths >= least - 1e-9]:
        units: list[Unit] = list(lay(float(length)))
        assert sum(wide for _, wide in units) == pytest.approx(float(length)), units
        assert all(is_useful(kind, wide, 0.6) for kind, wide in units), units


def test_a_remainder_is_a_strip_and_no_cabinet() -> None:
    assert [name for name, _ in fill(CABINET.width - 0.01)] == [FILLER]
    assert [name for name, _ in fill(CABINET.width)] == ["drawer_cabinet"]
    taken = take_in((("sink_cabinet", 0.6), ("drawer_cabinet", 0.75), ("hob_cabinet", 0.6)))
    assert taken is not None
    assert taken[2][0] == FILLER
