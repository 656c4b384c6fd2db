"""Letters on appliances whose symbols look alike; the schedule says what they stand for."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.scene import Piece
from scenewright.drawing.marks import INK, Mark, PaperView, group, plate, to_paper
from scenewright.drawing.pieces import to_plan_coordinates

LETTERS = {"dishwasher": "DW", "dryer": "TD", "fridge": "F", "washing_machine": "WM"}
"""Dishwasher, tumble dryer, fridge, washing machine."""

BEHIND = {"fridge": 0.3}
"""Share of the depth by which letters stand behind the middle, where the symbol has a sign there;
a round door holds them."""

HEIGHT, LEAST_LETTERED = 1.6, 8.0
"""Millimetres: height of the letters, and of an appliance that holds them."""


def short_names_mark(view: PaperView, pieces: Sequence[Piece]) -> Mark:
    """The letters, upright; what is stacked shares one place."""
    found: dict[tuple[float, float], list[str]] = {}
    for piece in pieces:
        if piece.category in LETTERS and min(piece.size[:2]) * view.scale >= LEAST_LETTERED:
            back = (0.0, -BEHIND.get(piece.category, 0.05) * piece.size.depth)
            x, y = to_paper(view, to_plan_coordinates(piece, back)).tolist()
            found.setdefault((round(x, 1), round(y, 1)), []).append(LETTERS[piece.category])
    rows = [("/".join(sorted(words)), at) for at, words in found.items()]
    return group([plate(words, at, HEIGHT, fill=INK) for words, at in rows])


def with_letters(category: str, name: str) -> str:
    """The name of a kind with the letters it is marked by.

    >>> with_letters("fridge", "Fridge"), with_letters("sofa", "Sofa")
    ('Fridge (F)', 'Sofa')
    """
    return f"{name} ({LETTERS[category]})" if category in LETTERS else name
