"""What a map may hold to be read, and what is said of what its file does not hold whole."""

from __future__ import annotations

MOST_FEATURES, MOST_CORNERS, MOST_LAYERS = 100_000, 1_000_000, 200
CUT_OFF = "is cut off at the edge of the file"
"""Why a feature cannot be drawn that is whole in the map that its file was cut from."""
CUT = "cut the place out of it (a clip in QGIS, osmium extract)"
PARTLY = "some of its corners are not in the file"
