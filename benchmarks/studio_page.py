"""The studio's page in headless Chromium: what is on the screen when, and what it cost to send.

The page is asked by a script that looks at every frame, so that nothing of it needs to be changed.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

FLAGS = ("--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
PATIENCE = 240_000.0
"""Milliseconds that anything may take on a busy machine."""
QUIET = 1.5
"""Seconds without an answer after which all of a page is in."""
DRAGGED = ((8, 5), (15, 9), (22, 14), (26, 17))
"""Pixels by which a piece is dragged, one place after the other."""
LOOK = """
const seen = window.seen = { layouts: [], judged: [], edited: [] };
const now = () => performance.now(), steps = () => document.querySelectorAll("#history li").length;
window.beginRun = (seed) => {
  const fresh = { boxes: 0, furniture: 0, done: 0, last: 0, stages: new Set() };
  Object.assign(seen, fresh, { begun: now(), before: steps() });
  document.querySelector("#seed").value = seed;
  document.querySelector("#arrange").click();
};
const Source = window.EventSource;
window.EventSource = class extends Source {
  constructor(...given) {
    super(...given);
    this.addEventListener("message", ({ data }) => {
      const event = JSON.parse(data);
      if (event.stage && event.stage !== "left out") seen.last = now();
      if (event.boxes) { seen.layouts.push(data.length + 8); seen.stages?.add(event.stage); }
    });
  }
};
const ask = window.fetch;
window.fetch = async (address, how) => {
  const begun = now(), body = String(how?.body ?? ""), moves = body.includes('"verb":"move"');
  if (moves) Object.assign(seen, { dropped: begun, then: steps() });
  const reply = await ask(address, how);
  if (body.includes('"verb":"judge"')) seen.judged.push(now() - begun);
  if (moves && (await reply.clone().json()).fault) seen.dropped = 0;
  return reply;
};
const look = () => {
  if (seen.begun && !seen.done) {
    const drawn = document.querySelector("#streamed *");
    const furnished = [...seen.stages].some((stage) => stage !== "search" || window.whole);
    if (drawn && !seen.boxes) seen.boxes = now() - seen.begun;
    if (drawn && furnished && !seen.furniture) seen.furniture = now() - seen.begun;
    if (steps() > seen.before) seen.done = now() - seen.begun;
    if (seen.done) {
      seen.furniture ||= seen.done;
      seen.silence = seen.begun + seen.done - seen.last;
    }
  }
  if (seen.dropped && steps() > seen.then) {
    seen.edited.push(now() - seen.dropped);
    seen.dropped = 0;
  }
  requestAnimationFrame(look);
};
requestAnimationFrame(look);
"""


class PageRun(NamedTuple):
    """One arrangement on the page: seconds until the first boxes, the first furniture and the
    layout itself were on the screen, from the last word on it to the layout, and the processor
    seconds of the server."""

    boxes: float
    furniture: float
    done: float
    silence: float
    processor: float


class PageFigures(NamedTuple):
    """What was seen of one kind of scene: seconds until the ``page`` was usable, its ``runs``,
    seconds of answers while dragging (``judged``) and of changes let go (``edited``), and bytes of
    ``layouts``, of changes (``told``) and of a ``first`` visit with the 3D view."""

    page: list[float]
    runs: list[PageRun]
    judged: list[float]
    edited: list[float]
    layouts: list[int]
    told: list[int]
    first: int


class Serving(NamedTuple):
    """A studio of its own process: its number, its link, and seconds until it printed that."""

    number: int
    link: str
    seconds: float


@contextmanager
def serving() -> Iterator[Serving]:
    """A studio in a folder of its own."""
    code = "from scenewright.cli import main; main(['studio', '--no-browser', '--port', '0'])"
    with tempfile.TemporaryDirectory() as folder:
        begun, text = time.perf_counter(), ""
        command = [sys.executable, "-u", "-c", code]
        process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        try:
            while "Ctrl-C" not in text:
                line = process.stdout.readline()
                if not line:
                    raise RuntimeError(f"the studio did not begin: {text}")
                text += line
            found = re.search(r"http://\S+", text)
            assert found is not None
            yield Serving(process.pid, found[0], time.perf_counter() - begun)
        finally:
            process.send_signal(signal.SIGINT)
            with process:
                process.wait(60)


@contextmanager
def browsing() -> Iterator[Any]:
    """Chromium, that of the system where there is one."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as made:
        path = shutil.which("chromium") or shutil.which("chromium-browser")
        more: dict[str, Any] = {"executable_path": path} if path else {}
        with made.chromium.launch(args=[*FLAGS], **more) as browser:
            yield browser


def spent_by(number: int) -> float:
    """Processor seconds of a process and all its threads."""
    fields = Path(f"/proc/{number}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def visit(browser: Any, cookies: Any = None) -> Any:
    """A page of a browser context of its own, known already if it has ``cookies``."""
    context = browser.new_context(viewport={"width": 1280, "height": 800}, storage_state=cookies)
    context.set_default_timeout(PATIENCE)
    context.add_init_script(LOOK)
    return context.new_page()


def measure_page(page: Any, browser: Any, served: Serving, sample: str, runs: int) -> PageFigures:
    """Open a sample on the page, arrange it by several seeds, change it and visit it anew."""
    _send(page, {"verb": "open", "source": f"sample:{sample}"})
    page.locator("#plan .space").first.wait_for()
    _wait_until(page, "async () => !(await (await fetch('/ready')).json()).kind")
    page.evaluate("whole => { window.whole = whole; seen.layouts = []; }", sample[:4] != "home")
    arranged = [_arrange(page, served, seed) for seed in range(runs)]
    told = _drag_some(page, 2 * runs)
    seen = page.evaluate("({ ...seen, stages: 0 })")
    page.evaluate("Object.assign(seen, { judged: [], edited: [] })")
    visits = [_visit_anew(page, browser, served, number == 0) for number in range(runs)]
    return PageFigures(
        [seconds for seconds, _ in visits],
        arranged,
        [ms / 1000 for ms in seen["judged"]],
        [ms / 1000 for ms in seen["edited"]],
        seen["layouts"],
        told,
        max(count for _, count in visits),
    )


def _wait_until(page: Any, script: str) -> None:
    """Wait for what a function on the page says; the page lets no text be run as a script."""
    end = time.perf_counter() + PATIENCE / 1000
    while not page.evaluate(script):
        if time.perf_counter() > end:
            raise RuntimeError(f"the page never came so far: {script}")
        page.wait_for_timeout(50)


def _send(page: Any, verb: dict[str, str]) -> None:
    page.evaluate(
        "async verb => { await fetch('/do', { method: 'POST', body: JSON.stringify(verb) }); }",
        verb,
    )


def _arrange(page: Any, served: Serving, seed: int) -> PageRun:
    before = spent_by(served.number)
    page.evaluate("seed => beginRun(seed)", seed)
    _wait_until(page, "() => seen.done")
    seen = page.evaluate("[seen.boxes || seen.done, seen.furniture, seen.done, seen.silence]")
    page.locator("#arrange:enabled").wait_for()
    boxes, furniture, done, silence = (float(ms) / 1000 for ms in seen)
    return PageRun(boxes, furniture, done, silence, spent_by(served.number) - before)


def _drag_some(page: Any, times: int) -> list[int]:
    """Drag pieces spread over the plan; bytes of the verb and of the state after each."""
    told, pieces = list[int](), page.locator("#plan .piece:not(.hangs):not(.flat)")
    count = pieces.count()
    for number in range(times):
        box = pieces.nth(number * count // times).bounding_box()
        if box is None:
            continue
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        with _counting(page, ("/do", "/state")) as sizes:
            page.mouse.move(x, y)
            page.mouse.down()
            for right, down in DRAGGED:
                page.mouse.move(x + right, y + down)
                page.wait_for_timeout(50)
            sizes.clear()
            before = page.evaluate("seen.edited.length")
            page.mouse.up()
            page.wait_for_timeout(100)
            _wait_until(page, "() => !seen.dropped")
            page.wait_for_timeout(200)
        if page.evaluate("seen.edited.length") > before:
            told.append(sum(sizes.values()))
    return told


@contextmanager
def _counting(page: Any, paths: tuple[str, ...]) -> Iterator[dict[str, int]]:
    """Bytes of answers as they came over the network, by request, of addresses that begin so."""
    wire, sizes, of = page.context.new_cdp_session(page), dict[str, int](), dict[str, str]()
    wire.on("Network.requestWillBeSent", lambda e: of.update({e["requestId"]: e["request"]["url"]}))

    def count(event: Any) -> None:
        path = "/" + of.get(event["requestId"], "").partition("://")[2].partition("/")[2]
        if path.startswith(paths):
            sizes[event["requestId"]] = int(event["encodedDataLength"])

    wire.on("Network.loadingFinished", count)
    wire.send("Network.enable")
    yield sizes
    wire.detach()


def _visit_anew(page: Any, browser: Any, served: Serving, solid: bool) -> tuple[float, int]:
    """Seconds until the page is usable for who has nothing of it yet, and bytes until all of it is
    there, with ``solid`` the 3D view as well."""
    other = visit(browser, page.context.storage_state())
    with _counting(other, ("/",)) as sizes:
        begun = time.perf_counter()
        other.goto(served.link.partition("?")[0])
        other.locator("#plan .piece").first.wait_for()
        other.locator("#arrange:enabled").wait_for()
        seconds = time.perf_counter() - begun
        before = -1
        if solid:
            other.click("#solid")
            other.locator("#space").wait_for()
        while solid and before != len(sizes):
            before = len(sizes)
            other.wait_for_timeout(1000 * QUIET)
    other.context.close()
    return seconds, sum(sizes.values())
