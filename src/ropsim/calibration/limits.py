"""The limits that calibration determines, and a controller under them."""

from dataclasses import replace

import numpy as np

from ropsim.model import ControllerModel, LookAhead, PathDefaults, Station
from ropsim.spatial import Array, frozen, record

ORDERS = 3
"""Speed, acceleration, jerk."""


@record
class MotionSettings:
    """Limits of a controller.

    Attributes:
        joints: speed, acceleration and jerk of each axis [rad | m, by s, s², s³], shape (3, n).
        tool: the same on tool paths where the program says nothing, of the TCP [m] and of the orientation
            [rad], shape (3, 2).
        look_ahead: how far beyond the present move the path is known.
    """

    joints: Array
    tool: Array
    look_ahead: LookAhead

    def __post_init__(self) -> None:
        object.__setattr__(self, "joints", frozen(self.joints))
        object.__setattr__(self, "tool", frozen(self.tool))

    @property
    def all(self) -> Array:
        """Return all limits in one row, joints first, shape (3n + 6,)."""
        return np.concatenate((self.joints.ravel(), self.tool.ravel()))

    def with_all(self, limits: Array) -> "MotionSettings":
        """Return settings with other limits, in the order of `all`."""
        count = self.joints.size
        joints, tool = limits[:count].reshape(self.joints.shape), limits[count:].reshape(self.tool.shape)
        return MotionSettings(joints, tool, self.look_ahead)

    def scaled(self, joints: Array, tool: Array) -> "MotionSettings":
        """Return settings whose speeds, accelerations and jerks are multiplied, each by shape (3,)."""
        return MotionSettings(self.joints * joints[:, None], self.tool * tool[:, None], self.look_ahead)


def settings_of(station: Station) -> MotionSettings:
    """Return the limits of the controller of a station."""
    robot, path = station.robot, station.controller.path
    tool = [
        [path.speed, path.orientation_speed],
        [path.acceleration, path.orientation_acceleration],
        [path.jerk, path.orientation_jerk],
    ]
    joints = np.array([robot.max_speeds, robot.max_accelerations, robot.max_jerks])
    return MotionSettings(joints, np.array(tool), station.controller.look_ahead)


def under(controller: ControllerModel, settings: MotionSettings) -> ControllerModel:
    """Return a controller that keeps to other limits on tool paths and looks as far ahead as they say."""
    (v, w), (a, wa), (j, wj) = settings.tool.tolist()
    return replace(controller, path=PathDefaults(v, a, j, w, wa, wj), look_ahead=settings.look_ahead)
