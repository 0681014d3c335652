"""Whether a block diagram fits an arm: axes, units, and states of its drives."""

from ropsim import blockdiagram as b
from ropsim.dynamics import chain_of
from ropsim.model import JointType, Mechanism

_DRIVE_UNITS = {
    "current": b.Unit.AMPERE,
    "pressure_a": b.Unit.PASCAL,
    "pressure_b": b.Unit.PASCAL,
}
"""Units of states of drives, by their names; those that are not here are not compared."""


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
        for axis, joint in enumerate(robot.axis_joints):
            if signal.size != robot.n:
                break
            table = b.TURNING if joint.measure is JointType.REVOLUTE else b.SLIDING
            needed = table.get(signal.role)
            if signal.role is b.Role.DRIVE_STATE:
                there = [one.name for one in chain_of(robot.drives[axis]).states]
                if signal.channel not in there:
                    has = ", ".join(f"`{one}`" for one in there) or "nothing"
                    drive = f"the drive of joint `{joint.name}`"
                    return f"reads `{signal.channel[:60]}` of {drive}, where {has} can be sensed"
                needed = _DRIVE_UNITS.get(signal.channel)
            if needed is not None and signal.unit(axis) is not needed:
                found = f"has signal `{signal.name[:60]}` in `{signal.unit(axis)}` for joint `{joint.name}`"
                return f"{found}; allowed is `{needed}`"
    return ""
