"""What lies outside the machine: inputs and time."""

from collections.abc import Mapping
from typing import Protocol

from ropsim.flow import Instruction, ModalState, MoveInstruction, OutputInstruction, WaitInstruction
from ropsim.spatial import Pose


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

    def met(self) -> bool:
        """Return whether the condition of the guarded move that was carried out last ended it; else False."""
        ...

    def attained(self, modal: ModalState) -> Pose | None:
        """Return the pose X_KT that the tool of a modal state has in its task frame; None if not known.

        Where a condition has ended the move that was carried out last, it is that at which it came true.
        """
        ...


class StillWorld:
    """A world without a robot: inputs never change, and time passes only by waiting.

    Args:
        inputs: channel -> value; all others are FALSE or 0.
    """

    def __init__(self, inputs: Mapping[str, bool | int | float] | None = None) -> None:
        self._channels = dict(inputs or {})
        self._time = 0.0
        self._met = False
        self._reached: MoveInstruction | None = None

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

    def met(self) -> bool:
        """Return whether the condition of the last guarded move held when it was carried out."""
        return self._met

    def attained(self, modal: ModalState) -> Pose | None:
        """Return the target of the last move, as if all guarded moves ended there; None where it is no pose.

        None also for another tool than that of the move.
        """
        move = self._reached
        if move is None or not isinstance(move.target, Pose) or move.angle is not None:
            return None
        if (move.modal.tool, move.modal.X_MT) != (modal.tool, modal.X_MT):
            return None
        if (move.modal.frame, move.modal.X_BK) == (modal.frame, modal.X_BK):
            return move.target
        return modal.X_BK.inverse() @ move.modal.X_BK @ move.target

    def carry_out(self, instruction: Instruction) -> None:
        """Set outputs, or let the duration of a wait pass; everything else takes no time here."""
        if isinstance(instruction, OutputInstruction):
            self._channels[instruction.channel] = instruction.value
        elif isinstance(instruction, MoveInstruction):
            for trigger in instruction.triggers:
                self._channels[trigger.channel] = trigger.value
            self._reached = instruction
            if instruction.guard is not None:
                self._met = instruction.guard.holds(self.read(instruction.guard.channel))
        elif isinstance(instruction, WaitInstruction):
            self._time += instruction.duration


class PassingWorld(StillWorld):
    """A still world in which what is waited for comes."""

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:  # noqa: FBT001 - a signal level
        """Return True."""
        del channel, value, timeout
        return True
