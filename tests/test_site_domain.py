"""Sites from end to end: samples are built on, valid, the same by seed, and can be saved."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.formats import solution_json

SAMPLES = ("site-30", "site-120", "site-courtyards")


def site(**more: object) -> Brief:
    ground = {"id": "s", "outline": [[0, 0], [120, 0], [120, 80], [0, 80]]}
    return Brief.model_validate({"domain": "site", "sites": [ground | more]})


def buildings(solution: sw.Solution) -> list[sw.Piece]:
    return [p for p in solution.pieces if p.category == "building" and not p.fixed]


@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("seed", [0, 1])
def test_samples_hold_all_they_ask_for_and_break_no_rule(name: str, seed: int) -> None:
    brief = sw.read(f"sample:{name}")
    solution = sw.solve(brief, seed=seed)
    report = sw.check(solution)
    assert report.valid, [found.message for found in report.findings]
    asked = sum(row.count for row in brief.part.sites[0].buildings)
    assert len(buildings(solution)) == asked
    assert not solution.left_out


def test_the_same_seed_gives_the_same_site() -> None:
    brief = sw.read("sample:site-30")
    one, other = (sw.solve(brief, seed=4) for _ in range(2))
    assert one.pieces == other.pieces
    assert one.pieces != sw.solve(brief, seed=5).pieces


def test_a_saved_site_reads_back() -> None:
    solution = sw.solve(site(buildings=[{"model": "villa", "count": 3}]))
    again = solution_json.loads(solution_json.dumps(solution))
    assert again.pieces == solution.pieces
    assert again.brief == solution.brief


@pytest.mark.parametrize("suffix", [".svg", ".geojson", ".cityjson", ".glb", ".json"])
def test_sites_are_written(suffix: str, tmp_path: Path) -> None:
    solution = sw.solve(site(buildings=[{"model": "villa", "count": 2}], origin=[11.5, 49.5]))
    sw.write(solution, tmp_path / f"site{suffix}")
    assert (tmp_path / f"site{suffix}").stat().st_size > 500


def test_only_sites_become_city_models(tmp_path: Path) -> None:
    hall = sw.solve(sw.read("sample:home-studio"), steps=100)
    with pytest.raises(InputError, match="only sites"):
        sw.write(hall, tmp_path / "home.cityjson")


def test_what_finds_no_place_is_named() -> None:
    solution = sw.solve(site(buildings=[{"model": "commercial_block", "count": 9}]))
    assert len(buildings(solution)) + int(solution.left_out[0].what.split()[0]) == 9
    assert "no place left for 64 x 36 m" in solution.left_out[0].reason


def test_buildings_keep_to_their_forms_and_landmarks_stay() -> None:
    landmark = {"id": "temple", "model": "pavilion", "at": [60, 40]}
    solution = sw.solve(
        site(
            landmarks=[landmark],
            buildings=[{"model": "row_houses", "count": 4, "forms": ["parallel"]}],
        )
    )
    assert all(abs(p.pose.heading + math.pi / 2) < 1.6 for p in buildings(solution))
    temple = next(p for p in solution.pieces if p.id == "s/temple")
    assert temple.pose[:2] == (60, 40)


def test_a_site_without_wishes_is_filled_to_its_ratio() -> None:
    solution = sw.solve(site(coverage=0.15))
    covered = sum(p.size.width * p.size.depth for p in buildings(solution))
    assert 0.05 < covered / (120 * 80) < 0.2


BAD = {
    "an unknown model": ({"buildings": [{"model": "vila"}]}, "use one of: villa"),
    "higher than the limit": (
        {"height_limit": 6, "buildings": [{"model": "villa"}]},
        "the limit of the site is 6 m",
    ),
    "a crossing outline": ({"outline": [[0, 0], [50, 50], [50, 0], [0, 50]]}, "crosses"),
    "a setback that leaves nothing": (
        {"setback": 19, "outline": [[0, 0], [30, 0], [30, 30]]},
        "setback",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_sites_are_told_in_one_line(name: str) -> None:
    more, told = BAD[name]
    with pytest.raises(InputError) as caught:
        sw.solve(site(**more))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
    json.dumps(str(caught.value))
