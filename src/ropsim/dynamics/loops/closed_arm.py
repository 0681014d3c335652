"""The functions of an arm with closed chains: kinematics closes them, generated code does the rest."""

import numpy as np

from ropsim.codegen import Compiled, Engine, bound, load
from ropsim.dynamics.diagnostics import LOOP_OUT_OF_REACH, LoopError
from ropsim.dynamics.loops.closed_code import closed_functions, traced_terms
from ropsim.dynamics.loops.plant_code import GAP
from ropsim.dynamics.loops.tree_motion import tree_motion
from ropsim.dynamics.structure import arm_numbers, structure_of
from ropsim.dynamics.traced.traced_drives import drive_sides
from ropsim.kinematics import loop_gaps
from ropsim.model import Mechanism, Payload
from ropsim.spatial import Array


def check_closed(robot: Mechanism, q: Array) -> None:
    """Make sure that closed chains close with the axes at q [rad | m], shape (n,).

    Raises:
        LoopError: M592, they do not.
    """
    gap = float(loop_gaps(robot, q[np.newaxis])[0])
    if not gap <= GAP:
        places = ", ".join(f"{one:.4g}" for one in q)
        message = f"closed chains of `{robot.name}` stay {gap:.3g} (m, rad) apart with the axes at {places}"
        hint = "choose coordinates that the chains can follow from the home position"
        raise LoopError(LOOP_OUT_OF_REACH.at(None, message, hint=hint, data={"gap": gap}))


def closed_coordinates(robot: Mechanism, q: Array) -> Array:
    """Return the coordinates that closed chains determine with the axes at q (n,), shape (p,) [rad | m].

    Raises:
        LoopError: M592, the chains do not close there.
    """
    check_closed(robot, q)
    return tree_motion(robot, q[np.newaxis])[0][0, robot.n :]


class ClosedArmFunctions:
    """Counterpart of `ArmFunctions` for arms with closed chains: the same functions, in closed positions.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.
        engine: who runs the code.
    """

    def __init__(self, robot: Mechanism, payload: Payload | None, engine: Engine) -> None:
        structure, numbers = structure_of(robot), arm_numbers(robot, payload)
        self._robot, self._structure, self._engine = robot, structure, engine
        self._constants = traced_terms(structure).constants(numbers)
        self._sides = drive_sides(structure, numbers)

    def rigid_inverse(self, q: Array, qd: Array, qdd: Array, wrench: Array, tau: Array) -> None:
        """Enter the torques of the rigid bodies and springs only."""
        check_closed(self._robot, q)
        y, yd, ydd = (one[0] for one in tree_motion(self._robot, q[None], qd[None], qdd[None]))
        self._code("closed_torques")(y, yd, ydd, wrench, self._constants, tau)

    def inverse(self, q: Array, qd: Array, qdd: Array, wrench: Array, tau: Array) -> None:
        """Enter the torques with friction and motor inertia."""
        self.rigid_inverse(q, qd, qdd, wrench, tau)
        friction, inertia, share = self._sides(q, qd)
        tau += inertia * qdd + friction
        tau /= 1.0 - share * np.sign(tau)

    def forward(self, q: Array, qd: Array, tau: Array, qdd: Array) -> None:
        """Enter the accelerations with friction and motor inertia."""
        check_closed(self._robot, q)
        y, yd, _ = (one[0] for one in tree_motion(self._robot, q[None], qd[None]))
        friction, inertia, share = self._sides(q, qd)
        net = tau - friction - share * abs(tau)
        self._code("closed_accelerations")(y, yd, net, np.array(inertia), self._constants, qdd)

    def mass_matrix(self, q: Array, M: Array) -> None:
        """Enter the mass matrix by rows with motor inertia, `M` of shape (n·n,)."""
        check_closed(self._robot, q)
        y, *_ = tree_motion(self._robot, q[None])
        self._code("closed_mass")(y[0], self._constants, M)
        M[:: self._robot.n + 1] += self._sides(q, np.zeros(self._robot.n))[1]

    def inverse_rows(self, q: Array, qd: Array, qdd: Array, tau: Array) -> None:
        """Enter for each row of a motion the result of `inverse` without wrench, shape (k, n)."""
        y, yd, ydd = tree_motion(self._robot, q, qd, qdd)
        bound(self._code("closed_rows"), self._constants)(y, yd, ydd, tau)
        for k in range(len(q)):
            friction, inertia, share = self._sides(q[k], qd[k])
            tau[k] += inertia * qdd[k] + friction
            tau[k] /= 1.0 - share * np.sign(tau[k])

    def _code(self, name: str) -> Compiled:
        return load(name, closed_functions(self._structure)[name], self._engine)
