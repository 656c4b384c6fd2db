"""A particle swarm (Kennedy, Eberhart 1995), and homes by one over the genes of their patches.

The constriction is that of Clerc, Kennedy 2002: w = 0.7298, c = 1.49618. For homes 40 particles fly
100 rounds, as many layouts as the paper's genetic algorithm looks at.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.asked import rate_unrated

Floats = NDArray[np.float64]
INERTIA, PULL = 0.7298, 1.49618
PARTICLES, ROUNDS = 40, 100


class ParticleSwarm(NamedTuple):
    """Positions and velocities (P, m), the best of each particle with its energy (P,), bounds, and
    whether anything was rated."""

    places: Floats
    speeds: Floats
    bests: Floats
    energies: Floats
    low: Floats
    high: Floats
    rated: bool = False


class Swarm(NamedTuple):
    """Ask / tell of :class:`scenewright.engine.solve.PopulationSolver`; ``first`` (P, m) where it
    starts, given parents among them."""

    first: Floats

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> ParticleSwarm:
        """At the first places, with small random speeds."""
        speeds = 0.1 * (high - low) * rng.uniform(-1.0, 1.0, self.first.shape)
        energies = np.full(len(self.first), math.inf)
        return ParticleSwarm(self.first.copy(), speeds, self.first.copy(), energies, low, high)

    def ask(self, state: ParticleSwarm, rng: np.random.Generator) -> tuple[Floats, ParticleSwarm]:
        """Where the particles are; after the first round each flies on, pulled to its own best
        and to the best of all, and stays within the bounds. While none is rated, anywhere."""
        if not state.rated:
            return state.places, state
        if not np.isfinite(state.energies).any():
            places = rng.uniform(state.low, state.high, state.places.shape)
            return places, state._replace(places=places, bests=places)
        shape, leader = state.places.shape, state.bests[state.energies.argmin()]
        speeds = INERTIA * state.speeds
        speeds += PULL * rng.random(shape) * (state.bests - state.places)
        speeds += PULL * rng.random(shape) * (leader - state.places)
        places = np.clip(state.places + speeds, state.low, state.high)
        return places, state._replace(places=places, speeds=speeds)

    def tell(self, state: ParticleSwarm, genes: Floats, energies: Floats) -> ParticleSwarm:
        """Each particle keeps its best; what is not rated is none."""
        better = rate_unrated(energies) < state.energies
        bests = np.where(better[:, None], genes, state.bests)
        least = np.where(better, energies, state.energies)
        return state._replace(bests=bests, energies=least, rated=True)
