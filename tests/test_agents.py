"""Agents: the studio's verbs as tools, by the protocol's own client over standard input and
output."""

from __future__ import annotations

import asyncio
import base64
import sys
from contextlib import closing, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from hostile_verbs import list_hostile
from scenewright.core.errors import CancelledError, InputError
from scenewright.studio.agents import call, list_all
from scenewright.studio.people import OWN, RIGHTS
from scenewright.studio.session import Session
from scenewright.studio.spoken import tell_pieces
from scenewright.studio.verbs import VERBS
from scenewright.workflow.project import open_project
from thoroughness import spread

pytestmark = pytest.mark.skipif(find_spec("mcp") is None, reason="needs mcp")


async def _work(folder: Path) -> dict[str, Any]:
    from mcp import Client, StdioServerParameters  # takes long: only where it is run

    command = ["-c", "from scenewright.cli import main; main(['mcp', '--project', 'a.studio'])"]
    server = StdioServerParameters(command=sys.executable, args=command, cwd=folder)
    told: dict[str, Any] = {}
    async with Client(server) as client:
        told["tools"] = {one.name: one for one in (await client.list_tools()).tools}

        async def use(name: str, /, **keys: Any) -> Any:
            answer = await client.call_tool(name, keys)
            (part,) = answer.content
            told[name] = answer.is_error, getattr(part, "text", None) or part.data
            return told[name][1]

        await use("open", source="/etc/passwd")
        outside = told["open"]
        await use("fly")
        await use("open", source="sample:home-room")
        await use("arrange", seed=2)
        await use("look")
        listed = await use("pieces", space="room")
        first = next(line for line in listed.splitlines() if " · desk · " in line)
        await use("judge", piece=first.split(" · ")[0], pose=[0.2, 0.2, 0.0])
        await use("move", piece="unicorn", pose=[1, 1, 0])
        unknown = told["move"]
        await use("find", words="armchair")
        await use("picture", of="plan")
        await use("export", name="room.json")
        await use("undo")
        await use("export", name="../b.json")
        await use("history")
        told |= {"outside": outside, "unknown": unknown}
    return told


def test_an_agent_arranges_looks_and_is_told_what_is_wrong(tmp_path: Path) -> None:
    told = asyncio.run(_work(tmp_path))
    assert {name for name, row in VERBS.items() if row.right != OWN} <= {*told["tools"]}
    assert told["tools"]["move"].input_schema["properties"]["poses"]["type"] == "object"
    for name in ("outside", "unknown", "fly"):
        error, text = told[name]
        assert error, name
        assert "\n" not in text
    assert "passes" in told["arrange"][1] or "valid" in told["arrange"][1]
    assert "space room (" in told["look"][1]
    assert (
        "wall" in told["judge"][1] or "outside" in told["judge"][1] or "leaves" in told["judge"][1]
    )
    assert "armchair" in told["find"][1]
    assert base64.b64decode(told["picture"][1])[:4] == b"\x89PNG"
    assert (tmp_path / "room.json").stat().st_size > 1000
    assert told["export"][0]
    assert "2: arranged, seed 2" in told["history"][1]
    assert sorted(one.name for one in tmp_path.iterdir() if "studio" not in one.name) == [
        "room.json"
    ]


def test_whatever_a_tool_is_asked_with_is_an_answer_or_a_line(tmp_path: Path) -> None:
    with closing(open_project(tmp_path / "a.studio")) as db:
        session = Session(db, lambda _event: None)
        session.open("sample:home-room")
        rows = [
            (name, asked)
            for name, _, schema in list_all()
            if name not in VERBS or not VERBS[name].goes_on
            for _, asked in list_hostile(name, schema["properties"])
        ]
        for name, asked in spread(rows, 40):
            given = {key: value for key, value in asked.items() if key != "verb"}
            with suppress(CancelledError):
                try:
                    answer = call(session, tmp_path, name, given)
                except InputError as error:
                    assert len(str(error).splitlines()) == 1, asked  # noqa: PT017
                else:
                    assert len(answer) < 20_000 or isinstance(answer, bytes), asked
        session.close()
    assert {one.name.partition(".")[0] for one in tmp_path.iterdir()} == {"a"}


def test_many_pieces_are_told_a_hundred_at_a_time() -> None:
    pose, size = [1, 2, 0, 0], [1, 1, 1]
    pieces = [
        {"id": f"p{k}", "name": "tree", "space": "s", "pose": pose, "size": size, "locked": False}
        for k in range(250)
    ]
    told, first = list[str](), 0
    while first < 250:
        *lines, last = tell_pieces({"pieces": pieces}, "s", first).splitlines()
        told += lines if last.startswith("and ") else [*lines, last]
        assert len(lines) <= 100
        first += 100
    assert [line.split(" · ")[0] for line in told] == [f"p{k}" for k in range(250)]


def test_every_tool_says_what_it_does_and_takes_only_what_it_knows() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    for name, about, schema in list_all():
        assert about, name
        jsonschema.Draft202012Validator.check_schema(schema)
    for row in VERBS.values():
        assert {*row.needed} <= {*row.keys}
        assert row.right in RIGHTS
