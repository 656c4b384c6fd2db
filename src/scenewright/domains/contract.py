"""What a kind of scene is: a value with its part of the brief, its verbs and its tables.

A domain is one package with a value :class:`Domain`. Verbs and tables are written as
``".module:name"`` below the domain's package, or as ``"package.module:name"``, and loaded when
first used, so that listing domains or reading a brief compiles nothing. A verb a domain does not
have is refused by name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from inspect import signature
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol

from scenewright.core.breeding import Breeder
from scenewright.core.brief import Brief
from scenewright.core.brief.fields import FURNITURE
from scenewright.core.errors import InputError
from scenewright.core.layout import Watch
from scenewright.core.passes import PassTrace
from scenewright.core.plan import Plan
from scenewright.core.registry import SHIPPED, Format, domain_of
from scenewright.core.report import Report
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution

if TYPE_CHECKING:
    from scenewright.drawing.layers import PlanDrawing

Verb = Literal[
    "plan",
    "validate",
    "problems",
    "solve",
    "solution",
    "given",
    "check",
    "findings",
    "scene",
    "draw",
    "draw_levels",
    "alternatives",
    "compare",
    "describe",
    "schemes",
    "planting",
    "adjust",
    "editing",
    "locked",
    "accessible",
    "groups",
    "styles",
    "learn",
    "learn_style",
    "learn_nets",
    "nets",
    "refuse_style",
    "floors",
    "drawn_scale",
    "programme",
    "ledger",
    "faults",
    "appearance",
    "detail_document",
    "detail_of",
    "features",
    "breeder",
    "matrix_breeder",
    "sources",
    "passes",
    "generate",
    "plots",
    "ways",
    "grounds",
]
"""What can be asked of a domain. :data:`NEEDED` are those without which nothing can be arranged; of
the others ``given`` (what a brief says stands, as pieces), ``validate``, ``refuse_style`` (a style
named on the command line that it does not know), ``alternatives``, ``compare``, ``describe``,
``schemes`` (figures by space, of a solution and its plan), ``locked``, ``groups``, ``styles`` (rows
to list), ``editing`` (its :class:`~scenewright.arranging.hand_rules.HandRules`, of a solution and
its plan), ``plots`` (the ground of each building, of a solution and its plan), ``ways`` (middle
lines of streets, of both), ``grounds`` (what is built on, with its streets, of both), ``floors``
(the least the energy of each space could be), ``drawn_scale`` (how much too small or too large the
plan is drawn, of a brief and its spaces), ``programme`` (what was decided for the whole, in words),
``ledger`` (what is owed to those who use it, and what of it stands), ``faults`` (remarks on broken
rows), ``appearance`` (its style, and what chose it), ``draw_levels`` (a sheet a level; else the
plan is one sheet), ``sources`` (author, licence and name of what a layout is learned from, of a
brief), ``features``, ``breeder``, ``matrix_breeder`` and the two of the detail are passed over
where a domain has none, the rest refused by name."""
Table = Literal[
    "presets",
    "solvers",
    "terms",
    "meanings",
    "patterns",
    "labels",
    "themes",
    "reasons",
    "remedies",
    "compromises",
]
"""Tables of a domain; ``remedies`` are rows of :class:`~scenewright.core.explanation.Remedy`,
``compromises`` a :class:`~scenewright.core.explanation.Compromise` by term."""

NEEDED: tuple[Verb, ...] = ("plan", "solve", "check", "scene", "draw")
"""The verbs every domain has."""


class Generating(Protocol):
    """``generate``: a brief made by a seed from what was asked, the same for the same seed; a key
    that the domain does not know is refused by name."""

    def __call__(self, asked: Mapping[str, Any], seed: int = 0) -> Brief: ...


class Tracing(Protocol):
    """``passes``: what each pass changes when the brief of a solution is solved again as it was."""

    def __call__(self, solution: Solution, plan: Plan) -> PassTrace: ...


class Planning(Protocol):
    """``plan``: everything later stages rely on, checked once."""

    def __call__(self, brief: Brief) -> Plan: ...


class Solving(Protocol):
    """``solve``: ``plan`` is that of the brief, made once a run. The work is ``steps`` or
    ``seconds``, else what the preset says. ``progress`` is called with the share done and what is
    being done; when ``cancel`` answers true, the best so far is returned. ``watch`` gets the best
    layout of each space, every change after its search, and what is settled; it is handed to a
    domain that takes it. ``hear`` is handed where a traced solver's steps are heard."""

    def __call__(
        self,
        brief: Brief,
        *,
        plan: Plan,
        preset: str = "default",
        solver: str | None = None,
        seconds: float | None = None,
        steps: int | None = None,
        seed: int = 0,
        threads: int | None = None,
        progress: Callable[[float, str], None] | None = None,
        cancel: Callable[[], bool] | None = None,
        watch: Watch | None = None,
    ) -> Solution: ...


class Checking(Protocol):
    """``check``: the referee's report on a solution."""

    def __call__(self, solution: Solution, plan: Plan, **given: Any) -> Report: ...


class Staging(Protocol):
    """``scene``: what writers of 3D and pictures draw."""

    def __call__(self, solution: Solution, plan: Plan) -> Scene: ...


class PlanDrawer(Protocol):
    """``draw``: the plan to print. ``judge`` gives the referee's report, for plans that show
    some of it."""

    def __call__(
        self, solution: Solution, plan: Plan, judge: Callable[[], Report]
    ) -> PlanDrawing: ...


class Measuring(Protocol):
    """``features``: what can be liked about a solution, by name; the same names for all solutions
    of a brief."""

    def __call__(self, solution: Solution, plan: Plan) -> Mapping[str, float]: ...


class Breeding(Protocol):
    """``breeder``: the genes of a brief's layouts and how they develop
    (:mod:`scenewright.core.breeding`)."""

    def __call__(self, brief: Brief, plan: Plan, seed: int = 0) -> Breeder: ...


class Domain(NamedTuple):
    """One kind of scene.

    ``name`` is what a brief says; ``about`` one line for lists; ``package`` where its modules
    are. ``part`` names the pydantic model of the keys only its briefs have (empty: none), and
    ``detail`` that of the keys only its solutions have. ``rooms`` tells whether its briefs have
    rooms; ``lacks`` and ``rooms_lack`` are common keys of briefs and rooms it does
    not know. ``defaults`` are values of common keys its briefs leave out. ``noun`` names one of its
    spaces in messages; ``largest_piece`` the greatest side a piece of a saved solution may have, in
    metres. ``verbs`` and ``tables`` give the function or table of each name as
    ``"module:name"`` below the package. ``samples`` are names of briefs in its folder
    ``samples``; ``formats`` files only it reads or writes. ``documents`` read a parsed JSON
    document of another program: its ``type`` -> ``"module:name"``. ``maps`` is the module that
    reads GeoJSON as such a brief: ``recognises(collection)`` and ``brief_of(collection, name)``;
    ``names_itself(collection)``, if there, tells whether tags say so plainly. ``budget`` is what
    its solvers count: ``steps`` of a search or whole ``layouts`` of a space; ``a_day`` how many of
    them of one space take about a day.
    """

    name: str
    about: str
    package: str
    part: str = ""
    detail: str = ""
    rooms: bool = True
    lacks: tuple[str, ...] = ()
    rooms_lack: tuple[str, ...] = ()
    defaults: Mapping[str, Any] = {}
    noun: str = "room"
    largest_piece: float = FURNITURE
    verbs: Mapping[str, str] = {}
    tables: Mapping[str, str] = {}
    formats: tuple[Format, ...] = ()
    documents: Mapping[str, str] = {}
    maps: str = ""
    budget: Literal["steps", "layouts"] = "steps"
    a_day: int = 1_000_000_000

    def part_model(self) -> Any:
        """The model of the keys only its briefs have; ``None`` if there are none."""
        return self.load(self.part) if self.part else None

    def detail_model(self) -> Any:
        """The model of the keys only its solutions have; ``None`` if there are none."""
        return self.load(self.detail) if self.detail else None

    def has(self, verb: Verb) -> bool:
        """Whether the domain has a verb."""
        return verb in self.verbs

    def verb(self, name: Verb) -> Any:
        """The function of a verb; raises :class:`InputError` if the domain has none."""
        if name not in self.verbs:
            words = name.replace("_", " ")
            fault = f"scenes of the domain '{self.name}' do not support '{words}'"
            having = ", ".join(kind for kind in SHIPPED if domain_of(kind).has(name))
            remedy = f"it is there for: {having}" if having else "leave it out"
            raise InputError(fault, remedy)
        return self.load(self.verbs[name])

    def takes(self, name: Verb, argument: str) -> bool:
        """Whether the function of a verb takes an argument that it may do without."""
        return argument in signature(self.verb(name)).parameters

    def table(self, name: Table) -> Any:
        """A table by name, empty if the domain has none."""
        return self.load(self.tables[name]) if name in self.tables else {}

    def load(self, reference: str) -> Any:
        """What ``"module:name"`` names; a module with a leading dot is the package's own."""
        module, _, name = reference.partition(":")
        return getattr(import_module(module, self.package), name)
