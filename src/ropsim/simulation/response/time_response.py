"""How an arm answers a step or a ramp of one reference coordinate: the servo as it is, limits and all."""

from math import nan

import numpy as np

from ropsim.controller import CompiledLaw, PythonLaw
from ropsim.dynamics import LimitSort, structure_of
from ropsim.flow import JointReference
from ropsim.model import ControllerModel, CurrentLoopMotor, Payload, RobotModel
from ropsim.simulation.servo.log import LogLayout
from ropsim.simulation.servo.servo import Servo
from ropsim.spatial import Array, frozen, record

SETTLED = 0.02
"""Half width of the band around the end of a step in which an axis has settled, over the step."""
LEAST_TIME, LONGEST_TIME = 0.5, 8.0
"""How long an answer is looked at [s]: until it has long settled, within these."""
_REST = 2.0
"""It has long settled when it was within its band for so long as it took to get there."""
_NEAR = 1e-6
_SLICE = 0.25
"""Time between two looks [s]."""


@record
class TimeResponse:
    """Motion of an axis while its reference steps or goes at a speed, and all others are held.

    Attributes:
        axis: number of the axis, from 0.
        time: [s], shape (k,); the reference changes at 0.
        reference: of the axis, from where it was [rad | m], shape (k,).
        moved: coordinate of the axis, from where it was [rad | m], shape (k,).
        effort: torque or force of its drive at the joint [N·m | N], shape (k,).
        others: largest deviations of the other axes [rad | m], 0 for this one, shape (n,).
        at_limit: share of the time at which the drive gives as much as it may.
    """

    axis: int
    time: Array
    reference: Array
    moved: Array
    effort: Array
    others: Array
    at_limit: float


@record
class StepFigures:
    """Figures of an answer to a step, as control textbooks have them.

    Attributes:
        rise: time from a tenth to nine tenths of the step [s]; NaN where it never gets there.
        overshoot: how far it goes beyond, over the step.
        peak_time: time of the farthest point [s].
        settling: time from which on it stays within 2 % of the step [s]; NaN where it does not in the time
            that is looked at.
        error: what is left at the end [rad | m].
    """

    rise: float
    overshoot: float
    peak_time: float
    settling: float
    error: float


def step_response(
    robot: RobotModel,
    controller: ControllerModel,
    q: Array,
    payload: Payload,
    step: tuple[int, float],
    law: CompiledLaw | PythonLaw | None = None,
) -> TimeResponse:
    """Return the answer to a step of the reference of an axis, from rest; reference speeds stay 0.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates at rest [rad | m], shape (n,).
        payload: tool and part.
        step: number of the axis, from 0, and the step of its reference [rad | m], not 0.
        law: another law than that of the controller model.

    Raises:
        DivergedError: S701, the state has become NaN or infinite.
    """
    axis, size = step
    return _answer(robot, (controller, law), q, payload, axis, (size, 0.0))


def ramp_response(
    robot: RobotModel,
    controller: ControllerModel,
    q: Array,
    payload: Payload,
    ramp: tuple[int, float],
    law: CompiledLaw | PythonLaw | None = None,
) -> TimeResponse:
    """Return the answer to a reference that goes at a speed from time 0 on; arguments as in `step_response`.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates at rest [rad | m], shape (n,).
        payload: tool and part.
        ramp: number of the axis, from 0, and the speed of its reference [rad/s | m/s], not 0.
        law: another law than that of the controller model.
    """
    axis, speed = ramp
    return _answer(robot, (controller, law), q, payload, axis, (0.0, speed))


def step_figures(answer: TimeResponse) -> StepFigures:
    """Return the figures of the answer to a step."""
    size = float(answer.reference[-1])
    share, time = answer.moved / size, answer.time
    tenth, nine = (_first(share, time, level) for level in (0.1, 0.9))
    outside = np.flatnonzero(np.abs(share - 1.0) > SETTLED)
    last = int(outside[-1]) if len(outside) else -1
    settling = nan if last == len(time) - 1 else float(time[last + 1])
    peak = int(share.argmax())
    error = size - float(answer.moved[-1])
    return StepFigures(nine - tenth, max(float(share[peak]) - 1.0, 0.0), float(time[peak]), settling, error)


def lag_of(answer: TimeResponse) -> tuple[float, float]:
    """Return how far an axis is behind a ramp at the end, and the largest such distance [rad | m]."""
    behind = (answer.reference - answer.moved) * np.sign(answer.reference[-1])
    return float(behind[-1]), float(behind.max())


def _first(share: Array, time: Array, level: float) -> float:
    """Return when a share is first beyond a level, between two samples; NaN for never."""
    places = np.flatnonzero(share >= level)
    if not len(places):
        return nan
    k = int(places[0])
    if k == 0:
        return float(time[0])
    part = (level - share[k - 1]) / (share[k] - share[k - 1])
    return float(time[k - 1] + part * (time[k] - time[k - 1]))


def _answer(
    robot: RobotModel,
    control: tuple[ControllerModel, CompiledLaw | PythonLaw | None],
    q: Array,
    payload: Payload,
    axis: int,
    change: tuple[float, float],
) -> TimeResponse:
    """Return the answer to a step and a speed of the reference of an axis."""
    controller, law = control
    servo = Servo.build(robot, controller, law)
    state = servo.initial_state(q, payload)
    recorder = servo.recorder(state)
    size, speed = change
    ticks = max(1, round(_SLICE * servo.control_hz))
    while True:
        time = (state.tick + np.arange(ticks)) / servo.control_hz  # row 0 comes into force a tick later
        rows, speeds = np.tile(np.asarray(q, np.float64), (ticks, 1)), np.zeros((ticks, robot.n))
        rows[:, axis] += size + speed * time
        speeds[:, axis] = speed
        state = servo.run(state, JointReference(rows, speeds, np.zeros_like(rows)), payload, recorder)
        made = _made(robot, recorder.channels(), axis, servo.control_hz, np.asarray(q, np.float64), change)
        if _is_over(made, size) or made.time[-1] >= LONGEST_TIME - 0.5 * _SLICE:
            return made


def _made(
    robot: RobotModel, log: dict[str, Array], axis: int, hz: int, q: Array, change: tuple[float, float]
) -> TimeResponse:
    time = np.arange(len(log["q"]) - 1) / hz
    away = log["q"][1:] - q
    moved = away[:, axis].copy()
    away[:, axis] = 0.0
    size, speed = change
    reference = size + speed * time
    return TimeResponse(
        axis,
        frozen(time),
        frozen(reference),
        frozen(moved),
        frozen(log["tau"][1:, axis]),
        frozen(np.abs(away).max(axis=0)),
        _at_limit(robot, log, axis),
    )


def _is_over(answer: TimeResponse, size: float) -> bool:
    """Return whether an answer to a step has long settled; that to a ramp is looked at for a while."""
    end = float(answer.time[-1])
    if end < LEAST_TIME - 0.5 * _SLICE:
        return False
    if size == 0.0:
        return end >= 4.0 * LEAST_TIME - 0.5 * _SLICE
    settling = step_figures(answer).settling
    return bool(end >= _REST * settling)


def _at_limit(robot: RobotModel, log: dict[str, Array], axis: int) -> float:
    """Return the share of the time at which the drive of an axis gives as much as it may.

    That is its amplifier at its largest output, or a current at its limit.
    """
    chains, drive = structure_of(robot).drives, robot.drives[axis]
    amplifier, layout = chains[axis].amplifier, LogLayout.of(chains)
    most = {amplifier.output.name: float(getattr(drive.amplifier, amplifier.numbers[0]))}
    most |= {
        one.column: one.near * float(getattr(drive.amplifier, one.number))
        for one in amplifier.limits
        if one.sort is LimitSort.LASTING
    }
    if isinstance(drive.motor, CurrentLoopMotor):
        most["current"] = drive.motor.max_current
    full = np.zeros(len(log["q"]) - 1, np.bool_)
    for name, value in most.items():
        column = log[name][1:, layout.field(name).axes.index(axis)]
        full |= np.abs(column) >= (1.0 - _NEAR) * value
    return float(full.mean())
