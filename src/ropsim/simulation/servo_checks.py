"""Checks at the door of the servo simulation, and the errors they raise."""

import numpy as np
import numpy.typing as npt

from ropsim.controller import CompiledLaw
from ropsim.dynamics import drive_fault
from ropsim.flow import JointReference
from ropsim.model import Rates, RobotModel
from ropsim.simulation.servo_diagnostics import (
    BAD_DRIVE,
    BAD_OPTIONS,
    BAD_REFERENCE,
    DIVERGED,
    NO_DRIVES,
    DivergedError,
    DriveDataError,
    NoDrivesError,
    OptionError,
    ServoArrayError,
)
from ropsim.simulation.servo_state import ServoState
from ropsim.spatial import Array, real_numbers


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
    for joint, drive in zip(robot.joints, robot.drives, strict=True):
        found = drive_fault(drive)
        if found:
            message = f"{found[0]} of the drive of joint `{joint.name}` {found[1]}"
            raise DriveDataError(BAD_DRIVE.at(None, message, hint="look at the drive data of the model"))


def diverged(robot: RobotModel, state: ServoState, control_hz: int) -> DivergedError:
    """Return the error of a state that is not finite."""
    bad = np.flatnonzero(~np.isfinite(state.values))
    joint = f" at joint `{robot.joints[int(bad[0]) % robot.n].name}`" if len(bad) else ""
    time = state.tick / control_hz
    message = f"the state is not finite any more{joint} at or after {time:.6g} s; all numbers must be finite"
    hint = "look for a NaN in reference, payload or gains, or raise `plant_steps`"
    return DivergedError(DIVERGED.at(None, message, hint=hint, data={"time_s": time}))


def check_option(name: str, value: int) -> None:
    """Make sure that a count is a whole number of at least 1.

    Raises:
        OptionError: it is not.
    """
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        message = f"`{name}` is `{value!r}`; allowed are whole numbers from 1"
        raise OptionError(BAD_OPTIONS.at(None, message, hint=f"set `{name}` to 1 or more"))


def check_rates(rates: Rates) -> None:
    """Make sure that the rates of a controller are whole numbers of at least 1.

    Raises:
        OptionError: one is not.
    """
    check_option("control_hz", rates.control_hz)
    check_option("plant_steps", rates.plant_steps)


def check_law(law: CompiledLaw, n: int) -> None:
    """Make sure that the parameters of a law fit the arm.

    Raises:
        ServoArrayError: they do not.
    """
    allowed = (len(law.parameter_names), n)
    if law.parameters.shape != allowed:
        raise _bad_shape(f"parameters of law `{law.name}`", law.parameters.shape, str(allowed))
    if not np.isfinite(law.parameters).all():
        raise _not_finite(f"parameters of law `{law.name}`")


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


def check_reference(reference: JointReference, n: int) -> tuple[Array, Array, Array]:
    """Return q, qd and qdd as compiled code takes them: contiguous float64; copies only where needed.

    Raises:
        ServoArrayError: the arrays are not all of shape (ticks, n).
    """
    allowed = (reference.ticks, n)
    for name, array in (("q", reference.q), ("qd", reference.qd), ("qdd", reference.qdd)):
        if array.shape != allowed:
            raise _bad_shape(f"array `reference.{name}`", array.shape, f"(ticks, {n}) for all three")
    return _plain(reference.q), _plain(reference.qd), _plain(reference.qdd)


def _plain(array: Array) -> Array:
    return np.require(array, np.float64, ["C", "W"])


def _bad_shape(what: str, shape: tuple[int, ...], allowed: str) -> ServoArrayError:
    message = f"{what} has shape `{shape}`; allowed is `{allowed}`"
    return ServoArrayError(BAD_REFERENCE.at(None, message, hint="give one number per joint"))


def _not_finite(what: str) -> ServoArrayError:
    message = f"{what} holds a number that is not finite; all must be finite"
    return ServoArrayError(BAD_REFERENCE.at(None, message, hint="look for NaN or inf where it is computed"))
