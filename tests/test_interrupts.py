"""Ctrl-C at any moment: one line, the exit code 130, and nothing else."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from scenewright import cli, interruption
from scenewright.batch.worker_pool import START
from thoroughness import few_or_many

pytestmark = pytest.mark.skipif(os.name == "nt", reason="signals")

CONSOLE_SCRIPT = "import sys\nfrom scenewright.cli import main\nsys.exit(main())"
WAYS = {"module": ["-m", "scenewright"], "script": ["-c", CONSOLE_SCRIPT]}
ROUNDS = few_or_many(1, 20)
LINES = ("scenewright: interrupted\n", "scenewright: interrupted: best so far written\n")


def interrupted(way: str, after: float, folder: Path) -> tuple[int, str, str]:
    """Exit code and what was told of a run that is interrupted after some seconds."""
    command = [sys.executable, *WAYS[way], "arrange", "sample:home-flat", "-o", "home.json"]
    process = subprocess.Popen(
        [*command, "--seconds", "60", "--quiet"],
        cwd=folder,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    time.sleep(after)
    process.send_signal(signal.SIGINT)
    told, fault = process.communicate(timeout=60)
    return process.returncode, told, fault


@pytest.mark.parametrize("way", WAYS)
def test_ctrl_c_at_random_moments_ends_with_one_line(way: str, tmp_path: Path) -> None:
    """The interpreter itself needs a moment before our first line, in which it tells its own way
    of being interrupted; nothing of ours may be in that."""
    draw = random.Random(way)
    ours = 0
    for after in [1.5, *(draw.uniform(0.0, 2.0) for _ in range(ROUNDS - 1))]:
        code, told, fault = interrupted(way, after, tmp_path)
        if code == 130:
            assert (told, fault in LINES) == ("", True), (after, fault)
            ours += 1
        else:
            assert after < 1.0, (after, code, fault)
            assert "site-packages" not in fault
            assert "scenewright/cli" not in fault
    assert ours >= 0.4 * ROUNDS
    assert {file.name for file in tmp_path.iterdir()} <= {"home.json"}


def test_nothing_is_imported_before_ctrl_c_is_heard() -> None:
    code = "import sys; before = set(sys.modules); import scenewright.cli; "
    code += "print(sorted(m for m in set(sys.modules) - before if 'scenewright' not in m))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout in ("['__future__']\n", "[]\n")


def test_an_import_is_left_at_once(tmp_path: Path) -> None:
    """An exception out of an import may become another: what it says is not shown."""
    (tmp_path / "slow.py").write_text(
        "import os, signal\ntry:\n    os.kill(os.getpid(), signal.SIGINT)\n"
        "except KeyboardInterrupt:\n    raise ImportError('half imported') from None\n"
    )
    code = "from scenewright import interruption as i; i.install(i.interrupt); import slow"
    paths = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=paths,
        check=False,
        capture_output=True,
        text=True,
    )
    assert (done.returncode, done.stderr) == (130, LINES[0])


def test_what_swallows_the_exception_does_not_keep_the_process() -> None:
    code = "import os, signal, time\nfrom scenewright import interruption as i\n"
    code += "i.PATIENCE = 0.3\ni.install(i.interrupt)\n"
    code += "try: os.kill(os.getpid(), signal.SIGINT)\nexcept KeyboardInterrupt: pass\n"
    code += "print('swallowed', flush=True)\ntime.sleep(30)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=20, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (130, "swallowed\n", LINES[0])


def test_workers_of_a_batch_do_not_hear_it(tmp_path: Path) -> None:
    """The terminal sends Ctrl-C to all processes at once: the parent alone tells it."""
    for number in range(60):
        brief = {"rooms": [{"outline": [[0, 0], [4, 0], [4, 3 + number / 200], [0, 3]]}]}
        (tmp_path / f"{number}.json").write_text(json.dumps(brief))
    command = [
        sys.executable,
        "-m",
        "scenewright",
        "arrange",
        "--batch",
        str(tmp_path),
        "-o",
        str(tmp_path / "out"),
        "--jobs",
        "1",
        "--seconds",
        "60",
        "--quiet",
    ]
    for after in (0.8, 2.5)[: few_or_many(1, 2)]:
        process = subprocess.Popen(
            command,
            text=True,
            start_new_session=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        time.sleep(after)
        os.killpg(process.pid, signal.SIGINT)
        _, fault = process.communicate(timeout=60)
        assert process.returncode == 130
        assert fault.startswith("scenewright: interrupted")
        assert fault.count("\n") == 1
    assert START.startswith("import _signal;")


def test_a_process_of_others_keeps_its_own_handler() -> None:
    before = signal.getsignal(signal.SIGINT)
    assert cli.run(["--version"]) == 0
    assert signal.getsignal(signal.SIGINT) is before
    assert before is not interruption.interrupt
