"""Six turning joints of any geometry: all branches, against closed forms, a search and a published arm."""

from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    Method,
    chain_arrays,
    classes_missed,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    posture,
    solver_of,
)
from ropsim.kinematics.testing import (
    GeneralSixAxisSolver,
    eliminations,
    least_singular_values,
    numeric,
    recognise,
    starts,
    steps_of,
)
from ropsim.model import DhRow, RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.published_arms import published_arm, random_joints
from support.wrist_arms import arm, industrial

REACHED = 1e-9  # m, entries of the rotation matrix: what is promised
SAME = 1e-9  # rad
NEAR_SINGULAR = 1e-5  # rad: rounding by 1e-16 moves joints by its square root

NAMES = ("crx5ia", "crx10ia_l", "motoman_hc10", "fanuc_m430ia2p", "abb_crb15000_5_95")
ARMS = {name: published_arm(name) for name in NAMES}
ARMS |= {"random": random_arm(3, "RRRRRR"), "other": random_arm(4, "RRRRRR")}

by_arm = pytest.mark.parametrize("robot", ARMS.values(), ids=ARMS.keys())


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


def present(branches: Array) -> Array:
    return np.asarray(~np.isnan(branches[..., 0]))


def assert_reaching(robot: RobotModel, T: Array, branches: Array) -> None:
    reached = forward_batch(robot, branches[present(branches)])
    expected = np.repeat(T, present(branches).sum(axis=1), axis=0)
    np.testing.assert_allclose(reached, expected, rtol=0.0, atol=REACHED)


@pytest.mark.parametrize(
    ("name", "fixed"), [("crx10ia_l", (0.0, pi)), ("crx10ia_l", (0.0,)), ("motoman_hc10", (0.0,))]
)
def test_an_upright_upper_arm_loses_no_answer(name: str, fixed: tuple[float, ...]) -> None:
    robot = ARMS[name]
    Q = random_joints(robot, 40, 17)
    Q[:, 1 : 1 + len(fixed)] = fixed
    branches = solver_of(robot).branches(forward_batch(robot, Q), np.zeros(6))
    assert (present(branches).sum(axis=1) % 2 == 0).all()
    own = np.where(present(branches), apart(branches, Q[:, np.newaxis]), np.inf).min(axis=1)
    assert own.max() < SAME


def test_answers_whose_roots_share_a_space_are_each_found() -> None:
    """Where joint 2 of a CRX is 0 in four answers, its root is a fourfold one."""
    robot = ARMS["crx5ia"]
    Q = random_joints(robot, 150, 5)[[39, 8]]
    Q[:, 1] = 0.0
    branches = solver_of(robot).branches(forward_batch(robot, Q), np.zeros(6))
    assert present(branches).sum(axis=1).tolist() == [8, 8]
    upright = np.abs(branches[:, :, 1]) < SAME
    assert upright.sum(axis=1).tolist() == [4, 4]


def test_answers_that_stand_alone_are_kept_beside_a_motion_that_moves_no_interface() -> None:
    """With joints 2 and 3 at 0 and 180° a HC10 may move so; a search finds answers along the motion."""
    robot = ARMS["motoman_hc10"]
    Q = random_joints(robot, 100, 5)[[1, 3]]
    Q[:, 1:3] = 0.0, pi
    branches = solver_of(robot).branches(forward_batch(robot, Q), np.zeros(6))
    for rows in branches:
        least = least_singular_values(chain_arrays(robot), rows[present(rows)])
        assert (least > 1e-3).sum() == 4
        assert (least < 1e-6).any()


@by_arm
def test_every_answer_reaches_and_one_is_the_configuration_itself(robot: RobotModel) -> None:
    assert (solver_of(robot).name, solver_of(robot).method) == ("general six-axis", Method.ALGEBRAIC)
    Q = random_joints(robot, 100, seed=1)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    assert_reaching(robot, T, branches)
    assert np.nanmin(apart(branches, Q[:, None]), axis=1).max() < SAME


@by_arm
def test_the_elimination_that_is_asked_first_loses_no_answers(robot: RobotModel) -> None:
    """One that loses a fifth is regular for some arms; real roots of a polynomial come in pairs."""
    solver = solver_of(robot)
    assert isinstance(solver, GeneralSixAxisSolver)
    Q = random_joints(robot, 100, seed=6)
    found, _ = starts(solver.ways[0], forward_batch(robot, Q))
    assert (np.nanmin(apart(found, Q[:, None]), axis=1) < 1e-3).mean() > 0.95
    numbers = present(inverse_batch(robot, forward_batch(robot, Q))).sum(axis=1)
    assert (numbers % 2 == 0).mean() > 0.95


@by_arm
def test_a_search_from_many_starts_finds_no_other_answer(robot: RobotModel) -> None:
    T = forward_batch(robot, random_joints(robot, 10, seed=2))
    searched, branches = numeric(robot).branches(T, np.zeros(6)), inverse_batch(robot, T)
    for found, known in zip(searched, branches, strict=True):
        for q in found[present(found)]:
            assert np.nanmin(apart(known, q)) < NEAR_SINGULAR


@pytest.mark.parametrize("robot", [published_arm("ur5e_robot"), robots.load("puma560"), industrial()])
def test_it_has_the_answers_of_the_closed_forms(robot: RobotModel) -> None:
    solver = recognise(robot)
    assert isinstance(solver, GeneralSixAxisSolver)
    T = forward_batch(robot, random_joints(robot, 30, seed=3))
    for found, known in zip(solver.branches(T, np.zeros(6)), inverse_batch(robot, T), strict=True):
        expected = known[present(known)]
        assert present(found).sum() == len(expected)
        assert max(np.nanmin(apart(found, q)) for q in expected) < NEAR_SINGULAR


def test_all_sixteen_answers_of_the_arm_of_manseur_and_doty_are_found() -> None:
    """A robot manipulator with 16 real inverse kinematic solution sets, 1989; the pose has six digits."""
    a, d = (0.3, 1.0, 0.0, 1.5, 0.0, 0.0), (0.0, 0.0, 0.2, 0.0, 0.0, 0.0)
    alpha = (90.0, 1.0, 90.0, 1.0, 90.0, 1.0)
    robot = arm(tuple(DhRow(*one) for one in zip(a, map(radians, alpha), d, strict=True)))
    R = np.array(
        [[-0.760117, -0.641689, 0.102262], [0.133333, 0.0, 0.991071], [-0.635959, 0.766965, 0.085558]]
    )
    left, _, right = np.linalg.svd(R)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = left @ right, (-1.140175, 0.0, 0.0)
    (branches,) = inverse_batch(robot, T[None])
    assert present(branches).all()
    assert_reaching(robot, T[None], branches[None])
    assert min(apart(np.delete(branches, k, axis=0), q).min() for k, q in enumerate(branches)) > 0.01


@pytest.mark.parametrize("name", NAMES)
def test_poses_of_round_angles_are_solved_however_singular(name: str) -> None:
    """All joints at multiples of 45°: stretched, folded, axes in line, motions that move no interface."""
    robot = ARMS[name]
    Q = np.round(random_joints(robot, 30, seed=4) / (pi / 4)) * (pi / 4)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    assert_reaching(robot, T, branches)
    assert present(branches).any(axis=1).all()
    for q in Q[:8]:
        found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
        assert apart(found.solutions, q).min() < NEAR_SINGULAR


def test_answers_that_share_the_unknown_of_an_elimination_are_told_apart() -> None:
    """Both turns of a wrist have one joint 2, the unknown of this cut: each of its roots is a double one."""
    robot = industrial()
    (way,) = eliminations(steps_of(chain_arrays(robot)), (1,))
    assert way.order[2] == 1
    T = forward_batch(robot, random_joints(robot, 20, seed=3))
    found, known = starts(way, T)[0], inverse_batch(robot, T)
    near = [
        bool((apart(rows, q) < 1e-3).any())
        for rows, answers in zip(found, known, strict=True)
        for q in answers[present(answers)]
    ]
    assert np.mean(near) > 0.5  # the rule by which an elimination is good for an arm


@pytest.mark.parametrize("bend", [0.02, 0.06])
def test_a_nearly_stretched_arm_of_links_in_one_line_is_answered(bend: float) -> None:
    rows = zip((0.0, 0.5, 0.4, 0.3, 0.2, 0.1), (pi / 2, 0.3, pi / 2, -1.0, 1.2, 0.0), strict=True)
    robot, q = arm(tuple(DhRow(*one, 0.0) for one in rows)), bend * np.array([1.0, 1.0, -1.0, 1.0, 1.0, 1.0])
    T = forward_batch(robot, q[None])
    assert 1.49 < np.linalg.norm(T[0, :3, 3]) < 1.5  # less than a hundredth from the sum of its links
    branches = inverse_batch(robot, T)
    assert_reaching(robot, T, branches)
    assert np.nanmin(apart(branches, q)) < NEAR_SINGULAR


def test_answers_come_in_the_order_of_their_distance_without_names() -> None:
    robot = ARMS["crx5ia"]
    (q,) = random_joints(robot, 1, seed=5)
    found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
    away = apart(found.solutions, q)
    assert away[0] < SAME
    assert (np.diff(away) >= 0.0).all()
    assert {str(one) for one in found.postures} == {"unnamed"} == {str(posture(robot, q))}


def test_poses_that_are_none_and_poses_too_far_away_have_no_answers() -> None:
    robot = ARMS["random"]
    poses = np.tile(forward(robot, np.full(6, 0.3)).matrix(), (6, 1, 1))
    poses[1, 0, 0] = np.nan
    poses[2, :3, :3] *= -1.0
    poses[3, :3, 3] += 20.0
    poses[4, :3, :3] *= 1e200
    poses[5] = 0.0
    assert present(inverse_batch(robot, poses)).any(axis=1).tolist() == [True] + [False] * 5
    far = inverse(robot, Pose(np.array([20.0, 0.0, 0.0])))
    assert far.status is IkStatus.OUT_OF_REACH
    assert far.shortfall is not None
    assert far.shortfall.miss is not None
    assert 10.0 < far.shortfall.miss.distance < 20.0


def test_arms_with_other_joints_are_told_what_they_miss() -> None:
    missed = {types: classes_missed(random_arm(1, types)) for types in ("RRRRRP", "RRRRRRR")}
    assert missed["RRRRRP"]["general six-axis"] == "joint `6` is prismatic"
    assert missed["RRRRRRR"]["general six-axis"] == "it has 7 joints, the class has 6"


@pytest.mark.parametrize("row", [DhRow(a=0.3, alpha=0.0, d=0.1), DhRow(a=0.0, alpha=pi / 2, d=0.0)])
@pytest.mark.parametrize("count", [6, 7])
def test_axes_that_are_all_parallel_or_meet_in_one_point_have_no_elimination(row: DhRow, count: int) -> None:
    crooked = arm((row,) * count)
    name = {6: "general six-axis", 7: "general seven-axis"}[count]
    assert classes_missed(crooked)[name] == "its axes lie so that no elimination is regular"
    assert solver_of(replace(crooked, name="crooked")).method is Method.NUMERIC


ALONE = [
    ("motoman_hc10", (-180, -180, 0, 0, -90, 90), (-90, 101.98505, 35.90465, 90, -90, -156.08041)),
    (
        "motoman_hc10",
        (-123.47942, -180, 180, -54.19152, 90, -90),
        (92.32906, -164.6231, -144.09535, 90, 90, -110.52775),
    ),
    (
        "fanuc_m430ia2p",
        (-90, 0, 0, -145.3839, -90, -237.97404),
        (34.6161, 15.45727, -30.37167, 90, -90, 107.11156),
    ),
]
"""Where an arm can move without moving its interface, and an answer that stands alone beside that [deg]."""


@pytest.mark.parametrize(("name", "moving", "alone"), ALONE)
def test_answers_that_stand_alone_are_not_lost_among_those_of_an_arm_that_can_move(
    name: str, moving: tuple[float, ...], alone: tuple[float, ...]
) -> None:
    robot = published_arm(name)
    answers = inverse_batch(robot, forward_batch(robot, np.radians([moving])))[0]
    apart = np.abs((answers - np.radians(alone) + pi) % (2.0 * pi) - pi).max(axis=1)
    assert np.nanmin(apart) < 1e-5
