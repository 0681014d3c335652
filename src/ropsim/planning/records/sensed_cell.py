"""Surroundings of sensors in a cell: the state of its arms, and the surfaces around them."""

from dataclasses import field
from typing import Protocol

from ropsim.model import Payload, RobotModel
from ropsim.spatial import Array, Pose, frozen, record


@record
class ArmState:
    """State of an arm at one time.

    Attributes:
        station: its name.
        time: [s].
        robot: its model.
        payload: tool and grasped part.
        q: attained joint coordinates [rad | m], shape (n,).
        qd: attained joint speeds [rad/s | m/s], shape (n,).
        effort: torques of the drives at the joints, from the currents of the motors [N·m | N], shape (n,); 0
            in a section without dynamics.
        X_WT: pose of the tool in force in the world.
        wrench: what the environment exerted on tool and held part over the last control tick: force [N] and
            moment [N·m] about the origin of the mechanical interface, in the world frame, shape (6,); zeros
            without a contact that the cell declares. In kinematic runs it comes from the same geometry, and
            moves nothing.
    """

    station: str
    time: float
    robot: RobotModel
    payload: Payload
    q: Array
    qd: Array
    effort: Array
    X_WT: Pose
    wrench: Array = field(default_factory=lambda: frozen([0.0] * 6))


class SensedCell(Protocol):
    """The cell at the time of a reading; computed on request."""

    def arm(self, station: str = "") -> ArmState:
        """Return an arm by the name of its station; the empty name is that of the arm that reads.

        Raises:
            KeyError: the station is unknown.
        """
        ...

    def distance(self, X_WS: Pose, most: float, station: str = "") -> float:
        """Return the distance along a z axis to the nearest surface [m], infinite where none is so near.

        Surfaces are supports of parts, parts, and the floor z = 0; the arm itself, its tool and held parts
        are excluded.

        Args:
            X_WS: the frame from whose origin, along whose z axis it is measured.
            most: greatest distance of the search [m].
            station: of the arm that is not seen; the empty name is that of the arm that reads.
        """
        ...


class NothingSensed:
    """The cell of channels that are read without a run: it has no arms, and nothing stands around."""

    def arm(self, station: str = "") -> ArmState:
        """Raise `KeyError`: there is none."""
        raise KeyError(station)

    def distance(self, X_WS: Pose, most: float, station: str = "") -> float:
        """Return infinity."""
        del X_WS, most, station
        return float("inf")
