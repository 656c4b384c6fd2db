"""Lamps, curtains, rugs and screens of a room that was changed."""

from __future__ import annotations

from dataclasses import replace

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.changes.lights import completed_as_before
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.formats import read

NARROW = Brief.model_validate(
    {
        "rooms": [
            {
                "name": "Living room",
                "outline": [[0, 0], [2.0, 0], [2.0, 5], [0, 5]],
                "doors": [{"at": [0.6, 5], "width": 0.8}],
            }
        ]
    }
)


def _tasks(brief):
    rooms = plan_rooms(brief).spaces
    return prepare_rooms(brief, rooms, catalog_of([]), PRESETS["default"], "anneal", 0)[0]


def test_a_room_in_which_nothing_changed_stays_as_it_was():
    brief = read("sample:home-flat")
    solution = solve(brief, steps=200, threads=1)
    for task in _tasks(brief):
        before = [p for p in solution.pieces if p.space == task.space.id]
        furniture = tuple(p for p in before if p.function != "light" or p.fixed)
        after = completed_as_before(task, furniture, before)
        assert {p.id: p for p in after} == {p.id: p for p in before}


def test_a_rug_without_room_beyond_its_sofa_takes_no_other_piece_with_it():
    """Such a rug is left out, and what was placed after it stays."""
    (task,) = _tasks(NARROW)

    def piece(name, size, y, group="g"):
        pose = Pose(1.0, y, 0.0, 1.5707963267948966)
        return Piece(name, name, "", task.space.id, pose, size, group, "seating")

    sofa = piece("sofa", Size(1.9, 0.9, 0.8), 0.46)
    table = piece("coffee_table", Size(1.0, 0.5, 0.4), 1.6)
    rug = piece("rug", Size(1.8, 1.2, 0.01), 1.5)
    chest = piece("chest", Size(0.8, 0.4, 0.8), 3.2, "other")
    found = {p.id: p for p in completed_as_before(task, (rug, sofa, table, chest), [sofa])}
    assert "rug" not in found
    assert [found[p.id] for p in (sofa, table, chest)] == [sofa, table, chest]
    kept = completed_as_before(task, (rug, sofa, table, chest), [sofa, replace(rug, id="rug")])
    assert rug in kept
