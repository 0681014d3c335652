"""The torques of the drives along a motion: many rows in one call of compiled code."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ropsim.codegen import (
    CONSTANTS,
    Compiled,
    Engine,
    Formula,
    GivenCode,
    SourceFunction,
    Tracer,
    bound,
    default_engine,
    load,
    row_by_row,
)
from ropsim.dynamics.arm_functions import identifier
from ropsim.dynamics.diagnostics import WRONG_SHAPE, StateShapeError
from ropsim.dynamics.long_arms.long_arm import chain_numbers, chain_torque_code
from ropsim.dynamics.loops.closed_arm import ClosedArmFunctions
from ropsim.dynamics.model_check import check_model
from ropsim.dynamics.structure import ArmStructure, arm_numbers, structure_of, traced_numbers
from ropsim.dynamics.traced.newton_euler import trace_inverse
from ropsim.dynamics.traced.traced_arm import trace_arm
from ropsim.dynamics.traced.traced_drives import joint_sides, sides_code
from ropsim.model import Mechanism, Payload
from ropsim.spatial import Array

_NAME = "effort_rows"
_SIGNATURE = "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1])"
_LONG_ROWS = """\
def effort_rows(constants, q, qd, qdd, tau):
    n = q.shape[1]
    side, wrench, chain = np.empty(3 * n), np.zeros(6), constants[{count}:]
    for k in range(q.shape[0]):
        chain_torques(q[k], qd[k], qdd[k], wrench, chain, tau[k])
        sides(q[k], qd[k], constants, side)
        for j in range(n):
            tau[k, j] += side[n + j] * qdd[k, j] + side[j]
            tau[k, j] /= 1.0 - side[2 * n + j] if tau[k, j] > 0.0 else 1.0 + side[2 * n + j]
"""


@dataclass(frozen=True, slots=True, eq=False)
class EffortRows:
    """The torques of the drives of an arm, row by row of a motion; made by `effort_rows`.

    Attributes:
        n: number of axes.
        function: `(q, qd, qdd, tau)`, compiled or in Python.
    """

    n: int
    function: Compiled

    def __call__(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Return for each row the result of `inverse_dynamics`, shape (k, n) [N·m | N].

        It is the torque that a drive must produce at its joint, before subtraction of friction, as in limits
        and recordings: for the rigid bodies with the payload, the inertia of the motor, and friction. Coulomb
        friction is |G|·Tc·tanh(q̇/v_s): at standstill it is 0 for both directions of the next motion. A law
        of friction with states counts as in steady motion. All numbers are to be finite; a row with NaN
        yields NaN and leaves the others alone.

        Args:
            q: joint coordinates [rad | m], shape (k, n).
            qd: joint speeds [rad/s | m/s], shape (k, n).
            qdd: joint accelerations [rad/s² | m/s²], shape (k, n).

        Raises:
            StateShapeError: M570, the arrays are not all of shape (k, n).
        """
        rows = len(q) if q.ndim else 0
        for name, array in (("q", q), ("qd", qd), ("qdd", qdd)):
            if array.shape != (rows, self.n):
                message = f"array `{name}` has shape `{array.shape}`; allowed is `({rows or 'k'}, {self.n})`"
                hint = "give one row per tick with one number per joint"
                raise StateShapeError(WRONG_SHAPE.at(None, message, hint=hint))
        tau = np.empty((rows, self.n))
        self.function(_plain(q), _plain(qd), _plain(qdd), tau)
        return tau


def effort_rows(robot: Mechanism, payload: Payload | None = None, engine: Engine | None = None) -> EffortRows:
    """Return the torques of the drives of an arm as a function of the rows of a motion.

    Structure is compiled, numbers are passed: an arm that differs in masses, friction or motors, and another
    payload, compile nothing. Without drives there is neither friction nor motor inertia.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.
        engine: who runs the code; None takes numba where it is installed.

    Raises:
        JointCountError: the arm has no joints, or not exactly one link for each of them and one drive for
            each axis.
        MechanismError: the mechanism cannot be, or its closed chains cannot move.
        ModelNumberError: a number of the model is not finite.
    """
    return _effort_rows(robot, payload, engine or default_engine())


@lru_cache(maxsize=256)
def _effort_rows(robot: Mechanism, payload: Payload | None, engine: Engine) -> EffortRows:
    check_model(robot)
    if robot.cuts:
        return EffortRows(robot.n, ClosedArmFunctions(robot, payload, engine).inverse_rows)
    structure, numbers = structure_of(robot), arm_numbers(robot, payload)
    if structure.is_long:
        sides = sides_code(structure)
        inner: tuple[SourceFunction, ...] = (*chain_torque_code(), *sides.functions)
        constants = np.concatenate([sides.constants(numbers), chain_numbers(structure, numbers)])
        rows = SourceFunction(_NAME, _SIGNATURE, _LONG_ROWS.format(count=sides.count))
    else:
        code = _efforts_code(structure)
        inner, constants = code.functions, code.constants(numbers)
        rows = row_by_row(_NAME, inner[-1], CONSTANTS)
    function = load(f"{identifier(robot.name)}_effort_rows", (*inner, rows), engine)
    return EffortRows(robot.n, bound(function, constants))


@lru_cache(maxsize=64)
def _efforts_code(structure: ArmStructure) -> GivenCode:
    """Return `efforts(q, qd, qdd, constants, tau)` of one row."""
    tracer = Tracer()
    q, qd, qdd = (tracer.variables(name, structure.n) for name in ("q", "qd", "qdd"))
    numbers = traced_numbers(tracer, structure)
    tau = trace_inverse(trace_arm(tracer, structure, numbers, q), qd, qdd)
    for k, side in enumerate(joint_sides(structure, numbers.drives, tracer, (q, qd))):
        tau[k] = side.needed(tau[k] + qdd[k] * side.inertia)
    results = [(f"tau[{k}]", value) for k, value in enumerate(tau)]
    return GivenCode.of(Formula("efforts", ("q", "qd", "qdd", "tau"), results))


def _plain(array: Array) -> Array:
    """Return an array as compiled code takes it; copies only where it must."""
    return np.ascontiguousarray(array, np.float64)
