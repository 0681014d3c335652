"""What a Prolog that runs has to do, whatever it runs on."""

from collections.abc import Callable, Generator, Mapping
from enum import Enum
from importlib.resources import files
from pathlib import Path
from typing import Protocol

from ropsim.core import read_bytes

MOST_BYTES = 8 << 20
"""Bytes of a text that is taken over; where the other side counts characters, so many of these."""


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
        why: `time` or `cancelled`, a key of what is said about it.
    """

    why = "time"


class TooLongError(Exception):
    """A text has more bytes than are taken over."""


class Program(Protocol):
    """A Prolog with our sources in it; it belongs to one thread, except for `stop`."""

    @property
    def grace(self) -> float:
        """After so much time over its limit it is stopped from outside, where it did not stop itself [s]."""

    @property
    def has_ended(self) -> bool:
        """Return whether it is of no use any more."""

    def write(self, path: str, content: bytes) -> None:
        """Put a file among those that Prolog sees."""

    def place(self, path: str) -> str:
        """Return by what name Prolog sees a file that was written."""

    def printed(self) -> str:
        """Return what Prolog has printed since the last time."""

    def replies(self, name: str, request: str) -> Generator[tuple[str, bool]]:
        """Ask one of our predicates; yield the text of each reply, and whether it is the last.

        Closing the generator ends the question. Questions end in the reverse order in which they began.

        Raises:
            CrashError: Prolog has ended; `StoppedError` where `stop` has ended it.
            TooLongError: a reply is longer than allowed.
        """

    def go_on(self, mark: str) -> bool:
        """Go on from where another one was kept under a mark, with the same files.

        Returns:
            whether there is such a one; else nothing has changed.
        """

    def keep(self, mark: str) -> None:
        """Keep the program as it is now, where that can be, for others of this machine.

        Args:
            mark: tells what it was given and asked since it has started.
        """

    def limit(self) -> None:
        """Let the next `stop` end what runs from now on."""

    def stop(self) -> None:
        """End what Prolog does now; any thread may call this."""

    def close(self) -> None:
        """End Prolog."""


Start = Callable[[int, Callable[[str], str]], Program]
"""Starts a program with so many bytes of memory; what Prolog asks of its host is answered by the function."""


def own_sources(host: str) -> Mapping[str, bytes]:
    """Return what of Prolog is ours, by file name; `engine.pl` loads the others.

    Args:
        host: file by which Prolog asks its host.
    """
    folder = files("ropsim.prolog").joinpath("pl")
    names = {"engine.pl": "engine.pl", "reader.pl": "reader.pl", "host.pl": host}
    return {name: read_bytes(Path(str(folder.joinpath(source)))) for name, source in names.items()}
