"""The whole MJCF model of a scene: options, shell, things, light, cameras, places, key frames."""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement

import numpy as np
import shapely

from scenewright._version import __version__
from scenewright.core.catalog import Catalog, Material, Part
from scenewright.core.scene import Prism, Scene
from scenewright.formats.simulation.mjcf.assets import Assets, write_numbers
from scenewright.formats.simulation.mjcf.bodies import World, add_item, add_parts, add_solid
from scenewright.formats.simulation.mjcf.places import VIEW, camera_axes, room_places
from scenewright.formats.simulation.solids import column_of
from scenewright.geometry.mesh import Floats
from scenewright.geometry.prisms import face_normals, sheet
from scenewright.render.daylight import sun_at
from scenewright.render.items import SLAB, RenderItem, things, to_level_coordinates
from scenewright.render.lamps import lamps_of
from scenewright.render.observations.ceilings import ceilings

STEP = "0.004"
"""Seconds."""
MOST_LIGHTS = 24
"""Lamps that shine, the brightest: MuJoCo draws no more than a hundred."""
BRIGHT = 0.45
"""Strength of the sun."""
LUMENS = 4000.0
"""Lumens of a lamp of full strength."""
SKY = {"type": "skybox", "builtin": "gradient", "rgb1": "0.62 0.76 0.9", "rgb2": "0.9 0.93 0.95"}
SKY |= {"width": "64", "height": "384"}
SHELL = ("wall", "slab", "space", "surface")
SOLID = Material("masonry", (0.7, 0.7, 0.7))


def build_model(scene: Scene, catalog: Catalog) -> Element:
    """The element ``mujoco`` of a scene."""
    root = Element("mujoco", {"model": scene.name or "scene"})
    _add_options(root, scene)
    assets = Assets(SubElement(root, "asset"))
    SubElement(assets.element, "texture", SKY)
    world = World(SubElement(root, "worldbody"), assets)
    heights = {level.id: level.elevation for level in scene.levels}
    found = things(scene, catalog)
    _add_floors(world, found, heights)
    _add_light(world, scene, found, heights, catalog)
    _add_shell(world, (*found, *ceilings(scene)), heights)
    _add_walls(world, scene, heights)
    for item in found:
        if item.kind not in SHELL:
            add_item(world, item, heights[item.level], catalog)
    _add_places(world, scene)
    frames = SubElement(root, "keyframe")
    for name, values in (("drawn", world.drawn), ("shut", world.shut)):
        SubElement(frames, "key", {"name": name, "qpos": write_numbers(values, 7)})
    return root


def _add_options(root: Element, scene: Scene) -> None:
    points = np.concatenate([np.asarray(s.outline) for s in scene.spaces] or [np.zeros((1, 2))])
    low, high = points.min(0), points.max(0)
    middle = (*(low + high) / 2, 1.0)
    SubElement(root, "compiler", {"angle": "radian", "autolimits": "true", "boundmass": "1e-4"})
    root[-1].set("boundinertia", "1e-7")
    option = SubElement(root, "option", {"timestep": STEP, "integrator": "implicitfast"})
    SubElement(option, "flag", {"sleep": "enable"})
    extent = write_numbers((max(float(np.linalg.norm(high - low)) / 2, 1.0),), 3)
    SubElement(root, "statistic", {"center": write_numbers(middle, 3), "extent": extent})
    shown = SubElement(root, "visual")
    SubElement(shown, "global", {"offwidth": "1920", "offheight": "1200"})
    SubElement(shown, "map", {"znear": "0.005", "zfar": "20"})
    SubElement(shown, "headlight", {"ambient": "0.35 0.35 0.35", "diffuse": "0.25 0.25 0.25"})
    SubElement(shown, "quality", {"shadowsize": "4096"})
    text = SubElement(root, "custom")
    SubElement(text, "text", {"name": "generator", "data": f"Scenewright {__version__}"})
    defaults = SubElement(root, "default")
    for name, facts in {
        "seen": {"type": "mesh", "contype": "0", "conaffinity": "0", "group": "2", "mass": "0"},
        "touched": {"group": "3", "rgba": "0.5 0.6 0.7 0.6"},
    }.items():
        SubElement(SubElement(defaults, "default", {"class": name}), "geom", facts)


def _add_floors(world: World, found: tuple[RenderItem, ...], heights: dict[str, float]) -> None:
    """What one stands on: a plane on the lowest level, the slabs of those above."""
    lowest = min(heights.values(), default=0.0)
    plane = {"name": world.assets.free_name("floor"), "class": "touched", "type": "plane"}
    plane |= {"size": "0 0 1", "pos": write_numbers((0, 0, lowest)), "friction": "0.6 0.005 0.0001"}
    SubElement(world.element, "geom", plane)
    for item in found:
        if item.kind == "slab" and heights[item.level] > lowest:
            name = world.assets.free_name(f"{item.name} to stand on")
            place = write_numbers((0, 0, heights[item.level]))
            body = SubElement(world.element, "body", {"name": name, "pos": place})
            for part in item.parts:
                upper = face_normals(part.vertices, part.faces)[:, 2] > 0
                _add_columns(world.assets, body, part.vertices, part.faces[upper], (-SLAB, 0.0))


def _add_shell(world: World, found: tuple[RenderItem, ...], heights: dict[str, float]) -> None:
    """Floors, walls and ceilings as they are seen; ceilings in a group of their own, so that a
    viewer may look in from above."""
    for item in found:
        if item.kind in (*SHELL, "ceiling") and item.parts:
            name = world.assets.free_name(item.name)
            place = write_numbers((0, 0, heights[item.level]))
            body = SubElement(world.element, "body", {"name": name, "pos": place})
            add_parts(world.assets, body, item, item.parts, np.zeros(3), touched=False)
            for geom in body if item.kind == "ceiling" else ():
                geom.set("group", "4")


def _add_walls(world: World, scene: Scene, heights: dict[str, float]) -> None:
    """Walls as they are touched: convex pieces of their prisms."""
    for wall in scene.walls:
        name = world.assets.free_name(f"{wall.id} to touch")
        place = write_numbers((0, 0, heights[wall.level]))
        body = SubElement(world.element, "body", {"name": name, "pos": place})
        for solid in wall.prisms:
            if _is_convex(solid):
                _add_column(world.assets, body, solid.outline, (solid.base, solid.top))
            else:
                cap = sheet(solid.outline, solid.holes, solid.top)
                _add_columns(world.assets, body, cap.vertices, cap.faces, (solid.base, solid.top))


def _is_convex(solid: Prism) -> bool:
    shape = shapely.Polygon(solid.outline, solid.holes)
    return bool(shape.convex_hull.area - shape.area < 1e-4)


def _add_columns(
    assets: Assets,
    body: Element,
    vertices: np.typing.NDArray[np.float64],
    faces: np.typing.NDArray[np.int64],
    z: tuple[float, float],
) -> None:
    """A column over each triangle in plan."""
    for ring in vertices[faces][:, :, :2]:
        _add_column(assets, body, ring, z)


def _add_column(assets: Assets, body: Element, ring: Floats, z: tuple[float, float]) -> None:
    """A solid of masonry over a convex polygon (k, 2)."""
    solid = column_of(ring, *z)
    if solid is not None:
        part = Part(SOLID, np.zeros((0, 3)), np.zeros((0, 3), np.int64))
        add_solid(assets, body, part, solid, np.zeros(3), ("shell", len(assets.meshes)))


def _add_sun(world: World, hour: str) -> None:
    """The sun of an hour, where it has risen; one from behind the reader where none is said."""
    risen, light = sun_at(hour), {"dir": "0.45 -0.6 -0.75", "diffuse": "0.45 0.43 0.4"}
    if risen is not None:
        light["dir"] = write_numbers(-risen.towards)
        light["diffuse"] = write_numbers([BRIGHT * share for share in risen.color], 3)
    if risen is not None or not hour:
        sun = {"name": "sun", "type": "directional", "pos": "0 0 20", "castshadow": "true"}
        SubElement(world.element, "light", sun | light)


def _add_light(
    world: World,
    scene: Scene,
    found: tuple[RenderItem, ...],
    heights: dict[str, float],
    catalog: Catalog,
) -> None:
    """A sun, and the brightest lamps as points of light."""
    _add_sun(world, scene.hour)
    for lamp in sorted(lamps_of(found, catalog), key=lambda lamp: -lamp.lumens)[:MOST_LIGHTS]:
        item = lamp.item
        at = to_level_coordinates(item, np.array([lamp.at]))[0] + (0, 0, heights[item.level])
        top = max(lamp.color)
        strength = min(lamp.lumens / LUMENS, 1.0)
        facts = {
            "name": world.assets.free_name(f"{item.name} light"),
            "type": "point",
            "pos": write_numbers(at),
            "diffuse": write_numbers([share / top * strength for share in lamp.color], 3),
            "attenuation": "1 0 0.4",
            "castshadow": "false",
        }
        SubElement(world.element, "light", facts)


def _add_places(world: World, scene: Scene) -> None:
    """A site to begin at and a camera for each room with free floor, and a camera over all."""
    for place in room_places(scene):
        label = place.space.name or place.space.id
        radius = min(place.clear, 0.5)
        site = {"name": world.assets.free_name(f"spawn {label}"), "type": "cylinder", "group": "4"}
        site |= {"pos": write_numbers(place.spawn), "size": write_numbers((radius, 0.002), 3)}
        SubElement(world.element, "site", site)
        axes = camera_axes(place.eye, place.seen)
        camera = {
            "name": world.assets.free_name(f"camera {label}"),
            "pos": write_numbers(place.eye),
        }
        camera |= {"xyaxes": write_numbers(axes.reshape(-1)), "fovy": write_numbers((VIEW,))}
        SubElement(world.element, "camera", camera)
