"""Interface of a running Prolog, independent of its platform."""

from collections.abc import Callable, Generator, Mapping
from enum import Enum
from importlib.resources import files
from pathlib import Path
from typing import Protocol

from ropsim.core import read_bytes

MOST_BYTES = 8 << 20
"""Bytes of a text that is taken over; where the other side counts characters, this number of them."""


class Prolog(Enum):
    """Which SWI-Prolog an engine uses."""

    BUILT_IN = "built-in"
    """The one of the package: inside of this process, shut off from the rest of the machine."""
    NATIVE = "native"
    """The command `swipl` of this machine, as a process of its own: faster, and for trusted texts only."""


class CrashError(Exception):
    """The program has ended in the middle of a call; it is of no use any more."""


class StoppedError(CrashError):
    """The program was ended from outside.

    Attributes:
        why: `time` or `cancelled`, a key of its message.
    """

    why = "time"


class TooLongError(Exception):
    """A text has more bytes than are taken over."""


class Program(Protocol):
    """A Prolog with our sources in it; it belongs to one thread, except for `stop`."""

    @property
    def grace(self) -> float:
        """Time beyond the limit after which a program that did not stop is ended from outside [s]."""

    @property
    def has_ended(self) -> bool:
        """Return whether it is of no use any more."""

    def write(self, path: str, content: bytes) -> None:
        """Write a file into the file system of Prolog."""

    def place(self, path: str) -> str:
        """Return the path under which Prolog sees a written file."""

    def printed(self) -> str:
        """Return the output of Prolog since the last call."""

    def replies(self, name: str, request: str) -> Generator[tuple[str, bool]]:
        """Call one of our predicates; yield the text of each reply, and whether it is the last.

        Closing the generator ends the question. Questions end in the reverse order in which they began.

        Raises:
            CrashError: Prolog has ended; `StoppedError` where `stop` has ended it.
            TooLongError: a reply is longer than allowed.
        """

    def go_on(self, mark: str) -> bool:
        """Go on from where another one was kept under a mark, with the same files.

        Returns:
            whether there is another reply; else nothing has changed.
        """

    def keep(self, mark: str) -> None:
        """Save an image of the program, if possible, for other processes on this machine.

        Args:
            mark: key of its contents and of all requests since its start.
        """

    def limit(self) -> None:
        """Let the next `stop` end anything that runs from now on."""

    def stop(self) -> None:
        """End the present work of Prolog; any thread may call this."""

    def close(self) -> None:
        """End Prolog."""


Start = Callable[[int, Callable[[str], str]], Program]
"""Starts a program with a memory limit in bytes; the function answers calls of Prolog to its host."""


def own_sources(host: str) -> Mapping[str, bytes]:
    """Return our Prolog sources, by file name; `engine.pl` loads the others.

    Args:
        host: file with Prolog's calls to its host.
    """
    folder = files("ropsim.prolog").joinpath("pl")
    names = {"engine.pl": "engine.pl", "reader.pl": "reader.pl", "host.pl": host}
    return {name: read_bytes(Path(str(folder.joinpath(source)))) for name, source in names.items()}
