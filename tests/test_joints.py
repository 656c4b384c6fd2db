"""Bodies of models: what moves, about what, and that it stays clear of the rest."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from scenewright.building.joinery import parts as opening_parts
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Asset, Part, transform_part
from scenewright.core.space import Opening
from scenewright.geometry.joints import Joint, transform_joint
from scenewright.geometry.mesh import Floats
from thoroughness import spread


@pytest.fixture(scope="module")
def moving() -> list[Asset]:
    """Models that have moving parts: two of each kind, all of them in the thorough check."""
    kinds: dict[str, list[Asset]] = {}
    for asset in catalog_of(()).assets.values():
        kinds.setdefault(asset.category, []).append(asset)
    chosen = [asset for rows in kinds.values() for asset in spread(rows, 2)]
    return [asset for asset in chosen if any(part.joint for part in asset.mesh(asset.usual))]


def moved(part: Part, joint: Joint, value: float) -> Floats:
    """The corners of a part whose joint stands at a value (Rodrigues 1840)."""
    axis, by = np.array(joint.axis), value - joint.at
    if joint.kind == "slide":
        return np.asarray(part.vertices + by * axis)
    local = part.vertices - joint.pivot
    along = np.outer(local @ axis, axis)
    turned = along + np.cos(by) * (local - along) + np.sin(by) * np.cross(axis, local)
    return np.asarray(turned + joint.pivot)


def bodies(parts: tuple[Part, ...]) -> dict[Joint, list[Part]]:
    found: dict[Joint, list[Part]] = {}
    for part in parts:
        if part.joint is not None:
            found.setdefault(part.joint, []).append(part)
    return found


def test_bodies_of_models_have_their_own_names_and_limits_that_hold(moving: list[Asset]) -> None:
    assert len(moving) > 40
    for asset in moving:
        joints = [*bodies(asset.mesh(asset.usual))]
        assert len({joint.body for joint in joints}) == len(joints), asset.id
        for joint in joints:
            assert joint.lower <= joint.at <= joint.upper, asset.id
            assert joint.lower < joint.upper, asset.id
            assert np.linalg.norm(joint.axis) == pytest.approx(1.0), asset.id


def test_a_front_opens_out_of_its_model_and_not_into_the_floor(moving: list[Asset]) -> None:
    for asset in (asset for asset in moving if "corner" not in asset.category):
        box = np.array(asset.usual[:2]) / 2
        for joint, parts in bodies(asset.mesh(asset.usual)).items():
            if joint.body.split()[0] in ("door", "drawer", "flap"):
                opened = np.concatenate([moved(p, joint, joint.upper) for p in parts])
                assert (np.abs(opened[:, :2]) - box).max() > 0.05, asset.id
                assert opened[:, 2].min() > -0.03, asset.id


@pytest.mark.parametrize(("hinge", "swing"), [(-1, 1), (1, 1), (-1, -1), (1, -1)])
@pytest.mark.parametrize("width", [0.9, 1.6])
def test_a_leaf_shut_fills_its_opening_and_lies_in_the_wall(
    hinge: int, swing: int, width: float
) -> None:
    door = Opening("d", "door", "0", 0, 0, 1, 0, width, 0.12, 0.0, 2.05, hinge=hinge, swing=swing)
    found = bodies(opening_parts(door))
    assert len(found) == (1 if width < 1.3 else 2)
    shut = np.concatenate([moved(p[0], joint, 0.0) for joint, p in found.items()])
    low, high = shut.min(0), shut.max(0)
    assert low[0] == pytest.approx(-width / 2, abs=0.04)
    assert high[0] == pytest.approx(width / 2, abs=0.04)
    assert max(abs(low[1]), abs(high[1])) <= 0.06 + 1e-9
    for joint, parts in found.items():
        wide = np.concatenate([moved(p, joint, pi / 2) for p in parts])
        assert wide[:, 1].mean() * swing > 0.2


def test_a_window_opens_into_the_room_and_stays_off_its_sill() -> None:
    window = Opening("w", "window", "0", 0, 0, 1, 0, 1.8, 0.3, 0.9, 2.3)
    found = bodies(opening_parts(window))
    assert len(found) == 2
    still = np.concatenate([p.vertices for p in opening_parts(window) if p.joint is None])
    board = still[still[:, 1] > 0.1][:, 2].max()
    for joint, parts in found.items():
        corners = np.concatenate([moved(p, joint, 1.2) for p in parts])
        assert corners[:, 1].max() > 0.4
        assert corners[:, 2].min() > board


def test_a_mirrored_door_opens_to_the_same_side_about_its_other_end() -> None:
    asset = catalog_of(()).assets["base_cabinet"]
    door = next(p for p in asset.mesh(asset.usual) if p.joint)
    other = transform_part(door, np.diag([-1.0, 1.0, 1.0]))
    here, there = (moved(p, p.joint, 1.0) for p in (door, other) if p.joint)
    np.testing.assert_allclose(there, here * (-1.0, 1.0, 1.0), atol=1e-12)


def test_a_slide_is_stretched_with_its_model() -> None:
    joint = Joint("drawer", "slide", (0.0, 0.2, 0.3), (0.0, 1.0, 0.0), 0.0, 0.4)
    assert transform_joint(joint, np.diag([1.0, 1.5, 1.0])).upper == pytest.approx(0.6)
