"""The steps of a program in order, of which some are known before they are due."""

from collections import deque
from collections.abc import Callable
from typing import TypeAlias

from ropsim.flow import Instruction
from ropsim.icr import Finished

Step: TypeAlias = Instruction | Finished


class Steps:
    """Steps of a program.

    Reading steps ahead lets the interpreter run to them; so a caller must not read behind a step that
    requires earlier ones to be executed, such as reading an input: `ropsim.icr.Machine.advance`.

    Args:
        advance: lets the interpreter run to its next step.
    """

    def __init__(self, advance: Callable[[], Step]) -> None:
        self._advance = advance
        self._known: deque[Step] = deque()

    def take(self) -> Step:
        """Return the next step."""
        return self._known.popleft() if self._known else self._advance()

    def ahead(self, number: int) -> Step:
        """Return the step behind a number of first ones, which all stay to be taken."""
        while len(self._known) <= number:
            self._known.append(self._advance())
        return self._known[number]
