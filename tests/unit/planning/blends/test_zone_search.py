"""Ways into and out of zones: found in one compiled search, and the same where only the path knows itself."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import forward_batch
from ropsim.motion import (
    JointLine,
    JointMotionLimits,
    JointPath,
    JointSection,
    SampledPath,
    SynchronisedJoints,
)
from ropsim.planning.testing import tcp_path_of
from ropsim.spatial import Array, Pose

ROUNDING = 1e-10  # of the length of the path; zones are found to 1e-8 of them
PARAMETER = 1e-9  # [m]
ROBOTS = ("puma560", "stanford", "scara", "panda", "cobra600", "irb4600_60_205", "kr210_r2700_2")


class _Unknown:
    """A path of which nothing is known but what it tells."""

    def __init__(self, path: JointPath) -> None:
        self.length, self.joints = path.length, path.joints


def paths(rng: np.random.Generator, n: int, *, far: float) -> list[JointPath]:
    """Return a path of each kind that compiled loops know, and a section of one."""
    start = rng.uniform(-0.5, 0.5, n)
    end = start + far * rng.uniform(-1.0, 1.0, n)
    speed = rng.uniform(0.5, 3.0, n)
    s = np.linspace(0.0, 1.0, 41)[:, np.newaxis]
    rows = (1.0 - s) * start + s * end + 0.2 * far * np.sin(2.0 * np.pi * s)
    traced = SampledPath(0.7, rows)
    return [
        JointLine(start, end),
        SynchronisedJoints(start, end, JointMotionLimits(speed, 4.0 * speed, 40.0 * speed)),
        traced,
        JointSection(traced, 0.1, 0.6),
    ]


@pytest.mark.parametrize("name", ROBOTS)
def test_a_path_that_loops_know_is_left_and_entered_as_any_other(name: str) -> None:
    rng, robot = np.random.default_rng(5), robots.load(name)
    X_MT = Pose(np.array([0.02, -0.1, 0.15]), np.array([0.9, 0.1, 0.3, -0.2]))
    for far in (1e-3, 0.3, 3.0):
        for path in paths(rng, robot.n, far=far):
            known, asked = (tcp_path_of(robot, each, X_MT, None) for each in (path, _Unknown(path)))
            for zone in (0.0, 1e-6, 3e-3, 0.05, 5.0):
                for clip in (0.5 * path.length, 0.03 * path.length):
                    for one, other in (
                        (known.leave(zone, path.length - clip), asked.leave(zone, path.length - clip)),
                        (known.enter(zone, clip), asked.enter(zone, clip)),
                    ):
                        assert one[0] == pytest.approx(other[0], abs=ROUNDING * path.length)
                        assert one[1] == pytest.approx(other[1], abs=PARAMETER * 1e-3)


def test_the_distance_that_is_told_is_that_of_the_tcp() -> None:
    robot, X_MT = robots.load("puma560"), Pose(np.array([0.0, 0.0, 0.2]))
    for path in paths(np.random.default_rng(2), robot.n, far=1.0):

        def tcp(s: float, path: JointPath = path) -> Array:
            q = path.joints(np.array([s])).q
            return np.asarray((forward_batch(robot, q) @ X_MT.matrix())[0, :3, 3])

        way = tcp_path_of(robot, path, X_MT, None)
        for (place, told), end in ((way.leave(0.02, 0.0), path.length), (way.enter(0.02, path.length), 0.0)):
            assert told == pytest.approx(0.02, abs=PARAMETER)
            assert np.linalg.norm(tcp(place) - tcp(end)) == pytest.approx(told, abs=1e-12)


def test_a_path_of_no_numbers_is_taken_as_far_as_it_may() -> None:
    robot = robots.load("puma560")
    for path in (
        JointLine(np.full(6, np.nan), np.zeros(6)),
        _Unknown(JointLine(np.full(6, np.nan), np.zeros(6))),
    ):
        way = tcp_path_of(robot, path, Pose(), None)
        assert way.enter(0.02, 0.5)[0] == 0.5
        assert way.leave(0.02, 0.5)[0] == 0.5
