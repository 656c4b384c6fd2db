"""What a person likes: derivatives, the posterior against sampling, and what events lead to."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.core.errors import InputError
from scenewright.engine.preference.choices import Choice, Rating, choice_slopes, rating_slopes
from scenewright.engine.preference.events import (
    KINDS,
    Edit,
    Event,
    Keep,
    Lock,
    Pick,
    Prefer,
    Reason,
    Stars,
    Undo,
    Worst,
    champion_of,
    counting,
    event_of,
    favourites_of,
    record_of,
)
from scenewright.engine.preference.kernel import Kernel, kernel_diagonal, kernel_matrix
from scenewright.engine.preference.laplace import Seen, fit_posterior, predict, predict_each
from scenewright.engine.preference.screens import ScreenMix, choose_screen, spread_over
from scenewright.engine.preference.taste import (
    judge,
    judge_each,
    learn_taste,
    measure_scale,
    slopes_of,
    start_from,
)
from scenewright.engine.preference.trust import TrustRecord, count_hit

CHOICES = (Choice(0, (0, 1, 2, 3)), Choice(2, (1, 2, 3), -1.0), Choice(1, (1, 3), 1.0, 2.0))
RATINGS = (Rating(0, 1.0, 0), Rating(2, -1.5, 1), Rating(3, 0.4, 0))
EVENTS: tuple[Event, ...] = (
    Pick(1, (0, 1, 2)),
    Worst(0, (0, 2)),
    Prefer(2, 0),
    Stars(1, 5, 0),
    Reason(0, "too dense"),
    Lock("church"),
    Edit(1, 3),
    Keep(3),
    Undo(),
)


def test_derivatives_of_choices_are_those_of_the_likelihood() -> None:
    rng = np.random.default_rng(0)
    values, step = rng.standard_normal(4), 1e-6
    slopes = choice_slopes(CHOICES, values)
    for k in range(4):
        ahead, behind = (choice_slopes(CHOICES, values + s * step * np.eye(4)[k]) for s in (1, -1))
        assert (ahead.value - behind.value) / 2 / step == pytest.approx(slopes.gradient[k])
        bend = (ahead.gradient - behind.gradient) / 2 / step
        assert bend == pytest.approx(-slopes.curvature[k], abs=1e-8)


def test_derivatives_of_ratings_are_those_of_the_likelihood() -> None:
    rng, step = np.random.default_rng(1), 1e-6
    both = rng.standard_normal(6)
    slopes = rating_slopes(RATINGS, both[:4], both[4:])
    for k in range(6):
        moved = [both + s * step * np.eye(6)[k] for s in (1, -1)]
        ahead, behind = (rating_slopes(RATINGS, m[:4], m[4:]) for m in moved)
        assert (ahead.value - behind.value) / 2 / step == pytest.approx(slopes.gradient[k])
        bend = (ahead.gradient - behind.gradient) / 2 / step
        assert bend == pytest.approx(-slopes.curvature[k], abs=1e-7)


def test_choices_sum_to_one_and_know_no_offset() -> None:
    values = np.array([0.3, -1.0, 2.0])
    told = [choice_slopes((Choice(k, (0, 1, 2)),), values).value for k in range(3)]
    assert np.exp(told).sum() == pytest.approx(1.0)
    raised = [choice_slopes((Choice(k, (0, 1, 2)),), values + 7.0).value for k in range(3)]
    assert raised == pytest.approx(told)


def test_the_kernel_is_a_kernel() -> None:
    points = np.random.default_rng(2).standard_normal((30, 5))
    matrix = kernel_matrix(Kernel(), points, points)
    assert np.allclose(matrix, matrix.T)
    assert np.linalg.eigvalsh(matrix).min() > -1e-9
    assert np.diag(matrix) == pytest.approx(kernel_diagonal(Kernel(), points))


def test_the_mode_is_the_highest_point_of_the_posterior() -> None:
    """Against an optimizer that knows nothing of the method: no direction leads upwards."""
    rng = np.random.default_rng(3)
    points = rng.standard_normal((4, 3))
    seen = Seen(points, np.zeros(4), CHOICES)
    found = fit_posterior(seen, Kernel())
    prior = kernel_matrix(Kernel(), points, points) + 1e-6 * np.eye(4)
    mode = prior @ found.slope

    def height(values: np.ndarray) -> float:
        return choice_slopes(CHOICES, values).value - 0.5 * values @ np.linalg.solve(prior, values)

    for _ in range(200):
        assert height(mode + 1e-3 * rng.standard_normal(4)) <= height(mode) + 1e-9


def test_the_posterior_is_that_of_sampling() -> None:
    """Prior draws weighed by their likelihood, half a million of them; the mode of what is skewed
    lies a little below its mean, the more so the wider the prior."""
    kernel = Kernel(2.0, 0.5, 0.3)
    points = np.array([[0.0, 0.0], [1.0, 0.2], [-0.7, 1.0]])
    choices = (Choice(0, (0, 1, 2)), Choice(2, (1, 2), -1.0))
    found = fit_posterior(Seen(points, np.zeros(3), choices), kernel)
    new = np.array([[0.5, -1.0]])
    mean, covariance = predict(found, new)
    every = np.vstack([points, new])
    prior = kernel_matrix(kernel, every, every) + 1e-9 * np.eye(4)
    rng = np.random.default_rng(0)
    draws = rng.standard_normal((500_000, 4)) @ np.linalg.cholesky(prior).T
    first = draws[:, 0] - np.log(np.exp(draws[:, :3]).sum(1))
    second = -draws[:, 2] - np.log(np.exp(-draws[:, 1:3]).sum(1))
    weight = np.exp(first + second)
    weight /= weight.sum()
    truth = weight @ draws[:, 3]
    assert mean[0] == pytest.approx(truth, abs=0.1)
    assert covariance[0, 0] == pytest.approx(weight @ (draws[:, 3] - truth) ** 2, rel=0.1)
    assert predict_each(found, new)[1] == pytest.approx(np.diag(covariance))


def test_ratings_of_strict_and_mild_screens_mean_the_same() -> None:
    """The same layouts rated two stars less on the second screen: their order stays."""
    values = {k: np.array([float(k)]) for k in range(6)}
    scale = measure_scale(["size"], np.array(list(values.values())))
    said = [Stars(k, 3 + k, 0) for k in range(3)] + [Stars(k, k - 2, 1) for k in range(3, 6)]
    mean, _ = judge_each(learn_taste(scale, said, values, {}), np.arange(6.0)[:, None])
    assert (np.diff(mean) > 0).all()


def test_a_reason_points_the_way() -> None:
    rng = np.random.default_rng(0)
    values = dict(enumerate(rng.standard_normal((20, 3))))
    scale = measure_scale(["sun", "open", "rows"], np.array(list(values.values())))
    reasons = {"more sun": {"sun": 1.0}, "too dense": {"open": 1.0, "rows": -1.0}}
    said = [Reason(3, "more sun"), Reason(5, "too dense")]
    slopes = slopes_of(learn_taste(scale, said, values, reasons))
    assert slopes[0] > 0.1
    assert slopes[1] > 0.1
    assert slopes[2] < -0.1


def test_the_order_of_events_about_different_things_does_not_matter() -> None:
    rng = np.random.default_rng(4)
    values = dict(enumerate(rng.standard_normal((8, 4))))
    scale = measure_scale("abcd", np.array(list(values.values())))
    said = [Pick(1, (0, 1, 2, 3)), Worst(5, (4, 5, 6)), Prefer(2, 7), Stars(3, 4, 0)]
    new = rng.standard_normal((5, 4))
    one, other = (judge(learn_taste(scale, s, values, {}), new) for s in (said, said[::-1]))
    assert one.mean == pytest.approx(other.mean, abs=1e-4)
    assert one.covariance == pytest.approx(other.covariance, abs=1e-4)


def test_what_is_taken_back_was_never_said() -> None:
    values = dict(enumerate(np.random.default_rng(5).standard_normal((6, 2))))
    scale = measure_scale("ab", np.array(list(values.values())))
    said: list[Event] = [Pick(1, (0, 1, 2)), Prefer(3, 4)]
    new = np.ones((1, 2))
    undone = learn_taste(scale, [*said, Stars(2, 1, 0), Undo()], values, {})
    assert judge(undone, new).mean == judge(learn_taste(scale, said, values, {}), new).mean
    assert counting([Undo(), Pick(1, (1, 2)), Undo(), Undo()]) == ()


def test_only_the_person_changes_the_champion() -> None:
    assert champion_of([]) is None
    assert champion_of([Stars(2, 5, 0), Prefer(2, 1), Reason(2, "x")]) is None
    assert champion_of([Pick(2, (1, 2)), Pick(4, (2, 4))]) == 4
    assert champion_of([Pick(2, (1, 2)), Keep(2), Pick(4, (2, 4))]) == 4, "a later pick counts"
    assert champion_of([Pick(2, (1, 2)), Keep(2), Edit(2, 9), Pick(4, (2, 4))]) == 9
    assert champion_of([Pick(2, (1, 2)), Pick(4, (2, 4)), Undo()]) == 2
    assert champion_of([Pick(9, (5, 9, 1)), Pick(5, (5, 1))]) == 9, "the best, not the last said"
    assert champion_of([Keep(2), Prefer(4, 2)]) == 4
    assert champion_of([Keep(2), Worst(2, (1, 2, 4)), Pick(4, (1, 4))]) == 4


def test_what_was_liked_besides_the_champion_is_a_favourite_until_it_is_the_worst() -> None:
    said = [Pick(9, (5, 9, 1)), Pick(5, (5, 1)), Stars(1, 5, 0), Stars(7, 4, 0)]
    assert favourites_of(said) == (1, 5)
    assert favourites_of([*said, Pick(8, (8, 9, 5))]) == (9, 1, 5)
    assert favourites_of([*said, Worst(5, (1, 5))]) == (1,)
    assert favourites_of([*said, Edit(5, 12), Undo()]) == (1, 5)
    assert favourites_of([*said, Edit(5, 12)]) == (12, 1)


def test_a_screen_begins_with_what_is_kept_even_where_nothing_is_learned() -> None:
    values = np.random.default_rng(5).standard_normal((40, 3))
    scale = measure_scale("abc", values)
    rng, shown = np.random.default_rng(0), np.zeros(40, bool)
    for said in ([], [Pick(0, (0, 1, 2))]):
        taste = learn_taste(scale, said, dict(enumerate(values)), {})
        screen = choose_screen(taste, values, shown, [7, 3], rng, ScreenMix())
        assert screen[:2] == [7, 3]
        assert len(set(screen)) == 12


def test_events_read_back() -> None:
    assert {type(event) for event in EVENTS} == set(KINDS.values())
    assert tuple(event_of(record_of(event)) for event in EVENTS) == EVENTS
    for wrong in ({}, {"event": "shrug"}, {"event": "keep"}, {"event": "keep", "candidate": "x"}):
        with pytest.raises(InputError) as caught:
            event_of(wrong)
        assert "\n" not in str(caught.value)


def test_a_taste_learns_what_is_hidden() -> None:
    """Twelve layouts at a time, best and worst: after ten screens the best of all is near."""
    rng = np.random.default_rng(6)
    values = rng.standard_normal((400, 10))
    truth = values @ rng.standard_normal(10) - 0.5 * values[:, 0] ** 2
    scale = measure_scale([f"f{k}" for k in range(10)], values)
    shown, champion, said = np.zeros(400, bool), None, []
    taste = learn_taste(scale, [], {}, {})
    for _ in range(8):
        screen = choose_screen(
            taste, values, shown, [] if champion is None else [champion], rng, ScreenMix()
        )
        assert len(set(screen)) == 12
        assert champion is None or screen[0] == champion
        assert shown[screen].sum() == (champion is not None)
        shown[screen] = True
        best, worst = max(screen, key=truth.__getitem__), min(screen, key=truth.__getitem__)
        said += [Pick(best, tuple(screen)), Worst(worst, tuple(screen))]
        champion = best
        taste = learn_taste(scale, said, dict(enumerate(values)), {})
    assert truth[champion] > np.sort(truth)[-8]


def test_a_screen_from_few_candidates_shows_all() -> None:
    values = np.random.default_rng(7).standard_normal((5, 3))
    scale = measure_scale("abc", values)
    said = [Pick(0, (0, 1, 2))]
    taste = learn_taste(scale, said, dict(enumerate(values)), {})
    rng = np.random.default_rng(0)
    assert sorted(choose_screen(taste, values, np.zeros(5, bool), [0], rng, ScreenMix())) == [
        0, 1, 2, 3, 4,
    ]  # fmt: skip
    assert sorted(spread_over(values, 12, 2)) == [0, 1, 2, 3, 4]


def test_other_peoples_tastes_are_where_one_starts() -> None:
    values = np.random.default_rng(8).standard_normal((10, 2))
    scale = measure_scale(["sun", "open"], values)
    sunny = int(values[:, 0].argmax())
    known = learn_taste(scale, [Pick(sunny, tuple(range(10)))] * 3, dict(enumerate(values)), {})
    start = start_from([known], ["open", "sun", "trees"])
    assert start[1] > abs(start[0]) > start[2] == 0.0
    fresh = learn_taste(scale, [], {}, {}, start[[1, 0]])
    assert judge_each(fresh, values)[0].argmax() == sunny


def test_no_screen_shows_the_same_twice() -> None:
    """Of two layouts that are alike one is worth a look, also beside a champion it is like."""
    rng = np.random.default_rng(4)
    values = np.repeat(rng.standard_normal((20, 5)), 3, axis=0)
    scale = measure_scale([f"f{k}" for k in range(5)], values)
    said = [Pick(0, (0, 6, 9, 12)), Worst(12, (6, 9, 12))]
    taste = learn_taste(scale, said, dict(enumerate(values)), {})
    shown = np.arange(len(values)) == 0
    for learning in (2, 45):
        for screen in range(5):
            mix = ScreenMix(learning=learning)
            chosen = choose_screen(taste, values, shown, [0], np.random.default_rng(screen), mix)
            assert len(np.unique(values[chosen], axis=0)) == len(chosen) == 12


def test_trust_is_counted_on_what_was_not_learned() -> None:
    record = TrustRecord()
    for picked in (0, 1, 2, 3, 4, 5, 1, 0):
        record = count_hit(record, [9.0, 8.0, 7.0, 3.0, 2.0, 1.0], picked)
    assert record[:2] == (8, 5)
    assert not record.enough
    twelve = list(range(12, 0, -1))
    for _ in range(30):
        record = count_hit(record, twelve, 0)
    assert record.enough
    assert not count_hit(TrustRecord(), twelve, 0).enough


def test_what_is_easily_told_apart_gives_no_trust() -> None:
    twelve, easy, narrow = list(range(12, 0, -1)), TrustRecord(), TrustRecord()
    for k in range(10):
        easy = count_hit(easy, twelve, 0, late=False)  # screens to learn from
        narrow = count_hit(narrow, twelve[:4], 3 if k < 2 else 0)  # three of four: no feat
    assert easy.share == 1.0
    assert narrow.share == 0.8
    assert not easy.enough
    assert not narrow.enough
    shares = [TrustRecord(10, n, 2.5, (10, n, 2.5)).enough for n in (6, 7, 8)]
    assert shares == [False, False, True]
