"""Random numbers inside kernels: the state is an argument, streams are the same everywhere."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled

Stream = NDArray[np.uint64]


def streams(seed: int, count: int) -> Stream:
    """Independent streams ``(count, 1)`` for the chains of a run."""
    state = np.random.SeedSequence(seed).generate_state(count, np.uint64)
    return np.maximum(state, 1).reshape(count, 1)


@compiled
def bits(stream: Stream) -> np.uint64:
    """The next 64 random bits: xorshift64* (Marsaglia 2003; Vigna 2016)."""
    x = stream[0]
    x ^= x >> np.uint64(12)
    x ^= x << np.uint64(25)
    x ^= x >> np.uint64(27)
    stream[0] = x
    return x * np.uint64(2685821657736338717)


@compiled
def uniform(stream: Stream) -> float:
    """A number in [0, 1)."""
    return float(bits(stream) >> np.uint64(11)) * 2.0**-53


@compiled
def below(stream: Stream, count: int) -> int:
    """An integer in 0 … count - 1."""
    return min(int(uniform(stream) * count), count - 1)


@compiled
def bell(stream: Stream) -> float:
    """Nearly normal with mean 0, variance 1, within ±3.5: the sum of four uniforms of 16 bits."""
    x, part = bits(stream), np.uint64(0xFFFF)
    low = (x & part) + ((x >> np.uint64(16)) & part)
    high = ((x >> np.uint64(32)) & part) + (x >> np.uint64(48))
    return (float(low + high) * 2.0**-16 - 2.0) * 1.7320508075688772
