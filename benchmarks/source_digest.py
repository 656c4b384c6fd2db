"""What a benchmark's figures are made by: the digest of its source and of all it runs.

Followed are imports within ``benchmarks`` and within the parts of the package that decide figures
(:data:`FOLLOWED`), rows of a table (``f"{__name__}.fill:fill_site"``) and names in quotes: a
benchmark that asks a domain by its contract names what it runs there.
Comments, docstrings, lines and quotes make no difference, nor does the version of Python.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from hashlib import blake2b
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
FOLLOWED = (
    "benchmarks",
    *(f"scenewright.{p}" for p in ("domains", "engine", "ground", "geometry")),
)
STARTED_BY = "scenewright.domains"
"""Its own module hands a brief to any domain: it is not followed, or all would belong to all."""


def source_digest(module: str, root: Path = ROOT) -> str:
    """Twelve hexadecimal digits of a module and of all it imports.

    >>> source_digest("benchmarks.kept") == source_digest("benchmarks.kept")
    True
    """
    reached, waiting = {module}, [module]
    while waiting:
        found = set(imports_of(waiting.pop(), root)) - reached
        reached |= found
        waiting += sorted(found)
    digest = blake2b(digest_size=6)
    for name in sorted(reached):
        digest.update(f"{name}={_parse(name, root)[0]};".encode())
    return digest.hexdigest()


def imports_of(module: str, root: Path = ROOT) -> tuple[str, ...]:
    """The modules of ours that one module imports or names in rows, among those followed."""
    return tuple(name for name in _parse(module, root)[1] if _find(name, root))


@cache
def _parse(module: str, root: Path) -> tuple[str, tuple[str, ...]]:
    """The digest of one module's own code, and the dotted names it may import."""
    tree = ast.parse((_find(module, root) or Path()).read_text(encoding="utf-8"))
    plain = "".join(_describe(tree)).encode()
    return blake2b(plain, digest_size=6).hexdigest(), tuple(sorted(set(_named(tree, module))))


def _named(tree: ast.Module, module: str) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Constant) and str(node.value).startswith(FOLLOWED):
            yield str(node.value)
        elif isinstance(node, ast.JoinedStr) and _begins_with_name(node):
            text = "".join(str(p.value) for p in node.values if isinstance(p, ast.Constant))
            yield f"{module}{text.partition(':')[0]}"


def _begins_with_name(node: ast.JoinedStr) -> bool:
    first = node.values[0] if node.values else None
    value = first.value if isinstance(first, ast.FormattedValue) else None
    return isinstance(value, ast.Name) and value.id == "__name__"


def _find(module: str, root: Path) -> Path | None:
    """The file of a module that is followed; ``None`` of all else."""
    if not module.startswith(FOLLOWED) or module == STARTED_BY:
        return None
    top = root if module.startswith("benchmarks") else root / "src"
    path = top.joinpath(*module.split("."))
    return next((p for p in (path.with_suffix(".py"), path / "__init__.py") if p.is_file()), None)


def _describe(node: Any) -> Iterator[str]:
    """A tree as text: types and what they hold, without places, docstrings and empty parts."""
    if isinstance(node, list):
        for part in node:
            yield from _describe(part)
    elif not isinstance(node, ast.AST):
        yield f"{node!r};"
    else:
        yield f"({type(node).__name__}"
        for name, value in ast.iter_fields(node):
            if value is not None and value != [] and name not in ("ctx", "type_comment"):
                yield f" {name}="
                yield from _describe(_without_words(value) if name == "body" else value)
        yield ")"


def _without_words(body: Any) -> Any:
    """Statements without those that are words alone."""
    if not isinstance(body, list):
        return body
    return [s for s in body if not (isinstance(s, ast.Expr) and isinstance(s.value, ast.Constant))]
