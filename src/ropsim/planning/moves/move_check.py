"""Checks of the values of one move instruction, before anything is computed with them."""

import math
from collections.abc import Collection, Container, Iterator

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.model import RobotModel, external_words
from ropsim.motion import (
    BAD_MOTION_VALUE,
    JOINT_OUT_OF_RANGE,
    MOVE_TOO_LONG,
    UNKNOWN_PATH,
    WRONG_NUMBER_OF_JOINTS,
)
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.records.wording import coordinate, figures, passes
from ropsim.spatial import Array, Pose

MAX_DURATION = 600.0  # [s] of one move; beyond it a mistaken unit is certain enough
MAX_COORDINATE = 1e3  # [m]
_MAX_RATE = 1e6  # any speed, acceleration or jerk, in SI units


def check_kind(move: MoveInstruction, kinds: Collection[str]) -> tuple[Diagnostic, ...]:
    """Return M561 where the kind of path of a move is neither PTP nor one of `kinds`."""
    if move.kind == MotionKind.PTP or move.kind in kinds:
        return ()
    known = ", ".join((MotionKind.PTP.value, *sorted(kinds)))
    found = UNKNOWN_PATH.at(
        move.origin.span,
        f"a move is of kind `{move.kind}`, this controller makes {known}",
        label=passes(move.origin),
        hint="use one of the kinds that it makes",
        data=move.origin.data,
    )
    return (found,)


def check_values(move: MoveInstruction) -> tuple[Diagnostic, ...]:
    """Return M509 for every value of the move that no motion can have."""
    if _is_plausible(move):
        return ()
    return tuple(
        BAD_MOTION_VALUE.at(
            move.origin.span,
            f"{name} is {value:g}{unit}, allowed is {allowed}",
            label=passes(move.origin),
            hint="look where the value is computed, and at its unit",
            data={"name": name, "value": value, **move.origin.data},
        )
        for name, value, unit, allowed in (
            *_bad_modal(move.modal),
            *_bad_target(move),
            *_bad_frames(move.modal),
        )
    )


def check_joints(
    move: MoveInstruction, q: Array, robot: RobotModel, limits: JointRange
) -> tuple[Diagnostic, ...]:
    """Return M508 where the number of joint coordinates is wrong, or M502 for each one out of range.

    Args:
        move: the instruction that they belong to.
        q: joint coordinates [rad | m], shape (m,).
        robot: the arm.
        limits: of its joints.
    """
    span, origin = move.origin.span, move.origin
    if len(q) != robot.n:
        behind = f", then {external_words(robot)}" if robot.external and robot.has_arm else ""
        found = WRONG_NUMBER_OF_JOINTS.at(
            span,
            f"target has {len(q)} joint coordinates, {_axes_of(robot)}",
            label=passes(origin),
            hint=f"give {robot.n} values, from the base to the tip{behind}",
            data={"found": len(q), "allowed": robot.n, **origin.data},
        )
        return (found,)
    return limit_findings(move, q, robot, limits, range(len(limits.joints)))


def _axes_of(robot: RobotModel) -> str:
    """Return how many axes the arm has, and the number of other axes."""
    external = len(robot.external) if robot.has_arm else 0
    own = f"`{robot.name}` has {robot.n - external} {'joint' if robot.n - external == 1 else 'joints'}"
    return own + (f" and {external} external {'axis' if external == 1 else 'axes'}" if external else "")


def limit_findings(
    move: MoveInstruction, q: Array, robot: RobotModel, limits: JointRange, numbers: Container[int]
) -> tuple[Diagnostic, ...]:
    """Return M502 for each of some joints whose coordinate is out of range.

    Args:
        move: the instruction that they belong to.
        q: joint coordinates [rad | m], shape (n,).
        robot: the arm.
        limits: of its joints.
        numbers: of the joints to check, among the joints of the limits.
    """
    origin = move.origin
    values, outside = limits.values(q[None])[0], np.flatnonzero(limits.excess(q[None])[0]).tolist()
    findings = []
    for index in (number for number in outside if number in numbers):
        joint, value = limits.joints[index], float(values[index])
        limit = joint.upper if value > joint.upper else joint.lower
        findings.append(
            JOINT_OUT_OF_RANGE.at(
                origin.span,
                f"target has joint `{joint.name}` at {coordinate(joint, value)}, "
                f"the limit is {coordinate(joint, limit)}",
                label=passes(origin),
                hint="give a coordinate within the limits of the joint"
                if index < robot.n
                else "the joint follows the axes: change the coordinates that move it",
                data={**figures(joint, value, limit), **origin.data},
            )
        )
    return tuple(findings)


def check_duration(move: MoveInstruction, duration: float) -> tuple[Diagnostic, ...]:
    """Return M513 where the move lasts longer than `MAX_DURATION` [s]."""
    if duration <= MAX_DURATION:
        return ()
    finding = MOVE_TOO_LONG.at(
        move.origin.span,
        f"the move would take {duration:.6g} s, allowed is {MAX_DURATION:g} s",
        label=passes(move.origin),
        hint="raise the speed, or cut the way into several moves",
        data={"duration_s": duration, "limit_s": MAX_DURATION, **move.origin.data},
    )
    return (finding,)


def _is_plausible(move: MoveInstruction) -> bool:
    """Return whether no value of a move to a pose is bad; false if each must be checked."""
    modal, target = move.modal, move.target
    if not isinstance(target, Pose) or move.external or not 0.0 <= modal.zone <= MAX_COORDINATE:
        return False
    if not (0.0 < modal.ptp_speed <= 1.0 and 0.0 < modal.ptp_acceleration <= 1.0):
        return False
    tool = modal.X_MT
    frames = is_near(target) and is_near(modal.X_BK) and (tool is None or is_near(tool))
    return frames and _are_rates(modal)


def is_near(pose: Pose) -> bool:
    """Return whether a pose is where a cell can be."""
    values: list[float] = pose.position.tolist()
    x, y, z = values
    return abs(x) <= MAX_COORDINATE and abs(y) <= MAX_COORDINATE and abs(z) <= MAX_COORDINATE


def _are_rates(modal: ModalState) -> bool:
    speed, acceleration, jerk = modal.path_speed, modal.path_acceleration, modal.path_jerk
    turning, turning_up = modal.orientation_speed, modal.orientation_acceleration
    return (
        (speed is None or 0.0 < speed <= _MAX_RATE)
        and (acceleration is None or 0.0 < acceleration <= _MAX_RATE)
        and (jerk is None or 0.0 < jerk <= _MAX_RATE)
        and (turning is None or 0.0 < turning <= _MAX_RATE)
        and (turning_up is None or 0.0 < turning_up <= _MAX_RATE)
    )


Bad = tuple[str, float, str, str]


def _bad_modal(modal: ModalState) -> Iterator[Bad]:
    for name, share in (("PTP speed", modal.ptp_speed), ("PTP acceleration", modal.ptp_acceleration)):
        if not 0.0 < share <= 1.0:
            yield name, share * 100.0, " %", "more than 0 % up to 100 %"
    rates = (
        ("path speed", modal.path_speed, " m/s"),
        ("path acceleration", modal.path_acceleration, " m/s²"),
        ("path jerk", modal.path_jerk, " m/s³"),
        ("orientation speed", modal.orientation_speed, " rad/s"),
        ("orientation acceleration", modal.orientation_acceleration, " rad/s²"),
    )
    for name, rate, unit in rates:
        if rate is not None and not 0.0 < rate <= _MAX_RATE:
            yield name, rate, unit, f"more than 0 up to {_MAX_RATE:g}{unit}"
    if not 0.0 <= modal.zone <= MAX_COORDINATE:
        yield "zone", modal.zone, " m", f"0 up to {MAX_COORDINATE:g} m"


def _bad_target(move: MoveInstruction) -> Iterator[Bad]:
    for number, value in enumerate(move.external, start=1):
        if not abs(value) <= MAX_COORDINATE:
            yield f"value {number} of the external axes", value, "", f"a number up to ±{MAX_COORDINATE:g}"
    if isinstance(move.target, Pose):
        yield from _bad_position("target", move.target)
    elif move.target is not None:
        for number, value in enumerate(move.target, start=1):
            if not abs(value) <= MAX_COORDINATE:
                yield f"joint coordinate {number}", value, "", f"a number up to ±{MAX_COORDINATE:g}"


def _bad_frames(modal: ModalState) -> Iterator[Bad]:
    yield from _bad_position(f"task frame `{modal.frame}`", modal.X_BK)
    if modal.X_MT is not None:
        yield from _bad_position(f"tool `{modal.tool}`", modal.X_MT)


def _bad_position(name: str, pose: Pose) -> Iterator[Bad]:
    for axis, value in zip("xyz", pose.position.tolist(), strict=True):
        if not math.isfinite(value) or abs(value) > MAX_COORDINATE:
            yield f"{axis} of the {name}", value, " m", f"a number up to ±{MAX_COORDINATE:g} m"
