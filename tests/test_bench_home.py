"""The benchmark of all methods of homes: C and our kernels agree, peers keep to their budget."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks import home_kernel
from benchmarks.home_methods import Method, lay_out, lines, named, table
from benchmarks.home_peers import PEERS, Ended, Objective, SpentError, peers
from benchmarks.home_rooms import Case, rooms

from rooms import full_problem, random_layouts
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.solvers import SOLVERS
from scenewright.engine.solve import Budget

WEIGHTS = {
    "boundary": 5000.0,
    "overlap": 600.0,
    "keep_free": 600.0,
    "main_wall": 1500.0,
    "against_wall": 1000.0,
    "pairs": 110.0,
    "size": 50.0,
}


def printed_problem():
    """The paper's seven costs, with no zones but those of doors, under a level ceiling."""
    problem, none, high = full_problem(printed=True), np.zeros((0, 5)), np.zeros((0, 6))
    ground = problem.ground._replace(
        use_space=none, paths=np.zeros((0, 4)), obstacles=none, windows=high, slopes=high
    )
    return problem._replace(ground=ground, weights=WEIGHTS)


def test_the_same_loops_in_c_say_the_same(tmp_path):
    library = home_kernel.compile_c(tmp_path)
    if library is None:
        pytest.skip("no C compiler")
    problem = printed_problem()
    layouts, found = random_layouts(problem, 300), np.empty(300)
    layouts[..., 3:] *= np.linspace(0.5, 3.0, 300)[:, None, None]  # floors too empty and too full
    home_kernel.in_c(library, problem).fill(layouts, found)
    assert found == pytest.approx(evaluate(problem, layouts), rel=home_kernel.ALIKE)
    mine = np.empty(300)
    home_kernel.ours(problem).fill(layouts, mine)
    assert mine.tolist() == evaluate(problem, layouts).tolist()


def test_without_a_compiler_c_is_left_out_with_a_word(monkeypatch, capsys):
    monkeypatch.setenv("PATH", "/nowhere")
    assert home_kernel.bench_kernel(1) == []
    assert "no C compiler" in capsys.readouterr().err


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.name)
def test_peers_keep_to_their_budget_and_tell_the_truth(peer):
    pytest.importorskip(peer.package, reason=f"needs {peer.package}, of the extra 'peers'")
    problem = full_problem()
    ended = peer.run(problem, Budget(steps=500), 0)
    assert ended.evaluations == 500
    assert evaluate(problem, ended.boxes[None])[0] == pytest.approx(ended.energy)
    assert ended.energy < np.median(evaluate(problem, random_layouts(problem, 200)))
    again = peer.run(problem, Budget(steps=500), 0)
    assert again.energy == ended.energy


def test_absent_peers_are_named(monkeypatch, capsys):
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    assert peers() == ()
    told = capsys.readouterr().err
    assert all(peer.name in told for peer in PEERS)


def test_an_objective_stops_at_its_last_layout():
    objective = Objective(full_problem(), Budget(steps=5))
    genes = np.random.default_rng(0).uniform(size=(4, len(objective.low)))
    assert len(objective(genes)) == 4
    with pytest.raises(SpentError):
        objective(genes)
    assert objective.looked == 5


@pytest.mark.parametrize("name", sorted(SOLVERS))
def test_every_solver_is_a_method_judged_by_the_problems_energy(name):
    problem = full_problem()
    row = lay_out(named(name), Case("room", problem, problem), Budget(steps=400, threads=1), 0)
    found = SOLVERS[name].run(problem, Budget(steps=400, threads=1), 0).layouts[0]
    assert row["energy"] == pytest.approx(found.energy)
    assert (row["method"], row["layouts"] >= 200) == (name, True)


def test_tables_count_who_is_best_and_who_ours_beats():
    energies = {"anneal": (1.0, 5.0, 3.0), "other": (2.0, 4.0, 3.0)}
    rows = [
        {
            "case": "room",
            "seed": seed,
            "method": method,
            "energy": energy,
            "seconds": 0.1,
            "layouts": 10,
            "budget": "b",
        }
        for method, found in energies.items()
        for seed, energy in enumerate(found)
    ]
    ours, other = table(rows, "room")
    assert (ours["best"], other["best"]) == (2, 2)
    assert (ours["ours as good"], other["ours as good"]) == (3, 2)
    assert (other["lower"], other["median"], other["upper"]) == (2.5, 3.0, 3.5)
    assert sum("| other |" in line for line in lines([ours, other])) == 1


@pytest.mark.realdata(quick=True)
@pytest.mark.usefixtures("real_data")
def test_rooms_are_a_fixed_list_and_pieces_are_measured_as_patches():
    found = rooms(2)
    assert [case.name for case in found] == [
        "08-86-1bce8a0837ba7150e4089040d0e4-0001/0-kitchen",
        "00-98-8a5263f5df97e011419c43194b58-0002/1-hall",
    ]
    case = found[0]
    merrell = named("merrell")
    row = lay_out(merrell, case, Budget(steps=500, threads=1), 0)
    assert 0.0 < row["stand"] <= 1.0
    still = Method("still", lambda p, *_: Ended(np.zeros((len(p.names), 5)), 0.0, 1))
    assert lay_out(still, case, Budget(steps=1), 0)["stand"] == 0.0
