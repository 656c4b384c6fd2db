"""The input report: every feature counted once, however many reasons there are."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from scenewright.core.brief.input_report import MOST_ROWS, OUTCOMES, Fate, InputReport, report_input

FATES = st.builds(
    Fate,
    st.text(max_size=9),
    st.sampled_from(("wall", "tree", "building")),
    st.sampled_from(OUTCOMES),
    st.integers(0, 400).map(str),
    st.booleans(),
)


@given(st.lists(FATES, max_size=500))
def test_no_feature_is_lost_in_the_sums(fates: list[Fate]) -> None:
    found = report_input(fates)
    assert found.features == len(fates)
    assert len(found.rows) <= MOST_ROWS
    for outcome in OUTCOMES:
        for stands in (True, False):
            counted = sum(r.count for r in found.rows if (r.outcome, r.stands) == (outcome, stands))
            assert counted == sum((f.outcome, f.stands) == (outcome, stands) for f in fates)


@given(st.lists(FATES, max_size=30))
def test_a_report_is_the_same_when_read_back(fates: list[Fate]) -> None:
    found = report_input(fates, drawn_floor=10.0, read_floor=9.4)
    assert InputReport.model_validate_json(found.model_dump_json()) == found


def test_what_stands_and_is_missing_is_not_complete() -> None:
    school = Fate("way/4", "building", "left out", "its outline crosses itself", stands=True)
    tree = Fate("node/5", "tree", "left out", "trees are planted anew")
    assert not report_input([school, tree]).complete
    assert report_input([tree]).complete


def test_less_than_most_of_the_drawn_floor_is_not_complete() -> None:
    assert not report_input([], drawn_floor=100.0, read_floor=94.0).complete
    assert report_input([], drawn_floor=100.0, read_floor=96.0).complete
    assert report_input([], drawn_floor=0.0, read_floor=0.0).floor_share is None
