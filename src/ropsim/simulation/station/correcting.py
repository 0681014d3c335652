"""A move that a sensor corrects: between two interpolation ticks its references are shifted."""

import math
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from ropsim.controller import (
    Correction,
    CorrectionRange,
    ShiftedArm,
    ShiftedJoints,
    braked,
    is_within_limits,
    next_correction,
    shifted_reference,
)
from ropsim.core import Diagnostic, Kind
from ropsim.flow import JointReference, PathTracking
from ropsim.planning import Refusal, Sample, TimedMove, guarded, refused
from ropsim.simulation.diagnostics.run_diagnostics import (
    CORRECTION_AT_LIMIT,
    CORRECTION_STOPPED_BY_ARM,
    NO_NUMBER_MEASURED,
)
from ropsim.simulation.records.move_span import FollowedCorrection
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.world import SimulatedWorld
from ropsim.spatial import Array

_LOOK_AHEAD = 0.2
"""Motion time of the look-ahead for shifts of the arm [s]."""
_NEARLY_STILL = 0.1
"""Share of the speed of a correction below which the arm counts as its limit."""


@dataclass(slots=True)
class Correcting:
    """The correction of one move; it goes on with the motion clock only.

    Attributes:
        at: the station.
        world: reads the signal.
        planned: the move.
        tracking: its settings.
        rows: planned references of the move.
        now: the correction.
        added: its present shift of the reference.
        ticks: control ticks at which it was known, the start first.
        values: its value at these [m].
        by_size: time at which the limit of its size was reached first [s]; None where it was not.
        by_arm: the same for limits of the joints.
        no_number: time at which a valid reading was no finite number first [s]; None where none was.
        is_lost: whether the joints could not hold the shift of the path; the motion is to end then.
        faults: faults of the corrector, each once.
    """

    at: StationRun
    world: SimulatedWorld
    planned: TimedMove
    tracking: PathTracking
    rows: JointReference
    arm: ShiftedArm = field(init=False)
    added: ShiftedJoints = field(init=False)
    now: Correction = field(default_factory=Correction)
    ticks: list[int] = field(default_factory=list)
    values: list[float] = field(default_factory=list)
    by_size: float | None = None
    by_arm: float | None = None
    no_number: float | None = None
    is_lost: bool = False
    faults: tuple[Diagnostic, ...] = ()

    def __post_init__(self) -> None:
        direction = np.array(self.tracking.direction.vector)
        self.arm = ShiftedArm(self.at.station.robot, self.planned.X_MT, direction)
        self.added = self.arm.still
        self._enter(self.at.tick)

    @property
    def largest(self) -> float:
        """Return the largest size that the correction has had [m]."""
        return max(map(abs, self.values))

    def corrected(
        self, reference: JointReference, elapsed: float, left: float, rate: float
    ) -> JointReference:
        """Return the references of the next control ticks with the correction; the sensor is read now.

        Args:
            reference: as planned, of one interpolation tick at the most.
            elapsed: motion time of these ticks [s].
            left: motion time of the move behind them [s].
            rate: motion time that passes per time at their end.
        """
        period = 1.0 / self.at.hz
        sample = self.world.sample(self.tracking.channel)
        before, time = self.added, reference.ticks * period
        now, added = Correction(self.now.value), None
        if not self.is_lost:
            now = self._next(sample, reference, elapsed, left)
            added = self.arm.shifted(reference.q[-1], reference.qd[-1], now, rate, before)
        if added is None or not self._can_be(reference.q[-1], before, added, time):
            self._note_arm()
            self.is_lost = True
            now, added = Correction(self.now.value), braked(before, time, self.at.station.robot)
        self.now, self.added = now, added
        self._enter(self.at.tick + reference.ticks)
        return shifted_reference(reference, before, added, period)

    def _can_be(self, q: Array, before: ShiftedJoints, after: ShiftedJoints, time: float) -> bool:
        """Return whether joints may be at a reference q, shape (n,), with the shift after a slice [s]."""
        robot, there = self.at.station.robot, q + after.q
        inside = (there >= robot.lower_limits) & (there <= robot.upper_limits)
        return bool(inside.all()) and is_within_limits(before, after, time, robot)

    def followed(self) -> FollowedCorrection:
        """Return the correction over the ticks of the stationso far."""
        direction = np.array(self.tracking.direction.vector)
        return FollowedCorrection(np.array(self.ticks, dtype=float), np.array(self.values), direction)

    def findings(self) -> tuple[Diagnostic, ...]:
        """Return S747, S748 where limits were reached, S753, and faults of the corrector."""
        limits = self.at.station.controller.correction
        found = list(self.faults)
        if self.by_size is not None:
            text = f"the most allowed, at {self.by_size:.2f} s: `{self.tracking.channel}` asks for more"
            hint = "bring the path nearer to the work, or allow more: `correction_size` of the controller"
            found.append(self._finding(CORRECTION_AT_LIMIT, text, hint, limits.size))
        if self.by_arm is not None:
            text = f"and the arm let it go no further at {self.by_arm:.2f} s"
            text += "; the motion was ended where the joints could not keep it" if self.is_lost else ""
            hint = "keep away from joint limits and singular postures, or correct along another axis"
            found.append(self._finding(CORRECTION_STOPPED_BY_ARM, text, hint, limits.size))
        if self.no_number is not None:
            found.append(self._no_number(self.no_number))
        return tuple(found)

    def _next(self, sample: Sample, reference: JointReference, elapsed: float, left: float) -> Correction:
        """Return the correction at the end of a slice."""
        if elapsed <= 0.0:
            return self.now
        limits, value = self.at.station.controller.correction, self.now.value
        speed = self._wanted(sample, reference)
        wanted, allowed = value + speed * elapsed, self._range(speed, reference, left)
        if wanted > allowed.upper or wanted < allowed.lower:
            bound = allowed.upper if wanted > allowed.upper else allowed.lower
            if abs(bound) >= limits.size:
                self.by_size = self.at.time if self.by_size is None else self.by_size
            else:
                self._note_arm()
        if allowed.speed < min(_NEARLY_STILL * limits.speed, abs(speed)):
            self._note_arm()
        return next_correction(self.now, speed, allowed, left, elapsed)

    def _range(self, speed: float, reference: JointReference, left: float) -> CorrectionRange:
        """Return the room for the correction within limits and arm, here and some time ahead."""
        limits, value = self.at.station.controller.correction, self.now.value
        here = self.arm.range_at(limits, reference.q[-1] + self.added.q, value)
        ahead = self.rows.ticks - round(max(left - _LOOK_AHEAD, 0.0) * self.at.hz)
        side = math.copysign(1.0, value or speed)
        bounds = self.arm.bounds(limits, self.rows.q[ahead - 1], value, side, self.added)
        return replace(here, lower=max(here.lower, bounds[0]), upper=min(here.upper, bounds[1]))

    def _wanted(self, sample: Sample, reference: JointReference) -> float:
        """Return the speed requested by the corrector [m/s]; 0 once it has failed."""
        corrector, move, value = self.at.chain.corrector, self.planned.move, self.now.value
        if not math.isfinite(float(sample.value)):  # a value that is not finite is no measurement
            if sample.valid and self.no_number is None:
                self.no_number = self.at.time
            return 0.0
        if self.faults:
            return 0.0
        X_BT = self.arm.pose(reference.q[-1])
        ask = partial(corrector.correct, sample, self.tracking, X_BT, value)
        answer = guarded(corrector, lambda: float(ask()), (float,), move)
        if not isinstance(answer, Refusal) and not np.isfinite(answer):
            answer = refused(corrector, f"returned {answer} as speed of a correction", move)
        if isinstance(answer, Refusal):
            self.faults = answer.diagnostics
            return 0.0
        return answer

    def _note_arm(self) -> None:
        self.by_arm = self.at.time if self.by_arm is None else self.by_arm

    def _enter(self, tick: int) -> None:
        self.ticks.append(tick)
        self.values.append(self.now.value)

    def _no_number(self, time: float) -> Diagnostic:
        origin, channel = self.planned.move.origin, self.tracking.channel
        return NO_NUMBER_MEASURED.at(
            origin.span,
            f"`{channel}` reads no finite number, at {time:.2f} s first: the path is not corrected meanwhile",
            label=f"pass {origin.visit}",
            hint="let the sensor say that such a reading is not valid",
            data={**origin.data, "channel": channel, "time_s": time},
        )

    def _finding(self, kind: Kind, text: str, hint: str, limit: float) -> Diagnostic:
        origin = self.planned.move.origin
        return kind.at(
            origin.span,
            f"the correction reached {self.largest * 1e3:.3g} mm, {text}",
            label=f"pass {origin.visit}",
            hint=hint,
            data={
                **origin.data,
                "channel": self.tracking.channel,
                "largest_m": self.largest,
                "limit_m": limit,
            },
        )
