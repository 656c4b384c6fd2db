"""The command line: thin commands over the library, a file each where they are not small."""

from scenewright.cli.commands import main, run

__all__ = ["main", "run"]
