"""What the studio costs without a browser: telling while something is searched, and memory."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks.source_digest import ROOT
from scenewright.core.layout import BestLayout
from scenewright.domains import plan_of, solve
from scenewright.formats import read
from scenewright.studio.session import Session
from scenewright.studio.streaming import stream_layouts
from scenewright.workflow.project import open_project

HOLD = "import sys; from benchmarks.studio_runs import hold; hold(sys.argv[1:])"
PAIRS = 2
"""Times that each run is made with and without a listener, of which the least counts."""


class Telling(NamedTuple):
    """What telling of a search costs: its processor seconds by those without, and the processor
    seconds from the last word to the layout, with the share of the run that is."""

    ratio: float
    silence: float
    share: float


def measure_telling(sample: str, seeds: int) -> Telling:
    """Arrange a sample with and without a listener that writes down all it hears."""
    brief = read(f"sample:{sample}")
    plan = plan_of(brief)
    solve(brief, plan=plan, seed=0)
    ratios, silences, shares = list[float](), list[float](), list[float]()
    for seed in range(1, seeds + 1):
        quiet, heard = list[float](), list[float]()
        for _ in range(PAIRS):
            begun = time.process_time()
            solve(brief, plan=plan, seed=seed)
            quiet.append(time.process_time() - begun)
            words, last = stream_layouts(_write), [0.0]

            def hear(best: BestLayout, words: Any = words, last: list[float] = last) -> None:
                words(best)
                last[0] = time.process_time()

            begun = time.process_time()
            solve(brief, plan=plan, seed=seed, watch=hear)
            heard.append(time.process_time() - begun)
            silences.append(begun + heard[-1] - last[0])
            shares.append(silences[-1] / heard[-1])
        ratios.append(min(heard) / min(quiet))
    return Telling(float(np.median(ratios)), max(silences), max(shares))


def measure_sessions(samples: Sequence[str], sessions: int) -> dict[str, float]:
    """Megabytes that a process holds with so many sessions, each with a scene arranged and shown
    in plan and in 3D: now and at most."""
    names = [samples[k % len(samples)] for k in range(sessions)]
    done = subprocess.run(
        [sys.executable, "-c", HOLD, *names], cwd=ROOT, capture_output=True, text=True, check=True
    )
    found: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return found


def hold(names: Sequence[str]) -> None:
    """Begin a session for each sample and print what this process holds."""
    with tempfile.TemporaryDirectory() as folder:
        held = []
        for number, name in enumerate(names):
            session = Session(open_project(Path(folder, f"{number}.studio")), lambda _event: None)
            session.open(f"sample:{name}")
            session.arrange(number)
            session.wait()
            session.state_since(0)
            session.solid()
            held.append(session)
        lines = Path("/proc/self/status").read_text(encoding="utf-8").splitlines()
        found = dict(line.split(":", 1) for line in lines)
        sizes = {key: int(found[key].split()[0]) / 1024 for key in ("VmRSS", "VmHWM")}
        print(json.dumps(sizes))
        for session in held:
            session.close()


def _write(event: dict[str, Any]) -> None:
    json.dumps(event)
