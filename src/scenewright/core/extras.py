"""Packages that are not installed: the line that installs one, by the extra that brings it."""

from __future__ import annotations

from importlib.util import find_spec

EXTRAS = {
    "browser": ("playwright",),
    "cluster": ("dask", "distributed", "fsspec"),
    "bim": ("ifcopenshell",),
    "draco": ("DracoPy",),
    "dxf": ("ezdxf",),
    "gis": ("pyogrio", "osmium"),
    "learn": ("torch",),
    "mcp": ("mcp",),
    "mujoco": ("mujoco",),
    "parquet": ("pyarrow",),
    "photo": ("pyoidn",),
    "pdf": ("fpdf", "fontTools", "fontpkg_noto_sans", "pypdfium2"),
    "peers": ("scipy", "cma", "pymoo", "deap"),
    "solve": ("ortools",),
    "studio": ("starlette", "uvicorn"),
    "svg": ("svgelements",),
    "usd": ("pxr",),
}
"""Our extras and the modules that each brings."""


def install_line(module: str) -> str:
    """The command that installs the package of a module, by an extra of ours if one brings it.

    >>> install_line("pymoo.core"), install_line("some.module")
    ("pip install 'scenewright[peers]'", 'pip install some')
    """
    top = module.partition(".")[0]
    extra = next((extra for extra, modules in EXTRAS.items() if top in modules), "")
    return f"pip install 'scenewright[{extra}]'" if extra else f"pip install {top}"


def is_installed(module: str) -> bool:
    """Whether a module can be imported, without importing it."""
    return find_spec(module) is not None


def require(module: str) -> None:
    """Raise the ModuleNotFoundError of a module that is not installed, without importing it."""
    if not is_installed(module):
        raise ModuleNotFoundError(f"no module named {module!r}", name=module)
