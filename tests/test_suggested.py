"""Words that are not ours: each is answered by the one that is meant, none passes in silence."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import scenewright
from scenewright import cli
from scenewright.catalog.assets import shipped
from scenewright.check.plan_notes import note_unknown_kinds
from scenewright.core.brief import Brief
from scenewright.core.edits import Change
from scenewright.core.errors import InputError
from scenewright.domains import plan_of
from scenewright.domains.hall.zoning.zones import check_halls
from scenewright.domains.home.furnishing.style_words import note_colours
from scenewright.domains.home.wished.requests import check_asks
from scenewright.domains.home.wished.wishes import check_wishes
from scenewright.formats import brief_json
from scenewright.workflow.changes import describe_changes

OUTLINE = [[0, 0], [6, 0], [6, 4], [0, 4]]


def brief(domain: str = "home", **room: Any) -> Brief:
    return Brief.model_validate({"domain": domain, "rooms": [{"outline": OUTLINE} | room]})


@pytest.mark.parametrize(
    ("word", "offered"),
    [
        ("till", "use one of: checkout"),
        ("rope", "use one of: rope_barrier"),
        ("chair", "use dining_chair, reading_chair, auditorium_seat or lounge_seat"),
        ("vitrine", "use one of: display_cabinet, showcase, wall_exhibit, fridge_shelf"),
        ("painting", "use wall_exhibit with the name 'painting'"),
        ("car", "use exhibit_island with the name 'car'"),
        ("whiteboard", "use screen"),
        ("well", "see: scenewright list assets"),
    ],
)
def test_a_demand_for_what_is_no_kind_offers_those_with_that_word(word: str, offered: str) -> None:
    hall = brief("hall", zones=[{"id": "a"}], demands=[{"category": word, "count": 2, "zone": "a"}])
    with pytest.raises(InputError) as caught:
        check_halls(hall, plan_of(hall))
    assert str(caught.value).endswith(f"is not a kind of the catalog; {offered}")


@pytest.mark.parametrize(
    ("word", "offered"),
    [
        ("seeting", "use one of: seating, sleeping"),
        ("couch", "use one of: sofa, corner_sofa"),
        ("unicorn", "see: scenewright list groups"),
    ],
)
def test_a_wish_for_what_is_no_group_offers_what_is_like_it(word: str, offered: str) -> None:
    with pytest.raises(InputError) as caught:
        check_wishes(brief(wishes=[{"what": word}]), shipped())
    assert str(caught.value).endswith(offered)


@pytest.mark.parametrize(("word", "offered"), [("sofa", "seating"), ("diningg", "dining")])
def test_asking_for_a_piece_offers_the_group_that_holds_it(word: str, offered: str) -> None:
    with pytest.raises(InputError, match=f"use one of: {offered}(, |$)"):
        check_asks(brief(ask=[{"group": word}]))


def test_fixed_items_that_are_like_a_kind_are_noted() -> None:
    words = ("couch", "couch", "well", "sofa")
    fixed = [{"category": word, "at": [1, 1], "size": [1, 1, 1]} for word in words]
    (note,) = note_unknown_kinds(brief(fixed=fixed), shipped().kinds)
    assert note.message.startswith("2 fixed 'couch' are no kind of the catalog")
    assert "use one of: sofa" in note.message


@pytest.mark.parametrize(("colour", "is_noted"), [("#ff0000", True), ("blue", False), ("", False)])
def test_a_colour_that_means_nothing_is_noted(colour: str, is_noted: bool) -> None:
    home = brief().model_copy(update={"colour": colour})
    assert bool(note_colours(home, shipped())) is is_noted
    assert bool(note_colours(brief(colour=colour), shipped())) is is_noted


def test_a_pitch_in_degrees_is_told_the_unit() -> None:
    slope = {"edge": 0, "knee": 1.0, "pitch": 45}
    with pytest.raises(InputError, match=r"pitch: 45 is not possible; pitches are radians"):
        brief_json.loads(json.dumps({"rooms": [{"outline": OUTLINE, "slopes": [slope]}]}))


@pytest.mark.parametrize(("count", "told"), [("0", "give at least 1"), ("51", "give at most 50")])
def test_limits_of_options_are_told_plainly(
    count: str, told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run(["arrange", "sample:home-room", "--alternatives", count]) == 2
    assert f"'--alternatives': {told};" in capsys.readouterr().err


def test_many_pieces_of_one_group_are_told_together() -> None:
    seats = [Change(f"a/seats/seat_{k}", "", "moved", "a", "by hand") for k in range(7)]
    assert describe_changes(seats) == ["moved: a/seats (7 pieces) (by hand)"]
    assert describe_changes(seats[:2]) == ["moved: a/seats/seat_0, a/seats/seat_1 (by hand)"]


@pytest.mark.parametrize(
    ("word", "offered"),
    [
        ("mirror", "use fitting_room, which has one"),
        ("picture", "use wall_exhibit with the name 'picture'"),
        ("plant", "use potted_tree or planter"),
        ("curtain", "use partition"),
    ],
)
def test_a_demand_for_what_does_not_stand_offers_what_does(word: str, offered: str) -> None:
    hall = brief("hall", demands=[{"category": word}])
    with pytest.raises(InputError) as caught:
        check_halls(hall, plan_of(hall))
    assert str(caught.value).endswith(f"does not stand on the floor; {offered}")


def test_how_full_a_zone_is_to_be_is_a_share(tmp_path: Path) -> None:
    room = {"outline": OUTLINE, "demands": [{"category": "bench", "fill": 50}]}
    file = tmp_path / "full.json"
    file.write_text(json.dumps({"domain": "hall", "rooms": [room]}))
    with pytest.raises(InputError, match=r"fill: 50 is not possible; it should be at most 0.8"):
        scenewright.read(file)
