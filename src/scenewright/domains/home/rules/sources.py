"""Where the numbers of rows come from."""

from __future__ import annotations

APPLETON = "Appleton, The Experience of Landscape (1975): prospect and refuge"
DAYLIGHT = "ASHRAE 90.1 (2019), 3.2: sidelighted area"
DGUV = "DGUV Information 215-444, 2.4: one looks along windows, those behind are mirrored"
DIN_4109 = "DIN 4109-1 (2018): no pipes in the walls of rooms one sleeps in"
NEUFERT = "Neufert, Architects' Data (2012)"
NKBA = "NKBA, Kitchen & Bathroom Planning Guidelines (2012)"
NKBA_17 = "NKBA, Kitchen Planning Guidelines, 17: 12 inches beside a cooking surface"
PANERO = "Panero, Zelnik, Human Dimension & Interior Space (1979)"
FLATS = "seen in furnished flats"
