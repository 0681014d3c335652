"""Surroundings of sensors in a cell: the state of its arms, and the surfaces around them."""

from dataclasses import field
from typing import Protocol

import numpy as np

from ropsim.core import frozen_dataclass
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
        X_WM: pose of the mechanical interface in the world.
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
    X_WM: Pose = field(default_factory=Pose)


@frozen_dataclass
class SensedBefore:
    """The cell at the time at which a sensor took its sample.

    Attributes:
        cell: as it was then.
        tick: control tick of the station of the sensor, which numbers the sample; negative before the run
            began, when the arm stood where it starts.
        age: of the sample [s].
        seed: of the noise of sensors in this run.
    """

    cell: "SensedCell"
    tick: int
    age: float
    seed: int


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

    def load(self, station: str = "") -> Array:
        """Return the wrench that an arm exerts on its tool and part to carry and accelerate them, shape (6,).

        Force [N] and moment [N·m] about the origin of the mechanical interface, in the world frame.

        Args:
            station: of the arm; the empty name is that of the arm that reads.
        """
        ...

    def before(self, station: str, period: float, delay: float) -> SensedBefore:
        """Return the cell as a sensor saw it that takes a sample at every period and tells it after a delay.

        Args:
            station: of the sensor; the empty name is that of the arm that reads.
            period: between two samples [s]; 0 for each control tick of the station.
            delay: [s].
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

    def load(self, station: str = "") -> Array:
        """Return zeros."""
        del station
        return np.zeros(6)

    def before(self, station: str, period: float, delay: float) -> SensedBefore:
        """Return that nothing is sensed."""
        del station, period
        return SensedBefore(self, 0, delay, 0)
