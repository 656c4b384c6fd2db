"""The designer as judge: what the guidelines measure, whose energy is whose, and the sheet."""

from __future__ import annotations

from math import pi
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from benchmarks import designer_measures as measures
from benchmarks.designer import NEAR, homes, lines, records, values
from benchmarks.designer_blind import DESIGNER, OURS, BlindPair, draw_home, open_key, shuffle_pairs
from benchmarks.designer_guidelines import GUIDELINES
from benchmarks.designer_rooms import Seen
from benchmarks.designer_sheet import sheet

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief, Room
from scenewright.core.scene import Piece, Pose, Size

SOFA, TV = Size(2.0, 0.9, 0.8), Size(1.0, 0.2, 0.6)


def pose(at: list[float], heading: float) -> Pose:
    return Pose(at[0], at[1], 0.0, heading)


def seen(rows: list[tuple[str, float, float, float, Size]], turn: float = 0.0) -> Seen:
    """A room of 5 x 4 m, its door at the left, its window at the right, turned about (0, 0)."""

    def at(x: float, y: float) -> list[float]:
        return [
            float(np.cos(turn) * x - np.sin(turn) * y),
            float(np.sin(turn) * x + np.cos(turn) * y),
        ]

    room = Room.model_validate(
        {
            "id": "room",
            "function": "bedroom",
            "outline": [at(0, 0), at(5, 0), at(5, 4), at(0, 4)],
            "doors": [{"at": at(0, 0.7), "width": 0.8}],
            "windows": [{"at": at(5, 2), "width": 1.6, "sill": 0.9}],
        }
    )
    space = spaces(Brief(rooms=[room]))[0]
    pieces = tuple(
        Piece(f"{kind}{k}", kind, "", "room", pose(at(x, y), heading + turn), size)
        for k, (kind, x, y, heading, size) in enumerate(rows)
    )
    return Seen(space, shapely.Polygon(space.outline), pieces, np.zeros((0, 5)), 0)


@pytest.mark.parametrize("turn", [0.0, 0.4, pi])
def test_a_seat_before_its_screen(turn: float) -> None:
    """Straight before it nothing is off; a metre aside at two metres both are 26.6 degrees."""
    before = seen([("sofa", 1.0, 2.0, 0.0, SOFA), ("tv", 3.0, 2.0, pi, TV)], turn)
    aside = seen([("sofa", 1.0, 1.0, 0.0, SOFA), ("tv", 3.0, 2.0, pi, TV)], turn)
    for measure, far in ((measures.off_axis, 26.565), (measures.turned_away, 26.565)):
        assert measure(before) == pytest.approx(0.0, abs=1e-9)
        assert measure(aside) == pytest.approx(far, abs=1e-3)
    assert measures.viewing_distance(before) == pytest.approx(2.0)
    assert measures.focal_point(before) == 1.0
    assert (
        measures.focal_point(seen([("sofa", 1.0, 2.0, pi, SOFA), ("tv", 3.0, 2.0, pi, TV)])) == 0.0
    )


@pytest.mark.parametrize("turn", [0.0, 0.4])
def test_the_bed_and_the_door(turn: float) -> None:
    """With the head at the far wall the door is ahead; with the head to it, behind; a wardrobe
    between hides it."""
    bed = Size(1.6, 2.0, 0.5)
    facing = seen([("double_bed", 4.0, 2.0, pi, bed)], turn)
    back = seen([("double_bed", 1.5, 2.0, 0.0, bed)], turn)
    hidden = seen(
        [("double_bed", 4.0, 2.0, pi, bed), ("wardrobe", 2.0, 1.2, pi / 2, Size(1.0, 0.6, 2.2))],
        turn,
    )
    ahead = measures.door_in_sight(facing)
    assert ahead is not None
    assert ahead < 30.0
    assert (measures.door_in_sight(back) or 0.0) > 90.0
    assert measures.door_in_sight(hidden) == 180.0
    far, near = measures.away_from_door(facing), measures.away_from_door(back)
    assert far is not None
    assert near is not None
    assert far > near


def test_ways_windows_and_walls() -> None:
    """A wardrobe across the room narrows the way to 0.6 m, and stands in the window's light."""
    across = seen([("wardrobe", 4.7, 1.7, pi, Size(3.4, 0.6, 2.2))])
    assert measures.windows(across) == pytest.approx(1.0)
    assert measures.backs(across) == 1.0
    empty = seen([("wardrobe", 2.5, 3.7, -pi / 2, Size(1.0, 0.6, 2.2))])
    assert measures.windows(empty) == 0.0
    assert measures.route(empty) == pytest.approx(1.0)
    barred = seen(
        [
            ("bookcase", 2.0, 1.7, 0.0, Size(3.4, 0.3, 2.0)),
            ("desk", 4.0, 2.0, pi, Size(1, 0.6, 0.7)),
        ]
    )
    assert measures.route(barred) == pytest.approx(0.6, abs=0.051)
    assert measures.desk_light(barred) == pytest.approx(0.7, abs=1e-6)


def test_limits() -> None:
    row = next(row for row in GUIDELINES if row.name == "conversation")
    assert [round(row.missed(v), 6) for v in (1.0, 1.2, 2.0, 2.9)] == [0.2, 0.0, 0.0, 0.5]
    assert len({row.name for row in GUIDELINES}) == len(GUIDELINES)


@pytest.mark.realdata
@pytest.mark.usefixtures("real_data")
def test_a_home() -> None:
    """Every room with groups is judged; all groups asked for stand, none with more faults than
    before; by the energy, which is not what rooms are composed by alone, the whole home is far
    better and no room much worse."""
    found = list(homes(1))
    pairs = [pair for home in found for pair in home.rooms]
    assert len(pairs) == 6  # the toilet is built in
    assert not any(pair.left_out for pair in pairs)
    assert all(pair.ours.faults <= pair.designer.faults for pair in pairs)
    ours = [sum(pair.our_terms.values()) for pair in pairs]
    theirs = [sum(pair.designer_terms.values()) for pair in pairs]
    assert sum(ours) < 0.7 * sum(theirs)
    assert all(our <= 1.5 * their + NEAR for our, their in zip(ours, theirs, strict=True))
    assert len(values(GUIDELINES[1], pairs)) == 6
    told = "\n".join(lines(pairs))
    assert all(f"| {row.name}: " in told for row in GUIDELINES)
    blind = shuffle_pairs(found, 0)
    for text, plans in ((sheet(found[0]), 2), (draw_home(found[0], blind), 12)):
        drawn = ElementTree.fromstring(text)
        names = [mark.get("id") for mark in drawn.iter() if mark.get("id")]
        assert len(names) == len(set(names))
        assert len(drawn) == plans
    assert "designer" not in text


def test_verdicts_are_told_by_the_key() -> None:
    """Of three rooms ours is preferred once, the designer's once; a verdict of no room is named."""
    key = [
        BlindPair(1, "home", "a", OURS, DESIGNER),
        BlindPair(2, "home", "b", DESIGNER, OURS),
        BlindPair(3, "home", "c", OURS, DESIGNER),
    ]
    told = open_key(key, {1: "A", 2: "A", 3: "-"})
    assert told == {OURS: ["home/a"], DESIGNER: ["home/b"], "tie": ["home/c"]}
    with pytest.raises(ValueError, match="room 3 has no verdict"):
        open_key(key, {1: "A", 2: "B"})


@pytest.mark.realdata
@pytest.mark.usefixtures("real_data")
def test_records() -> None:
    """By the energy ours is at least as good as the designer's in more rooms than the reverse;
    each count is of the rooms compared, and one of the two is at least as good in every room."""
    told = list(records(quick=True))
    assert len(told) == 1 + len(GUIDELINES)
    assert told[0]["metric"] == "energy"
    assert told[0]["runs"] > 0
    assert told[0]["ours"] >= told[0]["baseline"]
    for row in told:
        assert max(row["ours"], row["baseline"]) <= row["runs"] <= row["ours"] + row["baseline"]
