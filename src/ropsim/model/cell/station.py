"""A station: a robot at its place in the cell with its controller, its tools and the program that it runs."""

from collections.abc import Mapping
from dataclasses import field
from typing import ClassVar

from ropsim.flow import prefix_of
from ropsim.model.cell.tool import Tool
from ropsim.model.controller import ControllerModel
from ropsim.model.findings.number_range import COORDINATE, Ranges, check_ranges
from ropsim.model.robots.robot import RobotModel
from ropsim.spatial import Array, Pose, frozen, record


@record
class Station:
    """A robot under its controller.

    Programs and the controller work in the base frame B of the robot: `in_base` is the way there.

    Attributes:
        name: unique among the stations and devices of the cell; `ROBOT` for the only one.
        robot: the arm.
        controller: its controller.
        X_WB: base frame in the world frame.
        tools: that it can carry, by name.
        default_tool: tool at program start, empty for none.
        start: joint coordinates at time 0 [rad | m], shape (n,); empty for the rest position.
        program: name of the program that it runs where the user names none.
        serves: whether its program serves programs of other stations, and is over when they are.

    Raises:
        ModelValueError: a number of it or of its controller is outside its range.
    """

    RANGES: ClassVar[Ranges] = {"X_WB": COORDINATE, "start": COORDINATE}

    name: str
    robot: RobotModel
    controller: ControllerModel
    X_WB: Pose = field(default_factory=Pose)
    tools: Mapping[str, Tool] = field(default_factory=dict)
    default_tool: str = ""
    start: Array = field(default_factory=lambda: frozen([]))
    program: str = "main"
    serves: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "start", frozen(self.start))
        controller = self.controller
        check_ranges(
            f"station `{self.name}`",
            {
                "": self,
                "controller.": controller,
                "controller.rates.": controller.rates,
                "controller.gains.": controller.gains,
                "controller.path.": controller.path,
                "controller.correction.": controller.correction,
                "controller.look_ahead.": controller.look_ahead,
                "controller.sensors.": controller.sensors,
                **{f"controller.sensors.{one.quantity}.": one for one in controller.sensors.sensors},
            },
        )

    @property
    def q_start(self) -> Array:
        """Return the joint coordinates at time 0 [rad | m], shape (n,)."""
        return self.start if len(self.start) else self.robot.home

    @property
    def prefix(self) -> str:
        """Return the prefix of the names of its bodies and channels: empty for `ROBOT`."""
        return prefix_of(self.name)
