"""Names of prims: letters, digits and underscores, unique below one parent."""

from __future__ import annotations

import re
import unicodedata

from pxr import Sdf, Usd


def prim_name(wish: str) -> str:
    """A name a prim may have, as near to a wish as can be.

    >>> prim_name("living/wall-1"), prim_name("Küche"), prim_name("2nd"), prim_name("居間")
    ('living_wall_1', 'Kuche', '_2nd', '_')
    """
    plain = unicodedata.normalize("NFKD", wish).encode("ascii", "ignore").decode()
    name = re.sub(r"\W+", "_", plain)[:80] or "_"
    return f"_{name}" if name[0].isdigit() else name


def free_path(stage: Usd.Stage, parent: Sdf.Path, wish: str) -> Sdf.Path:
    """The path of a new prim below a parent, with a number behind a name that is taken."""
    name = prim_name(wish)
    path, count = parent.AppendChild(name), 1
    while stage.GetPrimAtPath(path):
        count += 1
        path = parent.AppendChild(f"{name}_{count}")
    return path
