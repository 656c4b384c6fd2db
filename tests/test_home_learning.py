"""Groups learned from furnished rooms: found as they stand, mended, merged, written, used."""

from __future__ import annotations

import json
from math import cos, isfinite, pi, sin
from pathlib import Path

import numpy as np
import pytest

from scenewright import formats
from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.catalog import GroupsBrief
from scenewright.core.catalog import Member
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.domains.home.cases.furnishing import Taste
from scenewright.domains.home.cases.library import cases, find_preferred_case
from scenewright.domains.home.cases.own_library import library_of
from scenewright.domains.home.cases.trial import usable
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.cases import merge_similar_cases
from scenewright.domains.home.learned.groups import Learned, document, learn, read, write
from scenewright.domains.home.learned.learning import (
    FurnishedSpace,
    GroupOccurrence,
    box_members,
    found_in,
)
from scenewright.domains.home.learned.space import drawn_out, footprint
from scenewright.domains.home.learned.words import ANCHORS, COMPANIONS

CATALOG = shipped()
BEDROOM = (
    ("double_bed", 0.0, 0.0, 0.0, 0.0, Size(1.6, 2.0, 0.5)),
    ("nightstand", -1.1, -0.75, 0.0, 0.0, Size(0.45, 0.4, 0.5)),
    ("nightstand", 1.1, -0.75, 0.0, 0.0, Size(0.45, 0.4, 0.5)),
    ("table_lamp", 1.1, -0.75, 0.5, 0.0, Size(0.2, 0.2, 0.4)),
)
DINING = (
    ("dining_table", 0.0, 0.0, 0.0, 0.0, Size(1.4, 0.8, 0.74)),
    *(
        ("dining_chair", x, y, 0.0, pi if y > 0 else 0.0, Size(0.45, 0.5, 0.9))
        for x in (-0.35, 0.35)
        for y in (-0.5, 0.5)
    ),
)
Rows = tuple[tuple[str, float, float, float, float, Size], ...]


def standing(rows: Rows, x: float, y: float, heading: float) -> tuple[Piece, ...]:
    """Pieces given in the frame of the first, as they stand in a room."""
    found = []
    for k, (category, px, py, z, turn, size) in enumerate(rows):
        at = (x + px * sin(heading) + py * cos(heading), y - px * cos(heading) + py * sin(heading))
        pose = Pose(*at, z, heading + turn)
        found.append(Piece(f"{category}{k}", category, "", "room", pose, size))
    return tuple(found)


def furnished(
    rows: Rows,
    at: tuple[float, float] = (2.0, 1.05),
    heading: float = pi / 2,
    name: str = "one",
    size: tuple[float, float] = (5.0, 5.0),
) -> FurnishedSpace:
    """A room with one door and a group of pieces."""
    wide, deep = size
    room = Room.model_validate(
        {
            "id": "room",
            "function": "living",
            "doors": [{"at": [0.7, deep], "width": 0.8}],
            "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        }
    )
    return FurnishedSpace(name, spaces(Brief(rooms=[room]))[0], standing(rows, *at, heading))


def found(room: FurnishedSpace) -> list[GroupOccurrence]:
    return list(found_in(room, CATALOG))


def test_the_words_are_of_known_groups_and_kinds() -> None:
    assert set(ANCHORS) <= set(CATALOG.kinds)
    assert set(ANCHORS.values()) | set(COMPANIONS) <= set(GROUPS)
    assert {kind for own in COMPANIONS.values() for kind in own.kinds} <= set(CATALOG.kinds)


@pytest.mark.parametrize("heading", [0.0, pi / 2, 2.5, -1.0])
def test_a_group_is_found_as_it_stands_however_it_is_turned(heading: float) -> None:
    (one,) = found(furnished(BEDROOM, (2.5, 2.5), heading))
    case = one.case
    assert case.function == "sleeping"
    assert [m.category for m in case.members] == [row[0] for row in BEDROOM]
    bed = case.members[0]
    for member, row in zip(case.members, BEDROOM, strict=True):
        assert (member.x - bed.x, member.y - bed.y) == pytest.approx(row[1:3], abs=1e-9)
        assert member.heading == pytest.approx(0.0)
    assert case.width == pytest.approx(2.65)
    lamp = case.members[3]
    assert lamp.on == 2
    assert lamp.z == pytest.approx(0.5)


def test_wall_and_door_are_measured() -> None:
    (one,) = found(furnished(BEDROOM))
    assert one.wall == pytest.approx(0.05)
    assert one.door == pytest.approx(np.hypot(1.3, 3.95), abs=0.15)
    assert one.area == pytest.approx(25.0)


def test_a_table_at_the_wall_is_another_group_and_looks_away_from_it() -> None:
    free, wall = DINING, (DINING[0], *(row for row in DINING[1:] if row[2] > 0))
    assert [f.case.function for f in found(furnished(free, (2.5, 2.5)))] == ["dining"]
    (one,) = found(furnished(wall, (2.5, 0.42)))
    assert one.case.function == "dining_wall"
    assert one.case.members[0].y < 0
    assert found(furnished(DINING[:1], (2.5, 2.5))) == []


def test_what_nobody_can_reach_is_no_group() -> None:
    walls = tuple(
        ("bookcase", x, y, 0.0, 0.0, Size(w, d, 2.0))
        for x, y, w, d in ((0.0, 0.72, 2.2, 0.3), (-0.95, 0.0, 0.3, 1.0), (0.95, 0.0, 0.3, 1.0))
    )
    case = box_members("sleeping", [Member(c, x, y, z, t, s) for c, x, y, z, t, s in BEDROOM])
    assert usable(case, CATALOG)
    around = [Member(c, x, y, z, turn, s) for c, x, y, z, turn, s in walls]
    toilet = Member("toilet", 0, -0.2, 0, 0, Size(0.4, 0.65, 0.8))
    closed = box_members("toilet", [toilet, *around])
    assert not usable(closed, CATALOG)


def test_a_chair_pushed_into_a_table_is_drawn_out_until_its_back_is_clear() -> None:
    rows = (DINING[0], ("dining_chair", 0.0, 0.2, 0.0, pi, Size(0.45, 0.5, 0.9)))
    table, chair = standing(rows, 2.0, 2.0, 0.3)
    moved = drawn_out(chair, table)
    assert footprint(moved).intersection(footprint(table)).area > 0.05
    far = float(np.hypot(moved.pose.x - 2, moved.pose.y - 2))
    clear = far + moved.size.depth / 2 - 0.4
    assert 0.06 <= clear <= 0.08 + 1e-9
    low = Piece("s", "stool", "", "r", chair.pose, Size(0.4, 0.4, 0.45))
    assert drawn_out(low, table) is low


def test_a_table_in_the_corner_of_a_sofa_is_pushed_out_and_rugs_lie_straight() -> None:
    rows = (
        ("corner_sofa", 0.0, 0.0, 0.0, 0.0, Size(2.4, 1.8, 0.8)),
        ("coffee_table", 0.2, 0.6, 0.0, 0.1, Size(0.8, 0.5, 0.4)),
        ("rug", 0.3, 1.0, 0.0, 0.8, Size(1.6, 1.2, 0.01)),
    )
    (one,) = found(furnished(rows, (2.5, 1.0)))
    sofa, table, rug = one.case.members
    assert table.y - sofa.y - 0.9 - 0.25 == pytest.approx(0.3, abs=0.06)
    assert rug.heading == pytest.approx(pi / 2)


def test_like_cases_of_several_homes_become_one_with_a_range() -> None:
    wider = (("double_bed", 0.0, 0.0, 0.0, 0.0, Size(1.66, 2.05, 0.6)), *BEDROOM[1:])
    rooms = [
        furnished(BEDROOM, name="a"),
        furnished(wider, name="b"),
        furnished(BEDROOM[:3], name="c"),
    ]
    learned = merge_similar_cases([one for room in rooms for one in found(room)])
    assert sorted(case.seen for case in learned) == [1, 2]
    both = next(case for case in learned if case.seen == 2)
    assert both.homes == ("a", "b")
    assert both.smallest[0] == pytest.approx((1.6, 2.0, 0.5))
    assert both.largest[0] == pytest.approx((1.66, 2.05, 0.6))


def learned_two() -> Learned:
    small = furnished(BEDROOM[:2], name="a", size=(3.5, 4.0))
    return learn([furnished(BEDROOM, name="b"), small, furnished(DINING, (2.5, 2.5))], CATALOG)


def test_the_file_reads_back_as_it_was_written(tmp_path: Path) -> None:
    file, learned = tmp_path / "groups.json", learned_two()
    write(learned, file)
    assert json.loads(file.read_text()) == json.loads(json.dumps(document(learned)))
    known = read(file)
    assert {name: len(own) for name, own in known.cases.items()} == {"sleeping": 2, "dining": 1}
    for case in learned.cases:
        same = [
            g
            for g in known.cases[case.case.function]
            if g.width == pytest.approx(case.case.width, abs=1e-3)
        ]
        assert len(same) == 1
        assert same[0].members[0].size == pytest.approx(case.case.members[0].size, abs=1e-3)
    assert all(isfinite(area) for own in known.areas.values() for area in own)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"format": "other"}, "is not a file of learned groups"),
        ({"distances": [["a", "b", float("nan"), 0, 0, 9]]}, "is no"),
        ({"distances": [["a", "b", -1.0, 0, 0, 9]]}, "distances[0][2]: "),
        ({"distances": [["a", "b", 1.0, 0, 0, 9, [1, -2, 0]]]}, "distances[0][6][1]: "),
        ({"clearances": [["toilet", "front", float("nan"), 0.5, 3]]}, "clearances[0][2]: "),
        ({"clearances": [["toilet", "front", 0.5, 1e9, 3]]}, "clearances[0][3]: "),
        ({"clearances": [["toilet", "above", 0.5, 0.5, 3]]}, "clearances[0][1]: "),
        ({"clearances": [["toilet", "front", 0.5, 0.5, 10**12]]}, "clearances[0][4]: "),
        ({"shares": [["bedroom", 12.0, -0.2]]}, "shares[0][2]: "),
        ({"shares": [["bedroom", 0.0, 0.2]]}, "shares[0][1]: "),
        ({"shares": [["bedroom", float("inf"), 0.2]]}, "shares[0][1]: "),
        (
            {
                "cases": [
                    {
                        "function": "bed",
                        "name": "",
                        "width": 1,
                        "depth": 1,
                        "members": [{"category": "double_bed", "x": 0, "y": 0, "size": [1, 1, 1]}],
                    }
                ]
            },
            "cases[0]: unknown group 'bed'",
        ),
        (
            {
                "cases": [
                    {
                        "function": "sleeping",
                        "name": "",
                        "width": 1,
                        "depth": 1,
                        "members": [{"category": "bed", "x": 0, "y": 0, "size": [1, 1, 1]}],
                    }
                ]
            },
            "unknown category 'bed'",
        ),
        (
            {
                "cases": [
                    {
                        "function": "sleeping",
                        "name": "",
                        "width": 1,
                        "depth": 1,
                        "members": [{"category": "double_bed", "x": 5, "y": 0, "size": [1, 1, 1]}],
                    }
                ]
            },
            "outside its group",
        ),
        (
            {
                "cases": [
                    {
                        "function": "sleeping",
                        "name": "",
                        "width": 1,
                        "depth": 1,
                        "members": [
                            {"category": "double_bed", "x": 0, "y": 0, "size": [1, 1, 1], "on": 0}
                        ],
                    }
                ]
            },
            "stands on a member that comes later",
        ),
        (
            {
                "cases": [
                    {"function": "sleeping", "name": "", "width": 1e9, "depth": 1, "members": []}
                ]
            },
            "is not a file of learned groups",
        ),
    ],
)
def test_what_cannot_be_used_is_told_in_one_line(
    tmp_path: Path, change: dict[str, object], told: str
) -> None:
    file = tmp_path / "groups.json"
    file.write_text(
        json.dumps({"format": "scenewright/groups", "version": 1, "cases": []} | change)
    )
    with pytest.raises(InputError) as caught:
        read(file)
    assert told in str(caught.value)
    assert str(file) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_learned_groups_stand_for_the_shipped_or_beside_them(tmp_path: Path) -> None:
    write(learned_two(), tmp_path / "groups.json")
    known = read(tmp_path / "groups.json")
    alone = library_of(CATALOG, Taste(), ((known, False),))
    beside = library_of(CATALOG, Taste(), ((known, True),))
    assert len(cases("sleeping", alone).groups) == 2
    assert len(cases("sleeping", beside).groups) == 2 + len(cases("sleeping").groups)
    assert cases("bath", alone).groups == cases("bath").groups
    large, small = (
        find_preferred_case("sleeping", 25.0, alone),
        find_preferred_case("sleeping", 13.0, alone),
    )
    assert (len(large.members), len(small.members)) == (4, 2), "by the rooms they were seen in"


def test_a_home_with_learned_groups_differs_and_is_valid(tmp_path: Path) -> None:
    write(learned_two(), tmp_path / "groups.json")
    room = {
        "id": "bed",
        "function": "double_bedroom",
        "doors": [{"at": [0.0, 0.8], "width": 0.85}],
        "outline": [[0, 0], [4.2, 0], [4.2, 4], [0, 4]],
    }
    usual = Brief(rooms=[Room.model_validate(room)])
    own = usual.model_copy(update={"groups": [GroupsBrief(path=str(tmp_path / "groups.json"))]})
    first, second = (home.solve(brief, steps=2000) for brief in (usual, own))
    assert check(second).valid
    beds = [next(p for p in s.pieces if p.category == "double_bed") for s in (first, second)]
    assert beds[1].size == pytest.approx((1.6, 2.0, 0.5))
    assert beds[0].size != beds[1].size
    assert sin(2 * beds[1].pose.heading) == pytest.approx(0.0, abs=1e-6), "square to the walls"


HOMES = ("2BedroomApartment", "3BedroomApartment", "Studio")


@pytest.mark.realdata(quick=True)
def test_groups_of_designers_furnish_their_homes_anew(real_data: Path, tmp_path: Path) -> None:
    files = [real_data / "furnished_homes_sh3d" / f"{name}.xml" for name in HOMES]
    rooms = []
    for file in files:
        brief = formats.read(file, keep=True)
        rooms += [
            FurnishedSpace(file.stem, space, tuple(fixed_pieces(room, space, CATALOG)))
            for space, room in zip(spaces(brief), brief.rooms, strict=True)
        ]
    learned = learn(rooms, CATALOG)
    assert len({case.case.function for case in learned.cases}) >= 12
    write(learned, tmp_path / "groups.json")
    groups = [str(tmp_path / "groups.json")]
    for file in files[::2]:
        solution = home.solve(formats.read(file, groups=groups), steps=2000)
        assert check(solution).valid
