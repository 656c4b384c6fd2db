"""Second runs of a kitchen, which only carry storage: they give way to one kitchen in one place."""

from __future__ import annotations

from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.settings import ComposingSettings

SECOND = "counter"


def is_spare(group: FurnishedGroup) -> bool:
    """Whether a group is a second run that nobody asked for."""
    return group.wish.group == SECOND and not group.wish.required


def without_spare(placed: Placed) -> Placed:
    """The groups without second runs."""
    return tuple(p for p in placed if not is_spare(p))


def price_of_spare(before: Placed, after: Placed, rule: ComposingSettings) -> float:
    """What second runs were worth that stood before and gave way: what may be paid to add them."""
    return rule.addition * (sum(map(is_spare, before)) - sum(map(is_spare, after)))


def list_given_up(before: Placed, after: Placed, reason: str) -> tuple[Missing, ...]:
    """The second runs that stood before and gave way, for a ``reason``."""
    kept = {p.name for p in after}
    return tuple(Missing(p.wish, reason) for p in before if is_spare(p) and p.name not in kept)
