"""Sets of scenes: every plan in many homes, every home in many looks, and the manifest."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import scenewright as sw
from scenewright import domains
from scenewright.batch import Variation
from scenewright.batch.jobs import BatchOptions, list_jobs
from scenewright.batch.ledger import measure_file
from scenewright.building.joinery import parts
from scenewright.catalog.loading import catalog_of
from scenewright.cli import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Opening
from scenewright.formats import glb, read, read_planned
from scenewright.render.daylight import HOURS, sun_at
from scenewright.workflow.disturb import _moved
from scenewright.workflow.looks import Look, draw_clutter, vary_brief
from scenewright.workflow.manifest import plan_hash, split_of

OPTIONS = BatchOptions((".json",), "default", None, None, 200, 0, False)
ALL = Variation(range(2), 2)


def plans(folder: Path, count: int) -> Path:
    """Toilets of several widths, furnished in milliseconds."""
    folder.mkdir()
    for k in range(count):
        outline = [[0, 0], [1.6 + 0.1 * k, 0], [1.6 + 0.1 * k, 2], [0, 2]]
        door = {"at": [0.8, 0], "width": 0.8, "swing": "out"}
        room = {"name": "WC", "function": "toilet", "outline": outline, "doors": [door]}
        (folder / f"wc-{k}.json").write_text(json.dumps({"rooms": [room]}))
    (folder / "manifest.jsonl").write_text('{"file": "wc-0.json"}\n')
    return folder


def lines_of(folder: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (folder / "manifest.jsonl").read_text().splitlines()]


def test_seeds_and_looks_have_names_of_their_own_and_keys_that_stay(tmp_path: Path) -> None:
    folder = plans(tmp_path / "in", 2)
    jobs = list_jobs([folder], tmp_path / "out", OPTIONS, ALL)
    assert [job.name for job in jobs[:4]] == ["wc-0-0-1", "wc-0-0-2", "wc-0-1-1", "wc-0-1-2"]
    assert len({job.key for job in jobs}) == len({job.name for job in jobs}) == 8
    more = list_jobs([folder], tmp_path / "out", OPTIONS, Variation(range(1, 9), 3))
    known = {job.name: job.key for job in more}
    assert [known[job.name] for job in jobs if job.seed] == [job.key for job in jobs if job.seed]


def test_a_set_goes_on_and_says_what_it_holds(tmp_path: Path) -> None:
    folder, out, before = plans(tmp_path / "in", 2), tmp_path / "out", list[bool]()
    make = {"jobs": 1, "steps": 200, "formats": (".json", ".glb"), "manifest": "jsonl"}
    first = sw.batch(folder, out, **make, variation=Variation(range(1), 2))
    assert [row.status for row in first] == ["complete"] * 4
    rows = sw.batch(
        folder, out, **make, variation=ALL, progress=lambda *heard: before.append(heard[3])
    )
    assert sum(before) == 4
    assert len(rows) == 8
    lines = lines_of(out)
    assert [line["scene"] for line in lines[:2]] == ["wc-0-0-1", "wc-0-0-2"]
    for line in lines:
        assert line["score"]["valid"]
        assert line["licences"]
        for file in line["files"]:
            assert tuple(measure_file(out / file["file"])) == (file["bytes"], file["blake2b"])
    for name in ("wc-0", "wc-1"):
        plan = {line["plan"] for line in lines if line["scene"].startswith(name)}
        assert plan == {plan_hash(read(folder / f"{name}.json"))}
        assert {line["split"] for line in lines if line["plan"] in plan} == {split_of(*plan)}
    sw.batch(folder, tmp_path / "again", **make, variation=ALL)
    assert [line["files"] for line in lines_of(tmp_path / "again")] == [x["files"] for x in lines]


def test_looks_leave_the_home_as_it_is_and_differ() -> None:
    brief = read("sample:home-room")
    looks = [vary_brief(brief, Look(3, n, ("style", "light", "doors"))) for n in range(1, 5)]
    solved = [domains.solve(one, steps=200, seed=3, threads=1) for one in looks]
    assert len({tuple((p.category, p.pose, p.size) for p in s.pieces) for s in solved}) == 1
    assert len({one.style for one in looks}) > 1
    assert len({one.hour for one in looks}) > 1
    assert {plan_hash(one) for one in looks} == {plan_hash(brief)}
    assert vary_brief(brief, Look(3, 0, ("style", "light", "doors"))) == brief


def test_what_the_author_says_of_looks_holds() -> None:
    brief = read("sample:home-room").model_copy(
        update={"style": "nordic", "hour": "noon", "residents": 1}
    )
    for number in range(1, 6):
        look = vary_brief(brief, Look(number, number, ("style", "light", "residents")))
        assert look.style.split()[0] == "nordic"
        assert (look.hour, look.residents) == ("noon", 1)


def test_residents_are_drawn_by_seed_and_not_by_look() -> None:
    brief = Brief.model_validate(
        {
            "rooms": [
                {"function": name, "outline": [[k, 0], [k + 4, 0], [k + 4, 4], [k, 4]]}
                for k, name in ((0, "double_bedroom"), (4, "single_bedroom"), (8, "living"))
            ]
        }
    )
    drawn = [[vary_brief(brief, Look(s, n, ("residents",))).residents for n in (0, 1, 2)]
             for s in range(30)]  # fmt: skip
    assert all(len(set(each)) == 1 for each in drawn)
    assert {each[0] for each in drawn} == {1, 2, 3}


def test_small_things_stay_on_what_they_stand_on() -> None:
    rng = np.random.default_rng(0)
    table = Piece("t", "side_table", "", "r", Pose(1.0, 2.0, 0.0, 0.7), Size(0.5, 0.4, 0.5))
    lamp = Piece("l", "table_lamp", "", "r", Pose(1.05, 2.0, 0.5, 0.7), Size(0.2, 0.2, 0.4), on="t")
    turn = np.array([[np.sin(0.7), -np.cos(0.7)], [np.cos(0.7), np.sin(0.7)]])
    seen = []
    for _ in range(200):
        moved = _moved(lamp, table, rng)
        x, y = turn @ (np.array(moved.pose[:2]) - table.pose[:2])
        lean = moved.pose.heading - 0.7
        half = 0.1 * (abs(np.cos(lean)) + abs(np.sin(lean)))
        assert abs(x) + half <= 0.25 + 1e-3
        assert abs(y) + half <= 0.20 + 1e-3
        assert moved.pose.z == lamp.pose.z
        seen.append(moved.pose.x)
    assert np.std(seen) > 0.02


def test_a_door_stands_as_far_open_as_its_brief_says() -> None:
    door = Opening("d", "door", "0", 0, 0, 1, 0, 0.9, 0.12, 0.0, 2.05, hinge=1, swing=1)

    def reach(ajar: float | None) -> float:
        leaf = next(p for p in parts(replace(door, ajar=ajar)) if p.material.name == "door oak")
        return float(np.ptp(leaf.vertices[:, 1]))

    assert reach(0.0) == pytest.approx(0.04)
    assert reach(np.pi / 2) == pytest.approx(0.834)
    assert reach(0.0) < reach(0.5) < reach(1.0) < reach(None)
    outline = [[0, 0], [3, 0], [3, 3], [0, 3]]
    room = {"outline": outline, "doors": [{"at": [1.5, 0], "ajar": 0.25}]}
    plan = domains.plan_of(Brief.model_validate({"rooms": [room]}))
    assert plan.spaces[0].openings[0].ajar == 0.25


@pytest.mark.parametrize("hour", [*HOURS, ""])
def test_the_sun_of_an_hour_shines_in_glb(hour: str) -> None:
    brief, plan = read_planned("sample:home-room")
    scene = domains.scene_of(domains.solution_of(brief, {}), plan)
    document, _ = glb.document_of(replace(scene, hour=hour), catalog_of([]))
    nodes = [node for node in document["nodes"] if node["name"] == "sun"]
    sun = sun_at(hour)
    assert len(nodes) == (sun is not None)
    if sun is not None:
        x, y, z, w = nodes[0]["rotation"]
        down = [-2 * (x * z + w * y), -2 * (y * z - w * x), -1 + 2 * (x * x + y * y)]
        east, north, up = sun.towards
        assert down == pytest.approx([-east, -up, north], abs=1e-6)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--seeds", "9:3"], "holds no seed"),
        (["--seeds", "0:2000000"], "ask for 1000000 at once"),
        (["--looks", "-1"], "give 0 to 1000"),
        (["--looks", "2", "--vary", "doors,weather"], "'weather' is nothing that varies"),
        (["--formats", "docx"], "cannot be written"),
        (["--jobs", "0"], "give at least 1"),
    ],
)
def test_what_a_set_cannot_be_is_told_in_one_line(
    words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = plans(tmp_path / "in", 1)
    assert run(["batch", str(folder), "-o", str(tmp_path / "out"), *words]) == 2
    fault = capsys.readouterr().err
    assert said in fault
    assert fault.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_one_command_makes_a_set(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, out = plans(tmp_path / "in", 1), tmp_path / "out"
    words = ["--seeds", "4:6", "--looks", "1", "--steps", "200", "--jobs", "1", "--json"]
    assert run(["batch", str(folder), "-o", str(out), *words]) == 0
    assert json.loads(capsys.readouterr().out)["totals"]["complete"] == 2
    assert [(line["seed"], line["look"]["number"]) for line in lines_of(out)] == [(4, 1), (5, 1)]
    saved = read(out / "wc-0-4-1.json")
    assert saved.rooms[0].doors[0].ajar is not None


def test_the_sun_of_an_hour_shines_in_usd() -> None:
    pxr = pytest.importorskip("pxr.Gf")
    from scenewright.formats.usd.stage import build_stage

    brief, plan = read_planned("sample:home-room")
    scene = domains.scene_of(domains.solution_of(brief, {}), plan)
    for hour in ("morning", "night"):
        stage = build_stage(replace(scene, hour=hour), catalog_of([]))
        suns = [prim for prim in stage.Traverse() if prim.GetName() == "Sun"]
        risen = sun_at(hour)
        assert len(suns) == (risen is not None)
        if risen is not None:
            turn = pxr.Rotation(suns[0].GetAttribute("xformOp:orient").Get())
            away = turn.TransformDir(pxr.Vec3d(0, 0, -1))
            assert [*away] == pytest.approx((-risen.towards).tolist(), abs=1e-6)


@pytest.mark.skipif(sys.platform != "linux", reason="bounds files as Linux does")
def test_a_disk_that_fills_is_one_line_and_what_is_done_stays(tmp_path: Path) -> None:
    import resource

    folder, out = plans(tmp_path / "in", 4), tmp_path / "out"
    make: dict[str, Any] = {"jobs": 1, "steps": 200, "manifest": "jsonl"}
    sw.batch(folder, out, **make, variation=Variation(range(1)))
    whole = {path.name: path.read_bytes() for path in out.glob("wc-*")}
    most = (out / ".batch.jsonl").stat().st_size + 300
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, before[1]))
    try:
        with pytest.raises(InputError, match="cannot be written into") as caught:
            sw.batch(folder, out, **make, variation=Variation(range(2)))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert "\n" not in str(caught.value)
    assert {name: (out / name).read_bytes() for name in whole} == whole
    again = list[bool]()
    heard = lambda *told: again.append(told[3])  # noqa: E731
    rows = sw.batch(folder, out, **make, variation=Variation(range(2)), progress=heard)
    assert [row.status for row in rows] == ["complete"] * 8
    assert sum(again) >= 4


def test_how_much_lies_about_is_drawn_by_look() -> None:
    brief = read("sample:home-room")
    looks = [Look(1, number, ("clutter",)) for number in range(12)]
    drawn = [draw_clutter(brief, look, "some") for look in looks]
    assert drawn[0] == draw_clutter(brief, None, "some") == "some"
    assert set(drawn) == {"none", "some", "lived-in"}


def test_the_sun_of_an_hour_shines_in_mjcf() -> None:
    from scenewright.formats.simulation.mjcf.model import build_model

    brief, plan = read_planned("sample:home-room")
    scene = domains.scene_of(domains.solution_of(brief, {}), plan)
    for hour in ("morning", "night"):
        root, risen = build_model(replace(scene, hour=hour), catalog_of([])), sun_at(hour)
        suns = [light for light in root.iter("light") if light.get("name") == "sun"]
        assert len(suns) == (risen is not None)
        if risen is not None:
            down = [float(part) for part in (suns[0].get("dir") or "").split()]
            assert down == pytest.approx((-risen.towards).tolist(), abs=1e-4)
