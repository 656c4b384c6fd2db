"""The way in is straight: open, parse, report, brief, plan; nothing is asked twice."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

import scenewright
from scenewright.core.atomic_file import recorded_run
from scenewright.workflow.request import ArrangeRequest, plan_request
from test_architecture import LAYERS

PACKAGE = Path(scenewright.__file__).parent
MOST_CLIMBS = 5
"""Calls from a lower layer back up to a higher one along one request."""


def layer_of(frame: FrameType) -> int | None:
    """The layer a function of ours is on; ``None`` for what is not ours."""
    file = Path(frame.f_code.co_filename)
    if not file.is_relative_to(PACKAGE):
        return None
    room = file.relative_to(PACKAGE).parts[0].removesuffix(".py")
    return next(level for level, rooms in enumerate(LAYERS) if room in rooms)


def follow(source: str, output: Path) -> tuple[list[str], Counter[str]]:
    """Calls that lead back up while a request is planned, and how often each function is called."""
    climbs: list[str] = []
    called: Counter[str] = Counter()

    def hear(frame: FrameType, event: str, _: Any) -> None:
        level = layer_of(frame) if event == "call" else None
        if level is None:
            return
        called[frame.f_code.co_name] += 1
        before = frame.f_back
        while before is not None and layer_of(before) is None:
            before = before.f_back
        if before is not None and level > (layer_of(before) or 0):
            climbs.append(frame.f_code.co_name)

    request = ArrangeRequest(source, (output,))
    with recorded_run():
        plan_request(request)  # whatever is imported on first use
        sys.setprofile(hear)
        try:
            plan_request(request)
        finally:
            sys.setprofile(None)
    return climbs, called


@pytest.mark.parametrize(
    "source", ["sample:home-room", "sample:hall-shop", "sample:site-30", "sample:village-hamlet"]
)
def test_a_request_is_planned_without_going_back_and_forth(source: str, tmp_path: Path) -> None:
    climbs, called = follow(source, tmp_path / "out.json")
    assert len(climbs) <= MOST_CLIMBS, climbs
    assert called["check_text"] == 2, "one source, one output"
    assert called["check_targets"] == 1
    assert called["open_source"] == 1
    assert called["plan_of"] == 1
