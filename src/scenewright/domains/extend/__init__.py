"""Extensions: a neighbourhood grown into an area beside it, in the spirit of its own."""

from __future__ import annotations

from scenewright.core.brief.fields import BUILDING
from scenewright.core.registry import MAPPED, SEEN, Format
from scenewright.domains.contract import Domain

DOMAIN = Domain(
    name="extend",
    about="a neighbourhood continued beside itself",
    package=__name__,
    part=".brief:ExtendPart",
    detail=".record:ExtensionRecord",
    rooms=False,
    lacks=("rooms", "levels", "walls", "stairs", "accessible", "residents"),
    defaults={"name": "extension"},
    noun="area",
    largest_piece=BUILDING,
    budget="layouts",
    a_day=50_000,
    verbs={
        "plan": ".plan:plan_extend",
        "solve": ".solving:solve",
        "problems": ".solving:problems",
        "solution": ".solution:solution_of",
        "given": ".given:given_pieces",
        "check": ".check.judge:check",
        "grounds": ".streets:list_grounds",
        "ways": ".streets:list_ways",
        "scene": ".furnish:scene_of_extension",
        "draw": ".drawing.plan:draw",
        "describe": ".reasons:describe_extension",
        "adjust": ".adjust:adjust",
        "editing": ".adjust:rules_of",
        "locked": ".locks:lock_extension",
        "features": ".features:measure_features",
        "breeder": ".breeding:make_breeder",
        "matrix_breeder": ".matrix_breeding:make_matrix_breeder",
        "plots": ".works:plots_of_extension",
        "schemes": ".uses:measure_schemes",
        "planting": ".planting:describe_planting",
        "detail_document": ".record:detail_document",
        "detail_of": ".record:detail_of",
    },
    tables={
        "presets": ".presets:PRESETS",
        "solvers": ".solvers:EXTEND_SOLVERS",
        "remedies": ".advice:REMEDIES",
        "compromises": ".advice:COMPROMISES",
        "meanings": ".reasons:MEANINGS",
        "reasons": ".features:REASONS",
    },
    formats=(
        Format(
            ".geojson",
            "areas, streets and buildings of an extension (written)",
            writer=f"{__name__}.writing.geojson",
            domain="extend",
            lacks=MAPPED,
        ),
        Format(
            ".gpkg",
            "the same as GeoPackage (written)",
            writer="scenewright.formats.gpkg",
            domain="extend",
            lacks=MAPPED,
        ),
        Format(
            ".city.json",
            "city model (CityJSON) of an extension (written)",
            writer=f"{__name__}.writing.cityjson",
            domain="extend",
            lacks=("roofs", *MAPPED),
        ),
        Format(
            ".street.png",
            "picture across the seam, at eye height",
            writer="scenewright.formats.street_png",
            domain="extend",
            lacks=SEEN,
        ),
    ),
    maps=".reading.geojson",
)
