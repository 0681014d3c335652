"""A moment of a run: where everything that can carry a part is at one time."""

from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.kinematics import Blocks
from ropsim.model import WORLD
from ropsim.simulation.parts.placements import Placements, Seat
from ropsim.spatial import Pose


@frozen_dataclass
class Moment:
    """Where the bodies are with which parts move.

    Attributes:
        carriers: X_WC of each body with which parts move, by name: of a tool the mechanical interface.
        solids: moving bodies that can carry parts, at their present poses.
    """

    carriers: Mapping[str, Pose]
    solids: Blocks

    def pose(self, seat: Seat) -> Pose:
        """Return X_WO of a part."""
        return seat.pose if seat.rides == WORLD else self.carriers[seat.rides] @ seat.pose

    def poses(self, placements: Placements) -> dict[str, Pose]:
        """Return X_WO of each part that is there, by name."""
        carriers = self.carriers
        return {
            name: seat.pose if seat.rides == WORLD else carriers[seat.rides] @ seat.pose
            for name, seat in placements.seats.items()
        }

    def on(self, carrier: str, X_WO: Pose) -> Pose:
        """Return the pose of a part in the frame of its carrier."""
        return X_WO if carrier == WORLD else self.carriers[carrier].inverse() @ X_WO
