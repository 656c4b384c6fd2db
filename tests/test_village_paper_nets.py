"""The paper's networks by NumPy: of any size, equal to slow plain sums; files that hold none."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.domains.village.learning.paper.batches import PRINTED as SCHEDULE
from scenewright.domains.village.learning.paper.batches import Feed, steps_left
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.nets_file import (
    ASKED,
    PRINTED,
    SHIPPED,
    SMALL,
    NetSizes,
    PaperNets,
    read_paper_nets,
    shapes_of_nets,
    shipped_nets,
    write_paper_nets,
)
from scenewright.domains.village.paper.passes import (
    draw_cosine,
    odds_of_another,
    odds_of_classes,
    odds_of_places,
)
from scenewright.domains.village.paper.retrieval import door_facing

ODD = NetSizes(96, ((5, 2), (7, 1)), (6, 4), 9, 3)
"""No size of either form; views of 96 pixels."""

STYLE = SHIPPED.parents[1] / "learned" / "europe.npz"


def drawn(sizes: NetSizes, seed: int = 0) -> PaperNets:
    """Networks with random weights of a usual spread."""
    rng, found = np.random.default_rng(seed), {}
    for name, shape in shapes_of_nets(sizes):
        spread = (2 / np.prod(shape[1:])) ** 0.5 if len(shape) > 1 else 0.2
        value = rng.normal(0, spread, shape) + name.endswith(("1.weight", "4.weight"))
        found[name] = (np.abs(value) + 0.5 if "running_var" in name else value).astype(np.float32)
    return PaperNets(sizes, found, {})


def conv_at(nets: PaperNets, name: str, x: np.ndarray, stride: int, at: tuple[int, int]) -> float:
    """One number of a convolution's first channel, summed pixel by pixel."""
    kernel, found = nets.weights[f"{name}.weight"][0].astype(float), 0.0
    pad = kernel.shape[-1] // 2
    for channel, row, column in np.ndindex(kernel.shape):
        i, j = at[0] * stride + row - pad, at[1] * stride + column - pad
        if 0 <= i < x.shape[1] and 0 <= j < x.shape[2]:
            found += kernel[channel, row, column] * float(x[channel, i, j])
    bias = nets.weights.get(f"{name}.bias")
    return found + (0.0 if bias is None else float(bias[0]))


def slow(nets: PaperNets, name: str, x: np.ndarray, stride: int = 1) -> np.ndarray:
    """A convolution as a sum of moved pictures, one weight at a time, in double precision."""
    kernel = nets.weights[f"{name}.weight"].astype(float)
    side, size = kernel.shape[-1], x.shape[1] // stride
    wide = np.pad(x.astype(float), ((0, 0), (side // 2,) * 2, (side // 2,) * 2))
    found = np.zeros((len(kernel), size, size))
    for row, column in np.ndindex(side, side):
        moved = wide[:, row : row + x.shape[1] : stride, column : column + x.shape[2] : stride]
        found += np.tensordot(kernel[:, :, row, column], moved, 1)
    bias = nets.weights.get(f"{name}.bias", np.zeros(len(kernel)))
    return np.asarray(found + np.reshape(bias, (-1, 1, 1)))


def normed(nets: PaperNets, name: str, x: np.ndarray) -> np.ndarray:
    scale, shift, mean, spread = (
        nets.weights[f"{name}.{part}"].astype(float)[:, None, None]
        for part in ("weight", "bias", "running_mean", "running_var")
    )
    return np.asarray((x - mean) / np.sqrt(spread + 1e-5) * scale + shift)


def dense(nets: PaperNets, name: str, x: np.ndarray) -> np.ndarray:
    found = nets.weights[f"{name}.weight"].astype(float) @ x
    return np.asarray(found + nets.weights[f"{name}.bias"])


def step(nets: PaperNets, conv: str, norm: str, x: np.ndarray, stride: int) -> np.ndarray:
    return np.asarray(np.maximum(normed(nets, norm, slow(nets, conv, x, stride)), 0))


def slow_continue(nets: PaperNets, view: np.ndarray) -> float:
    x = step(nets, "continue/0", "continue/1", view, 2)
    wide = np.pad(x, ((0, 0), (1, 1), (1, 1)))
    half = x.shape[1] // 2
    x = np.max(
        [wide[:, i : i + 2 * half : 2, j : j + 2 * half : 2] for i, j in np.ndindex(3, 3)], 0
    )
    number = 4
    for stage, (_, blocks) in enumerate(nets.sizes.stages):
        for k in range(blocks):
            at, stride = f"continue/{number}", 2 if stage and not k else 1
            inner = step(nets, f"{at}.main.0", f"{at}.main.1", x, stride)
            inner = normed(nets, f"{at}.main.4", slow(nets, f"{at}.main.3", inner))
            if stride == 2:
                x = normed(nets, f"{at}.round.1", slow(nets, f"{at}.round.0", x, 2))
            x, number = np.maximum(inner + x, 0), number + 1
    x = np.maximum(dense(nets, f"continue/{number + 2}", x.mean((1, 2))), 0)
    return float(1 / (1 + np.exp(-dense(nets, f"continue/{number + 4}", x)[0])))


def slow_seen(nets: PaperNets, name: str, x: np.ndarray) -> np.ndarray:
    for k in range(len(nets.sizes.channels)):
        x = step(nets, f"{name}/seen.{3 * k}", f"{name}/seen.{3 * k + 1}", x, 2)
    half = x.shape[1] // 2
    parts = [x[:, :half, :half], x[:, :half, half:], x[:, half:, :half], x[:, half:, half:]]
    return np.stack([part.mean((1, 2)) for part in parts], 1).ravel()


def slow_places(nets: PaperNets, x: np.ndarray) -> np.ndarray:
    at = 0
    for _ in nets.sizes.channels:
        x, at = step(nets, f"location/{at}", f"location/{at + 1}", x, 2), at + 3
    for _ in nets.sizes.channels:
        x = np.kron(x, np.ones((1, 2, 2)))
        x, at = step(nets, f"location/{at + 1}", f"location/{at + 2}", x, 1), at + 4
    return np.asarray(slow(nets, f"location/{at}", x)[0])


@pytest.mark.parametrize("sizes", [ODD, PRINTED], ids=["odd", "printed"])
def test_passes_of_any_size_are_the_plain_sums(sizes: NetSizes) -> None:
    nets, rng = drawn(sizes), np.random.default_rng(1)
    view = rng.normal(size=(12, sizes.pixels, sizes.pixels)).astype(np.float32)
    planes = np.concatenate([view, view[:8] > 0]).astype(np.float32)
    counts, shape = rng.random(8).astype(np.float32), np.eye(2, dtype=np.float32)[1]
    hidden = rng.normal(size=sizes.hidden).astype(np.float32)
    assert odds_of_another(nets, view) == pytest.approx(slow_continue(nets, view), abs=1e-4)
    seen = np.concatenate([slow_seen(nets, "area", view), counts])
    asked = dense(nets, "area/head.2", np.maximum(dense(nets, "area/head.0", seen), 0))
    assert odds_of_classes(nets, "area", view, counts) == pytest.approx(asked, abs=1e-4)
    assert odds_of_places(nets, planes) == pytest.approx(slow_places(nets, planes), abs=1e-4)
    seen = np.concatenate([slow_seen(nets, "orientation", view), shape, hidden])
    inner = np.maximum(dense(nets, "orientation/outer.0", seen), 0)
    cosine = np.tanh(dense(nets, "orientation/outer.2", inner)[0])
    assert draw_cosine(nets, view, shape, hidden) == pytest.approx(cosine, abs=1e-4)


def test_the_plain_sums_are_sums_of_single_pixels() -> None:
    nets = drawn(ODD)
    view = np.random.default_rng(2).normal(size=(12, 96, 96))
    found = slow(nets, "continue/0", view, 2)[0]
    for at in ((0, 0), (3, 47), (20, 11)):
        assert found[at] == pytest.approx(conv_at(nets, "continue/0", view, 2, at), abs=1e-9)


def test_a_file_of_any_size_is_read_as_written_and_used(tmp_path: Path) -> None:
    path = tmp_path / "odd.npz"
    write_paper_nets(path, drawn(ODD))
    found = read_paper_nets(path)
    assert found.sizes == ODD
    first = drawn(ODD).weights["continue/0.weight"]
    assert (found.weights["continue/0.weight"] == first.astype(np.float16)).all()
    made = sw.arrange("sample:village-hamlet", preset="paper", nets=str(path))
    assert made.solution.brief.part.nets == str(path)
    assert shipped_nets().sizes.pixels == 64


def _truncate(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:5000])


def _change(**more: object) -> Callable[[Path], None]:
    def change(path: Path) -> None:
        nets = drawn(ODD)
        sizes, weights = nets.sizes, dict(nets.weights)
        if "pixels" in more:
            sizes = sizes._replace(pixels=int(str(more["pixels"])))
        if "without" in more:
            del weights[str(more["without"])]
        if "broken" in more:
            weights[str(more["broken"])] *= np.nan
        write_paper_nets(path, PaperNets(sizes, weights, {}))

    return change


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (_truncate, "networks"),
        (lambda path: path.write_text("x"), "networks"),
        (
            lambda path: path.write_bytes((SHIPPED.parents[1] / "learned/europe.npz").read_bytes()),
            "sizes",
        ),
        (_change(pixels=100), "100 pixels"),
        (_change(without="location/0.weight"), "location/0.weight"),
        (_change(broken="area/head.0.bias"), "area/head.0.bias"),
        (lambda path: path.unlink(), "no such file"),
    ],
    ids=["cut", "text", "style", "pixels", "missing", "not finite", "none"],
)
def test_a_wrong_file_is_one_line(
    tmp_path: Path, spoil: Callable[[Path], object], said: str
) -> None:
    path = tmp_path / "nets.npz"
    write_paper_nets(path, drawn(ODD))
    spoil(path)
    with pytest.raises(InputError) as caught:
        sw.arrange("sample:village-hamlet", preset="paper", nets=str(path))
    assert said in str(caught.value)
    assert "nets.npz" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_networks_are_for_the_solver_that_asks_them() -> None:
    with pytest.raises(InputError, match="add --preset paper"):
        sw.arrange("sample:village-hamlet", nets=str(SHIPPED))
    with pytest.raises(InputError, match="--nets is for villages"):
        sw.arrange("sample:home-room", nets=str(SHIPPED))


def test_the_printed_schedule_goes_on_where_it_was() -> None:
    """9.3 million views of the paper's 5,393 samples; networks take turns, an epoch each."""
    assert 5393 * sum(SCHEDULE.epochs.values()) == 9_275_960
    ring = np.array([[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]])
    rings = tuple(ring + np.array([9.0 * k, 3.0]) for k in range(6))
    floor, street = shapely.box(0, 0, 60, 30), np.array([[[0.0, 0], [60, 0]]])
    feed = Feed([RealBlock("b", "p", floor, street, rings)], SMALL, SCHEDULE, 0)
    steps = list(steps_left(feed, dict.fromkeys(ASKED, 0)))
    counts = Counter(step.name for step in steps)
    assert counts == {**SCHEDULE.epochs, "orientation": 2 * 400}
    assert [step.name for step in steps[:7]] == [*ASKED, "orientation"]
    done = Counter(step.name for step in steps[:1001])
    assert list(steps_left(feed, done)) == steps[1001:]


def test_the_middle_of_a_house_is_that_of_its_least_rectangle() -> None:
    wing = np.array([[0.0, 0], [6, 0], [6, 2], [2, 2], [2, 6], [0, 6]])
    floor = shapely.box(-20, -1, 20, 30)
    assert door_facing(wing, np.array([3.0, 0.0]), floor) == pytest.approx(90)
