"""Inverse kinematics of arms of other makers, with the roundings of their files."""

from math import pi

import numpy as np
import pytest

from ropsim.kinematics import (
    IkOptions,
    Limits,
    Method,
    Snap,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    jacobian,
    posture,
    singular_distances,
    solver_of,
)
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.published_arms import TABLES, published_arm, random_joints

POSE_TOLERANCE = 1e-9
"""What the inverse kinematics promises [m, entries of the rotation matrix]."""
OWN_TOLERANCE = 1e-6
"""Near singularities rounding of 1e-16 moves angles by its square root [rad]."""
LAST_PLACE = 2.5e-16
"""So far rounding of their last places moves the numbers of a pose [m, entries of the matrix]."""
PRINTED = 1e-8
"""Angles and poses are printed to 1e-9; six angles act on at most 3 m [m, entries of the matrix]."""
FAR = 1e-2
"""From here on a configuration is far from its singularities [m, rad]: its posture has a name of its own."""

ARMS = {name: published_arm(name) for name in TABLES}
ROUNDED = {"kr6_r900_2", "kr210_r2700_2", "kr16_r1610_2", "kuka_kr5_arc", "kr10_r1100_2", "kr4_r600"}
ROUNDED |= {"kr560_r3100_2", "lbr_iisy3_r760", "kr120_r2700_2", "motoman_gp180"}
"""Their files give right angles as 1.570796327 or 1.5708."""
ROUNDED |= {"ur3e_robot", "ur5e_robot", "ur10e_robot"}
CLASSES = dict.fromkeys(("ur3e_robot", "ur5e_robot", "ur10e_robot"), "three parallel axes")
GENERAL = ("crx5ia", "crx10ia_l", "motoman_hc10", "fanuc_m430ia2p", "abb_crb15000_5_95")
CLASSES |= dict.fromkeys(GENERAL, "general six-axis") | {"motoman_sia20d": "S-R-S"}
CLASSES |= dict.fromkeys(("kuka_lbr_iiwa_14_r820", "franka_panda"), "general seven-axis")
"""All others have a spherical wrist."""
WRISTS = sorted(TABLES.keys() - CLASSES.keys())
CLOSED = sorted({*WRISTS, "ur3e_robot", "ur5e_robot", "ur10e_robot"})
METHODS = dict.fromkeys(("general six-axis", "general seven-axis"), Method.ALGEBRAIC)


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


def own_among(robot: RobotModel, q: Array) -> float:
    """Return how far the nearest answer is from the configuration that made the pose and is given as near."""
    answers = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q)).solutions
    return float(apart(answers, q).min(initial=np.inf))


@pytest.mark.parametrize("name", [name for name in TABLES if "poses" in TABLES[name]])
def test_the_chain_is_that_of_the_file(name: str) -> None:
    robot = ARMS[name]
    for row in TABLES[name]["poses"]:
        q, p, (x, y, z, w) = row[: robot.n], row[-7:-4], row[-4:]
        expected = Pose(np.array(p), np.array([w, x, y, z])).matrix()
        np.testing.assert_allclose(forward(robot, q).matrix(), expected, rtol=0.0, atol=PRINTED)


@pytest.mark.parametrize("name", TABLES)
def test_the_class_is_recognised_and_what_was_snapped_is_known(name: str) -> None:
    solver = solver_of(ARMS[name])
    assert solver.name == CLASSES.get(name, "spherical wrist")
    assert solver.method is METHODS.get(solver.name, Method.CLOSED_FORM)
    assert (solver.snapped_by != Snap()) == (name in ROUNDED)


def test_right_angles_written_as_1_5708_are_told_by_their_error() -> None:
    by = solver_of(ARMS["kr120_r2700_2"]).snapped_by
    assert by.angle == pytest.approx(1.5708 - pi / 2.0, rel=0.1)
    assert by.length < 1e-5


@pytest.mark.parametrize("name", CLOSED)
def test_every_answer_reaches_the_pose_and_one_is_the_configuration_itself(name: str) -> None:
    robot = ARMS[name]
    Q = random_joints(robot, 300, seed=1)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    present = ~np.isnan(branches[:, :, 0])
    reached = forward_batch(robot, branches[present])
    np.testing.assert_allclose(
        reached, np.repeat(T, present.sum(axis=1), axis=0), rtol=0.0, atol=POSE_TOLERANCE
    )
    nearest = np.nanmin(np.where(present, apart(branches, Q[:, None]), np.inf), axis=1)
    assert nearest.max() < OWN_TOLERANCE


@pytest.mark.parametrize("name", CLOSED)
def test_the_configuration_itself_is_an_answer_to_1e_9_rad_or_to_the_rounding_of_its_pose(name: str) -> None:
    robot = ARMS[name]
    Q = np.random.default_rng(1).uniform(robot.lower_limits, robot.upper_limits, (10_000, 6))
    own = np.nanmin(apart(inverse_batch(robot, forward_batch(robot, Q)), Q[:, None]), axis=1)
    for k in np.flatnonzero(own > 1e-9):
        least = float(np.linalg.svd(jacobian(robot, Q[k]), compute_uv=False)[-1])
        assert own[k] * least < LAST_PLACE, (k, own[k], least)


@pytest.mark.parametrize("name", WRISTS)
def test_rows_are_named_by_their_postures_and_names_are_unique(name: str) -> None:
    robot = ARMS[name]
    names = solver_of(robot).postures
    assert len(set(names)) == len(names) == 8
    seen = 0
    for rows in inverse_batch(robot, forward_batch(robot, random_joints(robot, 100, seed=2))):
        for q, expected in zip(rows, names, strict=True):
            left = None if np.isnan(q[0]) else singular_distances(robot, q)
            if left and min(left.shoulder, left.elbow, left.wrist) > FAR:
                assert posture(robot, q) == expected
                seen += 1
    assert seen > 300


@pytest.mark.parametrize("name", CLOSED)
def test_many_poses_have_the_answers_of_single_ones(name: str) -> None:
    robot = ARMS[name]
    T = forward_batch(robot, random_joints(robot, 20, seed=3))
    for X_BM, rows in zip(T, inverse_batch(robot, T), strict=True):
        np.testing.assert_array_equal(inverse_batch(robot, X_BM[None])[0], rows)
        single = inverse(robot, Pose.from_matrix(X_BM), IkOptions(Limits.IGNORE)).branches
        assert (np.isnan(single) == np.isnan(rows)).all()
        # the quaternion rounds the pose by 1e-16, a nearly stretched elbow turns that into 1e-8
        assert np.nanmax(apart(single, rows)) < OWN_TOLERANCE


SINGULAR = {
    "wrist straight": lambda Q: Q * [1, 1, 1, 1, 0, 1],
    "wrist nearly straight": lambda Q: Q * [1, 1, 1, 1, 1e-8, 1],
    "axes along those of the base": lambda Q: np.round(Q / (pi / 4)) * (pi / 4),
}


@pytest.mark.parametrize("kind", SINGULAR)
@pytest.mark.parametrize("name", CLOSED)
def test_the_arm_may_stay_where_it_is_in_a_singular_pose(name: str, kind: str) -> None:
    robot = ARMS[name]
    Q = SINGULAR[kind](random_joints(robot, 60, seed=4))
    assert max(own_among(robot, q) for q in Q) < OWN_TOLERANCE


@pytest.mark.parametrize("name", WRISTS)
def test_with_the_wrist_above_axis_1_the_arm_may_stay_where_it_is(name: str) -> None:
    robot = ARMS[name]
    found = 0
    for q in random_joints(robot, 40, seed=5):
        above = wrist_above_axis_1(robot, q)
        if above is not None:
            found += 1
            assert own_among(robot, above) < OWN_TOLERANCE
    assert found >= 5


def wrist_above_axis_1(robot: RobotModel, q: Array) -> Array | None:
    """Return q with joint 3 turned so that the wrist centre is abreast of axis 1; None where it cannot be."""

    def ahead(angle: float) -> float:
        """Return the signed distance; joint 1 turns the wrist the less the nearer it is."""
        turned = q.copy()
        turned[2] = angle
        left = singular_distances(robot, turned)
        assert left is not None
        side = 1.0 if posture(robot, turned).words[0] == "right" else -1.0
        return side * left.shoulder

    grid = np.linspace(-pi, pi, 60)
    values = np.array([ahead(angle) for angle in grid])
    crossings = np.flatnonzero(values[:-1] * values[1:] < 0.0)
    if len(crossings) == 0:
        return None
    low, high = grid[crossings[0]], grid[crossings[0] + 1]
    for _ in range(80):
        middle = (low + high) / 2.0
        low, high = (middle, high) if ahead(middle) * ahead(low) > 0.0 else (low, middle)
    found = q.copy()
    found[2] = low
    return found


@pytest.mark.parametrize("name", CLOSED)
def test_a_path_through_a_straight_wrist_has_no_jumps(name: str) -> None:
    """Joint 5 passes through 0 while all others move a little; each pose is asked with the answer before."""
    robot = ARMS[name]
    for q_middle in random_joints(robot, 6, seed=6) * [1, 1, 1, 1, 0, 1]:
        way = np.linspace(-1.0, 1.0, 81)[:, None] * [0.05, 0.04, -0.03, 0.02, 0.08, 0.03]
        path = q_middle + way
        q = path[0]
        for expected in path[1:]:
            found = inverse(robot, forward(robot, expected), IkOptions(Limits.IGNORE, near=q)).solutions
            nearest = found[int(np.argmin(apart(found, q)))]
            assert apart(nearest, q) < 0.02
            q = nearest
        assert apart(q, path[-1]) < 1e-3


def test_a_redundant_arm_stays_near_to_where_it_stands() -> None:
    robot = ARMS["kuka_lbr_iiwa_14_r820"]
    for q in random_joints(robot, 10, seed=8):
        beside = q + 0.03
        pose = forward(robot, q)
        nearest = inverse(robot, pose, IkOptions(Limits.IGNORE, near=beside)).solutions[0]
        np.testing.assert_allclose(forward(robot, nearest).matrix(), pose.matrix(), atol=POSE_TOLERANCE)
        assert apart(nearest, beside) < 3.0 * apart(q, beside)
