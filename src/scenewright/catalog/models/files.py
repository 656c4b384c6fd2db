"""Files beside a model, read without trusting the names the model gives them.

A name must lead to a plain file in the model's own folder or below; names that lead elsewhere
(``..``, absolute ones, other schemes, symbolic links out of the folder) are refused.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from pathlib import Path, PurePosixPath
from typing import Any

from scenewright.core.document_faults import check_characters
from scenewright.core.errors import InputError
from scenewright.core.stored_file import read_plain

MEBIBYTE = 2**20
COST = {b"[": 90, b"{": 240, b",": 64, b":": 120}
"""Bytes that what a sign of JSON stands for takes at most once parsed (CPython, 64 bits)."""
MOST_PARSED = 350 * MEBIBYTE
"""Bytes a JSON document may take once parsed."""

Beside = Callable[[str, int], bytes | None]
"""The bytes of a file named relative to the model's folder, up to a limit; None if missing."""


def within(name: str) -> str:
    """The name in normal form if it stays in the folder it starts from; InputError otherwise.

    >>> within("textures\\\\./wall.png")
    'textures/wall.png'
    >>> within("../wall.png")
    Traceback (most recent call last):
    scenewright.core.errors.InputError: refers to '../wall.png', outside its folder; keep the files of a model in one folder and name them from there
    """  # noqa: E501
    plain = name.strip().replace("\\", "/")
    steps = [step for step in plain.split("/") if step not in ("", ".")]
    leads_out = plain.startswith("/") or ".." in steps or re.match(r"[A-Za-z][\w+.-]*:", plain)
    if leads_out or not steps or not plain.isprintable() or len(plain) > 400:
        shown = "".join(sign if " " <= sign <= "~" else "?" for sign in name[:60])
        raise InputError(
            f"refers to '{shown}', outside its folder",
            "keep the files of a model in one folder and name them from there",
        )
    return str(PurePosixPath(*steps))


def beside(folder: Path) -> Beside:
    """Reads files of a folder and those below it."""
    top = Path(os.path.realpath(folder))

    def read(name: str, limit: int) -> bytes | None:
        path = top / within(name)
        try:
            if not Path(os.path.realpath(path)).is_relative_to(top):
                raise InputError("is a link out of the model's folder", "put the file there")
            return whole(path, limit) if path.is_file() else None
        except InputError as error:
            raise InputError(error.fault, error.remedy, place=error.place or name[:60]) from None
        except (OSError, ValueError):
            return None

    return read


def whole(path: Path, limit: int) -> bytes:
    """The bytes of a plain file of at most ``limit`` bytes."""
    return check_size(read_plain(path, limit), limit)


def check_size(content: bytes, limit: int) -> bytes:
    """The bytes, if they are neither too many nor none."""
    if len(content) > limit:
        raise InputError(f"is larger than {limit / MEBIBYTE:g} MiB", "simplify or split it")
    if not content:
        raise InputError("is empty", "save it again")
    return content


def json_of(content: bytes, what: str) -> dict[str, Any]:
    """The object a JSON document holds; its values are counted before it is parsed.

    >>> json_of(b'{"asset": [NaN]}', "glTF")
    Traceback (most recent call last):
    scenewright.core.errors.InputError: is not glTF: NaN is not valid JSON; save it again
    """
    check_json(content)
    try:
        text = content.decode("utf-8-sig")
        found = json.loads(text, parse_constant=_no_number)
    except RecursionError:
        raise InputError("is nested too deeply", "save it again") from None
    except ValueError as error:
        reason = " ".join(str(error).split())[:100]
        raise InputError(f"is not {what}: {reason}", "save it again") from None
    if not isinstance(found, dict):
        raise InputError(f"is not {what}: it holds no object", "save it again")
    check_characters(found, text)
    return found


def check_json(content: bytes, most: int = MOST_PARSED) -> None:
    """InputError if the values of a JSON document would take more memory than ``most`` bytes: known
    by its signs, before it is parsed.

    >>> check_json(b'{"rooms": [[0, 1], [2, 3]]}', 1000)
    >>> check_json(b"[" + b"{}," * 100 + b"{}]", 1000)
    Traceback (most recent call last):
    scenewright.core.errors.InputError: holds 202 values, more than can be held; split it into several files
    """  # noqa: E501
    counts = {sign: content.count(sign) for sign in COST}
    if sum(COST[sign] * count for sign, count in counts.items()) + 2 * len(content) > most:
        values = sum(counts.values()) - counts[b":"]
        raise InputError(
            f"holds {values:,} values, more than can be held", "split it into several files"
        )


def _no_number(word: str) -> Any:
    raise ValueError(f"{word} is not valid JSON")
