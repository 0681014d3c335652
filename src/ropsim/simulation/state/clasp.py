"""A gripper that is still closed on a part which another one has taken over."""

from dataclasses import dataclass

from ropsim.model import Tool
from ropsim.simulation.state.station_run import StationRun
from ropsim.spatial import Array


@dataclass(slots=True)
class Clasp:
    """A gripper that is closed on a part that hangs on another one.

    Attributes:
        at: its station.
        tool: the gripper.
        part: name.
        point: of the part, where the TCP of the gripper was when the other one took over, in the object
            frame [m], shape (3,).
        seen: tick of the cell's clock up to which nothing was wrong.
    """

    at: StationRun
    tool: Tool
    part: str
    point: Array
    seen: int
