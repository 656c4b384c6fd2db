"""Every module is reached by a user: from the command line, from Python or by a benchmark.

Imports count wherever they stand, and so do the names of modules in tables, ``"module:name"``.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from scenewright.core.registry import SHIPPED

ROOT = Path(__file__).parent.parent
SOURCE = ROOT / "src"
ASSETS = "scenewright.catalog.assets"
"""Its modules are named in the rows of kinds."""


def module_of(file: Path) -> str:
    base = SOURCE if SOURCE in file.parents else ROOT
    parts = file.relative_to(base).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


FILES = {
    module_of(file): file
    for folder in (SOURCE / "scenewright", ROOT / "benchmarks")
    for file in folder.rglob("*.py")
}


def text_of(string: ast.JoinedStr, names: dict[str, str]) -> str:
    """An f-string with the constants of its module filled in."""
    parts = []
    for value in string.values:
        known = isinstance(value, ast.FormattedValue) and isinstance(value.value, ast.Name)
        parts.append(names.get(value.value.id, "?") if known else getattr(value, "value", "?"))
    return "".join(str(part) for part in parts)


def named_in(module: str) -> Iterator[str]:
    """Modules that a module may name, or names in them."""
    file = FILES[module]
    tree = ast.parse(file.read_text())
    package = module if file.name == "__init__.py" else module.rpartition(".")[0]
    column = ".".join(module.split(".")[:3])
    names = {"__name__": module, "__package__": package}
    for node in tree.body:
        constant = isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant)
        if constant and isinstance(node.targets[0], ast.Name):
            names[node.targets[0].id] = str(node.value.value)
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.JoinedStr):
            yield text_of(node, names).partition(":")[0]
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and is_name(node.value):
            said = node.value.partition(":")[0]
            yield from (said, f"{column}{said}", f"{package}{said}", f"{package}.{said}")
            yield f"{ASSETS}{said}"


def is_name(text: str) -> bool:
    """Whether a text may name a module or what is in it."""
    return len(text) < 200 and not {" ", "\n"} & {*text}


def used_by_families() -> Iterator[str]:
    """What texts of parts take words from, and the modules of their own name."""
    for text in (SOURCE / "scenewright").rglob("*.parts"):
        yield module_of(text)
        for line in text.read_text("utf-8").splitlines():
            if line.startswith("use "):
                yield line[4:] if line[4:] in FILES else f"{ASSETS}.{line[4:]}"


def home_of(name: str) -> str:
    """The module a dotted name is, or is in; empty if there is none."""
    while name and name not in FILES:
        name = name.rpartition(".")[0]
    return name


def test_every_module_is_reached() -> None:
    reached: set[str] = set()
    waiting = ["scenewright.__main__", *(name for name in FILES if name.startswith("benchmarks"))]
    waiting += [f"scenewright.domains.{name}" for name in SHIPPED]
    waiting += used_by_families()
    while waiting:
        module = home_of(waiting.pop())
        if module and module not in reached:
            reached.add(module)
            waiting += [module.rpartition(".")[0], *filter(home_of, named_in(module))]
    assert sorted(set(FILES) - reached) == []
