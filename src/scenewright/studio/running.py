"""The server, from the first request until Ctrl-C."""

from __future__ import annotations

import socket
import sqlite3
from collections.abc import Callable
from pathlib import Path
from typing import Any

import uvicorn

from scenewright.studio.guard import LOCAL, App, Keys, guarded
from scenewright.studio.limits import bounded_connections
from scenewright.studio.server import Listeners, studio_app
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json

PATIENCE = 1
"""Seconds that pages which still listen are given at the end."""


def serve(
    db: sqlite3.Connection,
    source: str,
    folder: Path,
    listening: socket.socket,
    host: str,
    ready: Callable[[str], None],
) -> None:
    """Serve the studio of a project on a socket, under the name ``host``; a ``source`` is opened
    first. ``ready`` is given the token of the link, once the plan is read."""
    listeners = Listeners()
    session = Session(db, listeners.tell)
    if source:
        session.open(source)

    def tell(event: Json) -> None:
        listeners.tell(event)
        if "changed" in event:
            session.readiness.begin(session.kind())

    session.tell = tell
    session.readiness.begin(session.kind())
    keys = Keys(listening.getsockname()[1], session.people.find, (host, *LOCAL))
    app = guarded(studio_app(session, listeners, folder), keys)
    ready(keys.token or "")
    make_server(app).run(sockets=[listening])
    session.close()


def make_server(app: App) -> uvicorn.Server:
    """The server of an application, within :mod:`.limits`."""
    protocol: Any = bounded_connections()
    config = uvicorn.Config(
        app,
        http=protocol,
        ws="none",
        log_level="critical",
        timeout_graceful_shutdown=PATIENCE,
        lifespan="off",
    )
    return uvicorn.Server(config)
