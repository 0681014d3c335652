"""The pose commanded last: computed if the program determines it, else read from the robot."""

import math
from dataclasses import replace

from ropsim.flow import Instruction
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.location import Location, external_part, located, pose_part, posture_of, tag_of
from ropsim.icr.machine.site import Site, barrier
from ropsim.icr.machine.state import Commanded, CommandedJoints, Registers
from ropsim.icr.machine.traps import TrapError, out_of_range
from ropsim.icr.machine.world import World
from ropsim.spatial import Pose


def command_pose(registers: Registers, world: World, site: Site) -> Instruction | None:
    """Push the pose commanded last, X_KT, in the frame and for the tool in force.

    If the target of the last move determines the pose, the program continues at once. Else it waits until
    everything before has been executed, and takes the command pose of the arm.

    Raises:
        TrapError: the world has no arm, or lacks the tool in force; or numbers are not finite.
    """
    location = None if registers.is_synced else _known(registers, world)
    if location is None:
        if (sync := barrier(registers, site)) is not None:
            return sync
        X_KT = world.commanded(registers.modal)
        if X_KT is None:
            raise TrapError(kinds.POSE_UNKNOWN, "where the arm stands is not known", _UNKNOWN)
        location = X_KT.as_tuple()
        registers.commanded = Commanded(location, registers.modal)
    if not all(map(math.isfinite, pose_part(location))):
        raise out_of_range("the result of `CURPOSE` is not finite")
    registers.stack.append(location)
    return None


def _known(registers: Registers, world: World) -> Location | None:
    """Return the target of the last move in frame and tool in force; None if it determines no pose.

    Values of external axes given with the target stay with the pose: the axes are still there. A location in
    a task frame of its own is still in that.
    """
    if registers.commanded is None:
        return None
    then, now = registers.commanded.modal, registers.modal
    if isinstance(registers.commanded, CommandedJoints):
        X_KT = world.reached(registers.commanded.joints, then, now)
        return None if X_KT is None else X_KT.as_tuple()
    target = registers.commanded.target
    pose = pose_part(target)
    if (tag := tag_of(target)) is not None:
        then, now = (replace(one, frame=tag.name, X_BK=tag.X_BK) for one in (then, now))
    if (then.frame, then.X_BK, then.tool, then.X_MT) != (now.frame, now.X_BK, now.tool, now.X_MT):
        X_KT = world.reached(Pose.from_tuple(pose), then, now)
        if X_KT is None:
            return None
        pose = X_KT.as_tuple()
    return located(pose, external_part(target), posture_of(target), tag, None)


_UNKNOWN = "run the program in a cell, or move to a pose before"
