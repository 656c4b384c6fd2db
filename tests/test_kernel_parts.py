"""How kernels are compiled: parts once for all constants, with the passes that kernels need."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.kernel_store import KernelStore


@inlined
def raised(x: float, times: int, twice: bool) -> float:
    """``x`` and so many more."""
    return x + (2.0 * times if twice else times)


@compiled
def raise_both(values: np.ndarray, times: int) -> float:
    """A part with constants, and with numbers that are not."""
    total = 0.0
    for k in range(values.shape[0]):
        total += raised(values[k], times, k > 0) + raised(values[k], 1, True)
    return total


@pytest.fixture(autouse=True)
def _fresh(tmp_path: Path) -> None:
    raise_both._cache = KernelStore(raise_both.py_func, (tmp_path,))


def test_a_part_is_compiled_once_for_constants_and_others() -> None:
    assert raise_both(np.array([1.0, 10.0]), 3) == 4.0 + 3.0 + 16.0 + 12.0
    assert len(raised.overloads) == 1
