"""Checks at the door of the servo simulation, and the errors they raise."""

import math
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim.controller import LAW_DOES_NOT_FIT, CompiledLaw, LawError, LawTraits
from ropsim.core import did_you_mean
from ropsim.dynamics import chain_of, drive_fault, range_fault, shared_supply_fault
from ropsim.flow import JointReference
from ropsim.model import Cell, Rates, RobotModel
from ropsim.simulation.servo.diagnostics import (
    BAD_DRIVE,
    BAD_OPTIONS,
    BAD_REFERENCE,
    NO_DRIVES,
    DriveDataError,
    NoDrivesError,
    OptionError,
    ServoArrayError,
)
from ropsim.spatial import Array, real_numbers

_FLOAT64 = np.dtype(np.float64)
MOST_DELAY = 1000
"""Longest delay of a law [control ticks]."""


def _no_drives(robot: RobotModel) -> NoDrivesError:
    """Return the error of an arm without drives."""
    message = (
        f"model `{robot.name}` has {len(robot.drives)} drives for {robot.n} joints; each joint needs one"
    )
    hint = "take an arm with drive data, such as `puma560`, or run without dynamics"
    return NoDrivesError(NO_DRIVES.at(None, message, hint=hint))


def check_drives(robot: RobotModel) -> None:
    """Make sure that every joint has a drive that can exist.

    Raises:
        NoDrivesError: drives are missing.
        DriveDataError: a constant is impossible.
    """
    if len(robot.drives) != robot.n:
        raise _no_drives(robot)
    shared = shared_supply_fault(robot.drives)
    for axis, (joint, drive) in enumerate(zip(robot.axis_joints, robot.drives, strict=True)):
        found = drive_fault(drive) or range_fault(drive, joint)
        if found is None and shared is not None and shared[0] == axis:
            found = shared[1]
        if found:
            message = f"{found[0]} of the drive of joint `{joint.name}` {found[1]}"
            raise DriveDataError(BAD_DRIVE.at(None, message, hint="look at the drive data of the model"))


def check_option(name: str, value: int) -> None:
    """Make sure that a count is a whole number of at least 1.

    Raises:
        OptionError: it is not.
    """
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        message = f"`{name}` is `{value!r}`; allowed are whole numbers from 1"
        raise OptionError(BAD_OPTIONS.at(None, message, hint=f"set `{name}` to 1 or more"))


def check_time(name: str, value: float) -> None:
    """Make sure that a time is a number from 0 on.

    Raises:
        OptionError: it is not, or it is not finite.
    """
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 <= value < math.inf:
        message = f"`{name}` is `{value!r}`; allowed are seconds from 0 on"
        raise OptionError(BAD_OPTIONS.at(None, message, hint=f"set `{name}` to a number of seconds"))


def check_share(name: str, value: float) -> None:
    """Make sure that a share is a number from 0 to 1.

    Raises:
        OptionError: it is not.
    """
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 <= value <= 1.0:
        message = f"`{name}` is `{value!r}`; allowed are numbers from 0 to 1"
        raise OptionError(BAD_OPTIONS.at(None, message, hint=f"set `{name}` to a share, such as 0.5"))


def check_rates(rates: Rates) -> None:
    """Make sure that the rates of a controller are whole numbers of at least 1.

    Raises:
        OptionError: one is not.
    """
    check_option("control_hz", rates.control_hz)
    if rates.plant_steps is not None:
        check_option("plant_steps", rates.plant_steps)


def check_law(law: CompiledLaw, robot: RobotModel) -> None:
    """Make sure that a law fits the arm: its parameters, its output, its state.

    Raises:
        ServoArrayError: its parameters do not.
        LawError: its traits do not fit.
    """
    misfit = _misfit(law.traits, robot) or _unsensed(law.traits, robot)
    if law.model and law.model.robot.n != robot.n:
        misfit = f"has a model of {law.model.robot.n} axes, the arm has {robot.n}"
    if misfit:
        hint = "look at the `traits` of the law"
        raise LawError(LAW_DOES_NOT_FIT.at(None, f"law `{law.name}` {misfit}", hint=hint))
    allowed = (len(law.parameter_names), robot.n)
    if law.parameters.shape != allowed:
        raise _bad_shape(f"parameters of law `{law.name}`", law.parameters.shape, str(allowed))
    if not np.isfinite(law.parameters).all():
        raise _not_finite(f"parameters of law `{law.name}`")


def _misfit(traits: LawTraits, robot: RobotModel) -> str:
    """Return the traits of a law that do not fit an arm, as text; empty if all fit."""
    for joint, drive in zip(robot.axis_joints, robot.drives, strict=True):
        takes = chain_of(drive).amplifier.kind
        if traits.u_kind not in (None, takes):
            return f"puts out {traits.u_kind}, but the drive of joint `{joint.name}` takes {takes}"
    rows = len(traits.state_names)
    if traits.hold_row is not None and not 0 <= traits.hold_row < rows:
        return f"names row {traits.hold_row} as `hold_row`, but has {rows} rows of state"
    if not isinstance(traits.delay, int) or not 0 <= traits.delay <= MOST_DELAY:
        return f"has a delay of {traits.delay!r}; allowed are 0 to {MOST_DELAY} control ticks"
    return ""


def _unsensed(traits: LawTraits, robot: RobotModel) -> str:
    """Return the state that a law reads and a drive does not have, as text; empty if there is none."""
    axes = range(robot.n) if traits.sensed_axes is None else traits.sensed_axes
    for axis in axes:
        if not 0 <= axis < robot.n:
            return f"names axis {axis} in `sensed_axes`; the arm has axes 0 to {robot.n - 1}"
        there = [column.name for column in chain_of(robot.drives[axis]).states]
        for name in traits.sensed:
            if name not in there:
                has = f"only {', '.join(f'`{one}`' for one in there)}" if there else "nothing to be sensed"
                return f"reads `{name}`: the drive of joint `{robot.axis_joints[axis].name}` has {has}"
    return ""


def check_signals(law: CompiledLaw, cell: Cell) -> None:
    """Make sure that the cell has the signals that a law reads.

    Raises:
        LawError: it does not.
    """
    for name in law.traits.aux:
        if name not in cell.signals:
            hint = did_you_mean(name, cell.signals) or "look at the signals in cell.toml"
            message = f"law `{law.name}` reads signal `{name}`, which the cell does not have"
            raise LawError(LAW_DOES_NOT_FIT.at(None, message, hint=hint))
        if cell.signals[name].sensor is not None:
            hint = "let the law read an input that a script or a program changes"
            message = (
                f"law `{law.name}` reads signal `{name}` at every control tick, but a sensor measures it for "
                "programs only, between slices"
            )
            raise LawError(LAW_DOES_NOT_FIT.at(None, message, hint=hint))


def check_aux(aux: Array | None, ticks: int, names: tuple[str, ...]) -> Array:
    """Return the signals that a law reads, shape (ticks, a).

    Raises:
        ServoArrayError: they are missing or have another shape.
    """
    allowed = (ticks, len(names))
    given = np.empty((ticks, 0)) if aux is None else aux
    if given.shape != allowed:
        raise _bad_shape(
            "array `aux`", given.shape, f"{allowed}, a column for each signal that the law reads"
        )
    return _plain(given)


def check_vector(name: str, values: npt.ArrayLike, n: int) -> Array:
    """Return a writable copy of an array of n finite numbers.

    Raises:
        ServoArrayError: it has another shape or a number is not finite.
    """
    array = real_numbers(values)
    if array is None:
        raise _not_finite(f"array `{name}`")
    if array.shape != (n,):
        raise _bad_shape(f"array `{name}`", array.shape, f"({n},)")
    if not np.isfinite(array).all():
        raise _not_finite(f"array `{name}`")
    return np.array(array)


def check_output(values: npt.ArrayLike, n: int, tick: int, control_hz: int) -> Array:
    """Return the output of a law in Python at a control tick, n finite numbers.

    Raises:
        ServoArrayError: it has another shape or a number is not finite; the tick is named.
    """
    try:
        return check_vector("u", values, n)
    except ServoArrayError as error:
        found, time = error.diagnostic, tick / control_hz
        message = f"{found.message}; the law in Python put it out at {time:.6g} s (control tick {tick})"
        data = {**found.data, "time_s": time, "tick": tick}
        raise ServoArrayError(replace(found, message=message, data=data)) from error


def check_reference(reference: JointReference, n: int) -> tuple[Array, Array, Array]:
    """Return q, qd and qdd as compiled code takes them: contiguous float64; copies only where needed.

    Raises:
        ServoArrayError: the arrays are not all of shape (ticks, n).
    """
    q, qd, qdd = reference.q, reference.qd, reference.qdd
    if not q.shape == qd.shape == qdd.shape == (len(q), n):
        for name, array in (("q", q), ("qd", qd), ("qdd", qdd)):
            if array.shape != (len(q), n):
                raise _bad_shape(f"array `reference.{name}`", array.shape, f"(ticks, {n}) for all three")
    return _plain(q), _plain(qd), _plain(qdd)


def _plain(array: Array) -> Array:
    if array.dtype is _FLOAT64 and array.flags.carray:
        return array
    return np.require(array, np.float64, ["C", "W"])


def _bad_shape(what: str, shape: tuple[int, ...], allowed: str) -> ServoArrayError:
    message = f"{what} has shape `{shape}`; allowed is `{allowed}`"
    return ServoArrayError(BAD_REFERENCE.at(None, message, hint="give one number per joint"))


def _not_finite(what: str) -> ServoArrayError:
    message = f"{what} holds a number that is not finite; all must be finite"
    return ServoArrayError(BAD_REFERENCE.at(None, message, hint="look for NaN or inf where it is computed"))
