"""The networks of Zhu, Jiang and Li (2022) in their small form, trained on the training places of a
split: ``python -m benchmarks.village_paper_training A paper_A.npz`` (extra ``learn``; about six
minutes of one core). What is written is read by the preset ``paper``."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from benchmarks.village_data import split
from scenewright.domains.village.learning.paper.export import write_paper_nets
from scenewright.domains.village.learning.paper.nets import SMALL
from scenewright.domains.village.learning.paper.training import BRIEF, train_paper


def main(name: str, output: Path) -> None:
    """Train on one split and write the nets; the same split gives the same file."""
    import torch

    torch.set_num_threads(1)
    train, _ = split(name)
    begun = time.process_time()
    losses: dict[str, list[float]] = {}

    def tell(net: str, step: int, loss: float) -> None:
        losses.setdefault(net, []).append(loss)
        if step % 200 == 0:
            print(net, step, f"{sum(losses[net][-200:]) / 200:.3f}", flush=True)

    nets = train_paper(train, SMALL, BRIEF, 0, tell)
    write_paper_nets(output, nets, {"split": name, "blocks": len(train)})
    print(f"{time.process_time() - begun:.0f} processor seconds")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
