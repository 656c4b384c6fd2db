"""The studio's addresses: the page, the document, verbs by POST, events as they happen (SSE)."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Awaitable, Callable
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
from scenewright.studio.drawable import Json
from scenewright.studio.people import EDIT, OWN, OWNER, Person, may
from scenewright.studio.raters import RaterDesk
from scenewright.studio.session import FORMATS, Session
from scenewright.studio.verbs import do_verb, read_request

SCRIPT = "text/javascript"
PAGES = {
    "": "text/html",
    "studio.css": "text/css",
    "studio.js": SCRIPT,
    "breed.js": SCRIPT,
    "draw.js": SCRIPT,
    "draft.js": SCRIPT,
    "wire.js": SCRIPT,
    "words.js": SCRIPT,
    "people.js": SCRIPT,
    "words.zh.json": "application/json",
    "walk.js": SCRIPT,
    "shelf.js": SCRIPT,
    "three.js": SCRIPT,
}
LANGUAGES = ("en", "zh")
"""What the page speaks, the usual one first."""
MOST_CARDS = 500
"""Layouts that one request may ask for."""
PAUSE = 10.0
"""Seconds after which a line that says nothing keeps an event stream open."""
NAMED_FILES = ("catalogs", "groups", "sources", "source_file", "nets", "style")
"""Keys of a brief that name further files, which what is brought by the page may not."""


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


def studio_app(session: Session, listeners: Listeners, folder: Path) -> Starlette:
    """The application; what the page brings is kept in ``folder``, a folder of its own."""

    async def state(request: Request) -> Response:
        _, name, right = _person(request)
        shown = await run_in_threadpool(session.state)
        return JSONResponse(shown | {"me": {"name": name, "right": right}})

    async def events(_request: Request) -> Response:
        return StreamingResponse(listeners.stream(), media_type="text/event-stream")

    async def do(request: Request) -> Response:
        return await _answer(do_verb, session, await request.body(), _person(request))

    async def bring(request: Request) -> Response:
        if not may(_person(request).right, EDIT):
            return JSONResponse({"fault": "your link does not let you bring files"}, 403)
        name = request.query_params.get("name", "")
        return await _answer(_bring, session, await request.body(), folder, name)

    async def export(request: Request) -> Response:
        asked = request.query_params.get("formats", ",".join(FORMATS)).split(",")
        known = {row.suffix.removeprefix(".") for row in formats() if row.writer}
        return await _file(session.export, "application/zip", [e for e in asked if e in known])

    async def picture(_request: Request) -> Response:
        return await _file(session.file, "image/png", "png")

    async def model(_request: Request) -> Response:
        return await _file(session.file, "model/gltf-binary", "glb")

    async def list_samples(_request: Request) -> Response:
        return JSONResponse([*samples()])

    async def shelf(_request: Request) -> Response:
        return JSONResponse(await run_in_threadpool(session.shelf))

    async def thumb(request: Request) -> Response:
        name = request.query_params.get("asset", "")
        return await _file(session.thumb, "image/png", name)

    def sheets(request: Request) -> Breeding | RaterDesk:
        person = _person(request)
        return session.breeding if may(person.right, EDIT) else session.desk_of(person)

    async def breeding(request: Request) -> Response:
        return JSONResponse(await run_in_threadpool(sheets(request).state))

    async def ratings(request: Request) -> Response:
        if not may(_person(request).right, OWN):
            return JSONResponse({"fault": "only the owner sees who rated"}, 403)
        return JSONResponse(await run_in_threadpool(session.raters.results))

    async def cards(request: Request) -> Response:
        asked = [int(n) for n in request.query_params.get("of", "").split(",") if n.isdecimal()]
        return JSONResponse(await run_in_threadpool(sheets(request).draw, asked[:MOST_CARDS]))

    return Starlette(
        routes=[
            *(Route(f"/{name}", _page(name)) for name in PAGES),
            Route("/state", state),
            Route("/events", events),
            Route("/samples", list_samples),
            Route("/breeding", breeding),
            Route("/ratings", ratings),
            Route("/shelf", shelf),
            Route("/thumb.png", thumb),
            Route("/cards", cards),
            Route("/export.zip", export),
            Route("/picture.png", picture),
            Route("/scene.glb", model),
            Route("/do", do, methods=["POST"]),
            Route("/bring", bring, methods=["POST"]),
        ]
    )


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
        return Response(content, media_type=PAGES[name])

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


async def _file(make: Callable[..., bytes], kind: str, *args: Any) -> Response:
    try:
        return Response(await run_in_threadpool(make, *args), media_type=kind)
    except InputError as error:
        return JSONResponse({"fault": str(error)}, 422)


async def _answer(verb: Callable[..., Json], session: Session, body: bytes, *more: Any) -> Response:
    """What a verb answers, or its fault in one line."""
    try:
        return JSONResponse(await run_in_threadpool(verb, session, body, *more))
    except (InputError, CancelledError) as error:
        return JSONResponse({"fault": str(error)}, 422)


def _bring(session: Session, body: bytes, folder: Path, name: str) -> Json:
    plain = PurePath(name.replace("\\", "/")).name
    if not plain or plain.startswith(".") or plain != name:
        raise InputError(f"{name!r} is no name of a file", "bring the file itself")
    if plain.lower().endswith(".json"):
        check_names_no_file(read_request(body), plain)
    path = folder / plain
    path.write_bytes(body)
    session.open(str(path))
    return {}


def check_names_no_file(document: Json, name: str) -> None:
    """InputError for a brief that names further files: those of the server's machine are nobody's
    business.

    >>> check_names_no_file({"catalogs": ["/etc"]}, "flat.json")
    Traceback (most recent call last):
    scenewright.core.errors.InputError: flat.json: catalogs: names files, which a brief that is \
brought may not; start the studio with the file
    """
    inner = document.get("brief")
    if isinstance(inner, dict):
        check_names_no_file(inner, name)
    for key in NAMED_FILES:
        value = document.get(key)
        if value and (key != "style" or str(value).endswith(".npz")):
            fault = "names files, which a brief that is brought may not"
            raise InputError(fault, "start the studio with the file", file=name, place=key)
