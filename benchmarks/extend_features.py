"""Descriptors of models: how well the paper's and ours tell furniture, city and village parts.

Classes are those of ``model_classes.csv`` (from file names, near twins left out; committed before
anything was tuned). The weights of our parts were chosen on the models whose file has an odd
CRC-32; the others are held out. 1-NN: the share of models whose nearest other is of their class;
AMI of Ward's classes with the true ones (0 for labels at random); k-entropy impurity; and how far
two orders of presentation agree, online, by fuzzy ART and by our leader.
"""

from __future__ import annotations

import csv
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple
from zlib import crc32

import numpy as np

from benchmarks.real_data import data_set, skipped
from scenewright.catalog.descriptors.compact import compact_descriptor
from scenewright.catalog.descriptors.printed import printed_descriptor
from scenewright.catalog.loading import read_entry
from scenewright.core.brief.catalog import entry_of
from scenewright.core.errors import InputError
from scenewright.engine.clustering.agreement import (
    adjusted_mutual_information,
    k_entropy,
    nearest_share,
)
from scenewright.engine.clustering.linkage import k_means, leader, ward
from scenewright.engine.clustering.resonance import ResonanceSettings, fuzzy_art
from scenewright.geometry.mesh import Mesh, merge

Record = dict[str, Any]
TABLE = Path(__file__).parent / "model_classes.csv"
ORDERS = 6
VIGILANCES = (0.6, 0.7, 0.75, 0.8, 0.85, 0.9)


class DescribedSet(NamedTuple):
    """The models of one set: both descriptors (n, d), classes and coarse classes (n,), processor
    milliseconds a model for each descriptor, and which are ``held`` out (n,)."""

    vectors: dict[str, np.ndarray]
    classes: np.ndarray
    coarse: np.ndarray
    milliseconds: dict[str, float]
    held: np.ndarray


def records(
    quick: bool, progress: Callable[[float, str], None] | None = None, full: bool = False
) -> Iterator[Record]:
    """Records of both descriptors on all sets."""
    del full
    heard = progress or (lambda _share, _words: None)
    names = ("village",) if quick else ("furniture", "city", "village")
    for number, name in enumerate(names):
        try:
            found = describe_set(name)
        except InputError as fault:
            yield skipped(name, fault)
            continue
        yield from _records(name, found)
        heard((number + 1) / len(names), name)


def describe_set(name: str) -> DescribedSet:
    """Read the models of a set and describe each."""
    with TABLE.open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["set"] == name]
    vectors: dict[str, list[np.ndarray]] = {"paper": [], "ours": []}
    spent = dict.fromkeys(vectors, 0.0)
    for row in rows:
        entry = entry_of(str(data_set(row["file"].split("/")[0]).parent / row["file"]))
        parts = read_entry(entry).models[0].model.parts
        mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
        begun = time.process_time()
        vectors["paper"].append(printed_descriptor(mesh))
        middle = time.process_time()
        vectors["ours"].append(compact_descriptor(parts))
        spent["paper"] += middle - begun
        spent["ours"] += time.process_time() - middle
    classes = np.unique([row["class"] for row in rows], return_inverse=True)[1]
    coarse = np.unique([row["coarse"] for row in rows], return_inverse=True)[1]
    return DescribedSet(
        {key: np.array(value) for key, value in vectors.items()},
        classes,
        coarse,
        {key: 1000 * value / len(rows) for key, value in spent.items()},
        np.array([crc32(row["file"].encode()) % 2 == 0 for row in rows]),
    )


def _records(name: str, found: DescribedSet) -> Iterator[Record]:
    count = len(found.classes)
    for words, classes in (("", found.classes), (" coarse", found.coarse)):
        kinds = len(np.unique(classes))
        if words and kinds == len(np.unique(found.classes)):
            continue
        case = f"{name}, {count} models, {kinds}{words} classes"
        for metric, measure in (
            ("1-NN", nearest_share),
            ("1-NN of those held out", partial(_nearest_held, held=found.held)),
            ("AMI of Ward", _ami_of_ward),
            ("AMI of k-means", _ami_of_k_means),
            ("k-entropy", k_entropy),
        ):
            values = {key: float(measure(v, classes)) for key, v in found.vectors.items()}
            yield _record(case, metric, values["ours"], values["paper"], "the paper's")
    yield _record(
        f"{name}, {count} models",
        "ms a model",
        found.milliseconds["ours"],
        found.milliseconds["paper"],
        "the paper's",
    )
    ours, art = order_agreement(found)
    case = f"{name}, {ORDERS} orders of presentation"
    yield _record(case, "AMI of two orders", ours, art, "fuzzy ART of the paper's descriptor")


def order_agreement(found: DescribedSet) -> tuple[float, float]:
    """The mean AMI of pairs of orders: our leader, and fuzzy ART of the paper's descriptor, each
    at the threshold that gives about as many classes as there are."""
    wanted = len(np.unique(found.classes))
    ours, paper = found.vectors["ours"], found.vectors["paper"]
    gaps = np.linalg.norm(ours[:, None] - ours[None], axis=2)
    marks = np.quantile(gaps[np.triu_indices(len(ours), 1)], np.linspace(0.02, 0.5, 24))
    threshold = min(marks, key=lambda t: abs(leader(ours, float(t)).max() + 1 - wanted))
    vigilance = min(
        VIGILANCES, key=lambda v: abs(fuzzy_art(paper, ResonanceSettings(v)).max() + 1 - wanted)
    )
    return (
        _agreement(lambda rows: leader(ours[rows], float(threshold)), len(ours)),
        _agreement(lambda rows: fuzzy_art(paper[rows], ResonanceSettings(vigilance)), len(ours)),
    )


def _agreement(sort: Callable[[np.ndarray], np.ndarray], count: int) -> float:
    rng = np.random.default_rng(0)
    labels = []
    for _ in range(ORDERS):
        order = rng.permutation(count)
        label = np.zeros(count, np.int64)
        label[order] = sort(order)
        labels.append(label)
    pairs = [(a, b) for k, a in enumerate(labels) for b in labels[:k]]
    return float(np.mean([adjusted_mutual_information(a, b) for a, b in pairs]))


def _record(case: str, metric: str, ours: float, base: float, by: str) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": "ms" if metric.startswith("ms") else "1",
        "ours": round(ours, 4),
        "baseline": round(base, 4),
        "baseline_name": by,
        "ratio": round(ours / base, 3) if base else None,
        "runs": 1,
    }


def _nearest_held(vectors: np.ndarray, classes: np.ndarray, held: np.ndarray) -> float:
    """The share of the models held out whose nearest of all others is of their class."""
    away = ((vectors[:, None] - vectors[None]) ** 2).sum(2)
    np.fill_diagonal(away, np.inf)
    return float((classes[away.argmin(1)] == classes)[held].mean())


def _ami_of_ward(vectors: np.ndarray, classes: np.ndarray) -> float:
    return adjusted_mutual_information(ward(vectors, int(classes.max()) + 1), classes)


def _ami_of_k_means(vectors: np.ndarray, classes: np.ndarray) -> float:
    return adjusted_mutual_information(k_means(vectors, int(classes.max()) + 1), classes)
