"""Terms that bring data of their own: one file with a compiled function, one row in a table.

The function of such a term is ``cost(frames, i, frame, data) -> float``: what the layout
``frames`` (n, 8) costs, in homes (kind "layout") with item ``i`` taken to ``frame`` (-1: all stand
as they are), in halls (kind "hall") always with -1; in sites (kind "building") what building ``i``
costs at ``frame`` among the others. ``data`` (m,) are the numbers that its ``data`` function makes
of a problem, once. They are joined into one kernel, in which a term that weighs nothing takes one
comparison.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.registry import load_added
from scenewright.engine.rows import TermRow, load_function
from scenewright.geometry.boxes import Floats, Frame
from scenewright.geometry.compiled import inlined

GROUP = "scenewright.terms"
"""Entry points by which packages add terms: ``"home.symmetry" = "package.module:ROW"``."""


NOTHING: Floats = np.zeros(0)


class TermData(NamedTuple):
    """The numbers of all such terms, one after another: ``values`` (m,), and where those of each
    term ``starts`` (t + 1,)."""

    values: Floats
    starts: NDArray[np.int64]


def add_terms(domain: str, rows: Sequence[TermRow]) -> tuple[TermRow, ...]:
    """The rows of a domain's table, those of other packages last; rows without a number (-1) get
    that of their place.

    Raises :class:`scenewright.core.errors.InputError` if a package's row cannot be loaded.
    """
    every = (*rows, *load_added(GROUP, domain, TermRow))
    return tuple(row if row.number >= 0 else row._replace(number=k) for k, row in enumerate(every))


def with_data(rows: Sequence[TermRow]) -> tuple[TermRow, ...]:
    """Those rows whose terms bring data of their own."""
    return tuple(row for row in rows if row.data)


def gather(rows: Sequence[TermRow], problem: Any, weights: Floats | None = None) -> TermData:
    """What the terms with data make of a ``problem``; nothing of those that weigh nothing, where
    ``weights`` (terms,) are given."""
    parts = [
        np.ravel(load_function(row.data)(problem))
        if weights is None or weights[row.number] != 0.0
        else NOTHING
        for row in with_data(rows)
    ]
    starts = np.cumsum([0, *map(len, parts)]).astype(np.int64)
    return TermData(np.concatenate([np.zeros(0), *parts]).astype(np.float64), starts)


def join_terms(rows: Sequence[TermRow]) -> Callable[..., float]:
    """The kernel ``(frames, i, frame, weights, data, out) -> Σ_k w_k cost_k`` of all terms with
    data, those of weight 0 not looked at; each cost is written to ``out`` at the term's number.

    ``frames`` (n, 8), ``weights`` (terms,), ``out`` (terms,) or (0,) where nobody asks.
    """
    total = inlined(_nothing)
    for k, row in enumerate(with_data(rows)):
        total = _add_term(total, load_function(row.function), row.number, k)
    return total


def _nothing(
    frames: Floats,  # noqa: ARG001
    i: int,  # noqa: ARG001
    frame: Frame,  # noqa: ARG001
    weights: Floats,  # noqa: ARG001
    data: TermData,  # noqa: ARG001
    out: Floats,  # noqa: ARG001
) -> float:
    """No term."""
    return 0.0


def _add_term(
    before: Callable[..., float], cost: Callable[..., float], number: int, k: int
) -> Callable[..., float]:
    """The terms ``before`` and one more: row ``number`` of the weights, ``k`` of the data."""

    @inlined
    def sum_up(
        frames: Floats, i: int, frame: Frame, weights: Floats, data: TermData, out: Floats
    ) -> float:
        """The terms before and this one."""
        total = before(frames, i, frame, weights, data, out)
        if weights[number] != 0.0:
            value = cost(frames, i, frame, data.values[data.starts[k] : data.starts[k + 1]])
            total += weights[number] * value
            if out.shape[0] > number:
                out[number] = value
        return total

    return sum_up
