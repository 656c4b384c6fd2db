"""Runs of benchmarks are kept line by line, for the code they were made with."""

from __future__ import annotations

from pathlib import Path

from benchmarks import kept


def test_what_was_cut_short_goes_on_where_it_ended(tmp_path: Path) -> None:
    made: list[int] = []

    def make(number: int) -> int:
        made.append(number)
        return number**2

    first = kept.open_runs("squares", ["benchmarks/kept.py"], tmp_path)
    assert [first.have(str(k), lambda k=k: make(k)) for k in (2, 3, 2)] == [4, 9, 4]
    with first.path.open("a") as file:
        file.write('["4", 1')  # killed while it was writing
    again = kept.open_runs("squares", ["benchmarks/kept.py"], tmp_path)
    assert again.values == {"2": 4, "3": 9}
    assert [again.have(str(k), lambda k=k: make(k)) for k in (3, 4)] == [9, 16]
    assert made == [2, 3, 4]
    assert kept.open_runs("squares", ["benchmarks/kept.py"], tmp_path).values["4"] == 16


def test_other_code_begins_anew(tmp_path: Path) -> None:
    kept.open_runs("squares", ["benchmarks/kept.py"], tmp_path).keep("2", 4)
    assert not kept.open_runs(
        "squares", ["benchmarks/k*.py", "benchmarks/site.py"], tmp_path
    ).values
