"""MJCF: what the file says by its own text, and what MuJoCo makes of it."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from flat import flat_brief, flat_solution
from scenewright.core.catalog import Material, Part
from scenewright.core.solution import Solution, unfurnished
from scenewright.formats import write
from scenewright.formats.simulation.solids import column_of, solids_of
from scenewright.geometry.mesh import Mesh, extrude, merge, rotate_mesh
from scenewright.geometry.prisms import prism
from scenewright.geometry.solids import ball, block, rod, slab

OAK = Material("oak", (0.8, 0.7, 0.5))


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("mjcf") / "flat.mjcf.xml"
    write(flat_solution(), path)
    return path


@pytest.fixture(scope="module")
def root(file: Path) -> ElementTree.Element:
    return ElementTree.parse(file).getroot()


@pytest.fixture
def loaded(file: Path) -> tuple[Any, Any, Any]:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    return mujoco, model, data


def part_of(*meshes: Mesh) -> Part:
    return Part(OAK, *merge(meshes))


def test_a_turned_box_is_a_box_and_a_round_bar_a_cylinder() -> None:
    box, bar = solids_of(
        part_of(
            rotate_mesh(block((0, 0.4), (0, 0.2), (0, 0.1)), "z", 0.3),
            rod((1, 1, 0), (1, 1.3, 0.4), 0.02, sides=12),
        )
    )
    assert box.form == "box"
    assert sorted(box.sides) == pytest.approx([0.05, 0.1, 0.2])
    assert bar.form == "cylinder"
    assert bar.sides[:2] == pytest.approx([0.02, 0.25])
    assert bar.middle == pytest.approx([1.0, 1.15, 0.2])


@pytest.mark.parametrize("turned", [0.0, 0.4])
@pytest.mark.parametrize("way", [1, -1])
def test_a_column_is_what_its_triangles_are(turned: float, way: int) -> None:
    turn = np.array([[np.cos(turned), -np.sin(turned)], [np.sin(turned), np.cos(turned)]])
    for corners in (
        [(0, 0), (2, 0), (2, 1), (0, 1)],
        [(0, 0), (1, 0), (2, 0), (2, 1), (0, 1)],
        [(0, 0), (2, 0), (1, 1)],
        [(0, 0), (2, 0), (2.2, 1), (0, 1)],
    ):
        ring = np.array(corners, float) @ turn.T
        (known,) = solids_of(Part(OAK, *prism(ring, 0.5, 3.0)))
        made = column_of(ring[::way], 0.5, 3.0)
        assert made is not None
        assert (made.form, made.volume, made.area) == (
            "box" if len(corners) == 5 else known.form,  # a corner within a side is none
            pytest.approx(known.volume),
            pytest.approx(known.area),
        )
        assert made.middle == pytest.approx(known.middle, abs=1e-6)
        if len(corners) != 5:
            assert sorted(made.sides) == pytest.approx(sorted(known.sides))
    assert column_of(np.array([(0, 0), (2, 0), (1, 1e-5)]), 0.0, 1.0) is None
    assert column_of(np.array([(0, 0), (2, 0), (1, 1.0)]), 1.0, 1.0001) is None


def test_a_board_with_round_corners_is_no_cylinder() -> None:
    (board,) = solids_of(part_of(slab((-0.4, 0.4), (-0.4, 0.4), (0, 0.02), 0.02)))
    assert board.form == "hull"
    assert np.abs(board.corners[:, :2]).max() == pytest.approx(0.4)


def test_the_hollow_of_an_angle_stays_free() -> None:
    ring = np.array([(0, 0), (1, 0), (1, 0.3), (0.3, 0.3), (0.3, 1), (0, 1)])
    pieces = solids_of(part_of(extrude(ring, 0.0, 0.1)))
    assert len(pieces) > 1
    for piece in pieces:
        low = (piece.middle + piece.corners).min(0)
        assert low[0] < 0.35 or low[1] < 0.35
        assert not ((piece.middle + piece.corners)[:, :2] > 0.55).all(1).any()


def test_each_leg_is_a_solid_of_its_own_and_slivers_are_none() -> None:
    legs = [block((x, x + 0.04), (0, 0.04), (0, 0.7)) for x in (0.0, 0.9)]
    sliver = block((0, 1), (0, 1), (0, 1e-7))
    assert len(solids_of(part_of(*legs, sliver, ball(0.1, 0.1, 0.1, (3, 0, 0))))) == 3


def test_nothing_is_kept_from_touching(root: ElementTree.Element) -> None:
    assert root.find("contact") is None
    masks = {geom.get("contype") for geom in root.iter("geom")} - {None}
    assert masks == {"0"}
    touched = [geom.attrib for geom in root.iter("geom") if geom.get("class") == "touched"]
    assert touched
    assert not any("conaffinity" in facts for facts in touched)


def test_names_are_told_apart_and_bytes_are_the_same(
    file: Path, root: ElementTree.Element, tmp_path: Path
) -> None:
    for kind in ("body", "joint", "material", "camera", "site"):
        names = [one.get("name") for one in root.iter(kind)]
        assert len(set(names)) == len(names)
        assert all("/" not in str(name) for name in names)
    write(flat_solution(), tmp_path / "other.mjcf.xml")
    assert (tmp_path / "other.mjcf.xml").read_bytes() == file.read_bytes()


def test_an_empty_home_can_be_written(tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    write(unfurnished(flat_brief()), tmp_path / "empty.mjcf.xml")
    assert mujoco.MjModel.from_xml_path(str(tmp_path / "empty.mjcf.xml")).nbody > 5


def test_every_piece_is_a_body_where_it_was_placed(loaded: tuple[Any, Any, Any]) -> None:
    _, model, data = loaded
    solution: Solution = flat_solution()
    places = {model.body(i).name: data.xpos[i] for i in range(model.nbody)}
    for piece in solution.pieces:
        name = piece.id.replace("/", "-")
        assert places[name][:2] == pytest.approx(piece.pose[:2], abs=1e-4)


def test_what_is_touched_covers_what_is_seen(loaded: tuple[Any, Any, Any]) -> None:
    """The boxes of both, body by body, where nothing of it gives way."""
    _, model, data = loaded
    boxes: dict[tuple[int, int], list[Any]] = {}
    for geom in range(model.ngeom):
        centre, half = model.geom_aabb[geom].reshape(2, 3)
        signs = np.array(np.meshgrid(*[(-1, 1)] * 3)).reshape(3, -1).T
        corners = (centre + signs * half) @ data.geom_xmat[geom].reshape(3, 3).T
        key = (int(model.geom_bodyid[geom]), int(model.geom_group[geom]))
        boxes.setdefault(key, []).append(corners + data.geom_xpos[geom])
    for body in range(1, model.nbody):
        if model.body_jntnum[body] and (body, 2) in boxes and (body, 3) in boxes:
            seen, felt = (np.concatenate(boxes[body, group]) for group in (2, 3))
            assert felt.min(0) == pytest.approx(seen.min(0), abs=0.3)
            assert felt.max(0) == pytest.approx(seen.max(0), abs=0.3)


def test_a_door_can_be_pushed_open_and_a_drawer_pulled(loaded: tuple[Any, Any, Any]) -> None:
    mujoco, model, data = loaded
    mujoco.mj_resetDataKeyframe(model, data, 1)
    leaves = [j for j in range(model.njnt) if model.joint(j).name.endswith(" leaf")]
    drawers = [j for j in range(model.njnt) if " drawer " in model.joint(j).name]
    assert leaves
    for joints, force, aim in ((leaves, 6.0, np.deg2rad(80.0)), (drawers, 20.0, None)):
        for joint in joints[:3]:
            mujoco.mj_resetDataKeyframe(model, data, 1)
            target = aim or 0.8 * model.jnt_range[joint, 1]
            for _ in range(750):
                data.qfrc_applied[:] = 0.0
                data.qfrc_applied[model.jnt_dofadr[joint]] = force
                mujoco.mj_step(model, data)
            assert data.qpos[model.jnt_qposadr[joint]] > target
    assert model.jnt_range[leaves[0], 1] > pi / 2


def test_places_to_begin_at_are_free(loaded: tuple[Any, Any, Any]) -> None:
    """Nothing that can be touched stands within the radius of a site, up to a robot's height."""
    mujoco, model, data = loaded
    assert model.nsite >= 2
    hit = np.zeros(1, np.int32)
    groups = np.array([0, 0, 0, 1, 0, 0], np.uint8)
    for site in range(model.nsite):
        x, y, z = data.site_xpos[site]
        up = np.array([0.0, 0.0, 1.0])
        away = mujoco.mj_ray(model, data, np.array([x, y, z + 0.05]), up, groups, 1, -1, hit)
        assert away < 0 or away > 1.2
