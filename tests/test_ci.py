"""The whole check: it starts in a bare environment, whatever a terminal or a shell has set."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.mark.skipif(sys.platform == "win32", reason="needs bash")
def test_the_check_starts_in_a_bare_environment(root: Path, tmp_path: Path) -> None:
    make = tmp_path / "make"
    make.write_text('#!/bin/sh\necho "$@"\nenv\n')
    make.chmod(0o755)
    noise = {"COLUMNS": "40", "TERM": "dumb", "PYTHONPATH": "/nowhere", "FORCE_COLOR": "1"}
    given = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "HOME": str(tmp_path), "CI": "1"}
    for more in ({}, noise):
        done = subprocess.run(
            [str(root / ".ci" / "run")],
            env=given | more,
            capture_output=True,
            text=True,
            check=True,
        )
        first, *lines = done.stdout.splitlines()
        assert first == "--no-print-directory test"
        told = dict(line.partition("=")[::2] for line in lines)
        assert given.items() <= told.items()
        assert not noise.keys() & told.keys()
