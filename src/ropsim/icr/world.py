"""What lies outside the machine: inputs and time."""

from collections.abc import Mapping
from typing import Protocol

from ropsim.flow import Instruction, MoveInstruction, OutputInstruction, WaitInstruction


class World(Protocol):
    """What the machine asks after the consumer has carried out everything before."""

    def read(self, channel: str) -> bool | int | float:
        """Return the present value of a channel."""
        ...

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:  # noqa: FBT001 - a signal level
        """Return whether a channel came to have a value; False where `timeout` [s] came first.

        Whoever carries out the instructions has carried out the `AwaitInstruction` before. With timeout None,
        False means that the value will never come.
        """
        ...

    def time(self) -> float:
        """Return the time since the start [s]."""
        ...


class StillWorld:
    """A world without a robot: inputs never change, and time passes only by waiting.

    Args:
        inputs: channel -> value; all others are FALSE or 0.
    """

    def __init__(self, inputs: Mapping[str, bool | int | float] | None = None) -> None:
        self._channels = dict(inputs or {})
        self._time = 0.0

    def read(self, channel: str) -> bool | int | float:
        """Return the value given for a channel, or what the program has set it to."""
        return self._channels.get(channel, 0)

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:  # noqa: FBT001 - a signal level
        """Return at once where the input has the value; else let the timeout pass."""
        if bool(self.read(channel)) is value:
            return True
        self._time += timeout or 0.0
        return False

    def time(self) -> float:
        """Return the time waited so far [s]."""
        return self._time

    def carry_out(self, instruction: Instruction) -> None:
        """Set outputs, or let the duration of a wait pass; everything else takes no time here."""
        if isinstance(instruction, OutputInstruction):
            self._channels[instruction.channel] = instruction.value
        elif isinstance(instruction, MoveInstruction):
            for trigger in instruction.triggers:
                self._channels[trigger.channel] = trigger.value
        elif isinstance(instruction, WaitInstruction):
            self._time += instruction.duration
