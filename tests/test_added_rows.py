"""What a term, a pattern, a solver and a format take: one file and one row of another package."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from thoroughness import THOROUGH, only_thorough

PLUGINS = Path(__file__).parent / "plugins"
TERMS = {"site": "SITE"} | ({"home": "HOME", "hall": "HALL"} if THOROUGH else {})
"""Domains that get the term: each compiles its energy anew, that of sites soonest; so do halls for
a pattern."""
ENTRIES = """
[scenewright.terms]
{}
[scenewright.patterns]
hall.zigzag = loft.zigzag:ROW
[scenewright.solvers]
home.handful = loft.handful:ROW
[scenewright.formats]
.tally = loft.tally
""".format("\n".join(f"{domain}.northward = loft.northward:{row}" for domain, row in TERMS.items()))
USED = """
import json, sys
import numpy as np
import scenewright as sw
from scenewright.workflow.lists import rows
from scenewright.domains import presets
briefs = json.load(sys.stdin)

def mean_y(solution):
    placed = [p for p in solution.pieces if p.category == "building"] or solution.pieces
    return float(np.mean([piece.pose.y for piece in placed]))

def room(weight):
    presets("home")["quick"].weights["northward"] = weight
    return sw.solve(sw.Brief.model_validate(briefs["home"]), preset="quick", seed=3, steps=2000)

def site(weight):
    presets("site")["default"].weights["northward"] = weight
    return sw.solve(sw.read("sample:site-courtyards"), solver="sa", seed=1, steps=2000)

free, drawn = site(0.0), site(3.0)
if "home" in sys.argv:
    rooms = room(0.0), room(3000.0)
    assert mean_y(rooms[1]) > mean_y(rooms[0]) + 0.5 and sw.check(rooms[1]).valid
hall = drawn
if "hall" in sys.argv:
    hall = sw.solve(sw.Brief.model_validate(briefs["hall"]), preset="quick", seed=1, steps=600)
few = sw.solve(sw.Brief.model_validate(briefs["home"]), solver="handful", seed=1)
sw.write(few if hall is drawn else hall, "some.tally")
print(json.dumps({
    "free": mean_y(free), "drawn": mean_y(drawn),
    "valid": [sw.check(one).valid for one in (drawn, hall)],
    "terms": [[row["domain"], row["name"]] for row in rows("terms")],
    "solvers": [row["name"] for row in rows("solvers")],
    "patterns": [row["name"] for row in rows("patterns")],
    "places": [[piece.pose.x, piece.pose.y] for piece in hall.pieces],
    "few": len(few.pieces),
    "tally": open("some.tally").read(),
}))
"""


def install(folder: Path, name: str, entries: str) -> dict[str, str]:
    """The environment of a program in which a package has these entry points."""
    info = folder / f"{name}-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(entries)
    paths = [str(folder), str(PLUGINS), *filter(None, [os.environ.get("PYTHONPATH")])]
    return dict(os.environ) | {"PYTHONPATH": os.pathsep.join(paths)}


def brief(domain: str, **more: Any) -> dict[str, Any]:
    outline = [[0, 0], [7, 0], [7, 6], [0, 6]]
    wanted = {"name": "Room", "outline": outline, "doors": [{"at": [3.5, 0], "width": 0.9}]}
    return {"domain": domain, "name": "Room", "rooms": [wanted | more]}


@pytest.fixture(scope="module")
def used(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    demand = {"category": "plinth", "count": 5, "patterns": ["zigzag"], "size": [0.5, 0.5, 1.0]}
    briefs = {"home": brief("home", function="bedroom"), "hall": brief("hall", demands=[demand])}
    folder = tmp_path_factory.mktemp("loft")
    done = subprocess.run(
        [sys.executable, "-c", USED, *TERMS],
        input=json.dumps(briefs),
        capture_output=True,
        text=True,
        cwd=folder,
        env=install(folder, "loft", ENTRIES),
    )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(done.stdout))


def test_a_term_with_data_of_its_own_draws_what_it_weighs(used: dict[str, Any]) -> None:
    assert used["drawn"] > used["free"] + 0.5
    assert used["valid"] == [True, True]
    assert sorted(row[0] for row in used["terms"] if row[1] == "northward") == sorted(TERMS)


def test_a_format_writes_and_a_pattern_is_listed(used: dict[str, Any]) -> None:
    assert "zigzag" in used["patterns"]
    assert len(used["tally"].splitlines()) >= 1


@only_thorough
def test_a_pattern_lays_out_what_asks_for_it(used: dict[str, Any]) -> None:
    assert used["tally"] == "plinth 5\n"
    places = used["places"]
    ahead = [places[k + 1][axis] - places[k][axis] for axis in (0, 1) for k in range(4)]
    turns = [a * b < 0 for a, b in pairwise(ahead)]
    assert all(turns[:3]) or all(turns[4:])


def test_a_solver_is_found_by_its_name(used: dict[str, Any]) -> None:
    assert "handful" in used["solvers"]
    assert used["few"] > 0


@pytest.mark.parametrize(
    ("row", "fault"),
    [("loft.nowhere:ROW", "cannot be loaded"), ("loft.tally:write", "is no TermRow")],
)
def test_a_broken_row_is_named_in_one_line_and_left_out(
    row: str, fault: str, tmp_path: Path
) -> None:
    env = install(tmp_path, "broken", f"[scenewright.terms]\nhome.broken = {row}\n")
    command = [sys.executable, "-m", "scenewright", "list", "terms"]
    done = subprocess.run(command, capture_output=True, text=True, env=env)
    assert done.returncode == 0, done.stderr
    assert "home.broken" in done.stderr
    assert fault in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    assert "walls" in done.stdout or "overlap" in done.stdout
