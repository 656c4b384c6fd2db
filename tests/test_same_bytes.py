"""Same seed and steps, same bytes: in every file, on any number of threads, in any process."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from thoroughness import only_thorough

PROGRAM = """
import sys
from scenewright import domains, formats
name, threads, folder = sys.argv[1:]
solution = domains.solve(formats.read("sample:" + name), steps=60, seed=3, threads=int(threads))
for suffix in ("json", "svg", "glb", "png"):
    formats.write(solution, f"{folder}/scene.{suffix}")
"""


def digests(name: str, threads: int, folder: Path) -> dict[str, str]:
    """SHA-256 of each file a process of its own writes, which orders sets in its own way."""
    folder.mkdir()
    environment = {**os.environ, "PYTHONHASHSEED": str(threads)}
    command = [sys.executable, "-c", PROGRAM, name, str(threads), str(folder)]
    subprocess.run(command, env=environment, check=True)
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(folder.iterdir())}


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    ["home-studio", *(pytest.param(n, marks=only_thorough) for n in ("hall-shop", "site-30"))],
)
def test_the_same_seed_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    assert digests(name, 1, tmp_path / "one") == digests(name, 2, tmp_path / "two")
