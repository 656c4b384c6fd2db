"""Simulated persons: a hidden taste, noise that grows as they tire, a drifting scale, anchoring.

No panel of people was at hand: every figure from these says so.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.person_world import FIRST, SeenLayout, World
from scenewright.core.breeding import Genome
from scenewright.engine.preference.taste import reason_step, standardise
from scenewright.workflow.evolution.population import draw_genomes

Floats = NDArray[np.float64]
LIKED, BENT = 7, 2
"""Features a taste is made of; for so many of them neither little nor much is best."""
HIDDEN = 0.35
"""Weight of each of the three measures the engine does not see, where a feature weighs about 1."""
NOISE, FRESH, TIRING = 0.3, 80, 120.0
"""Noise of a judgement in standard deviations of the taste; after so many judgements it grows by
itself in so many more."""
DRIFT, ANCHOR = 0.05, 0.25
"""How far the scale of ratings drifts a screen, in stars, and how far a rating is drawn to those of
the same screen before it."""


class Taster(NamedTuple):
    """A hidden taste: ``linear`` and ``bent`` weights (D,) with the best places (D,) of the latter,
    weights of what is ``unseen`` (3,) with its scale, mean and spread of the taste over layouts by
    chance, and whether it is ``conjunctive``: what counts is the worst of the linear parts, which
    no sum of features says."""

    linear: Floats
    bent: Floats
    best: Floats
    unseen: Floats
    usual: Floats
    spread: Floats
    middle: float
    unit: float
    conjunctive: bool = False


def make_taster(world: World, seed: int, conjunctive: bool = False) -> Taster:
    """A person: a few features liked or disliked, of those that vary."""
    rng = np.random.default_rng([77, seed])
    rows = [world.look(g) for g in draw_genomes(world.genes, 99, FIRST, np.random.default_rng(1))]
    hidden = np.array([row.unseen for row in rows])
    dims = len(world.scale.names)
    varying = np.flatnonzero(np.isfinite(world.scale.spread))
    chosen = rng.choice(varying, LIKED, replace=False)
    linear, bent, best = np.zeros(dims), np.zeros(dims), np.zeros(dims)
    linear[chosen[BENT:]] = rng.choice([-1.0, 1.0], LIKED - BENT) * rng.uniform(0.5, 1.5)
    bent[chosen[:BENT]] = 0.5
    best[chosen[:BENT]] = rng.uniform(-1.0, 1.0, BENT)
    signs = HIDDEN * rng.choice([-1.0, 1.0], 3)
    taster = Taster(
        linear, bent, best, signs, hidden.mean(0), hidden.std(0) + 1e-9, 0.0, 1.0, conjunctive
    )
    values = np.array([like(taster, world, row) for row in rows])
    return taster._replace(middle=float(values.mean()), unit=float(values.std()))


def like(taster: Taster, world: World, row: SeenLayout, moved: Floats | None = None) -> float:
    """How much a person truly likes a layout, 0 on average, 1 a standard deviation; ``moved`` (D,)
    by so many standard deviations of its features."""
    at = standardise(world.scale, row.values) + (0.0 if moved is None else moved)
    parts = taster.linear * at
    visible = parts.sum() - taster.bent @ (at - taster.best) ** 2
    if taster.conjunctive:
        visible = parts[taster.linear != 0.0].min()
    hidden = taster.unseen @ ((row.unseen - taster.usual) / taster.spread)
    return (float(visible + hidden) - taster.middle) / taster.unit


class SimulatedPerson:
    """Somebody who judges, and tires of it."""

    def __init__(
        self, world: World, seed: int, noise: float = 1.0, conjunctive: bool = False
    ) -> None:
        self.world, self.taster = world, make_taster(world, seed, conjunctive)
        self._rng = np.random.default_rng([78, seed])
        self._noise, self.judged, self._strict = noise * NOISE, 0, 0.0
        self._truth: dict[Genome, float] = {}

    def truth(self, genome: Genome) -> float:
        """How much a layout is liked, without noise."""
        if genome not in self._truth:
            self._truth[genome] = like(self.taster, self.world, self.world.look(genome))
        return self._truth[genome]

    def best(self, among: Sequence[Genome], sign: float = 1.0) -> Genome:
        """The best of some, or with ``sign`` -1 the worst, as far as the person can tell."""
        noise = self._tired() * self._rng.standard_normal(len(among))
        told = sign * np.array([self.truth(genome) for genome in among]) + noise
        return among[int(told.argmax())]

    def reason(self, genome: Genome) -> str | None:
        """What a layout lacks most, of the reasons there are; none if nothing would help."""
        row, now = self.world.look(genome), self.truth(genome)
        gain, noise = {}, self._tired()
        for words, wanted in self.world.reasons.items():
            step = reason_step(self.world.scale, wanted)
            if step.any():
                better = like(self.taster, self.world, row, step) - now
                gain[words] = better + 0.5 * noise * float(self._rng.standard_normal())
        best = max(gain, key=gain.__getitem__, default="")
        return best if gain.get(best, 0.0) > 0.0 else None

    def rate(self, genomes: Sequence[Genome]) -> Floats:
        """Stars, 1 to 5, of a screen one after the other (n,)."""
        self._strict += DRIFT * float(self._rng.standard_normal())
        given: list[float] = []
        for genome in genomes:
            felt = 3.0 + self.truth(genome) / 1.5 + self._strict
            felt += self._tired() / 1.5 * float(self._rng.standard_normal())
            if given:
                felt += ANCHOR * (float(np.mean(given)) - felt)
            given.append(float(np.clip(round(felt), 1, 5)))
        return np.array(given)

    def _tired(self) -> float:
        """The noise of the next judgement."""
        self.judged += 1
        return self._noise * (1.0 + max(self.judged - FRESH, 0) / TIRING)
