"""Classes of groups of furniture and of functions of rooms. Said once; those of kinds of pieces
are in :mod:`scenewright.catalog.classes`."""

from __future__ import annotations

TABLES = frozenset(("dining", "dining_wall"))
"""Groups one eats at."""
RUNS = frozenset(("kitchen", "kitchenette"))
"""Groups one cooks at."""
UNITS = RUNS | {"counter"}
"""Groups of kitchen units side by side."""
COOKING = UNITS | {"fridge", "island"}
"""Groups of a kitchen."""
BED_GROUPS = ("sleeping", "single", "bunk")
"""Groups one sleeps in, cots apart, that for two first."""
DESK_GROUPS = frozenset(("desk", "kids_desk"))
"""Groups one works at."""
SITTING = frozenset(("seating", "media"))
"""Seats and the screen they look at."""
WET_ROOMS = frozenset(("bathroom", "toilet", "washroom"))
"""Functions of rooms with water that nobody cooks in."""
SLEPT_IN = frozenset(("bedroom", "double_bedroom", "single_bedroom", "child_bedroom"))
"""Functions of rooms one sleeps in."""
LIVED_IN = SLEPT_IN | {"living", "dining", "study"}
"""Functions of rooms people spend their day or night in."""
UNLIVED = frozenset(("storage", "balcony", "other"))
"""Functions of rooms that nobody lives in."""
