"""What F_eva (22) of Zhang and Yang (2023) tells of complete layouts, and whether M sees.

Random layouts of the matrix code that hold all that is asked for; R, M, C and H of each in the
repaired form, and the printed M beside. How much of the variance of F_eva each part explains, and
how M, measured with boxes from the eyes on the ways, agrees with 20 views between and beside those
eyes, ray by ray on the meshes.

python -m benchmarks.site_value
"""

from __future__ import annotations

from typing import Any

import numpy as np

import scenewright as sw
from scenewright.catalog.assets import shipped
from scenewright.core.scene import Size
from scenewright.domains.site.encodings.cell_moves import random_genes
from scenewright.domains.site.encodings.refill import count_kinds, make_amount, refill
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge, measure_seen
from scenewright.domains.site.solving import problems
from scenewright.domains.site.terms.measure import lay
from scenewright.domains.site.terms.value import OMEGA, value_parts
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.relief import relief
from scenewright.geometry.walker_meshes import SaliencyModel, sights_of_meshes, street

SAMPLES, LAYOUTS, VIEWS, RAYS = ("site-30", "site-landmarks"), 60, 20, 400
PARTS = ("R", "M", "C", "H")


def measure_sample(name: str, layouts: int = LAYOUTS, seed: int = 5) -> dict[str, Any]:
    """Shares of variance and the correlation with views of one sample."""
    problem = problems(sw.read(f"sample:{name}"))[0]
    cells, rng = make_cells(problem), np.random.default_rng(seed)
    judge = make_judge(problem, cells)
    amount = make_amount((0.0, 0.0), cells, problem.buildings.floors)
    views = draw_views(problem, rng)
    rows: list[list[float]] = []
    models, which = collect_models(problem)
    while len(rows) < layouts:
        genes = random_genes(cells, rng, problem.buildings.quality, float(rng.random()))
        refill(cells, genes, amount, rng)
        if count_kinds(cells, genes).sum() < len(which):
            continue
        boxes, parts = judge.boxes(genes.reshape(1, -1).astype(float))[0], np.empty(4)
        lay(judge.measure.p, judge.measure.s, boxes)
        value_parts(judge.measure.s, judge.worth, parts)
        printed, parts[1] = parts[1], measure_seen(problem, boxes)
        poses = np.column_stack([boxes[:, :2], np.zeros(len(boxes)), boxes[:, 2]])
        shown = sights_of_meshes(street(models, which, poses), views, 1.0, RAYS).values.mean()
        rows.append([parts @ np.array(OMEGA), *parts, shown, printed])
    return summarize(name, np.array(rows))


def summarize(name: str, rows: Floats) -> dict[str, Any]:
    """The record of a sample; ``rows`` (n, 7) F_eva, R, M, C, H, what views show, printed M."""
    explained = {
        part: round(float(np.corrcoef(rows[:, 0], rows[:, k])[0, 1] ** 2), 3)
        if rows[:, k].std() > 1e-9
        else 0.0
        for k, part in enumerate(PARTS, 1)
    }
    return {
        "sample": name,
        "layouts": len(rows),
        "deviation of F_eva": round(float(rows[:, 0].std()), 4),
        "variance explained": explained,
        "M with unseen views": round(float(np.corrcoef(rows[:, 2], rows[:, 5])[0, 1]), 3),
        "deviation of printed M": round(float(rows[:, 6].std()), 6),
    }


def draw_views(problem: SiteProblem, rng: np.random.Generator) -> Floats:
    """Points (20, 2) between the eyes of a problem, about a metre beside their ways."""
    eyes = problem.ground.eyes
    between = 0.5 * (eyes[1:] + eyes[:-1]) + rng.normal(0.0, 1.0, (len(eyes) - 1, 2))
    found: Floats = between[np.linspace(0, len(between) - 1, VIEWS).astype(int)]
    return found


def collect_models(problem: SiteProblem) -> tuple[list[SaliencyModel], Any]:
    """The meshes of a problem's buildings with the relief of their faces, and which each has."""
    known: dict[tuple[str, tuple[float, ...]], int] = {}
    models: list[SaliencyModel] = []
    which: list[int] = []
    for name, size in zip(problem.names, problem.buildings.sizes.tolist(), strict=True):
        key = name.rpartition("/")[2].rpartition("_")[0], tuple(size)
        if key not in known:
            known[key] = len(models)
            parts = shipped().assets[key[0]].mesh(Size(*size))
            mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
            models.append(SaliencyModel(mesh, relief(mesh).faces))
        which.append(known[key])
    return models, np.array(which)


def main() -> None:
    """Tell both samples."""
    for name in SAMPLES:
        print(measure_sample(name))


if __name__ == "__main__":
    main()
