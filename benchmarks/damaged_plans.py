"""Plans and building models in the files of other programs, to be damaged: a home of two rooms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from benchmarks.damage import damage_json, damage_zip, zipped
from benchmarks.damage_structure import damage_lines, damage_streams, damage_xml
from benchmarks.damaged_samples import HOME, XML
from benchmarks.damaged_uses import DamagedFormat, arrange_with, given, learn_groups, plain, plan_it

SHARE = 500
"""Files of each kind."""
FEW = 3
"""Pieces of furniture in them: most of a file that is not damaged only takes time."""


@cache
def solution() -> Any:
    """A home solved."""
    from scenewright.core.brief import Brief
    from scenewright.domains import solve

    return solve(Brief.model_validate(HOME), steps=50, threads=1)


def written(suffix: str) -> Callable[[Path], bytes]:
    """What makes the content of the home with little furniture as it is written with a suffix."""

    def sound(folder: Path) -> bytes:
        from scenewright import formats

        path = folder / f"sound.{suffix}"
        found = solution()
        formats.write(replace(found, pieces=found.pieces[:FEW]), path)
        return path.read_bytes()

    return sound


def _zipped_ifc(folder: Path) -> bytes:
    return zipped({"home.ifc": written("ifc")(folder)})


_HOME_ZIP = given(zipped({"Home.xml": XML.encode()}))
_LINES, _XML = plain(damage_lines), plain(damage_xml)
_HOUSE = written("procthor.json")
PLAN_FORMATS = (
    DamagedFormat(
        "sweet homes",
        SHARE,
        ".sh3d",
        _HOME_ZIP,
        plain(damage_zip(damage_xml)),
        arrange_with(10, "--keep"),
    ),
    DamagedFormat(
        "homes to learn", 60, ".sh3d", _HOME_ZIP, plain(damage_zip(damage_xml)), learn_groups
    ),
    DamagedFormat("home XML", 120, ".xml", given(XML.encode()), _XML, arrange_with(10)),
    DamagedFormat("IFC models", SHARE, ".ifc", written("ifc"), _LINES, plan_it),
    DamagedFormat(
        "zipped IFC", 60, ".ifczip", _zipped_ifc, plain(damage_zip(damage_lines)), plan_it
    ),
    DamagedFormat("ProcTHOR houses", 60, ".procthor.json", _HOUSE, plain(damage_json), plan_it),
    DamagedFormat("DXF plans", SHARE, ".dxf", written("dxf"), _LINES, plan_it),
    DamagedFormat("SVG plans", SHARE, ".svg", written("svg"), _XML, plan_it),
    DamagedFormat("PDF plans", SHARE, ".pdf", written("pdf"), plain(damage_streams), plan_it),
)
