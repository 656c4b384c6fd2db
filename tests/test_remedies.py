"""Every message to a user says what to do, and small doors of the command line close softly."""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

import scenewright as sw
from scenewright import cli
from scenewright.core.errors import InputError
from scenewright.core.extras import EXTRAS
from scenewright.domains import plan_of

PACKAGE = Path(sw.__file__).parent
Captured = pytest.CaptureFixture[str]


def list_without_remedy(tree: ast.Module) -> Iterator[str]:
    """Calls of InputError that give no remedy, by line; what hands on a reason that holds one is
    none."""
    for node in ast.walk(tree):
        if not (isinstance(node, ast.Call) and ast.unparse(node.func) == "InputError"):
            continue
        given = [*node.args[1:2], *(k.value for k in node.keywords if k.arg == "remedy")]
        empty = not given or (isinstance(given[0], ast.Constant) and not given[0].value)
        if empty and not any(isinstance(one, ast.Starred) for one in node.args):
            text = ast.unparse(node)
            if ".reason" not in text:
                yield f"{node.lineno}: {text}"


def test_every_refusal_says_what_to_do() -> None:
    found = {
        str(file.relative_to(PACKAGE)): list(
            list_without_remedy(ast.parse(file.read_text("utf-8")))
        )
        for file in PACKAGE.rglob("*.py")
    }
    assert not {name: calls for name, calls in found.items() if calls}


def test_a_call_without_remedy_is_found() -> None:
    code = 'InputError("a")\nInputError("a", "b")\nInputError("a", "")\nInputError("a", remedy="b")'
    assert [one[0] for one in list_without_remedy(ast.parse(code))] == ["1", "3"]


def test_a_benchmark_without_its_package_says_how_to_install_it(
    capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [name for name in sys.modules if name.partition(".")[0] in ("scipy", "benchmarks")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "scipy", None)
    assert cli.run(["bench", "site", "--quick"]) == 2
    shown = capsys.readouterr().err
    assert "benchmark 'site' needs the package 'scipy'" in shown
    assert "pip install 'scenewright[peers]'" in shown


def test_every_extra_is_one_of_the_package() -> None:
    project = tomllib.loads((PACKAGE.parent.parent / "pyproject.toml").read_text())["project"]
    assert EXTRAS.keys() <= project["optional-dependencies"].keys()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a system without /dev/full")
@pytest.mark.parametrize("words", [["list", "samples"], ["--help"], ["schema", "brief"]])
def test_an_output_that_takes_no_more_is_one_line(words: list[str]) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "scenewright", *words],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            env=os.environ | {"PYTHONWARNINGS": "default"},
        )
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert done.stderr.startswith("scenewright: the output cannot be written")


def test_fold_reads_a_sample(capsys: Captured) -> None:
    assert cli.run(["fold", "sample:extend-terrace", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert rows[0]["elements"] >= 10
    assert cli.run(["fold", "sample:home-room"]) == 2
    assert "draws no building" in capsys.readouterr().err
    assert cli.run(["fold", "sample:extend-terace"]) == 2
    assert "sample:extend-terrace" in capsys.readouterr().err


def extension(**area: object) -> sw.Brief:
    houses = [
        {"outline": [[x, 0], [x + 9, 0], [x + 9, 8], [x, 8]], "height": 7.0}
        for x in range(0, 60, 12)
    ]
    ground = {"outline": [[80, -10], [160, -10], [160, 40], [80, 40]]}
    source = {"buildings": houses, "stands": True}
    return sw.Brief.model_validate(
        {"domain": "extend", "sources": [source], "areas": [ground | area]}
    )


@pytest.mark.parametrize(
    ("area", "told"),
    [
        ({"storeys": -2}, "areas[0].storeys: -2 storeys leave nothing"),
        (
            {"rows": [{"pattern": "A A", "line": [[90, 0], [90, 0]]}]},
            "areas[0].rows[0]: its line has no length; draw it from end to end",
        ),
    ],
)
def test_what_cannot_be_grown_is_refused(area: dict[str, object], told: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_of(extension(**area))
    assert told in str(caught.value)


def test_a_storey_less_is_grown() -> None:
    assert plan_of(extension(storeys=-1)).spaces
