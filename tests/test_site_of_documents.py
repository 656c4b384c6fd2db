"""The web pages of the documents: every page and every public name is there, without a warning."""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import scenewright as sw
from thoroughness import THOROUGH

DOCS = Path(__file__).parent.parent / "docs"
READ = [] if THOROUGH else ["api.md", "exchange.md", "notebooks/flat.ipynb"]
"""Pages that are built; none stands for all."""


def pages() -> set[str]:
    files = [*DOCS.glob("*.md"), *DOCS.glob("notebooks/*.ipynb")]
    return {file.relative_to(DOCS).with_suffix("").as_posix() for file in files} - {"index"}


def test_every_page_is_in_the_contents() -> None:
    index = (DOCS / "index.md").read_text("utf-8")
    listed = re.findall(r"^([a-z/-]+)$", index, re.M)
    assert sorted(listed) == sorted(pages())


def test_every_public_name_is_in_the_reference() -> None:
    named = re.findall(r"^\.\. auto\w+:: (\w+)", (DOCS / "api.md").read_text("utf-8"), re.M)
    assert sorted(named) == sorted(sw.__all__)


def test_pages_are_built_without_warnings_and_fetch_nothing(tmp_path: Path) -> None:
    if importlib.util.find_spec("myst_parser") is None or importlib.util.find_spec("furo") is None:
        pytest.skip("the extra docs is not installed")
    source = tmp_path / "docs"
    for name in ["conf.py", *(READ or [f"{p.name}" for p in DOCS.iterdir()])]:
        target = source / name
        target.parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if (DOCS / name).is_dir() else shutil.copy)(DOCS / name, target)
    if READ:
        listed = "\n".join(name.partition(".")[0] for name in READ)
        (source / "index.md").write_text(f"# Pages\n\n```{{toctree}}\n{listed}\n```\n")
        for name in READ:
            keep_own_links(source / name)
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "sphinx",
            "-q",
            "-W",
            "--keep-going",
            str(source),
            str(tmp_path / "out"),
        ],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    for page in (tmp_path / "out").rglob("*.html"):
        text = page.read_text("utf-8")
        assert not re.findall(r'<(?:script|link|img)[^>]+(?:src|href)="(?:https?:)?//', text), page
    text = (tmp_path / "out" / "notebooks" / "flat.html").read_text("utf-8")
    assert "Furnish a flat" in text


def keep_own_links(file: Path) -> None:
    """Links to pages that are not built become text."""
    text = file.read_text("utf-8")
    if file.suffix == ".md":
        file.write_text(re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text), encoding="utf-8")
