"""The same scene as ``.glb``, its textures as WebP: half their bytes.

For readers that know EXT_texture_webp.
"""

from __future__ import annotations

import os

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.glb import write_scene


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path``; the file appears whole or not at all."""
    write_scene(solution, path, plan, batched=True, webp=True)
