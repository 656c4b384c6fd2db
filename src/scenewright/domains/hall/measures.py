"""Distances that several rules of halls go by, in metres. Said once, each with its reason."""

from __future__ import annotations

HEAD_HEIGHT = 2.0
"""What begins above is in nobody's way: the least headroom of stairs and doors."""
ARM = 0.2
"""How far the arm of a passer-by reaches beyond their side, and how far one stands off a chair."""
QUEUE = 2.0
"""Depth of the floor before a till or desk on which people wait: about four of them."""
DOOR_OUTSIDE = 0.6
"""How far outside the bounds of its zone a door may lie."""
AISLE = 1.2
"""The clear width of an aisle (International Building Code 2021, 1030.9.1: 1.12 m)."""
KEPT_OFF = 0.5
"""What exhibits, tables and lounge seats keep off columns, and lounge seats off other groups."""
