"""Ctrl-C from the first moment on: one line on the standard error, and the exit code 130.

The handler is installed before anything heavy is imported, so this module imports only what the
interpreter has loaded already. A ``KeyboardInterrupt`` raised while an extension module is being
imported may leave it as another error; then the process ends at once, as there is nothing to tidy
up. Everywhere else it is raised, so that temporary files are removed. What the way out prints
after the one line is not shown, and if something swallows the exception (a callback of a C library
does) the process still ends after :data:`PATIENCE` seconds.
"""

from __future__ import annotations

import os
import time
from _signal import SIG_IGN, SIGINT, signal  # type: ignore[import-not-found]
from _thread import start_new_thread

TYPE_CHECKING = False  # that of typing, whose import takes time
if TYPE_CHECKING:
    from types import FrameType

LINE = b"scenewright: interrupted\n"
CLEAR = b"\r\x1b[2K\x1b[?25h"
"""Clears the line of a progress bar and shows the cursor again."""
CODE = 130
PATIENCE = 5.0
"""Seconds after which an interrupted process ends, whatever holds it."""


def install(handler: object = None) -> None:
    """Let Ctrl-C end this process with one line: at once (:func:`leave`), or by the ``handler``.
    Outside the main thread nothing is changed."""
    try:
        signal(SIGINT, handler or leave)
    except ValueError:
        return


def ignore() -> None:
    """Let Ctrl-C do nothing more: the work is done, and its exit code stands."""
    install(SIG_IGN)


def leave(number: int, frame: FrameType | None) -> None:
    """A handler: tell it and end at once."""
    del number, frame
    _tell()
    os._exit(CODE)


def interrupt(number: int, frame: FrameType | None) -> None:
    """A handler: tell it and raise ``KeyboardInterrupt``, but not out of an import; further
    signals are ignored."""
    ignore()
    if _is_importing(frame):
        leave(number, frame)
    _tell()
    start_new_thread(_end_late, ())
    raise KeyboardInterrupt


def _tell() -> None:
    """Write the line, and let nothing else follow it on the standard error."""
    try:
        os.write(2, CLEAR + LINE if os.isatty(2) else LINE)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    except OSError:  # nobody listens
        return


def _is_importing(frame: FrameType | None) -> bool:
    """Whether a module is being imported in some frame of the stack."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _end_late() -> None:
    time.sleep(PATIENCE)
    os._exit(CODE)
