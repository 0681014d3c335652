"""Guarded moves: a condition on a channel is checked while the arm moves."""

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.flow import Comparison, Guard, MoveInstruction
from ropsim.model import Sensor
from ropsim.simulation.diagnostics.run_diagnostics import GUARD_HELD_BEFORE, GUARD_NOT_MET
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.world import SimulatedWorld


@frozen_dataclass
class Lookout:
    """Checks the condition of a guarded move.

    Attributes:
        guard: the condition.
        world: reads the channel, and records how the move ended.
        at: the station whose arm moves.
        since: when the move began [s].
        sensor: measures the channel; None where no sensor does.
    """

    guard: Guard
    world: SimulatedWorld
    at: StationRun
    since: float
    sensor: Sensor | None = None

    def ends(self) -> bool:
        """Return whether the move ends now by its condition or its timeout; notify the world."""
        guard = self.guard
        self.world.guard_met = guard.holds(self.world.read(guard.channel))
        if self.world.guard_met:
            self.world.q_met = self.at.plant.q
        late = guard.timeout is not None and self.world.now() - self.since >= guard.timeout
        return self.world.guard_met or late

    def missed(self, move: MoveInstruction) -> Diagnostic | None:
        """Return S746 where the arm has come to the target of a move and its condition has not come true.

        A move with a timeout says itself that its condition need not come true.
        """
        if self.ends() or self.guard.timeout is not None:
            return None
        return GUARD_NOT_MET.at(
            move.origin.span,
            f"the motion came to its target, and `{self._condition}` never came true",
            label=f"pass {move.origin.visit}",
            hint="let the target lie beyond the place that is looked for, or write `timeout`",
            data={**move.origin.data, "channel": self.guard.channel, "time_s": self.world.now()},
        )

    def held_before(self, move: MoveInstruction, came: str) -> Diagnostic:
        """Return S754: the condition of a move was true before it began.

        Args:
            move: the instruction.
            came: the reason why the move ended.
        """
        return GUARD_HELD_BEFORE.at(
            move.origin.span,
            f"`{self._condition}` was true before the motion began: {came}",
            label=f"pass {move.origin.visit}",
            hint="let it become false before the motion, or ask for it in front of the motion",
            data={**move.origin.data, "channel": self.guard.channel, "time_s": self.since},
        )

    @property
    def _condition(self) -> str:
        guard = self.guard
        if guard.comparison is Comparison.IS:
            return f"{guard.channel} is {'on' if guard.value else 'off'}"
        order = ">" if guard.comparison is Comparison.ABOVE else "<"
        unit = f" {self.sensor.unit}" if self.sensor is not None else ""
        return f"{guard.channel} {order} {float(guard.value):.6g}{unit}"
