"""Sites: groups of buildings on ground between streets, around landmarks that stand."""

from __future__ import annotations

from scenewright.core.brief.fields import BUILDING
from scenewright.core.registry import MAPPED, SEEN, Format
from scenewright.domains.contract import Domain

DOMAIN = Domain(
    name="site",
    about="groups of buildings on a site, around landmarks",
    package=__name__,
    part=".brief:SitePart",
    detail=".record:DetailRecord",
    rooms=False,
    lacks=("rooms", "levels", "walls", "stairs", "accessible", "residents"),
    defaults={"name": "site"},
    noun="site",
    largest_piece=BUILDING,
    verbs={
        "plan": ".plan:plan_sites",
        "solve": ".solving:solve",
        "problems": ".solving:problems",
        "solution": ".solution:solution_of",
        "given": ".given:given_pieces",
        "check": ".check.judge:check",
        "grounds": ".works:list_grounds",
        "ways": ".works:list_ways",
        "findings": ".check.judge:check_rules",
        "scene": ".furnish:scene_of_sites",
        "draw": ".drawing.plan:draw",
        "alternatives": ".alternatives:alternatives",
        "compare": ".alternatives:compare",
        "describe": ".alternatives:describe",
        "schemes": ".schemes:measure_schemes",
        "adjust": ".adjust:adjust",
        "editing": ".adjust:rules_of",
        "locked": ".locks:lock_sites",
        "detail_document": ".record:detail_document",
        "detail_of": ".record:detail_of",
        "features": ".features:measure_features",
        "breeder": ".breeding:make_breeder",
        "matrix_breeder": ".matrix_breeding:make_matrix_breeder",
    },
    tables={
        "reasons": ".features:REASONS",
        "presets": ".presets:PRESETS",
        "solvers": ".solvers:SITE_SOLVERS",
        "terms": ".terms.table:TERM_ROWS",
        "remedies": ".advice:REMEDIES",
        "compromises": ".advice:COMPROMISES",
        "meanings": ".terms.table:MEANINGS",
    },
    formats=(
        Format(
            ".geojson",
            "footprints of a site (written)",
            writer=f"{__name__}.writing.geojson",
            domain="site",
            lacks=MAPPED,
        ),
        Format(
            ".gpkg",
            "the same as GeoPackage (written)",
            writer="scenewright.formats.gpkg",
            domain="site",
            lacks=MAPPED,
        ),
        Format(
            ".city.json",
            "city model (CityJSON): its buildings as landmarks (read), a site (written)",
            f"{__name__}.reading.cityjson",
            f"{__name__}.writing.cityjson",
            "site",
            lacks=("roofs", *MAPPED),
        ),
        Format(
            ".cityjson",
            "the same under a name that other tools may refuse",
            f"{__name__}.reading.cityjson",
            f"{__name__}.writing.cityjson",
            "site",
            lacks=("roofs", *MAPPED),
        ),
        *(
            Format(
                suffix,
                "city model, a building a line (CityJSONSeq, read)",
                f"{__name__}.reading.cityjson",
                domain="site",
            )
            for suffix in (".city.jsonl", ".jsonl")
        ),
        Format(
            ".street.png",
            "picture of a site at eye height",
            writer="scenewright.formats.street_png",
            domain="site",
            lacks=SEEN,
        ),
    ),
    documents={"CityJSON": ".reading.cityjson:brief_of"},
    maps=".reading.geojson",
)
