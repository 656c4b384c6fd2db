"""Every example in the README and the documents runs."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import pytest
from benchmarks.appearance import ranking

from scenewright import cli
from scenewright.catalog.appearance import shipped_facts
from scenewright.core.brief.zones import Demand, ZoneBrief
from scenewright.core.report import KINDS
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.domains.hall.presets import PRESETS as HALL_PRESETS
from scenewright.domains.hall.solvers import HALL_SOLVERS
from scenewright.domains.hall.terms.table import HALL_TERMS
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.terms.table import TERMS
from scenewright.domains.site.presets import PRESETS as SITE_PRESETS
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.terms.table import SITE_AIMS
from thoroughness import THOROUGH

ROOT = Path(__file__).parent.parent
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
BLOCK = re.compile(r"(?:<!-- file: (\S+) -->\n)?```(\w+)\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_examples_run(
    document: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Files are written, commands must not fail, Python runs; in order, in one folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SCENEWRIGHT_HOME", str(tmp_path / "user"))
    names: dict[str, object] = {}
    for file, language, body in BLOCK.findall(document.read_text(encoding="utf-8")):
        if file:
            Path(file).parent.mkdir(parents=True, exist_ok=True)
            Path(file).write_text(body, encoding="utf-8")
        elif language == "python":
            exec(compile(body, str(document), "exec"), names)
        elif language == "console":
            for line in body.splitlines():
                run(line, capsys)


STEPS = {"site": 2, "home": 400, "hall": 400}
"""As many as an example takes that says nothing of them, of those of a whole run."""


def sparing(words: list[str]) -> list[str]:
    """A command with few steps, unless it says how many, and no other process; none where papers'
    methods run."""
    if "--method" in words:
        return []
    if words[0] == "batch" or "--batch" in words:
        return with_steps([*words, "--jobs", "1"], 200)
    if words[0] != "arrange" or {"--layouts", "--preset"} & {*words}:
        return words
    domain = words[1].removeprefix("sample:").partition("-")[0]
    if words[1].endswith(".json"):
        domain = json.loads(Path(words[1]).read_text("utf-8")).get("domain", "home")
    return with_steps(words, STEPS[domain]) if domain in STEPS else words


def with_steps(words: list[str], few: int) -> list[str]:
    """A command with the steps that it says, for whose outcome it was chosen; else with a few.

    >>> with_steps(["--steps", "1000"], 400), with_steps(["-o", "a.svg"], 400)
    (['--steps', '1000'], ['-o', 'a.svg', '--steps', '400'])
    """
    return words if "--steps" in words else [*words, "--steps", str(few)]


def run(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Run a line that calls Scenewright; others (``$ make demo``) are for people."""
    if line.startswith("$ scenewright "):
        words = shlex.split(line.removeprefix("$ scenewright "), comments=True)
        asked = words if THOROUGH else sparing(words)
        code = cli.run(asked) if asked else 0
        told = capsys.readouterr()
        assert code == 0, f"{line}\n{told.out}\n{told.err}"


def test_links_lead_somewhere() -> None:
    for document in DOCUMENTS:
        for link in re.findall(r"\]\(([^)#]+)", document.read_text(encoding="utf-8")):
            if "://" not in link:
                assert (document.parent / link).exists(), f"{document.name} links to {link}"


def test_the_tables_are_told_whole() -> None:
    home = (ROOT / "docs" / "home-method.md").read_text(encoding="utf-8")
    check = (ROOT / "docs" / "check.md").read_text(encoding="utf-8")
    assert [row.name for row in TERMS if f"`{row.name}`" not in home] == []
    assert [name for name in PRESETS if f"`{name}`" not in home and name not in home] == []
    assert [name for name in SOLVERS if f"`{name}`" not in home] == []
    assert [kind for kind in KINDS if f"`{kind}`" not in check] == []


def test_the_tables_of_sites_are_told_whole() -> None:
    site = "".join(
        (ROOT / "docs" / name).read_text(encoding="utf-8") for name in ("site.md", "site-method.md")
    )
    names = [*(row.name for row in SITE_AIMS), *SITE_SOLVERS, *SITE_PRESETS]
    assert [name for name in names if f"`{name}`" not in site] == []
    assert [line for line in ranking(shipped_facts()) if line not in site] == []


def test_the_tables_of_halls_are_told_whole() -> None:
    hall = "".join(
        (ROOT / "docs" / name).read_text(encoding="utf-8") for name in ("hall.md", "hall-method.md")
    )
    names = [row.name for row in HALL_TERMS]
    names += [*PATTERNS, *HALL_SOLVERS, *HALL_PRESETS]
    assert [name for name in names if f"`{name}`" not in hall] == []
    picture = (ROOT / "docs" / "patterns.svg").read_text(encoding="utf-8")
    assert [name for name in PATTERNS if f">{name}</text>" not in picture] == []
    brief = (ROOT / "docs" / "brief-halls.md").read_text(encoding="utf-8")
    fields = [*ZoneBrief.model_fields, *Demand.model_fields]
    assert [name for name in fields if f"| `{name}` |" not in brief] == []
