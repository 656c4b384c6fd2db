"""Shapes by key: what a piece looks like in plan, and meshes. Of equal content they have one key,
so that whoever has a shape never asks for it again, whichever scene it is of."""

from __future__ import annotations

import json
from base64 import urlsafe_b64encode
from collections import OrderedDict
from collections.abc import Iterable
from hashlib import blake2b
from threading import Lock
from typing import Any

Json = dict[str, Any]
DIGEST = 6
"""Bytes of a key: among 10,000 shapes two of one key are met once in five million projects."""
MOST_SYMBOLS, MOST_BYTES = 5000, 32 << 20
"""Symbols, and bytes of meshes, that are kept; those told longest ago go first."""


def key_of(content: bytes) -> str:
    """The key of a shape.

    >>> key_of(b"a chair"), key_of(b"a desk")
    ('bW_PgUVg', 'H1XMzay8')
    """
    return urlsafe_b64encode(blake2b(content, digest_size=DIGEST).digest()).decode()


class Shapes:
    """The shapes of one project; any thread may ask."""

    def __init__(self) -> None:
        self._lock, self._bytes = Lock(), 0
        self._symbols: OrderedDict[str, Json] = OrderedDict()
        self._meshes: OrderedDict[str, bytes] = OrderedDict()

    def add_symbol(self, symbol: Json) -> str:
        """Keep a symbol; its key."""
        key = key_of(json.dumps(symbol).encode())
        with self._lock:
            self._symbols[key] = symbol
            self._symbols.move_to_end(key)
            while len(self._symbols) > MOST_SYMBOLS:
                self._symbols.popitem(last=False)
        return key

    def symbols(self, keys: Iterable[str]) -> dict[str, Json]:
        """Those of some symbols that are kept."""
        with self._lock:
            return {key: self._symbols[key] for key in keys if key in self._symbols}

    def add_mesh(self, content: bytes) -> str:
        """Keep a mesh; its key."""
        key = key_of(content)
        with self._lock:
            self._bytes += len(content) - len(self._meshes.pop(key, b""))
            self._meshes[key] = content
            while self._bytes > MOST_BYTES and len(self._meshes) > 1:
                self._bytes -= len(self._meshes.popitem(last=False)[1])
        return key

    def mesh(self, key: str) -> bytes:
        """A mesh that is kept; empty for others."""
        with self._lock:
            return self._meshes.get(key, b"")
