"""Alternatives of sites differ by form, axis and open ground, and by a stated measure."""

from __future__ import annotations

import pytest

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.domains import alternatives, check, plan_of
from scenewright.domains.site.alternatives import FORMS, compare, describe, list_variants


def test_alternatives_and_seeds_of_the_courtyards_differ():
    brief = sw.read("sample:site-courtyards")
    plan = plan_of(brief)
    seeds = [sw.solve(brief, seed=seed) for seed in range(3)]
    assert min(compare(one, seeds[2], plan) for one in seeds[:2]) >= 0.3
    found = alternatives(brief, 3)
    apart = [compare(a, b, plan) for k, a in enumerate(found) for b in found[:k]]
    assert min(apart) > 0.25
    assert len({describe(one, plan) for one in found}) == 3
    assert all(check(one).valid and not one.left_out for one in found)


def test_the_measure_is_one_of_difference():
    brief = sw.read("sample:site-30")
    plan, one = plan_of(brief), sw.solve(brief)
    other = sw.solve(brief, preset="paper", steps=200)
    assert compare(one, one, plan) == pytest.approx(0.0)
    assert 0.0 < compare(one, other, plan) <= 1.0
    assert compare(one, other, plan) == pytest.approx(compare(other, one, plan))
    assert describe(one, plan).startswith("fronts south")


def test_forms_are_varied_only_where_the_brief_leaves_them_open():
    site = {"outline": [[0, 0], [90, 0], [90, 60], [0, 60]]}
    free = Brief.model_validate({"domain": "site", "name": "x", "sites": [site]}).part.sites
    assert {v.form for v in list_variants(free, 9)} == {"", *FORMS}
    fixed = Brief.model_validate(
        {"domain": "site", "name": "x", "sites": [site | {"form": "point"}]}
    )
    assert {v.form for v in list_variants(fixed.part.sites, 9)} == {""}
