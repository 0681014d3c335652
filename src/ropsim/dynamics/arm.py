"""Dynamics of an arm for callers with plain arrays: checked shapes in, new arrays out."""

import numpy as np
import numpy.typing as npt

from ropsim.dynamics.arm_functions import compiled
from ropsim.dynamics.diagnostics import WRONG_SHAPE, StateShapeError
from ropsim.dynamics.mass_check import check_inertias, check_masses, missing_inertia
from ropsim.dynamics.model_check import check_model
from ropsim.dynamics.structure import arm_numbers, structure_of
from ropsim.dynamics.traced.traced_drives import drive_sides
from ropsim.kinematics import NotFiniteError
from ropsim.model import Mechanism, Payload
from ropsim.spatial import Array, real_numbers


def inverse_dynamics(
    robot: Mechanism,
    q: npt.ArrayLike,
    qd: npt.ArrayLike,
    qdd: npt.ArrayLike,
    wrench: npt.ArrayLike | None = None,
    *,
    payload: Payload | None = None,
) -> Array:
    """Return the drive torques at the joints that a motion takes, shape (n,) [N·m | N].

    Rigid bodies, motor inertia J·G² and friction; the inverse of `forward_dynamics`.

    Args:
        robot: the arm.
        q: joint coordinates [rad | m], shape (n,).
        qd: joint speeds [rad/s | m/s], shape (n,).
        qdd: joint accelerations [rad/s² | m/s²], shape (n,).
        wrench: force [N] then moment [N·m] that the mechanical interface exerts on its surroundings, in its
            own frame, about its origin, shape (6,); it adds +Jᵀ·wrench. None for none.
        payload: body at the mechanical interface.

    Raises:
        StateShapeError: an array has another shape.
        NotFiniteError: an array holds NaN or infinity.
        JointCountError: the arm has no joints, or not exactly one link and one drive for each.
        ModelNumberError: a number of the model is not finite.
        MissingMassError: no link of the arm has a mass.
    """
    check_masses(robot)
    tip = np.zeros(6) if wrench is None else _array("wrench", wrench, 6)
    tau = np.empty(robot.n)
    compiled(robot, payload).inverse(*_motion(robot, q, qd, qdd), tip, tau)
    return tau


def rigid_inverse_dynamics(
    robot: Mechanism,
    q: npt.ArrayLike,
    qd: npt.ArrayLike,
    qdd: npt.ArrayLike,
    payload: Payload | None = None,
) -> Array:
    """Return the joint torques of the rigid bodies alone, shape (n,): no friction, no motor inertia.

    Arguments and errors as in `inverse_dynamics`.
    """
    check_masses(robot)
    tau = np.empty(robot.n)
    compiled(robot, payload).rigid_inverse(*_motion(robot, q, qd, qdd), np.zeros(6), tau)
    return tau


def gravity(robot: Mechanism, q: npt.ArrayLike, payload: Payload | None = None) -> Array:
    """Return the joint torques that hold the arm still against gravity, shape (n,) [N·m | N].

    Arguments and errors as in `inverse_dynamics`.
    """
    rest = np.zeros(robot.n)
    return rigid_inverse_dynamics(robot, q, rest, rest, payload)


def bias(robot: Mechanism, q: npt.ArrayLike, qd: npt.ArrayLike, payload: Payload | None = None) -> Array:
    """Return the joint torques of gravity, centrifugal and Coriolis forces, shape (n,); no friction.

    Arguments and errors as in `inverse_dynamics`.
    """
    return rigid_inverse_dynamics(robot, q, qd, np.zeros(robot.n), payload)


def forward_dynamics(
    robot: Mechanism,
    q: npt.ArrayLike,
    qd: npt.ArrayLike,
    tau: npt.ArrayLike,
    payload: Payload | None = None,
) -> Array:
    """Return the joint accelerations under drive torques, shape (n,) [rad/s² | m/s²].

    Args:
        robot: the arm.
        q: joint coordinates [rad | m], shape (n,).
        qd: joint speeds [rad/s | m/s], shape (n,).
        tau: torques of the drives at the joints, before friction [N·m | N], shape (n,).
        payload: body at the mechanical interface.

    Raises:
        StateShapeError: an array has another shape.
        NotFiniteError: an array holds NaN or infinity.
        JointCountError: the arm has no joints, or not exactly one link and one drive for each.
        ModelNumberError: a number of the model is not finite.
        MissingMassError: no link has a mass, or an axis moves nothing that has an inertia.
    """
    check_inertias(robot, payload)
    n = robot.n
    qdd = np.empty(n)
    inputs = (_array("q", q, n), _array("qd", qd, n), _array("tau", tau, n))
    try:
        compiled(robot, payload).forward(*inputs, qdd)
    except ZeroDivisionError:
        raise missing_inertia(robot, ()) from None
    if not np.isfinite(qdd).all():
        raise missing_inertia(robot, ())
    return qdd


def mass_matrix(robot: Mechanism, q: npt.ArrayLike, payload: Payload | None = None) -> Array:
    """Return the mass matrix with motor inertia on its diagonal, shape (n, n) [kg·m² | kg·m | kg].

    Arguments and errors as in `inverse_dynamics`.
    """
    check_masses(robot)
    n = robot.n
    entries = np.empty(n * n)
    compiled(robot, payload).mass_matrix(_array("q", q, n), entries)
    return entries.reshape(n, n)


def friction(robot: Mechanism, q: npt.ArrayLike, qd: npt.ArrayLike) -> Array:
    """Return the torques that friction exerts on the joints, shape (n,) [N·m | N]: against the motion.

    They include the force on the rod of a cylinder due to its changing lever, and not what friction takes of
    the load. Laws with states count as in steady motion.

    Args:
        robot: the arm; without drives there is no friction, and behind an elastic gear it acts on the motor.
        q: joint coordinates [rad | m], shape (n,); only the levers of cylinders depend on them.
        qd: joint speeds [rad/s | m/s], shape (n,).

    Raises:
        StateShapeError: an array has another shape.
        NotFiniteError: an array holds NaN or infinity.
    """
    check_model(robot)
    places, speeds = _array("q", q, robot.n), _array("qd", qd, robot.n)
    against, *_ = drive_sides(structure_of(robot), arm_numbers(robot))(places, speeds)
    torques: Array = 0.0 - against
    return torques


def _motion(
    robot: Mechanism, q: npt.ArrayLike, qd: npt.ArrayLike, qdd: npt.ArrayLike
) -> tuple[Array, Array, Array]:
    n = robot.n
    return _array("q", q, n), _array("qd", qd, n), _array("qdd", qdd, n)


def _array(name: str, values: npt.ArrayLike, size: int) -> Array:
    array = real_numbers(values)
    if array is None or array.shape != (size,):
        found = "no real numbers" if array is None else f"shape `{array.shape}`"
        message = f"array `{name}` has {found}; allowed is `({size},)`"
        raise StateShapeError(
            WRONG_SHAPE.at(None, message, hint="call once per state with one number per joint")
        )
    if not np.isfinite(array).all():
        raise NotFiniteError(name)
    return np.array(array)  # compiled functions take contiguous writable arrays only
