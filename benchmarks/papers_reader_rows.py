"""What the reader's test is made of: rows of the pages, what they name, and the checks by row."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

import scenewright as sw
from scenewright.domains.hall.solving import solve as solve_hall
from scenewright.domains.home.solving import solve as solve_home
from scenewright.domains.site.solving import solve as solve_site
from scenewright.domains.village.solving import solve as solve_village
from scenewright.engine.trace import Step

Dice = np.random.Generator
Pair = tuple[float, float]
"""What the print gives by hand, and what the function or the trace says."""
Check = Callable[[Any, Dice], Pair]
PAGES = {
    "halls": "hall",
    "homes": "home",
    "sites": "site",
    "extensions": "extend",
    "villages": "village",
}
FOLDER = Path(__file__).parent.parent / "docs"
CHECKS: dict[tuple[str, str, str], Check] = {}
"""By page, kind (formula or step) and how the row begins."""


def by_row(page: str, kind: str, row: str) -> Callable[[Check], Check]:
    """Says which row of which page a check is of."""

    def add(check: Check) -> Check:
        CHECKS[page, kind, row] = check
        return check

    return add


@cache
def rows_of(page: str) -> tuple[tuple[str, str], ...]:
    """The rows of a page: what is printed, and the function it names."""
    text = (FOLDER / f"reproduction-{page}.md").read_text(encoding="utf-8")
    return tuple(re.findall(r"^\| (\S.*?) \| `([\w/.]+)`.*$", text, re.MULTILINE))


def function_of(page: str, path: str) -> Any:
    """The function a row names, ``terms/table.space_cost``."""
    module, _, names = path.partition(".")
    shared = path.startswith(("engine/", "geometry/", "ground/"))
    place = "" if shared else f"domains.{PAGES[page]}."
    found = import_module(f"scenewright.{place}{module.replace('/', '.')}")
    for name in names.split("."):
        found = getattr(found, name)
    return found


@cache
def trace(page: str) -> tuple[Step, ...]:
    """What the preset ``paper`` does with a sample."""
    heard = list[Step]()
    runs: dict[str, tuple[Any, str]] = {
        "halls": (solve_hall, "hall-shop"),
        "homes": (solve_home, "home-room"),
        "sites": (solve_site, "site-square"),
        "villages": (solve_village, "village-hamlet"),
    }
    solve, sample = runs[page]
    solve(sw.read(f"sample:{sample}"), preset="paper", hear=heard.append)
    return tuple(heard)


def told(page: str, kind: str) -> list[Step]:
    """The steps of one kind."""
    return [step for step in trace(page) if step.kind == kind]
