"""Distances that several rules of halls go by, in metres. Said once, each with its reason."""

from __future__ import annotations

HEAD_HEIGHT = 2.0
"""Height above which nothing is in anybody's way: the least headroom of stairs and doors."""
ARM = 0.2
"""How far the arm of a passer-by reaches beyond their side, and how far one stands off a chair."""
QUEUE = 2.0
"""Depth of the floor before a till or desk on which people wait: about four of them."""
DOOR_OUTSIDE = 0.6
"""How far outside the bounds of its zone a door may lie."""
AISLE = 1.2
"""The clear width of an aisle (International Building Code 2021, 1030.9.1: 1.12 m)."""
KEPT_OFF = 0.5
"""Distance of exhibits, tables and lounge seats from columns, of these seats from other groups."""
NEAR_ENTRANCE = 3.0
"""How far from the entrance a desk is at hand."""
QUEUE_TRIED = 1.5
"""Depth of the floor before a desk that stays off the way in."""
STAFF_ROOM = 0.7
"""Depth of the floor behind a desk on which those stand who serve, at least."""
WAY_LENGTH, WAY_WIDTH = 6.0, 2.4
"""The way in from the entrance that stays free."""
UNSEEN = 0.02
"""The share of a floor that is to be free which columns and corners may take."""
