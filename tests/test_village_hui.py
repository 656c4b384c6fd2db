"""Hui-style blocks of our own making, and the measures of Table 2 and 3 that they are for."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely
from benchmarks.hui_blocks import LANES, brief_of_block, make_hui_blocks
from benchmarks.village_hui import markdown_lines, tell_block
from benchmarks.village_table3 import (
    ToldBlock,
    density,
    facing,
    near_road,
    shuffle_block,
    tell_table2,
    tell_table3,
)

import scenewright as sw
from scenewright.domains.village.learning.real_blocks import clean_blocks, library_of
from scenewright.domains.village.paper.filling import list_candidates
from scenewright.domains.village.standing import place

BLOCKS = clean_blocks(make_hui_blocks(12, 3))
TOLD = [tell_block(block) for block in BLOCKS]


def test_blocks_are_as_the_rules_say() -> None:
    """Nothing overlaps, all stands inside, lanes are 1.5 to 3 m wide, doors are on walls."""
    assert len(BLOCKS) == 12
    gaps = []
    for block in BLOCKS:
        shapes = np.array([shapely.Polygon(ring) for ring in block.houses], object)
        shared = shapely.area(shapely.intersection(shapes[:, None], shapes[None]))
        np.fill_diagonal(shared, 0)
        assert shared.max() < 0.05
        assert shapely.covers(shapely.buffer(block.floor, 0.01), shapes).all()
        away = shapely.distance(shapes[:, None], shapes[None])
        np.fill_diagonal(away, np.inf)
        gaps += away.min(1).tolist()
        on = shapely.distance(shapely.boundary(shapes), shapely.points(np.array(block.doors)))
        assert on.max() < 0.01
    lanes = [gap for gap in gaps if gap > 0.05]
    assert 0.2 < 1 - len(lanes) / len(gaps) < 0.8
    assert min(lanes) > LANES[0] - 0.1
    assert np.median(lanes) < LANES[1]


def test_every_class_is_there_and_depends_on_the_house() -> None:
    classes = np.concatenate([block.classes for block in TOLD])
    for column, count in enumerate((3, 2, 3)):
        assert (np.bincount(classes[:, column], minlength=count) > 0.05 * len(classes)).all()
    brick = classes[:, 0] == 0
    assert brick[classes[:, 2] == 2].mean() > brick[classes[:, 2] == 0].mean() + 0.2


def test_measures_tell_a_shuffled_block_from_a_true_one() -> None:
    """In Table 3 by much; classes stay, so that KL says nothing until they change."""
    rng = np.random.default_rng(0)
    made = [shuffle_block(block, rng) for block in TOLD]
    true, moved = tell_table3(TOLD), tell_table3(made)
    names = list(true)
    assert abs(moved[names[0]] - true[names[0]]) > 0.25
    assert moved[names[1]] != pytest.approx(true[names[1]], rel=0.2)
    assert true[names[2]] > moved[names[2]] + 10
    assert np.mean([facing(a) > facing(b) for a, b in zip(TOLD, made, strict=True)]) > 0.9
    assert max(tell_table2(TOLD, made).values()) == 0.0
    other = [block._replace(classes=block.classes * 0) for block in TOLD]
    assert min(tell_table2(TOLD, other).values()) > 0.2


def test_measures_do_not_change_as_a_block_is_turned() -> None:
    spin = np.array([[np.cos(0.7), np.sin(0.7)], [-np.sin(0.7), np.cos(0.7)]])
    for block in TOLD[:3]:
        floor = shapely.Polygon(shapely.get_coordinates(block.floor.exterior) @ spin)
        rings = tuple(ring @ spin for ring in block.rings)
        turned = ToldBlock(floor, rings, block.doors @ spin, block.classes)
        for measure in (density, near_road, facing):
            assert measure(turned) == pytest.approx(measure(block), abs=0.01)


def test_the_library_holds_real_doors_and_materials() -> None:
    houses = library_of(BLOCKS[:2])
    candidates = list_candidates(houses)
    assert len(candidates) == len(houses)
    assert {one.house.classes[0] for one in candidates} == {0, 1, 2}
    for house, ring in zip(houses, BLOCKS[0].houses, strict=False):
        assert house.door is not None
        wall = shapely.LinearRing(place(house.outline, np.zeros((1, 3)))[0])
        assert wall.distance(shapely.Point(house.door)) < 0.01
        assert shapely.Polygon(ring).area == pytest.approx(house.area, abs=0.01)


def test_a_block_is_drawn_in_the_hui_style(tmp_path: Path) -> None:
    path = tmp_path / "hui.json"
    row = make_hui_blocks(1, 3)[0]
    path.write_text(json.dumps(brief_of_block(row)))
    made = sw.arrange(path)
    houses = [piece for piece in made.solution.pieces if "hui" in piece.asset]
    assert len(houses) == len(row["houses"])
    assert [one for one in made.report.findings if one.kind == "collision"] == []


def test_the_table_has_a_row_a_method() -> None:
    rows = [
        {"case": "real", "metric": "KL area", "ours": 0.1},
        {"case": "ours", "metric": "KL area", "ours": 0.2},
        {"case": "256², area", "metric": "CPU s a step", "ours": 1.0},
    ]
    lines = markdown_lines(rows)
    assert "| ours | 0.2 |" in lines
    assert lines[-1] == "| area | CPU s a step | 1.0 |"
