"""Something that is written, and what must hold however far it came."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path


class Progress(Enum):
    """How far a job came before it was killed, as far as it could tell."""

    BEGUN = "begun"
    PROMISED = "promised"
    DONE = "done"


Tell = Callable[[Progress], None]


@dataclass(frozen=True, slots=True)
class Job:
    """A job that writes files.

    Attributes:
        name: such as `save`.
        prepare: make what is there before; in a folder of its own.
        act: write; tells when it has promised something, such as that a text is kept.
        check: the next start; raises where something is lost, half-written, or where it does not work.
    """

    name: str
    prepare: Callable[[Path], None]
    act: Callable[[Path, Tell], None]
    check: Callable[[Path, Progress], None]
