"""What the pages say of the papers, recomputed by hand: the draw of one seed agrees."""

from __future__ import annotations

from benchmarks.papers_open import OPEN
from benchmarks.papers_reader import records
from benchmarks.papers_reader_rows import CHECKS, PAGES, rows_of


def test_every_check_is_of_one_row_of_its_page() -> None:
    for page, _, row in CHECKS:
        assert len([one for one, _ in rows_of(page) if one.startswith(row)]) == 1, (page, row)
    kinds = {(page, kind): 0 for page in PAGES for kind in ("formula", "step")}
    for page, kind, _ in CHECKS:
        kinds[page, kind] += 1
    assert min(n for (page, _), n in kinds.items() if page != "villages") >= 5


def test_what_dice_choose_agrees_with_what_is_computed_by_hand() -> None:
    found = list(records(seed=0))
    assert len(found) >= 40
    assert [row for row in found if not row["agree"]] == []


def test_every_paper_has_choices_left_open_and_each_is_tried_otherwise() -> None:
    assert {row.scene for row in OPEN} == set(PAGES)
    assert all(len(row.tried) >= 2 for row in OPEN)
