"""Line input: with history and completion on a capable terminal, plain from a pipe."""

import contextlib
import sys
from collections.abc import Callable
from pathlib import Path

from ropsim.core import state_folder
from ropsim.lsp import Workshop, offered

LONGEST_LINE = 1_000_000
"""Characters that are read of a line; an endless one ends there."""
LONGEST_HISTORY = 1000
"""Lines that are kept between two sessions."""


class LineEditor:
    """Reads lines from standard input.

    Args:
        text: returns the text that the next line continues, for completion.
        place: file that the text would have; the project around it supplies names.

    Attributes:
        is_typed: whether a user types, on a terminal.
    """

    def __init__(self, text: Callable[[], str], place: Path) -> None:
        self._text = text
        self._place = place
        self._workshop = Workshop()
        self._found: tuple[str, ...] = ()
        self._words: Callable[[str], tuple[str, ...]] = _no_words
        self.is_typed = sys.stdin.isatty() and sys.stdout.isatty()
        if self.is_typed:
            self._prepare()

    def line(self, prompt: str, words: Callable[[str], tuple[str, ...]] | None = None) -> str | None:
        """Return the next line, None at the end of the input.

        Args:
            prompt: stands before it.
            words: returns further completions of the present input, in addition to those of the text.
        """
        self._words = words or _no_words
        try:
            if self.is_typed:
                return input(prompt)
            line = sys.stdin.readline(LONGEST_LINE)
        except (EOFError, UnicodeDecodeError):
            return None
        return line.rstrip("\r\n") if line else None

    def keep_history(self) -> None:
        """Keep the input for the next session, if possible."""
        if self.is_typed:
            with contextlib.suppress(ImportError, OSError):
                import readline

                path = _history()
                path.parent.mkdir(parents=True, exist_ok=True)
                readline.set_history_length(LONGEST_HISTORY)
                readline.write_history_file(path)

    def offered(self, line: str) -> tuple[str, ...]:
        """Return the completions at the end of a line that begin like its last word."""
        found = offered(self._text(), line, self._place, self._workshop)
        return tuple(sorted({*self._words(line), *found}))

    def _prepare(self) -> None:
        try:
            import readline
        except ImportError:  # Windows has no `readline`; input works without it
            return
        readline.set_completer(self._complete)
        readline.parse_and_bind("tab: complete")
        with contextlib.suppress(OSError):
            readline.read_history_file(_history())

    def _complete(self, word: str, number: int) -> str | None:
        import readline

        if number == 0:
            self._found = self.offered(readline.get_line_buffer()[: readline.get_endidx()])
        del word
        return self._found[number] if number < len(self._found) else None


def _no_words(line: str) -> tuple[str, ...]:
    del line
    return ()


def _history() -> Path:
    return state_folder() / "repl_history"
