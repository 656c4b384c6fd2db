"""Consoles that print text from outside without obeying it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import IO

from rich.console import Console, ConsoleOptions, ConsoleRenderable, RenderHook, RenderResult
from rich.segment import Segment
from rich.text import Text

from scenewright.text import printable, printable_lines


def console(
    *,
    stderr: bool = False,
    quiet: bool = False,
    width: int | None = None,
    height: int | None = None,
    file: IO[str] | None = None,
) -> Console:
    """A console whose every line is harmless to the terminal, whatever is printed on it.

    Control, escape and bidirectional characters are replaced, in tables as in lines; a line of
    text stays on one line. Styles are as ever. The message of a progress bar is to be made
    :func:`~scenewright.text.printable` by who sets it.

    >>> console(width=40).print("sofa\\x1b[2J", markup=False)
    sofa\ufffd[2J
    """
    made = Console(stderr=stderr, quiet=quiet, width=width, height=height, file=file)
    made.push_render_hook(_Harmless())
    return made


class _Harmless(RenderHook):
    """Wraps what is printed."""

    def process_renderables(self, renderables: list[ConsoleRenderable]) -> list[ConsoleRenderable]:
        """The text printed instead."""
        return [_Wrapped(inner) for inner in renderables]


@dataclass(frozen=True)
class _Wrapped:
    """Renders as what it holds, without what a terminal would obey."""

    inner: ConsoleRenderable

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        inner = _on_one_line(self.inner) if isinstance(self.inner, Text) else self.inner
        for segment in console.render(inner, options):
            text, style, control = segment
            yield segment if control else Segment(printable_lines(text), style)


def _on_one_line(text: Text) -> Text:
    """A text without line feeds; the blanks it begins with stay."""
    indent = len(text.plain) - len(text.plain.lstrip(" "))
    line = " " * indent + printable(text.plain)
    if line == text.plain:
        return text
    return Text(line, style=text.style, end=text.end, no_wrap=text.no_wrap, overflow=text.overflow)
