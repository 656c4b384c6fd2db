"""Materials as UsdPreviewSurface, each once, below one scope; with textures in packages."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from pxr import Gf, Sdf, Usd, UsdShade

from scenewright.core.catalog import Material
from scenewright.formats.usd.names import free_path
from scenewright.formats.usd.physics import rub
from scenewright.render.colour import linear_of
from scenewright.render.textures.pictures import color_picture, normal_picture
from scenewright.render.textures.table import Texture, texture_of

TYPES = Sdf.ValueTypeNames
PLACES = "st"
"""The primvar of places on a texture."""
FOLDER = "textures"


@dataclass(frozen=True, slots=True)
class MaterialScope:
    """Where materials are, those ``known``, and files of textures by their path; ``pictures`` is
    None where a file cannot hold any."""

    path: Sdf.Path
    pictures: dict[str, bytes] | None = None
    known: dict[Material, Sdf.Path] = field(default_factory=dict)

    def texture(self, material: Material) -> Texture | None:
        """The texture a material wears here."""
        return texture_of(material.name) if self.pictures is not None else None


def linear_color(material: Material) -> Gf.Vec3f:
    """The colour in linear light, as renderers count."""
    return Gf.Vec3f(*(round(float(share), 5) for share in linear_of(np.array(material.color))))


def material_path(stage: Usd.Stage, scope: MaterialScope, material: Material) -> Sdf.Path:
    """The path of a material, which is made when it is first asked for."""
    if material not in scope.known:
        path = free_path(stage, scope.path, material.name)
        scope.known[material] = path
        _define_material(stage, path, material, scope)
    return scope.known[material]


def _define_material(
    stage: Usd.Stage, path: Sdf.Path, material: Material, scope: MaterialScope
) -> None:
    made = UsdShade.Material.Define(stage, path)
    made.GetPrim().SetDisplayName(material.name)
    rub(made.GetPrim(), material.name)
    shader = _shader(stage, path, "Surface", "UsdPreviewSurface")
    color = linear_color(material)
    diffuse = shader.CreateInput("diffuseColor", TYPES.Color3f)
    diffuse.Set(color)
    shader.CreateInput("roughness", TYPES.Float).Set(float(material.roughness))
    shader.CreateInput("metallic", TYPES.Float).Set(float(material.metallic))
    if material.opacity < 1:
        shader.CreateInput("opacity", TYPES.Float).Set(float(material.opacity))
    if material.emission > 0:
        glow = color * min(float(material.emission), 1.0)
        shader.CreateInput("emissiveColor", TYPES.Color3f).Set(glow)
    made.CreateSurfaceOutput().ConnectToSource(shader.CreateOutput("surface", TYPES.Token))
    row = scope.texture(material)
    if row is not None and scope.pictures is not None:
        _wear(stage, path, shader, row, scope.pictures)


def _shader(stage: Usd.Stage, parent: Sdf.Path, name: str, kind: str) -> UsdShade.Shader:
    shader = UsdShade.Shader.Define(stage, parent.AppendChild(name))
    shader.CreateIdAttr(kind)
    return shader


def _wear(
    stage: Usd.Stage,
    path: Sdf.Path,
    surface: UsdShade.Shader,
    row: Texture,
    pictures: dict[str, bytes],
) -> None:
    """The textures of colour and of relief, whose files are added to ``pictures``."""
    reader = _shader(stage, path, "Places", "UsdPrimvarReader_float2")
    reader.CreateInput("varname", TYPES.String).Set(PLACES)
    places = reader.CreateOutput("result", TYPES.Float2)
    picture = color_picture(row.name)
    diffuse = surface.GetInput("diffuseColor")
    factors = np.minimum(np.array(diffuse.Get()) * picture.factor, 1.0)
    scale = Gf.Vec4f(*(round(float(share), 5) for share in factors), 1.0)
    color = _picture(stage, path, "Color", places, _keep(pictures, row.name, picture.content))
    color.CreateInput("sourceColorSpace", TYPES.Token).Set("sRGB")
    color.CreateInput("scale", TYPES.Float4).Set(scale)
    diffuse.ConnectToSource(color.CreateOutput("rgb", TYPES.Float3))
    if row.relief:
        file = _keep(pictures, f"{row.name} normals", normal_picture(row.name))
        relief = _picture(stage, path, "Relief", places, file)
        relief.CreateInput("sourceColorSpace", TYPES.Token).Set("raw")
        relief.CreateInput("scale", TYPES.Float4).Set(Gf.Vec4f(2.0, 2.0, 2.0, 1.0))
        relief.CreateInput("bias", TYPES.Float4).Set(Gf.Vec4f(-1.0, -1.0, -1.0, 0.0))
        normal = surface.CreateInput("normal", TYPES.Normal3f)
        normal.ConnectToSource(relief.CreateOutput("rgb", TYPES.Float3))


def _picture(
    stage: Usd.Stage, parent: Sdf.Path, name: str, places: UsdShade.Output, file: str
) -> UsdShade.Shader:
    made = _shader(stage, parent, name, "UsdUVTexture")
    made.CreateInput("file", TYPES.Asset).Set(file)
    made.CreateInput("st", TYPES.Float2).ConnectToSource(places)
    for axis in ("wrapS", "wrapT"):
        made.CreateInput(axis, TYPES.Token).Set("repeat")
    return made


def _keep(pictures: dict[str, bytes], name: str, content: bytes) -> str:
    file = f"{FOLDER}/{name.replace(' ', '_')}.jpg"
    pictures.setdefault(file, content)
    return file
