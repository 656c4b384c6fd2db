"""The buildings of a glTF scene, or of all scenes of a folder, with the models that draw them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from scenewright.catalog.models import gltf_scene
from scenewright.catalog.models.cityjson import turn_of
from scenewright.catalog.models.files import MEBIBYTE, beside, whole
from scenewright.catalog.models.model import clean
from scenewright.core.atomic_file import note_read
from scenewright.core.catalog import OWN
from scenewright.core.errors import InputError
from scenewright.ground.buildings.built import BuiltBuilding, BuiltScene
from scenewright.ground.reading.city import building_of_parts
from scenewright.ground.reading.cleaning import drop_overlaps

SUFFIXES = (".glb", ".gltf")
MOST_BYTES = 256 * MEBIBYTE
MOST_FILES = 500


def model_scene(path: Path, scale: float = 1.0) -> BuiltScene:
    """The scene of a .glb or .gltf, or of all in a folder, in metres where they stand; ``scale``
    is metres a unit."""
    found, left_out = list[BuiltBuilding](), list[str]()
    for file in _files(path):
        try:
            found += _buildings(file, scale, left_out)
        except InputError as error:
            if not path.is_dir():
                raise
            left_out.append(f"{clean(file.name, 'unnamed')}: {error.fault}")
    kept, overlapping = drop_overlaps(found) if found else ((), ())
    return BuiltScene(
        path.stem, kept, left_out=(*left_out, *overlapping), catalog=str(path.absolute())
    )


def _files(path: Path) -> list[Path]:
    if not path.is_dir():
        return [path]
    found = sorted(file for file in path.iterdir() if file.suffix.lower() in SUFFIXES)
    if not found or len(found) > MOST_FILES:
        raise InputError(
            f"holds {len(found)} scenes", f"give a folder of 1 to {MOST_FILES} .glb files"
        )
    return found


def _buildings(file: Path, scale: float, left_out: list[str]) -> list[BuiltBuilding]:
    note_read(file)
    content, stem = whole(file, MOST_BYTES), clean(file.stem, "model")
    found = []
    buildings = gltf_scene.scene_buildings(content, stem, beside(file.parent), scale)
    for one in buildings:
        if not one.parts:
            left_out.append(f"{one.name}: has no surface")
            continue
        built = building_of_parts(one.parts, one.name, "", f"{OWN}{one.model}")
        if built is None:
            left_out.append(f"{one.name}: has no usable footprint")
        else:
            front = turn_of(buildings[one.like].parts) - np.pi / 2 + one.turn
            found.append(built._replace(heading=front))
    return found
