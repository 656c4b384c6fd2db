"""Hostile input, drawn by seeds: one clear line, or an answer; never a traceback, never a heap.

Broken briefs are read, laid out and judged in this process. The worst files are read in a process
of their own that may neither take much memory nor much time of the processor.
"""

from __future__ import annotations

import json
import random
import subprocess
import sys
from pathlib import Path

import pytest

from hostile_documents import DOCUMENTS, broken
from hostile_files import FILES, worst
from scenewright import domains, formats, models
from scenewright.brief import Brief
from scenewright.check import check
from scenewright.errors import InputError
from scenewright.formats import solution_json

SEEDS = 40
"""Broken documents and files of each kind."""
STEPS = 20
READ = """
import json, resource, sys
from pathlib import Path
resource.setrlimit(resource.RLIMIT_DATA, (1536 * 2**20, 1536 * 2**20))
resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
from scenewright import formats, models
from scenewright.errors import InputError
for path in map(Path, sys.argv[1:]):
    try:
        if path.suffix in models.suffixes() and path.suffix not in (".json", ".cityjson"):
            told = [one.reason for one in models.report(path).skipped]
        else:
            formats.read(path)
            told = []
    except InputError as error:
        told = [str(error)]
    print(json.dumps([path.name, told]), flush=True)
"""


def clear(told: str) -> None:
    """One printable line of a length a person reads."""
    assert told
    assert len(told.splitlines()) == 1, told
    assert len(told) < 600, told
    assert told.isprintable(), told


@pytest.mark.parametrize("seed", range(SEEDS))
@pytest.mark.parametrize("name", DOCUMENTS)
def test_broken_documents(name: str, seed: int, tmp_path: Path) -> None:
    suffix, document = DOCUMENTS[name]
    draw = random.Random(f"{name} {seed}")
    path = tmp_path / f"broken{suffix}"
    path.write_text(broken(document, draw), encoding="utf-8", errors="surrogatepass")
    try:
        brief = formats.read(path)
        answered(brief, tmp_path)
    except InputError as error:
        clear(str(error))
    assert {p.name for p in tmp_path.iterdir()} <= {path.name, "out.json"}


def answered(brief: Brief, folder: Path) -> None:
    """Lay out a brief that could be read, judge the answer, write it and read it back."""
    if len(brief.rooms) + len(brief.sites) > 8:
        return
    solution = domains.solve(brief, steps=STEPS, threads=1)
    report = check(solution)
    json.dumps(report.to_dict(), allow_nan=False)
    if brief.domain == "home":
        assert report.valid, str(report)
    formats.write(solution, folder / "out.json")
    assert len(solution_json.read(folder / "out.json").pieces) == len(solution.pieces)


@pytest.mark.parametrize("seed", range(SEEDS))
@pytest.mark.parametrize("name", FILES)
def test_broken_files(name: str, seed: int, tmp_path: Path) -> None:
    suffix, drawn = FILES[name]
    path = tmp_path / f"broken{suffix}"
    path.write_bytes(drawn(random.Random(f"{name} {seed}")))
    try:
        if suffix in models.suffixes():
            for one in models.report(path).skipped:
                clear(one.reason)
        else:
            formats.read(path, keep=True)
    except InputError as error:
        clear(str(error))
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("name", DOCUMENTS)
def test_what_is_broken_here_was_sound(name: str, tmp_path: Path) -> None:
    suffix, document = DOCUMENTS[name]
    path = tmp_path / f"sound{suffix}"
    path.write_text(json.dumps(document))
    answered(formats.read(path), tmp_path)


@pytest.mark.skipif(sys.platform != "linux", reason="bounds a process as Linux does")
def test_the_worst_files_take_little_memory_and_time(tmp_path: Path) -> None:
    files = worst()
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    done = subprocess.run(
        [sys.executable, "-c", READ, *(str(tmp_path / name) for name in files)],
        capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-2000:]
    heard = dict(json.loads(line) for line in done.stdout.splitlines())
    assert heard.keys() == files.keys()
    for name, told in heard.items():
        assert told or name in ("features.geojson", "rooms.json", "cities.cityjson"), name
        for line in told[:5]:
            clear(line)
    assert "root:" not in done.stdout
