"""Operations of motion and gripper."""

import math
from dataclasses import replace
from functools import lru_cache
from itertools import chain
from struct import Struct
from typing import NamedTuple

from ropsim.core import maker
from ropsim.flow import (
    GripAction,
    GripInstruction,
    Instruction,
    ListedPoint,
    ModalState,
    MotionKind,
    MoveInstruction,
    PostureRequest,
    Side,
    SyncInstruction,
    Trigger,
)
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.geometry import check_same_frame
from ropsim.icr.machine.handlers import Datum
from ropsim.icr.machine.location import (
    Location,
    composed,
    external_part,
    point_of,
    pose_part,
    posture_of,
    tag_of,
)
from ropsim.icr.machine.operations.command_pose import command_pose
from ropsim.icr.machine.site import Operation, Site, barrier
from ropsim.icr.machine.state import Commanded, CommandedJoints, Finished, Registers
from ropsim.icr.machine.traps import TrapError, out_of_range
from ropsim.icr.machine.world import World
from ropsim.icr.rules.operands import setting_fault
from ropsim.spatial import Pose


class _AtPose(NamedTuple):
    """Attributes of the target pose of a move; see `MoveInstruction` and `Origin`."""

    external: tuple[float, ...] = ()
    via: tuple[Pose, ...] = ()
    posture: PostureRequest | None = None
    point: ListedPoint | None = None


_NOTHING = _AtPose()
_NUMBERS = Struct("7d")
_move = maker(MoveInstruction)


@lru_cache(maxsize=4096)
def _pose(numbers: bytes) -> Pose:
    """Return a pose of the bits of its numbers; the same ones come back in loops, and after an edit."""
    return Pose.from_tuple(_NUMBERS.unpack(numbers))


def _move_joints(registers: Registers, _world: World, site: Site) -> Instruction:
    registers.commanded = CommandedJoints(joints := registers.stack.pop(), registers.modal)
    return _told(registers, site, MotionKind.PTP, joints, registers.modal)


def _move_pose(registers: Registers, _world: World, site: Site) -> Instruction:
    return _moved(registers, site, _TO_POSES[site.mnemonic], _taken(registers, 1))


def _move_arc(registers: Registers, _world: World, site: Site) -> Instruction:
    return _moved(registers, site, MotionKind.CIRC, _taken(registers, 2))


def _move_arc_angle(registers: Registers, _world: World, site: Site) -> Instruction:
    """Hand out an arc that ends where its angle says, which the program does not compute."""
    angle = registers.stack.pop()
    if fault := setting_fault(site.mnemonic, angle):
        raise out_of_range(fault)
    move = _moved(registers, site, MotionKind.CIRC, _taken(registers, 2))
    registers.commanded = None
    return replace(move, angle=angle)


def _move_curve(registers: Registers, _world: World, site: Site) -> Instruction:
    return _moved(registers, site, MotionKind.SPLINE, _taken(registers, site.operand))


def _move_along(registers: Registers, _world: World, site: Site) -> Instruction:
    """Hand out a curve through all poses of a list."""
    before, behind = _taken(registers, 2)
    points = tuple(composed(composed(before, one), behind) for one in site.operand)
    if not all(map(math.isfinite, chain.from_iterable(map(pose_part, points)))):
        raise out_of_range(f"a pose of `{site.mnemonic}` is not finite")
    return _moved(registers, site, MotionKind.SPLINE, points)


def _taken(registers: Registers, count: int) -> tuple[Datum, ...]:
    """Take values from the stack, the top last."""
    taken = tuple(registers.stack[-count:])
    del registers.stack[-count:]
    return taken


def _moved(
    registers: Registers, site: Site, kind: MotionKind, points: tuple[Location, ...]
) -> MoveInstruction:
    """Return a move through points to the last one of them."""
    via, target = points[:-1], points[-1]
    for point in via:
        _check_via(site.mnemonic, point, target)
    registers.commanded = Commanded(target, modal := registers.modal)
    X_KT, *X_KV = [_pose(_NUMBERS.pack(*pose_part(one))) for one in (target, *via)]
    if (tag := tag_of(target)) is not None:
        modal = registers.changed(("FRAME", tag.name), frame=tag.name, X_BK=tag.X_BK)
    more = _AtPose(external_part(target), tuple(X_KV), posture_of(target), point_of(target))
    move = _told(registers, site, kind, X_KT, modal, more)
    if move.has_free_orientation:  # how the tool is turned at its end, the program does not compute
        registers.commanded = None
    return move


def _told(
    registers: Registers,
    site: Site,
    kind: MotionKind,
    target: Pose | tuple[float, ...] | None,
    modal: ModalState,
    more: _AtPose = _NOTHING,
) -> MoveInstruction:
    """Return a move with all settings for the next one.

    The end of a guarded move is unknown to the program, also that of a move corrected by a sensor.
    """
    triggers, registers.triggers = registers.triggers, ()
    guard, registers.guard = registers.guard, None
    tracking, registers.tracking = registers.tracking, None
    if guard is not None or tracking is not None:
        registers.commanded = None
    external, via, posture, point = more
    origin = registers.origin(site.key, site.span, point)
    return _move(kind, target, modal, origin, external, via, None, triggers, guard, posture, tracking)


def _check_via(name: str, point: Location, target: Location) -> None:
    """Trap where a point on the way has other attributes than the target: frame, external axes or posture.

    Raises:
        TrapError: it has external axes; for a path they belong to its end.
    """
    check_same_frame(name, point, target)
    for what, one, wanted in (
        ("values of external axes", external_part(point), external_part(target)),
        ("a posture or a free orientation", posture_of(point), posture_of(target)),
    ):
        if one and one != wanted:
            message = f"`{name}` is given a via point with {what} other than its target"
            raise TrapError(
                kinds.RANGE, message, "give them to the target only: they are those of the whole path"
            )


def _home(registers: Registers, _world: World, site: Site) -> Instruction:
    registers.commanded = CommandedJoints(None, registers.modal)
    return _told(registers, site, MotionKind.PTP, None, registers.modal)


def _trigger(registers: Registers, _world: World, site: Site) -> None:
    side, channel = site.operand
    value, place = _taken(registers, 2)
    if fault := setting_fault(site.mnemonic, place):
        raise out_of_range(fault)
    distance, time = (place, None) if site.mnemonic == "TRIG.DIST" else (None, place)
    registers.triggers += (Trigger(channel, value, _SIDES[side], distance, time),)


def _sync(registers: Registers, _world: World, site: Site) -> Instruction:
    return SyncInstruction(registers.modal, registers.origin(site.key, site.span), before=site.operand)


def _stop(registers: Registers, _world: World, site: Site) -> Instruction | Finished:
    return barrier(registers, site) or Finished(None, registers.steps, site.operand)


def _grip(registers: Registers, _world: World, site: Site) -> Instruction:
    action, tool = site.operand
    return GripInstruction(GripAction(action), tool, registers.modal, registers.origin(site.key, site.span))


_SIDES = {"before": Side.BEFORE_END, "after": Side.AFTER_START}
_TO_POSES = {"MOVE.PTP": MotionKind.PTP, "MOVE.LIN": MotionKind.LIN}
"""Kinds of the moves to one pose."""

MOTION: dict[str, Operation] = {
    "MOVE.PTP.J": _move_joints,
    "MOVE.PTP": _move_pose,
    "MOVE.LIN": _move_pose,
    "MOVE.CIRC": _move_arc,
    "MOVE.CIRC.A": _move_arc_angle,
    "MOVE.SPL": _move_curve,
    "MOVE.SPL.L": _move_along,
    "HOME": _home,
    "TRIG.DIST": _trigger,
    "TRIG.TIME": _trigger,
    "SYNC": _sync,
    "STOP": _stop,
    "GRIP": _grip,
    "CURPOSE": command_pose,
}
"""Mnemonic -> operation."""
