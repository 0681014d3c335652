"""What is fuzzed: how an input is made, and what must hold when it is read."""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

Take = Callable[[bytes], str]
"""Read an input and return how it was answered: `read`, or a diagnostic code. Raises where that is wrong."""


@dataclass(frozen=True, slots=True)
class Target:
    """A reader of bytes from somewhere else.

    Attributes:
        name: such as `ply`.
        make: an input from numbers of a generator; the same numbers give the same input.
        take: read it.
    """

    name: str
    make: Callable[[Random], bytes]
    take: Take

    def case(self, seed: int, number: int) -> bytes:
        """Return an input by its number, whatever was made before."""
        return self.make(Random(f"{seed}/{self.name}/{number}"))
