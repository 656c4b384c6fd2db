"""Compiled kernels on disk: whatever is wrong with a file, it is compiled and written again."""

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import scenewright
from thoroughness import few_or_many, spread

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


def shut(path: Path) -> None:
    path.chmod(0)


DAMAGES: list[Callable[[Path], object]] = [
    flip_a_bit,
    cut_short,
    replace_by_folder,
    lambda path: path.write_bytes(b""),
    lambda path: path.write_bytes(b"\x80\x04K\x01."),
    shut,
]


SERVING = """
import os, sys
import numba
from scenewright.geometry.compile_clock import compile_clock
from scenewright.geometry.boxes import wrap
numba.njit(lambda x: x + 1.0)(1.0)
for _ in sys.stdin:
    if os.fork():
        os.wait()
        continue
    with compile_clock() as clock:
        print(round(float(wrap(7.0)), 6), clock.kernels, flush=True)
    os._exit(0)
"""
"""The answer and how many were compiled for each line it reads, in a process of its own that has
all modules loaded, a compiler that is ready, and no kernel."""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="forks a process for each run")
def test_a_broken_file_heals(tmp_path: Path) -> None:
    program = [sys.executable, "-W", "error", "-c", SERVING]
    with subprocess.Popen(
        program,
        env=command(tmp_path),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as server:

        def served() -> list[str]:
            assert server.stdin is not None
            assert server.stdout is not None
            server.stdin.write("\n")
            server.stdin.flush()
            return server.stdout.readline().split()

        assert served() == [ANSWER, "1"]
        for number, damage in enumerate(spread(DAMAGES, 3)):
            assert served() == [ANSWER, "0"], number
            damage(kernels(tmp_path)[0])
            answer, compiled = served()
            assert answer == ANSWER, number
            assert compiled == "1" or damage is shut, number
            for path in kernels(tmp_path):
                if path.is_dir():
                    path.rmdir()
            served()
            assert served() == [ANSWER, "0"], number
        assert server.communicate()[1] == ""


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
        for _ in range(few_or_many(2, 3))
    ]
    ended = [each.communicate() for each in started]
    assert [(out.split()[0], err) for out, err in ended] == [(ANSWER, "")] * len(started)
    assert len(kernels(tmp_path)) == 1
    assert not list(tmp_path.rglob("*.partial"))
    assert run(tmp_path) == [ANSWER, "0"]


EACH = """
import numpy as np
from scenewright.geometry.compile_clock import compile_clock
from scenewright.geometry.boxes import wrap
from scenewright.domains.home.terms.packing import size
from scenewright.domains.site.solvers.blocks.perimeter_block import set_along
few, none, no = np.zeros((1, 4)), np.zeros((0, 5)), np.zeros(0, np.int64)
along = few, few, few, (1.0, 1.0, 1.0), no > 0, no, none, np.zeros((0, 8)), no
calls = (wrap, (7.0,)), (size, (4.5, 10.0)), (set_along, along)
for kernel, given in calls:
    with compile_clock() as clock:
        kernel(*given)
    print(clock.kernels)
"""


def test_words_compile_nothing_and_code_what_it_is_part_of(tmp_path: Path) -> None:
    """Edits in a copy of the sources: of a docstring, of a home's constant, of a part of sites."""
    sources = tmp_path / "scenewright"
    unread = shutil.ignore_patterns("__pycache__", "*.json", "samples")
    shutil.copytree(Path(scenewright.__file__).parent, sources, ignore=unread)
    boxes = sources / "geometry/boxes.py"

    def kernels_compiled() -> str:
        given = command(tmp_path / "kernels") | {"PYTHONPATH": str(tmp_path)}
        ended = subprocess.run(
            [sys.executable, "-c", EACH], env=given, capture_output=True, text=True, check=True
        )
        return "".join(ended.stdout.split())

    def edit(file: Path, old: str, new: str) -> None:
        text = file.read_text(encoding="utf-8")
        assert old in text
        file.write_text(text.replace(old, new), encoding="utf-8")

    assert kernels_compiled() == "111"
    edit(boxes, '"""The angle brought into', '"""More words.\n\n    The angle brought into')
    edit(boxes, "@compiled\ndef wrap", "# a comment\n\n@compiled\ndef wrap")
    assert kernels_compiled() == "000", "words are no code"
    edit(sources / "domains/home/terms/packing.py", "MOST_SHARE = 0.55", "MOST_SHARE = 0.56")
    assert kernels_compiled() == "010", "a home's constant is no part of sites"
    edit(
        sources / "domains/site/solvers/blocks/perimeter_block.py",
        "HAIR * HAIR",
        "HAIR * 0.5 * HAIR",
    )
    assert kernels_compiled() == "001", "a part is code of the kernel it is copied into"
    edit(boxes, "angle - 2.0 * math.pi", "angle - 2.5 * math.pi")
    assert kernels_compiled() == "100"
