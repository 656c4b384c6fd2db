"""MJCF, the models of MuJoCo: a home or hall in which things can be moved, opened and walked among.

One file, ``.mjcf.xml``, with its meshes inside: it appears whole or not at all, and can be moved.
Metres, kilograms, seconds, radians, z up. Nothing of MuJoCo is needed to write it. No pair of
things is kept from touching. Same solution, same bytes.
E. Todorov, T. Erez, Y. Tassa, *MuJoCo: a physics engine for model-based control* (IROS 2012).
"""

from __future__ import annotations

import os
from xml.etree import ElementTree

from scenewright.core.atomic_file import write_atomically
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path``; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of
    from scenewright.formats.simulation.mjcf.model import build_model

    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    root = build_model(scene, catalog)
    ElementTree.indent(root)
    write_atomically(path, ElementTree.tostring(root, encoding="unicode") + "\n")
