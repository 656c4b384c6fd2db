"""The benchmark of MuJoCo models: it tells stable things from falling ones, what opens from what is
stuck."""

from __future__ import annotations

import pytest

pytest.importorskip("mujoco")

from benchmarks.mujoco import list_joints, opens, simulate

import mujoco
from flat import flat_solution

SHUT = """<mujoco><compiler angle="radian" autolimits="true"/><worldbody>
<geom type="plane" size="0 0 1"/>
<body name="chest" pos="0 0 0.5"><geom type="box" size="0.4 0.2 0.3" pos="0 -0.25 0"/>
<body name="chest drawer 1"><joint name="chest drawer 1" type="slide" axis="0 1 0" range="0 0.4"
damping="6"/><geom type="box" size="0.3 0.01 0.1"/></body></body>
<body name="wall" pos="0 {away} 0.5"><geom type="box" size="1 0.1 0.5"/></body>
</worldbody><keyframe><key qpos="0"/><key qpos="0"/></keyframe></mujoco>"""


@pytest.mark.parametrize(("away", "free"), [(0.8, True), (0.3, False)])
def test_a_drawer_before_a_wall_is_stuck(away: float, free: bool) -> None:
    model = mujoco.MjModel.from_xml_string(SHUT.format(away=away))
    assert list_joints(model) == ([], [0])
    assert opens(model, mujoco.MjData(model), 0) is free


def test_a_flat_is_simulated() -> None:
    found = simulate(flat_solution())
    assert found.free > 0
    assert found.leaves > 0
    assert not found.stuck_leaves
    assert len(found.moved) <= 1
