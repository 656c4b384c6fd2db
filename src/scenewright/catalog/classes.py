"""Classes of kinds of furniture: what is sat on, slept in, eaten and worked at. Said once."""

from __future__ import annotations

SOFAS = frozenset(("sofa", "loveseat", "corner_sofa"))
"""Seats for several side by side."""
SOFT_SEATS = SOFAS | {"armchair"}
"""What one sits in to rest."""
TABLE_SEATS = frozenset(("dining_chair", "stool"))
"""What one sits on at a table to eat at."""
EATING_TABLES = frozenset(("dining_table", "round_table"))
"""What one eats at."""
BEDS = frozenset(("double_bed", "single_bed", "bunk_bed"))
"""What one sleeps in, cots apart."""
DESKS = frozenset(("desk", "kids_desk", "corner_desk"))
"""What one works at."""
PLAIN_CABINETS = frozenset(("base_cabinet", "drawer_cabinet"))
"""Units of a kitchen that only store: of any width."""
WORKTOP = PLAIN_CABINETS | {"corner_cabinet", "dishwasher", "filler_panel"}
"""Units of a kitchen with worktop on them."""
RUN = WORKTOP | {"sink_cabinet", "hob_cabinet", "fridge"}
"""Units of a kitchen side by side."""
