"""The verb ``mcp``: the studio's verbs as tools for agents."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import Annotated

import typer

from scenewright.core.errors import InputError
from scenewright.core.extras import require


def mcp(
    source: Annotated[
        str, typer.Argument(metavar="[FILE]", help="A plan, a saved scene, or sample:NAME.")
    ] = "",
    project: Annotated[
        Path | None,
        typer.Option(metavar="NAME.studio", help="Keeps every version (left out: in memory)."),
    ] = None,
) -> int:
    """Serve the studio's verbs to agents, as tools of the Model Context Protocol, over standard
    input and output: arrange, move, undo, breed, look, picture, export.

    Files are read from and written into the folder it is started in, and nowhere else.
    """
    require("mcp")
    from scenewright.studio.agents import serve_agents
    from scenewright.studio.session import Session
    from scenewright.workflow.project import open_project, shown_version

    with closing(open_project(project or Path(":memory:"))) as db:
        if source and shown_version(db) is not None:
            fault = "is there already, with its versions"
            raise InputError(fault, "leave the plan out", file=str(project))
        session = Session(db, lambda _event: None)
        if source:
            session.open(source)
        try:
            serve_agents(session, Path.cwd())
        finally:
            session.close()
    return 0
