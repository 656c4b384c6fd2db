"""The table of formats: a row a suffix, and the module that reads or writes it, loaded on use."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from scenewright.core.errors import InputError
from scenewright.core.extras import install_line
from scenewright.core.plugins import load_plugins
from scenewright.core.registry import JUDGED, SEEN, Format, domain_names, domain_of

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

    from scenewright.domains.contract import Domain

SWEET_HOME = (".sh3d", ".xml")
"""Suffixes of files whose levels may be hidden."""


FLAT = ("heights of rooms", "3D shapes", *JUDGED)
DRAWN = ("hanging lamps", *FLAT)
"""Contents that plans cannot hold."""

FORMATS = (
    Format(
        ".json",
        "brief (read), solution (read as a brief with its locked pieces, written)",
        "scenewright.formats.brief_json",
        "scenewright.formats.solution_json",
    ),
    Format(".sh3d", "Sweet Home 3D home", "scenewright.formats.sh3d"),
    Format(".xml", "Home.xml of a Sweet Home 3D home", "scenewright.formats.sh3d"),
    Format(".geojson", "indoor map or site (OpenStreetMap, read)", "scenewright.formats.geojson"),
    *(
        Format(suffix, f"{about} (read)", "scenewright.formats.gis")
        for suffix, about in {
            ".osm": "map, OpenStreetMap XML",
            ".osm.gz": "the same, packed",
            ".osm.bz2": "the same, packed",
            ".pbf": "map, OpenStreetMap PBF",
            ".gpkg": "map, GeoPackage: all its layers",
            ".shp": "map, shapefile with what lies beside it",
            ".zip": "map, shapefiles or others packed",
            ".kml": "map, KML",
            ".kmz": "the same, packed",
        }.items()
    ),
    Format(
        ".glb",
        "3D scene, binary glTF 2.0",
        writer="scenewright.formats.glb",
        lacks=("dimensions", "outlets", *JUDGED),
    ),
    Format(
        ".nodes.glb",
        "the same, everything a mesh of its own",
        writer="scenewright.formats.nodes_glb",
        lacks=("dimensions", "outlets", *JUDGED),
    ),
    Format(
        ".webp.glb",
        "the same as .glb, its textures as WebP",
        writer="scenewright.formats.webp_glb",
        lacks=("dimensions", "outlets", *JUDGED),
    ),
    Format(
        ".game.glb",
        "the same for engines: levels of detail, collision meshes",
        writer="scenewright.formats.game_glb",
        lacks=("dimensions", "outlets", *JUDGED),
    ),
    Format(
        ".procthor.json",
        "house of ProcTHOR, for AI2-THOR (read and written)",
        "scenewright.formats.simulation.procthor",
        "scenewright.formats.simulation.procthor",
        lacks=("columns", "sloped ceilings", "stairs", "outlets", "3D shapes", *JUDGED),
    ),
    Format(
        ".mjcf.xml",
        "3D scene to simulate, MJCF of MuJoCo",
        writer="scenewright.formats.simulation.mjcf",
        lacks=("dimensions", "outlets", *JUDGED),
    ),
    Format(
        ".sceneeval.json",
        "scene state of SceneEval, for judges of scenes",
        writer="scenewright.formats.simulation.scene_eval",
        lacks=("columns", "sloped ceilings", "stairs", "outlets", "3D shapes", *JUDGED),
    ),
    *(
        Format(
            suffix,
            f"3D scene to simulate, OpenUSD {form}",
            writer="scenewright.formats.usd",
            lacks=("dimensions", "outlets", *JUDGED),
        )
        for suffix, form in {".usda": "as text", ".usdc": "as binary", ".usdz": "packed"}.items()
    ),
    Format(
        ".ifc",
        "building model (IFC2x to IFC4x3, read; IFC4, or the one that was read with more, written)",
        "scenewright.formats.ifc",
        "scenewright.formats.ifc",
        extends=True,
        lacks=("glow of materials", "sloped ceilings", "outlets", *JUDGED),
    ),
    Format(".ifczip", "building model, zipped (read)", "scenewright.formats.ifc"),
    Format(
        ".svg",
        "plan drawing (read and written)",
        "scenewright.formats.painted.svg",
        "scenewright.formats.svg",
        lacks=("ids", *FLAT),
    ),
    Format(
        ".dxf",
        "plan for CAD (read; written in metres)",
        "scenewright.formats.dxf.plan",
        "scenewright.formats.dxf",
        lacks=DRAWN,
    ),
    Format(
        ".mm.dxf",
        "plan for CAD in millimetres",
        writer="scenewright.formats.dxf.millimetres",
        lacks=DRAWN,
    ),
    Format(
        ".3d.dxf",
        "3D scene for CAD, meshes",
        writer="scenewright.formats.dxf.solids",
        lacks=("gloss and glow of materials", "names of rooms", "dimensions", "outlets", *JUDGED),
    ),
    Format(
        ".pdf",
        "set of sheets to print (a plan in it is read)",
        "scenewright.formats.painted.pdf",
        "scenewright.formats.pdf",
        lacks=("ids", "3D shapes", *JUDGED),
    ),
    Format(
        ".credits.txt", "authors and licences of the models", writer="scenewright.formats.credits"
    ),
    Format(".png", "picture from above", writer="scenewright.formats.png", lacks=SEEN),
    Format(
        ".room.png",
        "photographs of all rooms of a home or hall on one sheet",
        writer="scenewright.formats.room_png",
        lacks=SEEN,
    ),
)


def suffix_of(path: str | os.PathLike[str]) -> str:
    """The suffix by which a file's format is found, as it is written there.

    >>> suffix_of("a/site.street.png"), suffix_of("site.png"), suffix_of("notes.txt")
    ('.street.png', '.png', '.txt')
    """
    name = Path(path).name
    fitting = [len(row.suffix) for row in formats() if _fits(row, name.lower())]
    return name[-max(fitting) :] if fitting else Path(name).suffix


def formats() -> tuple[Format, ...]:
    """All formats: the rows above, those of the domains, and those other packages add."""
    own = tuple(row for kind in domains() for row in kind.formats)
    return FORMATS + own + _added_formats()


@cache
def _added_formats() -> tuple[Format, ...]:
    """The formats of other packages; those that cannot be used are left out."""
    return tuple(row for _, row in load_plugins("scenewright.formats", _check_format))


def _check_format(entry: EntryPoint, module: Any) -> Format:
    """The row of a module of another package, which may only read or only write."""
    reads, writes = (callable(getattr(module, name, None)) for name in ("read", "write"))
    if not entry.name.startswith(".") or entry.name == ".":
        raise TypeError("is called by no suffix, such as '.dxf'")
    if not (isinstance(module, ModuleType) and (reads or writes)):
        raise TypeError("is no module with a function 'read' or 'write'")
    return Format(entry.name, entry.value, entry.value * reads, entry.value * writes)


def domains() -> tuple[Domain, ...]:
    """All domains."""
    return tuple(domain_of(name) for name in domain_names())


def row_of(path: str | os.PathLike[str], part: str, domain: str = "") -> Format:
    """The row of the longest suffix that fits, and of those the one of the domain, of the rows that
    have the ``part``, ``reader`` or ``writer``; InputError if there is none."""
    name = Path(path).name.lower()
    suffix = Path(name).suffix
    rows = [row for row in formats() if getattr(row, part)]
    fitting = [row for row in rows if _fits(row, name)]
    if not fitting:
        usable = dict.fromkeys(row.suffix for row in rows if not domain or row.holds(domain))
        verb = "read" if part == "reader" else "written"
        text = f"'{suffix}' files cannot be {verb}" if suffix else "the name has no suffix"
        raise InputError(text, f"use one of: {', '.join(usable)}", file=str(path))
    return min(fitting, key=lambda row: (-len(row.suffix), not row.holds(domain)))


def _fits(row: Format, name: str) -> bool:
    """Whether a file's name ends in a row's suffix, and has more than that."""
    return name.endswith(row.suffix) and len(name) > len(row.suffix)


def load_function(module: str, name: str, path: str | os.PathLike[str]) -> Callable[..., Any]:
    """A function of the module of a format."""
    found: Callable[..., Any] | None = getattr(load_module(module, path), name, None)
    if found is None:
        raise InputError(
            f"the format's module {module} has no function '{name}'",
            "use another format",
            file=str(path),
        )
    return found


def load_module(name: str, path: str | os.PathLike[str]) -> ModuleType:
    """The module of a format; InputError with the line that installs what it lacks."""
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        raise InputError(
            f"this format needs the package '{error.name}'",
            install_line(error.name or ""),
            file=str(path),
        ) from None
