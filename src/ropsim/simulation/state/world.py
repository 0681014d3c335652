"""View of the interpreter of a station on the simulated cell: time and channels."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ropsim.flow import ModalState
from ropsim.icr import Target
from ropsim.planning import Sample
from ropsim.simulation.records.polling import Polling
from ropsim.simulation.state.station_arm import StationArm
from ropsim.spatial import Array, Pose


@dataclass(slots=True)
class SimulatedWorld:
    """The interpreter's window on a run (`ropsim.icr.World`).

    Attributes:
        channel: delivers a channel at a time [s].
        now: returns the simulated time of the station [s].
        look: is called before each reading.
        longest_wait: a wait without a timeout ends after this time [s].
        arm: returns poses of the arm of the station.
        came: whether the channel that was waited for last came to have its value.
        guard_met: whether the condition of the guarded move that was carried out last ended it.
        q_met: attained coordinates at the tick at which it was seen to be true [rad | m], shape (n,); None
            where the move that was carried out last had no condition, or was not ended by it.
        polling: notified of the readings of the program.
    """

    channel: Callable[[str, float], Sample]
    now: Callable[[], float]
    look: Callable[[], None]
    longest_wait: float
    arm: StationArm
    came: bool = False
    guard_met: bool = False
    q_met: Array | None = None
    polling: Polling = field(default_factory=Polling)

    def read(self, channel: str) -> bool | float:
        """Return the present value of a channel; one that is not valid reads as off."""
        self.look()
        sample = self.channel(channel, self.now())
        value = self.polling.reads[channel] = sample.value if sample.valid else False
        return value

    def sample(self, channel: str) -> Sample:
        """Return the present reading of a channel, valid or not."""
        self.look()
        return self.channel(channel, self.now())

    def time(self) -> float:
        """Return the simulated time [s]."""
        self.polling.timed = True
        return self.now()

    def wait(self, channel: str, value: bool | float, timeout: float | None) -> bool:  # noqa: FBT001 - a signal's value
        """Return how the wait ended that the station has carried out."""
        del channel, value, timeout
        return self.came

    def met(self) -> bool:
        """Return how the guarded move ended that the station has carried out."""
        return self.guard_met

    def attained(self, modal: ModalState) -> Pose:
        """Return the pose that the tool in force has in the task frame in force, X_KT.

        Behind a move that its condition has ended it is that at which the condition was seen to be true.
        """
        self.look()
        return self.arm.attained(modal, self.q_met)

    def commanded(self, modal: ModalState) -> Pose | None:
        """Return the pose X_KT of the tool in force at which the arm stands by command."""
        self.look()
        return self.arm.commanded(modal)

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        """Return where a move leads, by the tools and frames of the cell."""
        return self.arm.reached(target, then, now)
