"""A run from file to files: the plan is made once, events come in order, no terminal is needed."""

from __future__ import annotations

import ast
import json
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from threading import Event as Flag
from types import ModuleType

import pytest

import scenewright as sw
from scenewright import cli
from scenewright.building import plan as room_plan
from scenewright.core.errors import CancelledError, InputError
from scenewright.domains.site import plan as ground_plan
from scenewright.formats import solution_json
from scenewright.workflow.alternatives import arrange_alternatives
from scenewright.workflow.arrange import arrange_file
from scenewright.workflow.events import (
    Changed,
    Event,
    Judged,
    Notice,
    Planned,
    Progress,
    Solved,
    Wrote,
    run_to_end,
)
from scenewright.workflow.request import ArrangeRequest
from scenewright.workflow.stream import stream_progress

PACKAGE = Path(sw.__file__).parent / "workflow"
ROOM = "sample:home-room"


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def count_calls(monkeypatch: pytest.MonkeyPatch, module: ModuleType, name: str) -> list[str]:
    """A list that grows by one with every call of a function its module calls by name."""
    calls: list[str] = []
    called = getattr(module, name)

    def counted(*given: object) -> object:
        calls.append(name)
        return called(*given)

    monkeypatch.setattr(module, name, counted)
    return calls


def plan_calls(monkeypatch: pytest.MonkeyPatch, source: str) -> list[str]:
    """Calls of what only ``spaces`` or ``site_plans`` calls, once each."""
    if source.startswith("sample:site"):
        return count_calls(monkeypatch, ground_plan, "site_plans")
    return count_calls(monkeypatch, room_plan, "find_openings")


@pytest.mark.parametrize("source", [ROOM, "sample:hall-irregular", "sample:site-30"])
def test_one_arrange_with_three_outputs_and_a_check_plans_once(
    source: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = plan_calls(monkeypatch, source)
    outputs = [word for name in ("a.json", "a.svg", "a.glb") for word in ("-o", name)]
    assert cli.run(["arrange", source, "--steps", "100", *outputs]) in (0, 1)
    assert len(calls) == 1


def test_every_format_of_a_site_takes_the_one_plan(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = plan_calls(monkeypatch, "sample:site-30")
    outputs = [word for name in ("a.city.json", "a.svg", "a.street.png") for word in ("-o", name)]
    assert cli.run(["arrange", "sample:site-30", "--steps", "100", *outputs]) in (0, 1)
    assert len(calls) == 1


@pytest.mark.parametrize("source", [ROOM, "sample:hall-shop"])
def test_alternatives_plan_once(source: str, monkeypatch: pytest.MonkeyPatch) -> None:
    calls = plan_calls(monkeypatch, source)
    given = ["--steps", "60", "--alternatives", "2", "-o", "a.svg"]
    assert cli.run(["arrange", source, *given]) in (0, 1)
    assert len(calls) == 1


def test_adjusting_plans_once(monkeypatch: pytest.MonkeyPatch) -> None:
    sw.arrange(ROOM, ["a.json"], steps=100)
    piece = solution_json.read("a.json").pieces[0].id
    calls = plan_calls(monkeypatch, ROOM)
    assert cli.run(["adjust", "a.json", "--lock", piece, "-o", "b.json", "-o", "b.svg"]) in (0, 1)
    assert len(calls) == 1


@pytest.mark.parametrize("verb", ["check", "explain"])
def test_judging_and_explaining_plan_once(verb: str, monkeypatch: pytest.MonkeyPatch) -> None:
    sw.arrange(ROOM, ["a.json"], steps=100)
    calls = plan_calls(monkeypatch, ROOM)
    assert cli.run([verb, "a.json"]) in (0, 1)
    assert len(calls) == 1


def kinds(events: Iterator[Event]) -> list[type]:
    return [kind for kind, _ in groupby(type(event) for event in events)]


def test_events_come_in_order() -> None:
    request = ArrangeRequest(ROOM, (Path("a.json"), Path("a.svg")), steps=100)
    events = list(arrange_file(request))
    changes = [event for event in events if isinstance(event, Changed)]
    assert all(change.stage and change.reason for change in changes)
    assert {change.stage for change in changes} >= {"fit"}
    events = [event for event in events if not isinstance(event, Changed)]
    assert kinds(iter(events)) == [Planned, Progress, Solved, Judged, Progress, Wrote, Notice]
    assert [str(e) for e in events if isinstance(e, Notice) and "a.svg: left out:" in str(e)]
    assert [event.path.name for event in events if isinstance(event, Wrote)] == ["a.json", "a.svg"]
    shares = [event.share for event in events if isinstance(event, Progress)]
    assert all(0.0 <= share <= 1.0 for share in shares)


def test_every_alternative_is_told_and_written() -> None:
    heard: list[Event] = []
    request = ArrangeRequest(ROOM, (Path("a.svg"),), steps=60, alternatives=2)
    found = run_to_end(arrange_alternatives(request), heard.append)
    assert [one.rank for one in found] == list(range(1, len(found) + 1))
    assert sum(isinstance(event, Solved) for event in heard) == len(found)
    assert sorted(path.name for path in Path().iterdir()) == [f"a-{one.rank}.svg" for one in found]


def test_the_facade_arranges_as_the_command_line_does() -> None:
    shares: list[float] = []
    arranged = sw.arrange(
        ROOM, ["a.json"], steps=100, seed=3, progress=lambda share, _: shares.append(share)
    )
    assert cli.run(["arrange", ROOM, "--steps", "100", "--seed", "3", "-o", "b.json", "-q"]) in (
        0,
        1,
    )
    assert Path("a.json").read_bytes() == Path("b.json").read_bytes()
    assert arranged.report.valid
    assert shares[-1] == 1.0


def test_the_source_is_not_replaced_by_an_output() -> None:
    sw.arrange(ROOM, ["a.json"], steps=50)
    with pytest.raises(InputError, match="is read by this run"):
        sw.arrange("a.json", ["a.json"], steps=50)


def test_cancelled_before_anything_is_found_nothing_is_written() -> None:
    with pytest.raises(CancelledError):
        sw.arrange(ROOM, ["a.json"], steps=50, cancel=lambda: True)
    assert not list(Path().iterdir())


def test_a_listener_that_leaves_stops_the_work() -> None:
    stopped = Flag()

    def work(tell, cancelled):  # type: ignore[no-untyped-def]
        tell(0.1, "begun")
        while not cancelled():
            stopped.wait(0.01)
        stopped.set()

    events = stream_progress(work)
    assert next(events) == Progress(0.1, "begun")
    events.close()
    assert stopped.wait(5.0)


def test_closed_while_writing_leaves_no_file() -> None:
    events = arrange_file(ArrangeRequest(ROOM, (Path("a.json"), Path("a.svg")), steps=50))
    next(e for e in events if isinstance(e, Progress) and e.what.startswith("writing"))
    events.close()
    assert not list(Path().iterdir())


def test_accessible_works_in_a_batch() -> None:
    given = ["--accessible", "--steps", "100"]
    assert cli.run(["arrange", ROOM, "--batch", "-o", "out", "-q", *given]) in (0, 1)
    assert cli.run(["arrange", ROOM, "-o", "one.json", "-q", *given]) in (0, 1)
    alone, batch = (json.loads(Path(p).read_text()) for p in ("one.json", "out/home-room.json"))
    assert alone["brief"]["accessible"] is True
    assert batch == alone


def test_a_domain_without_accessible_says_so_in_its_row() -> None:
    words = ["arrange", "sample:hall-irregular", ROOM, "--batch", "-o", "out", "--accessible"]
    assert cli.run([*words, "--steps", "50", "-q"]) == 1
    rows = json.loads(Path("out/summary.json").read_text())["files"]
    assert [row["status"] == "failed" for row in rows] == [True, False]
    assert "sample:hall-irregular" in rows[0]["message"]


def test_no_terminal_is_known() -> None:
    for file in PACKAGE.glob("*.py"):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        named = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        heads = {
            name.split(".")[0]
            for node in ast.walk(tree)
            if isinstance(node, ast.Import | ast.ImportFrom)
            for name in [getattr(node, "module", None) or "", *(a.name for a in node.names)]
        }
        assert not heads & {"rich", "typer"}
        assert "print" not in named
