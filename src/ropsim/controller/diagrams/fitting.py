"""Whether a block diagram fits an arm: axes, units, and states of its drives."""

from ropsim import blockdiagram as b
from ropsim.dynamics import chain_of
from ropsim.model import Joint, JointType, Mechanism

_DRIVE_UNITS = {
    "current": b.Unit.AMPERE,
    "pressure_a": b.Unit.PASCAL,
    "pressure_b": b.Unit.PASCAL,
}
"""Units of states of drives, by their names; other states are not compared."""


def check_fit(diagram: b.Diagram, robot: Mechanism) -> None:
    """Make sure that a diagram without faults fits an arm.

    Raises:
        DiagramError: C626, it does not.
    """
    misfit = _misfit(diagram, robot)
    if misfit:
        message = f"controller `{diagram.name[:60]}` {misfit}"
        hint = "see docs/reference/controller-file.md"
        raise b.DiagramError(b.DOES_NOT_FIT.at(None, message, hint=hint))


def _misfit(diagram: b.Diagram, robot: Mechanism) -> str:
    if diagram.axes != robot.n:
        return f"is for {diagram.axes} axes, `{robot.name}` has {robot.n}"
    if diagram.arm and diagram.arm != robot.name:
        return f"is for the arm `{diagram.arm[:60]}`, this one is `{robot.name}`"
    for signal in diagram.signals:
        if signal.role is b.Role.DRIVE_STATE:
            found = _unsensed(diagram, signal, robot)
        elif signal.role in b.TURNING:
            found = _other_unit(signal, robot)
        else:
            found = ""
        if found:
            return found
    return ""


def _other_unit(signal: b.Signal, robot: Mechanism) -> str:
    for axis, joint in enumerate(robot.axis_joints):
        table = b.TURNING if joint.measure is JointType.REVOLUTE else b.SLIDING
        if signal.unit(axis) is not table[signal.role]:
            return _wrong_unit(signal, axis, joint, table[signal.role])
    return ""


def _unsensed(diagram: b.Diagram, signal: b.Signal, robot: Mechanism) -> str:
    for axis in sorted(_read(diagram, signal)):
        joint = robot.axis_joints[axis]
        there = [one.name for one in chain_of(robot.drives[axis]).states]
        if signal.channel not in there:
            has = ", ".join(f"`{one}`" for one in there) or "nothing"
            return (
                f"reads `{signal.channel[:60]}` of the drive of joint `{joint.name}`, "
                f"where {has} can be sensed"
            )
        needed = _DRIVE_UNITS.get(signal.channel)
        if needed is not None and signal.unit(axis) is not needed:
            return _wrong_unit(signal, axis, joint, needed)
    return ""


def _read(diagram: b.Diagram, signal: b.Signal) -> set[int]:
    """Return the elements of a signal that blocks and links take."""
    if any(signal.name in one.inputs for one in diagram.blocks):
        return set(range(signal.size))
    links = [one for one in diagram.links if one.source == signal.name]
    return {one.source_first + k for one in links for k in range(one.count)}


def _wrong_unit(signal: b.Signal, axis: int, joint: Joint, allowed: b.Unit) -> str:
    found = f"has signal `{signal.name[:60]}` in `{signal.unit(axis)}` for joint `{joint.name}`"
    return f"{found}; allowed is `{allowed}`"
