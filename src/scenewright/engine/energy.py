"""Energies: their parts, and the sum of these."""

from __future__ import annotations

from typing import NamedTuple


class Part(NamedTuple):
    """What one term says: of one item, of two (``a & b``), or of the whole layout (item empty).

    ``cost`` is ``value`` times ``weight``; areas are already divided by the summed area.
    """

    item: str
    term: str
    value: float
    weight: float
    cost: float


class Evaluation(NamedTuple):
    """The energy of one layout and all its parts; their costs sum to the energy."""

    energy: float
    parts: tuple[Part, ...]
