"""Plug-ins that were left out, each named in one line on the standard error."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def name_plugins() -> Iterator[None]:
    """Write each :class:`scenewright.core.plugins.PluginWarning` of the block as a line."""
    from scenewright.core.plugins import PluginWarning
    from scenewright.text import printable

    with warnings.catch_warnings():
        usual = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *place: Any, **more: Any) -> None:
            if issubclass(category, PluginWarning):
                sys.stderr.write(f"scenewright: {printable(str(message))}\n")
            else:
                usual(message, category, *place, **more)

        warnings.showwarning = show
        warnings.simplefilter("always", PluginWarning)
        yield
