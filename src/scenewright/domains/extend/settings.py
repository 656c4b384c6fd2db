"""Settings of filling areas, besides weights."""

from __future__ import annotations

from typing import NamedTuple


class GrowthSettings(NamedTuple):
    """``spread``: metres by which a neighbour may miss its place and still count half;
    ``missing``: what a neighbour at no known place costs, in neighbours at theirs; ``noise``:
    chance added to what a proposal is worth; ``patches``: placements of a whole source tried
    before growing; ``slack``: the share by which coverage may miss; ``polish``: moves of rows and
    buildings tried at the end; ``relaxed``: whether free ground is filled
    where no neighbour proposes anything; ``edges``: whether every other layout begins with
    the buildings along streets and borders."""

    spread: float = 2.5
    missing: float = 0.3
    noise: float = 0.12
    patches: int = 24
    slack: float = 0.02
    polish: int = 30
    relaxed: bool = True
    edges: bool = True
