"""Results at an address of fsspec (``s3://bucket/set``, ``sftp://…``, ``file:///…``): put there
whole, and looked at again when a batch goes on. Needs the extra ``cluster``."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any

from scenewright.core.errors import InputError
from scenewright.core.extras import install_line

if TYPE_CHECKING:
    from scenewright.batch.ledger import ResultFile

RENAMING = frozenset(("file", "local", "sftp", "ssh", "smb", "hdfs"))
"""Systems of files where a name appears before its content is whole: there it is renamed."""


def open_store(address: str) -> tuple[Any, str]:
    """The file system of an address and the path in it. Raises :class:`InputError` where there is
    none, or a package that it needs is missing."""
    try:
        from fsspec.core import url_to_fs

        system, root = url_to_fs(address)
    except ImportError as error:
        missing = error.name or "fsspec"
        raise InputError(f"--to needs {missing}", install_line(missing), file=address) from None
    except (ValueError, OSError) as error:
        fault = f"is no address that can be written to: {error}"
        raise InputError(fault, "give one such as s3://bucket/set", file=address) from None
    return system, str(root).rstrip("/")


def put_results(address: str, name: str, paths: Iterable[Path]) -> tuple[str, ...]:
    """Put the results of a scene below an address; their addresses. No name appears before its
    content is whole."""
    system, root = open_store(address)
    folder = str(PurePosixPath(root) / PurePosixPath(name).parent)
    named = []
    try:
        system.makedirs(folder, exist_ok=True)
        for path in paths:
            final = f"{folder}/{path.name}"
            _put(system, path, final)
            named.append(str(system.unstrip_protocol(final)))
    except OSError as error:
        fault = f"cannot be written to: {error.strerror or error}"
        raise InputError(fault, "check the address", file=address) from None
    return tuple(named)


def _put(system: Any, path: Path, final: str) -> None:
    kinds = {system.protocol} if isinstance(system.protocol, str) else {*system.protocol}
    if not kinds & RENAMING:
        system.put_file(str(path), final)
        return
    partial = str(PurePosixPath(final).parent / f".scenewright-{secrets.token_hex(8)}")
    try:
        system.put_file(str(path), partial)
        system.mv(partial, final)
    finally:
        if system.exists(partial):
            system.rm(partial)


def whole_at(address: str, folder: Path) -> Callable[[Path, ResultFile], bool]:
    """Whether a result that would be in ``folder`` is at an address with the size it was written
    with; the address is listed once."""
    sizes = _list_sizes(address)

    def is_whole(path: Path, known: ResultFile) -> bool:
        return sizes.get(path.relative_to(folder).as_posix()) == known.size > 0

    return is_whole


def _list_sizes(address: str) -> Mapping[str, int]:
    system, root = open_store(address)
    try:
        system.makedirs(root, exist_ok=True)
        listed = system.find(root, detail=True)
    except Exception as error:  # of whatever package serves the address
        fault = f"cannot be reached: {' '.join(str(error).split())[:200]}"
        raise InputError(fault, "check address and credentials", file=address) from None
    return {str(path)[len(root) + 1 :]: int(row.get("size") or 0) for path, row in listed.items()}
