"""Who is let in: this machine's browser, once it came by the link that was printed.

The link's token is good once and becomes a cookie that scripts cannot read and other sites do not
send. Requests under another host name (DNS rebinding), from another origin (forgery), without the
cookie, or too long are refused before anything reads them.
"""

from __future__ import annotations

import asyncio
import hmac
import secrets
from collections.abc import Awaitable, Callable, Collection, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs

from starlette.exceptions import HTTPException

from scenewright.studio.limits import BODY_SECONDS, longest
from scenewright.studio.people import OWNER, Person

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

LOCAL = ("127.0.0.1", "localhost")
"""Names of this machine for itself."""
COOKIE = "scenewright-studio"
STAY = 90 * 86400
"""Seconds that a guest is remembered."""
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
    """The token of the owner's link, until it is used, and the value of her cookie; ``find`` knows
    whose the token of another link is, which is the cookie of that person as well."""

    def __init__(
        self,
        port: int,
        find: Callable[[str], Person | None] = lambda _token: None,
        names: Collection[str] = LOCAL,
    ) -> None:
        self.hosts = {f"{name}:{port}" for name in names}
        self.find, self.name = find, f"{COOKIE}-{port}"
        self.token: str | None = secrets.token_urlsafe(24)
        self.cookie = secrets.token_urlsafe(24)

    def spend(self, token: str) -> bool:
        """Whether a token is the link's; it is good once."""
        right = self.token is not None and hmac.compare_digest(token, self.token)
        if right:
            self.token = None
        return right


def guarded(app: App, keys: Keys) -> App:
    """An ASGI application that lets through only what :mod:`scenewright.studio.guard` says."""

    async def answer(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await app(scope, receive, send)
            return
        headers = {k.decode("latin-1"): v.decode("latin-1") for k, v in scope["headers"]}
        most = longest(scope["path"])
        fault = refuse(scope["method"], headers, keys.hosts, most)
        if fault:
            await _reply(send, *fault)
        elif cookie := _enter(scope, headers.get("cookie", ""), keys):
            more = [(b"set-cookie", cookie.encode()), (b"location", b"/")]
            await _reply(send, 303, "", more)
        elif person := who_is(headers.get("cookie", ""), keys):
            scope["person"] = person
            await app(scope, _bounded(scope, receive, most), _with_headers(send))
        else:
            await _reply(send, 403, "use the link that the studio printed; it is good once")

    return answer


def refuse(
    method: str, headers: dict[str, str], hosts: set[str], most: int = 0
) -> tuple[int, str] | None:
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
    if not (length.isdecimal() and len(length) < 20 and int(length) <= most):
        return 413, too_long(most)
    return None


def _enter(scope: Scope, known: str, keys: Keys) -> str:
    """The cookie of whoever comes by a link; empty for others. A guest's link may stand in a
    letter, so that her cookie is sent where that is followed."""
    if scope["method"] != "GET" or scope["path"] != "/":
        return ""
    token = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
    if token and keys.spend(token):
        return f"{keys.name}={keys.cookie}; Path=/; HttpOnly; SameSite=Strict"
    if token and keys.find(token) and who_is(known, keys) != OWNER:
        return f"{keys.name}={token}; Path=/; HttpOnly; SameSite=Lax; Max-Age={STAY}"
    return ""


def who_is(header: str, keys: Keys) -> Person | None:
    """Whose cookie a header of cookies holds."""
    try:
        found = SimpleCookie(header).get(keys.name)
    except CookieError:
        return None
    if found is None:
        return None
    return OWNER if hmac.compare_digest(found.value, keys.cookie) else keys.find(found.value)


def _bounded(scope: Scope, receive: Receive, most: int) -> Receive:
    """The parts of a request; a body that outgrows ``most`` bytes, or never ends, is refused where
    it does."""
    clock = asyncio.get_running_loop().time
    seen, whole, end = 0, scope["method"] in ("GET", "HEAD"), clock() + BODY_SECONDS

    async def next_part() -> MutableMapping[str, Any]:
        nonlocal seen, whole
        if whole:
            return await receive()
        try:
            message = await asyncio.wait_for(receive(), max(end - clock(), 0.01))
        except TimeoutError:
            raise HTTPException(408, "the request took too long to arrive") from None
        seen += len(message.get("body", b""))
        whole = not message.get("more_body", False)
        if seen > most:
            raise HTTPException(413, too_long(most), {"connection": "close"})
        return message

    return next_part


def too_long(most: int) -> str:
    """What is said of a body that is longer than it may be.

    >>> too_long(1 << 20)
    'at most 1 MB'
    """
    return f"at most {most >> 20} MB"


def _with_headers(send: Send) -> Send:
    async def forward(message: MutableMapping[str, Any]) -> None:
        if message["type"] == "http.response.start":
            own = [*message.get("headers", ())]
            said = {name for name, _ in own}
            more = [row for row in HEADERS if row[0] not in said]
            message = {**message, "headers": [*own, *more]}
        await send(message)

    return forward


async def _reply(
    send: Send, status: int, text: str, more: list[tuple[bytes, bytes]] | None = None
) -> None:
    headers = [(b"content-type", b"text/plain; charset=utf-8"), *HEADERS, *(more or [])]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": text.encode()})
