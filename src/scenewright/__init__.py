"""Automatic 3D scene layout: read a brief, solve it, write the scene.

>>> import scenewright as sw
>>> brief = sw.read("sample:home-flat")
>>> [room.name for room in brief.rooms][:2]
['Living and dining', 'Kitchen']

Names are loaded when first used, so importing the package is quick.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from scenewright._version import __version__

if TYPE_CHECKING:
    from scenewright.assets import shipped
    from scenewright.batch import batch
    from scenewright.brief import Brief
    from scenewright.catalog import Asset, Catalog, Kind
    from scenewright.check import Report, check
    from scenewright.domains import alternatives, resolve, solve
    from scenewright.errors import InputError
    from scenewright.formats import read, samples, write
    from scenewright.formats.solution_json import read as read_solution
    from scenewright.layout import Layout
    from scenewright.problem import Problem
    from scenewright.scene import Piece, Pose, Scene, Size
    from scenewright.shell import scene_of
    from scenewright.solution import Solution
    from scenewright.space import Level, Opening, Space

__all__ = [
    "Asset", "Brief", "Catalog", "InputError", "Kind", "Layout", "Level", "Opening", "Piece",
    "Pose", "Problem", "Report", "Scene", "Size", "Solution", "Space", "__version__",
    "alternatives", "batch", "check", "read", "read_solution", "resolve", "samples", "scene_of",
    "shipped", "solve", "write",
]  # fmt: skip

_HOMES = {
    "read": "formats:read",
    "read_solution": "formats.solution_json:read",
    "samples": "formats:samples",
    "write": "formats:write",
    "alternatives": "domains:alternatives",
    "batch": "batch:batch",
    "solve": "domains:solve",
    "resolve": "domains:resolve",
    "check": "check:check",
    "Report": "check:Report",
    "scene_of": "shell:scene_of",
    "shipped": "assets:shipped",
    "Brief": "brief:Brief",
    "Solution": "solution:Solution",
    "Problem": "problem:Problem",
    "Layout": "layout:Layout",
    "Space": "space:Space",
    "Level": "space:Level",
    "Opening": "space:Opening",
    "Scene": "scene:Scene",
    "Piece": "scene:Piece",
    "Pose": "scene:Pose",
    "Size": "scene:Size",
    "Catalog": "catalog:Catalog",
    "Asset": "catalog:Asset",
    "Kind": "catalog:Kind",
    "InputError": "errors:InputError",
}
"""Where each name lives: module below this package, and name in it."""


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'scenewright' has no attribute {name!r}")
    module, _, attribute = _HOMES[name].partition(":")
    found = getattr(import_module(f"scenewright.{module}"), attribute)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted(__all__)


class _Facade(ModuleType):
    """Importing the subpackage ``check`` would put it in the place of the verb of that name."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOMES and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Facade
