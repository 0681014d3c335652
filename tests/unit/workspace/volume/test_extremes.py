"""How far and how high a point comes: the search ends where nothing more is won."""

import pytest

from ropsim import robots
from ropsim.model import RobotModel
from ropsim.spatial import Array
from ropsim.workspace import MovedPoint, PointKind, moved_point
from ropsim.workspace.ranges import axis_ranges
from ropsim.workspace.volume.extremes import extremes
from ropsim.workspace.volume.sweep import sweep_of

LOOKS = 1_000
"""Times that all searches together look where the point is; one that followed the last bits needed 42,000."""


def test_the_search_does_not_follow_the_last_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    """The flange of this arm is farthest out along a ridge: any turn of the last axes is as good."""
    robot = robots.load("irb140")
    point, ranges = moved_point(robot, PointKind.FLANGE), axis_ranges(robot)
    sweep = sweep_of(robot, point, ranges)
    looks: list[int] = []
    positions = MovedPoint.positions

    def counted(self: MovedPoint, robot: RobotModel, Q: Array) -> Array:
        looks.append(len(Q))
        return positions(self, robot, Q)

    monkeypatch.setattr(MovedPoint, "positions", counted)
    found = extremes(robot, point, sweep, ranges)
    assert len(looks) < LOOKS
    for one in found:  # each is a place that the arm takes
        assert ((ranges.lower <= one.q) & (one.q <= ranges.upper)).all()
    assert [one.value for one in found] == pytest.approx([0.0, 0.875, -0.155513, 1.157], abs=1e-6)
