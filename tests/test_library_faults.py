"""Hostile libraries of furniture: one line each."""

from __future__ import annotations

import struct
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from hostile_models import WHOLE, fault_of, zipped
from model_files import PIECE, furniture, obj_text, put

LIBRARY = {
    "no model line": ("name#1=x", "lists no models"),
    "model outside": (PIECE.replace("/kit/table.obj", "../../table.obj"), "outside its folder"),
    "model on a drive": (PIECE.replace("/kit/table.obj", "C:/table.obj"), "outside its folder"),
    "model missing": (PIECE.replace("table.obj", "chair.obj"), "is missing"),
    "kind not read": (PIECE.replace("table.obj", "table.dae"), "'.dae' models are not read"),
    "no size": (PIECE.replace("width#1", "wide#1"), "its size is not possible"),
    "no width": (PIECE.replace("width#1=80", "width#1=0"), "its size is not possible"),
    "endless width": (PIECE.replace("width#1=80", "width#1=inf"), "is not a length"),
    "width a word": (PIECE.replace("width#1=80", "width#1=wide"), "is not a length"),
    "rotation short": (PIECE.replace("0 -1 0", "0"), "not nine numbers"),
    "rotation of words": (PIECE.replace("0 -1 0", "0 -1 x"), "not nine numbers"),
    "rotation that bends": (PIECE.replace("0 -1 0", "0 -9 0"), "is not a rotation"),
    "rotation not finite": (PIECE.replace("0 -1 0", "0 nan 0"), "is not a rotation"),
    "long line": ("model#1=" + "x" * 30_000, "a line is longer"),
}


@pytest.mark.parametrize("case", LIBRARY)
def test_library_faults(tmp_path: Path, case: str) -> None:
    catalogue, told = LIBRARY[case]
    assert told in fault_of(furniture(tmp_path, catalogue, {"kit/table.obj": obj_text()}))


NAMED = {"PluginFurnitureCatalog.properties": PIECE.encode("latin-1")}


@cache
def lied() -> bytes:
    return zipped({"PluginFurnitureCatalog.properties": b"#" * 100 + b" " * 9_000_000})


PACKED: dict[str, tuple[Callable[[], bytes], str]] = {
    "no zip": (lambda: b"hello", "whole zip archive"),
    "cut off": (lambda: WHOLE[: len(WHOLE) // 2], "whole zip archive"),
    "no catalogue": (lambda: zipped({"a.txt": b"a"}), "holds no PluginFurnitureCatalog.properties"),
    "catalogue swells": (lied, "is larger than 8 MiB"),
    "model swells": (
        lambda: zipped(NAMED | {"kit/table.obj": b"\n" * 30_000_000}),
        "packed more than 200 times",
    ),
    "model too large": (
        lambda: zipped(NAMED | {"kit/table.obj": b"\n" * 70_000_000}),
        "larger than 64 MiB",
    ),
    "damaged": (lambda: WHOLE.replace(b"PluginF", b"PluginG", 1), "cannot be unpacked"),
    "many entries": (lambda: zipped({f"{k}": b"" for k in range(50_001)}), "holds 50,001 entries"),
}


@pytest.mark.parametrize("case", PACKED)
def test_archive_faults(tmp_path: Path, case: str) -> None:
    make, told = PACKED[case]
    assert told in fault_of(put(tmp_path, "shop.sh3f", make()))


def test_an_archive_that_lies_about_sizes_is_not_believed(tmp_path: Path) -> None:
    """The size in the directory of the archive says 100 bytes, the entry has 9 MB."""
    true = struct.pack("<I", 9_000_100)
    assert lied().count(true) == 2
    path = put(tmp_path, "shop.sh3f", lied().replace(true, struct.pack("<I", 100)))
    assert "cannot be unpacked" in fault_of(path) or "lists no models" in fault_of(path)
