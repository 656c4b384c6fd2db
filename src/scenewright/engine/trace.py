"""What a method does as it runs, step by step, for whoever hears: the trace of a run.

A solver that is traced tells its parameters as it begins, every step (a generation, an iteration
of ants, a house), and why it stops. It tells them through its budget (:class:`~.solve.Budget`);
where nobody hears, nothing is told, and the answer is the same.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np


class Step(NamedTuple):
    """One thing told: its ``kind`` (``begin``, ``generation``, ``ants``, ``iterations``, ``house``,
    ``stop`` …), its ``number`` counted from 1, ``facts`` by name (numbers, words, lists of them, or
    ``None``), and the ``space`` it happens in."""

    kind: str
    number: int
    facts: Mapping[str, Any]
    space: str = ""


Hear = Callable[[Step], None]


def hear_in(hear: Hear | None, space: str) -> Hear | None:
    """The listener to the steps of one space; none where nobody hears.

    >>> heard = []
    >>> hear_in(heard.append, "hall")(Step("stop", 1, {"reason": "nothing new"}))
    >>> heard[0].space
    'hall'
    """
    return None if hear is None else lambda step: hear(step._replace(space=space))


def tell(hear: Hear | None, kind: str, number: int, **facts: Any) -> None:
    """Tell a step to whoever hears.

    >>> heard = []
    >>> tell(heard.append, "house", 3, odds=np.float64(0.5))
    >>> heard[0].kind, heard[0].number, heard[0].facts
    ('house', 3, {'odds': 0.5})
    """
    if hear is not None:
        hear(Step(kind, number, {name: to_plain(value) for name, value in facts.items()}))


def to_plain(value: Any) -> Any:
    """A fact as JSON holds it: arrays as lists, what is no number as ``None``.

    >>> to_plain((np.array([1.0, np.inf]), np.int64(2), "x", True))
    [[1.0, None], 2, 'x', True]
    """
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, float):
        return value if np.isfinite(value) else None
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        value = value._asdict()
    if isinstance(value, Mapping):
        return {str(name): to_plain(one) for name, one in value.items()}
    return [to_plain(one) for one in value] if isinstance(value, list | tuple) else value
