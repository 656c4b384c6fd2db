"""Killed at random: ``scenewright bench killed``.

A batch, an evolution and the compiler, each ended by SIGKILL at fifty moments drawn by a seed.
What a run had acknowledged (a row of a batch, an event that was told, a kernel that was kept) has
to be there afterwards and to be whole, nothing may be left half-written under its name, and the
files of others beside it stay byte for byte what they were. Runs on Linux.
"""

from __future__ import annotations

import hashlib
import json
import os
import random
import select
import signal
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

Record = dict[str, Any]
Progress = Callable[[float, str], None]
Work = Callable[[Path, Callable[[str], None]], None]

MOMENTS, QUICK = 50, 4
LONGEST = {"batch": 1.0, "evolve": 0.2, "compile": 0.1}
"""Seconds after which a run is killed, at most, counted from the word it is waited for."""
MOST_WORDS, PATIENCE = 3, 120.0
"""Words of a run that are waited for, at most, and for how many seconds."""
FILES = 60
"""Scenes of a batch."""
KERNELS = 40


class Killed(NamedTuple):
    """What was found after all moments: how many runs were ``alive`` when killed, what they had
    ``acknowledged`` in all, what of that was ``lost``, what was ``half`` written, and ``foreign``
    files that changed."""

    alive: int
    acknowledged: int
    lost: int
    half: int
    foreign: int


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """What was lost, half-written or changed for each of the three."""
    for number, name in enumerate(TARGETS):
        if progress is not None:
            progress(number / len(TARGETS), f"killing {name}")
        with tempfile.TemporaryDirectory() as top:
            found = kill_often(name, Path(top), QUICK if quick else MOMENTS)
        for metric, value in found._asdict().items():
            yield {
                "case": name,
                "metric": metric,
                "unit": "",
                "ours": value,
                "baseline": None,
                "baseline_name": "",
                "ratio": None,
                "runs": QUICK if quick else MOMENTS,
            }


def kill_often(name: str, top: Path, moments: int, seed: int = 0) -> Killed:
    """Begin the same work again and again, each time killed at a random moment."""
    prepare, work, inspect = TARGETS[name]
    prepare(top)
    foreign = plant_foreign_files(top)
    draw, said, alive, lost, half = random.Random(f"{name} {seed}"), list[str](), 0, 0, 0
    told = 0
    for _ in range(moments):
        words, seconds = draw.randint(0, MOST_WORDS), draw.uniform(0.0, LONGEST[name])
        more, ended = kill_run(top, work, words, seconds)
        said, told = said + more, told + len(more)
        alive += not ended
        missing, broken = inspect(top, said)
        lost, half = lost + missing, half + broken
    return Killed(alive, told, lost, half, count_changed(foreign))


def kill_run(top: Path, work: Work, words: int, seconds: float) -> tuple[list[str], bool]:
    """What a fork of this process acknowledged until it was killed, so many ``seconds`` after so
    many ``words``, and whether it had ended by itself before."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(reader)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            work(top, lambda word: _say(writer, word))
            os._exit(0)
        finally:
            os._exit(1)
    os.close(writer)
    said, begun = b"", time.monotonic()
    while said.count(b"\n") < words and time.monotonic() - begun < PATIENCE:
        if select.select([reader], [], [], 0.1)[0]:
            more = os.read(reader, 65536)
            said += more
            if not more:
                break
    time.sleep(seconds)
    ended = os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT | os.WNOHANG) is not None
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    with os.fdopen(reader, "rb") as answers:
        lines = (said + answers.read()).split(b"\n")[:-1]
    return [line.decode() for line in lines], ended


def _say(writer: int, word: str) -> None:
    os.write(writer, word.encode() + b"\n")


def plant_foreign_files(top: Path) -> dict[Path, str]:
    """Files of others where the work is done, and their digests."""
    out = top / "out"
    for place in (".parts/mine.txt", "notes.txt", ".scenewright-parts-x/mine.txt", "deep/own.json"):
        (out / place).parent.mkdir(parents=True, exist_ok=True)
        (out / place).write_text(f"mine: {place}")
    inputs = list((top / "in").glob("*")) if (top / "in").exists() else []
    return {
        path: digest_of(path) for path in [*inputs, *out.rglob("*.txt"), *out.rglob("own.json")]
    }


def count_changed(known: dict[Path, str]) -> int:
    """How many files are gone or changed."""
    return sum(digest_of(path) != digest for path, digest in known.items())


def digest_of(path: Path) -> str:
    """A digest of a file's content; empty if it is not there."""
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else ""


def _prepare_batch(top: Path) -> None:
    import scenewright.batch  # noqa: F401 - forks have it loaded

    (top / "in").mkdir()
    for k in range(FILES):
        outline = [[0, 0], [1.6 + 0.02 * k, 0], [1.6 + 0.02 * k, 2], [0, 2]]
        door = {"at": [0.8, 0], "width": 0.8, "swing": "out"}
        room = {"name": "WC", "function": "toilet", "outline": outline, "doors": [door]}
        (top / "in" / f"wc-{k:02}.json").write_text(json.dumps({"rooms": [room]}))


def _work_batch(top: Path, say: Callable[[str], None]) -> None:
    from scenewright.batch import batch

    batch(
        str(top / "in"), top / "out", jobs=1, steps=50,
        progress=lambda row, _done, _total, before: None if before else say(Path(row.file).stem),
    )  # fmt: skip


def _inspect_batch(top: Path, said: list[str]) -> tuple[int, int]:
    """Acknowledged results that are missing or unknown to the ledger; results that do not read."""
    from scenewright.batch.jobs import BatchOptions, list_jobs
    from scenewright.batch.ledger import Ledger

    options = BatchOptions((".json",), "default", None, None, 50, 0, False)
    lost, out = 0, top / "out"
    with Ledger(out) as ledger:
        for job in list_jobs([top / "in"], out, options):
            lost += job.name in said and ledger.find(job) is None
    return lost, sum(not _is_whole(path) for path in out.glob("*.json"))


def _is_whole(path: Path) -> bool:
    try:
        return bool(json.loads(path.read_bytes())["pieces"])
    except (ValueError, KeyError):
        return path.name == "summary.json" and path.stat().st_size > 0


def _prepare_evolve(top: Path) -> None:
    from scenewright.workflow.evolution.population import BreedingPlan
    from scenewright.workflow.evolve import evolve

    (top / "out").mkdir()
    few = BreedingPlan(first=4, each=2, rounds=1, brood=4)
    with evolve("sample:home-room", top / "out" / "my.evolution", breeding=few) as evolution:
        evolution.ask()


def _work_evolve(top: Path, say: Callable[[str], None]) -> None:
    from scenewright.engine.preference.events import Stars
    from scenewright.workflow.evolution.log import EvolutionLog
    from scenewright.workflow.evolve import resume_evolution

    fresh = EvolutionLog(top / "out" / f"fresh-{time.time_ns()}.evolution")
    fresh.begin({"brief": "{}", "seed": "0", "breeding": "[]"})
    fresh.close()
    with resume_evolution(top / "out" / "my.evolution") as evolution:
        for k in range(100_000):
            evolution.tell(Stars(k % 3, 1 + k % 5, 0))
            say(str(len(evolution.events)))


def _inspect_evolve(top: Path, said: list[str]) -> tuple[int, int]:
    """Events that were acknowledged and are not there; new logs that cannot be opened."""
    from scenewright.core.errors import InputError
    from scenewright.workflow.evolution.log import EvolutionLog
    from scenewright.workflow.evolve import resume_evolution

    with resume_evolution(top / "out" / "my.evolution") as evolution:
        lost = max(int(said[-1]) - len(evolution.events), 0) if said else 0
    half = 0
    for path in (top / "out").glob("fresh-*.evolution"):
        try:
            EvolutionLog(path).close()
        except InputError:
            half += 1
        path.unlink()
    return lost, half


def _prepare_compile(top: Path) -> None:
    import scenewright.geometry.kernel_store  # noqa: F401 - forks have it loaded

    (top / "out").mkdir()


def _work_compile(top: Path, say: Callable[[str], None]) -> None:
    from scenewright.geometry.kernel_store import save

    folder = top / "out" / "kernels"
    for k in range(KERNELS):
        if not (folder / f"k{k}.kernel").exists() and save(folder / f"k{k}.kernel", _payload(k)):
            say(str(k))
        time.sleep(0.02)


def _payload(number: int) -> bytes:
    return random.Random(number).randbytes(200_000 + number)


def _inspect_compile(top: Path, said: list[str]) -> tuple[int, int]:
    """Kernels that were kept and are gone; kernels that do not read as they were written. Some are
    removed, so that the next run has something to do."""
    from scenewright.geometry.kernel_store import unsealed

    folder = top / "out" / "kernels"
    lost = sum(not (folder / f"k{word}.kernel").is_file() for word in said)
    half = 0
    for path in sorted(folder.glob("*.kernel")):
        half += unsealed(path.read_bytes()) != _payload(int(path.stem[1:]))
        path.unlink()
    said.clear()
    return lost, half


Prepare = Callable[[Path], None]
Inspect = Callable[[Path, list[str]], tuple[int, int]]
TARGETS: dict[str, tuple[Prepare, Work, Inspect]] = {
    "batch": (_prepare_batch, _work_batch, _inspect_batch),
    "evolve": (_prepare_evolve, _work_evolve, _inspect_evolve),
    "compile": (_prepare_compile, _work_compile, _inspect_compile),
}  # fmt: skip
"""What is killed: how it is prepared, done, and looked at afterwards."""
