"""The referee on collisions and on what leaves its room, at its tolerances."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from judged_rooms import NORTH, SOUTH, judge, kinds, piece, rectangle, room
from scenewright.core.scene import Pose


@pytest.mark.parametrize(("gap", "found"), [(0.0, set()), (-0.009, set()), (-0.011, {"collision"})])
def test_collision_tolerance(gap, found):
    assert kinds(judge(piece("box", 0.5, 2.5), piece("box", 1.5 + gap, 2.5))) == found


@pytest.mark.parametrize(("z", "found"), [(0.98, {"collision", "sunk"}), (0.995, set())])
def test_heights_part_pieces(z, found):
    table, lamp = piece("table", 1, 2, id="t"), piece("lamp", 1, 2, 0.2, 0.2, 0.4, z=z, on="other")
    report = judge(table, lamp, piece("box", 3, 2, id="other"))
    assert ("collision" in kinds(report)) == ("collision" in found)


def test_collision_tells_depth_area_and_names():
    (found,) = judge(piece("box", 0.5, 2.5, id="p"), piece("box", 1.3, 2.25, id="q")).findings
    assert (found.piece, found.other) == ("p", "q")
    assert found.amount == pytest.approx(0.2)
    assert found.area == pytest.approx(0.2 * 0.75)
    assert "0.20 m" in found.message


def test_rugs_and_curtains_collide_with_nothing():
    rug = piece("rug", 2, 2, 2, 1.5, 0.02)
    curtain = piece("curtain", 1, 2.95, 1.5, 0.1, 2.3, heading=SOUTH)
    assert judge(rug, curtain, piece("box", 1, 2.5)).valid
    assert not judge(piece("rug", 2, 2, 1, 1, 0.5), piece("box", 2, 2)).valid


@pytest.mark.parametrize(("out", "valid"), [(0.5, True), (0.10, True), (0.03, False)])
def test_a_chair_goes_under_its_table_but_not_its_back(out, valid):
    """The chair faces the table; ``out`` is how far its back end stays outside."""
    table = piece("table", 2, 2, 1.4, 0.8, 0.75)
    chair = piece("chair", 2, 1.6 - out + 0.25, 0.45, 0.5, 0.9, heading=NORTH)
    assert judge(table, chair).valid == valid


def test_a_chair_goes_under_nothing_else_and_a_hob_into_its_counter():
    assert "collision" in kinds(judge(piece("box", 2, 2), piece("chair", 2, 1.5, 0.4, 0.4)))
    counter, hob = piece("counter", 2, 2.7, 2, 0.6, 0.9), piece("hob", 2, 2.7, 0.6, 0.5, 0.06)
    assert judge(counter, replace(hob, pose=hob.pose._replace(z=0.88), on=counter.id)).valid


def test_what_stands_on_another_is_no_collision_but_must_not_sink():
    table = piece("table", 2, 2, h=0.7, id="t")
    lamp = piece("lamp", 2, 2, 0.2, 0.2, 0.4, z=0.685, on="t", id="l")
    assert judge(table, lamp).valid
    assert kinds(judge(table, replace(lamp, pose=lamp.pose._replace(z=0.6)))) == {"sunk"}
    assert kinds(judge(table, replace(lamp, pose=lamp.pose._replace(z=0.73)))) == {"floating"}
    assert kinds(judge(table, replace(lamp, pose=Pose(2.52, 2, 0.7, 0)))) == {"floating"}
    assert kinds(judge(lamp)) == {"floating"}


@pytest.mark.parametrize(("x", "found"), [(0.5, set()), (0.491, set()), (0.489, {"out_of_bounds"})])
def test_out_of_bounds_tolerance(x, found):
    assert kinds(judge(piece("box", x, 2.4))) == found


def test_holes_ceilings_and_corners_are_out_of_bounds():
    column = (rectangle(1, 1, 1.4, 1.4)[::-1],)
    pillar = room(holes=column)
    assert kinds(judge(piece("box", 1.95, 2.1), spaces=(pillar,))) == set()
    (found,) = judge(piece("box", 1.2, 1.6, 0.2, 0.6), spaces=(pillar,)).findings
    assert found.kind == "out_of_bounds"
    (found,) = judge(piece("box", 1, 2, h=2.62)).findings
    assert found.kind == "out_of_bounds"
    assert found.amount == pytest.approx(0.02)
    corner = room(outline=np.array([[0, 0], [4, 0], [4, 1.5], [2, 1.5], [2, 3], [0, 3]], float))
    assert kinds(judge(piece("box", 2, 2), spaces=(corner,))) == {"out_of_bounds"}
