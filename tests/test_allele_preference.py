"""Formulas (7) to (25) of Zhang and Yang (2023), each against a slow, plain version."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from scenewright.engine.preference.alleles import art1, preference, subspaces
from scenewright.engine.preference.alleles.art1 import Art1Settings
from scenewright.engine.preference.alleles.preference import AlleleRecord

RNG = np.random.default_rng(0)
RATED = RNG.integers(0, 4, (30, 5))
RATINGS = RNG.integers(1, 6, 30).astype(float)
QUALITY = RNG.uniform(0.1, 1.0, 30)
RECORDS = [AlleleRecord(0.2, 0.5, 4.0), AlleleRecord(0.0, 0.9, 5.0), AlleleRecord(0.7, 0.3, 2.0)]
EVERY = [(gene, allele) for gene in range(5) for allele in range(4)]


@pytest.mark.parametrize(("gene", "allele"), EVERY)
def test_9_is_the_mean_of_carriers_less_that_of_all(gene: int, allele: int) -> None:
    carriers = [r for row, r in zip(RATED, RATINGS, strict=True) if row[gene] == allele]
    plain = sum(carriers) / len(carriers) - sum(RATINGS) / len(RATINGS)
    printed = preference.prefer_allele(RATED, RATINGS, gene, allele, "printed")
    assert printed == pytest.approx(plain)
    repaired = preference.prefer_allele(RATED, RATINGS, gene, allele)
    assert repaired == pytest.approx(max(plain, 0.0) / (max(RATINGS) - min(RATINGS)))
    assert 0.0 <= repaired <= 1.0


def test_9_as_printed_leaves_its_range_and_10_lets_nearly_all_pass() -> None:
    printed = [preference.prefer_allele(RATED, RATINGS, *place, "printed") for place in EVERY]
    assert min(printed) < 0.0
    seen = [preference.observe_allele(RATED, *place, 4, "printed") for place in EVERY]
    assert all(value > 1.0 for value in seen)
    repaired = [preference.observe_allele(RATED, *place, 4) for place in EVERY]
    assert 0.2 < np.mean([value > 1.0 for value in repaired]) < 0.8


@pytest.mark.parametrize(("gene", "allele"), EVERY)
def test_10_is_the_share_over_chance(gene: int, allele: int) -> None:
    share = sum(1 for row in RATED if row[gene] == allele) / len(RATED)
    printed = preference.observe_allele(RATED, gene, allele, 4, "printed")
    assert printed == pytest.approx(share / (1 / 4**5))
    assert preference.observe_allele(RATED, gene, allele, 4) == pytest.approx(share / (1 / 4))


def test_preferences_are_used_by_the_three_rules() -> None:
    use = preference.accept_preference
    assert use(0.6, 1.01, 0.1, 0.5, 0.99) == 0.6
    assert use(0.6, 1.0, 0.6, 0.5, preference.SELDOM - 1e-9) == 0.6
    assert use(0.6, 1.0, 0.6, 0.5, preference.SELDOM) == 0.0
    assert use(0.6, 1.0, 0.4, 0.5, 0.0) == 0.0
    assert 0.25 <= preference.SELDOM <= 0.4


def test_7_sums_over_the_alleles() -> None:
    plain, weights = 0.0, 0.0
    for p, tau, fitness in RECORDS:
        plain += p * (tau + p) * fitness / tau
        weights += p * (tau + p) / tau
    assert preference.estimate_fitness(RECORDS, 3.0, "printed") == pytest.approx(plain)
    assert preference.estimate_fitness(RECORDS, 3.0) == pytest.approx(plain / weights)
    twice = preference.estimate_fitness(RECORDS * 2, 3.0, "printed")
    assert twice == pytest.approx(2 * plain)
    assert preference.estimate_fitness(RECORDS * 2, 3.0) == pytest.approx(plain / weights)
    assert preference.estimate_fitness([AlleleRecord(0.0, 0.5, 5.0)], 3.0) == 3.0


def test_11_starts_from_the_middle_of_the_bounds() -> None:
    plain = sum(p * (tau + p) / (tau + 1) for p, tau, _ in RECORDS)
    assert preference.estimate_unknown(RECORDS, 1, 5, "printed") == pytest.approx(plain * 3)
    assert preference.estimate_unknown(RECORDS, 1, 5) == pytest.approx(3 + 2 * plain / 3)
    for many in (1, 10, 100):
        assert 3.0 <= preference.estimate_unknown(RECORDS * many, 1, 5) <= 5.0


def test_12_is_the_mean_difference_less_the_threshold() -> None:
    plain = sum(abs(r - 4.0) for r in RATINGS) / (len(RATINGS) - 1) - 0.3
    assert preference.measure_difference(RATINGS, 4.0, 0.3) == pytest.approx(plain)


@pytest.mark.parametrize(("gene", "allele"), EVERY)
def test_14_counts_what_it_sums_only_when_repaired(gene: int, allele: int) -> None:
    rows = list(zip(RATED.tolist(), RATINGS.tolist(), QUALITY.tolist(), strict=True))
    good = [r for row, r, q in rows if row[gene] == allele and q >= 0.5]
    there = [r for row, r, _ in rows if row[gene] == allele]
    told = (RATED, RATINGS, QUALITY, gene, allele, 0.5)
    assert preference.estimate_allele(*told, "printed") == pytest.approx(sum(good) / len(there))
    repaired = preference.estimate_allele(*told)
    assert repaired == pytest.approx(sum(good) / len(good)) if good else math.isnan(repaired)


def test_23_is_the_mean_over_bests_that_carry() -> None:
    for gene, allele in EVERY:
        carry = [r for row, r in zip(RATED, RATINGS, strict=True) if row[gene] == allele]
        told = preference.estimate_from_best(RATED, RATINGS, gene, allele)
        assert told == pytest.approx(sum(carry) / len(carry))
    assert math.isnan(preference.estimate_from_best(RATED, RATINGS, 0, 99))


def test_13_counts_members() -> None:
    parts = RNG.integers(0, 3, 50)
    plain = [sum(1 for part in parts if part == k) for k in range(4)]
    assert subspaces.count_members(parts, 4).tolist() == plain


def test_15_to_18_are_deviations_about_the_mean() -> None:
    values, n = RNG.standard_normal(12), 12
    mean = sum(values) / n
    assert subspaces.centre_variable(values) == pytest.approx([v - mean for v in values])
    printed = subspaces.centre_ratings(values, "printed")
    assert printed == pytest.approx([v - sum(values) / n / n for v in values])
    assert subspaces.centre_ratings(values) == pytest.approx([v - mean for v in values])
    deviation = math.sqrt(sum((v - mean) ** 2 for v in values) / (n - 1))
    assert subspaces.measure_deviation(values - mean) == pytest.approx(deviation)


def test_19_is_a_correlation_when_repaired() -> None:
    one, other = RNG.standard_normal((2, 20))
    exact = float(np.corrcoef(one, other)[0, 1])
    assert subspaces.correlate_variable(one, other) == pytest.approx(exact)
    printed = subspaces.correlate_variable(one, 2.0 * one, "printed")
    off = 2.0 * one - 2.0 * one.mean() / 20
    plain = ((one - one.mean()) * off).sum() / 20
    plain /= math.sqrt(((one - one.mean()) ** 2).sum() / 19) * math.sqrt((off**2).sum() / 19)
    assert printed == pytest.approx(plain)
    assert subspaces.correlate_variable(one, 2.0 * one) == pytest.approx(1.0)
    assert subspaces.correlate_variable(np.ones(5), one[:5]) == 0.0


def test_the_space_is_split_along_what_goes_with_the_ratings() -> None:
    points = RNG.uniform(size=(40, 3))
    ratings = 5.0 - 4.0 * points[:, 1] + 0.3 * points[:, 2]
    assert subspaces.choose_split(points, ratings) == 1
    assert subspaces.choose_split(points, ratings, "printed") != 1
    parts = subspaces.divide_space(points, 1, 4)
    for k in range(4):
        assert np.ptp(points[parts == k, 1]) <= np.ptp(points[:, 1]) / 4 + 1e-12


def test_20_is_the_least_and_mean_distance() -> None:
    point, members = RNG.uniform(size=3), RNG.uniform(size=(9, 3))
    far = [math.dist(point, member) for member in members]
    assert subspaces.measure_distances(point, members) == pytest.approx((min(far), sum(far) / 9))


def test_21_is_an_average_only_when_repaired() -> None:
    told, least, mean = [2.0, 3.0, 5.0], [0.5, 1.0, 4.0], [1.0, 2.0, 5.0]
    plain = sum(mean) * sum(f / h for f, h in zip(told, least, strict=True))
    assert subspaces.combine_models(told, least, mean, "printed") == pytest.approx(plain)
    assert plain > max(told)
    weights = [1 / h for h in least]
    exact = sum(w * f for w, f in zip(weights, told, strict=True)) / sum(weights)
    assert subspaces.combine_models(told, least, mean) == pytest.approx(exact)
    scaled = subspaces.combine_models(told, [9 * h for h in least], mean)
    assert scaled == pytest.approx(exact)
    assert subspaces.combine_models(told, [0.0, 1.0, 2.0], mean) == 2.0
    assert subspaces.combine_models([4.0] * 3, least, mean) == pytest.approx(4.0)


@pytest.mark.parametrize("count", [2, 7, 10])
def test_hypercubes_are_latin_and_symmetric(count: int) -> None:
    points = subspaces.draw_symmetric_hypercube(count, 4, np.random.default_rng(count))
    levels = [(k + 0.5) / count for k in range(count)]
    for column in points.T:
        assert sorted(column.tolist()) == pytest.approx(levels)
    rows = {tuple(row) for row in points.round(9).tolist()}
    assert {tuple(row) for row in (1.0 - points).round(9).tolist()} == rows


def test_art1_by_hand() -> None:
    """Three patterns with ρ = 0.6, β = 1. x1 = 1100 founds A (V²¹ = 1/3 1/3 0 0). x2 = 1110: match
    2/3 > 0.6, A's prototype stays 1100 (old ⊙ x), V²¹ = 2/3 2/3 0 0. x3 = 0011: match 0, founds B.
    x4 = 0111: A drives 2/3 and matches 1/3, B drives 2/3 and matches 2/3: B."""
    settings = Art1Settings(0.6, 1.0)
    network = art1.begin_network(4)
    rows = np.array([[1, 1, 0, 0], [1, 1, 1, 0], [0, 0, 1, 1], [0, 1, 1, 1]], float)
    places = []
    for row, rating in zip(rows, (4.0, 2.0, 5.0, 3.0), strict=True):
        network, place = art1.present(network, row, rating, settings)
        places.append(place)
    assert places == [0, 0, 1, 1]
    assert network.downward.tolist() == [[1, 1, 0, 0], [0, 0, 1, 1]]
    assert network.upward == pytest.approx(np.array([[2 / 3, 2 / 3, 0, 0], [0, 0, 2 / 3, 2 / 3]]))
    assert art1.rate_pattern(network, rows[0], 9.0, settings) == 3.0
    assert art1.rate_pattern(network, rows[2], 9.0, settings) == 4.0
    strange = np.array([1.0, 0, 0, 1])
    assert art1.rate_pattern(network, strange, 9.0, settings) == 9.0


def test_art1_learns_slowly_at_half_the_rate() -> None:
    settings = Art1Settings(0.4, 0.5)
    network, _ = art1.present(art1.begin_network(3), np.array([1.0, 1, 0]), 3.0, settings)
    network, place = art1.present(network, np.array([1.0, 0, 1]), 3.0, settings)
    assert place == 0
    assert network.downward[0].tolist() == [1.0, 0.5, 0.0]
    assert network.upward[0].tolist() == [1.0, 0.0, 0.0]


def test_vigilance_parts_and_joins() -> None:
    patterns = (np.random.default_rng(1).random((40, 12)) < 0.5).astype(float)
    counts = [
        len(art1.learn_ratings(patterns, np.ones(40), Art1Settings(v)).members)
        for v in (0.1, 0.5, 0.99)
    ]
    assert counts[0] < counts[1] < counts[2]
    distinct = len({tuple(row) for row in patterns.tolist() if any(row)})
    assert counts[2] <= distinct + 1


def test_24_25_and_the_stages_of_the_takeover() -> None:
    rng = random.Random(0)
    truth = [rng.uniform(1, 5) for _ in range(9)]
    told = [rng.uniform(1, 5) for _ in range(9)]
    squares = sum((a - b) ** 2 for a, b in zip(truth, told, strict=True))
    one, other = np.array(truth), np.array(told)
    assert art1.measure_rmse(one, other) == pytest.approx(math.sqrt(squares / 9))
    plain = sum(abs(a - b) for a, b in zip(truth, told, strict=True))
    assert art1.measure_error(one, other) == pytest.approx(plain)
    coarse, fine = art1.STAGES
    assert coarse.rmse > fine.rmse
    assert coarse.error > fine.error
    near, exact = one + 0.65, one + 0.3
    assert art1.may_take_over(one, near, coarse)
    assert not art1.may_take_over(one, near, fine)
    assert art1.may_take_over(one, exact, fine)
    assert not art1.may_take_over(np.zeros(0), np.zeros(0), coarse)


def test_13_to_21_estimate_what_was_not_rated() -> None:
    """Local models tell points apart where ratings bend, and keep to the usual without enough."""
    points = np.linspace(0.0, 8.0, 17)[:, None]
    ratings = np.where(points[:, 0] < 4.0, 1.5 + 0.5 * points[:, 0], 5.0 - 0.5 * points[:, 0] / 4)
    asked = np.array([0.7, 2.2, 5.3, 7.4])
    plain = np.interp(asked, points[:, 0], ratings)
    found = [subspaces.estimate_locally(points, ratings, np.array([x]), 3.0) for x in asked]
    assert found == pytest.approx(plain.tolist(), abs=0.45)
    assert subspaces.estimate_locally(points[:4], ratings[:4], np.zeros(1), 3.0) == 3.0
    there = subspaces.estimate_locally(points, ratings, points[0], 3.0)
    mean, middle, slopes = subspaces.fit_plane(points[:9], ratings[:9])
    assert there == pytest.approx(mean + float(slopes @ (points[0] - middle)), abs=0.3)
