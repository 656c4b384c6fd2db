"""What ends a command early, as one line on the standard error and an exit code."""

from __future__ import annotations

import errno
import os
import re
import sys
from typing import Any

from scenewright.text import printable

FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)
"""How the system says that a place takes no more."""


def write_fault(message: str, code: int = 2) -> int:
    """Write the line; the exit code."""
    sys.stderr.write(f"scenewright: {printable(message)}\n")
    return code


def describe_usage_fault(usage_fault: Any) -> str:
    """The fault of the parser in our words; empty if the help was shown instead."""
    message = str(usage_fault.format_message()).rstrip(".")
    message = re.sub(r"Input should be a valid integer.*", "give a whole number", message)
    message = re.sub(r"Input should be a valid number.*", "give a number", message)
    message = message.replace("Input should be greater than or equal to", "give at least")
    return message.replace("Input should be less than or equal to", "give at most")


def is_output_full(error: Exception) -> bool:
    """Whether what is printed cannot be taken: a full disk, not a file that a command names.

    >>> is_output_full(OSError(errno.ENOSPC, "No space left on device"))
    True
    >>> is_output_full(OSError(errno.ENOSPC, "No space left on device", "plan.svg"))
    False
    """
    return isinstance(error, OSError) and error.errno in FULL and error.filename is None


def drop_output() -> None:
    """Nobody can take what is still to be printed: it is not tried again at the end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
