"""The wheel alone, in an environment of its own without node: the page opens."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import sysconfig
import urllib.request
import venv
from pathlib import Path

import pytest

from thoroughness import only_thorough

pytest.importorskip("starlette")
pytest.importorskip("hatchling")
ROOT = Path(__file__).parents[1]
ASKED = ("studio.css", "studio.js", "draft.js", "three.js", "words.zh.json", "samples", "shelf")
pytestmark = [only_thorough, pytest.mark.slow]


def install(folder: Path) -> Path:
    """The wheel of this package in a new environment; what it needs comes from where the tests
    run, but this package does not."""
    words = ["wheel", "-q", "--no-deps", "--no-build-isolation", "-w", str(folder), str(ROOT)]
    pip = [sys.executable, "-m", "pip"]
    subprocess.run([*pip, *words], check=True, cwd=folder)
    made = folder / "environment"
    venv.create(made, with_pip=False)
    inside = made / "lib" / f"python{sys.version_info[0]}.{sys.version_info[1]}" / "site-packages"
    (wheel,) = folder.glob("scenewright-*.whl")
    words = ["install", "-q", "--no-deps", "--target", str(inside), str(wheel)]
    subprocess.run([*pip, *words], check=True)
    others = {sysconfig.get_paths()["purelib"], *filter(lambda p: "site-packages" in p, sys.path)}
    (inside / "others.pth").write_text("\n".join(sorted(others)) + "\n")
    return made / "bin" / "python"


def test_the_page_opens_from_a_wheel_without_node(tmp_path: Path) -> None:
    python = install(tmp_path)
    code = "import scenewright, sys; print(scenewright.__file__)"
    bare = {"PATH": str(python.parent), "HOME": str(tmp_path)}
    kept = {key: os.environ[key] for key in ("NUMBA_CACHE_DIR",) if key in os.environ}
    found = subprocess.run(
        [python, "-c", code], env=bare, cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert str(tmp_path) in found.stdout
    words = ["studio", "sample:home-room", "--no-browser", "--port", "0"]
    code = f"from scenewright.cli import main; main({words!r})"
    process = subprocess.Popen(
        [python, "-u", "-c", code], env=bare | kept, cwd=tmp_path, stdout=subprocess.PIPE, text=True
    )
    with process:
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(3)]
        link = re.search(r"http://\S+", "".join(lines))
        assert link is not None, lines
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        page = opener.open(link[0]).read().decode()
        assert "<title>Scenewright studio</title>" in page
        base = link[0].partition("?")[0]
        for name in ASKED:
            assert len(opener.open(base + name).read()) > 100, name
        assert json.loads(opener.open(f"{base}state?since=0").read())["name"] == "A rented room"
        process.send_signal(signal.SIGINT)
