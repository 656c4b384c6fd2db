"""The page that says what the papers print: every function and test it names is there."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

import pytest

HALL, HOME, SITE = "hall", "home", "site"
DEFAULTS = {
    HALL: "test_hall_as_printed",
    HOME: "test_home_as_printed",
    SITE: "test_site_as_printed",
    "village": "test_traces",
    "extend": "test_extend_printed",
}
PACKAGES = {"extension": "extend"}
"""Domains that are not named by the heading of their page."""
SHARED = ("engine/", "geometry/", "ground/")
NUMBERED = {
    HALL: [f"eq. {number}" for number in range(1, 10)],
    HOME: [f"C{number}" for number in range(1, 8)],
    SITE: [f"({number})" for number in range(1, 26)],
}


class Line(NamedTuple):
    """A printed equation, the function that computes it and the test that holds it."""

    domain: str
    printed: str
    function: str
    test: str


def lines_of(page: str) -> list[Line]:
    """The rows of the tables of equations."""
    found, domain = [], ""
    for line in page.splitlines():
        if line.startswith("## "):
            heading = line.removeprefix("## ").lower().removesuffix("s")
            domain = PACKAGES.get(heading, heading)
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        code = [re.fullmatch(r"`([^`]+)`", cell) for cell in cells[1:3]]
        if len(cells) >= 3 and all(code):
            found.append(Line(domain, cells[0], *(match[1] for match in code if match)))
    return found


@pytest.fixture(scope="module")
def lines(root: Path) -> list[Line]:
    return lines_of((root / "docs" / "reproduction.md").read_text(encoding="utf-8"))


@pytest.mark.parametrize("domain", [HALL, HOME, SITE])
def test_every_numbered_equation_has_its_line(lines: list[Line], domain: str) -> None:
    printed = [line.printed for line in lines if line.domain == domain]
    assert len(printed) >= 19
    assert not [name for name in NUMBERED[domain] if not any(p.startswith(name) for p in printed)]


def test_every_function_named_is_there(lines: list[Line]) -> None:
    for line in lines:
        path, _, names = line.function.partition(".")
        home = "" if path.startswith(SHARED) else f"domains.{line.domain}."
        found = import_module(f"scenewright.{home}{path.replace('/', '.')}")
        for name in names.split("."):
            found = getattr(found, name)
        assert callable(found), line


def test_every_test_named_is_there(lines: list[Line], root: Path) -> None:
    for line in lines:
        file, _, name = line.test.rpartition(".")
        source = (root / "tests" / f"{file or DEFAULTS[line.domain]}.py").read_text("utf-8")
        assert f"\ndef {name}(" in source, line
