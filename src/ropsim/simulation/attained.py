"""Where the tool of a station is now, as its program sees it."""

from ropsim.flow import ModalState
from ropsim.kinematics import forward
from ropsim.simulation.station_run import StationRun
from ropsim.spatial import Pose


def attained_pose(at: StationRun, modal: ModalState) -> Pose:
    """Return the pose that the arm really has, of the tool and in the task frame of a modal state: X_KT."""
    q = at.plant.q
    X_BT = forward(at.station.robot, q) @ at.chain.tool_pose(modal)
    return at.chain.work.frame_pose(modal, q).inverse() @ X_BT
