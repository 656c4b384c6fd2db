"""The stages of Zhang and Fei (2017) before a person is asked: classes, grammar, symmetry, ants.

The sources' buildings are sorted into classes by their looks (section 2; fuzzy ART, our repair of
the printed ART); a class is a letter of the grammar (1.2), whose groups are the leaves of the box
abstraction, split by symmetry value (20); then ants lay out plots (2.2), and the best of what they
found are the first generation that is bred.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.catalog.descriptors.compact import compact_descriptor
from scenewright.core.breeding import BreedingStage
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Size
from scenewright.domains.extend.areas import ExtendPlan
from scenewright.domains.extend.models import model_of
from scenewright.domains.extend.pattern import SourcePattern
from scenewright.domains.extend.solvers.colony import BredPlots
from scenewright.engine.clustering.resonance import fuzzy_art
from scenewright.engine.trace import Step
from scenewright.ground.buildings.abstraction import abstract_boxes, leaves_of, total_value
from scenewright.ground.buildings.built import frames_of
from scenewright.ground.buildings.grammar import parse_scene, show_layout
from scenewright.text import quantity


def cluster_kinds(brief: Brief, pattern: SourcePattern, catalog: Catalog) -> list[int]:
    """The class of each kind of building of the sources, from 0, by the model that draws it."""
    models = [catalog.assets[model_of(kind, brief.style, catalog)] for kind in pattern.kinds]
    sizes = [Size(*kind.size) for kind in pattern.kinds]
    pairs = zip(models, sizes, strict=True)
    return fuzzy_art(np.array([compact_descriptor(m.mesh(size)) for m, size in pairs])).tolist()


def read_sources(
    made: ExtendPlan, pattern: SourcePattern, classes: Sequence[int]
) -> tuple[BreedingStage, ...]:
    """The stages that read the sources: classes of buildings, the grammar in their letters, and
    the symmetry of the box abstraction."""
    letters = np.array([name_class(one) for one in classes])[pattern.kind]
    sorted_: dict[str, list[str]] = {}
    for kind, one in zip(pattern.kinds, classes, strict=True):
        sorted_.setdefault(name_class(one), []).append(f"{kind.name} x {kind.copies}")
    lines = tuple(f"{letter}: {', '.join(names)}" for letter, names in sorted_.items())
    grammar, symmetry, values = list[str](), list[str](), list[float]()
    for number, scene in enumerate(made.sources):
        frames = frames_of(scene.buildings, scene.roads)
        layout = parse_scene(frames, letters[pattern.source == number].tolist())
        tree = abstract_boxes(frames.boxes)
        grammar += show_layout(layout)
        values.append(total_value(tree))
        symmetry.append(f"{quantity(len(leaves_of(tree)), 'box')}, symmetry value {values[-1]:.2f}")
    return (
        BreedingStage("cluster", lines, {"classes": sorted_}),
        BreedingStage("grammar", tuple(grammar), {"productions": grammar}),
        BreedingStage("symmetry", tuple(symmetry), {"values": values}),
    )


def name_class(number: int) -> str:
    """The letter of a class; from the 27th on with a number.

    >>> name_class(0), name_class(27)
    ('A', 'B1')
    """
    letter = chr(ord("A") + number % 26)
    return letter if number < 26 else f"{letter}{number // 26}"


def tell_ants(found: BredPlots, heard: Sequence[Step]) -> BreedingStage:
    """The stage of the ants: what they walked, and how good their best layouts are."""
    walked = [step for step in heard if step.kind == "ants"]
    ants, moved = sum(s.facts["ants"] for s in walked), sum(s.facts["moved"] > 0 for s in walked)
    work = f"{quantity(ants, 'ant')} in {quantity(len(walked), 'iteration')}"
    line = f"{work}, trails moved in {moved}; F {found.value:.3f}"
    best = [genes.tolist() for genes in found.few[:8]]
    facts = {"ants": ants, "iterations": len(walked), "fitness": found.value, "layouts": best}
    return BreedingStage("ants", (line,), facts)
