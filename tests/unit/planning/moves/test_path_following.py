"""Paths of the tool become paths of the joints that lead the tool along them."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import forward, forward_batch
from ropsim.model import RobotModel
from ropsim.motion import Arc, Line, OrientationMode, ToolPath, arc
from ropsim.planning import Refusal
from ropsim.planning.testing import follow_path
from ropsim.robots import default_controller
from ropsim.spatial import Array
from support.cells import chain_of, one_station
from support.motion import CHAIN, FINE, PUMA, START, interface_pose, lin, shifted

ARMS = ["puma560", "ur10e", "irb4600_60_205", "scara", "cobra600", "stanford"]
MODES = [OrientationMode.FIXED_AXIS, OrientationMode.DRIVE_TRANSFORM]
MOVE = lin(None, FINE)
TRUE = 2e-8  # [m | -] of poses between samples: joints are true to about 1e-9 rad


def paths(robot: RobotModel, random: np.random.Generator) -> tuple[Array, list[ToolPath]]:
    """Return a start, and a line and an arc from there, of up to half a metre."""
    share = random.uniform(0.3, 0.7, robot.n)
    q = np.asarray(robot.lower_limits + share * (robot.upper_limits - robot.lower_limits))
    near = [q + random.normal(scale=0.1, size=robot.n) for _ in range(2)]
    start, via, end = (forward(robot, one) for one in (q, *near))
    curved = arc(start, via, end)
    found: list[ToolPath] = [Line(start, end, MODES[int(random.integers(2))])]
    return q, [*found, curved] if isinstance(curved, Arc) else found


@pytest.mark.parametrize("name", ARMS)
def test_the_joints_lead_the_tool_along_its_path(name: str) -> None:
    chain = chain_of(one_station("c", robots.load(name), default_controller(name)))
    random, count = np.random.default_rng(3), 0
    for _ in range(12):
        q_start, found = paths(chain.robot, random)
        for path in found:
            traced = follow_path(chain, path, q_start, MOVE)
            if isinstance(traced, Refusal):
                continue
            count += 1
            at = np.sort(random.uniform(0.0, path.length, 50))
            reached = forward_batch(chain.robot, traced[0].joints(at).q)
            assert np.abs(reached - path.tool(at).matrices).max() < TRUE
    assert count >= 8


def test_a_joint_limit_and_a_place_out_of_reach_refuse_a_path() -> None:
    home, start = interface_pose(PUMA.home), interface_pose(START)
    for path, q, code in (
        (Line(home, shifted(home, -1.1, 0.0, 0.0)), PUMA.home, "M503"),
        (Line(start, shifted(start, 3.0, 0.0, 0.0)), START, "M501"),
    ):
        found = follow_path(CHAIN, path, q, MOVE)
        assert isinstance(found, Refusal)
        assert found.diagnostics[0].code == code
