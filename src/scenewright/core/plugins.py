"""What other packages add by entry points: loaded one by one; what is broken is named and left out.

A plug-in that cannot be loaded, or is not what its group wants, costs one :class:`PluginWarning`
that names its entry point, whatever it raises while it is loaded, and nothing else: all that does
not need it works as before.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

T = TypeVar("T")
GROUPS = (
    "scenewright.domains",
    "scenewright.formats",
    "scenewright.kinds",
    "scenewright.patterns",
    "scenewright.solvers",
    "scenewright.terms",
)
"""All groups of entry points by which packages add something."""
REMEDY = "mend or uninstall the package that adds it"


class PluginWarning(UserWarning):
    """A plug-in was left out, and why: one line that names its entry point."""


def load_plugins(
    group: str, check: Callable[[EntryPoint, Any], T], prefix: str = ""
) -> Iterator[tuple[str, T]]:
    """The names of a group's entry points that begin with ``prefix``, in order, and what ``check``
    makes of what each names; those that fail are left out with a :class:`PluginWarning`."""
    entries = [entry for entry in list_entries(group) if entry.name.startswith(prefix)]
    for entry in sorted(entries, key=lambda entry: entry.name):
        loaded = load_plugin(entry, check)
        if loaded:
            yield entry.name, loaded[0]


def load_plugin(entry: EntryPoint, check: Callable[[EntryPoint, Any], T]) -> tuple[T, ...]:
    """What ``check`` makes of what an entry point names; nothing, and a warning, where it fails."""
    try:
        return (check(entry, entry.load()),)
    except (Exception, SystemExit, KeyboardInterrupt) as error:
        reason = " ".join(str(error).split())[:200]
        fault = reason if isinstance(error, TypeError) and reason else describe_error(error)
        text = f"plug-in left out: {describe_entry(entry)}: {fault}; {REMEDY}"
        warnings.warn(text, PluginWarning, stacklevel=2)
        return ()


def describe_error(error: BaseException) -> str:
    """An error in one line: what kind, and what it says.

    >>> describe_error(ZeroDivisionError("by hand"))
    'cannot be loaded (ZeroDivisionError: by hand)'
    """
    said = " ".join(str(error).split())[:200]
    kind = type(error).__name__
    return f"cannot be loaded ({kind}: {said})" if said else f"cannot be loaded ({kind})"


def describe_entry(entry: EntryPoint) -> str:
    """An entry point by its name, its group and what it names."""
    return f"the entry point '{entry.name}' of {entry.group}, {entry.value}"


def list_entries(group: str) -> Iterable[EntryPoint]:
    """The entry points of a group; what finds them takes a tenth of the time of ``--help``."""
    from importlib.metadata import entry_points

    return entry_points(group=group)


def blame_plugin(trace: TracebackType | None) -> str:
    """The entry point in whose package an error arose, by the innermost frames of its traceback;
    empty if it arose in none."""
    frames = set()
    while trace is not None:
        frames.add(str(trace.tb_frame.f_globals.get("__name__", "")).partition(".")[0])
        trace = trace.tb_next
    for entry in (entry for group in GROUPS for entry in list_entries(group)):
        if entry.module.partition(".")[0] in frames - {"scenewright"}:
            return describe_entry(entry)
    return ""
