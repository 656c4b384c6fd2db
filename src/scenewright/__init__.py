"""Automatic 3D scene layout: read a brief, solve it, write the scene.

>>> import scenewright as sw
>>> brief = sw.read("sample:home-flat")
>>> [room.name for room in brief.rooms][:2]
['Living and dining', 'Kitchen']

Names are loaded when first used, so importing the package is quick.
"""

from __future__ import annotations

import os
import sys

from scenewright._version import __version__

# Before numpy is loaded: products of a few hundred rows gain nothing from threads that wait for
# each other, and on a busy machine take twenty times as long.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

TYPE_CHECKING = False  # that of typing, whose import takes longer than all of this
if TYPE_CHECKING:
    from scenewright.batch import batch
    from scenewright.catalog.assets import shipped
    from scenewright.core.brief import Brief
    from scenewright.core.catalog import Asset, Catalog
    from scenewright.core.edits import Addition as Addition
    from scenewright.core.errors import InputError
    from scenewright.core.kind import Kind
    from scenewright.core.layout import Layout, NamedBox
    from scenewright.core.map_options import MapOptions
    from scenewright.core.report import Report
    from scenewright.core.scene import Piece, Pose, Scene, Size
    from scenewright.core.solution import Solution
    from scenewright.core.space import Level, Opening, Space
    from scenewright.domains import (
        alternatives,
        check,
        explain,
        resolve,
        scene_of,
        solution_of,
        solve,
    )
    from scenewright.domains.home.problem import Problem
    from scenewright.domains.plotting import plots_of
    from scenewright.formats import losses, read, samples, write
    from scenewright.formats.solution_json import read as read_solution
    from scenewright.workflow.arrange import arrange
    from scenewright.workflow.editing import edit_pieces as edit_pieces
    from scenewright.workflow.evolve import evolve
    from scenewright.workflow.generate import generate
    from scenewright.workflow.meshes import check_meshes
    from scenewright.workflow.observe import observe
    from scenewright.workflow.photograph import photograph
    from scenewright.workflow.scene_project import Project as Project
    from scenewright.workflow.workspace import Workspace as Workspace
if TYPE_CHECKING:
    from typing import Any

__all__ = [
    "Addition",
    "Asset",
    "Brief",
    "Catalog",
    "InputError",
    "Kind",
    "Layout",
    "Level",
    "MapOptions",
    "NamedBox",
    "Opening",
    "Piece",
    "Pose",
    "Problem",
    "Project",
    "Report",
    "Scene",
    "Size",
    "Solution",
    "Space",
    "Workspace",
    "__version__",
    "alternatives",
    "arrange",
    "batch",
    "check",
    "check_meshes",
    "edit_pieces",
    "evolve",
    "explain",
    "generate",
    "losses",
    "observe",
    "photograph",
    "plots_of",
    "read",
    "read_solution",
    "resolve",
    "samples",
    "scene_of",
    "shipped",
    "solution_of",
    "solve",
    "write",
]

_HOMES = {
    "losses": "formats:losses",
    "read": "formats:read",
    "read_solution": "formats.solution_json:read",
    "samples": "formats:samples",
    "write": "formats:write",
    "alternatives": "domains:alternatives",
    "arrange": "workflow.arrange:arrange",
    "evolve": "workflow.evolve:evolve",
    "observe": "workflow.observe:observe",
    "photograph": "workflow.photograph:photograph",
    "batch": "batch:batch",
    "solve": "domains:solve",
    "edit_pieces": "workflow.editing:edit_pieces",
    "Addition": "core.edits:Addition",
    "Project": "workflow.scene_project:Project",
    "Workspace": "workflow.workspace:Workspace",
    "resolve": "domains:resolve",
    "check": "domains:check",
    "check_meshes": "workflow.meshes:check_meshes",
    "explain": "domains:explain",
    "generate": "workflow.generate:generate",
    "Report": "core.report:Report",
    "plots_of": "domains.plotting:plots_of",
    "scene_of": "domains:scene_of",
    "solution_of": "domains:solution_of",
    "shipped": "catalog.assets:shipped",
    "Brief": "core.brief:Brief",
    "Solution": "core.solution:Solution",
    "Problem": "domains.home.problem:Problem",
    "Layout": "core.layout:Layout",
    "NamedBox": "core.layout:NamedBox",
    "Space": "core.space:Space",
    "Level": "core.space:Level",
    "Opening": "core.space:Opening",
    "Scene": "core.scene:Scene",
    "Piece": "core.scene:Piece",
    "Pose": "core.scene:Pose",
    "Size": "core.scene:Size",
    "Catalog": "core.catalog:Catalog",
    "Asset": "core.catalog:Asset",
    "Kind": "core.kind:Kind",
    "InputError": "core.errors:InputError",
    "MapOptions": "core.map_options:MapOptions",
}
"""Where each name lives: module below this package, and name in it."""


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'scenewright' has no attribute {name!r}")
    from importlib import import_module

    module, _, attribute = _HOMES[name].partition(":")
    found = getattr(import_module(f"scenewright.{module}"), attribute)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted(__all__)


class _Facade(type(sys)):  # type: ignore[misc]
    """Importing the subpackage ``check`` would put it in the place of the verb of that name."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOMES and isinstance(value, type(sys))):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Facade
