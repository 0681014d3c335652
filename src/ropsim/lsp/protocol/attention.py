"""Cancellation of long work: the computation for a text ends when the editor has sent a newer one."""

from collections.abc import Callable, Mapping

from ropsim.flow import Instruction
from ropsim.icr import Arm, PassingWorld


class SupersededError(Exception):
    """A newer text waits to be processed."""


def nobody_calls() -> bool:
    """Return False."""
    return False


class Attention:
    """Checks whether a more urgent message waits.

    Attributes:
        is_called: returns whether a message waits.
    """

    __slots__ = ("is_called",)

    def __init__(self) -> None:
        self.is_called: Callable[[], bool] = nobody_calls

    def check(self) -> None:
        """Check for a waiting message.

        Raises:
            SupersededError: a newer text waits.
        """
        if self.is_called():
            raise SupersededError

    def world(
        self, inputs: Mapping[str, bool | int | float] | None = None, arm: Arm | None = None
    ) -> "AttentiveWorld":
        """Return a world for a dry run that can be cancelled; see `PassingWorld`."""
        return AttentiveWorld(self, inputs, arm)


class AttentiveWorld(PassingWorld):
    """A world in which a dry run checks for messages at each of its robot instructions.

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
        """Check for messages, then act as a world at rest.

        Raises:
            SupersededError: a newer text waits.
        """
        self._attention.check()
        super().carry_out(instruction)
