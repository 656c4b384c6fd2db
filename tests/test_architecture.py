"""The shape of the house: imports go down, files and functions stay small, names stay plain."""

from __future__ import annotations

import ast
import gc
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest

import scenewright
from every import every

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "src" / "scenewright"
FILES = sorted(PACKAGE.rglob("*.py"))
TESTS = sorted((ROOT / "tests").rglob("*.py"))
BENCHMARKS = sorted((ROOT / "benchmarks").glob("*.py"))
NAMES = [str(file.relative_to(PACKAGE)) for file in FILES]

LAYERS = (
    {"_version", "core", "geometry", "interruption", "text"},
    {"catalog"},
    {"building", "engine"},
    {"ground", "render", "drawing", "check", "arranging", "clutter"},
    {"domains"},
    {"formats"},
    {"workflow"},
    {"batch", "studio"},
    {"scenewright", "cli", "__main__"},
)
"""Top-level packages from the ground up."""

BANNED = {"utils", "util", "helpers", "helper", "common", "manager", "base", "misc", "tools"}
JUDGED = {"engine", "geometry", "render"}
VALUE = "scenewright.geometry.joints"
"""How a part of a model moves: a value that parts hold, which judges nothing."""
SOLVING = {"terms", "encodings", "energy", "solvers", "solving", "problem", "build_problem"}
"""Parts of a domain that its referee never imports."""
LOADING = ("scenewright.catalog.loading", "scenewright.catalog.models")
"""What reads models from files: the referee is given its kinds."""
DOMAINS = {"home", "hall", "site", "village", "extend"}
HEAVY = ("numpy", "numba", "shapely", "trimesh", "embreex", "scipy", "pydantic")


def name_file(file: Path) -> str:
    """Where a file lies in the checkout."""
    return str(file.relative_to(ROOT))


def room_of(module: str) -> str:
    """The top-level room a dotted module name lies in."""
    return module.split(".")[:2][-1]


def module_of(file: Path) -> str:
    """The dotted name of a source file."""
    parts = file.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def parse(file: Path) -> ast.Module:
    """The syntax tree of a file, parsed once for all rules."""
    return ast.parse(file.read_text(encoding="utf-8"))


@pytest.fixture(scope="module", autouse=True)
def trees() -> Iterator[None]:
    """Syntax trees are let go once the last rule is checked. Until then no cycle of objects is
    looked for: among a million nodes that takes four times as long as parsing them."""
    gc.disable()
    yield
    gc.enable()
    parse.cache_clear()
    imported.cache_clear()


@cache
def imported(file: Path) -> tuple[str, ...]:
    """Dotted names of our modules that a file imports, at its head or inside functions."""
    return tuple(list_imports(file))


def list_imports(file: Path) -> Iterator[str]:
    for node in ast.walk(parse(file)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.startswith("scenewright"))
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file} imports relatively"
            module = node.module or ""
            if module == "scenewright":
                yield from (f"scenewright.{alias.name}" for alias in node.names)
            elif module.startswith("scenewright."):
                yield module


def layer_of(room: str) -> int:
    """The floor a room is on."""
    found = [level for level, rooms in enumerate(LAYERS) if room in rooms]
    assert found, f"{room} belongs to no layer: add it to LAYERS"
    return found[0]


@every(FILES, name_file)
def test_imports_only_go_down(file: Path) -> None:
    own = room_of(module_of(file))
    for name in imported(file):
        assert layer_of(room_of(name)) <= layer_of(own), f"{file.name} imports {name}"
        if own == "geometry":
            assert room_of(name) == "geometry", f"{file.name} imports {name}"


def domain_in(module: str) -> str:
    """The domain a module belongs to; empty if none."""
    parts = module.split(".")
    return parts[2] if parts[1:2] == ["domains"] and parts[2:3] and parts[2] in DOMAINS else ""


@every(FILES, name_file)
def test_no_domain_imports_another(file: Path) -> None:
    own = domain_in(module_of(file))
    for name in imported(file) if own else ():
        assert domain_in(name) in ("", own), f"{file.name} imports {name}"


@every(FILES, name_file)
def test_domains_are_asked_through_the_contract(file: Path) -> None:
    """Outside a domain nobody imports its modules; the façade names one class of homes."""
    if "domains" in file.parts or file == PACKAGE / "__init__.py":
        return
    for name in imported(file):
        parts = name.split(".")
        assert parts[1:2] != ["domains"] or parts[2:3] in ([], ["contract"]), f"imports {name}"


def test_nothing_outside_the_domains_is_named_after_one() -> None:
    outside = [name for name in NAMES if not name.startswith("domains/")]
    assert not [n for n in outside if re.search(r"(^|[/_])(home|hall|site|village)s?([_./]|$)", n)]


def test_the_referee_shares_no_code_with_what_it_judges() -> None:
    seen: set[str] = set()
    waiting = [module_of(file) for file in PACKAGE.rglob("check/**/*.py")]
    while waiting:
        module = waiting.pop()
        if module in seen:
            continue
        seen.add(module)
        bare = room_of(module) not in JUDGED or module == VALUE
        assert bare, f"the referee reaches {module}"
        assert not SOLVING & set(module.split(".")[3:]), f"the referee reaches {module}"
        assert not module.startswith(LOADING), f"the referee reaches {module}"
        path = PACKAGE.parent.joinpath(*module.split("."))
        files = [f for f in (path.with_suffix(".py"), path / "__init__.py") if f.exists()]
        waiting += [name for file in files for name in imported(file)]


CALLING = {"cli", "batch", "workflow", "formats"}
"""Rooms that may call the referee, beside a domain's registration and the hand-over to it."""


@every(FILES, name_file)
def test_the_search_never_asks_the_referee(file: Path) -> None:
    module = module_of(file)
    parts = module.split(".")
    registration = parts[1:2] == ["domains"] and len(parts) < 4
    if "check" in parts or room_of(module) in CALLING or registration:
        return
    for name in imported(file):
        assert "check" not in name.split("."), f"{module} imports the referee: {name}"


@every(FILES, name_file)
def test_files_and_functions_are_small(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 400
    for node in ast.walk(parse(file)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            assert (node.end_lineno or 0) - node.lineno <= 60, f"{node.name} is too long"


@every([*TESTS, *BENCHMARKS], name_file)
def test_files_of_tests_and_benchmarks_are_small(file: Path) -> None:
    assert len(file.read_text(encoding="utf-8").splitlines()) <= 400, "split it by theme"


@every(FILES, name_file)
def test_every_module_and_public_function_has_a_docstring(file: Path) -> None:
    tree = parse(file)
    assert ast.get_docstring(tree) or not tree.body, "the module says nothing"
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            assert ast.get_docstring(node), f"{node.name} says nothing"


@every(FILES, name_file)
def test_names_tell_what_is_inside(file: Path) -> None:
    words = {
        part for name in file.relative_to(PACKAGE).with_suffix("").parts for part in name.split("_")
    }
    assert not words & BANNED


def test_no_class_of_ours_is_derived_from_another() -> None:
    allowed = {"Model"}  # the settings every pydantic model of the brief shares
    for file in FILES:
        tree = parse(file)
        ours = {node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef)} - allowed
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                bases = {base.id for base in node.bases if isinstance(base, ast.Name)}
                assert not bases & ours, f"{node.name} in {file.name}"


def test_the_facade_lists_what_it_loads() -> None:
    assert sorted(scenewright.__all__) == sorted([*scenewright._HOMES, "__version__"])
    assert dir(scenewright) == sorted(scenewright.__all__)
    for name in scenewright.__all__:
        assert getattr(scenewright, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        scenewright.nothing  # noqa: B018


def test_the_facade_tells_type_checkers_the_same() -> None:
    tree = parse(PACKAGE / "__init__.py")
    blocks = [node for node in tree.body if isinstance(node, ast.If)]
    told = {
        alias.asname or alias.name: f"{node.module}:{alias.name}".removeprefix("scenewright.")
        for node in blocks[0].body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert told == scenewright._HOMES


@pytest.mark.parametrize("module", ["scenewright", "scenewright.cli"])
def test_importing_is_light(module: str) -> None:
    code = f"import {module}, sys; print(*[m for m in {HEAVY!r} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


@pytest.mark.parametrize("first", ["", "import scenewright.check, scenewright.engine.solve"])
def test_verbs_are_not_hidden_by_packages_of_the_same_name(first: str) -> None:
    code = f"""{first}
import scenewright as sw
assert sw.check.__module__ == "scenewright.domains", sw.check
import scenewright.check.rooms, scenewright.engine.solve
assert callable(sw.check) and callable(sw.solve) and callable(sw.read)
from scenewright.core.report import KINDS
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_no_import_cycle_between_layers_of_one_floor() -> None:
    """Rooms of one floor may use each other, but not in a ring."""
    uses: dict[str, set[str]] = {}
    for file in FILES:
        own = room_of(module_of(file))
        uses.setdefault(own, set()).update({room_of(name) for name in imported(file)} - {own})
    order: list[str] = []
    while uses:
        free = sorted(room for room, below in uses.items() if not below & uses.keys())
        assert free, f"a ring of imports among {sorted(uses)}"
        order += free
        for room in free:
            del uses[room]
    assert order[-1] == "__main__"


NAMED = {
    "pillow": "PIL",
    "mapbox-earcut": "mapbox_earcut",
    "fast-simplification": "fast_simplification",
    "fpdf2": "fpdf",
    "fonttools": "fontTools",
    "usd-core": "pxr",
}
OUR_OWN = {"scenewright", "pydantic_core"}  # and what pydantic cannot be without
"""Packages imported by another name than they are installed by."""
OF_BLENDER = {"cycles_script.py": {"bpy", "mathutils"}}
"""What a script that Blender runs imports of Blender."""


@cache
def known_packages(learning: bool) -> frozenset[str]:
    """What may be imported: what pyproject.toml lists for everybody, or for the extras of
    more solvers and of files; what learns may import what the extra of learning lists."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    listed = [*project["dependencies"]]
    optional = project["optional-dependencies"]
    extras = optional.keys() - {"dev", "docs", "learn", "peers"}
    for extra in [*extras, *(["learn"] if learning else [])]:
        listed += optional[extra]
    names = [re.split("[<>=!~ ;\\[]", line)[0] for line in listed]
    return frozenset({NAMED.get(name, name) for name in names} | sys.stdlib_module_names | OUR_OWN)


@every(FILES, name_file)
def test_only_packages_a_user_has_are_imported(file: Path) -> None:
    known = known_packages("learning" in file.parts) | OF_BLENDER.get(file.name, set())
    for node in ast.walk(parse(file)):
        heads = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        if isinstance(node, ast.ImportFrom):
            heads.append(node.module or "")
        assert {head.split(".")[0] for head in heads} <= known, f"imports {heads}"


def test_layers_name_only_what_exists_or_is_planned() -> None:
    assert all(not lower & upper for lower, upper in pairwise(LAYERS))


def test_no_address_of_a_registry_and_no_path_of_a_machine() -> None:
    signs = [
        "/" + "work/",
        "/" + "root/",
        "/" + "home/user",
        "pypi" + ".org",
        "pythonhosted" + ".",
        "registry." + "npmjs",
        "index" + "-url",
    ]
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if listed.returncode:
        pytest.skip("not a git checkout")
    for name in filter(None, listed.stdout.split("\0")):
        data = (ROOT / name).read_bytes() if (ROOT / name).exists() else b""
        if b"\0" in data[:8000]:
            continue
        text = data.decode("utf-8")
        assert not [sign for sign in signs if sign in text], f"{name} holds an address or path"


def decorated(node: ast.AST, names: set[str]) -> bool:
    return isinstance(node, ast.FunctionDef) and any(
        isinstance(d, ast.Name) and d.id in names for d in node.decorator_list
    )


@cache
def inlined_functions() -> frozenset[str]:
    """The full names of all functions that are copied into kernels."""
    return frozenset(
        f"{module_of(file)}.{node.name}"
        for file in FILES
        for node in parse(file).body
        if isinstance(node, ast.FunctionDef) and decorated(node, {"inlined"})
    )


def names_used_by_python(tree: ast.AST, names: dict[str, str]) -> Iterator[str]:
    """Full names used outside compiled functions, by what the file's own ``names`` mean."""
    for child in ast.iter_child_nodes(tree):
        if decorated(child, {"compiled", "inlined"}):
            continue
        if isinstance(child, ast.Name):
            yield names.get(child.id, "")
        if isinstance(child, ast.Attribute) and isinstance(child.value, ast.Name):
            yield f"{names.get(child.value.id, '')}.{child.attr}"
        yield from names_used_by_python(child, names)


@every([*FILES, *TESTS, *BENCHMARKS], name_file)
def test_inlined_functions_are_only_called_by_kernels(file: Path) -> None:
    """They have no entry from Python: a call would crash."""
    tree = parse(file)
    module = module_of(file) if PACKAGE in file.parents else ""
    names = {node.name: f"{module}.{node.name}" for node in tree.body if hasattr(node, "name")}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            names |= {a.asname or a.name: f"{node.module}.{a.name}" for a in node.names}
    assert not inlined_functions().intersection(names_used_by_python(tree, names))


def test_inlined_functions_are_found_where_python_names_them() -> None:
    told = names_used_by_python(
        ast.parse("moves.turn(1)"), {"moves": "scenewright.domains.home.solvers.moves"}
    )
    assert inlined_functions().intersection(told) == {"scenewright.domains.home.solvers.moves.turn"}
