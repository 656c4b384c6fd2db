"""A toy domain: blankets on a meadow, each apart from the next. It shows what a domain takes."""

from __future__ import annotations

from scenewright.domains.contract import Domain

DOMAIN = Domain(
    name="meadow",
    about="blankets on a meadow",
    package=__name__,
    part=".meadow:MeadowPart",
    rooms=False,
    noun="meadow",
    verbs={
        "plan": ".meadow:plan",
        "solve": ".meadow:solve",
        "check": ".meadow:check",
        "scene": ".meadow:scene",
        "draw": ".meadow:draw",
    },
    tables={
        "presets": ".meadow:PRESETS",
        "solvers": ".meadow:SOLVERS",
        "meanings": ".meadow:TERMS",
    },
)
