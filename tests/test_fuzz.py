"""Hostile input, drawn by seeds: one clear line, or an answer; never a traceback, never a heap.

Broken briefs are read, laid out and judged in this process. The worst files are read in a process
of their own that may neither take much memory nor much time of the processor.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import random
import subprocess
import sys
from pathlib import Path

import pytest

from flat import flat_solution
from hostile_documents import DOCUMENTS, broken
from hostile_files import FILES, worst
from scenewright import cli, domains, formats
from scenewright.catalog import models
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import check
from scenewright.formats import solution_json
from thoroughness import few_or_many, spread

SEEDS = few_or_many(8, 40)
"""Broken documents and files of each kind."""
CASES = int(os.environ.get("SCENEWRIGHT_FUZZ", few_or_many(8, 24)))
"""Cases of solutions, encodings and terminals; ``SCENEWRIGHT_FUZZ=2000`` runs two thousand."""
STEPS = 20
READ = """
import json, resource, sys
from pathlib import Path
resource.setrlimit(resource.RLIMIT_DATA, (1536 * 2**20, 1536 * 2**20))
resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
from scenewright import formats
from scenewright.catalog import models
from scenewright.core.errors import InputError
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
    if len(brief.rooms) + len(brief.part.sites if brief.part else ()) > 8:
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


@pytest.fixture(scope="module")
def saved() -> str:
    """A sound solution as text."""
    return solution_json.dumps(flat_solution())


def as_encoded(text: str, draw: random.Random) -> bytes:
    """A text in some encoding, some of them not UTF-8."""
    name = draw.choice(("utf-8", "utf-8", "utf-8-sig", "utf-16", "utf-32", "latin-1", "utf-7"))
    errors = "surrogatepass" if name.startswith("utf") and name != "utf-7" else "replace"
    return text.encode(name, errors if name != "utf-7" else "replace")


@pytest.mark.parametrize("seed", range(CASES))
def test_broken_solutions_at_terminals_of_all_encodings(
    seed: int, saved: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every case is a solution or a brief, in some encoding, given to the command line whose
    output goes to a terminal or a pipe of some encoding: exit 0, 1 or 2, and no traceback."""
    draw = random.Random(f"solution {seed}")
    whole = draw.random() < 0.5
    name = "solution" if whole else draw.choice(tuple(DOCUMENTS))
    suffix, document = (".json", json.loads(saved)) if whole else DOCUMENTS[name]
    path = tmp_path / f"broken{suffix}"
    path.write_bytes(as_encoded(broken(document, draw), draw))
    streams = [_terminal(draw) for _ in range(2)]
    monkeypatch.chdir(tmp_path)
    with contextlib.redirect_stdout(streams[0]), contextlib.redirect_stderr(streams[1]):
        code = cli.run(["check", str(path)])
    written = b"".join(stream.buffer.getvalue() for stream in streams)  # type: ignore[attr-defined]
    assert code in (0, 1, 2), written[-2000:]
    assert b"Traceback" not in written
    assert b"\x1b[31m" not in written


def _terminal(draw: random.Random) -> io.TextIOWrapper:
    """Where a command writes to: bytes of an encoding that may not hold all letters."""
    encoding = draw.choice(("utf-8", "ascii", "cp1252", "latin-1", "cp437"))
    return io.TextIOWrapper(
        io.BytesIO(), encoding=encoding, errors="backslashreplace", write_through=True
    )


@pytest.mark.skipif(sys.platform != "linux", reason="bounds a process as Linux does")
def test_the_worst_files_take_little_memory_and_time(tmp_path: Path) -> None:
    files = dict(spread(list(worst().items()), 1))
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    done = subprocess.run(
        [sys.executable, "-c", READ, *(str(tmp_path / name) for name in files)],
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    heard = dict(json.loads(line) for line in done.stdout.splitlines())
    assert heard.keys() == files.keys()
    for name, told in heard.items():
        assert told or name in ("features.geojson", "rooms.json", "cities.cityjson"), name
        for line in told[:5]:
            clear(line)
    assert "root:" not in done.stdout
