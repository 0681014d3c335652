"""At how many looks joints and tool are at their limits, beside formulas in whole arrays."""

import numpy as np

from ropsim import robots
from ropsim.controller.critical_kernel import joints_reached, tool_reached
from ropsim.kinematics import forward_batch
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
    counts, reached = np.empty((2, 4, 3)), np.empty(len(looks))
    at, first = looks.astype(float), starts.astype(float)
    joints_reached(qd, qdd, at, first, torque, most, PERIOD, SHARE, counts, reached)
    jerk = (qdd[looks + 1] - qdd[looks]) / PERIOD
    sizes = np.abs(np.stack((qd[looks], qdd[looks], torque, jerk), axis=1))
    there = sizes >= SHARE * np.repeat(most, np.diff(starts), axis=0)
    np.testing.assert_array_equal(counts, [there[:7].sum(axis=0), there[7:].sum(axis=0)])
    np.testing.assert_array_equal(reached, there.any(axis=(1, 2)))
    assert 0.0 < counts.sum() < there.size


def test_the_tool_is_counted_group_by_group() -> None:
    """The first group stands still in its orientation, of which nothing is counted."""
    chosen = np.random.default_rng(2)
    flanges = forward_batch(ARM, ARM.home + chosen.normal(scale=0.1, size=(4 * 16, ARM.n)))
    flanges[: 4 * 6, :3, :3] = flanges[0, :3, :3]
    starts, tools = np.array([0.0, 6.0, 16.0]), np.array([Pose().matrix(), TOOL.matrix()])
    wanted = np.concatenate((flanges[:24], flanges[24:] @ tools[1])).reshape(16, 4, 4, 4)
    steps = np.diff(wanted[:, :, :3, 3], axis=1)
    turns = wanted[:, :-1, :3, :3].transpose(0, 1, 3, 2) @ wanted[:, 1:, :3, :3]
    spins = 0.5 * np.stack([turns[:, :, k - 1, k - 2] - turns[:, :, k - 2, k - 1] for k in range(3)], axis=-1)
    sizes = np.stack(
        [
            np.linalg.norm(
                np.stack((one[:, 0], one[:, 1] - one[:, 0], np.diff(one, 2, axis=1)[:, 0])), axis=-1
            )
            for one in (steps, spins)
        ]
    )  # (kind, step or change, look)
    least = np.array([np.median(sizes[:, :, :6], axis=-1), np.median(sizes[:, :, 6:], axis=-1)])
    used = (np.arange(16.0) % 5 == 0.0).astype(float)
    poses, counts = flanges.copy(), np.empty((2, 7))
    tool_reached(poses, starts, tools, least, used, counts)
    np.testing.assert_allclose(poses, wanted.reshape(-1, 4, 4), rtol=0.0, atol=1e-15)
    for group, on in enumerate((slice(0, 6), slice(6, 16))):
        there = sizes[:, :, on] >= least[group][:, :, np.newaxis]
        there[1] &= group > 0
        np.testing.assert_array_equal(counts[group, :6], there.sum(axis=-1).ravel())
        assert counts[group, 6] == np.count_nonzero(~there.any(axis=(0, 1)) & (used[on] == 0.0))
