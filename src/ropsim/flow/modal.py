"""The modal state under which a robot instruction is executed (ICR class 05)."""

from dataclasses import field

from ropsim.core import frozen_dataclass
from ropsim.spatial import Pose


@frozen_dataclass
class ModalState:
    """Frame, tool, speeds and zone in force; every robot instruction carries a snapshot.

    Attributes:
        frame: name of the task frame; empty for the base frame.
        X_BK: pose of the task frame in the base frame.
        tool: name of the tool; empty for the bare mechanical interface.
        X_MT: pose of the tool in the mechanical interface frame; None leaves it to the cell file.
        ptp_speed: share of the joint speed limits, in (0, 1].
        ptp_acceleration: share of the joint acceleration limits, in (0, 1].
        path_speed: speed of the TCP on its paths [m/s]; None = the cell's default.
        path_acceleration: its acceleration [m/s²]; None = the cell's default.
        orientation_speed: angular speed limit on tool paths [rad/s]; None = the cell's default.
        orientation_acceleration: its acceleration [rad/s²]; None = the cell's default.
        path_jerk: jerk on tool paths [m/s³]; None = the cell's default.
        zone: distance from the target at which the next move may begin [m]; 0 stops there (fine).
        passes: a target whose zone is 0 is a via point: it is passed by at the distance that the cell has for
            these.
    """

    frame: str = ""
    X_BK: Pose = field(default_factory=Pose)
    tool: str = ""
    X_MT: Pose | None = None
    ptp_speed: float = 1.0
    ptp_acceleration: float = 1.0
    path_speed: float | None = None
    path_acceleration: float | None = None
    orientation_speed: float | None = None
    orientation_acceleration: float | None = None
    path_jerk: float | None = None
    zone: float = 0.0
    passes: bool = False
