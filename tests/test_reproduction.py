"""The pages that say what the papers print: every function, test and fact they name is there."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

import pytest

HALL, HOME, SITE = "hall", "home", "site"
PAGES = {
    HALL: ("halls", "test_hall_as_printed"),
    HOME: ("homes", "test_home_as_printed"),
    SITE: ("sites", "test_site_as_printed"),
    "village": ("villages", "test_traces"),
    "extend": ("extensions", "test_extend_printed"),
}
"""By domain the page, and the file of tests that are named without one."""
SHARED = ("engine/", "geometry/", "ground/")
NUMBERED = {
    HALL: [f"eq. {number}" for number in range(1, 10)],
    HOME: [f"C{number}" for number in range(1, 8)],
    SITE: [f"({number})" for number in range(1, 26)],
}


class Line(NamedTuple):
    """A printed equation, the function that computes it, the test that holds it and, if any, the
    fact of a trace that shows it."""

    domain: str
    printed: str
    function: str
    test: str
    fact: str


def lines_of(domain: str, page: str) -> list[Line]:
    """The rows of the table of equations of a page."""
    found = []
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        code = [re.fullmatch(r"`([^`]+)`", cell) for cell in cells[1:3]]
        if len(cells) >= 4 and all(code):
            function, test = (match[1] for match in code if match)
            found.append(Line(domain, cells[0], function, test, cells[3].strip("`")))
    return found


@pytest.fixture(scope="module")
def lines(root: Path) -> list[Line]:
    pages = {name: root / "docs" / f"reproduction-{page}.md" for name, (page, _) in PAGES.items()}
    return [one for name, page in pages.items() for one in lines_of(name, page.read_text("utf-8"))]


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
        source = (root / "tests" / f"{file or PAGES[line.domain][1]}.py").read_text("utf-8")
        assert f"\ndef {name}(" in source, line


def told_by(node: ast.Call) -> Iterator[str]:
    """``kind.fact`` of what one call of ``tell`` tells."""
    words = [str(arg.value) for arg in node.args if isinstance(arg, ast.Constant)]
    for word in node.keywords:
        yield f"{words[0]}.{word.arg}"
        if isinstance(word.value, ast.DictComp) or word.arg is None:
            yield f"{words[0]}.*"


def test_every_fact_named_is_told_in_traces(lines: list[Line], root: Path) -> None:
    for domain in PAGES:
        told = set[str]()
        for file in (root / "src/scenewright/domains" / domain).rglob("*.py"):
            for node in ast.walk(ast.parse(file.read_text("utf-8"))):
                if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "tell":
                    told |= set(told_by(node))
        facts = [line.fact for line in lines if line.domain == domain and line.fact]
        assert facts
        assert [f for f in facts if f not in told and f"{f.partition('.')[0]}.*" not in told] == []
