"""Closed chains move as differences of their closed positions say, for any joints and any cut."""

from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise

import numpy as np
import pytest

from ropsim.kinematics import forward_batch, frames_batch, jacobians_at, joint_motion, loop_freedom
from ropsim.kinematics.chain.closed_arrays import closed_arrays
from ropsim.kinematics.chain.closure import closed_states, states_along
from ropsim.kinematics.chain.closure_kernel import write_rows
from ropsim.model import JointType, Mechanism, RobotModel
from ropsim.spatial import Array, Pose
from support.closed_arms import (
    COUPLED_PALLETIZER,
    delta,
    five_bar,
    palletizer,
    six_axis_with_cylinders,
    two_link_with_cylinders,
)
from support.linkages import FOUR_BAR, SLIDER_CRANK
from support.random_loops import HELD, random_loop, with_joint_at_the_cut

STEP = 1e-4
GAP = 1e-12
FASTEST = 6.0  # of passive coordinates
BEFORE = 1e-9  # share of the way
FIVE_POINTS = np.array([1.0, -8.0, 8.0, -1.0]) / 12.0  # at -2, -1, 1, 2 steps
DIFFERENCES = 1e-8  # of central differences of fourth order, relative to derivatives
ARMS = (palletizer, two_link_with_cylinders, five_bar, delta, six_axis_with_cylinders)


@lru_cache(maxsize=1)
def sound_loops() -> tuple[Mechanism, ...]:
    made = [random_loop(seed) for seed in range(240)]
    return tuple(one for one in made if not loop_freedom(one))


def moved_from_home(loop: Mechanism, seed: int, reach: float = 0.3) -> Array:
    return np.asarray(loop.home + np.random.default_rng(seed).uniform(-reach, reach, (4, loop.n)))


def closable(loop: Mechanism, rows: Array) -> Array:
    results = closed_states(closed_arrays(loop), rows)[1]
    return np.asarray(rows[results[:, 0] == 1.0])


def test_there_are_hundreds_of_random_loops_that_can_move() -> None:
    assert len(sound_loops()) > 200


def test_random_loops_close_to_rounding() -> None:
    count = 0
    for number, loop in enumerate(sound_loops()):
        states, results = closed_states(closed_arrays(loop), moved_from_home(loop, number))
        followed = results[:, 0] == 1.0
        count += int(followed.sum())
        assert results[followed, 1].max(initial=0.0) <= GAP, loop.name
        assert np.isfinite(states).all()
    assert count > 600  # the others lock on the way


@pytest.mark.parametrize("kind", HELD, ids=[kind.value for kind in HELD])
def test_a_cut_holds_what_the_joint_holds_for_which_it_stands(kind: JointType) -> None:
    """A chain with that joint and a cut of all six directions has the same closed positions."""
    compared = 0
    for seed in range(500, 530):
        loop = random_loop(seed, kind)
        if loop_freedom(loop):
            continue
        joined = with_joint_at_the_cut(loop, kind)
        rows = closable(joined, closable(loop, moved_from_home(loop, seed)))
        frames, others = frames_batch(loop, rows), frames_batch(joined, rows)
        np.testing.assert_allclose(
            frames[:, :-1], others[:, : frames.shape[1] - 1], atol=1e-10, err_msg=loop.name
        )
        compared += len(rows)
    assert compared > 50


def test_speeds_and_accelerations_are_derivatives_of_closed_positions() -> None:
    compared = 0
    for number, loop in enumerate(sound_loops()[::4]):
        random = np.random.default_rng(number)
        speed, change = random.normal(size=(2, loop.n))
        ways = STEP * np.array([-2.0, -1.0, 0.0, 1.0, 2.0])[:, np.newaxis]
        for q in closable(loop, moved_from_home(loop, number, 0.2))[:2]:
            rows = q + ways * speed + 0.5 * ways * ways * change
            if len(closable(loop, rows)) < len(rows):
                continue
            along = joint_motion(loop, rows, speed + ways * change, np.tile(change, (5, 1)))
            if np.abs(along.speed).max() > FASTEST:
                continue  # differences say little next to a dead centre
            compared += 1
            first = FIVE_POINTS @ along.position[[0, 1, 3, 4]] / STEP
            second = FIVE_POINTS @ along.speed[[0, 1, 3, 4]] / STEP
            for found, expected in ((along.speed[2], first), (along.acceleration[2], second)):
                size = max(1.0, np.abs(expected).max()) ** 3
                np.testing.assert_allclose(found, expected, atol=DIFFERENCES * size, err_msg=loop.name)

    assert compared > 40


def test_coordinates_of_an_open_arm_are_linear_in_its_axes() -> None:
    robot = COUPLED_PALLETIZER
    q, speed = np.array([[0.1, 1.5, -0.2, 0.3]]), np.array([[0.4, -0.3, 0.2, 0.1]])
    found = joint_motion(robot, q, speed, 2.0 * speed)
    np.testing.assert_allclose(found.position[0, 3], -0.2 - 1.5)
    np.testing.assert_allclose(found.acceleration, 2.0 * found.speed)


@pytest.mark.parametrize("make", ARMS)
def test_the_jacobian_is_the_derivative_of_closed_poses(make: Callable[[], RobotModel]) -> None:
    robot = make()
    X_MT = Pose(np.array([0.05, -0.02, 0.1]), np.array([0.9, 0.1, -0.3, 0.2]))
    for q in robot.home + np.random.default_rng(1).uniform(-0.04, 0.04, (5, robot.n)):
        T, J = jacobians_at(robot, q[np.newaxis], X_MT)
        for axis in range(robot.n):
            ways = STEP * np.array([-2.0, -1.0, 1.0, 2.0])[:, np.newaxis] * np.eye(robot.n)[axis]
            poses = forward_batch(robot, q + ways) @ X_MT.matrix()
            change = np.tensordot(FIVE_POINTS, poses, 1) / STEP
            turn = change[:3, :3] @ T[0, :3, :3].T
            expected = [*change[:3, 3], turn[2, 1], turn[0, 2], turn[1, 0]]
            np.testing.assert_allclose(J[0, :, axis], expected, atol=DIFFERENCES)


def test_a_parallelogram_as_a_cut_is_the_coupled_arm() -> None:
    cut, coupled = palletizer(), COUPLED_PALLETIZER
    rows = coupled.home + np.random.default_rng(2).uniform(-0.4, 0.4, (40, 4))
    motion = joint_motion(cut, rows, 0.3 * rows, -0.2 * rows)  # by the rows of the cuts
    expected = joint_motion(coupled, rows, 0.3 * rows, -0.2 * rows)
    for name in ("position", "speed", "acceleration"):
        np.testing.assert_allclose(getattr(motion, name), getattr(expected, name), atol=1e-11)
    np.testing.assert_allclose(frames_batch(cut, rows), frames_batch(coupled, rows), atol=1e-12)
    X_MT = Pose(np.array([0.1, 0.2, 0.3]))
    np.testing.assert_allclose(
        jacobians_at(cut, rows, X_MT)[1], jacobians_at(coupled, rows, X_MT)[1], atol=1e-12
    )


@pytest.mark.parametrize("robot", [FOUR_BAR, SLIDER_CRANK, five_bar(), two_link_with_cylinders()])
def test_a_chain_followed_along_a_path_is_where_it_is_followed_from_home(robot: RobotModel) -> None:
    random, loops = np.random.default_rng(4), closed_arrays(robot)
    ends = robot.home + random.uniform(-0.04, 0.04, (20, robot.n))
    path = np.concatenate([one + np.linspace(0, 1, 25)[:, None] * (two - one) for one, two in pairwise(ends)])
    start = closed_states(loops, path[:1])[0][0]
    along, results = states_along(loops, path, start)
    assert (results[:, 0] == 1.0).all()
    np.testing.assert_allclose(along, closed_states(loops, path)[0], atol=1e-10)


def test_a_chain_locks_at_dead_centres_and_nowhere_else() -> None:
    """Just before it locks, the slopes of the rows by the passive coordinates are all but singular."""
    locked = 0
    for number, loop in enumerate(sound_loops()[::2]):
        loops, work = closed_arrays(loop), closed_arrays(loop).work()
        rows = moved_from_home(loop, number)
        for q, share in zip(rows, closed_states(loops, rows)[1][:, 0], strict=True):
            before = loop.home + (share - BEFORE) * (q - loop.home)
            state, result = states_along(loops, before[np.newaxis], loops.home)
            if share < 1.0 and result[0, 0] == 1.0:
                write_rows(loops.arm(), state[0], work)
                slopes = work.slopes @ loops.spread[:, loops.n : -1]
                values = np.linalg.svd(slopes, compute_uv=False)
                assert values[loops.rank - 1] < 1e-3 * values[0], loop.name
                locked += 1
    assert locked > 50


def test_random_loops_never_jump_to_another_assembly() -> None:
    """Along a path the passive coordinates change as fast as their speeds say, never more."""
    for number, loop in enumerate(sound_loops()[::3]):
        loops, random = closed_arrays(loop), np.random.default_rng(number)
        goal = loop.home + random.uniform(-1.0, 1.0, loop.n)
        rows = loop.home + np.linspace(0.0, 1.0, 81)[:, np.newaxis] * (goal - loop.home)
        states, results = states_along(loops, rows, loops.home)
        reached = int((results[:, 0] == 1.0).sum())
        assert (results[:reached, 0] == 1.0).all()
        assert np.isnan(states[reached:]).all()
        motion = joint_motion(loop, rows[:reached], np.tile((goal - loop.home) / 80.0, (reached, 1)))
        passive = states[:reached, loops.n :]
        step = np.diff(passive, axis=0)
        speeds = np.abs(motion.speed).max(axis=1)
        most = 2.0 * np.maximum(speeds[1:], speeds[:-1]) + 1e-9
        assert (np.abs(step).max(axis=1, initial=0.0) <= most).all(), loop.name
