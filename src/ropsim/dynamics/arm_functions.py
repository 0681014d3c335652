"""The generated functions of an arm, made on the first request."""

from collections.abc import Callable, Sequence
from functools import lru_cache

from ropsim.codegen import Compiled, Engine, Formula, GivenCode, Scalar, Tracer, default_engine
from ropsim.dynamics.long_arms.long_arm import LongArmFunctions
from ropsim.dynamics.loops.closed_arm import ClosedArmFunctions
from ropsim.dynamics.model_check import check_model
from ropsim.dynamics.structure import ArmStructure, arm_numbers, structure_of, traced_numbers
from ropsim.dynamics.traced.forward_dynamics import trace_solve
from ropsim.dynamics.traced.mass_matrix import trace_mass_matrix
from ropsim.dynamics.traced.newton_euler import Wrench, trace_inverse
from ropsim.dynamics.traced.traced_arm import TracedArm, trace_arm
from ropsim.dynamics.traced.traced_drives import Side, joint_sides
from ropsim.model import Mechanism, Payload


class ArmFunctions:
    """Compiled functions of one arm; each is generated and compiled (or loaded from disk) at its first use.

    All arrays are one-dimensional, contiguous float64; the last argument receives the result. The numbers of
    the arm are filled in; every arm of the same structure shares the code. Friction and motor inertia come
    from the robot's drives, zero without.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.
        engine: who runs the code.
    """

    def __init__(self, robot: Mechanism, payload: Payload | None, engine: Engine) -> None:
        check_model(robot)
        self._name = identifier(robot.name)
        self._structure = structure_of(robot)
        self._numbers = arm_numbers(robot, payload)
        self._engine = engine
        self._made: dict[str, Compiled] = {}

    @property
    def rigid_inverse(self) -> Compiled:
        """Return `f(q, qd, qdd, wrench, tau)`: torques of the rigid bodies only."""
        return self._function("rigid_inverse", rigid_inverse_code)

    @property
    def inverse(self) -> Compiled:
        """Return `f(q, qd, qdd, wrench, tau)`: torques with friction and motor inertia."""
        return self._function("inverse", inverse_code)

    @property
    def forward(self) -> Compiled:
        """Return `f(q, qd, tau, qdd)`: accelerations with friction and motor inertia."""
        return self._function("forward", forward_code)

    @property
    def mass_matrix(self) -> Compiled:
        """Return `f(q, M)`: mass matrix by rows with motor inertia, `M` of shape (n·n,)."""
        return self._function("mass_matrix", mass_matrix_code)

    def _function(self, name: str, code_of: Callable[[ArmStructure], GivenCode]) -> Compiled:
        if name not in self._made:
            code = code_of(self._structure)
            self._made[name] = code.bound(f"{self._name}_{name}", self._numbers, self._engine)
        return self._made[name]


AnyArmFunctions = ArmFunctions | LongArmFunctions | ClosedArmFunctions


@lru_cache(maxsize=256)
def _compiled(robot: Mechanism, payload: Payload | None, engine: Engine) -> AnyArmFunctions:
    check_model(robot)
    if robot.cuts:
        return ClosedArmFunctions(robot, payload, engine)
    return (LongArmFunctions if structure_of(robot).is_long else ArmFunctions)(robot, payload, engine)


def compiled(
    robot: Mechanism, payload: Payload | None = None, engine: Engine | None = None
) -> AnyArmFunctions:
    """Return the compiled functions of an arm.

    Models are compared by content: an equal one, in this process or a later one, is not compiled again; nor
    is one that differs in numbers alone.

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
    return _compiled(robot, payload, engine or default_engine())


@lru_cache(maxsize=64)
def rigid_inverse_code(structure: ArmStructure) -> GivenCode:
    """Return the code of `rigid_inverse`."""
    arm, (_, qd), qdd, tip, _ = _inverse_inputs(structure)
    return _inverse_code("rigid_inverse", trace_inverse(arm, qd, qdd, tip))


@lru_cache(maxsize=64)
def inverse_code(structure: ArmStructure) -> GivenCode:
    """Return the code of `inverse`."""
    arm, (q, qd), qdd, tip, drives = _inverse_inputs(structure)
    tau = trace_inverse(arm, qd, qdd, tip)
    for k, side in enumerate(joint_sides(structure, drives, arm.tracer, (q, qd))):
        tau[k] = side.needed(tau[k] + qdd[k] * side.inertia)
    return _inverse_code("inverse", tau)


@lru_cache(maxsize=64)
def forward_code(structure: ArmStructure) -> GivenCode:
    """Return the code of `forward`."""
    tracer, n = Tracer(), structure.n
    q, qd, tau = (tracer.variables(name, n) for name in ("q", "qd", "tau"))
    numbers = traced_numbers(tracer, structure)
    arm = trace_arm(tracer, structure, numbers, q)
    qdd = trace_forward(arm, qd, tau, joint_sides(structure, numbers.drives, tracer, (q, qd)))
    results = [(f"qdd[{k}]", qdd[k]) for k in range(n)]
    return GivenCode.of(Formula("forward", ("q", "qd", "tau", "qdd"), results))


def trace_forward(
    arm: TracedArm,
    qd: list[Scalar],
    tau: list[Scalar],
    sides: list[Side],
    outside: Sequence[Scalar] = (),
) -> list[Scalar]:
    """Return the joint accelerations.

    Args:
        arm: the arm.
        qd: joint speeds.
        tau: torques of the drives at the joints, before friction.
        sides: friction and inertia of the drives at the joints; empty without drives.
        outside: efforts at the axes from outside; empty for none.
    """
    bias = trace_inverse(arm, qd, [arm.tracer.constant(0.0)] * arm.n)
    right = [tau[k] - bias[k] for k in range(arm.n)]
    lower = trace_mass_matrix(arm)
    for k, side in enumerate(sides):
        right[k] = right[k] - side.friction.under(tau[k])
        lower[k][k] = lower[k][k] + side.inertia
    for k, effort in enumerate(outside):
        right[k] = right[k] + effort
    return trace_solve(lower, right)


@lru_cache(maxsize=64)
def mass_matrix_code(structure: ArmStructure) -> GivenCode:
    """Return the code of `mass_matrix`."""
    tracer, n = Tracer(), structure.n
    numbers = traced_numbers(tracer, structure)
    q = tracer.variables("q", n)
    lower = trace_mass_matrix(trace_arm(tracer, structure, numbers, q))
    rest = [tracer.constant(0.0)] * n
    for k, side in enumerate(joint_sides(structure, numbers.drives, tracer, (q, rest))):
        lower[k][k] = lower[k][k] + side.inertia
    entries = [(f"M[{n * i + j}]", lower[max(i, j)][min(i, j)]) for i in range(n) for j in range(n)]
    return GivenCode.of(Formula("mass_matrix", ("q", "M"), entries))


def identifier(name: str) -> str:
    """Return a robot name as part of a Python identifier."""
    return "arm_" + "".join(c if c.isascii() and c.isalnum() else "_" for c in name)[:40]


def _inverse_inputs(
    structure: ArmStructure,
) -> tuple[TracedArm, tuple[list[Scalar], list[Scalar]], list[Scalar], Wrench, list[list[Scalar]]]:
    tracer = Tracer()
    q, qd, qdd = (tracer.variables(name, structure.n) for name in ("q", "qd", "qdd"))
    fx, fy, fz, mx, my, mz = tracer.variables("wrench", 6)
    numbers = traced_numbers(tracer, structure)
    arm = trace_arm(tracer, structure, numbers, q)
    return arm, (q, qd), qdd, Wrench((fx, fy, fz), (mx, my, mz)), numbers.drives


def _inverse_code(name: str, tau: list[Scalar]) -> GivenCode:
    results = [(f"tau[{k}]", value) for k, value in enumerate(tau)]
    return GivenCode.of(Formula(name, ("q", "qd", "qdd", "wrench", "tau"), results))
