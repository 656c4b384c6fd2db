"""``bench``: JSON alone on the standard output, and an interrupted run keeps what it has."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from scenewright import cli
from scenewright.cli import bench as cli_bench

RECORD = {
    "case": "a",
    "metric": "time",
    "unit": "s",
    "ours": 1.0,
    "baseline": 2.0,
    "baseline_name": "b",
    "ratio": 2.0,
    "runs": 3,
}
TINY = """
import time

def records(quick=False, progress=NoneMORE):
    print("a note")
    for number in range(COUNT):
        yield RECORD | {"case": str(number)}
    open("begun", "w").close()
    while WAITS:
        time.sleep(0.01)
"""


@pytest.fixture(autouse=True)
def _in_a_checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A checkout with nothing but the benchmark ``tiny``."""
    (tmp_path / "src" / "scenewright").mkdir(parents=True)
    (tmp_path / "benchmarks").mkdir()
    (tmp_path / "benchmarks" / "__init__.py").touch()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", list(sys.path))
    for name in [name for name in sys.modules if name.partition(".")[0] == "benchmarks"]:
        monkeypatch.delitem(sys.modules, name)
    yield
    for name in ("benchmarks.tiny", "benchmarks"):
        sys.modules.pop(name, None)


def save_benchmark(count: int | str = 2, waits: bool = False, more: str = "") -> None:
    text = TINY
    for name, value in {"RECORD": RECORD, "COUNT": count, "WAITS": waits, "MORE": more}.items():
        text = text.replace(name, str(value))
    Path("benchmarks/tiny.py").write_text(text, encoding="utf-8")


def test_json_stands_alone_on_the_standard_output(capsys: pytest.CaptureFixture[str]) -> None:
    save_benchmark()
    assert cli.run(["bench", "tiny", "--json"]) == 0
    told = capsys.readouterr()
    assert [row["case"] for row in json.loads(told.out)] == ["0", "1"]
    assert told.err == "a note\n"


def test_records_are_written_as_json_and_as_markdown(capsys: pytest.CaptureFixture[str]) -> None:
    save_benchmark()
    assert cli.run(["bench", "tiny", "-q", "-o", "out/t.json", "-o", "t.md"]) == 0
    assert [row["case"] for row in json.loads(Path("out/t.json").read_text())] == ["0", "1"]
    head, rule, *rows = Path("t.md").read_text().splitlines()
    assert head == "| case | metric | unit | ours | baseline | baseline_name | ratio | runs |"
    assert set(rule) == set("|- ")
    assert rows[1] == "| 1 | time | s | 1.0 | 2.0 | b | 2.0 | 3 |"
    own = "def markdown_lines(records):\n    yield f'{len(records)} records'\n"
    Path("benchmarks/tiny.py").write_text(Path("benchmarks/tiny.py").read_text() + own)
    sys.modules.pop("benchmarks.tiny")
    assert cli.run(["bench", "tiny", "-q", "-o", "t.md"]) == 0
    assert Path("t.md").read_text() == "2 records\n"
    capsys.readouterr()
    assert cli.run(["bench", "tiny", "-o", "t.csv"]) == 2
    assert "t.csv: benchmarks are not written as '.csv'; use .json or .md" in (
        capsys.readouterr().err
    )


@pytest.mark.skipif(os.name == "nt", reason="signals")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("count", [0, 2])
def test_an_interrupted_run_prints_the_records_it_has(number: int, count: int) -> None:
    save_benchmark(count, waits=True)
    command = [sys.executable, "-m", "scenewright", "bench", "tiny", "--json"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + 60
    while not Path("begun").exists() and process.poll() is None and time.monotonic() < end:
        time.sleep(0.02)
    process.send_signal(number)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert [row["case"] for row in json.loads(out)] == ["0", "1"][:count]
    assert err == f"a note\nscenewright: interrupted after {count} records\n"


def test_every_record_says_of_how_many_runs_it_is(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("SCENEWRIGHT_DEBUG", raising=False)
    Path("benchmarks/tiny.py").write_text(
        f"def records(quick=False, progress=None):\n    yield {RECORD | {'runs': 7}!r}\n"
        "    yield {'case': 'b'}\n"
    )
    assert cli.run(["bench", "tiny"]) == 3
    assert "a record lacks metric" in capsys.readouterr().err


def test_full_measures_more_where_there_is_more(capsys: pytest.CaptureFixture[str]) -> None:
    save_benchmark(more=", full=False")
    assert cli.run(["bench", "tiny", "--full", "--quiet"]) == 0
    save_benchmark()
    sys.modules.pop("benchmarks.tiny")
    assert cli.run(["bench", "tiny", "--full"]) == 2
    assert "always measures everything" in capsys.readouterr().err
    assert cli.run(["bench", "tiny", "--full", "--quick"]) == 2
    assert "exclude each other" in capsys.readouterr().err


def test_only_benchmarks_of_real_plans_are_rescaled(capsys: pytest.CaptureFixture[str]) -> None:
    save_benchmark(more=", rescaled=False, full=False", count="int(rescaled) + 2 * int(full)")
    for words, count in (([], 0), (["--rescaled"], 1), (["--rescaled", "--full"], 3)):
        assert cli.run(["bench", "tiny", "--json", *words]) == 0
        assert len(json.loads(capsys.readouterr().out)) == count
    save_benchmark()
    sys.modules.pop("benchmarks.tiny")
    assert cli.run(["bench", "tiny", "--rescaled"]) == 2
    assert "benchmark 'tiny' has no plans to rescale" in capsys.readouterr().err


def test_a_set_is_drawn_by_any_seed_where_one_is_drawn(capsys: pytest.CaptureFixture[str]) -> None:
    save_benchmark(more=", seed=7, count=0", count="seed + 2 * count")
    for words, count in (([], 7), (["--seed", "0", "--count", "1"], 2)):
        assert cli.run(["bench", "tiny", "--json", *words]) == 0
        assert len(json.loads(capsys.readouterr().out)) == count
    save_benchmark()
    sys.modules.pop("benchmarks.tiny")
    assert cli.run(["bench", "tiny", "--seed", "0"]) == 2
    assert "benchmark 'tiny' draws nothing by a seed" in capsys.readouterr().err


def test_all_is_asked_of_benchmarks_that_have_parts(capsys: pytest.CaptureFixture[str]) -> None:
    save_benchmark(more=", everything=False", count="2 * int(everything)")
    assert cli.run(["bench", "tiny", "--json", "--all"]) == 0
    assert len(json.loads(capsys.readouterr().out)) == 2
    save_benchmark()
    sys.modules.pop("benchmarks.tiny")
    assert cli.run(["bench", "tiny", "--all"]) == 2
    assert "leave --all out" in capsys.readouterr().err


def test_benchmarks_are_the_modules_that_can_be_run(root: Path) -> None:
    found = cli_bench.names(root / "benchmarks")
    assert {"home", "hall", "site", "r2v", "batch", "designer"} <= set(found)
    assert not {"home_methods", "hall_malls"} & set(found)
    text = (root / "benchmarks" / "papers.py").read_text("utf-8")
    assert set(re.findall(r'PaperPart\(".*", "(\w+)"\)', text)) <= set(found)


def test_records_of_stages_come_one_by_one() -> None:
    sys.path.insert(0, str(Path(__file__).parent.parent))
    from benchmarks.stages import run_stages, tally

    def halts() -> Iterator[int]:
        yield 1
        yield 2
        raise KeyboardInterrupt

    rows = tally(halts(), lambda items: [RECORD | {"runs": len(items)}])
    assert next(rows)["runs"] == 2
    with pytest.raises(KeyboardInterrupt):
        next(rows)
    told: list[str] = []
    stages = run_stages(
        [("one", lambda: [RECORD]), ("two", halts)], lambda _, name: told.append(name)
    )
    assert next(stages) == RECORD
    assert told == ["one"]
