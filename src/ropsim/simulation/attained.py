"""Where the tool of a station is now, as its program sees it."""

from ropsim.flow import ModalState
from ropsim.kinematics import forward
from ropsim.simulation.station_run import StationRun
from ropsim.spatial import Array, Pose


def attained_pose(at: StationRun, modal: ModalState, q_then: Array | None) -> Pose:
    """Return the pose that the arm really has, of the tool and in the task frame of a modal state: X_KT.

    Args:
        at: the station.
        modal: with tool and frame.
        q_then: where the arm was at the time that is meant [rad | m], shape (n,); None for now.
    """
    q = at.plant.q if q_then is None else q_then
    X_BT = forward(at.station.robot, q) @ at.chain.tool_pose(modal)
    return at.chain.work.frame_pose(modal, q).inverse() @ X_BT
