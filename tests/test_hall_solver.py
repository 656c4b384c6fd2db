"""Chains of halls: energies that add up, rules that hold, answers that repeat."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import scenewright
from hall_chains import SLACK, answer, posed, rules_broken, two_zones
from scenewright.core.brief import Brief
from scenewright.core.solution import STOPPED, Solution
from scenewright.domains.hall import solving as domain
from scenewright.domains.hall.solvers.chains import (
    HallChain,
    advance,
    anneal_hall,
    begin_chain,
    gd_mh,
    layout_of,
)
from scenewright.domains.hall.solvers.guided_metropolis import count_missed
from scenewright.domains.hall.terms.table import REACH
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget
from scenewright.formats import solution_json

SAMPLES = ("exhibition", "shop", "reading-room", "auditorium", "irregular")


def sample(name: str) -> Brief:
    return scenewright.read(f"sample:hall-{name}")


def _count(solution: Solution) -> Counter[str]:
    """Objects of a hall by category, without the walls built for them."""
    return Counter(p.category for p in solution.pieces if p.category != "partition")


def fresh(chain: HallChain) -> float:
    """The energy of where a chain stands, measured from nothing."""
    base, free, reached = chain.bits
    lost = count_missed(chain.p, chain.s, chain.grid, base, free, reached, chain.inset)
    return float(measure_all(chain.p, chain.s, chain.work) + chain.p.weights[REACH] * lost)


@pytest.mark.parametrize("name", SAMPLES)
def test_energies_add_up_and_no_rule_is_broken_along_a_chain(name: str) -> None:
    problem, start = (one := posed(sample(name)).fitted).problem, one.start
    chain = begin_chain(problem, start, streams(7, 1)[0])
    assert chain.tally[0] == pytest.approx(fresh(chain), abs=1e-9)
    begun, made = float(chain.tally[2]), 0
    for _ in range(8):
        advance(chain, np.array([0.05, 20.0, 3200.0, 0.6]), made, 400)
        made += 400
        assert chain.tally[0] == pytest.approx(fresh(chain), abs=1e-6)
        assert rules_broken(problem, chain) < SLACK
    assert chain.tally[3] > 100, "hardly a move was accepted"
    assert chain.tally[2] <= begun
    best = layout_of(chain)
    assert best.energy == pytest.approx(chain.tally[2], abs=1e-6)
    assert best.energy == pytest.approx(fresh(chain), abs=1e-9)
    assert rules_broken(problem, chain) < SLACK


@pytest.mark.parametrize("solve", [anneal_hall, gd_mh])
def test_the_best_is_never_worse_than_the_start(solve: Any) -> None:
    for name, preset in (("exhibition", "default"), ("auditorium", "paper")):
        fitted = posed(sample(name), preset).fitted
        begun = begin_chain(fitted.problem, fitted.start, streams(0, 1)[0]).tally[2]
        energies = []
        for steps in (32, 600):
            found = solve(fitted.problem, fitted.start, Budget(steps=steps, threads=1), 3)
            energies.append(found.layouts[0].energy)
            assert [layout.energy for layout in found.layouts] == sorted(
                layout.energy for layout in found.layouts
            )
        assert max(energies) <= begun + 1e-9
        assert energies[1] < begun


def test_gd_mh_makes_a_thousand_iterations() -> None:
    brief = sample("shop")
    found = scenewright.solve(brief, preset="paper", seed=1)
    assert (found.solver, found.evaluations) == ("gd-mh", 1000)
    assert {value.term for value in found.terms} == {"space", "fill", "access", "proportion"}
    fitted = posed(brief, "paper").fitted
    assert gd_mh(fitted.problem, fitted.start, Budget(), 1).evaluations == 1000


@pytest.mark.parametrize("solver", ["anneal", "gd-mh"])
def test_the_same_seed_gives_the_same_hall_on_any_number_of_threads(solver: str) -> None:
    brief = sample("exhibition")
    one, two = (answer(brief, threads=n, solver=solver, steps=600) for n in (1, 2))
    assert one.pieces == two.pieces
    assert one.energies == two.energies
    assert one.detail is not None
    assert two.detail is not None
    assert one.detail.layout.groups == two.detail.layout.groups
    assert answer(brief, threads=2, solver=solver, steps=600, seed=5).pieces != one.pieces


def test_two_halls_do_not_depend_on_each_other() -> None:
    room = sample("shop").rooms[0]
    moved = room.model_copy(
        update={
            "id": "twin",
            "outline": [(x, y + 40) for x, y in room.outline],
            "doors": [],
            "windows": [],
            "zones": [],
            "links": [],
        }
    )
    demands = [one.model_copy(update={"zone": None}) for one in room.demands]
    moved = moved.model_copy(update={"demands": demands})
    brief = sample("shop")
    pair = brief.model_copy(update={"rooms": [room, moved]})
    alone, both = answer(brief, steps=200, threads=1), answer(pair, steps=200, threads=2)
    assert alone.pieces == tuple(piece for piece in both.pieces if piece.space == "shop")
    assert set(both.energies) == {"shop", "twin"}


def test_progress_is_heard_and_cancelling_keeps_what_was_found() -> None:
    brief, shares = sample("exhibition"), list[float]()
    whole = answer(brief, steps=20_000, threads=1, progress=lambda share, _: shares.append(share))
    assert shares == sorted(shares)
    assert 0.0 <= shares[0] < 0.2
    assert shares[-1] == 1.0
    heard = iter(range(10))
    part = answer(brief, steps=20_000, threads=1, cancel=lambda: next(heard, None) is None)
    assert 0 < part.evaluations < whole.evaluations
    assert _count(whole) - _count(part) == Counter(bench=3)
    assert [(one.what, one.reason) for one in part.left_out] == [("3 of 3 benches", STOPPED)]
    nothing = answer(brief, cancel=lambda: True)
    assert (nothing.evaluations, nothing.energies) == (0, {})


def test_seconds_bound_the_work() -> None:
    short, long = (
        answer(sample("irregular"), steps=None, seconds=seconds, threads=1)
        for seconds in (0.05, 1.5)
    )
    assert 100 < short.evaluations < long.evaluations


def test_locked_objects_stay_and_count(tmp_path: Path) -> None:
    """A piece locked in the file stays to the bit; its group is no larger than before."""
    path = tmp_path / "hall.json"
    first = answer(sample("exhibition"))
    scenewright.write(first, path)
    document = json.loads(path.read_text())
    kept = [p for p in document["pieces"] if p["function"] in ("finds", "boat")]
    for piece in kept:
        piece["fixed"] = True
    path.write_text(json.dumps(document))
    again = scenewright.solve(scenewright.read(path), seed=11)
    pieces = {piece.id: piece for piece in again.pieces}
    assert len(pieces) == len(again.pieces)
    for piece in kept:
        assert list(pieces[piece["id"]].pose) == piece["pose"]
        assert pieces[piece["id"]].fixed
    assert by_function(again) == by_function(first)
    assert again.pieces != first.pieces
    assert scenewright.check(again).valid
    assert again.detail is not None
    assert {"hall/finds", "hall/boat"} <= {group.id for group in again.detail.layout.groups}
    assert solution_json.loads(solution_json.dumps(again)).pieces == again.pieces


def by_function(found: Solution) -> dict[str, int]:
    names = [p.function for p in found.pieces if p.function not in ("partition", "fixed")]
    return {name: names.count(name) for name in sorted(set(names))}


def test_one_locked_object_of_many_leaves_room_for_the_others() -> None:
    """Only the one is fixed (as a brief may say): five of six are still to be placed."""
    fixed = {
        "category": "showcase",
        "at": [15, 5],
        "size": [1.2, 0.6, 2.0],
        "function": "cases",
        "group": "hall/cases",
        "id": "hall/cases/showcase_1",
    }
    sizes = [[1.2, 0.6, 2.0], [2.0, 0.6, 1.0], [1.6, 0.6, 1.4]]
    brief = two_zones(
        {"id": "cases", "category": "showcase", "sizes": sizes, "zone": "east"}, fixed=[fixed]
    )
    found = answer(brief)
    mine = [piece for piece in found.pieces if piece.function == "cases"]
    assert sorted(piece.size.width for piece in mine) == [1.2, 1.6, 2.0]
    assert len({piece.id for piece in mine}) == 3
    assert scenewright.check(found).valid


def test_no_hall_no_energy() -> None:
    """A hall without demands is an answer too."""
    found = domain.solve(two_zones())
    assert (found.pieces, found.left_out, found.evaluations) == ((), (), 0)
    assert found.detail is not None
    assert [zone.id for zone in found.detail.layout.zones] == ["west", "east"]
