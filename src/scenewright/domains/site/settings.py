"""Settings of solving sites, besides the weights of terms; presets hold the values."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from scenewright.catalog.appearance import Measure


class FillSettings(NamedTuple):
    """Filling block by block: layouts of each without a budget; how many times the least the gaps
    may be, filling by filling; how much chance has a say among forms about as good; what half a
    turn off the preferred heading costs, in shares of a block's buildings, and what a court that is
    to close and does not; how many times e the farthest block's share is where buildings are
    ``drawn`` to its side; shares of a run done after the first filling and after all; steps by
    which gaps are widened less; how many heights towers of the form ``point`` stand apart. The
    building line is as far ``back`` from the border as a share of the height, at least and at most
    metres; ``backs`` are the shares of it tried in turn, ``forward`` what standing on the border
    costs."""

    tried: int = 8
    loosest: tuple[float, ...] = (8.0, 2.0, *(1.0,) * 10)
    variety: float = 0.05
    askew: float = 0.5
    other: float = 3.0
    void: float = 12.0
    widest: float = 60.0
    aside: float = 9.5
    parts: tuple[float, ...] = (1.0, 0.75, 0.5)
    unclosed: float = 20.0
    back: tuple[float, float, float] = (0.33, 5.0, 10.0)
    backs: tuple[float, ...] = (1.0, 0.5, 1.0, 1.0, 0.0)
    forward: float = 4.0
    drawn: float = 0.8
    filled: float = 0.5
    most: float = 0.8
    steps: int = 6
    apart: float = 0.6


class AimSettings(NamedTuple):
    """Looking at layouts of a block: metres up to which buildings and eyes about it count, most
    eyes and the rays of each, most buildings whose sun is looked at, and minutes between."""

    far: float = 150.0
    near: float = 60.0
    eyes: int = 48
    rays: int = 32
    lit: int = 40
    minutes: float = 60.0


class InterlockSettings(NamedTuple):
    """Setting buildings that are no boxes into each other's corners: orders and corners tried;
    buildings beyond which none are set anew; what half a turn off the preferred heading costs, as
    a share of the ground taken."""

    tried: int = 6
    many: int = 400
    turn: float = 0.05


class MatrixSettings(NamedTuple):
    """The matrix-coded genetic algorithm: layouts of a generation, generations without a budget,
    chances of a chromosome to be crossed and mutated; δ of (12); what a mean position cost of (5)
    takes off the value of (22) where repaired; first layouts made of local templates; eyes and rays
    by which M is measured; generations of local search without gain, and without anything new,
    that end a run."""

    population: int = 10
    generations: int = 200
    crossover: float = 0.75
    mutation: float = 0.04
    alike: float = 0.002
    position: float = 0.1
    templates: int = 5
    eyes: int = 40
    rays: int = 32
    stalled: int = 40
    known: int = 50


class ExchangeSettings(NamedTuple):
    """Improving: partners drawn for each building and exchanges tried for each; how far a front may
    turn off the preferred heading, in radians, or as far as it was before; rays of each eye, and of
    how many eyes one is used; metres within which shadows are followed, by which one may be larger
    that takes another's place, and within which a way is one a building stands at."""

    partners: int = 24
    tries: int = 2
    leeway: float = math.radians(30.0)
    rays: int = 32
    paces: int = 2
    shade: float = 100.0
    give: float = 25.0
    beside: float = 40.0


class BuildingMoveSettings(NamedTuple):
    """Moves of annealed buildings: up to where in [0, 1) a nudge, a turn, a place beside another
    and a jump are drawn (beyond them a building is left out); metres of a nudge, at last and more
    while hot; radians of a turn by a little while hot."""

    nudge: float = 0.45
    turn: float = 0.55
    beside: float = 0.8
    jump: float = 0.98
    least: float = 0.05
    far: float = 15.0
    little: float = 0.3


class ChainSettings(NamedTuple):
    """Annealing of boxes: temperatures, and moves a building without a budget; costs of (6) beyond
    ``most`` are all alike; moves of a local template in the matrix-coded algorithm, and from 0 hot
    to 1 cold where its schedule starts."""

    hot: float = 10.0
    cold: float = 1e-3
    moves: int = 4000
    most: float = 10.0
    template: int = 1500
    cool: float = 0.4
    drawn: BuildingMoveSettings = BuildingMoveSettings()


class RandomSettings(NamedTuple):
    """Buildings dropped where there is room: layouts without a budget, and places tried for each
    building."""

    layouts: int = 1000
    tries: int = 60


class SwarmSettings(NamedTuple):
    """The swarm of poses: particles, rounds without a budget, and how many of the best are looked
    at in the end for what can stand."""

    particles: int = 40
    rounds: int = 250
    looked: int = 40


class CourtSettings(NamedTuple):
    """Closing courts: fewest buildings round one; metres by which the sides of its rectangle are
    drawn in each time; most lengths of a side tried, and the least in shares of the whole."""

    fewest: int = 4
    drawn_in: float = 2.0
    tried: int = 24
    least: float = 0.35


class SiteVarietySettings(NamedTuple):
    """Other plans: candidates for each plan asked for, and more; what differing, being good and a
    building left out weigh."""

    tried: int = 2
    spare: int = 2
    different: float = 0.6
    good: float = 0.3
    lost: float = 0.05


class SiteSettings(NamedTuple):
    """The measure of visual quality (our ``relief`` or as ``printed``), the form of the paper's
    measures, and how blocks are filled and looked at, buildings set into corners and exchanged,
    courts closed, matrices bred, boxes annealed, dropped and flown, and plans chosen."""

    measure: Measure = "relief"
    form: Literal["printed", "repaired"] = "repaired"
    fill: FillSettings = FillSettings()
    aims: AimSettings = AimSettings()
    interlock: InterlockSettings = InterlockSettings()
    matrix: MatrixSettings = MatrixSettings()
    exchange: ExchangeSettings = ExchangeSettings()
    chain: ChainSettings = ChainSettings()
    random: RandomSettings = RandomSettings()
    swarm: SwarmSettings = SwarmSettings()
    courts: CourtSettings = CourtSettings()
    variety: SiteVarietySettings = SiteVarietySettings()
