"""Writing the paper's networks, as trained in PyTorch, as plain arrays."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

LICENCE = "ODbL 1.0, © OpenStreetMap contributors"


def write_paper_nets(path: Path, nets: Mapping[str, Any], card: Mapping[str, Any]) -> None:
    """Write networks by name, in half precision; layers are called as PyTorch calls them."""
    found = {
        f"{name}/{layer}": value.detach().cpu().numpy().astype(np.float16)
        for name, net in nets.items()
        for layer, value in net.state_dict().items()
        if not layer.endswith("num_batches_tracked")
    }
    document = json.dumps({"licence": LICENCE, **card}, sort_keys=True, ensure_ascii=False)
    found["card"] = np.frombuffer(document.encode(), np.uint8)
    with path.open("wb") as file:
        np.savez(file, allow_pickle=False, **found)
