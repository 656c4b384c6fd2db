"""Examples to learn poses from: a real house at its real pose among legal poses proposed for it.

Blocks are taken as the solver fills them: the largest house first, with some chance, and each house
sees those placed before it. States are drawn afresh for every example.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.village.choosing import JITTER
from scenewright.domains.village.house import House, to_own_frame
from scenewright.domains.village.learned.style import VillageStyle, style_in_region
from scenewright.domains.village.learned.surroundings import Surroundings, survey, with_house
from scenewright.domains.village.learned.tokens import PoseTokens, tokens_of
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.library import classify_house
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.proposals import TOUCH, propose, shapes_at
from scenewright.domains.village.settings import GrowSettings, VillageSettings
from scenewright.domains.village.standing import Floats, Shapes, stand

LEARNED = (0.004, 0.14)
"""Spread of proposals beside houses while learning: nearer to parallel than where houses are placed
by what was learned. The net, which takes 1° for nothing, cannot tell quite parallel from nearly so,
and would make too many of the one."""
CHOICES = 32
"""The real pose and the legal proposals beside it, at most."""


class PoseExample(NamedTuple):
    """Features of the real pose (row 0) and of legal proposals, in single precision."""

    tokens: PoseTokens


class Turn(NamedTuple):
    """A house of a real block about to be placed: what it sees, the house, its real pose (3,) and
    footprint, and the shrunken footprints of the houses that stand."""

    seen: Surroundings
    house: House
    pose: Floats
    shape: shapely.Polygon
    taken: Shapes


def problem_of_block(
    block: RealBlock, houses: Sequence[House], style: VillageStyle, settings: VillageSettings
) -> VillageProblem:
    """The problem of filling a real block anew with houses of a library, as in its region."""
    shapely.prepare(block.floor)
    lines = shapely.union_all(shapely.linestrings(block.streets))
    walkable = shapely.union(block.floor, shapely.buffer(lines, 2.0))
    return VillageProblem(
        block.name,
        block.floor,
        block.streets,
        block.street_share,
        walkable,
        stand([], []),
        tuple(houses),
        None,
        None,
        None,
        settings,
        style_in_region(style, block.region),
        shapely.Polygon(),
    )


def turns_of(block: RealBlock, rng: np.random.Generator) -> Iterator[Turn]:
    """The houses of a block in an order of placing, each with the houses placed before it."""
    whole = block.standing
    areas = shapely.area(whole.shapes) * np.exp(rng.normal(0.0, JITTER, len(whole.shapes)))
    order = np.argsort(-areas, kind="stable")
    inner = np.asarray(shapely.buffer(whole.shapes, -TOUCH, join_style="mitre"), object)
    seen = survey(block.floor, block.streets, block.street_share, len(order), whole.take(order[:0]))
    for k, number in enumerate(order.tolist()):
        house, pose = house_at(block.houses[number])
        yield Turn(seen, house, pose, whole.shapes[number], inner[order[:k]])
        seen = with_house(seen, whole.take(order[: k + 1]))


def house_at(ring: Floats) -> tuple[House, Floats]:
    """A real footprint (n, 2) as a house in its own frame, and its pose (3,)."""
    local, turn = to_own_frame(ring)
    house = classify_house("", local, 2, 7.0, "", 1.0)
    frame = stand([ring], [house.size]).frames[0]
    return house, np.array([frame[0], frame[1], turn])


def legal_proposals(
    problem: VillageProblem, turn: Turn, rng: np.random.Generator, most: int
) -> tuple[Floats, Shapes]:
    """At most ``most`` legal proposals (k, 3) for a house, and their footprints (k,)."""
    poses = rng.permutation(propose(problem, turn.seen.standing, turn.house, rng))
    shapes, rings = shapes_at(turn.house, poses)
    good = np.flatnonzero(shapely.contains_xy(problem.floor, rings[..., 0], rings[..., 1]).all(1))
    good = good[shapely.covers(problem.floor, shapes[good])]
    good = good[: 2 * most] if len(turn.taken) else good[:most]
    if len(turn.taken) and len(good):
        hit = shapely.STRtree(turn.taken).query(shapes[good], predicate="intersects")[0]
        good = np.delete(good, np.unique(hit))[:most]
    return poses[good], shapes[good]


def examples_of(
    block: RealBlock, style: VillageStyle, rng: np.random.Generator, choices: int = CHOICES
) -> Iterator[PoseExample]:
    """An example of every house of a block for which some pose is legal."""
    problem = problem_of_block(block, (), style, VillageSettings(GrowSettings(askew=LEARNED)))
    for turn in turns_of(block, rng):
        poses, shapes = legal_proposals(problem, turn, rng, choices - 1)
        if len(poses):
            poses = np.concatenate([turn.pose[None], poses])
            shapes = np.concatenate([np.array([turn.shape], object), shapes])
            yield PoseExample(_lean(tokens_of(turn.seen, turn.house, poses, shapes)))


def _lean(tokens: PoseTokens) -> PoseTokens:
    own, houses, sides = (part.astype(np.float32) for part in tokens[:3])
    return PoseTokens(own, houses, sides, tokens.known)


def pad_examples(
    examples: Sequence[PoseExample], choices: int = CHOICES
) -> tuple[PoseTokens, NDArray[np.bool_]]:
    """Examples (b,) as arrays (b, choices, …), and which choices are there (b, choices)."""
    there = np.zeros((len(examples), choices), bool)
    for k, example in enumerate(examples):
        there[k, : len(example.tokens.own)] = True
    parts = []
    for column in range(4):
        rows = [example.tokens[column] for example in examples]
        whole = np.zeros((len(rows), choices, *rows[0].shape[1:]), rows[0].dtype)
        for k, row in enumerate(rows):
            whole[k, : len(row)] = row
        parts.append(whole)
    return PoseTokens(*parts), there
