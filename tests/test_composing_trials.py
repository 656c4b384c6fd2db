"""Places of a group are furnished only as far as anybody looks, and come in the order of cost."""

from __future__ import annotations

from itertools import islice

import numpy as np

from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.judging import JudgedRoom
from scenewright.domains.home.composing.places.trials import FormTrial, furnish_by_cost

CASE = cases("wardrobe").groups[0]
LEAST = [3.0, 1.0, 2.0, 1.0, 9.0, 0.5]
COSTS = [3.0, 4.0, 2.0, 4.0, 9.0, None]


def list_trials():
    """One trial for each least cost, its number in the place of its energy."""
    return [FormTrial(CASE, np.zeros(5), float(k), least) for k, least in enumerate(LEAST)]


def furnish_by_table(furnished):
    """What furnishes a trial by the table of costs and notes its number."""

    def furnish(trial):
        number = int(trial.energy)
        furnished.append(number)
        cost = COSTS[number]
        return None if cost is None else JudgedRoom((number,), cost)

    return furnish


def test_rooms_come_by_cost_and_of_equal_ones_the_earlier_first():
    rooms = furnish_by_cost(list_trials(), furnish_by_table([]))
    assert [room.placed[0] for room in rooms] == [2, 0, 1, 3, 4]


def test_nothing_is_furnished_that_cannot_be_next():
    furnished: list[int] = []
    rooms = furnish_by_cost(list_trials(), furnish_by_table(furnished))
    assert [room.cost for room in islice(rooms, 1)] == [2.0]
    assert sorted(furnished) == [1, 2, 3, 5]
