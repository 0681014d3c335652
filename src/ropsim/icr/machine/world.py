"""Surroundings of the machine: inputs and time."""

from collections.abc import Mapping
from typing import Protocol, TypeAlias

from ropsim.flow import Instruction, ModalState, MoveInstruction, OutputInstruction, WaitInstruction
from ropsim.spatial import Pose

Target: TypeAlias = Pose | tuple[float, ...] | None
"""A pose X_KT, joint coordinates [rad | m], or None for the home position: that of a `MoveInstruction`."""


class World(Protocol):
    """Queries of the machine, answered after the consumer has executed everything before."""

    def read(self, channel: str) -> bool | int | float:
        """Return the present value of a channel."""
        ...

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:  # noqa: FBT001 - a signal level
        """Return whether a channel came to have a value; False where `timeout` [s] came first.

        The consumer has executed the preceding `AwaitInstruction`. With timeout None, False means that the
        value will never come.
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

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        """Return where a move leads, X_KT; None where it is known only when the arm stands there.

        May be called before the move has been carried out.

        Args:
            target: of the move.
            then: its modal state.
            now: with the tool and the task frame of the pose.
        """
        ...

    def commanded(self, modal: ModalState) -> Pose | None:
        """Return the pose X_KT of the tool of a modal state at which the arm stands by command.

        It differs from `attained` by the error of the drives, and where a condition has ended a move by the
        distance of braking. None if it is not known.
        """
        ...


class Arm(Protocol):
    """The robot of a still world, which stands exactly where its moves lead. Immutable."""

    def after(self, move: MoveInstruction) -> "Arm":
        """Return the arm behind one more move."""
        ...

    def standing(self, modal: ModalState) -> Pose | None:
        """Return the pose X_KT of the tool of a modal state at which the arm stands; None if not known."""
        ...

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        """Return where a move leads; see `World.reached`."""
        ...


class UnknownArm:
    """An arm of which nothing is known: only pose targets determine its pose.

    Args:
        last: the last move; None at the start.
    """

    def __init__(self, last: MoveInstruction | None = None) -> None:
        self._last = last

    def after(self, move: MoveInstruction) -> "UnknownArm":
        """Return the arm behind one more move."""
        return UnknownArm(move)

    def standing(self, modal: ModalState) -> Pose | None:
        """Return the target of the last move; None for a target that is no pose."""
        last = self._last
        if last is None or last.angle is not None:
            return None
        return self.reached(last.target, last.modal, modal)

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        """Return a pose by the frames and tools of the program; None for joint coordinates and home.

        None also for another tool whose pose only the cell has.
        """
        if not isinstance(target, Pose):
            return None
        if (then.frame, then.X_BK) != (now.frame, now.X_BK):
            target = now.X_BK.inverse() @ (then.X_BK @ target)
        if (then.tool, then.X_MT) == (now.tool, now.X_MT):
            return target
        if then.X_MT is None or now.X_MT is None:
            return None
        return target @ then.X_MT.inverse() @ now.X_MT


class StillWorld:
    """A world in which inputs never change, and time passes only by waiting.

    Args:
        inputs: channel -> value; all others are FALSE or 0.
        arm: the robot at the start; None for one of which nothing is known.
    """

    def __init__(
        self, inputs: Mapping[str, bool | int | float] | None = None, arm: Arm | None = None
    ) -> None:
        self._channels = dict(inputs or {})
        self._arm: Arm = UnknownArm() if arm is None else arm
        self._time = 0.0
        self._met = False

    def read(self, channel: str) -> bool | int | float:
        """Return the value given for a channel, or the value set by the program."""
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
        """Return where the arm stands, as if all guarded moves ended at their targets; None if not known."""
        return self._arm.standing(modal)

    def commanded(self, modal: ModalState) -> Pose | None:
        """Return the same: the arm stands exactly where it is commanded to."""
        return self._arm.standing(modal)

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        """Return the target pose of a move, if the arm determines it."""
        return self._arm.reached(target, then, now)

    def carry_out(self, instruction: Instruction) -> None:
        """Set outputs, or let the duration of a wait pass; everything else takes no time here."""
        if isinstance(instruction, OutputInstruction):
            self._channels[instruction.channel] = instruction.value
        elif isinstance(instruction, MoveInstruction):
            for trigger in instruction.triggers:
                self._channels[trigger.channel] = trigger.value
            self._arm = self._arm.after(instruction)
            if instruction.guard is not None:
                self._met = instruction.guard.holds(self.read(instruction.guard.channel))
        elif isinstance(instruction, WaitInstruction):
            self._time += instruction.duration


class PassingWorld(StillWorld):
    """A still world in which every wait ends."""

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:  # noqa: FBT001 - a signal level
        """Return True."""
        del channel, value, timeout
        return True
