"""Compiled kernels on disk: whatever is wrong with a file, it is compiled and written again."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

PROGRAM = """
import numpy as np
from scenewright.geometry.compile_clock import compile_clock
from scenewright.geometry.boxes import wrap
with compile_clock() as clock:
    print(round(float(wrap(7.0)), 6), clock.kernels)
"""
ANSWER = "0.716815"


def command(folder: Path) -> dict[str, str]:
    return {**os.environ, "NUMBA_CACHE_DIR": str(folder)}


def run(folder: Path) -> list[str]:
    """The answer of a kernel and how many were compiled, from a process of its own."""
    ended = subprocess.run(
        [sys.executable, "-W", "error", "-c", PROGRAM],
        env=command(folder),
        capture_output=True,
        text=True,
        check=False,
    )
    assert not ended.stderr
    return ended.stdout.split()


def kernels(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.kernel"))


def cut_short(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-100])


def flip_a_bit(path: Path) -> None:
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)


def replace_by_folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


DAMAGES: list[Callable[[Path], object]] = [
    cut_short,
    flip_a_bit,
    replace_by_folder,
    lambda path: path.write_bytes(b""),
    lambda path: path.write_bytes(b"\x80\x04K\x01."),
    lambda path: path.chmod(0),
]


@pytest.fixture(scope="module")
def compiled_once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("kernels")
    assert run(folder) == [ANSWER, "1"]
    return folder


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_broken_file_heals(compiled_once: Path, damage: Callable[[Path], object]) -> None:
    assert run(compiled_once) == [ANSWER, "0"]
    damage(kernels(compiled_once)[0])
    assert run(compiled_once)[0] == ANSWER
    for path in kernels(compiled_once):
        if path.is_dir():
            path.rmdir()
    run(compiled_once)
    assert run(compiled_once) == [ANSWER, "0"]


def test_a_folder_that_cannot_be_made_costs_time_only(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    assert run(tmp_path / "file" / "cache") == [ANSWER, "1"]


def test_processes_that_compile_at_once_do_not_disturb_each_other(tmp_path: Path) -> None:
    started = [
        subprocess.Popen(
            [sys.executable, "-c", PROGRAM],
            env=command(tmp_path),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for _ in range(3)
    ]
    ended = [each.communicate() for each in started]
    assert [(out.split()[0], err) for out, err in ended] == [(ANSWER, "")] * 3
    assert len(kernels(tmp_path)) == 1
    assert not list(tmp_path.rglob("*.partial"))
    assert run(tmp_path) == [ANSWER, "0"]
