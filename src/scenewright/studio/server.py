"""The studio's addresses: the page, the document, verbs by POST, events as they happen (SSE)."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping
from importlib import resources
from pathlib import Path, PurePath
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response, StreamingResponse
from starlette.routing import Route

from scenewright.core.errors import CancelledError, InputError
from scenewright.formats import samples
from scenewright.formats.table import formats
from scenewright.studio.breeding import Breeding
from scenewright.studio.limits import MOST_FILES
from scenewright.studio.people import EDIT, OWN, OWNER, Person, may
from scenewright.studio.raters import RaterDesk
from scenewright.studio.replies import reply
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.texture_files import texture_file
from scenewright.studio.verbs import do_verb
from scenewright.studio.wishing import ask_schema
from scenewright.workflow.dressing import list_looks

SCRIPT = "text/javascript"
PAGES = {
    "": "text/html",
    "studio.css": "text/css",
    "studio.js": SCRIPT,
    "breed.js": SCRIPT,
    "draw.js": SCRIPT,
    "draft.js": SCRIPT,
    "sketch.js": SCRIPT,
    "snapping.js": SCRIPT,
    "looks.js": SCRIPT,
    "wire.js": SCRIPT,
    "words.js": SCRIPT,
    "people.js": SCRIPT,
    "wishes.js": SCRIPT,
    "words.zh.json": "application/json",
    "walk.js": SCRIPT,
    "mesh.js": SCRIPT,
    "solid.js": SCRIPT,
    "state.js": SCRIPT,
    "shelf.js": SCRIPT,
    "three.js": SCRIPT,
}
LANGUAGES = ("en", "zh")
"""What the page speaks, the usual one first."""
MOST_CARDS, MOST_SYMBOLS = 500, 1000
"""Layouts and symbols that one request may ask for."""
PAUSE = 10.0
"""Seconds after which a line that says nothing keeps an event stream open."""


class Listeners:
    """The pages that listen; ``tell`` may be called from any thread."""

    def __init__(self) -> None:
        self.queues: set[tuple[asyncio.AbstractEventLoop, asyncio.Queue[Json]]] = set()

    def tell(self, event: Json) -> None:
        """Send an event to every page."""
        for loop, queue in [*self.queues]:
            loop.call_soon_threadsafe(queue.put_nowait, event)

    async def stream(self) -> AsyncIterator[str]:
        """Events for one page until it goes away."""
        mine = (asyncio.get_running_loop(), asyncio.Queue[Json]())
        self.queues.add(mine)
        try:
            yield ": here\n\n"
            while True:
                try:
                    event = await asyncio.wait_for(mine[1].get(), PAUSE)
                    yield f"data: {json.dumps(event)}\n\n"
                except TimeoutError:
                    yield ": here\n\n"
        finally:
            self.queues.discard(mine)


Query = Mapping[str, str]


def _state(session: Session, person: Person, query: Query) -> Any:
    """All that the page shows, or what changed ``since`` a state it has."""
    since = query.get("since", "")[:12]
    told = session.state_since(int(since) if since.isdecimal() else 0)
    me = {"name": person.name, "right": person.right}
    return told if "since" in told else told | {"me": me}


def _sheets(session: Session, person: Person) -> Breeding | RaterDesk:
    return session.breeding if may(person.right, EDIT) else session.desk_of(person)


def _cards(session: Session, person: Person, query: Query) -> Any:
    asked = [int(n) for n in query.get("of", "").split(",") if n.isdecimal()]
    return _sheets(session, person).draw(asked[:MOST_CARDS])


def _symbols(session: Session, _person: Person, query: Query) -> Any:
    return session.shapes.symbols(query.get("of", "").split(",")[:MOST_SYMBOLS])


def _ratings(session: Session, person: Person, _query: Query) -> Any:
    if not may(person.right, OWN):
        raise InputError("only the owner sees who rated", "ask for a look at it")
    return session.raters.results()


def _export(session: Session, query: Query) -> bytes:
    asked = [one for one in query.get("formats", "").split(",") if one]
    known = {row.suffix.removeprefix(".") for row in formats() if row.writer}
    return session.export([ending for ending in asked if ending in known] if asked else ())


TOLD: Mapping[str, Callable[[Session, Person, Query], Any]] = {
    "/state": _state,
    "/samples": lambda *_: [*samples()],
    "/breeding": lambda session, person, _: _sheets(session, person).state(),
    "/ratings": _ratings,
    "/shelf": lambda session, *_: session.shelf(),
    "/wish.schema.json": lambda _session, _person, query: ask_schema(query.get("of", "home")),
    "/ready": lambda session, *_: session.readiness.state(),
    "/looks": lambda session, *_: list_looks(session.kind()),
    "/cards": _cards,
    "/symbols": _symbols,
    "/solid": lambda session, *_: session.solid(),
}
"""What is told as JSON, by address."""
GIVEN: Mapping[str, tuple[str, Callable[[Session, Query], bytes]]] = {
    "/export.zip": ("application/zip", _export),
    "/picture.png": ("image/png", lambda session, _: session.file("png")),
    "/scene.glb": ("model/gltf-binary", lambda session, _: session.file("glb")),
    "/photo.png": ("image/png", lambda session, _: session.photos.last()),
    "/thumb.png": ("image/png", lambda session, query: session.thumb(query.get("asset", ""))),
}
"""What is given as a file, by address."""
LASTING: Mapping[str, tuple[str, Callable[[Session, str], bytes]]] = {
    "/mesh/{name}": ("application/octet-stream", lambda session, name: session.shapes.mesh(name)),
    "/texture/{name}.webp": ("image/webp", lambda _, name: texture_file(name.replace("_", " "))),
}
"""What never changes at its address, which names it by its content."""


def studio_app(session: Session, listeners: Listeners, folder: Path) -> Starlette:
    """The application; what the page brings is kept in ``folder``, a folder of its own."""
    bringing = asyncio.Semaphore(MOST_FILES)

    async def events(_request: Request) -> Response:
        return StreamingResponse(listeners.stream(), media_type="text/event-stream")

    async def do(request: Request) -> Response:
        return await _answer(request, do_verb, session, await request.body(), _person(request))

    async def bring(request: Request) -> Response:
        if not may(_person(request).right, EDIT):
            return JSONResponse({"fault": "your link does not let you bring files"}, 403)
        name = request.query_params.get("name", "")
        async with bringing:
            return await _answer(request, _bring, session, await request.body(), folder, name)

    return Starlette(
        routes=[
            *(Route(f"/{name}", _page(name)) for name in PAGES),
            *(Route(path, _tell(session, row)) for path, row in TOLD.items()),
            *(Route(path, _give(session, *row)) for path, row in GIVEN.items()),
            *(Route(path, _keep(session, *row)) for path, row in LASTING.items()),
            Route("/events", events),
            Route("/do", do, methods=["POST"]),
            Route("/bring", bring, methods=["POST"]),
        ]
    )


def _tell(session: Session, tell: Callable[..., Any]) -> Callable[[Request], Awaitable[Response]]:
    async def told(request: Request) -> Response:
        return await _answer(request, tell, session, _person(request), request.query_params)

    return told


def _give(
    session: Session, kind: str, make: Callable[..., bytes]
) -> Callable[[Request], Awaitable[Response]]:
    async def given(request: Request) -> Response:
        try:
            content = await run_in_threadpool(make, session, request.query_params)
        except InputError as error:
            return JSONResponse({"fault": str(error)}, 422)
        return reply(request, content, kind)

    return given


def _keep(
    session: Session, kind: str, find: Callable[[Session, str], bytes]
) -> Callable[[Request], Awaitable[Response]]:
    async def kept(request: Request) -> Response:
        content = await run_in_threadpool(find, session, request.path_params["name"])
        if not content:
            return JSONResponse({"fault": "it is not kept any more; ask for the scene"}, 404)
        return reply(request, content, kind, forever=True)

    return kept


def _person(request: Request) -> Person:
    """Who asks, as the guard found."""
    person: Person = request.scope.get("person", OWNER)
    return person


def _page(name: str) -> Callable[[Request], Awaitable[Response]]:
    file = resources.files("scenewright.studio") / "page" / (name or "studio.html")

    async def page(request: Request) -> Response:
        content = file.read_bytes()
        if not name:
            known = request.cookies.get("scenewright-language", "")
            language = choose_language(known or request.headers.get("accept-language", ""))
            content = content.replace(b'lang="en"', f'lang="{language}"'.encode(), 1)
        return reply(request, content, PAGES[name])

    return page


def choose_language(header: str) -> str:
    """The language of the page that suits an Accept-Language header best.

    >>> choose_language("zh-CN,zh;q=0.9,en;q=0.8"), choose_language("fr, en;q=0.5, zh;q=0.2")
    ('zh', 'en')
    """
    found = []
    for part in header.split(","):
        name, _, share = part.strip().lower().partition(";q=")
        if (name[:2] in LANGUAGES and share.replace(".", "", 1).isdecimal()) or not share:
            found.append((-float(share or 1), name[:2]))
    known = [name for _, name in sorted(found, key=lambda one: one[0]) if name in LANGUAGES]
    return known[0] if known else LANGUAGES[0]


async def _answer(request: Request, verb: Callable[..., Any], *given: Any) -> Response:
    """What a verb answers, or its fault in one line: refused is an answer too, no failure of the
    server, and browsers would log another status as an error of the page."""
    try:
        told = await run_in_threadpool(verb, *given)
        text = json.dumps(told, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
        return reply(request, text.encode(), "application/json")
    except (InputError, CancelledError) as error:
        return JSONResponse({"fault": str(error)}, headers={"cache-control": "no-store"})


def _bring(session: Session, body: bytes, folder: Path, name: str) -> Json:
    plain = PurePath(name.replace("\\", "/")).name
    if not plain or plain.startswith(".") or plain != name:
        raise InputError(f"{name!r} is no name of a file", "bring the file itself")
    (folder / plain).write_bytes(body)
    session.open(plain, folder)
    return {}
