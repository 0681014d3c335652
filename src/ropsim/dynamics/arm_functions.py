"""The generated functions of one arm, made when they are first asked for."""

from collections.abc import Callable
from functools import lru_cache

from ropsim.codegen import Compiled, Engine, Scalar, SourceFunction, Tracer, default_engine, emit, load
from ropsim.dynamics.drive_dc import reflected_inertia
from ropsim.dynamics.forward_dynamics import trace_solve
from ropsim.dynamics.friction import trace_friction
from ropsim.dynamics.mass_matrix import trace_mass_matrix
from ropsim.dynamics.model_check import check_model
from ropsim.dynamics.newton_euler import Wrench, trace_inverse
from ropsim.dynamics.traced_arm import TracedArm, trace_arm
from ropsim.model import RobotModel


class ArmFunctions:
    """Compiled functions of one arm; each is generated and compiled (or loaded from disk) at its first use.

    All arrays are one-dimensional, contiguous float64; `load` is `last_body(robot, payload)`, shape (10,);
    the last argument receives the result. Friction and motor inertia are those of the robot's drives, none
    without.

    Args:
        robot: the arm.
        engine: who runs the code.
    """

    def __init__(self, robot: RobotModel, engine: Engine) -> None:
        check_model(robot)
        self._robot = robot
        self._engine = engine

    @property
    def rigid_inverse(self) -> Compiled:
        """Return `f(q, qd, qdd, wrench, load, tau)`: torques of the rigid bodies only."""
        return self._function("rigid_inverse", emit_rigid_inverse)

    @property
    def inverse(self) -> Compiled:
        """Return `f(q, qd, qdd, wrench, load, tau)`: torques with friction and motor inertia."""
        return self._function("inverse", emit_inverse)

    @property
    def forward(self) -> Compiled:
        """Return `f(q, qd, tau, load, qdd)`: accelerations with friction and motor inertia."""
        return self._function("forward", emit_forward)

    @property
    def mass_matrix(self) -> Compiled:
        """Return `f(q, load, M)`: mass matrix by rows with motor inertia, `M` of shape (n·n,)."""
        return self._function("mass_matrix", emit_mass_matrix)

    def _function(self, name: str, emit_it: Callable[[RobotModel], SourceFunction]) -> Compiled:
        source = _source(self._robot, emit_it)
        return load(f"{identifier(self._robot.name)}_{name}", (source,), self._engine)


@lru_cache(maxsize=64)
def _compiled(robot: RobotModel, engine: Engine) -> ArmFunctions:
    return ArmFunctions(robot, engine)


def compiled(robot: RobotModel, engine: Engine | None = None) -> ArmFunctions:
    """Return the compiled functions of an arm.

    Models are compared by content: an equal one, in this process or a later one, is not compiled again.

    Args:
        robot: the arm.
        engine: who runs the code; None takes numba where it is installed.

    Raises:
        ChainTooLongError: the arm has more than `MOST_JOINTS` joints.
        ModelNumberError: a number of the model is not finite.
    """
    return _compiled(robot, engine or default_engine())


@lru_cache(maxsize=256)
def _source(robot: RobotModel, emit_it: Callable[[RobotModel], SourceFunction]) -> SourceFunction:
    return emit_it(robot)


def emit_rigid_inverse(robot: RobotModel) -> SourceFunction:
    """Return the source of `rigid_inverse`."""
    arm, qd, qdd, tip = _inverse_inputs(robot)
    return _emit_inverse("rigid_inverse", trace_inverse(arm, qd, qdd, tip))


def emit_inverse(robot: RobotModel) -> SourceFunction:
    """Return the source of `inverse`."""
    arm, qd, qdd, tip = _inverse_inputs(robot)
    tau = trace_inverse(arm, qd, qdd, tip)
    for k, drive in enumerate(robot.drives):
        tau[k] = tau[k] + qdd[k] * reflected_inertia(drive) + trace_friction(drive, qd[k])
    return _emit_inverse("inverse", tau)


def emit_forward(robot: RobotModel) -> SourceFunction:
    """Return the source of `forward`."""
    tracer = Tracer()
    n = robot.n
    q, qd, tau = (tracer.variables(name, n) for name in ("q", "qd", "tau"))
    qdd = trace_forward(robot, trace_arm(tracer, robot, q, tracer.variables("load", 10)), qd, tau)
    return emit("forward", ("q", "qd", "tau", "load", "qdd"), [(f"qdd[{k}]", qdd[k]) for k in range(n)])


def trace_forward(robot: RobotModel, arm: TracedArm, qd: list[Scalar], tau: list[Scalar]) -> list[Scalar]:
    """Return the joint accelerations under the drive torques `tau`, with friction and motor inertia."""
    bias = trace_inverse(arm, qd, [arm.tracer.constant(0.0)] * arm.n)
    right = [tau[k] - bias[k] for k in range(arm.n)]
    for k, drive in enumerate(robot.drives):
        right[k] = right[k] - trace_friction(drive, qd[k])
    return trace_solve(_trace_full_mass_matrix(robot, arm), right)


def emit_mass_matrix(robot: RobotModel) -> SourceFunction:
    """Return the source of `mass_matrix`."""
    tracer = Tracer()
    n = robot.n
    arm = trace_arm(tracer, robot, tracer.variables("q", n), tracer.variables("load", 10))
    lower = _trace_full_mass_matrix(robot, arm)
    entries = [(f"M[{n * i + j}]", lower[max(i, j)][min(i, j)]) for i in range(n) for j in range(n)]
    return emit("mass_matrix", ("q", "load", "M"), entries)


def identifier(name: str) -> str:
    """Return a robot name as part of a Python identifier."""
    return "arm_" + "".join(c if c.isascii() and c.isalnum() else "_" for c in name)[:40]


def _trace_full_mass_matrix(robot: RobotModel, arm: TracedArm) -> list[list[Scalar]]:
    lower = trace_mass_matrix(arm)
    for k, drive in enumerate(robot.drives):
        lower[k][k] = lower[k][k] + reflected_inertia(drive)
    return lower


def _inverse_inputs(robot: RobotModel) -> tuple[TracedArm, list[Scalar], list[Scalar], Wrench]:
    tracer = Tracer()
    q, qd, qdd = (tracer.variables(name, robot.n) for name in ("q", "qd", "qdd"))
    fx, fy, fz, mx, my, mz = tracer.variables("wrench", 6)
    arm = trace_arm(tracer, robot, q, tracer.variables("load", 10))
    return arm, qd, qdd, Wrench((fx, fy, fz), (mx, my, mz))


def _emit_inverse(name: str, tau: list[Scalar]) -> SourceFunction:
    results = [(f"tau[{k}]", value) for k, value in enumerate(tau)]
    return emit(name, ("q", "qd", "qdd", "wrench", "load", "tau"), results)
