"""Homes: dwellings whose rooms are furnished by what they are for."""

from __future__ import annotations

from scenewright.domains.contract import Domain

DOMAIN = Domain(
    name="home",
    about="dwellings: rooms furnished by what they are for",
    package=__name__,
    rooms_lack=("people", "theme", "fill", "like"),
    verbs={
        "plan": "scenewright.building.plan:plan_rooms",
        "validate": ".wished.requests:check_plain",
        "problems": ".solving:problems",
        "solve": ".solving:solve",
        "solution": ".solution:solution_of",
        "given": "scenewright.building.standing:given_pieces",
        "check": ".check.judge:check",
        "findings": ".check.judge:check_rules",
        "scene": ".furnishing.look:scene_of_home",
        "draw": ".drawing.plan:draw",
        "draw_levels": ".drawing.plan:draw_levels",
        "alternatives": ".alternatives:alternatives",
        "compare": ".alternatives:difference",
        "describe": ".alternatives:sides",
        "adjust": ".changes.resolve:adjust",
        "locked": "scenewright.building.standing:locked_rooms",
        "accessible": ".wheelchair:accessible",
        "groups": ".cases.listing:list_groups",
        "styles": ".cases.listing:list_styles",
        "refuse_style": ".furnishing.look:refuse_style",
        "learn": ".learned.from_homes:learn_from_homes",
        "drawn_scale": "scenewright.check.drawn_scale:estimate_scale",
        "programme": ".needs.household:tell_programme",
        "ledger": ".needs.ledger:make_ledger",
        "faults": ".rules.told:tell_faults",
        "appearance": ".furnishing.look:tell_palette",
        "features": ".features:measure_features",
        "breeder": ".breeding:make_breeder",
        "passes": ".passes:trace_passes",
        "generate": ".floorplans.generate:generate_home",
    },
    tables={
        "reasons": ".features:REASONS",
        "presets": ".presets:PRESETS",
        "solvers": ".solvers:SOLVERS",
        "terms": ".terms.table:TERMS",
        "remedies": ".advice:REMEDIES",
        "compromises": ".advice:COMPROMISES",
        "meanings": ".terms.table:MEANINGS",
        "labels": ".groups:LABELS",
    },
)
