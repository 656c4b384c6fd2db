"""Interactive methods to a common liking, by simulated raters."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.papers_raters import (
    METHODS,
    OURS,
    RatedRun,
    compare_runs,
    figures_of,
    run_method,
    starts_of,
)
from benchmarks.papers_raters_tables import markdown_lines, page_lines
from benchmarks.papers_raters_worlds import RatedWorld, plots_world, site_world


@pytest.fixture(scope="module")
def site() -> RatedWorld:
    return site_world(6)


@pytest.fixture(scope="module")
def plots() -> RatedWorld:
    return plots_world("extend-court")


@pytest.mark.parametrize("name", ["vp", "tiga", "sga"])
def test_a_run_asks_as_its_method_does(site: RatedWorld, name: str) -> None:
    run = run_method(site, name, True, 1, 32)
    assert len(run.liked) == len(run.stars) == 32
    assert run.ages[:10] == (1,) * 10
    later = np.bincount(run.ages)[2:-1]
    assert later.max() <= (METHODS[name].asked or 10)
    assert run == run_method(site, name, True, 1, 32)


def test_all_begin_alike_where_the_first_layouts_are_the_same(plots: RatedWorld) -> None:
    first = [run_method(plots, name, False, 3, 8).liked for name in ("ciga", "siga", "sga", OURS)]
    assert len(set(first)) == 1
    assert starts_of("ciga") == (True, False)
    assert starts_of("siga") == starts_of(OURS) == (False,)
    assert run_method(plots, "ciga", True, 3, 8).liked != first[0]


def test_the_network_rates_on_to_the_end_where_it_is_not_capped(site: RatedWorld) -> None:
    capped, whole = (
        run_method(site, name, True, 0, 60) for name in ("vp", "vp, network to the end")
    )
    assert 0 < capped.alone[-1] <= 13 < 200 <= whole.alone[-1]


def test_levels_are_common_and_what_is_not_reached_counts_whole() -> None:
    good = RatedRun((0.0, 2.0, 3.0), (3.0, 4.0, 4.0), (1, 1, 2), (0, 0, 0))
    poor = RatedRun((0.5, 1.0, 0.0), (3.0, 3.0, 2.0), (1, 2, 3), (0, 0, 5))
    told = figures_of([poor], [1.0], [3.0])
    assert told["ratings to the common level"] == [2.0]
    assert told["generations to the common level"] == [2.0]
    assert told["ratings to the usual method's end"] == [3.0]
    assert told["reached the usual method's end"] == [0.0]
    assert told["liked in the end"] == [1.0]
    rows = list(compare_runs("a", {"good": [good, good], "poor": [poor, poor]}, "good"))
    (level,) = [row for row in rows if row["metric"] == "ratings to the common level, good"]
    assert level["ours"] == 2.0
    (end,) = [row for row in rows if row["metric"] == "liked in the end, poor"]
    assert (end["ours"], end["baseline"], end["told_apart"]) == (1.0, 3.0, True)
    text = "\n".join(markdown_lines(rows))
    assert "| `poor` | ≈ 2.0 ± 0.0 |" in text
    assert "| 0 of 2 |" in text
    assert "| ratings, its end | reached | liked |" in "\n".join(page_lines(rows))
