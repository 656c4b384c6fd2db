"""Words of several verbs: what is read and how, with what beside it, and what is written."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from scenewright.cli import completion
from scenewright.core.errors import InputError
from scenewright.core.map_options import MapOptions, place_in

INPUT = "A file, or sample:NAME."

InputsArgument = Annotated[
    list[str], typer.Argument(metavar="INPUT...", help=INPUT, autocompletion=completion.inputs)
]
InputArgument = Annotated[
    str, typer.Argument(metavar="INPUT", help=INPUT, autocompletion=completion.inputs)
]
OutputsOption = Annotated[
    list[Path] | None,
    typer.Option(
        "-o",
        "--output",
        metavar="OUT",
        help="Output file; may be repeated.",
        autocompletion=completion.outputs,
    ),
]
PresetOption = Annotated[
    str,
    typer.Option(help="Named set of weights and parameters.", autocompletion=completion.presets),
]
SolverOption = Annotated[
    str | None, typer.Option(help="Solver by name.", autocompletion=completion.solvers)
]

KeepOption = Annotated[bool, typer.Option("--keep", help="Keep the furniture of a file in place.")]
ScaleOption = Annotated[
    float,
    typer.Option(
        min=0.001,
        max=1000,
        help="Multiply all lengths in plan (2: drawn half as large as it is); heights, of sills, "
        "doors and ceilings too, and sizes of furniture stay. 0.01 reads centimetres, "
        "0.001 millimetres, 0.0254 inches. Of a PDF or SVG: the 50 of 1:50.",
    ),
]
HiddenOption = Annotated[
    bool, typer.Option("--hidden-levels", help="Include the hidden levels of a .sh3d.")
]
AlternativesOption = Annotated[
    int, typer.Option(min=1, max=50, help="Number of distinct plans, ranked: OUT-1, OUT-2 …")
]
StepsOption = Annotated[
    int | None, typer.Option(help="Search budget in steps (homes, halls, sites).")
]
LayoutsOption = Annotated[
    int | None, typer.Option(help="Search budget in layouts (villages, extensions).")
]
CatalogOption = Annotated[
    list[str] | None,
    typer.Option("--catalog", metavar="PATH", help="Models of your own; may be repeated."),
]
GroupsOption = Annotated[
    list[str] | None,
    typer.Option("--groups", metavar="PATH", help="Learned groups; may be repeated."),
]
ClutterOption = Annotated[
    str, typer.Option(metavar="AMOUNT", help="Small objects about: none, some or lived-in.")
]
StyleOption = Annotated[
    str,
    typer.Option(
        "--style",
        metavar="STYLE",
        help="By name, or a file that learn has written.",
        autocompletion=completion.styles,
    ),
]
CrsOption = Annotated[
    str,
    typer.Option(
        "--crs", metavar="CRS", help="Reference system of a map, such as EPSG:25832, over its own."
    ),
]
OriginOption = Annotated[
    str,
    typer.Option(
        "--origin", metavar="X,Y", help="Place of a map that becomes 0, 0; or longitude,latitude."
    ),
]
LayerOption = Annotated[
    list[str] | None,
    typer.Option("--layer", metavar="LAYER", help="Only this layer of a map; may be repeated."),
]
SiteOption = Annotated[
    str,
    typer.Option(
        "--site",
        metavar="PLACE",
        help="Ground of a map to build on: the id of an area, or X,Y (longitude,latitude) in one "
        "or between streets.",
    ),
]


def map_options_of(crs: str, origin: str, layers: list[str] | None, site: str) -> MapOptions:
    """The options of a map. InputError for an origin that is no place."""
    place = place_in(origin) if origin else None
    if origin and place is None:
        fault = f"--origin '{origin[:40]}' is no place"
        raise InputError(fault, "give two numbers, such as --origin 11.07,49.45")
    return MapOptions(crs, place, tuple(layers or ()), site)
