"""Edits by hand as the command line writes them: names, places, sizes, pairs."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, pi, radians

from scenewright.core.edits import Addition
from scenewright.core.errors import InputError

RADIANS_MEANT = 0.003
"""A heading so near to eighths of a turn in radians, 1.57 as well as 1.5708, is not in degrees."""
PLACE = "give PIECE=X,Y or PIECE=X,Y,DEGREES, as bed=1.2,3.4,90"


def read_pose(argument: str, option: str = "--move") -> tuple[str, tuple[float, ...]]:
    """``bed=1.2,3.4,90`` as a name and a pose in metres and radians.

    >>> read_pose("bed=1.2,3.4")
    ('bed', (1.2, 3.4))
    """
    name, numbers = _split_numbers(argument)
    if not name or len(numbers) not in (2, 3):
        raise InputError(f"{option} {argument} is not a place", PLACE)
    for angle in numbers[2:]:
        _check_degrees(angle, f"{option} {argument}")
    return name, (*numbers[:2], *(radians(angle) for angle in numbers[2:]))


def read_addition(argument: str) -> Addition:
    """``armchair=1.2,3.4`` as a model to be put in.

    >>> read_addition("armchair=1.2,3.4")
    Addition(asset='armchair', x=1.2, y=3.4, heading=None, space='')
    """
    name, (x, y, *heading) = read_pose(argument, "--add")
    return Addition(name, x, y, heading[0] if heading else None)


def read_size(argument: str) -> tuple[str, tuple[float, ...]]:
    """``desk=1.6,0.8,0.75`` as a name and width, depth and height in metres.

    >>> read_size("desk=1.6,0.8,0.75")
    ('desk', (1.6, 0.8, 0.75))
    """
    name, numbers = _split_numbers(argument)
    if not name or len(numbers) != 3 or min(numbers) <= 0:
        raise InputError(
            f"--resize {argument} is not a size", "give PIECE=WIDTH,DEPTH,HEIGHT in metres"
        )
    return name, numbers


def read_word(argument: str, option: str, example: str) -> tuple[str, str]:
    """``sofa=corner sofa`` as a name and what it is to become.

    >>> read_word("sofa=corner sofa", "--exchange", "")
    ('sofa', 'corner sofa')
    """
    name, _, other = (part.strip() for part in argument.partition("="))
    if not name or not other:
        raise InputError(f"{option} {argument} lacks a half", f"give {example}")
    return name, other


def read_pair(argument: str) -> tuple[str, str]:
    """``sofa,tv`` as two names.

    >>> read_pair("sofa, tv")
    ('sofa', 'tv')
    """
    names = [part.strip() for part in argument.split(",")]
    if len(names) != 2 or not all(names):
        raise InputError(f"--swap {argument} is not a pair", "give two pieces, as sofa,tv")
    return names[0], names[1]


def check_locks(lock: Sequence[str], unlock: Sequence[str]) -> None:
    """InputError for what is to be locked and released at once."""
    both = sorted(set(lock) & set(unlock))
    if both:
        raise InputError(f"{both[0]} is to be locked and released", "leave out one of the two")


def _split_numbers(argument: str) -> tuple[str, tuple[float, ...]]:
    """A name and the numbers after it; none if one of them is no number."""
    name, _, rest = argument.partition("=")
    try:
        numbers = tuple(float(part) for part in rest.split(","))
    except ValueError:
        numbers = ()
    return name.strip(), numbers if all(map(isfinite, numbers)) else ()


def _check_degrees(angle: float, given: str) -> None:
    """InputError for what is no angle in degrees: beyond a full turn, or an eighth of a turn or
    several written in radians.

    >>> _check_degrees(90.0, "--move bed=1,2,90"), _check_degrees(1.5, "--move bed=1,2,1.5")
    (None, None)
    """
    if abs(angle) > 360:
        raise InputError(f"{given}: {angle:g} is no heading", "give degrees, -360 to 360")
    eighths = round(angle / (pi / 4))
    if eighths and abs(eighths) <= 8 and abs(angle - eighths * pi / 4) < RADIANS_MEANT:
        raise InputError(
            f"{given}: the heading seems to be in radians", f"give degrees: {45 * eighths}"
        )
