"""What several tests need: a small furnished flat, built by hand, as a solution and a scene."""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator
from pathlib import Path

import hypothesis
import pytest
from benchmarks.real_data import data_folder

from flat import flat_solution
from scenewright.core.solution import Solution
from skip_summary import pytest_terminal_summary
from thoroughness import THOROUGH, few_or_many

__all__ = ["pytest_terminal_summary"]

# On a build server property tests try the same examples every time; at a desk they go on looking.
hypothesis.settings.register_profile(
    "scenewright",
    deadline=None,
    max_examples=few_or_many(25, 300),
    derandomize=bool(os.environ.get("CI")),
)
hypothesis.settings.load_profile("scenewright")

ROOT = Path(__file__).parent.parent


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """What is collected lives until the end: no cycle of objects is looked for among it, while it
    grows or later. That took half the time of collecting."""
    gc.disable()
    yield
    gc.freeze()
    gc.enable()


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Tests of real data are skipped where there are none; but the quick ones they are in the
    thorough check."""
    real = item.get_closest_marker("realdata")
    if real and not data_folder().is_dir():
        pytest.skip(f"no real data at {data_folder()}: set SCENEWRIGHT_DATA")
    if real and not (THOROUGH or real.kwargs.get("quick")):
        pytest.skip("in make test-all")


@pytest.fixture(scope="session")
def root() -> Path:
    """The top folder of the source checkout."""
    return ROOT


@pytest.fixture(scope="session")
def real_data() -> Path:
    """The folder of real data sets; the test is skipped where there is none."""
    folder = data_folder()
    if not folder.is_dir():
        pytest.skip(f"no real data at {folder}: set SCENEWRIGHT_DATA")
    return folder


@pytest.fixture
def solution() -> Solution:
    """The furnished flat of two rooms."""
    return flat_solution()
