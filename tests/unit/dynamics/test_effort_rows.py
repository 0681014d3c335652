"""The torques of the drives along a motion."""

from dataclasses import replace
from unittest.mock import patch

import numpy as np
import pytest

from ropsim import dynamics, robots
from ropsim.codegen import Engine
from ropsim.codegen.testing import compiled
from ropsim.dynamics import EffortRows, effort_rows, inverse_dynamics
from ropsim.model import DcMotor, Drive, ElasticGear, Friction, Payload, RobotModel, VoltageAmplifier
from ropsim.spatial import Array
from support.arms import MOTOR, drive, random_arm, random_states
from support.mujoco_arm import MujocoArm
from support.mujoco_tree import MujocoTree
from support.trees import random_tree

BOX = Payload(2.0, np.array([0.1, 0.0, 0.2]), np.diag([0.1, 0.2, 0.15]))
WORN = drive(friction=Friction(1e-3, 0.3, -0.2))
SOFT = Drive(VoltageAmplifier(40.0, 10.0), MOTOR, ElasticGear(80.0, 1e4, 5.0), Friction(1e-3, 0.3, -0.2))
ROUNDING = (
    1e-12  # relative to the largest number: sums in another order, elementary functions of two libraries
)
ENGINES = 1e-9  # torques up to 1e3 in double arithmetic

ARMS = {
    "puma560": robots.load("puma560"),
    "coupled joints": robots.load("palletizer"),
    "no drives": random_arm(1, "RPR"),
    "elastic gears": random_arm(2, "RR", (SOFT, SOFT)),
    "one joint": random_arm(3, "P", (WORN,)),
    "thirteen joints": random_arm(7, "RRP" * 4 + "R", (WORN,) * 13),
    "thirteen joints without drives": random_arm(7, "RRP" * 4 + "R"),
}


def _rows(robot: RobotModel, count: int) -> tuple[Array, Array, Array]:
    states = random_states(robot, count)
    q, qd, qdd = (np.ascontiguousarray(states[:, k]) for k in range(3))
    qd[0] = 0.0
    return q, qd, qdd


def _python(robot: RobotModel) -> EffortRows:
    return effort_rows(robot, None, Engine.PYTHON)


def _close(found: Array, expected: Array) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=ROUNDING * np.abs(expected).max())


@pytest.mark.parametrize("payload", [None, BOX], ids=["empty", "loaded"])
def test_every_row_is_what_inverse_dynamics_says(payload: Payload | None) -> None:
    puma = ARMS["puma560"]
    q, qd, qdd = _rows(puma, 20)
    expected = [inverse_dynamics(puma, *row, payload=payload) for row in zip(q, qd, qdd, strict=True)]
    _close(effort_rows(puma, payload)(q, qd, qdd), np.array(expected))


@pytest.mark.parametrize("robot", ARMS.values(), ids=ARMS.keys())
def test_so_it_is_for_arms_of_all_kinds(robot: RobotModel) -> None:
    """In plain Python, as nothing of this is about who runs the code."""
    q, qd, qdd = _rows(robot, 4)
    tau, nothing = np.empty_like(q), np.zeros(6)
    inverse = dynamics.compiled(robot, BOX, Engine.PYTHON).inverse
    for row in zip(q, qd, qdd, tau, strict=True):
        inverse(*row[:3], nothing, row[3])
    _close(effort_rows(robot, BOX, Engine.PYTHON)(q, qd, qdd), tau)


@pytest.mark.parametrize("name", ["puma560", "coupled joints", "thirteen joints"])
def test_both_engines_agree(name: str) -> None:
    rows = _rows(ARMS[name], 4)
    one, other = (effort_rows(ARMS[name], BOX, engine)(*rows) for engine in Engine)
    _close(one, other)


@pytest.mark.parametrize("types", ["RRP", "RRPRRPRRPRRPR"])
def test_rigid_bodies_and_motor_inertia_agree_with_another_engine(types: str) -> None:
    motor = DcMotor(0.2, 0.2, 2.0, 1e-3, 1e-4)
    robot = random_arm(11, types, (drive(ratio=30.0, motor=motor),) * len(types))
    oracle = MujocoArm(robot)
    q, qd, qdd = _rows(robot, 10)
    tau = _python(robot)(q, qd, qdd)
    inertia = 1e-4 * 30.0**2  # what MuJoCo adds at each joint as armature
    expected = np.array([oracle.inverse(*row) for row in zip(q, qd, qdd, strict=True)])
    assert np.abs(inertia * qdd).max() > 0.1
    np.testing.assert_allclose(tau, expected, rtol=0, atol=ENGINES * np.abs(expected).max())


@pytest.mark.parametrize("seed", range(3))
def test_trees_with_couplings_agree_with_another_engine(seed: int) -> None:
    """By virtual work the efforts at the axes are Cᵀ times those at the joints of the uncoupled tree."""
    tree = random_tree(seed)
    oracle = MujocoTree(tree.robot)
    q, qd, qdd = _rows(tree.robot, 5)
    tau = _python(tree.robot)(q, qd, qdd)
    for k, row in enumerate(tau):
        joints = oracle.inverse(tree.C @ q[k] + tree.c, tree.C @ qd[k], tree.C @ qdd[k])
        np.testing.assert_allclose(row, tree.C.T @ joints, rtol=0, atol=ENGINES)


def test_coulomb_friction_is_nothing_at_standstill_and_whole_in_motion() -> None:
    dry = random_arm(4, "RP", (drive(ratio=-50.0, friction=Friction(0.0, 0.3, -0.2)),) * 2)
    q, still = np.zeros((3, 2)), np.zeros((3, 2))
    qd = np.array([[0.0, 0.0], [0.1, 0.1], [-0.1, -0.1]])
    smooth = replace(dry, drives=(drive(ratio=-50.0),) * 2)
    dry_part = _python(dry)(q, qd, still) - _python(smooth)(q, qd, still)
    expected = 50.0 * np.array([[0.0, 0.0], [0.3, 0.3], [-0.2, -0.2]])
    np.testing.assert_allclose(dry_part, expected, rtol=0, atol=1e-9)


def test_other_masses_frictions_motors_and_payloads_compile_nothing() -> None:
    puma = ARMS["puma560"]
    rows = _rows(puma, 3)
    before = effort_rows(puma)(*rows)
    heavier = replace(puma, links=tuple(replace(link, mass=1.1 * link.mass) for link in puma.links))
    worn = replace(
        puma, drives=tuple(replace(one, friction=Friction(1e-3, 0.4, -0.5)) for one in puma.drives)
    )
    with patch("ropsim.codegen.load.compiled", wraps=compiled) as asked:
        after = [
            effort_rows(robot, load)(*rows) for robot, load in ((heavier, None), (worn, None), (puma, BOX))
        ]
    assert asked.call_count == 0
    assert all((tau != before).any() for tau in after)


def test_equal_arms_and_payloads_share_their_function() -> None:
    one, other = random_arm(5, "RRR"), random_arm(5, "RRR")
    assert one is not other
    assert effort_rows(one, BOX, Engine.PYTHON) is effort_rows(other, replace(BOX), Engine.PYTHON)
    assert effort_rows(one, BOX, Engine.PYTHON) is not effort_rows(one, None, Engine.PYTHON)


@pytest.fixture(params=list(Engine), ids=lambda engine: engine.value)
def puma_rows(request: pytest.FixtureRequest) -> EffortRows:
    return effort_rows(ARMS["puma560"], None, request.param)


def test_no_rows_give_no_rows(puma_rows: EffortRows) -> None:
    nothing = np.empty((0, 6))
    assert puma_rows(nothing, nothing, nothing).shape == (0, 6)


def test_rows_with_gaps_and_read_only_rows_count_the_same_and_stay_as_they_are(puma_rows: EffortRows) -> None:
    states = random_states(ARMS["puma560"], 5)
    states.flags.writeable = False
    before = states.copy()
    parts = [np.ascontiguousarray(states[:, k]) for k in range(3)]
    np.testing.assert_array_equal(puma_rows(*(states[:, k] for k in range(3))), puma_rows(*parts))
    np.testing.assert_array_equal(states, before)


def test_a_row_that_is_not_finite_is_told_by_nan_and_spoils_no_other(puma_rows: EffortRows) -> None:
    q, qd, qdd = _rows(ARMS["puma560"], 3)
    good = puma_rows(q, qd, qdd)
    qd[1] = np.nan
    tau = puma_rows(q, qd, qdd)
    assert np.isnan(tau[1]).all()
    np.testing.assert_array_equal(tau[[0, 2]], good[[0, 2]])


@pytest.mark.parametrize("shape", [(3, 5), (2, 6), (6,), (3, 6, 1)])
def test_rows_that_do_not_fit_are_refused_by_name(puma_rows: EffortRows, shape: tuple[int, ...]) -> None:
    rows = np.zeros((3, 6))
    with pytest.raises(dynamics.StateShapeError, match=r"`qd` has shape .*; allowed is `\(3, 6\)`") as caught:
        puma_rows(rows, np.zeros(shape), rows)
    assert caught.value.diagnostic.code == "M570"


@pytest.mark.parametrize("shape", [(6,), (), (0,), (2, 3, 6)])
def test_what_is_no_table_of_rows_is_refused(puma_rows: EffortRows, shape: tuple[int, ...]) -> None:
    with pytest.raises(dynamics.StateShapeError, match="`q` has shape"):
        puma_rows(np.zeros(shape), np.zeros(shape), np.zeros(shape))


def test_an_arm_that_cannot_be_is_refused() -> None:
    broken = replace(random_arm(0, "RR"), links=())
    with pytest.raises(dynamics.JointCountError, match="has 0 links for 2 joints"):
        effort_rows(broken)
