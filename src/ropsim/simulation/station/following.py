"""Following a plan in slices: the motion clock advances along it, the plant follows."""

import math
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from ropsim.controller import ClockLimits, ClockState, advance, undisturbed
from ropsim.core import frozen_dataclass
from ropsim.flow import JointReference
from ropsim.planning import MotionPlan
from ropsim.simulation.records.planned_sequence import PlannedMotion
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.station.correcting import Correcting
from ropsim.simulation.station.guarding import Lookout


@frozen_dataclass
class PlanRows:
    """The reference rows of a plan with that of its start before them."""

    plan: MotionPlan

    @property
    def count(self) -> int:
        """Return the number of rows."""
        return self.plan.ticks + 1

    def rows(self, first: int, last: int) -> JointReference:
        """Return the rows from number `first` up to, without it, number `last`."""
        reference = self.plan.reference
        if first > 0:
            return reference.part(first - 1, last - 1)
        zeros = np.zeros((1, len(self.plan.q_start)))
        start = (self.plan.q_start[None], zeros, zeros)
        rest = reference.part(0, last - 1)
        return JointReference(
            *(np.concatenate(pair) for pair in zip(start, (rest.q, rest.qd, rest.qdd), strict=True))
        )


@dataclass(slots=True)
class Follower:
    """Follows one plan.

    Attributes:
        run: the cell.
        at: the station.
        motion: of the plan.
        limits: bounds of changes of the override; None without interventions.
        clock: where it is.
        correcting: corrects the path of the move that is made by a sensor; None where nothing does.
        lookout: checks the condition of the present move; None without one.
        ended: whether a condition has ended the move, or a correction that the joints cannot keep; it brakes.
        ended_at: place at which the condition of the move was seen to end it, negative for none.
        passed: places to which it has come [control ticks of motion time], each with its tick.
    """

    run: CellRun
    at: StationRun
    motion: PlannedMotion
    limits: ClockLimits | None = None
    clock: ClockState = field(default_factory=ClockState)
    correcting: Correcting | None = None
    lookout: Lookout | None = None
    ended: bool = False
    ended_at: float = -1.0
    passed: list[tuple[float, int]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.clock = ClockState(0.0, self.run.override(self.at.due), 0.0)
        self.passed.append((0.0, self.at.tick))

    @property
    def plan(self) -> MotionPlan:
        """Return the plan that is followed."""
        return self.motion.plan

    @property
    def is_held(self) -> bool:
        """Return whether the motion stands by the override."""
        return self.clock.rate == 0.0 and self.clock.change == 0.0

    @property
    def _is_undisturbed(self) -> bool:
        """Return whether the motion is at one of its rows and at its own speed."""
        return self.clock.rate == 1.0 and self.clock.change == 0.0 and self.clock.place.is_integer()

    def until(self, place: int) -> Iterator[None]:
        """Follow the plan to a control tick of motion time; yields after each slice.

        Ends early, once the arm stands, where the run has been stopped or a condition has ended the move, and
        where the arm is still slowed by the override when the longest simulated time has passed.
        """
        at = self.at
        while self.clock.place < place:
            if not self.ended and self.lookout is not None and self.lookout.ends():
                self.ended, self.ended_at = True, self.clock.place
            self.ended = self.ended or (self.correcting is not None and self.correcting.is_lost)
            override = self.run.override(at.due)
            over = self._is_over(override)
            if (over or self.ended) and (self.is_held or self.clock.place == 0.0):
                at.cut_short |= over
                at.is_held = False
                return
            at.is_held = self.is_held and override == 0.0
            self._slice(place, 0.0 if over or self.ended else override)
            yield

    def tick_at(self, place: int) -> int:
        """Return the last tick at which the motion was not beyond a place that it has come to."""
        number = bisect_right(self.passed, (place, math.inf)) - 1
        before, tick = self.passed[number]
        return tick + int(place - before) if number + 1 < len(self.passed) else tick

    def blended(self, since: int, end: int) -> int:
        """Return for how many control ticks between two ticks the motion was within a zone."""
        if not self.plan.blends:
            return 0
        come, within = int(self.clock.place), 0
        for first, last in self.plan.blends:
            if first < come:
                ends, begins = self.tick_at(min(last, come)), self.tick_at(first)
                within += max(0, min(ends, end) - max(begins, since))
        return within

    def _is_over(self, override: float) -> bool:
        """Return whether the motion is to end before its end: by hand, held for ever, or lasting too long."""
        at = self.at
        return at.in_vain or self.run.is_stopped(at.due) or (at.is_over and override < 1.0)

    def _slice(self, place: int, override: float) -> None:
        """Go on towards a place at the requested rate, until the next observation or intervention."""
        run, at = self.run, self.at
        every = at.station.controller.rates.interpolation_ticks
        reads = self.lookout is not None or self.correcting is not None
        longest = min(run.slice(at), every) if reads else run.slice(at)
        period = self.plan.period
        rows, before = PlanRows(self.plan), self.clock.place
        if override == 1.0 and self._is_undisturbed:
            ticks = min(place - int(self.clock.place), longest)
            self.clock, reference = undisturbed(self.clock, rows, ticks)
            at.follow(self._corrected(reference, before))
            self.passed.append((self.clock.place, at.tick))
            return
        limits = self.limits = self.limits or self.motion.clock_limits()
        followed: list[JointReference] = []
        for _ in range(min(longest, every)):
            self.clock, row = advance(self.clock, rows, 1, override, limits, period)
            followed.append(row)
            self.passed.append((self.clock.place, at.tick + len(followed)))
            if self.clock.place >= place:
                break
        reference = JointReference(
            np.concatenate([row.q for row in followed]),
            np.concatenate([row.qd for row in followed]),
            np.concatenate([row.qdd for row in followed]),
        )
        at.follow(self._corrected(reference, before))

    def _corrected(self, reference: JointReference, before: float) -> JointReference:
        """Return the references of a slice with a sensor's correction; `before` is its start in the plan."""
        if self.correcting is None:
            return reference
        period, place = self.plan.period, self.clock.place
        elapsed, left = (place - before) * period, (self.plan.ticks - place) * period
        return self.correcting.corrected(reference, elapsed, left, self.clock.rate)
