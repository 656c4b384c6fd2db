"""Models declared as parts: a family is a text of rows, and a part is ``material: shape``.

```
chest_of_drawers(name="Low chest")          a model of a kind, and how it differs from its row
  rows = max(2, round(h / 0.23))            a measure: a formula of sizes and measures above
  OAK: slab((-w, w), (-d, d), (h - 0.02, h))          a part: what it is of, its shape
  BLACK: leg(s * w, -d, (0, 0.1), 0.02, 0.01) for s in (-1, 1)         the same, repeated
  *: book_rows(x, y, levels)                what has several materials
  plan: rectangle(size)                     a line of the plan symbol
```

``w`` and ``d`` are half the width and depth, ``h`` the height, ``size`` all three. What is indented
further continues the row above. At the margin, ``plan NAME`` and ``form NAME(...)`` are symbols and
shapes of the family, ``NAME = ...`` its measures, ``models ...`` models that a formula makes, and
``use FAMILY`` takes the words of another. Words of formulas are shapes, materials and what a module
of the same name defines. All else of a model - bodies, texture, closedness, mass - follows from its
parts.
"""

from __future__ import annotations

import ast
import builtins
import math
from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from importlib import import_module, resources
from importlib.util import find_spec, resolve_name
from itertools import pairwise
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.corners import mirror_drawing
from scenewright.catalog.assets.symbols import Line
from scenewright.core.catalog import Material
from scenewright.core.kind import size_range
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh

HERE = "scenewright.catalog.assets"
MODULES = (
    *("scenewright.geometry.mesh", "scenewright.geometry.solids", "scenewright.geometry.joints"),
    *(f"{HERE}.{name}" for name in ("bodies", "drawing", "extruded", "joinery", "lengthwise")),
    *(f"{HERE}.{name}" for name in ("materials", "model", "objects", "symbols")),
)
"""The modules whose public names are words of every formula."""
BUILT_IN = "abs any all bool dict enumerate float int len list locals map max min next range"
BUILT_IN += " reversed round set sorted str sum tuple zip"
FORBIDDEN = (ast.Lambda, ast.Await, ast.Yield, ast.YieldFrom, ast.NamedExpr)
SIZES = "w, d, h = size.width / 2, size.depth / 2, size.height"


class Row(NamedTuple):
    """A row of a block: its line, what stands before its colon or equals sign, which of the two
    (``mark``; "" where neither stands outside brackets), and the formula."""

    line: int
    left: str
    mark: str
    formula: str


class Block(NamedTuple):
    """A model, ``plan`` or ``form``: the line and words of its head, and its rows."""

    line: int
    head: str
    rows: tuple[Row, ...]


def read_blocks(text: str) -> Iterator[Block]:
    r"""The blocks of a family.

    >>> [block] = read_blocks("stool\n  r = w\n  OAK: disc(r,\n    (0, h))\n")
    >>> block.head, [row[1:] for row in block.rows]
    ('stool', [('r', '=', 'w'), ('OAK', ':', 'disc(r, (0, h))')])
    """
    found: list[list[tuple[int, str]]] = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.strip()
        if not words or words.startswith("#"):
            continue
        if not line.startswith(" "):
            found.append([(number, words)])
        elif line.startswith("    "):
            found[-1][-1] = (found[-1][-1][0], f"{found[-1][-1][1]} {words}")
        else:
            found[-1].append((number, words))
    for head, *rows in found:
        yield Block(*head, tuple(_read_row(*row) for row in rows))


def _read_row(line: int, words: str) -> Row:
    depth = 0
    for at, sign in enumerate(words):
        depth += (sign in "([{") - (sign in ")]}")
        if depth == 0 and (sign == ":" or words[at - 1 : at + 2] == " = "):
            return Row(line, words[:at].strip(), sign, words[at + 1 :].strip())
    return Row(line, "", "", words)


def put(found: dict[Material, list[Mesh]], material: Any, shape: Any) -> None:
    """Adds a mesh or several of a material, or without one pairs or a mapping of such, to what was
    found before."""
    if material is not None:
        shape = ((material, shape),)
    for own, meshes in shape.items() if isinstance(shape, Mapping) else shape:
        found.setdefault(own, []).extend([meshes] if isinstance(meshes, Mesh) else meshes)


def draw(lines: list[Line], line: Any) -> None:
    """Adds a polyline, or several, to those of a symbol."""
    lines.extend([line] if isinstance(line, np.ndarray) else line)


def _write(block: Block, takes: str, plan: bool) -> str:
    """The source of what a block draws, parts or plan: a function of what it ``takes``."""
    lines = [
        f"def drawn({takes}):",
        "_found, _lines = {}, []",
        *([SIZES] if "size" in takes.split(", ") else []),
    ]
    result = "tuple(_lines)" if plan else "parts(size, _found)"
    for _, left, mark, formula in block.rows:
        if mark == "=":
            lines.append(f"{left} = {formula}")
        elif plan and left == ("" if block.head.startswith("plan ") else "plan"):
            lines.append(f"draw(_lines, ({formula}))")
        elif not plan and not mark:
            result = formula
        elif not plan and left != "plan":
            lines.append(f"put(_found, {'None' if left == '*' else left}, ({formula}))")
    return "\n    ".join([*lines, f"return {result}"])


def _compile(source: str, words: dict[str, Any], at: str) -> Callable[..., Any]:
    tree = ast.parse(source, at)
    for node in ast.walk(tree):
        if isinstance(node, FORBIDDEN) or (isinstance(node, ast.Attribute) and "__" in node.attr):
            raise SyntaxError(f"{at}: a formula has no {type(node).__name__.lower()}")
    FunctionType(compile(tree, at, "exec"), words)()
    drawn: Callable[..., Any] = words.pop("drawn")
    return drawn


def _drawn(block: Block, words: dict[str, Any], at: str, takes: str, plan: bool) -> Any:
    """What a block draws, compiled when it is first drawn."""
    compiled = cache(lambda: _compile(_write(block, takes, plan), words, f"{at}:{block.line}"))
    return lambda *values, **named: compiled()(*values, **named)


OWN: tuple[Any, ...] = (Size, size_range, draw, put, pairwise, partial)


def _words(module: str) -> dict[str, Any]:
    """What formulas of a family can name."""
    found: dict[str, Any] = {word.__name__: word for word in OWN} | {"np": np}
    for name in MODULES:
        found |= _public(name)
    found |= {
        name: getattr(math, name)
        for name in ["acos", "atan2", "cos", "hypot", "pi", "sin", "sqrt", "tan"]
    }
    found |= vars(import_module(module)) if module and find_spec(module) else {}
    return found | {"__builtins__": {name: getattr(builtins, name) for name in BUILT_IN.split()}}


def _public(module: str) -> dict[str, Any]:
    return {k: v for k, v in vars(import_module(module)).items() if k[0] != "_"}


def read_family(text: str, module: str) -> tuple[Drawing, ...]:
    r"""The models of a family, in the order of its text.

    >>> [stool] = read_family("stool\n  OAK: block((-w, w), (-d, d), (0, h))\n", "")
    >>> from scenewright.core.scene import Size
    >>> [part.material.name for part in stool.mesh(Size(0.4, 0.4, 0.5))]
    ['oak']
    """
    words, found = _words(module), list[Drawing]()
    for block in read_blocks(text):
        kind, _, head = block.head.partition(" ")
        name, _, takes = head.partition("(")
        if kind == "plan":
            words[name] = _drawn(block, words, module, "size", True)
        elif kind == "form":
            words[name] = _drawn(block, words, module, takes[:-1], False)
        elif kind == "use":
            words |= _public(
                resolve_name(f".{head}" if head[:12] != "scenewright." else head, HERE)
            )
        elif kind == "models":
            made = _compile(f"def drawn():\n    return {head}", words, f"{module}:{block.line}")()
            found.extend([made] if isinstance(made, Drawing) else made)
        elif " = " in block.head:
            source = f"def drawn():\n    {block.head}\n    return locals()"
            words |= _compile(source, words, f"{module}:{block.line}")()
        else:
            found.extend(_models(block, words, module))
    return tuple(found)


def _models(block: Block, words: dict[str, Any], at: str) -> Iterator[Drawing]:
    """The models of a block: one, one a colour, or one and its mirror image."""
    category, _, more = block.head.partition("(")
    own = _compile(f"def drawn():\n    return dict({more or ')'}", words, f"{at}:{block.line}")()
    colours, mirrored = own.pop("colours", ()), own.pop("mirrored", False)
    takes = "size, colour" if colours else "size"
    mesh = _drawn(block, words, at, takes, False)
    if any(row.left == "plan" for row in block.rows):
        own["symbol"] = _drawn(block, words, at, takes, True)
    drawing = Drawing(category, mesh, **own)
    yield from [] if colours else [drawing]
    yield from [mirror_drawing(drawing)] if mirrored else []
    for number, colour in enumerate(colours):
        own_id = f"{category}_{number}" if number else ""
        yield drawing._replace(mesh=partial(mesh, colour=colour), id=own_id)


@cache
def drawings_of(module: str) -> tuple[Drawing, ...]:
    """The models of a family: those its text declares, then those of its module's ``ASSETS``.

    >>> len(drawings_of("scenewright.catalog.assets.furniture.storage")) > 10
    True
    """
    package, _, name = module.rpartition(".")
    text = resources.files(package).joinpath(f"{name}.parts") if package else None
    declared = read_family(text.read_text("utf-8"), module) if text and text.is_file() else ()
    if declared and not find_spec(module):
        return declared
    return (*declared, *getattr(import_module(module), "ASSETS", ()))
