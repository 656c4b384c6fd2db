"""Automatic 3D scene layout: read a brief, solve it, write the scene."""

from scenewright._version import __version__

__all__ = ["__version__"]
