"""Answers as they go out: packed where that pays, kept by the browser where they never change."""

from __future__ import annotations

import gzip
from functools import lru_cache

from starlette.requests import Request
from starlette.responses import Response

LEVEL = 6
LEAST = 500
"""Bytes below which nothing is packed."""
PACKED = ("text/", "application/json", "application/octet-stream", "model/")
"""Kinds of content that become smaller by it."""
FOREVER = "private, max-age=31536000, immutable"
"""Of what is named by its content."""


def reply(request: Request, content: bytes, kind: str, forever: bool = False) -> Response:
    """An answer, ``forever`` the same at its address or not to be kept; what never changes, and
    scripts, are packed once."""
    headers = {"cache-control": FOREVER if forever else "no-store"}
    if len(content) >= LEAST and kind.startswith(PACKED):
        headers["vary"] = "accept-encoding"
        if "gzip" in request.headers.get("accept-encoding", ""):
            headers["content-encoding"] = "gzip"
            once = forever or kind.startswith("text/")
            content = pack_once(content) if once else gzip.compress(content, LEVEL, mtime=0)
    return Response(content, media_type=kind, headers=headers)


@lru_cache(maxsize=256)
def pack_once(content: bytes) -> bytes:
    """Packed content that is asked for again and again.

    >>> gzip.decompress(pack_once(b"a page"))
    b'a page'
    """
    return gzip.compress(content, LEVEL, mtime=0)
