"""The command by which a file that is not read here becomes one that is."""

from __future__ import annotations

PLAIN_GLTF = "npx @gltf-transform/cli copy IN.glb OUT.glb"
"""glTF-Transform: writes a compressed glTF file without compression."""
ASSIMP = "assimp export IN{suffix} OUT.glb -fglb2"
"""The Open Asset Import Library's program."""
BLENDER = (
    "blender -b IN.blend --python-expr "
    "\"import bpy; bpy.ops.export_scene.gltf(filepath='OUT.glb')\""
)
EXPORT = "export it as glTF (.glb) from the program it was made with"

CONVERSIONS = {
    **dict.fromkeys(
        (".fbx", ".dae", ".3ds", ".ply", ".3mf", ".x3d", ".x", ".lwo", ".off", ".ac", ".ase"),
        ASSIMP,
    ),
    ".blend": BLENDER,
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), "import it in Blender and export glTF"),
    **dict.fromkeys(
        (".skp", ".max", ".ma", ".mb", ".c4d", ".rfa", ".step", ".stp", ".iges", ".kmz"), EXPORT
    ),
}
"""Models of other programs by suffix, and what makes them readable."""


def conversion_of(suffix: str) -> str:
    """The command or the step that makes a file of a suffix readable; empty where none is known.

    >>> conversion_of(".fbx")
    'assimp export IN.fbx OUT.glb -fglb2'
    """
    return CONVERSIONS.get(suffix, "").replace("{suffix}", suffix)
