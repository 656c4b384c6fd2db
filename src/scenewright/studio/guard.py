"""Who is let in: this machine's browser, once it came by the link that was printed.

The link's token is good once and becomes a cookie that scripts cannot read and other sites do not
send. Requests under another host name (DNS rebinding), from another origin (forgery), without the
cookie, or too long are refused before anything reads them.
"""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Awaitable, Callable, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

COOKIE = "scenewright-studio"
LONGEST = 64 << 20
"""Bytes that a request may bring."""
HEADERS = (
    (
        b"content-security-policy",
        b"default-src 'self'; img-src 'self' blob: data:; connect-src 'self' blob:; "
        b"frame-ancestors 'none'; base-uri 'none'",
    ),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"no-referrer"),
    (b"cache-control", b"no-store"),
)


class Keys:
    """The token of the link, until it is used, and the value of the cookie."""

    def __init__(self) -> None:
        self.token: str | None = secrets.token_urlsafe(24)
        self.cookie = secrets.token_urlsafe(24)

    def spend(self, token: str) -> bool:
        """Whether a token is the link's; it is good once."""
        right = self.token is not None and hmac.compare_digest(token, self.token)
        if right:
            self.token = None
        return right


def guarded(app: App, keys: Keys, port: int) -> App:
    """An ASGI application that lets through only what :mod:`scenewright.studio.guard` says."""
    hosts = {f"{name}:{port}" for name in ("127.0.0.1", "localhost")}

    async def answer(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await app(scope, receive, send)
            return
        headers = {k.decode("latin-1"): v.decode("latin-1") for k, v in scope["headers"]}
        fault = refuse(scope["method"], headers, hosts)
        if fault:
            await _reply(send, *fault)
        elif is_let_in(headers.get("cookie", ""), keys):
            await app(scope, _limited(receive), _with_headers(send))
        elif keys.spend(parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]):
            cookie = f"{COOKIE}={keys.cookie}; Path=/; HttpOnly; SameSite=Strict"
            more = [(b"set-cookie", cookie.encode()), (b"location", b"/")]
            await _reply(send, 303, "", more)
        else:
            await _reply(send, 403, "use the link that the studio printed; it is good once")

    return answer


def refuse(method: str, headers: dict[str, str], hosts: set[str]) -> tuple[int, str] | None:
    """Status and words for a request that is refused whoever it comes from.

    >>> refuse("GET", {"host": "127.0.0.1:80"}, {"127.0.0.1:80"})
    >>> refuse("GET", {"host": "evil.example"}, {"127.0.0.1:80"})
    (421, 'this host name is not served')
    """
    if headers.get("host", "") not in hosts:
        return 421, "this host name is not served"
    origin = headers.get("origin", "")
    if origin and origin.removeprefix("http://") not in hosts:
        return 403, "requests from other sites are refused"
    if method not in ("GET", "HEAD") and not origin:
        return 403, "requests that change something must name their origin"
    length = headers.get("content-length", "0")
    if not length.isdecimal() or int(length) > LONGEST:
        return 413, f"at most {LONGEST >> 20} MB"
    return None


def is_let_in(header: str, keys: Keys) -> bool:
    """Whether a header of cookies holds ours."""
    try:
        found = SimpleCookie(header).get(COOKIE)
    except CookieError:
        return False
    return found is not None and hmac.compare_digest(found.value, keys.cookie)


def _limited(receive: Receive) -> Receive:
    """The request's body, cut off where it grows longer than it may be."""
    seen = 0

    async def next_part() -> MutableMapping[str, Any]:
        nonlocal seen
        message = await receive()
        seen += len(message.get("body", b""))
        return {"type": "http.disconnect"} if seen > LONGEST else message

    return next_part


def _with_headers(send: Send) -> Send:
    async def forward(message: MutableMapping[str, Any]) -> None:
        if message["type"] == "http.response.start":
            message = {**message, "headers": [*message.get("headers", ()), *HEADERS]}
        await send(message)

    return forward


async def _reply(
    send: Send, status: int, text: str, more: list[tuple[bytes, bytes]] | None = None
) -> None:
    headers = [(b"content-type", b"text/plain; charset=utf-8"), *HEADERS, *(more or [])]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": text.encode()})
