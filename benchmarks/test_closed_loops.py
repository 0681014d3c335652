"""Closed chains: a step beside Pinocchio, a parallelogram beside the serial arm, a pose of a delta."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from measuring import Measure, processor_seconds

from ropsim import codegen
from ropsim.codegen import Engine, SourceFunction
from ropsim.dynamics import arm_numbers, forward_dynamics, free_motion, structure_of
from ropsim.dynamics.arm_functions import forward_code
from ropsim.kinematics import IkOptions, forward, inverse, joint_motion, solver_of, without_linear_loops
from ropsim.model import BASE_LINK, LoopCut, RobotModel, passive_coordinates
from ropsim.spatial import Array, Pose
from support.closed_arms import COUPLED_PALLETIZER, CRANK, IN_PLANE, LOWER_ARM, at, delta, five_bar

STEP, STEPS = 1e-3, 2000
PALLETIZER = COUPLED_PALLETIZER
COLUMN, LOWER, LEVER, ELBOW, ROD, FLANGE = 0, 1, 2, 3, 4, 9


def start_of(robot: RobotModel) -> tuple[Array, Array]:
    """Return coordinates and speeds of axes and chains at home, with the axes in motion."""
    motion = joint_motion(robot, [robot.home], [np.linspace(1.0, -1.0, robot.n)])
    places = [*robot.axes, *passive_coordinates(robot)]
    return motion.position[0, places], motion.speed[0, places]


class Pinocchio:
    """A mechanism of turning joints with its cuts as constraints, integrated from Python."""

    def __init__(self, robot: RobotModel) -> None:
        pin: Any = pytest.importorskip("pinocchio")
        self._pin, self.model, ids = pin, pin.Model(), {BASE_LINK: 0}
        for number, (joint, link) in enumerate(zip(robot.joints, robot.links, strict=True)):
            kind, where = pin.JointModelRZ(), pin.SE3(joint.placement.matrix())
            ids[number] = self.model.addJoint(ids[joint.parent], kind, where, joint.name)
            body = pin.Inertia(link.mass, link.com, link.inertia)
            self.model.appendBodyToJoint(ids[number], body, pin.SE3.Identity())
        self.model.gravity.linear = robot.gravity
        self._cuts = pin.StdVec_RigidConstraintModel()
        for cut in robot.cuts:
            ends = (pin.SE3(cut.X_first.matrix()), pin.SE3(cut.X_second.matrix()))
            self._cuts.append(
                pin.RigidConstraintModel(
                    pin.ContactType.CONTACT_3D,
                    self.model,
                    ids[cut.first],
                    ends[0],
                    ids[cut.second],
                    ends[1],
                    pin.ReferenceFrame.LOCAL,
                )
            )
        self._data = self.model.createData()
        self._cut_data = pin.StdVec_RigidConstraintData()
        for one in self._cuts:
            self._cut_data.append(one.createData())
        self._settings = pin.ProximalSettings(1e-12, 1e-10, 10)
        pin.initConstraintDynamics(self.model, self._data, self._cuts, self._cut_data)

    def accelerations(self, q: Array, v: Array, tau: Array) -> Array:
        """Return the accelerations under the constraints."""
        found: Array = self._pin.constraintDynamics(
            self.model, self._data, q, v, tau, self._cuts, self._cut_data, self._settings
        )
        return found

    def run(self, q: Array, v: Array, steps: int) -> tuple[Array, Array]:
        """Return the state after steps of the classical Runge-Kutta method, without projection."""
        tau, h, rates = np.zeros(len(q)), STEP, self.accelerations
        for _ in range(steps):
            a1 = rates(q, v, tau).copy()
            v2 = v + 0.5 * h * a1
            a2 = rates(q + 0.5 * h * v, v2, tau).copy()
            v3 = v + 0.5 * h * a2
            a3 = rates(q + 0.5 * h * v2, v3, tau).copy()
            v4 = v + h * a3
            a4 = rates(q + h * v3, v4, tau)
            q, v = q + h / 6.0 * (v + 2.0 * (v2 + v3) + v4), v + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4)
        return q, v


def test_a_step_of_a_closed_chain(benchmark: Any) -> None:
    """A five-bar falls: Runge-Kutta with projection, beside Pinocchio's constraint dynamics from Python."""
    robot = replace(five_bar(), gravity=np.array([0.0, -9.81, 0.0]))
    other, (y, yd) = Pinocchio(robot), start_of(robot)
    order = [*robot.axes, *passive_coordinates(robot)]
    q, v = np.empty(len(y)), np.empty(len(y))
    q[order], v[order] = y, yd
    q_end, _ = other.run(q, v, 200)
    ours = free_motion(robot, y, yd, STEP, 200, every=200)
    np.testing.assert_allclose(q_end[order], ours.y[-1], atol=1e-6)

    def own() -> None:
        free_motion(robot, y, yd, STEP, STEPS, every=STEPS)

    def pinocchio() -> None:
        other.run(q, v, STEPS // 10)

    measure = Measure(benchmark)
    (seconds, reference), _ = measure(lambda: processor_seconds(own, pinocchio), rounds=3)
    measure.figure("microseconds a step", 1e6 * seconds / STEPS)
    measure.figure("time over that of Pinocchio", seconds / (10.0 * reference), most=0.5)


REPEAT = SourceFunction(
    "repeat_forward",
    "void(f8[::1], f8[::1], f8[::1], f8[::1], f8[::1], i8)",
    """\
def repeat_forward(q, qd, tau, constants, qdd, times):
    for _ in range(times):
        forward(q, qd, tau, constants, qdd)
        q[0] += 1e-9 * qdd[0]
""",
)


def repeated(robot: RobotModel, times: int = 50_000) -> Callable[[], None]:
    """Return forward dynamics of an arm, called so often in compiled code."""
    code = forward_code(structure_of(robot))
    function = codegen.load("repeat", (code.functions[0], REPEAT), Engine.NUMBA)
    constants, n = code.constants(arm_numbers(robot)), robot.n

    def call() -> None:
        function(np.array(robot.home), np.full(n, 0.3), np.zeros(n), constants, np.zeros(n), times)

    call()
    return call


def arm_of(numbers: tuple[int, ...], axes: tuple[int, ...], cuts: tuple[LoopCut, ...]) -> RobotModel:
    """Return bodies of the palletizer as an arm of their own, its flange on the forearm."""
    joints, place = PALLETIZER.joints, {number: k for k, number in enumerate(numbers)}
    parents = {FLANGE: ELBOW}
    moved = tuple(
        replace(joints[k], parent=place.get(parents.get(k, joints[k].parent), BASE_LINK)) for k in numbers
    )
    links = tuple(PALLETIZER.links[k] for k in numbers)
    tip = len(numbers) - 1
    return replace(PALLETIZER, joints=moved, links=links, couplings=(), cuts=cuts, axes=axes, tip=tip, dh=())


def test_an_arm_with_a_parallelogram_beside_the_serial_one(benchmark: Any) -> None:
    """Column, lower arm, forearm and flange, with and without lever and rod of a parallelogram as a cut."""
    serial = arm_of((COLUMN, LOWER, ELBOW, FLANGE), (0, 1, 2, 3), ())
    cut = LoopCut(3, at(-CRANK), 4, at(LOWER_ARM), IN_PLANE)
    closed = arm_of((COLUMN, LOWER, LEVER, ELBOW, ROD, FLANGE), (0, 1, 2, 5), (cut,))
    coupled = without_linear_loops(closed)
    state = coupled.home, np.full(4, 0.3), np.zeros(4)
    np.testing.assert_allclose(forward_dynamics(closed, *state), forward_dynamics(coupled, *state), rtol=1e-9)
    measure, (one, other) = Measure(benchmark), (repeated(coupled), repeated(serial))
    (seconds, reference), _ = measure(lambda: processor_seconds(one, other, rounds=15), rounds=3)
    measure.figure("microseconds", 1e6 * seconds / 50_000)
    measure.figure("time over that of the serial arm", seconds / reference, most=1.3)


def test_a_pose_of_a_delta(benchmark: Any) -> None:
    """All branches of a pose."""
    robot, options = delta(), IkOptions(near=delta().home)
    random = np.random.default_rng(0)
    poses: list[Pose] = [forward(robot, robot.home + random.uniform(-0.3, 0.3, 3)) for _ in range(10)]
    assert solver_of(robot).name == "plate on rods"

    def solve() -> None:
        for pose in poses:
            inverse(robot, pose, options)

    solve()
    measure = Measure(benchmark)
    (seconds,), _ = measure(lambda: processor_seconds(solve, rounds=9), rounds=3)
    measure.figure("milliseconds a pose", 1e3 * seconds / len(poses), most=4.0)
