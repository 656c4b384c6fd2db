"""The verb ``fold``: rows of buildings, and the storeys of a model, as folded strings."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from scenewright.cli import tables
from scenewright.core.atomic_file import check_targets, write_atomically
from scenewright.core.errors import InputError

SCENES = (".geojson", ".json", ".cityjson", ".jsonl")
"""Suffixes of scenes besides those of GIS maps."""
MOST_ROWS = 12
"""Rows shown."""


def fold(
    source: Annotated[
        str,
        typer.Argument(
            metavar="INPUT", help='A scene, map, sample:NAME, model (.glb) or string "A B A B".'
        ),
    ],
    to: Annotated[
        int | None, typer.Option(min=1, max=2000, help="Unfold to about this many elements.")
    ] = None,
    axis: Annotated[str, typer.Option(help="Of a model: z (storeys), x or y (bays).")] = "z",
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="OUT.obj", help="With --to: the model grown."),
    ] = None,
    grammar: Annotated[
        bool, typer.Option("--grammar", help="The layout as a grammar: groups, features, arrays.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
) -> int:
    """Fold repeated neighbours: rows of a scene, storeys or bays of a model, or a string."""
    if axis not in ("x", "y", "z"):
        raise InputError(f"'{axis}' is no axis", "give x, y or z")
    source = _find_sample(source)
    suffix = Path(source).suffix.lower()
    scene = _is_scene(source)
    if scene:
        rows = scene_rows(Path(source), to)
    elif suffix and Path(source).exists():
        rows = model_rows(Path(source), "xyz".index(axis), to, output)
    elif suffix and " " not in source:
        raise InputError("there is no such file", "check the path", file=source)
    else:
        rows = [_row("string", _parse_string(source), to)]
    if output is not None and scene:
        raise InputError("only models are written", "give a .glb or .obj", file=str(output))
    lines = _layout_lines(source, suffix, axis, to) if grammar else []
    if as_json:
        tables.print_json({"grammar": lines, "folded": rows} if grammar else rows)
        return 0
    console = tables.output_console()
    for line in lines:
        tables.print_line(console, line)
    tables.table(console, rows[:MOST_ROWS], title="folded", whole=("folded",))
    if output is not None:
        tables.print_line(console, f"wrote {output}", "dim")
    return 0


def _is_scene(source: str) -> bool:
    """Whether a source holds buildings by its suffix: a map, a city model, a saved solution."""
    from scenewright.ground.geodata.kinds import is_map

    return source.lower().endswith(SCENES) or is_map(source)


def _find_sample(source: str) -> str:
    """The file of a sample, any other source as it is."""
    from scenewright.formats.opening import SAMPLE, open_source

    return str(open_source(source).path) if source.startswith(SAMPLE) else source


def _layout_lines(source: str, suffix: str, axis: str, to: int | None) -> list[str]:
    """The productions of a scene, of the first model of a file, or of a string; grown to ``to``
    elements, if asked for."""
    from scenewright.geometry.folding import unfold
    from scenewright.ground.buildings.grammar import grow_layout, parse_slabs, show_layout

    if _is_scene(source):
        layout = _scene_layout(Path(source))
    elif suffix and Path(source).exists():
        layout = parse_slabs(_model_slabs(Path(source), "xyz".index(axis))[0][1])
    else:
        layout = parse_slabs(_parse_string(source))
    if to is not None:
        arrays = [a for g in layout.groups for f in g.features for a in f.arrays]
        count = sum(len(unfold(array.elements)) for array in arrays)
        layout = grow_layout(layout, to / max(count, 1))
    lines = [f"symmetry value {layout.symmetry:.2f}"] if layout.symmetry else []
    return [*show_layout(layout), *lines]


def _scene_layout(path: Path) -> Any:
    from scenewright.ground.buildings.built import frames_of
    from scenewright.ground.buildings.grammar import parse_scene
    from scenewright.ground.buildings.kinds import name_kinds
    from scenewright.ground.reading import read_built

    scene = read_built(path)
    frames = frames_of(scene.buildings, scene.roads)
    return parse_scene(frames, name_kinds(scene.buildings, frames))


def _parse_string(text: str) -> tuple[str, ...]:
    from scenewright.geometry.folding import parse, unfold

    try:
        return unfold(parse(text))
    except ValueError as error:
        raise InputError(str(error), 'write it as "(A B)^3 C"') from None


def _row(name: str, symbols: tuple[str, ...], to: int | None) -> dict[str, Any]:
    from scenewright.geometry import folding

    if not symbols or len(symbols) > folding.MOST:
        raise InputError(
            f"has {len(symbols)} elements", f"1 to {folding.MOST} are folded", place=name
        )
    folded = folding.fold(symbols)
    found: dict[str, Any] = {
        "of": name,
        "elements": len(symbols),
        "folded": folding.show(folded),
        "cost": round(folding.cost_of(folded) / len(symbols), 3),
    }
    if to is not None:
        longer = folding.stretch(folded, to)
        found["grown"] = folding.show(longer)
        found["to"] = len(folding.unfold(longer))
    return found


def scene_rows(path: Path, to: int | None) -> list[dict[str, Any]]:
    """The rows of a scene, the longest first."""
    from scenewright.ground.buildings.built import frames_of
    from scenewright.ground.buildings.kinds import name_kinds
    from scenewright.ground.buildings.rows import find_rows, string_of
    from scenewright.ground.reading import read_built

    scene = read_built(path)
    frames = frames_of(scene.buildings, scene.roads)
    letters = name_kinds(scene.buildings, frames)
    found = [
        _row(f"row {k + 1}, pitch {row.pitch:.1f} m", string_of(row, letters), to)
        for k, row in enumerate(find_rows(frames))
    ]
    if not found:
        raise InputError(
            "holds no row of three buildings", "give a scene with rows", file=str(path)
        )
    return found


def model_rows(path: Path, axis: int, to: int | None, output: Path | None) -> list[dict[str, Any]]:
    """The slabs of each model of a file, and the first grown, if asked for."""
    models = _model_slabs(path, axis)
    found = [_row(name, symbols, to) for name, symbols, _ in models]
    if output is not None:
        _write_grown(models[0][2], axis, to, output)
    return found


def _model_slabs(path: Path, axis: int) -> list[tuple[str, tuple[str, ...], Any]]:
    """The id, the slabs and the parts of each model of a file."""
    from scenewright.catalog.loading import read_entry
    from scenewright.core.brief.catalog import entry_of
    from scenewright.geometry.mesh import Mesh, merge
    from scenewright.geometry.slabs import slabs_of

    found = []
    for one in read_entry(entry_of(str(path))).models:
        mesh = merge([Mesh(part.vertices, part.faces) for part in one.model.parts])
        found.append((one.model.id, slabs_of(mesh, axis).symbols, one.model.parts))
    if not found:
        raise InputError("holds no model", "give a .glb or .obj", file=str(path))
    return found


def _write_grown(parts: Any, axis: int, to: int | None, output: Path) -> None:
    """The model with its longest repeat turning often enough, as OBJ."""
    from scenewright.geometry.mesh import Mesh, merge
    from scenewright.geometry.slabs import grow_slabs, repeated_part, slabs_of

    if to is None or output.suffix.lower() != ".obj":
        raise InputError("grown models are written as .obj", "give --to N", file=str(output))
    check_targets([output])
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    slabs = slabs_of(mesh, axis)
    start, end, times = repeated_part(slabs.symbols)
    if not times:
        raise InputError("nothing in it repeats along that axis", "try another axis")
    more = max(round((to - len(slabs.symbols)) / (end - start)), 0)
    made = grow_slabs(mesh, slabs, start, end, 1 + more)
    lines = [f"v {x:.5f} {z:.5f} {-y:.5f}" for x, y, z in made.vertices.tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in made.faces.tolist()]
    write_atomically(output, "\n".join(lines) + "\n")
