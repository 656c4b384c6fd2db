"""Halls: exhibitions, shops, reading rooms, auditoria: groups of like objects in zones."""

from __future__ import annotations

from scenewright.domains.contract import Domain

DOMAIN = Domain(
    name="hall",
    about="exhibitions, shops, reading rooms, auditoria: groups in zones",
    package=__name__,
    lacks=("accessible", "residents", "style", "colour"),
    rooms_lack=("slopes", "wishes"),
    defaults={"route_width": 0.9, "name": "hall"},
    detail=".record:DetailRecord",
    verbs={
        "plan": "scenewright.building.plan:plan_rooms",
        "validate": ".zoning.zones:check_halls",
        "problems": ".solving:problems",
        "solve": ".solving:solve",
        "solution": ".solution:solution_of",
        "given": "scenewright.building.standing:given_pieces",
        "check": ".check.judge:check",
        "findings": ".check.judge:check_rules",
        "scene": ".furnishing.islands:scene_of_hall",
        "draw": ".drawing.overlay:draw",
        "draw_levels": ".drawing.overlay:draw_levels",
        "alternatives": ".alternatives:alternatives",
        "compare": ".alternatives:compare",
        "describe": ".alternatives:describe",
        "adjust": ".adjust:adjust",
        "editing": ".editing:rules_of",
        "locked": ".record:lock_halls",
        "floors": ".floors:floors_of",
        "detail_document": ".record:detail_document",
        "detail_of": ".record:detail_of",
        "features": ".features:measure_features",
        "breeder": ".breeding:make_breeder",
        "passes": ".passes:trace_passes",
        "generate": ".generating:generate_hall",
    },
    tables={
        "reasons": ".features:REASONS",
        "presets": ".presets:PRESETS",
        "solvers": ".solvers:HALL_SOLVERS",
        "terms": ".terms.table:HALL_TERMS",
        "remedies": ".advice:REMEDIES",
        "compromises": ".advice:COMPROMISES",
        "meanings": ".terms.table:MEANINGS",
        "patterns": ".patterns:PATTERNS",
        "themes": ".demands.themes:THEMES",
    },
    maps=".indoor.geojson",
)
