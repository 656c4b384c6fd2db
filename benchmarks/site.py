# ruff: noqa: A005  (the command names the module)
"""The site benchmark: ``scenewright bench site``.

Samples and growing sites by our default (:mod:`.site_scale`), scenes of 6 to 120 buildings by every
method (:mod:`.site_methods`), real compounds against their designers (:mod:`.site_compounds`), and
the speed of kernels and saliency (:mod:`.site_speed`). ``python -m benchmarks.site PART…`` runs
parts alone; ``--quick`` and ``--seeds N`` go with it. ``ours`` and ``baseline`` are medians (means
of shares and counts) over ``runs``.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from benchmarks import site_compounds, site_methods, site_scale, site_speed
from benchmarks.site_scenes import SIZES
from benchmarks.stages import run_stages

Record = dict[str, Any]
Progress = Callable[[float, str], None]
PARTS = ("default", "scale", "methods", "compounds", "speed")


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """All records; ``quick`` takes two seeds, scenes of up to 30 buildings, sites of up to 1000
    and ten compounds, and tells six figures of each method."""
    yield from run_stages([(name, partial(part, name, quick)) for name in PARTS], progress)


def part(name: str, quick: bool = False, seeds: int | None = None) -> list[Record]:
    """The records of one part."""
    many = seeds or (2 if quick else 10)
    sizes = SIZES[:3] if quick else SIZES
    parts: dict[str, Callable[[], list[Record]]] = {
        "default": lambda: site_scale.samples_records(many),
        "scale": lambda: site_scale.scale_records(site_scale.SIZES[: 2 if quick else 3]),
        "methods": lambda: site_methods.summary(
            site_methods.rows(many, sizes), site_methods.MAIN if quick else site_methods.FIGURES
        ),
        "compounds": lambda: site_compounds.compound_records(10 if quick else None),
        "speed": lambda: site_speed.speed_records(3 if quick else 9),
    }
    return parts[name]()


def main() -> None:
    """Print the records of some parts, a line of JSON each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", nargs="+", choices=PARTS)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--seeds", type=int)
    told = parser.parse_args()
    for name in told.parts:
        for row in part(name, told.quick, told.seeds):
            print(json.dumps(row), flush=True)


if __name__ == "__main__":
    main()
