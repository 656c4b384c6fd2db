"""How faults of model files are told, for the tests."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path
from typing import Any

import pytest

from model_files import PIECE, SIDES, TETRAHEDRON, glb_of, gltf_of, obj_text
from scenewright.catalog.models import library, report
from scenewright.core.errors import InputError

Json = dict[str, Any]


SECRET = "the secret of another folder"


def fault_of(path: Path) -> str:
    """The one line that reading a file leads to; what several models of a file say counts."""
    found = report(path)
    assert not found.models, "it was read"
    assert found.skipped
    for one in found.skipped:
        assert len(one.reason.splitlines()) == 1
        assert len(one.reason) < 400
        assert one.reason.isprintable()
        assert SECRET not in one.reason
    with pytest.raises(InputError) as caught:
        library(path)
    assert len(str(caught.value).splitlines()) == 1
    return found.skipped[0].reason


SOUND = glb_of(gltf_of(TETRAHEDRON, SIDES))


def zipped(entries: dict[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            archive.writestr(name, content)
    return stream.getvalue()


WHOLE = zipped(
    {
        "PluginFurnitureCatalog.properties": PIECE.encode("latin-1"),
        "kit/table.obj": obj_text().encode(),
    }
)
