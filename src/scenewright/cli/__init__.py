"""The command line: thin commands over the library, a file each where they are not small.

Nothing is imported here: :func:`main` first makes sure that Ctrl-C is obeyed, then loads the rest.
"""

from __future__ import annotations

import sys

from scenewright import interruption

__all__ = ["main", "run"]


def main(arguments: list[str] | None = None) -> None:
    """Run the command line and leave with its exit code; every fault is one line.

    What the encoding of the terminal or file cannot hold is written as ``?``.
    """
    interruption.install()
    try:
        for stream in (sys.stdout, sys.stderr):
            if hasattr(stream, "reconfigure"):  # not if it is closed or was replaced
                stream.reconfigure(errors="replace")
        interruption.install(interruption.interrupt)
        _collect_rarely()
        code = run(arguments)
        interruption.ignore()
    except KeyboardInterrupt:
        code = interruption.CODE
    sys.exit(code)


def _collect_rarely() -> None:
    from scenewright.core.garbage import collect_rarely

    collect_rarely()


def run(arguments: list[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    from scenewright.cli.plugin_warnings import name_plugins

    with name_plugins():
        from scenewright.cli import commands

        return commands.run(arguments)
