"""Bounded: hostile input is refused, or done, in little memory and little time of the processor."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from hostile_files import Files
from hostile_sizes import costly_answers, costly_documents, costly_homes, room, stars
from scenewright import formats
from scenewright.building import masonry
from scenewright.building.outlines import polygon, ring
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Size
from thoroughness import only_thorough, spread

MOST_MEMORY, LONGEST = 500.0, 5.0
"""Mebibytes beyond an empty run, and seconds of the processor until a refusal."""
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="bounds a process as Linux does")


def runs(files: Files, folder: Path, *options: str) -> dict[str, dict[str, object]]:
    """What each file led to."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
    script = Path(__file__).with_name("bounded_runs.py")
    command = [sys.executable, str(script), *options, *(str(folder / name) for name in files)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=900)
    return {row["name"]: row for row in map(json.loads, done.stdout.splitlines())}


@pytest.mark.parametrize("files", [costly_homes, costly_documents])
def test_hostile_files_are_refused_soon_and_in_little_memory(files: object, tmp_path: Path) -> None:
    assert callable(files)
    for name, row in runs(dict(spread(list(files().items()), 6)), tmp_path).items():
        assert not row["error"], row
        assert float(str(row["memory"])) <= MOST_MEMORY, row
        assert row["done"] or float(str(row["seconds"])) <= LONGEST, row
        assert row["done"] == (name in ("same-walls.json", "fixed.json")), row


@only_thorough
def test_costly_answers_take_little_memory(tmp_path: Path) -> None:
    """No more than half a gigabyte beyond what an ordinary room takes."""
    rows = runs(costly_answers(), tmp_path, "--whole")
    usual = float(str(rows["plain.json"]["memory"]))
    for row in rows.values():
        assert row["done"], row
        assert float(str(row["memory"])) <= usual + MOST_MEMORY, row


@pytest.mark.parametrize("asset", ["bookcase", "shelf_unit", "wall_shelf", "planter", "radiator"])
def test_a_thing_of_any_size_has_few_faces(asset: str) -> None:
    for size in (Size(30.0, 30.0, 30.0), Size(30.0, 0.4, 30.0), Size(30.0, 0.01, 0.01)):
        parts = shipped().assets[asset].mesh(size)
        assert sum(len(part.faces) for part in parts) < 50_000
        width = max(p.vertices[:, 0].max() for p in parts) * 2
        assert width == pytest.approx(30.0)


def test_walls_are_shared_out_without_a_walk_over_all() -> None:
    brief = Brief.model_validate(stars(9))
    walls = masonry.derive_walls(brief, spaces(brief), "0")
    assert len(walls) == 9 * 24
    assert {wall.id for wall in walls} == {
        f"room-{k + 1}/wall-{edge}" for k in range(9) for edge in range(24)
    }


@pytest.mark.parametrize(
    ("document", "fault"),
    [
        (
            {"rooms": [room()], "walls": [{"start": [9000, 0], "end": [9005, 0]}]},
            "reaches 9,000 m beyond all rooms",
        ),
        (
            {"rooms": [room()], "walls": [{"start": [0, 0], "end": [0, -9000]}]},
            "reaches 9,000 m beyond all rooms",
        ),
        ({"rooms": [room(), room(9000, 0)]}, "lies 8,995 m from all other rooms"),
        (
            {"rooms": [room()], "sites": [{"outline": [[0, 0], [50, 0], [50, 50]]}]},
            "are given, but the brief is of a home",
        ),
        (
            {
                "domain": "site",
                "sites": [{"outline": [[0, 0], [50, 0], [50, 50]]}],
                "rooms": [room()],
            },
            "are given, but the brief is of a site",
        ),
        (
            {"domain": "hall", "rooms": [room(wishes=[{"what": "desk"}])]},
            "are given, but the brief is of a hall",
        ),
        (
            {"domain": "hall", "accessible": True, "rooms": [room()]},
            "is given, but the brief is of a hall",
        ),
        ({"rooms": [room(people=5)]}, "is given, but the brief is of a home"),
    ],
)
def test_what_cannot_be_meant_is_one_line(document: object, fault: str, tmp_path: Path) -> None:
    path = tmp_path / "brief.json"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError) as caught:
        formats.read(path)
    assert fault in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize(
    "spike", [[(9, 2)], [(9, 2), (9, 6), (9 + 1e-9, 6), (9 + 1e-9, 2 - 1e-9)], [(2, 2)]]
)
def test_spikes_of_an_outline_are_left_out(spike: list[tuple[float, float]]) -> None:
    corners = [(0, 0), (4, 0), (4, 2), *spike, (4, 2 + 1e-9), (4, 3), (0, 3)]
    assert ring(corners).tolist() == [[0, 0], [4, 0], [4, 3], [0, 3]]


def test_a_neck_of_a_micrometre_is_refused() -> None:
    neck = [(4, 1 + 1e-6), (4, 3), (0, 3)]
    with pytest.raises(InputError, match="narrower than 1 mm"):
        polygon(
            [(0, 0), (4, 0), (4, 1), (6, 1), (6, 0), (9, 0), (9, 3), (6, 3), (6, 1 + 1e-6), *neck]
        )
