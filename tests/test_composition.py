"""Faults of composition are counted where they are, and not where they are mended."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.composition import hold
from benchmarks.composition_faults import FAULTS, list_rooms

from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Opening, Space

UP = np.pi / 2
WINDOW = Opening("w", "window", "0", 2.0, 4.0, 1.0, 0.0, 1.2, 0.2, 0.9, 2.1, spaces=("room",))
SLIDING = Opening("d", "door", "0", 4.0, 2.0, 0.0, 1.0, 1.8, 0.2, 0.0, 2.1, spaces=("room",))


def room(functions, *openings):
    outline = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], np.float64)
    return Space("room", "Room", functions, "0", outline, openings=openings)


def piece(category, x, y, heading=UP, size=(1.0, 0.5, 0.8), z=0.0):
    return Piece(
        f"{category}{x}{y}", category, category, "room", Pose(x, y, z, heading), Size(*size)
    )


def count(fault, space, *pieces):
    return FAULTS[fault](list_rooms([space], pieces))


SOFA = piece("sofa", 2, 0.5, UP, (2.0, 0.9, 0.8))
BED = piece("double_bed", 2, 1.1, UP, (1.6, 2.0, 0.5))
HOB = piece("hob_cabinet", 2.0, 0.3, UP, (0.6, 0.6, 0.9))
SINK = piece("sink_cabinet", 3.2, 0.3, UP, (0.6, 0.6, 0.9))
CASES = [
    ("no dining table", ("living",), (SOFA,), (SOFA, piece("round_table", 2, 2))),
    ("two seats in a living room", ("living",), (piece("loveseat", 2, 1),), (SOFA,)),
    (
        "screen too small",
        ("living",),
        (SOFA, piece("tv", 2, 3.9, -UP, (0.9, 0.1, 0.5))),
        (SOFA, piece("tv", 2, 3.9, -UP, (1.4, 0.1, 0.8))),
    ),
    (
        "rug no wider than the sofa",
        ("living",),
        (SOFA, piece("rug", 2, 1.5, UP, (1.8, 1.4, 0.01))),
        (SOFA, piece("rug", 2, 1.5, UP, (2.5, 1.8, 0.01))),
    ),
    (
        "coffee table at the rug's edge",
        ("living",),
        (piece("rug", 2, 2, UP, (2.0, 1.4, 0.01)), piece("coffee_table", 2, 2.4)),
        (piece("rug", 2, 2, UP, (2.0, 1.4, 0.01)), piece("coffee_table", 2, 2.0)),
    ),
    (
        "double bed with one nightstand",
        ("bedroom",),
        (BED, piece("nightstand", 3.1, 0.3)),
        (BED, piece("nightstand", 3.1, 0.3), piece("nightstand", 0.9, 0.3)),
    ),
    (
        "double bed from one side",
        ("bedroom",),
        (piece("double_bed", 0.85, 1.1, UP, (1.6, 2.0, 0.5)),),
        (BED,),
    ),
    (
        "single bed adrift",
        ("bedroom",),
        (piece("single_bed", 2, 1.1, UP, (0.9, 2.0, 0.5)),),
        (piece("single_bed", 0.46, 1.1, UP, (0.9, 2.0, 0.5)),),
    ),
    (
        "hob against the sink",
        ("kitchen",),
        (HOB, piece("sink_cabinet", 2.6, 0.3, UP, (0.6, 0.6, 0.9))),
        (HOB, SINK, piece("base_cabinet", 2.6, 0.3, UP, (0.6, 0.6, 0.9))),
    ),
    (
        "hob at the end",
        ("kitchen",),
        (HOB, SINK, piece("base_cabinet", 2.6, 0.3, UP, (0.6, 0.6, 0.9))),
        (
            *(HOB, SINK, piece("base_cabinet", 2.6, 0.3, UP, (0.6, 0.6, 0.9))),
            piece("drawer_cabinet", 1.5, 0.3, UP, (0.4, 0.6, 0.9)),
        ),
    ),
    (
        "worktop under 0.6 m",
        ("kitchen",),
        (HOB, SINK, piece("fridge", 2.6, 0.3, UP, (0.6, 0.6, 1.9))),
        (HOB, SINK, piece("fridge", 2.6, 0.3, UP, (0.6, 0.6, 0.9))),
    ),
    (
        "worktop under 0.6 m",
        ("kitchen",),
        (HOB, SINK, piece("fridge", 2.0, 3.0, UP, (0.6, 0.6, 0.9))),
        (HOB, SINK, piece("drawer_cabinet", 2.6, 0.3, UP, (0.6, 0.6, 0.9))),
    ),
    ("bare walls", ("bedroom",), (BED,), (BED, piece("picture", 2, 0, z=1.5))),
    (
        "armchair alone",
        ("living",),
        (SOFA, piece("armchair", 3.5, 3.5, UP)),
        (SOFA, piece("armchair", 3.4, 1.6, np.pi)),
    ),
]


@pytest.mark.parametrize(
    ("fault", "functions", "faulty", "mended"), CASES, ids=lambda c: str(c)[:30]
)
def test_a_fault_is_counted_and_its_remedy_is_not(fault, functions, faulty, mended):
    space = room(functions)
    assert count(fault, space, *faulty) == (1, 1)
    assert count(fault, space, *mended) == (0, 1)


def test_openings_want_their_floor():
    space = room(("living",), WINDOW, SLIDING)
    chest = piece("chest_of_drawers", 2, 3.7, -UP)
    assert count("something before a window", space, chest) == (1, 1)
    assert count("something before a window", space, piece("sofa", 2, 2)) == (0, 1)
    assert count("window bare", space) == (1, 1)
    assert count("window bare", space, piece("curtain", 2, 3.95, -UP, z=0.1)) == (0, 1)
    plant = piece("potted_tree", 3.8, 2.8, size=(0.4, 0.4, 1.0))
    assert count("something before a sliding door", space, plant) == (1, 1)
    assert count("something before a sliding door", space) == (0, 1)


def test_faults_turn_with_the_home():
    turn = 0.7
    c, s = np.cos(turn), np.sin(turn)
    space = room(("living",))
    turned = Space("room", "Room", ("living",), "0", space.outline @ np.array([[c, s], [-s, c]]))
    pieces = [SOFA, piece("rug", 2, 1.5, UP, (1.8, 1.4, 0.01)), piece("armchair", 3.5, 3.5)]
    moved = [
        replace(
            p,
            pose=Pose(
                c * p.pose.x - s * p.pose.y,
                s * p.pose.x + c * p.pose.y,
                p.pose.z,
                p.pose.heading + turn,
            ),
        )
        for p in pieces
    ]
    for name in FAULTS:
        assert count(name, space, *pieces) == count(name, turned, *moved), name


def test_what_a_home_holds():
    held = hold(list_rooms([room(("kitchen",))], [HOB, SINK, piece("fridge", 0.5, 0.5), SOFA]))
    assert held["kitchens with hob, sink and fridge"] == 1
    assert held["seats"] == 3
    assert held["pieces"] == 4
    assert held["metres of worktop"] == 0.0


@pytest.mark.parametrize(("height", "metres"), [(0.9, 0.6), (1.9, 0.0)])
def test_over_a_fridge_under_the_worktop_lies_worktop(height, metres):
    fridge = piece("fridge", 2.6, 0.3, UP, (0.6, 0.6, height))
    held = hold(list_rooms([room(("kitchen",))], [HOB, SINK, fridge]))
    assert held["metres of worktop"] == metres
