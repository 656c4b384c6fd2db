"""Villages: blocks between lanes, filled with real houses as those of a region stand."""

from __future__ import annotations

from scenewright.core.brief.fields import BUILDING
from scenewright.core.registry import MAPPED, SEEN, Format
from scenewright.domains.contract import Domain

DOMAIN = Domain(
    name="village",
    about="blocks of a village filled with houses",
    package=__name__,
    part=".brief:VillagePart",
    detail=".record:VillageRecord",
    rooms=False,
    lacks=("rooms", "levels", "walls", "stairs", "accessible", "residents"),
    defaults={"name": "village"},
    noun="block",
    largest_piece=BUILDING,
    budget="layouts",
    a_day=150_000,
    verbs={
        "plan": ".plan:plan_village",
        "solve": ".solving:solve",
        "problems": ".solving:problems",
        "solution": ".solution:solution_of",
        "given": ".given:given_pieces",
        "check": ".check.judge:check",
        "grounds": ".lanes:list_grounds",
        "ways": ".lanes:list_ways",
        "scene": ".furnish:scene_of_village",
        "draw": ".drawing.plan:draw",
        "adjust": ".adjust:adjust",
        "breeder": ".breeding:make_breeder",
        "editing": ".adjust:rules_of",
        "styles": ".library:list_looks",
        "learn_style": ".learning.learn:learn_style",
        "learn_nets": ".learning.paper.learn:learn_nets",
        "nets": ".plan:use_nets",
        "locked": ".locks:lock_village",
        "features": ".features:measure_features",
        "sources": ".library:sources_of",
        "detail_document": ".record:detail_document",
        "detail_of": ".record:detail_of",
        "plots": ".plots:plots_of_village",
        "schemes": ".uses:measure_schemes",
    },
    tables={
        "presets": ".presets:PRESETS",
        "solvers": ".solvers:VILLAGE_SOLVERS",
        "remedies": ".advice:REMEDIES",
        "compromises": ".advice:COMPROMISES",
        "meanings": ".reasons:MEANINGS",
        "reasons": ".features:REASONS",
    },
    formats=(
        Format(
            ".geojson",
            "lanes, blocks and houses of a village (written)",
            writer=f"{__name__}.writing.geojson",
            domain="village",
            lacks=MAPPED,
        ),
        Format(
            ".gpkg",
            "the same as GeoPackage (written)",
            writer="scenewright.formats.gpkg",
            domain="village",
            lacks=MAPPED,
        ),
        Format(
            ".city.json",
            "city model (CityJSON) of a village (written)",
            writer=f"{__name__}.writing.cityjson",
            domain="village",
            lacks=("roofs", *MAPPED),
        ),
        Format(
            ".street.png",
            "picture of a village from its lane",
            writer="scenewright.formats.street_png",
            domain="village",
            lacks=SEEN,
        ),
    ),
    maps=".reading.geojson",
)
