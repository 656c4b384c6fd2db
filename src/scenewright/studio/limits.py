"""How much the studio takes from anyone: bytes, seconds, connections, rows. All of it is here."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

MEBIBYTE = 1 << 20
LONGEST = {"/bring": 64 * MEBIBYTE}
LONGEST_VERB = MEBIBYTE
"""Bytes that a request may bring, by address and elsewhere."""
MOST_FILES = 4
"""Files brought at a time; more wait."""
BODY_SECONDS = 60.0
"""Seconds that a request's body may take to arrive."""
SILENT_SECONDS = 10.0
"""Seconds after which a connection that has asked for nothing is closed."""
MOST_CONNECTIONS = 600
"""Connections at a time; of more, those that have asked for nothing go, the oldest first."""


def longest(path: str) -> int:
    """Bytes that a request to an address may bring.

    >>> longest("/do") < longest("/bring")
    True
    """
    return LONGEST.get(path, LONGEST_VERB)


def bounded_connections() -> Callable[..., H11Protocol]:
    """What makes the protocol of every new connection, and closes those that only take up room."""
    silent: OrderedDict[H11Protocol, None] = OrderedDict()

    def close(one: H11Protocol) -> None:
        silent.pop(one, None)
        if one.scope is None and one.transport is not None:
            one.transport.abort()

    def make(**given: Any) -> H11Protocol:
        made = H11Protocol(**given)
        silent[made] = None
        made.loop.call_later(SILENT_SECONDS, close, made)
        if len(made.connections) >= MOST_CONNECTIONS:
            close(next(iter(silent)))
        return made

    return make
