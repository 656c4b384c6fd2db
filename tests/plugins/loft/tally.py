"""A format: how many of each kind there are, a line each."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path
from typing import Any

from scenewright.core.solution import Solution


def write(solution: Solution, path: str | os.PathLike[str], **_: Any) -> None:
    """Write the tally of a solution."""
    counted = Counter(piece.category for piece in solution.pieces)
    Path(path).write_text("".join(f"{kind} {n}\n" for kind, n in sorted(counted.items())))
