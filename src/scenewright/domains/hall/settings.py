"""Settings of solving halls, besides the weights of terms; presets hold the values."""

from __future__ import annotations

from typing import NamedTuple


class ChainSettings(NamedTuple):
    """Annealing of patterns: how many chains, λ at the start (``low``) and the end (``high``) of
    the schedule, the share ``tepid`` of it that is left out where a good layout is improved, the
    share of moves that energies do not lead (``free``), and the seconds without a budget; how often
    a place is drawn for each unit of a first layout (``tries``), and of how many units on all
    chains start alike (``many``)."""

    chains: int = 4
    low: float = 0.05
    high: float = 20.0
    tepid: float = 0.25
    free: float = 0.6
    seconds: float = 0.4
    tries: int = 600
    many: int = 64


class MoveSettings(NamedTuple):
    """Moves of annealed chains. Share of the moves that change a partition (``walls``) in halls of
    up to ``few`` objects, less in larger ones, where everything is measured again; of these the
    share that makes it as long as it may be (``out``), and the share that moves it off its border
    where a passage is too narrow, something out of reach or it stands off already (``aside``), and
    elsewhere (``seldom``). Share of the other moves drawn blindly that go to what is in the way
    (``called``), of guided ones that change the pattern (``form``), and of slides that go four
    times as far (``far``). The route is looked at after every ``block`` accepted moves."""

    walls: float = 0.03
    few: float = 80.0
    out: float = 0.98
    aside: float = 0.5
    seldom: float = 0.02
    called: float = 0.3
    form: float = 0.05
    far: float = 0.2
    block: int = 16


class GuidedSettings(NamedTuple):
    """The paper's chain (Cao, Cheng, Zhang 2024): its iterations and its λ; moves of a group
    refused one after the other before it changes its pattern (``stuck``); moves drawn for one
    iteration at most, lest a layout that cannot move never ends (``draws``); metres below which a
    wall is removed (``shortest``); the share of moves that try a wall unasked (``walls``), and of
    translations and turns that are turns (``turned``)."""

    steps: int = 1000
    rate: float = 0.1
    stuck: int = 20
    draws: int = 200
    shortest: float = 0.5
    walls: float = 0.05
    turned: float = 0.5


class SearchSettings(NamedTuple):
    """Attempts while something cannot be reached; of a stated budget the share of the ``first``
    and of each ``again``; how much more what is ``wrong`` weighs in the end, and the objects of a
    group that is then tried in halves (``large``); how often what no route reaches is then
    ``given_up``; E_s of all groups above its least that makes a layout ``crowded``."""

    attempts: int = 4
    first: float = 0.5
    again: float = 0.1
    wrong: float = 20.0
    large: int = 6
    given_up: int = 6
    crowded: float = 4.0


class FitSettings(NamedTuple):
    """Making demands fit: ``rounds`` in which groups that are to stay whole are not split, of
    ``most_rounds``; first layouts ``tried`` in each; units of at most ``small`` objects are not
    split. Other first layouts (``chances``) are tried where no more than the share
    ``little`` of the objects finds no room; where more does not, objects get these ``shares`` of
    their clearances in turn, and ``looked`` layouts of each are looked at. Missing objects are
    tried ``again`` times beside those placed."""

    rounds: int = 12
    most_rounds: int = 120
    tried: int = 300
    small: int = 3
    chances: int = 3
    little: float = 0.02
    shares: tuple[float, ...] = (0.1, 0.4, 0.7, 1.0)
    looked: int = 1200
    again: int = 24


class BorderSettings(NamedTuple):
    """Moving borders of zones that have slack: how many ``lines`` of borders, the most uneven first
    (0: they stay), the shares of their slack that are tried in turn (``steps``), the ``share`` of
    the layouts looked at that is spent on annealing after each, and the least ``gain`` of energy
    for which it stays moved."""

    lines: int = 2
    steps: tuple[float, ...] = (0.6, 0.3)
    share: float = 0.12
    gain: float = 0.2


class ZoningSettings(NamedTuple):
    """Proposing zones by annealing trees of cuts: at most ``attempts``; of each the best
    ``tried`` divisions for every plan asked for; two plans put at least the share ``different`` of
    the floor into other zones. Floors in one piece of up to ``exhaustive`` zones are divided in
    every way; else ``rounds`` of ``starts`` follow one another, the best ``kept`` of them
    annealed for ``steps`` steps as ``heat`` falls from the first to the second, until one costs
    less than ``good`` a zone; halls of more than ``large`` hundred corners times zones get less.
    Weights of not meeting whom a zone should (``pair``), not being at its ``door``, cutting a door
    in two (``cut_door``), ``narrow`` ends in square metres, and of another ``area``."""

    attempts: int = 3
    tried: int = 8
    different: float = 0.15
    exhaustive: int = 3
    rounds: int = 3
    starts: int = 40
    kept: int = 2
    steps: int = 40
    good: float = 0.25
    large: float = 12.0
    heat: tuple[float, float] = (0.3, 0.02)
    pair: float = 2.0
    door: float = 10.0
    cut_door: float = 2.0
    narrow: float = 4.0
    area: float = 4.0


USUAL_ZONING = ZoningSettings()


class OtherPlansSettings(NamedTuple):
    """Plans that differ: candidates ``tried`` for every plan asked for, and ``spare`` ones; the
    weight of differing (``different``) against being good; what it costs that something is not
    placed (``missing``)."""

    tried: int = 2
    spare: int = 2
    different: float = 0.5
    missing: float = 10.0


class HallSettings(NamedTuple):
    """Whether groups stay ``whole``, whether eq. 3 stands as ``printed``, and whether
    counters stand ``lined`` up at walls where the brief leaves that open; how demands are made to
    fit, chains anneal and move, the paper's chain runs, attempts follow one another, borders move,
    zones are proposed and plans differ."""

    whole: bool = False
    printed: bool = False
    lined: bool = True
    chains: ChainSettings = ChainSettings()
    moves: MoveSettings = MoveSettings()
    guided: GuidedSettings = GuidedSettings()
    search: SearchSettings = SearchSettings()
    fit: FitSettings = FitSettings()
    borders: BorderSettings = BorderSettings()
    zoning: ZoningSettings = USUAL_ZONING
    other_plans: OtherPlansSettings = OtherPlansSettings()
