"""What the presets of the papers do, read from their traces: not what fields say, what was done."""

from __future__ import annotations

import ast
import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.domains.extend.printed import PlotGrid
from scenewright.domains.extend.solvers.ants import run_ants
from scenewright.domains.extend.solvers.colony import breed
from scenewright.domains.hall.solving import solve as solve_hall
from scenewright.domains.home.solving import solve as solve_home
from scenewright.domains.site.solving import solve as solve_site
from scenewright.domains.village.paper.retrieval import RetrievedHouse, door_facing, retrieve
from scenewright.domains.village.solving import solve as solve_village
from scenewright.engine.trace import Step
from scenewright.workflow.arrange import arrange

EVEN = np.full(4, 0.25)


def of_kind(steps: list[Step], kind: str) -> list[Step]:
    return [step for step in steps if step.kind == kind]


def share(steps: list[Step], part: str, whole: str) -> float:
    return sum(s.facts[part] for s in steps) / sum(s.facts[whole] for s in steps)


@pytest.fixture(scope="module")
def site() -> list[Step]:
    heard = list[Step]()
    solve_site(sw.read("sample:site-square"), preset="paper", hear=heard.append)
    return heard


def test_sites_are_bred_for_at_most_two_hundred_generations(site: list[Step]) -> None:
    begun, stop = site[0], site[-1]
    assert (begun.kind, stop.kind) == ("begin", "stop")
    assert begun.facts["population"] == 10
    assert begun.facts["generations"] == 200
    bred = of_kind(site, "generation")
    assert all(len(step.facts["values"]) == step.facts["population"] for step in bred)
    assert {step.facts["population"] for step in bred} == {10}
    assert max(step.number for step in bred) <= stop.number <= 200
    assert stop.facts["reason"] in ("the last generation", "nothing new in 50 generations")
    looked = [step.facts["evaluations"] for step in bred]
    assert looked == sorted(looked)
    assert looked[-1] == stop.facts["evaluations"] <= 2000


def test_sites_are_crossed_and_mutated_as_often_as_printed(site: list[Step]) -> None:
    """Few generations are global, so the shares are of several seeds."""
    heard = list[Step]()
    for seed in range(1, 5):
        brief = sw.read("sample:site-square")
        solve_site(brief, preset="paper", seed=seed, steps=200, hear=heard.append)
    bred = [step for step in of_kind(heard, "generation") if step.facts["stage"] == "global"]
    pairs = sum(step.facts["pairs"] for step in bred)
    assert share(bred, "crossed", "pairs") == pytest.approx(0.75, abs=4 * (0.19 / pairs) ** 0.5)
    mutated = sum(step.facts["mutated"] for step in bred) / (2 * pairs)
    assert mutated == pytest.approx(0.04, abs=4 * (0.039 / 2 / pairs) ** 0.5)


def test_equation_12_ends_the_global_search_once(site: list[Step]) -> None:
    bred = of_kind(site, "generation")
    stages = [step.facts["stage"] for step in bred]
    first = stages.index("local")
    assert stages == ["global"] * first + ["local"] * (len(stages) - first)
    ended = bred[first].facts["settled"]
    assert bred[first - 1].number <= ended < bred[first].number
    assert all((step.facts["rho"] > 0.0) == (step.number < ended) for step in bred[:first])


def plots(rows: int = 6, columns: int = 8) -> PlotGrid:
    x, y = np.meshgrid(np.arange(columns) * 20.0, np.arange(rows) * 20.0)
    free = np.ones((rows, columns), bool)
    return PlotGrid(np.stack([x, y], -1), free, np.array([80.0, 120.0, 200.0]), 2400.0)


@pytest.fixture(scope="module")
def ants() -> list[Step]:
    heard = list[Step]()
    rng = np.random.default_rng(0)
    run_ants(plots(4, 5), EVEN, None, rng, hear=heard.append)
    return heard


def test_three_hundred_ants_walk_twenty_times_and_trails_move(ants: list[Step]) -> None:
    walked = of_kind(ants, "ants")
    assert [step.number for step in walked] == list(range(1, 21))
    assert {step.facts["ants"] for step in walked} == {300}
    assert ants[-1].facts == {"reason": "the last of its iterations", "evaluations": 6000}
    assert all(step.facts["moved"] > 0 for step in walked)
    assert all(step.facts["far"] > 0 for step in walked)
    assert walked[0].facts["rho"] == 0.5 > walked[-1].facts["rho"] == 0.1
    assert np.mean([step.facts["greedy"] for step in walked]) == pytest.approx(0.5, abs=0.02)


def test_eight_are_bred_thirty_times_and_few_genes_mutate() -> None:
    heard = list[Step]()
    for seed in range(4):
        breed(plots(), EVEN, None, np.random.default_rng(seed), hear=heard.append)
    bred = of_kind(heard, "generation")
    assert [step.number for step in bred] == list(range(1, 31)) * 4
    assert {step.facts["population"] for step in bred} == {8}
    assert {step.facts["evaluations"] for step in of_kind(heard, "stop")} == {240}
    born = [step for step in bred if step.facts["genes"]]
    assert 20 < len(born) < len(bred)
    assert share(born, "mutated", "genes") == pytest.approx(0.028, abs=0.005)
    crossed = sum(step.facts["crossed"] for step in born) / (8 * len(born))
    assert crossed == pytest.approx(0.56, abs=0.08)
    assert all(a.facts["best"] <= b.facts["best"] for a, b in pairwise(bred[:30]))


def test_nothing_heard_changes_nothing() -> None:
    heard = list[Step]()
    brief = sw.read("sample:site-square")
    told = solve_site(brief, preset="paper", steps=60, hear=heard.append)
    assert heard
    assert told.pieces == solve_site(brief, preset="paper", steps=60).pieces


def test_a_trace_is_written_beside_the_outputs_a_line_a_step(tmp_path: Path) -> None:
    file = tmp_path / "trace.jsonl"
    arranged = arrange("sample:extend-terrace", preset="paper", layouts=80, trace=file)
    lines = [json.loads(line) for line in file.read_text("utf-8").splitlines()]
    assert lines[0]["kind"] == "run"
    assert lines[0]["brief_hash"] == arranged.solution.brief_hash
    assert {line["space"] for line in lines[1:]} == {"east"}
    assert [line["kind"] for line in lines if line["kind"] in ("begin", "stop")] == [
        *["begin", "stop"] * 2
    ]
    assert lines[-1]["evaluations"] == 40
    again = tmp_path / "again.jsonl"
    arrange("sample:extend-terrace", preset="paper", layouts=80, trace=again)
    assert again.read_bytes() == file.read_bytes()


def test_a_trace_of_a_solver_that_tells_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="the solver 'anneal' tells no steps") as fault:
        arrange("sample:home-room", trace=tmp_path / "trace.jsonl")
    assert "paper-ga" in str(fault.value)


def test_homes_are_bred_forty_by_a_hundred() -> None:
    heard = list[Step]()
    solve_home(sw.read("sample:home-room"), preset="paper", hear=heard.append)
    bred = of_kind(heard, "generation")
    assert [step.number for step in bred] == list(range(1, 101))
    assert {len(step.facts["energies"]) for step in bred} == {40}
    later = bred[1:]
    crossed = sum(step.facts["crossed"] for step in later) / (20 * len(later))
    mutated = sum(step.facts["mutated"] for step in later) / (40 * len(later))
    assert crossed == pytest.approx(0.9, abs=0.03)
    assert mutated == pytest.approx(0.85, abs=0.03)
    assert [step.facts["mutation"] for step in bred].count("normal") == 49
    assert any(min(b.facts["energies"]) > min(a.facts["energies"]) for a, b in pairwise(bred))
    assert all(b.facts["best"] <= a.facts["best"] for a, b in pairwise(bred))


def test_halls_make_a_thousand_iterations_with_their_energies_told() -> None:
    heard = list[Step]()
    solve_hall(sw.read("sample:hall-shop"), preset="paper", hear=heard.append)
    begun, blocks, stop = heard[0], heard[1:-1], heard[-1]
    assert begun.facts["settings"]["rate"] == 0.1
    assert set(begun.facts["weights"]) == {"space", "fill", "access", "proportion"}
    assert [step.facts["iterations"] for step in blocks] == list(range(50, 1001, 50))
    assert stop.facts == {"reason": "the last iteration", "iterations": 1000}
    accepted = [step.facts["accepted"] for step in blocks]
    assert 0 < accepted[0] <= accepted[-1] < 1000
    assert accepted == sorted(accepted)
    assert blocks[-1].facts["step"] == 0.5 < blocks[0].facts["step"]


def test_continue_is_asked_before_every_house() -> None:
    heard = list[Step]()
    village = sw.read("sample:village-hamlet")
    solution = solve_village(village, preset="paper", hear=heard.append)
    built, last = of_kind(heard, "house"), of_kind(heard, "continue")
    assert [step.number for step in built] == list(range(1, len(built) + 1))
    assert all(step.facts["odds"] >= 0.5 for step in built)
    assert len(built) > 5
    no = last[0].facts["odds"] < 0.5
    reason = "continue says stop" if no else "as much stands as is asked for"
    assert heard[-1].facts["reason"] == reason
    assert no or len(built) == 14
    houses = [piece for piece in solution.pieces if piece.group == "hamlet/houses"]
    assert len(houses) <= len(built)


def fields_of(tree: ast.Module) -> list[tuple[str, str]]:
    """Fields of the classes of settings that a module defines."""
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    return [
        (one.name, line.target.id)
        for one in classes
        if one.name.endswith("Settings") or one.name == "PaperGenetic"
        for line in one.body
        if isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name)
    ]


@pytest.mark.parametrize("domain", ["home", "hall", "site", "extend", "village"])
def test_every_parameter_of_a_preset_is_read(domain: str, root: Path) -> None:
    package = root / "src" / "scenewright"
    shared = [package / "engine" / "genetic.py"] if domain == "home" else []
    files = [*(package / "domains" / domain).rglob("*.py"), *shared]
    trees = [ast.parse(file.read_text("utf-8")) for file in files]
    read = {
        node.attr
        for tree in trees
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load)
    }
    text = "".join(file.read_text("utf-8") for file in files)
    fields = [field for tree in trees for field in fields_of(tree)]
    moves = [name for owner, name in fields if owner == "BuildingMoveSettings"]
    read |= {name for k, name in enumerate(moves) if f"drawn[{k}]" in text}  # by compiled code
    assert len(fields) >= 5
    assert not [f"{owner}.{name}" for owner, name in fields if name not in read]


def test_the_house_retrieved_has_the_best_category_and_angle_of_the_whole_library() -> None:
    """category / 2 + angle / 100: material alone gives way to 10 degrees, shape to 40."""
    ring = np.array([[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]])
    floor, none = shapely.box(0, 0, 60, 60), np.empty(0, object)
    asked = (1, 0, 1)
    front, back = np.array([3.0, 0.0]), np.array([3.0, 4.0])
    library = [
        RetrievedHouse(ring, back, (0, 1, 1)),
        RetrievedHouse(ring, front, (0, 0, 1)),
        RetrievedHouse(ring, front, (1, 0, 1)),
        RetrievedHouse(ring, front, (1, 0, 1)),
    ]
    found = retrieve(library, asked, np.array([20.0, 3.0]), 0.0, floor, floor, none)
    assert found is not None
    assert found.number == 2
    assert found.score == pytest.approx(0.9 + door_facing(*found.placed[:2], floor) / 100)
    assert retrieve(library[:2], asked, np.array([20.0, 3.0]), 0.0, floor, floor, none).number == 1
    outside = shapely.box(0, 0, 1, 1)
    assert retrieve(library, asked, np.array([20.0, 3.0]), 0.0, floor, outside, none) is None
