"""What steers how homes are solved, beside the weights of terms; presets hold the values."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

MERE_KITCHEN = ("kitchen",)
"""What a room is for that is a kitchen and nothing else."""


class ChainSettings(NamedTuple):
    """Annealing of patches: temperatures at the start and the end, in spreads of the energies of
    random layouts; ``agreed`` chains whose bests differ by no more than the share ``alike`` have
    found the same, and the run ends; ``seconds`` is the work without a budget. ``samples`` layouts
    and ``pilot`` moves of each tell the spread."""

    hot: float = 0.07
    cold: float = 5e-6
    agreed: int = 3
    alike: float = 0.005
    seconds: float = 0.1
    samples: int = 32
    pilot: int = 16


class GreedySettings(NamedTuple):
    """Greedy placement: metres between places ``along`` a wall and ``apart`` on the floor; places
    looked at for ``one`` item, for all items of a pass (``first``), and for one in the ``least``
    pass; how much the logarithm of an area may err in further passes (``shake``); layouts
    ``kept``."""

    along: float = 0.25
    apart: float = 0.5
    one: int = 400
    first: int = 4000
    least: int = 25
    shake: float = 0.5
    kept: int = 64


class FaultCosts(NamedTuple):
    """What faults of a furnished room cost when answers for it are compared.

    A wish that is ``missing``, by its rank, or one that the room's function fails without
    (``core``); a group no route reaches (``unreached``), a door that nothing joins to the others
    (``barred``); a lost ``piece`` of a group that can do without; an ``unmet`` wish for a place, or
    an outlet; a unit of ``energy``; a ``fallback`` taken instead; taking what is in the way rather
    than what cannot be reached (``in_the_way``); a room where a wheelchair cannot turn
    (``no_turn``), a bed or toilet it cannot get to (``no_transfer``)."""

    missing: tuple[float, float, float] = (1000.0, 60.0, 8.0)
    core: float = 3000.0
    unreached: float = 600.0
    barred: float = 1500.0
    piece: float = 4.0
    unmet: float = 30.0
    energy: float = 0.05
    fallback: float = 200.0
    in_the_way: float = 200.0
    no_turn: float = 1500.0
    no_transfer: float = 900.0


class TrySettings(NamedTuple):
    """How a room is tried: shares of its work for the ``first`` try, each ``again`` and to ``fill``
    it up; layouts furnished of a try (``layouts``) and when filling up (``fills``); further tries
    while a wish for a place is not met (``unmet``); the placed groups that make another try worth
    its time (``roomy``); how many items each take the stated steps (``crowded``); the share of its
    preferred footprint that an essential group has at least when tried again (``modest``)."""

    first: float = 0.5
    again: float = 0.3
    fill: float = 0.2
    layouts: int = 4
    fills: int = 6
    unmet: int = 2
    roomy: int = 4
    crowded: int = 9
    modest: float = 0.45


class CompositionCosts(NamedTuple):
    """What faults of composition cost, beside those of :class:`FaultCosts`: too little worktop in
    one piece, a hob beside the sink or at the end of its run, or one of ``few_rings``, fridge, sink
    and hob off a work triangle (``triangle``), a sink narrower than 0.6 m (``small_sink``) or
    without worktop beside it, a fridge hard at the sink (``fridge_at_sink``), apart or under
    the worktop (``low_fridge``), hob and sink at walls ``across`` from each other or apart
    (``split``), a washing machine away from the run (``loose``), half a wardrobe, a shallow one, a
    bed for two with one nightstand or one side to get in, one of 1.9 m (``short_bed``), a single
    bed away from walls, a bed in the entrance (``at_door``), a desk away from daylight (``dark``),
    too few shelves, too few seats, a screen too small for its distance, a sofa that does not look
    at it (``view``), is off its ``axis``, at a bad ``distance`` or with something ``between``,
    a sofa with something near before it (``outlook``), a screen on the wall (``hung``), a table
    with one chair (``lone``), for fewer than its room has (``few_places``), away from daylight
    (``dim_table``) or ``beside_clothes`` in a kitchen one may eat in, one whose chairs all face the
    wall (``abreast_wall``), or with ``stools``, outdoor chairs side by side (``abreast``), a table
    ``crowded`` by seats, something in the way beside a bed for two (``bed_way``), a single bed
    whose head is off the wall (``head_off``) or that is narrower than 0.9 m (``narrow_bed``),
    something before the ``doors`` of a wardrobe, before a window or a wide door, a group small for
    its room (``modest``), a table by its ``places``; a unit by which the
    furnished share of a floor is off what was learned (``share``), and by which the free floor
    beside a group falls short of it (``floor``)."""

    worktop: float = 24.0
    hob_at_sink: float = 22.0
    hob_at_end: float = 22.0
    few_rings: float = 12.0
    triangle: float = 30.0
    small_sink: float = 8.0
    sink_alone: float = 14.0
    fridge_at_sink: float = 8.0
    fridge_alone: float = 26.0
    low_fridge: float = 24.0
    across: float = 12.0
    split: float = 40.0
    loose: float = 14.0
    wardrobe: float = 18.0
    shallow: float = 4.0
    nightstand: float = 14.0
    one_side: float = 14.0
    short_bed: float = 4.0
    adrift: float = 44.0
    at_door: float = 8.0
    dark: float = 12.0
    shelves: float = 10.0
    seats: float = 24.0
    screen: float = 18.0
    view: float = 30.0
    axis: float = 12.0
    distance: float = 8.0
    between: float = 16.0
    outlook: float = 12.0
    hung: float = 8.0
    lone: float = 16.0
    few_places: float = 20.0
    dim_table: float = 6.0
    beside_clothes: float = 4.0
    abreast_wall: float = 6.0
    stools: float = 4.0
    abreast: float = 4.0
    crowded: float = 8.0
    bed_way: float = 9.0
    head_off: float = 12.0
    narrow_bed: float = 3.0
    doors: float = 8.0
    window: float = 18.0
    opening: float = 14.0
    short_run: float = 20.0
    modest: float = 10.0
    places: float = 20.0
    share: float = 300.0
    floor: float = 20.0


class ComposingSettings(NamedTuple):
    """Groups of a furnished room tried in better forms and places: ``rounds`` over all of them;
    of each group ``forms``, of each form the best ``places``, looked at every ``step`` metres, that
    are ``apart`` metres from one another; rooms of at most ``few`` groups are composed again for
    ``anew`` faulty ones, from ``starts`` places of each, all others in ``other_forms``; of a
    bed and a wardrobe that are placed together, ``pair_forms`` at ``pair_places`` of each, and
    ``pairs`` of them furnished; what may be paid for something ``lacking``, and for an
    ``addition`` nobody asked for; by how much the room is to cost less (``least``), and how much
    ``wider`` its ways stay on the grid, metres. ``costs`` are those of faults."""

    rounds: int = 2
    forms: int = 6
    places: int = 3
    step: float = 0.1
    apart: float = 0.4
    least: float = 0.5
    wider: float = 0.02
    few: int = 7
    anew: int = 2
    starts: int = 4
    other_forms: int = 3
    pair_forms: int = 6
    pair_places: int = 50
    pairs: int = 50
    pair_starts: int = 8
    lacking: float = 60.0
    addition: float = 8.0
    costs: CompositionCosts = CompositionCosts()


class RetrySettings(NamedTuple):
    """Rooms that gave up something essential: how much ``wider`` the ways of each further try are,
    metres (up to two cells of the grid they are walked on); layouts of essentials walked through
    exactly (``walked``); how often what bars a way is taken out (``rounds``)."""

    wider: tuple[float, ...] = (0.08, 0.02)
    walked: int = 6
    rounds: int = 24


class WallSearchSettings(NamedTuple):
    """Essential groups tried at every place along the walls: ``places`` of one form, layouts whose
    ways are ``walked`` and ``answers`` given for one set of groups, at most; essential ``groups``
    at most; of each its smallest ``forms``."""

    places: int = 6
    walked: int = 40
    answers: int = 2
    groups: int = 5
    forms: int = 2


class RearrangeSettings(NamedTuple):
    """Changes to a furnished room: layouts furnished (``layouts``); what it costs to put a group a
    metre away from where it was (``shift``); share of the work for groups placed anew; where a
    moved group fits is looked for in ``nudges`` steps of ``nudge`` metres either
    way."""

    layouts: int = 6
    shift: float = 10.0
    share: float = 0.5
    nudge: float = 0.05
    nudges: int = 12


class VarietySettings(NamedTuple):
    """Plans that differ: candidates ``tried`` for every plan asked for, and ``spare`` ones; the
    weight of differing (``different``) against being good, energies counting from 0, the best, to
    1; what it costs that something essential is ``missing`` from a room; plans that differ by less
    than ``least`` from one already taken are not given."""

    tried: int = 2
    spare: int = 2
    different: float = 1.0
    missing: float = 2.0
    least: float = 0.1


class HomeSettings(NamedTuple):
    """``printed`` takes the formulas as the paper prints them, ``paper`` its problem
    (:mod:`scenewright.domains.home.paper_problem`) instead of ours; ``exact`` checks every piece
    while furnishing; how ``chains`` anneal, what faults cost, and how rooms are tried."""

    printed: bool = False
    paper: bool = False
    exact: bool = True
    chains: ChainSettings = ChainSettings()
    greedy: GreedySettings = GreedySettings()
    costs: FaultCosts = FaultCosts()
    tries: TrySettings = TrySettings()
    composing: ComposingSettings = ComposingSettings()
    retry: RetrySettings = RetrySettings()
    walls: WallSearchSettings = WallSearchSettings()
    rearrange: RearrangeSettings = RearrangeSettings()
    variety: VarietySettings = VarietySettings()


@lru_cache(maxsize=64)
def fit_settings(settings: HomeSettings, functions: tuple[str, ...]) -> HomeSettings:
    """The settings for a room for these functions: where people live in a kitchen as well, its run
    is short, a fridge at the end of it may stand hard at the sink, and a table takes what floor
    seats and screen leave it."""
    if functions == MERE_KITCHEN:
        return settings
    composing = settings.composing
    costs = composing.costs._replace(fridge_at_sink=0.0, abreast_wall=0.0)
    return settings._replace(composing=composing._replace(costs=costs))
