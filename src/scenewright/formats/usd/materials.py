"""Materials as UsdPreviewSurface, each once, below one scope."""

from __future__ import annotations

import numpy as np
from pxr import Gf, Sdf, Usd, UsdShade

from scenewright.core.catalog import Material
from scenewright.formats.usd.names import free_path
from scenewright.render.colour import linear_of

Paths = dict[Material, Sdf.Path]


def linear_color(material: Material) -> Gf.Vec3f:
    """The colour in linear light, as renderers count."""
    return Gf.Vec3f(*(round(float(share), 5) for share in linear_of(np.array(material.color))))


def material_path(stage: Usd.Stage, known: Paths, scope: Sdf.Path, material: Material) -> Sdf.Path:
    """The path of a material, which is made when it is first asked for."""
    if material not in known:
        known[material] = _define_material(stage, free_path(stage, scope, material.name), material)
    return known[material]


def _define_material(stage: Usd.Stage, path: Sdf.Path, material: Material) -> Sdf.Path:
    made = UsdShade.Material.Define(stage, path)
    made.GetPrim().SetDisplayName(material.name)
    shader = UsdShade.Shader.Define(stage, path.AppendChild("Surface"))
    shader.CreateIdAttr("UsdPreviewSurface")
    color = linear_color(material)
    values = [
        ("diffuseColor", Sdf.ValueTypeNames.Color3f, color),
        ("roughness", Sdf.ValueTypeNames.Float, float(material.roughness)),
        ("metallic", Sdf.ValueTypeNames.Float, float(material.metallic)),
    ]
    if material.opacity < 1:
        values.append(("opacity", Sdf.ValueTypeNames.Float, float(material.opacity)))
    if material.emission > 0:
        glow = color * min(float(material.emission), 1.0)
        values.append(("emissiveColor", Sdf.ValueTypeNames.Color3f, glow))
    for name, kind, value in values:
        shader.CreateInput(name, kind).Set(value)
    out = shader.CreateOutput("surface", Sdf.ValueTypeNames.Token)
    made.CreateSurfaceOutput().ConnectToSource(out)
    return path
