"""What an MJCF model refers to by name: meshes, hulls and materials, each written once."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from scenewright.core.catalog import Material, Part
from scenewright.geometry.mesh import Floats
from scenewright.geometry.prisms import face_normals

PLAIN = re.compile(r"[^\w ()+-]+")
"""What is left out of names: ``/`` parts the names of models that are put together."""


@dataclass(frozen=True, slots=True)
class Assets:
    """The element ``asset`` as it is filled, and what is in it by key; the names that are taken."""

    element: Element
    materials: dict[Material, str] = field(default_factory=dict)
    meshes: dict[Hashable, str] = field(default_factory=dict)
    names: set[str] = field(default_factory=set)

    def free_name(self, wish: str) -> str:
        """A name nobody has yet, of letters, digits and spaces."""
        plain, count = PLAIN.sub("-", wish).strip("- ") or "thing", 1
        name = plain
        while name in self.names:
            count += 1
            name = f"{plain} {count}"
        self.names.add(name)
        return name


def write_numbers(values: Iterable[float], digits: int = 5) -> str:
    """Numbers as MJCF has them.

    >>> write_numbers((0.5, -0.0, 1e-9, 12.0))
    '0.5 0 0 12'
    """
    if isinstance(values, np.ndarray):
        rows = values.round(digits).tolist()
    else:
        rows = [round(float(value), digits) for value in values]
    return ("%.10g " * len(rows))[:-1] % tuple([row + 0.0 for row in rows])  # no zero is negative


def name_material(assets: Assets, material: Material) -> str:
    """The name of a material; its colour, gloss and glow are written the first time."""
    if material not in assets.materials:
        name = assets.free_name(f"of {material.name}")
        assets.materials[material] = name
        gloss = 1.0 - material.roughness
        shown = {
            "name": name,
            "rgba": write_numbers((*material.color, material.opacity), 4),
            "specular": write_numbers((0.2 + 0.6 * gloss,), 3),
            "shininess": write_numbers((gloss,), 3),
            "emission": write_numbers((material.emission,), 3),
        }
        SubElement(assets.element, "material", shown)
    return assets.materials[material]


def name_mesh(assets: Assets, key: Hashable, part: Part, shift: Floats) -> str | None:
    """The name of a part's triangles, moved by ``shift``; none where none of them has an area."""
    if key not in assets.meshes:
        vertices = (part.vertices + shift).round(4)
        faces = part.faces[np.linalg.norm(face_normals(vertices, part.faces), axis=1) > 0]
        used, rows = np.unique(faces, return_inverse=True)
        assets.meshes[key] = ""
        if len(used):
            name = assets.meshes[key] = f"mesh {len(assets.meshes)}"
            SubElement(
                assets.element,
                "mesh",
                {
                    "name": name,
                    "inertia": "shell",
                    "vertex": write_numbers(vertices[used].reshape(-1), 4),
                    "face": " ".join(map(str, rows.reshape(-1).tolist())),
                },
            )
    return assets.meshes[key] or None


def name_hull(assets: Assets, key: Hashable, corners: Floats) -> str:
    """The name of the convex hull of corners (k, 3)."""
    if key not in assets.meshes:
        name = assets.meshes[key] = f"hull {len(assets.meshes)}"
        listed = {"name": name, "vertex": write_numbers(corners.reshape(-1))}
        SubElement(assets.element, "mesh", listed)
    return assets.meshes[key]


def quaternion(axes: Floats) -> Sequence[float]:
    """The turn (w, x, y, z) that takes x, y and z to the rows of ``axes`` (S. Shepperd 1978).

    >>> [round(value, 3) for value in quaternion(np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1.0]]))]
    [0.707, 0.0, 0.0, 0.707]
    """
    turn = axes.T
    squares = np.array([turn.trace(), *np.diag(turn)])
    largest = int(squares.argmax())
    if largest == 0:
        cross = (turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1])
        found = np.array([1 + squares[0], *cross])
    else:
        i = largest - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        found = np.zeros(4)
        found[0] = turn[k, j] - turn[j, k]
        found[1 + i] = 1 + 2 * turn[i, i] - squares[0]
        found[1 + j], found[1 + k] = turn[i, j] + turn[j, i], turn[i, k] + turn[k, i]
    return [float(value) for value in found / np.linalg.norm(found)]
