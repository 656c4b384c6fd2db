"""The line that says what a run of pytest skipped, and why."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from skip_summary import EXTRAS, find_missing, read_extras, summarize_skips
from thoroughness import only_thorough

TESTS = """
import pytest

def test_that_runs(): pass

@pytest.mark.parametrize("n", [1, 2])
def test_solver(n): pytest.importorskip("no_such_package", reason="needs the extra 'solve'")

@pytest.mark.skipif(True, reason="signals")
def test_signals(): pass
"""


@pytest.mark.parametrize("processes", [pytest.param("0", marks=only_thorough), "2"])
def test_every_run_ends_with_what_it_skipped(tmp_path: Path, processes: str) -> None:
    (tmp_path / "conftest.py").write_text("from skip_summary import pytest_terminal_summary\n")
    (tmp_path / "test_some.py").write_text(TESTS)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-n", processes]
    done = subprocess.run(
        command,
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(Path(__file__).parent)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    line = done.stdout.splitlines()[-2]
    assert line.startswith("skipped 3: 2 × needs the extra 'solve'; 1 × signals")


def test_missing_packages_are_named_with_their_extra(root: Path) -> None:
    extras = read_extras(root / "pyproject.toml")
    assert tuple(extras) == EXTRAS
    assert extras["solve"] == ["ortools"]
    assert {"scipy", "cma", "pymoo", "deap"} == set(extras["peers"])
    missing = find_missing({"solve": ["no_such_package"], "peers": ["pytest"]})
    assert missing == {"solve": ["no_such_package"]}
    assert summarize_skips([], missing) == (
        "skipped nothing. Not installed: no_such_package (extra 'solve')"
    )
    assert summarize_skips([], {}) == "skipped nothing"
    assert summarize_skips(["no\ndata"], missing).count("\n") == 0
