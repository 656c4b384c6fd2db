"""The studio for agents: its verbs, and some to look with, as tools of the Model Context Protocol.

A tool has the sentence and the schema of its verb, and answers in a few lines of words; a verb that
goes on after it has answered is waited for here. Pictures come when they are asked for.
"""

from __future__ import annotations

import asyncio
import base64
import json
from collections.abc import Callable, Mapping
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from PIL import Image

from scenewright._version import __version__
from scenewright.catalog.loading import catalog_of
from scenewright.core.errors import CancelledError, InputError
from scenewright.domains import scene_of
from scenewright.formats import samples
from scenewright.render.picture import Pixels
from scenewright.render.plan_picture import draw_scene_plan
from scenewright.studio.asked import read_text, read_whole
from scenewright.studio.people import EDIT, OWN
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.shelf import find_models
from scenewright.studio.spoken import (
    shorten,
    tell_changes,
    tell_pieces,
    tell_scene,
    tell_sheet,
    tell_verdict,
)
from scenewright.studio.verbs import VERBS, Verb, do_verb

SIDE = 800
"""Pixels across a picture."""
ABOUT = (
    "Arranges furniture, exhibits and buildings. Begin with open, then arrange; look says what is "
    "there and what is wrong, picture shows it. Metres, radians. Every verb is a version: undo."
)
Answer = str | bytes


class Tool(NamedTuple):
    """What a tool does, in a sentence; its keys by JSON Schema; and what answers."""

    about: str
    keys: Mapping[str, Json]
    answer: Callable[[Session, Path, Json], Answer]


def _open(session: Session, folder: Path, asked: Json) -> Answer:
    source = str(asked.get("source", ""))
    session.open(source, folder)
    return tell_scene(session.state())


def _picture(session: Session, _folder: Path, asked: Json) -> Answer:
    """A layout of the sheets as a plan, or the scene, in plan or from above at an angle."""
    number = asked.get("layout")
    if isinstance(number, int):
        solution, plan = session.breeding.choose(number)
    elif asked.get("of") == "view":
        return session.file("png")
    else:
        _, solution, plan, _ = session.versions.must_show()
    catalog = catalog_of(solution.brief.catalogs)
    return _png(draw_scene_plan(scene_of(solution, plan), catalog, SIDE))


def _png(pixels: Pixels) -> bytes:
    kept = BytesIO()
    Image.fromarray(np.asarray(pixels)).quantize(64).save(kept, "PNG", optimize=True)
    return kept.getvalue()


def _export(session: Session, folder: Path, asked: Json) -> Answer:
    name = Path(str(asked.get("name", "")))
    if name.name != str(name) or not name.stem or name.stem.startswith("."):
        raise InputError(f"{str(name)!r} is no name of a file", "give a plain one: flat.glb")
    path = folder / name
    if path.exists():
        raise InputError(f"{name} is there already", "choose another name")
    ending = name.suffix.removeprefix(".")
    path.write_bytes(session.export() if ending == "zip" else session.file(ending))
    return f"wrote {name}, {path.stat().st_size} bytes"


def _find(session: Session, _folder: Path, asked: Json) -> Answer:
    rows = find_models(session.shelf(), str(asked.get("words", "")))
    told = [
        f"{row['asset']} · {row['kind']} · {row['size'][0]:.2f} x {row['size'][1]:.2f} m"
        for row in rows
    ]
    return "\n".join(shorten(told)) or "no such model"


TEXT: Json = {"type": "string"}
LOOKING: Mapping[str, Tool] = {
    "open": Tool(
        "begin with a sample or a file of the folder the server was started in",
        {"source": {"type": "string", "description": "sample:NAME, or the name of a file"}},
        _open,
    ),
    "samples": Tool("the samples there are", {}, lambda *_: "\n".join(samples())),
    "look": Tool(
        "the scene in words: spaces, verdict, findings, what was left out",
        {},
        lambda session, *_: tell_scene(session.state()),
    ),
    "pieces": Tool(
        "ids, places and sizes of the pieces, of one space or all",
        {"space": TEXT, "first": {"type": "integer", "minimum": 0}},
        lambda session, _, asked: tell_pieces(
            session.state(), read_text(asked, "space"), read_whole(asked, "first")
        ),
    ),
    "find": Tool("models that can be put in, by words", {"words": TEXT}, _find),
    "sheet": Tool(
        "the layouts bred last, by their places",
        {},
        lambda session, *_: tell_sheet(session.breeding.state()),
    ),
    "picture": Tool(
        "a picture of the scene, or of a layout that was bred",
        {
            "of": {"type": "string", "enum": ["plan", "view"]},
            "layout": {"type": "integer", "description": "number of a layout of the sheets"},
        },
        _picture,
    ),
    "history": Tool(
        "what was done, by version",
        {},
        lambda session, *_: "\n".join(
            f"{one['id']}: {one['what']}" for one in session.state()["history"][-40:]
        ),
    ),
    "export": Tool(
        "write the scene into the folder: NAME.glb, .json, .svg, .png, .dxf, … or .zip of several",
        {"name": TEXT},
        _export,
    ),
}
"""Tools beside the verbs; ``open`` also takes files."""


def call(session: Session, folder: Path, name: str, asked: Json) -> Answer:
    """What a tool answers; InputError in one line for what cannot be done."""
    if name in LOOKING:
        return LOOKING[name].answer(session, folder, asked)
    said = do_verb(session, json.dumps(asked | {"verb": name}).encode())
    row = VERBS[name]
    if row.goes_on:
        session.wait()
    return _tell(session, name, row, said)


def _tell(session: Session, name: str, row: Verb, said: Json) -> str:
    lines = [one["message"] for one in said.get("findings", ())]
    lines += tell_changes(said.get("changes", ())) + said.get("differences", [])
    lines += [f"not held: {what}" for what in said.get("lost", ())]
    if name in ("breed", "next", "say"):
        return tell_sheet(session.breeding.state())
    if row.right == EDIT and name != "judge":
        state = session.state()
        lines += [f"version {state['version']}", *tell_verdict(state)]
    return "\n".join(lines) or "nothing is wrong there" if name == "judge" else "\n".join(lines)


def serve_agents(session: Session, folder: Path) -> None:
    """Serve a session over standard input and output until it is closed."""
    asyncio.run(_serve(session, folder))


async def _serve(session: Session, folder: Path) -> None:
    from mcp.server.stdio import stdio_server

    server = make_server(session, folder)
    async with stdio_server() as (read, write):
        await server.run(read, write, server.create_initialization_options())


def make_server(session: Session, folder: Path) -> Any:
    """The server of the protocol: its list of tools, and what calls them one at a time."""
    from mcp import types
    from mcp.server.lowlevel import Server

    turn = asyncio.Lock()

    async def list_tools(*_: Any) -> Any:
        return types.ListToolsResult(
            tools=[types.Tool(name=n, description=a, input_schema=s) for n, a, s in list_all()]
        )

    async def call_tool(_context: Any, params: Any) -> Any:
        asked = params.arguments or {}
        try:
            async with turn:
                answer = await _in_thread(session, folder, params.name, asked)
        except (InputError, CancelledError, ModuleNotFoundError) as error:
            fault = types.TextContent(text=str(error))
            return types.CallToolResult(content=[fault], is_error=True)
        if isinstance(answer, bytes):
            data = base64.b64encode(answer).decode()
            return types.CallToolResult(
                content=[types.ImageContent(data=data, mime_type="image/png")]
            )
        return types.CallToolResult(content=[types.TextContent(text=answer)])

    return Server(
        "scenewright",
        version=__version__,
        instructions=ABOUT,
        on_list_tools=list_tools,
        on_call_tool=call_tool,
    )


async def _in_thread(session: Session, folder: Path, name: str, asked: Json) -> Answer:
    """Call a tool; a call that is given up stops what it began."""
    try:
        return await asyncio.to_thread(call, session, folder, name, asked)
    except asyncio.CancelledError:
        session.stop()
        raise


def list_all() -> list[tuple[str, str, Json]]:
    """Name, sentence and schema of every tool.

    >>> sorted(name for name, _, _ in list_all())[:3]
    ['accept', 'add', 'again']
    """
    mine = ((name, row) for name, row in VERBS.items() if name not in LOOKING and row.right != OWN)
    verbs = [(name, row.about, row.schema()) for name, row in mine]
    looking = [
        (name, row.about, {"type": "object", "properties": dict(row.keys)})
        for name, row in LOOKING.items()
    ]
    return looking + verbs
