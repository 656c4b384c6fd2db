"""What was skipped and why, in one line at the end of every run of pytest."""

from __future__ import annotations

import importlib.util
import re
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parent.parent
EXTRAS = ("solve", "peers")
"""The extras whose packages the tests of comparisons need."""
NAME = re.compile(r"[A-Za-z0-9._-]+")


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_terminal_summary(terminalreporter: Any) -> Iterator[None]:
    """Called by pytest before its closing line; what others say there comes first."""
    yield
    reports = terminalreporter.stats.get("skipped", [])
    missing = find_missing(read_extras(ROOT / "pyproject.toml"))
    terminalreporter.write_line(summarize_skips(map(reason_of, reports), missing))


def reason_of(report: Any) -> str:
    """Why a test was skipped: the last of file, line and reason, or what it was expected to do."""
    told = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    return told.removeprefix("Skipped: ")


def read_extras(project: Path) -> dict[str, list[str]]:
    """The names of the packages of each extra."""
    stated = tomllib.loads(project.read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    return {extra: [NAME.findall(one)[0] for one in stated[extra]] for extra in EXTRAS}


def find_missing(extras: dict[str, list[str]]) -> dict[str, list[str]]:
    """The packages of each extra that are not installed here, of those that lack any."""
    lacking = {
        extra: [name for name in names if importlib.util.find_spec(name) is None]
        for extra, names in extras.items()
    }
    return {extra: names for extra, names in lacking.items() if names}


def summarize_skips(reasons: Iterable[str], missing: dict[str, list[str]]) -> str:
    """One line: how many tests were skipped for each reason, the most frequent first, and which
    packages of the extras are missing."""
    counts = Counter(reasons)
    told = [f"{count} × {reason}" for reason, count in counts.most_common()]
    line = f"skipped {counts.total()}: {'; '.join(told)}" if told else "skipped nothing"
    absent = [f"{', '.join(names)} (extra '{extra}')" for extra, names in missing.items()]
    line += f". Not installed: {'; '.join(absent)}" if absent else ""
    return " ".join(line.split())
