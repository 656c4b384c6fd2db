"""The verb ``studio``: a page on this machine to arrange a plan and change it by hand."""

from __future__ import annotations

import socket
import tempfile
import webbrowser
from contextlib import closing
from pathlib import Path
from typing import Annotated

import typer

from scenewright.cli import tables
from scenewright.core.errors import InputError
from scenewright.core.extras import require

PORT, LOCAL = 8420, "127.0.0.1"
BACKLOG = 128
"""Connections that wait until they are taken."""


def studio(
    source: Annotated[
        str, typer.Argument(metavar="[FILE]", help="A plan, a saved scene, or sample:NAME.")
    ] = "",
    project: Annotated[
        Path | None,
        typer.Option(
            metavar="NAME.studio", help="Keeps every version (left out: by the plan's name)."
        ),
    ] = None,
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="Left out, or taken: any that is free.")
    ] = PORT,
    host: Annotated[
        str,
        typer.Option(
            metavar="ADDRESS", help="Let others in: this machine's address in their network."
        ),
    ] = LOCAL,
    browser: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
) -> int:
    """Open a page on this machine: arrange a plan, change it by hand, undo, take it away.

    Every version is kept in a project file; given again, it opens where it was left.
    """
    for module in ("starlette", "uvicorn"):
        require(module)
    from scenewright.studio.running import serve
    from scenewright.workflow.project import SUFFIX, open_project, shown_version

    named = source.endswith(SUFFIX)
    path = Path(source) if named else project or Path(_stem(source) + SUFFIX)
    if named and not path.exists():
        raise InputError("there is no such project", "check the path", file=source)
    with closing(open_project(path)) as db, tempfile.TemporaryDirectory() as folder:
        fresh = shown_version(db) is None
        if source and not named and not fresh:
            fault = "is there already, with its versions"
            raise InputError(fault, f"open it: scenewright studio {path}", file=str(path))
        with closing(_listen(host, port)) as listening:
            address = f"http://{host}:{listening.getsockname()[1]}/"
            console = tables.output_console()

            def ready(token: str) -> None:
                link = f"{address}?token={token}"
                tables.print_line(console, f"project {path}")
                tables.print_line(console, f"studio  {link}")
                tables.print_line(console, "the link is good once; Ctrl-C ends the studio", "dim")
                if browser:
                    webbrowser.open(link)

            serve(db, "" if named else source, Path(folder), listening, host, ready)
    return 0


def _stem(source: str) -> str:
    """The name of the project of a plan: in this folder."""
    return Path(source.replace(":", "-")).name.split(".")[0] or "untitled"


def _listen(host: str, port: int) -> socket.socket:
    """A socket at an address of this machine, at a port or, where that is taken, at any; a browser
    that comes before the server waits there."""
    listening = socket.socket()
    for tried in (port, 0):
        try:
            listening.bind((host, tried))
            listening.listen(BACKLOG)
        except OSError:
            continue
        return listening
    listening.close()
    remedy = "close another program's server" if host == LOCAL else "give its address in a network"
    raise InputError(f"nothing can be served at {host}", remedy)
