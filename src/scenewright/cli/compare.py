"""The verb ``compare``: is it the same place? Two built scenes, measured against each other."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from scenewright.cli import tables
from scenewright.core.errors import InputError

if TYPE_CHECKING:
    from scenewright.ground.buildings.built import BuiltScene
    from scenewright.ground.likeness.places import PlaceComparison


def compare(
    first: Annotated[
        Path, typer.Argument(metavar="A", help="A map, a city model or a saved solution.")
    ],
    second: Annotated[
        Path | None,
        typer.Argument(metavar="B", help="Another; left out: what A grew beside what it grew of."),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Seed of the shuffles.")] = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
) -> int:
    """Compare two places: their buildings and how they stand, beyond chance, with a ruler."""
    from scenewright.ground.likeness.places import FEWEST, compare_places

    one, other = _scenes(first, second)
    for scene, path in ((one, first), (other, second or first)):
        if len(scene.buildings) < FEWEST:
            raise InputError(
                f"has {len(scene.buildings)} buildings",
                f"give a scene of at least {FEWEST}",
                file=str(path),
            )
    found = compare_places(one, other, seed)
    if as_json:
        tables.print_json(document(found))
    else:
        _show(found)
    return 0


def _scenes(first: Path, second: Path | None) -> tuple[BuiltScene, BuiltScene]:
    from scenewright.ground.reading import read_built, read_grown

    if second is None:
        return read_grown(first)
    one, other = read_built(first), read_built(second)
    return one._replace(name=one.name or first.stem), other._replace(name=other.name or second.stem)


def document(found: PlaceComparison) -> dict[str, Any]:
    """A comparison as plain values."""
    return {
        "names": list(found.names),
        "buildings": list(found.counts),
        "what": round(found.excess.what, 4),
        "how": round(found.excess.how, 4),
        "whole": round(found.excess.whole, 4),
        "verdict": found.verdict,
        "copied": round(found.copied, 4),
        "ruler": [
            {"of": mark.name, "what": round(mark.what, 4), "how": round(mark.how, 4)}
            for mark in found.ruler
        ],
        "features": [
            {k: round(v, 4) if isinstance(v, float) else v for k, v in row._asdict().items()}
            for row in found.excess.features
        ],
        "words": list(found.words),
    }


def _show(found: PlaceComparison) -> None:
    from scenewright.ground.likeness.places import OTHER_PLACE, SAME_PLACE

    console = tables.output_console()
    ruler = [
        {"": f"{found.names[0]} and {found.names[1]}", **_row(found.excess)},
        *({"": mark.name, **_row(mark)} for mark in found.ruler),
        {
            "": "halves of one real compound, 3 of 4 below",
            "what": "",
            "how": "",
            "whole": SAME_PLACE,
        },
        {"": "two real compounds, median", "what": "", "how": "", "whole": OTHER_PLACE},
    ]
    tables.table(
        console, ruler, title="excess over chance: buildings, and how they stand", whole=("",)
    )
    tables.print_line(
        console, f"{found.verdict}; {found.copied:.0%} of the second copies the first"
    )
    for line in found.words:
        tables.print_line(console, f"- {line}")


def _row(one: Any) -> dict[str, float]:
    return {side: round(getattr(one, side), 2) + 0.0 for side in ("what", "how", "whole")}
