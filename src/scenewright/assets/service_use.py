"""What each kind of piece has to be connected to, and how far its lead or hose reaches.

Distances are in plan, from the outlet to the nearest point of the piece. Appliances come with a
mains lead of about 1.5 m and supply and drain hoses of about 1.5 m; a computer's lead of 1.8 m has
to go down from the desk and along it. Basins and sinks are joined by hoses of 0.3 to 0.5 m and a
trap, so the outlet is behind them or just beside; a toilet stands at its drain. Baths and showers
are plumbed under their tray, a metre at most to keep the fall.
"""

from __future__ import annotations

from typing import NamedTuple


class Need(NamedTuple):
    """One kind of outlet a piece needs, how many metres it reaches, and by what."""

    outlet: str
    reach: float
    by: str


LEAD = Need("power", 1.5, "lead")
HOSE = Need("water", 1.5, "hose")
PIPE = Need("water", 0.5, "pipe")
TRAY = Need("water", 1.0, "pipe")

NEEDS: dict[str, tuple[Need, ...]] = {
    "tv": (LEAD, Need("antenna", 1.5, "cable")),
    "desk": (Need("power", 1.8, "lead"), Need("data", 2.0, "cable")),
    "fridge": (LEAD,),
    "hob_cabinet": (LEAD,),
    "oven_cabinet": (LEAD,),
    "dishwasher": (LEAD, HOSE),
    "washing_machine": (LEAD, HOSE),
    "dryer": (LEAD,),
    "sink_cabinet": (PIPE,),
    "basin": (PIPE,),
    "pedestal_basin": (PIPE,),
    "toilet": (PIPE,),
    "bathtub": (TRAY,),
    "shower": (TRAY,),
}
"""A kind that is not listed needs none."""
