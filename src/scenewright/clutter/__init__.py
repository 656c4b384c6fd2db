"""Small objects on what carries them: books, plates, cups, towels, toys, cushions, shoes.

Where a piece can carry is measured on its model (:mod:`.surfaces`, :mod:`.tops`), what it carries
is a row of a table (:mod:`.rows`), where each stands is chosen by a seed (:mod:`.spots`,
:mod:`.fill`), and whether it stands is measured once more on the finished scene
(:mod:`.stability`).
"""

from scenewright.clutter.fill import with_clutter
from scenewright.clutter.rows import AMOUNTS, ROWS, Amount, Row

__all__ = ["AMOUNTS", "ROWS", "Amount", "Row", "with_clutter"]
