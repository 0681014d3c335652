"""Choices of the speed in bends: more programmed speed never costs time, and nothing is lost against one."""

from collections.abc import Callable

import numpy as np
import pytest

from ropsim.motion import ArcFault, JointLine, SplineFault, ToolLimits, ToolPath, arc, plan_time_law, spline
from ropsim.planning.testing import PathSegment, sections_of, tool_path_limit_choices, tool_path_limits
from ropsim.spatial import Pose
from support.examples import examples
from support.motion import RULES

SPEEDS = 0.05 * 1.25 ** np.arange(14)  # up to 0.9 m/s
SLOWER = 1.03
"""Of the time at a lower programmed speed; what changes with the speed is which cells make one path limit."""
ARMS = ((4.6, 46.0, 5.3, 23.0, 230.0), (2.0, 20.0, 3.14, 10.0, 100.0), (10.0, 200.0, 6.0, 50.0, 1000.0))
"""Acceleration and jerk of the TCP, then speed, acceleration and jerk of the orientation."""


def curve(random: np.random.Generator) -> ToolPath:
    """Return the spline through two to eight points at random, from millimetres to decimetres apart."""
    place, turn, poses, size = (
        np.zeros(3),
        np.array([1.0, 0.0, 0.0, 0.0]),
        [],
        10.0 ** random.uniform(-3, -0.5),
    )
    for _ in range(random.integers(3, 10)):
        poses.append(Pose(place, turn))
        place = place + random.normal(size=3) * size
        turn = turn + 0.3 * random.normal(size=4) * random.integers(0, 2)
    found = spline(poses)
    return curve(random) if isinstance(found, SplineFault) else found


def bend(random: np.random.Generator) -> ToolPath:
    """Return an arc of a random radius and angle; on every other one the tool turns."""
    radius, angle = 10.0 ** random.uniform(-2.5, 0.0), random.uniform(0.2, 6.0)
    turn = np.array([1.0, 0.0, 0.0, 0.0]) + 0.3 * random.normal(size=4) * random.integers(0, 2)
    points = (
        np.array([radius * np.cos(share * angle), radius * np.sin(share * angle), 0.0])
        for share in (0.0, 0.5, 1.0)
    )
    start, via, end = points
    found = arc(Pose(start), Pose(via), Pose(end, turn))
    assert not isinstance(found, ArcFault)
    return found


def least_time(path: ToolPath, limits: ToolLimits) -> float:
    """Return the time of a path with the bounds that are found to be the quickest."""
    (first, *others), bent = tool_path_limit_choices(path, limits)
    still = JointLine(np.zeros(1), np.ones(1))
    alone = PathSegment(0, still, path, Pose(), first, gentler=tuple(others), bend=bent)
    return sections_of([([alone], None)], RULES)[0].law.duration


def times(path: ToolPath, limits: ToolLimits) -> list[float]:
    """Return the times of a path with each choice, first that of the highest speeds."""
    return [plan_time_law(one).duration for one in tool_path_limit_choices(path, limits).choices]


@pytest.mark.parametrize("make", [curve, bend])
def test_no_path_gets_slower_when_the_programmed_speed_is_raised(
    make: Callable[[np.random.Generator], ToolPath],
) -> None:
    random = np.random.default_rng(11)
    for number in range(examples(100)):
        path, least = make(random), np.inf
        for speed in SPEEDS.tolist():
            time = least_time(path, ToolLimits(speed, *ARMS[number % len(ARMS)]))
            assert time <= SLOWER * least, (number, speed)
            least = min(least, time)


def test_curves_are_up_to_half_as_long_on_their_way_as_at_the_highest_speed_of_each_bend() -> None:
    random, shares = np.random.default_rng(12), []
    for number in range(30):
        path, limits = curve(random), ToolLimits(0.7, *ARMS[number % len(ARMS)])
        found = times(path, limits)
        assert found[0] == plan_time_law(tool_path_limits(path, limits)).duration
        shares.append(min(found) / found[0])
    assert np.median(shares) < 0.9
    assert min(shares) < 0.6


def test_a_path_that_is_slow_for_its_bends_has_a_single_choice() -> None:
    path = bend(np.random.default_rng(1))
    slow, quick = (ToolLimits(speed, *ARMS[0]) for speed in (1e-3, 3.0))
    assert len(tool_path_limit_choices(path, slow).choices) == 1
    assert len(tool_path_limit_choices(path, quick).choices) > 5
