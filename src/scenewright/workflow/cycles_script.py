"""Run inside Blender 3.4 or later, which has its own Python: renders the views of a job.

``blender -b --python cycles_script.py -- job.json``. Beside the job it writes, of each view, arrays
``N-light.npy``, ``N-body.npy`` and ``N-facing.npy``: linear light, colour and normal of what is
seen first. No module of ours is imported here.
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np

PASSES = {"light": "Image", "body": "DiffCol", "facing": "Normal"}
BOUNCES = 6


def main() -> None:
    """Read the job, import its scene, render its views."""
    import bpy  # the module of the program that runs this

    setattr(np, "bool", bool)  # noqa: B010, the importer of Blender 3.4 asks for it
    path = Path(sys.argv[sys.argv.index("--") + 1])
    job = json.loads(path.read_text(encoding="utf-8"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=job["scene"])
    _remove(bpy, "LIGHT", "CAMERA")
    scene = bpy.context.scene
    _set_up(scene, job)
    for number, view in enumerate(job["views"]):
        _remove(bpy, "LIGHT", "CAMERA")
        _add_camera(bpy, scene, view)
        _add_sun(bpy, scene, view["sun"])
        _add_sky(bpy, scene, view["sky"], view["pane"])
        for lamp in view["lamps"]:
            _add_lamp(bpy, scene, lamp)
        for portal in view["portals"]:
            _add_portal(bpy, scene, portal)
        _render(bpy, scene, path.parent, number)
        sys.stdout.write(f"scenewright view {number}\n")
        sys.stdout.flush()


def _remove(bpy: Any, *kinds: str) -> None:
    for thing in [each for each in bpy.data.objects if each.type in kinds]:
        bpy.data.objects.remove(thing, do_unlink=True)


def _set_up(scene: Any, job: dict[str, Any]) -> None:
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = job["samples"]
    scene.cycles.seed = job["seed"]
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = BOUNCES
    scene.cycles.transparent_max_bounces = 16
    scene.cycles.sample_clamp_indirect = 4.0
    scene.cycles.caustics_reflective = scene.cycles.caustics_refractive = False
    scene.view_settings.view_transform = "Raw"
    layer = scene.view_layers[0]
    layer.use_pass_diffuse_color = layer.use_pass_normal = True


def _add(bpy: Any, scene: Any, name: str, data: Any) -> Any:
    thing = bpy.data.objects.new(name, data)
    scene.collection.objects.link(thing)
    return thing


def _placed(at: Any, right: Any, up: Any, back: Any) -> Any:
    """The matrix of a thing at a place with three axes."""
    from mathutils import Matrix  # of Blender too

    rows = [[*(float(axis[k]) for axis in (right, up, back)), float(at[k])] for k in range(3)]
    return Matrix([*rows, [0.0, 0.0, 0.0, 1.0]])


def _add_camera(bpy: Any, scene: Any, view: dict[str, Any]) -> None:
    lens = bpy.data.cameras.new("photo")
    lens.sensor_fit = "HORIZONTAL"
    lens.angle = view["wide"]
    lens.shift_y = view["shift"]
    lens.clip_start = 0.02
    right, up, ahead = (np.array(axis) for axis in view["axes"])
    thing = _add(bpy, scene, "photo", lens)
    thing.matrix_world = _placed(view["eye"], right, up, -ahead)
    scene.camera = thing
    scene.render.resolution_x, scene.render.resolution_y = view["size"]
    scene.render.resolution_percentage = 100


def _add_sun(bpy: Any, scene: Any, sun: dict[str, Any]) -> None:
    top = max(sun["light"])
    if top <= 0:
        return
    lamp = bpy.data.lights.new("sun", "SUN")
    lamp.energy, lamp.color = top, [share / top for share in sun["light"]]
    lamp.angle = 2 * math.atan(0.008)
    to = np.array(sun["to"]) / np.linalg.norm(sun["to"])
    side = np.cross([0.0, 0.0, 1.0], to)
    side /= np.linalg.norm(side)
    _add(bpy, scene, "sun", lamp).matrix_world = _placed((0, 0, 0), side, np.cross(to, side), to)


def _add_lamp(bpy: Any, scene: Any, row: dict[str, Any]) -> None:
    """A ball of light: watts are 4 pi times the intensity."""
    top = max(row["light"])
    lamp = bpy.data.lights.new("lamp", "POINT")
    lamp.energy, lamp.color = 4 * math.pi * top, [share / top for share in row["light"]]
    lamp.shadow_soft_size = row["radius"]
    lamp.cycles.max_bounces = 4
    _add(bpy, scene, "lamp", lamp).location = row["at"]


def _add_portal(bpy: Any, scene: Any, row: dict[str, Any]) -> None:
    """A window, through which rays look for the sky first."""
    lamp = bpy.data.lights.new("window", "AREA")
    lamp.shape, (lamp.size, lamp.size_y) = "RECTANGLE", row["size"]
    lamp.cycles.is_portal = True
    x, y = row["out"]
    placed = _placed(row["at"], (-y, x, 0), (0, 0, 1), (x, y, 0))
    _add(bpy, scene, "window", lamp).matrix_world = placed


def _add_sky(bpy: Any, scene: Any, sky: list[list[float]], pane: float) -> None:
    """Ground, horizon and zenith, darker where the camera itself sees them."""
    world = bpy.data.worlds.new("sky")
    scene.world, world.use_nodes = world, True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    place, parts = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeSeparateXYZ")
    links.new(place.outputs["Generated"], parts.inputs[0])
    share = _math(nodes, links, "SQRT", _math(nodes, links, "MAXIMUM", parts.outputs["Z"], 0.0))
    above = _mix(nodes, links, share, sky[1], sky[2])
    is_up = _math(nodes, links, "GREATER_THAN", parts.outputs["Z"], 0.0)
    whole = _mix(nodes, links, is_up, sky[0], above)
    seen = nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"]
    back = nodes["Background"]
    links.new(whole, back.inputs["Color"])
    less = _math(nodes, links, "MULTIPLY", seen, pane - 1.0)
    links.new(_math(nodes, links, "ADD", less, 1.0), back.inputs["Strength"])


def _math(nodes: Any, links: Any, operation: str, first: Any, second: float | None = None) -> Any:
    node = nodes.new("ShaderNodeMath")
    node.operation = operation
    links.new(first, node.inputs[0])
    if second is not None:
        node.inputs[1].default_value = second
    return node.outputs[0]


def _mix(nodes: Any, links: Any, share: Any, first: list[float], second: Any) -> Any:
    node = nodes.new("ShaderNodeMixRGB")
    links.new(share, node.inputs["Fac"])
    node.inputs["Color1"].default_value = [*first, 1.0]
    if isinstance(second, list):
        node.inputs["Color2"].default_value = [*second, 1.0]
    else:
        links.new(second, node.inputs["Color2"])
    return node.outputs[0]


def _render(bpy: Any, scene: Any, folder: Path, number: int) -> None:
    """Render, and keep the passes as arrays, the upper row first."""
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    layers, out = nodes.new("CompositorNodeRLayers"), nodes.new("CompositorNodeOutputFile")
    out.base_path = str(folder)
    out.format.file_format, out.format.color_depth = "OPEN_EXR", "32"
    out.file_slots.clear()
    for name, source in PASSES.items():
        out.file_slots.new(f"{number}-{name}-")
        links.new(layers.outputs[source], out.inputs[-1])
    bpy.ops.render.render()
    for name in PASSES:
        (path,) = folder.glob(f"{number}-{name}-*.exr")
        image = bpy.data.images.load(str(path))
        image.colorspace_settings.name = "Non-Color"
        wide, high = image.size
        values = np.empty(wide * high * 4, np.float32)
        image.pixels.foreach_get(values)
        np.save(folder / f"{number}-{name}.npy", values.reshape(high, wide, 4)[::-1, :, :3])
        bpy.data.images.remove(image)


if __name__ == "__main__":
    main()
