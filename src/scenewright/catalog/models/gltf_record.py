"""The parts of a glTF document that models need, checked field by field.

Khronos Group, *glTF 2.0 Specification* (2021), section 5. Keys that are not listed are ignored.
"""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, Field, ValidationError

from scenewright.core.document_faults import to_input_error

Whole = Annotated[int, Field(strict=True, ge=0, le=2**40)]
Number = Annotated[float, Field(allow_inf_nan=False, ge=-1e12, le=1e12)]
MOST_NODES = 200_000
Triple = tuple[Number, Number, Number]
Quadruple = tuple[Number, Number, Number, Number]
Extensions = dict[str, Any]


class About(BaseModel):
    """Who made the file, by which version of the format."""

    version: str
    copyright: str = ""
    extras: Any = None


class Buffer(BaseModel):
    """Raw bytes: in the file, in its name (``data:``) or in a file beside it."""

    byteLength: Whole  # noqa: N815
    uri: str | None = None


class BufferView(BaseModel):
    """A stretch of a buffer."""

    buffer: Whole
    byteLength: Whole  # noqa: N815
    byteOffset: Whole = 0  # noqa: N815
    byteStride: Annotated[int, Field(strict=True, ge=4, le=252)] | None = None  # noqa: N815
    extensions: Extensions = {}


class SparseIndices(BaseModel):
    """Where a sparse accessor differs."""

    bufferView: Whole  # noqa: N815
    componentType: Whole  # noqa: N815
    byteOffset: Whole = 0  # noqa: N815


class SparseValues(BaseModel):
    """What a sparse accessor has there."""

    bufferView: Whole  # noqa: N815
    byteOffset: Whole = 0  # noqa: N815


class Sparse(BaseModel):
    """The exceptions of an accessor."""

    count: Whole
    indices: SparseIndices
    values: SparseValues


class Accessor(BaseModel):
    """Numbers of one type in a stretch of a buffer."""

    componentType: Whole  # noqa: N815
    count: Whole
    type: str
    bufferView: Whole | None = None  # noqa: N815
    byteOffset: Whole = 0  # noqa: N815
    normalized: bool = False
    sparse: Sparse | None = None


class Primitive(BaseModel):
    """Triangles (or points or lines) of one material."""

    attributes: dict[str, Whole]
    indices: Whole | None = None
    material: Whole | None = None
    mode: Whole = 4
    extensions: Extensions = {}


class Body(BaseModel):
    """A mesh."""

    primitives: list[Primitive] = []


class GltfNode(BaseModel):
    """A place in the tree, with a mesh or nodes below it."""

    name: Any = None
    extras: Any = None
    mesh: Whole | None = None
    children: list[Whole] = []
    matrix: Annotated[list[Number], Field(min_length=16, max_length=16)] | None = None
    translation: Triple = (0.0, 0.0, 0.0)
    rotation: Quadruple = (0.0, 0.0, 0.0, 1.0)
    scale: Triple = (1.0, 1.0, 1.0)
    extensions: Extensions = {}


class GltfScene(BaseModel):
    """A scene: the roots of its nodes."""

    nodes: list[Whole] = []


class TextureInfo(BaseModel):
    """Which texture, by which coordinates."""

    index: Whole
    texCoord: Annotated[int, Field(ge=0, le=31)] = 0  # noqa: N815
    extensions: Extensions = {}


class Roughness(BaseModel):
    """The metallic-roughness model of a material."""

    baseColorFactor: Quadruple = (1.0, 1.0, 1.0, 1.0)  # noqa: N815
    baseColorTexture: TextureInfo | None = None  # noqa: N815
    metallicFactor: Number = 1.0  # noqa: N815
    roughnessFactor: Number = 1.0  # noqa: N815
    metallicRoughnessTexture: Any = None  # noqa: N815


class GltfMaterial(BaseModel):
    """A material."""

    name: str = ""
    pbrMetallicRoughness: Roughness | None = None  # noqa: N815
    alphaMode: str = "OPAQUE"  # noqa: N815


class Texture(BaseModel):
    """Which image a texture shows."""

    source: Whole | None = None


class Image(BaseModel):
    """An image: a file or a stretch of a buffer."""

    uri: str | None = None
    bufferView: Whole | None = None  # noqa: N815


class Document(BaseModel):
    """A whole glTF document."""

    asset: About
    scene: Whole | None = None
    scenes: list[GltfScene] = []
    nodes: Annotated[list[GltfNode], Field(max_length=MOST_NODES)] = []
    meshes: list[Body] = []
    materials: list[GltfMaterial] = []
    textures: list[Texture] = []
    images: list[Image] = []
    accessors: list[Accessor] = []
    bufferViews: list[BufferView] = []  # noqa: N815
    buffers: list[Buffer] = []
    extensionsRequired: list[str] = []  # noqa: N815


def check_document(document: dict[str, Any]) -> Document:
    """The document, or an InputError that names the place of its first fault."""
    try:
        return Document.model_validate(document)
    except ValidationError as error:
        raise to_input_error(error) from None
