"""Where the tool of a station is, as its program sees it."""

from ropsim.controller import ArmPoses
from ropsim.flow import ModalState
from ropsim.kinematics import forward
from ropsim.simulation.state.station_run import StationRun
from ropsim.spatial import Array, Pose


class StationArm:
    """The arm of a station of a run.

    Args:
        at: the station.
    """

    def __init__(self, at: StationRun) -> None:
        self._at = at
        self._poses = ArmPoses(at.station.robot, at.chain.work)

    def attained(self, modal: ModalState, q_then: Array | None) -> Pose:
        """Return the pose that the arm really has, of the tool and in the task frame of a modal state: X_KT.

        Args:
            modal: the modal state.
            q_then: where the arm was at the time that is meant [rad | m], shape (n,); None for now.
        """
        at = self._at
        q = at.plant.q if q_then is None else q_then
        X_BT = forward(at.station.robot, q) @ at.chain.tool_pose(modal)
        return at.chain.work.frame_pose(modal, q).inverse() @ X_BT

    def commanded(self, modal: ModalState) -> Pose | None:
        """Return the pose X_KT at which the arm stands by command; None if the tool is not known."""
        return self._poses.at(self._at.q_command, modal)

    def reached(
        self, target: Pose | tuple[float, ...] | None, then: ModalState, now: ModalState
    ) -> Pose | None:
        """Return where a move leads; see `ArmPoses.reached`."""
        return self._poses.reached(target, then, now)
