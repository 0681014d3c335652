"""Long work gives way: what is worked out for a text ends where the editor has sent a newer one meanwhile."""

from collections.abc import Callable, Mapping

from ropsim.flow import Instruction
from ropsim.icr import Arm, PassingWorld


class SupersededError(Exception):
    """A newer text waits to be looked at."""


def nobody_calls() -> bool:
    """Return False."""
    return False


class Attention:
    """Looks whether something waits that is more urgent than what is being done.

    Attributes:
        is_called: tells whether it does.
    """

    __slots__ = ("is_called",)

    def __init__(self) -> None:
        self.is_called: Callable[[], bool] = nobody_calls

    def look(self) -> None:
        """Look up from the work.

        Raises:
            SupersededError: a newer text waits.
        """
        if self.is_called():
            raise SupersededError

    def world(
        self, inputs: Mapping[str, bool | int | float] | None = None, arm: Arm | None = None
    ) -> "AttentiveWorld":
        """Return a world for a dry run that gives way; see `PassingWorld`."""
        return AttentiveWorld(self, inputs, arm)


class AttentiveWorld(PassingWorld):
    """A world in which a dry run looks up at each of its robot instructions.

    Args:
        attention: looks.
        inputs: channel -> value; all others are FALSE or 0.
        arm: the robot at the start; None for one of which nothing is known.
    """

    def __init__(
        self,
        attention: Attention,
        inputs: Mapping[str, bool | int | float] | None = None,
        arm: Arm | None = None,
    ) -> None:
        super().__init__(inputs, arm)
        self._attention = attention

    def carry_out(self, instruction: Instruction) -> None:
        """Look up, then do what a still world does.

        Raises:
            SupersededError: a newer text waits.
        """
        self._attention.look()
        super().carry_out(instruction)
