"""The functions of an arm that is too long for straight-line code: loops over its joints."""

from functools import cache

import numpy as np

from ropsim.codegen import Compiled, Engine, SourceFunction, load, source_function
from ropsim.dynamics.long_arms import chain_steps as steps
from ropsim.dynamics.long_arms.chain_loop import chain_accelerations, chain_mass_matrix, chain_torques
from ropsim.dynamics.model_check import check_model
from ropsim.dynamics.structure import BODY, ArmStructure, arm_numbers, structure_of
from ropsim.dynamics.traced.traced_drives import drive_sides
from ropsim.model import JointType, Mechanism, Payload
from ropsim.spatial import Array

_TYPES = {"chain": "f8[::1]", "b": "i8", "q": "f8", "qd": "f8", "R": "f8[:,::1]", "A": "f8[:,::1]"}


@cache
def _steps() -> tuple[SourceFunction, ...]:
    return (
        source_function(steps.place_joint, **_TYPES),
        source_function(steps.carry_motion, **_TYPES),
        source_function(steps.carry_force, **_TYPES),
        source_function(steps.move_joint, **_TYPES),
        source_function(steps.momentum, **_TYPES),
        source_function(steps.turn_momentum, **_TYPES),
        source_function(steps.spatial_inertia, **_TYPES),
        source_function(steps.carry_inertia, **_TYPES, into="f8[:,::1]"),
    )


@cache
def chain_torque_code() -> tuple[SourceFunction, ...]:
    """Return the functions of inverse dynamics; `chain_torques` is the last."""
    return (*_steps(), source_function(chain_torques))


@cache
def chain_acceleration_code() -> tuple[SourceFunction, ...]:
    """Return the functions of forward dynamics; `chain_accelerations` is the last."""
    return (*_steps(), source_function(chain_accelerations))


@cache
def chain_mass_matrix_code() -> tuple[SourceFunction, ...]:
    """Return the functions of the mass matrix; `chain_mass_matrix` is the last."""
    return (*chain_torque_code(), source_function(chain_mass_matrix))


def chain_numbers(structure: ArmStructure, numbers: Array) -> Array:
    """Return an arm as the loops take it; see `chain_loop`.

    Args:
        structure: geometry of the arm.
        numbers: as from `arm_numbers`.
    """
    bodies = numbers[3 : 3 + BODY * structure.n].reshape(structure.n, BODY)
    found = [numbers[:3]]
    for k in range(structure.n):
        slides = float(structure.types[k] is JointType.PRISMATIC)
        rotation, origin = structure.placements[k]
        found.append(np.array([slides, structure.offsets[k], *rotation, *origin, *bodies[k]]))
    rotation, origin = structure.interface
    return np.concatenate([*found, rotation, origin])


class LongArmFunctions:
    """Counterpart of `ArmFunctions` for arms of more than `MOST_JOINTS` joints: the same functions.

    Torques and accelerations cost time in proportion to the number of joints, the mass matrix to its square.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.
        engine: who runs the code.
    """

    def __init__(self, robot: Mechanism, payload: Payload | None, engine: Engine) -> None:
        check_model(robot)
        structure, numbers = structure_of(robot), arm_numbers(robot, payload)
        self._n = robot.n
        self._engine = engine
        self._chain = chain_numbers(structure, numbers)
        self._sides = drive_sides(structure, numbers)

    def rigid_inverse(self, q: Array, qd: Array, qdd: Array, wrench: Array, tau: Array) -> None:
        """Enter the torques of the rigid bodies only."""
        self._code(chain_torque_code())(q, qd, qdd, wrench, self._chain, tau)

    def inverse(self, q: Array, qd: Array, qdd: Array, wrench: Array, tau: Array) -> None:
        """Enter the torques with friction and motor inertia."""
        self.rigid_inverse(q, qd, qdd, wrench, tau)
        friction, inertia, share = self._sides(q, qd)
        tau += inertia * qdd + friction
        tau /= 1.0 - share * np.sign(tau)

    def forward(self, q: Array, qd: Array, tau: Array, qdd: Array) -> None:
        """Enter the accelerations with friction and motor inertia."""
        friction, inertia, share = self._sides(q, qd)
        net = tau - friction - share * abs(tau)
        self._code(chain_acceleration_code())(q, qd, net, inertia, self._chain, qdd)

    def mass_matrix(self, q: Array, M: Array) -> None:
        """Enter the mass matrix by rows with motor inertia, `M` of shape (n·n,)."""
        self._code(chain_mass_matrix_code())(q, self._chain, M)
        M[:: self._n + 1] += self._sides(q, np.zeros(self._n))[1]

    def _code(self, functions: tuple[SourceFunction, ...]) -> Compiled:
        return load(functions[-1].name, functions, self._engine)
