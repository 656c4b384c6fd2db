"""What is told while something is dragged is what the referee says once it is put there."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

import scenewright as sw
from scenewright.workflow.judging import MoveJudge

LOCAL = {"collision", "out_of_bounds", "blocked_door", "setback", "spacing"}
SCENES = {"home-flat": 300, "hall-shop": 1500, "site-square": 2}


@pytest.mark.parametrize("name", SCENES)
def test_a_move_is_judged_as_the_whole_scene_would_be(name: str) -> None:
    scene = sw.solve(sw.read(f"sample:{name}"), steps=SCENES[name])
    judge, rng = MoveJudge(scene), random.Random(name)
    before = {(f.kind, f.piece, f.other) for f in sw.check(scene).findings}
    movable = [p for p in scene.pieces if p.function not in ("partition", "landmark")]
    movable = [p for p in movable if p.on is None and p.category not in ("tree", "lamp", "light")]
    alone = [p for p in movable if not any(q.on == p.id for q in scene.pieces)]
    for piece in rng.sample(alone, 4):
        pose = piece.pose._replace(
            x=piece.pose.x + rng.uniform(-1, 1), y=piece.pose.y + rng.uniform(-1, 1), heading=0.3
        )
        told = judge.find_new({piece.id: (pose.x, pose.y, pose.heading)})
        moved = [replace(p, pose=pose) if p.id == piece.id else p for p in scene.pieces]
        whole = sw.check(replace(scene, pieces=tuple(moved))).findings
        new = {(f.kind, f.piece, f.other) for f in whole} - before
        said = {(f.kind, f.piece, f.other) for f in told}
        assert {row for row in said if row[0] in LOCAL} == {row for row in new if row[0] in LOCAL}
