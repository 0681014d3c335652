"""Tool frames of a run: which one is in force at a row, and where the tool is."""

import numpy as np

from ropsim import robots
from ropsim.kinematics import forward_batch
from ropsim.simulation.testing import ToolFrames
from ropsim.spatial import Pose, quaternions_from_matrices

ARM = robots.load("puma560")
FIRST = Pose.from_tuple((0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0))
SECOND = Pose.from_tuple((0.02, -0.03, 0.2, 0.6, 0.0, -0.8, 0.0))


def test_poses_of_the_tool_are_those_of_the_flange_with_the_frame_in_force() -> None:
    frames = ToolFrames.beginning_with(FIRST)
    frames.set(40, SECOND)
    frames.set(40, SECOND)
    frames.set(70, FIRST)
    ticks = np.arange(0.0, 100.0)
    share = np.linspace(0.0, 1.0, len(ticks))[:, None]
    q = (1.0 - share) * ARM.lower_limits + share * ARM.upper_limits
    flanges = forward_batch(ARM, q)
    found = frames.on(ticks, flanges.copy())
    in_force = [SECOND if 40.0 < tick <= 70.0 else FIRST for tick in ticks]
    assert [frames.at(tick) for tick in ticks] == in_force
    wanted = np.array([flange @ tool.matrix() for flange, tool in zip(flanges, in_force, strict=True)])
    np.testing.assert_allclose(found.matrices, wanted, rtol=0.0, atol=1e-15)
    turned = quaternions_from_matrices(wanted[:, :3, :3])
    np.testing.assert_allclose(found.quaternions, turned, rtol=0.0, atol=1e-14)
    assert (found.quaternions[:, 0] >= 0.0).all()


def test_a_half_turn_has_an_orientation_without_a_division_by_nothing() -> None:
    frames = ToolFrames.beginning_with(Pose())
    halves = np.array([np.diag(signs) for signs in ((1.0, -1, -1, 1), (-1.0, 1, -1, 1), (-1.0, -1, 1, 1))])
    found = frames.on(np.arange(3.0), halves)
    np.testing.assert_array_equal(np.abs(found.quaternions), np.eye(4)[1:])
