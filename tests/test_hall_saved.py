"""Saved halls that were damaged: each is drawn and judged, or refused in one line."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from hall_briefs import TWO, document, hall
from scenewright import cli

Document = dict[str, Any]
SMALL = [
    {"category": "bench", "count": 2, "zone": "a"},
    {"category": "showcase", "count": 3, "zone": "b"},
]
PLACES = {"zones": TWO, "demands": SMALL}
CROSSED: list[list[float]] = [[0, 0], [6, 8], [6, 0], [0, 8]]
FLAT: list[list[float]] = [[1, 1], [2, 2], [3, 3]]


def _zones(outline: list[list[float]]) -> Callable[[Document], object]:
    return lambda d: [z.update(outline=outline) for z in d["graph"]["zones"]]


def _each(key: str, **values: Any) -> Callable[[Document], object]:
    return lambda d: [row.update(values) for row in d["graph"][key]]


def _pieces(**values: Any) -> Callable[[Document], object]:
    return lambda d: [piece.update(values) for piece in d["pieces"]]


DAMAGE: dict[str, Callable[[Document], object]] = {
    "nothing": lambda _: None,
    "no graph": lambda d: d.pop("graph"),
    "an empty graph": lambda d: d.update(graph=None),
    "crossed zones": _zones(CROSSED),
    "flat zones": _zones(FLAT),
    "zones of one point": _zones([[1, 1]] * 3),
    "a spike": _zones([[0, 0], [6, 0], [6, 8], [50, 50], [6, 8], [0, 8]]),
    "a crossed hole": _each("zones", holes=[CROSSED]),
    "a zone elsewhere": _each("zones", space="nowhere"),
    "groups of no zone": _each("groups", zone="nowhere"),
    "groups of no hall": _each("groups", space="nowhere"),
    "groups of no objects": _each("groups", objects=["x"]),
    "groups without parts": _each("groups", parts=[]),
    "a pattern unknown": _each("groups", pattern="heap"),
    "tiny pieces": _pieces(size=[1e-9, 1e-9, 1e-9]),
    "all in one place": _pieces(pose=[5, 5, 0, 0]),
    "models unknown": _pieces(asset="x"),
    "kinds unknown": _pieces(category="x"),
    "no pieces": lambda d: d.update(pieces=[]),
    "no tours": lambda d: d.update(tours=[]),
    "tours without widths": lambda d: [t.update(widths=[]) for t in d["tours"]],
    "stops of no group": lambda d: [t.update(stops=[["x", 10**6]]) for t in d["tours"]],
    "floors of no hall": lambda d: d.update(floors={"x": 1.0}),
    "no energies": lambda d: d.update(energies={}),
    "a solver from outside": lambda d: d.update(solver="given"),
}
REFUSED: dict[str, tuple[Callable[[Document], object], str]] = {
    "a zone that is not a number": (_zones([[float("nan"), 0], [1, 0], [1, 1]]), "NaN is not"),
    "a zone of two corners": (_zones([[0, 0], [1, 1]]), "needs at least 3 corners"),
    "a zone a light year wide": (_zones([[0, 0], [1e16, 0], [0, 1]]), "lengths are metres"),
    "pieces of no size": (_pieces(size=[0, 0, 0]), "more than 0"),
}


@pytest.fixture(scope="module")
def laid(tmp_path_factory: pytest.TempPathFactory) -> Document:
    folder = tmp_path_factory.mktemp("laid")
    brief = folder / "hall.json"
    brief.write_text(json.dumps(document("small", hall(**PLACES))))
    path = folder / "laid.json"
    assert cli.run(["arrange", str(brief), "-o", str(path), "--steps", "300", "-q"]) in (0, 1)
    found: Document = json.loads(path.read_text())
    return found


@pytest.fixture
def damaged(laid: Document, tmp_path: Path) -> Callable[[Callable[[Document], object]], Path]:
    def write(damage: Callable[[Document], object]) -> Path:
        found = copy.deepcopy(laid)
        damage(found)
        path = tmp_path / "saved.json"
        path.write_text(json.dumps(found))
        return path

    return write


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_a_damaged_hall_is_judged_explained_and_drawn(
    damage: Callable[[Document], object],
    damaged: Callable[[Callable[[Document], object]], Path],
    tmp_path: Path,
) -> None:
    path = str(damaged(damage))
    assert cli.run(["check", path]) in (0, 1)
    assert cli.run(["explain", path]) == 0
    drawn = [tmp_path / f"again{suffix}" for suffix in (".json", ".svg", ".glb")]
    outputs = [part for file in drawn for part in ("-o", str(file))]
    assert cli.run(["adjust", path, *outputs]) in (0, 1)
    assert all(file.stat().st_size > 500 for file in drawn)


@pytest.mark.parametrize(
    "damage", ["no graph", "flat zones", "groups of no zone", "a solver from outside"]
)
def test_a_damaged_hall_is_laid_out_again(
    damage: str, damaged: Callable[[Callable[[Document], object]], Path], tmp_path: Path
) -> None:
    path, out = str(damaged(DAMAGE[damage])), str(tmp_path / "again.json")
    again = ["adjust", path, "-o", out, "--again", "hall", "--steps", "100"]
    assert cli.run(again) in (0, 1)


@pytest.mark.parametrize(("damage", "told"), REFUSED.values(), ids=REFUSED)
@pytest.mark.parametrize("verb", [["check"], ["explain"], ["adjust", "-o", "again.svg"]])
def test_what_cannot_be_read_is_one_line(
    verb: list[str],
    damage: Callable[[Document], object],
    told: str,
    damaged: Callable[[Callable[[Document], object]], Path],
    capsys: pytest.CaptureFixture[str],
) -> None:
    path = str(damaged(damage))
    assert cli.run([verb[0], path, *verb[1:]]) == 2
    error = capsys.readouterr().err.strip()
    assert "\n" not in error
    assert told in error


def test_an_unknown_solver_is_refused_when_it_is_to_solve(
    damaged: Callable[[Callable[[Document], object]], Path],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    path, out = str(damaged(lambda d: d.update(solver="x"))), str(tmp_path / "again.json")
    assert cli.run(["adjust", path, "-o", out, "--again", "hall"]) == 2
    assert "unknown solver 'x'" in capsys.readouterr().err


def test_a_piece_moved_out_of_its_hall_is_named(
    damaged: Callable[[Callable[[Document], object]], Path],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    path, out = damaged(lambda _: None), tmp_path / "moved.json"
    piece = next(p["id"] for p in json.loads(path.read_text())["pieces"] if "showcase" in p["id"])
    assert cli.run(["adjust", str(path), "-o", str(out), "--move", f"{piece}=-30,4"]) == 2
    error = capsys.readouterr().err
    assert f"'{piece}' cannot stand at (-30, 4)" in error
    assert "'hall' lies within (0, 0) and (12, 8)" in error
    assert not out.exists()
