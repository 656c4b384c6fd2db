"""How tests drive the studio in a headless browser: a server of its own, a page that must not
complain, what a hand does."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

SOON = 240_000.0
"""Milliseconds that anything may take on a busy machine."""
CONTRAST = """([back, front]) => {
  const light = (name) => {
    const code = getComputedStyle(document.body).getPropertyValue(name).trim();
    const parts = code.match(/[0-9a-f]{2}/gi);
    const [r, g, b] = parts.map((part) => parseInt(part, 16) / 255)
      .map((value) => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const [low, high] = [light(back), light(front)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}"""
"""How much lighter one of two colours of the page is (WCAG 2.2, contrast ratio)."""
NAMELESS = """() => [...document.querySelectorAll("button, input, select, a, [tabindex='0']")]
  .filter((one) => one.getClientRects().length && !(one.ariaLabel || one.labels?.[0]?.textContent
    || one.textContent || one.title).trim()).map((one) => one.outerHTML.slice(0, 80))"""
"""Controls that are shown and have no name to be read out."""


class Studio(NamedTuple):
    """A studio that runs in a folder: its process and its link."""

    process: subprocess.Popen[str]
    link: str


def begin(folder: Path, source: str = "") -> Studio:
    words = ["studio", *([source] if source else []), "--no-browser", "--port", "0"]
    code = f"from scenewright.cli import main; main({words!r})"
    process = subprocess.Popen(
        [sys.executable, "-u", "-c", code], cwd=folder, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    text = ""
    while "token=" not in text or "Ctrl-C" not in text:
        line = process.stdout.readline()
        assert line, text
        text += line
    found = re.search(r"http://\S+", text)
    assert found is not None
    return Studio(process, found[0])


@contextmanager
def started(folder: Path, source: str = "") -> Iterator[Studio]:
    studio = begin(folder, source)
    try:
        yield studio
    finally:
        studio.process.send_signal(signal.SIGINT)
        with studio.process:
            studio.process.wait(60)


@contextmanager
def visiting(browser: Any, link: str, **how: Any) -> Iterator[Any]:
    """A page of its own browser context; it must not complain, nor ask anything of another
    machine."""
    with browser.new_context(viewport={"width": 1280, "height": 800}, **how) as context:
        context.set_default_timeout(SOON)
        page, complaints = context.new_page(), list[str]()
        home = link.partition("?")[0]
        page.on("request", lambda r: None if at_home(r.url, home) else complaints.append(r.url))
        page.on("console", lambda m: complaints.append(m.text) if m.type == "error" else None)
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.goto(link)
        yield page
        assert complaints == []


def at_home(address: str, home: str) -> bool:
    """Whether what a page asks for is the studio's own, or lies in the page."""
    return address.startswith((home, "data:", f"blob:{home}"))


def begin_drawing(page: Any, kind: str) -> None:
    page.click("#draw")
    page.click(f"[data-kind={kind}]")
    page.locator("#draft").wait_for()


def name_it(page: Any, name: str, box: str = "#room-name") -> None:
    """Name what was drawn just now; the drawing has the keys again."""
    page.locator(f"{box}:focus").wait_for()
    page.fill(box, name)
    page.keyboard.press("Enter")
    page.locator("#draft:focus").wait_for()


def column_over_image(page: Any, at: tuple[float, float]) -> None:
    """Lay an image under the drawing, which leaves the tools in one row; put a column there and
    type its size."""
    seen = {"name": "plan.png", "mimeType": "image/png", "buffer": page.screenshot()}
    page.set_input_files("#under", seen)
    page.locator("#tools [data-tool=scale]").wait_for()
    tops = "[...tools.querySelectorAll('button')].map((one) => one.offsetTop)"
    assert len({*page.evaluate(f"{tops}.filter((top) => top)")}) == 1
    page.locator("#draft").focus()
    page.keyboard.press("c")
    page.mouse.click(*at)
    page.fill("#column-size", "0.3")
    page.keyboard.press("Enter")
    page.locator("#draft").focus()
    size = "fetch('/state').then((r) => r.json()).then((s) => s.draft.columns[0].size === 0.3)"
    page.wait_for_function(size)


def furnish_drawing(page: Any) -> None:
    page.locator("#faults", has_text="nothing").wait_for()
    page.locator("#furnish:enabled").wait_for()
    page.click("#furnish")
    page.locator("#plan .piece").nth(4).wait_for()
    page.locator("#stop").wait_for(state="hidden")


def furnish(page: Any) -> None:
    done = page.locator("#history li", has_text="arranged")
    before = done.count()
    page.click("#arrange")
    done.nth(before).wait_for()
    page.locator("#stop").wait_for(state="hidden")


def spot(page: Any, name: str) -> tuple[float, float]:
    """Where a piece is on the screen."""
    box = page.locator(f"#plan .piece:has(title:text-is('{name}'))").first.bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(page: Any, start: tuple[float, float], end: tuple[float, float]) -> None:
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    page.mouse.move(*end)
    page.mouse.up()
