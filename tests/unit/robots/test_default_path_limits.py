"""Limits of tool paths of the standard controller: from the maker, of the joints, or the same for all."""

from dataclasses import replace

import pytest

from ropsim import robots
from ropsim.model import ModelValueError, PathDefaults, PublishedPathLimits

CITED = {
    "gp25": (10.0, 8.6, 20.0),
    "gp7": (6.4, 8.7, 32.0),
    "iiwa14": (4.4, 1.9, 13.0),
    "irb120": (4.6, 5.3, 23.0),
    "irb1200_5_09": (5.7, 7.8, 27.0),
    "irb140": (5.3, 6.3, 27.0),
    "irb2400_16": (6.4, 6.8, 28.0),
    "irb4600_60_205": (5.9, 5.3, 21.0),
    "irb6640_180_255": (16.0, 3.1, 43.0),
    "kr210_r2700_2": (2.2, 3.5, 2.2),
    "kr6_r900_2": (5.6, 8.1, 25.0),
    "manutec_r3": (10.0, 3.5, 43.0),
    "panda": (13.0, 2.5, 25.0),
    "tx60": (6.3, 8.7, 31.0),
    "ur3e": (3.7, 3.3, 16.0),
    "ur5e": (5.7, 2.8, 20.0),
}
"""Acceleration [m/s²], speed [rad/s] and acceleration [rad/s²] of turning: of other samples, of the Panda its
maker's. Turning is not faster than 8.7 rad/s."""
CLOSE = 0.1
LEAST, MOST = PathDefaults(0.25, 0.3, 3.0, 0.1, 0.3, 3.0), PathDefaults(0.25, 20.0, 200.0, 8.7, 200.0, 2000.0)
"""Of a crane and of a small SCARA."""


@pytest.mark.parametrize("name", CITED)
def test_the_standard_controller_has_the_cited_limits(name: str) -> None:
    path = robots.default_controller(name).path
    found = path.acceleration, path.orientation_speed, path.orientation_acceleration
    assert found == pytest.approx(CITED[name], rel=CLOSE)
    assert (path.jerk, path.orientation_jerk) == pytest.approx((10.0 * found[0], 10.0 * found[2]))
    assert path.speed == PathDefaults().speed


@pytest.mark.parametrize("name", robots.names())
def test_every_arm_of_the_library_has_sensible_limits_and_says_where_they_come_from(name: str) -> None:
    controller = robots.default_controller(name)
    path = controller.path
    for field in ("acceleration", "jerk", "orientation_speed", "orientation_acceleration"):
        assert getattr(LEAST, field) <= getattr(path, field) <= getattr(MOST, field), field
    (origin,) = (one for one in controller.origins if one.parameters == "path limits")
    assert origin.kind.value == ("published" if name == "panda" else "derived")


def test_what_the_maker_publishes_goes_before_what_the_joints_can_do() -> None:
    robot = robots.load("irb120")
    of_joints, _ = robots.default_path_limits(robot)
    path, (origin,) = robots.default_path_limits(
        replace(robot, path_limits=PublishedPathLimits(acceleration=7.0, orientation_jerk=300.0))
    )
    assert path == replace(of_joints, acceleration=7.0, jerk=70.0, orientation_jerk=300.0)
    assert origin.source.startswith("acceleration, jerk of turning from the maker; full acceleration after")
    assert origin.kind.value == "derived"


def test_a_conveyor_has_the_same_for_all_and_no_origin() -> None:
    assert robots.default_path_limits(robots.conveyor(1.0, 0.5, 0.8)) == (PathDefaults(), ())


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
def test_a_published_limit_is_a_positive_number(value: float) -> None:
    with pytest.raises(ModelValueError, match="orientation speed of tool paths"):
        PublishedPathLimits(orientation_speed=value)
