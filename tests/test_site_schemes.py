"""Figures of schemes of sites: by hand, in explanations and in the table of alternatives."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

import scenewright as sw
from scenewright.cli.commands import app
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check, plan_of
from scenewright.domains.site.schemes import NET, count_sizes, list_dwellings, measure_schemes


def piece(asset: str, width: float, depth: float, height: float) -> Piece:
    return Piece("b", "building", asset, "s", Pose(0, 0, 0, 0), Size(width, depth, height))


@pytest.mark.parametrize(
    ("asset", "width", "floors", "count"),
    [("modern_residential", 38.0, 5, 20), ("row_houses", 36.0, 2, 6), ("villa", 12.0, 2, 1)],
)
def test_dwellings_share_the_net_floor(asset: str, width: float, floors: int, count: int) -> None:
    sizes = list_dwellings(piece(asset, width, 10.0, 3.0 * floors), width * 10.0, floors)
    assert len(sizes) == count
    assert sum(sizes) == pytest.approx(NET * width * 10.0 * floors)
    assert sum(count_sizes(sizes).values()) == count


def test_figures_add_up_and_are_told(tmp_path) -> None:
    solution = sw.solve(sw.read("sample:site-square"))
    judged = check(solution).figures["sites"]["square"]
    (row,) = measure_schemes(solution, plan_of(solution.brief)).values()
    assert 0.0 < sum(row["floor_by_use"].values()) < judged["floor_area"]
    assert sum(row["dwellings_by_size"].values()) == row["dwellings"]
    assert row["bays_per_dwelling"] == pytest.approx(44 / row["dwellings"], abs=1e-3)
    assert 0.0 < row["green"] < judged["area"] * (1.0 - judged["coverage"])
    assert row["trees"] == sum(p.category == "tree" for p in solution.pieces)
    file = tmp_path / "square.json"
    sw.write(solution, file)
    told = CliRunner().invoke(app, ["explain", str(file)]).output
    assert "dwellings" in told
    assert "housing" in told
    document = json.loads(CliRunner().invoke(app, ["explain", str(file), "--json"]).output)
    assert document["sites"]["square"]["dwellings"] == row["dwellings"]


def test_alternatives_are_a_table_of_schemes(tmp_path) -> None:
    line = ["arrange", "sample:site-courtyards", "--alternatives", "2", "-o"]
    told = (
        CliRunner().invoke(app, [*line, str(tmp_path / "plan.svg")], env={"COLUMNS": "200"}).output
    )
    assert "FAR" in told
    assert "dwellings" in told
