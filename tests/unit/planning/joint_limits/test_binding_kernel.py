"""At how many looks joints and tool are at their limits, beside formulas in whole arrays."""

import numpy as np

from ropsim import robots
from ropsim.kinematics import forward_batch
from ropsim.planning.testing import (
    Reached,
    four_in_sequence,
    limits_reached,
    put_on,
    sample_moves,
    segment_numbers,
    tool_on_segments,
    tool_reached,
)
from ropsim.spatial import Pose

SHARE = 0.98
PERIOD = 1e-3
ARM = robots.load("puma560")
TOOL = Pose.from_tuple((0.02, -0.03, 0.2, 0.6, 0.0, -0.8, 0.0))


def test_joints_are_counted_move_by_move() -> None:
    chosen = np.random.default_rng(1)
    qd, qdd = chosen.normal(size=(2, 60, 3))
    looks, starts = np.array([*range(0, 20, 3), *range(21, 58, 4)]), np.array([0, 7, 17])
    torque, most = chosen.normal(size=(len(looks), 3)), chosen.uniform(0.5, 2.0, (2, 4, 3))
    most[:, 3] *= 1e3
    counts, longest, reached = np.empty((2, 4, 3)), np.empty((2, 2)), np.empty(len(looks))
    at, first = looks.astype(float), starts.astype(float)
    limits_reached(qd, qdd, at, first, torque, most, PERIOD, SHARE, Reached(counts, longest, reached))
    jerk = (qdd[looks + 1] - qdd[looks]) / PERIOD
    sizes = np.abs(np.stack((qd[looks], qdd[looks], torque, jerk), axis=1))
    there = sizes >= SHARE * np.repeat(most, np.diff(starts), axis=0)
    np.testing.assert_array_equal(counts, [there[:7].sum(axis=0), there[7:].sum(axis=0)])
    np.testing.assert_array_equal(reached, there.any(axis=(1, 2)))
    np.testing.assert_array_equal(longest[:, 0], counts.reshape(2, -1).argmax(axis=1))
    np.testing.assert_array_equal(longest[:, 1], counts.max(axis=(1, 2)) / np.diff(starts))
    assert 0.0 < counts.sum() < there.size


def test_looks_are_evenly_spaced_and_leave_out_the_last_tick_of_a_move() -> None:
    rows, most = np.random.default_rng(4).normal(size=(3, 90, 2)), 8
    spans = np.array([[0.0, 3.0], [3.0, 20.0], [20.0, 29.0], [40.0, 90.0]])
    looks, starts, found = np.empty(32), np.empty(5), np.empty((3, 32, 2))
    sample_moves(rows[0], rows[1], rows[2], spans, most, looks, starts, found)
    wanted = [range(0, 2), range(3, 19, 2), range(20, 28), range(40, 89, 7)]
    assert starts.tolist() == [0, 2, 10, 18, 25]
    ticks = [tick for each in wanted for tick in each]
    assert looks[:25].tolist() == ticks
    np.testing.assert_array_equal(found[:, :25], rows[:, ticks])


def test_four_rows_are_taken_of_the_moves_that_are_chosen_as_far_as_there_are_any() -> None:
    q, chosen = np.random.default_rng(5).normal(size=(30, 3)), np.array([0.0, 2.0])
    looks, starts = np.array([0.0, 2.0, 5.0, 9.0, 20.0, 24.0, 28.0]), np.array([0.0, 3.0, 4.0, 7.0])
    reached = np.array([1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0])
    rows, here = np.empty((28, 3)), np.empty((2, 7))
    first = np.empty(3)
    four_in_sequence(q, looks, reached, starts, chosen, rows, here[0], here[1], first)
    kept = [0, 1, 2, 4, 5, 6]
    assert first.tolist() == [0, 3, 6]
    np.testing.assert_array_equal(here[:, :6], [looks[kept], reached[kept]])
    ticks = np.minimum(looks[kept].astype(int)[:, None] + np.arange(4), 29)
    np.testing.assert_array_equal(rows[:24], q[ticks.ravel()])


def test_tools_are_put_on_and_pieces_found_as_far_as_there_are_looks() -> None:
    poses = forward_batch(ARM, ARM.home + np.random.default_rng(6).normal(size=(12, ARM.n)))
    pieces, on = np.array([[2.0, 5.0], [5.0, 9.0]]), np.full(4, 7.0)
    wanted = poses @ TOOL.matrix()
    looks = np.array([1.0, 3.0, 5.0, 0.0])
    tool_on_segments(poses, np.array([0.0, 3.0]), TOOL.matrix()[None], looks, pieces, on)
    assert on.tolist() == [-1.0, 0.0, 1.0, 7.0]
    np.testing.assert_allclose(poses, wanted, rtol=0.0, atol=1e-15)


def test_a_look_lies_on_the_piece_that_has_begun_and_not_ended() -> None:
    pieces = np.array([[2.0, 5.0], [5.0, 5.0], [5.0, 9.0], [12.0, 14.0]])
    on = np.empty(15)
    segment_numbers(np.arange(15.0), pieces, on)
    assert on.tolist() == [-1, -1, 0, 0, 0, 2, 2, 2, 2, -1, -1, -1, 3, 3, -1]


def test_poses_of_the_tool_are_those_of_the_flange_with_the_frame_of_the_move() -> None:
    poses = forward_batch(ARM, ARM.home + np.random.default_rng(3).normal(size=(4 * 5, ARM.n)))
    tools = np.array([Pose().matrix(), TOOL.matrix()])
    wanted = np.concatenate((poses[:8], poses[8:] @ tools[1]))
    put_on(poses, np.array([0.0, 2.0, 5.0]), tools)
    np.testing.assert_allclose(poses, wanted, rtol=0.0, atol=1e-15)


def test_the_tool_is_counted_piece_by_piece() -> None:
    """On the first piece the orientation stands: nothing of it counts; looks on none count together."""
    chosen = np.random.default_rng(2)
    poses = forward_batch(ARM, ARM.home + chosen.normal(scale=0.1, size=(4 * 16, ARM.n)))
    poses[: 4 * 6, :3, :3] = poses[0, :3, :3]
    on, starts = (
        np.array([0.0] * 6 + [-1.0, 1.0, 1.0, -1.0] + [1.0] * 4 + [-1.0] * 2),
        np.array([0.0, 10.0, 16.0]),
    )
    X = poses.reshape(16, 4, 4, 4)
    steps = np.diff(X[:, :, :3, 3], axis=1)
    turns = X[:, :-1, :3, :3].transpose(0, 1, 3, 2) @ X[:, 1:, :3, :3]
    spins = 0.5 * np.stack([turns[:, :, k - 1, k - 2] - turns[:, :, k - 2, k - 1] for k in range(3)], axis=-1)
    sizes = np.stack(
        [
            np.linalg.norm(
                np.stack((one[:, 0], one[:, 1] - one[:, 0], np.diff(one, 2, axis=1)[:, 0])), axis=-1
            )
            for one in (steps, spins)
        ]
    )  # (kind, step or change, look)
    least = np.array([np.median(sizes[:, :, :10], axis=-1), np.median(sizes[:, :, 10:], axis=-1)])
    used = (np.arange(16.0) % 5 == 0.0).astype(float)
    counts, longest, idle = np.empty((2, 6)), np.empty((2, 2)), np.empty(16)
    tool_reached(poses, starts, on, least, used, counts, longest, idle)
    there = np.concatenate(
        (sizes[:, :, :10] >= least[0][:, :, None], sizes[:, :, 10:] >= least[1][:, :, None]), axis=2
    )
    there[1, :, :6] = False
    np.testing.assert_array_equal(counts[0], there[:, :, :10].sum(axis=-1).ravel())
    np.testing.assert_array_equal(counts[1], there[:, :, 10:].sum(axis=-1).ravel())
    np.testing.assert_array_equal(idle, np.where(there.any(axis=(0, 1)) | (used > 0.0), -1.0, on))
