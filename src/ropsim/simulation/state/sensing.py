"""Surroundings of the sensors of a run: its arms and surfaces at the time at which a station reads."""

import math
from dataclasses import dataclass, field, replace

import numpy as np

from ropsim.kinematics import Blocks, forward, nearest_along, part_blocks, stacked
from ropsim.planning import (
    ENTITY_FAILS,
    ArmState,
    Sample,
    SensedBefore,
    SensorInterface,
    entity_fails,
    is_our_own,
    raised,
)
from ropsim.simulation.state.carried_load import carried_load
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun
from ropsim.spatial import Array, Pose


@dataclass(slots=True)
class SensedRun:
    """The cell at the tick of a station that reads, or before (`ropsim.controller.SensedCell`).

    Attributes:
        run: the cell.
        at: the station that reads; no other one at work is less far.
        due: tick of the cell's clock, which is kept; None for that of the station.
    """

    run: CellRun
    at: StationRun
    due: int | None = None
    _solids: dict[str, Blocks] = field(default_factory=dict)

    @property
    def _due(self) -> int:
        return self.at.due if self.due is None else self.due

    def arm(self, station: str = "") -> ArmState:
        """Return an arm; of one that is ahead, or whose program has ended, where it is at this tick.

        Raises:
            KeyError: the station is unknown.
        """
        name = station or self.at.station.name
        other = self.run.stations[name]
        robot, payload = other.station.robot, other.loads.at(self._due // other.cell_ticks)
        if other.due <= self._due:
            q, qd, effort, tick = other.plant.q, other.plant.qd, other.plant.effort, float(other.tick)
            wrench = other.plant.wrench
        else:
            tick = self._due / other.cell_ticks
            row = other.plant.at(tick)
            q, qd, effort = other.plant.q_at(tick), row["qd"], row.get("tau", np.zeros(robot.n))
            wrench = other.plant.wrench_at(tick)
        X_WM = other.station.X_WB @ forward(robot, q)
        X_WT = X_WM @ other.tool_frames.at(tick + 1)  # from this tick on
        return ArmState(name, self._due / self.run.hz, robot, payload, q, qd, effort, X_WT, wrench, X_WM)

    def distance(self, X_WS: Pose, most: float, station: str = "") -> float:
        """Return the distance along a z axis to the nearest surface [m], infinite where none is so near."""
        name = station or self.at.station.name
        if name not in self._solids:
            self._solids[name] = self._seen_by(name)
        along = np.asarray(X_WS.rotation()[:, 2])
        found = min(nearest_along(self._solids[name], X_WS.position, along), _floor(X_WS.position, along))
        return found if found <= most else math.inf

    def load(self, station: str = "") -> Array:
        """Return the wrench that an arm exerts on its load, from where it was at the last control ticks."""
        other = self.run.stations[station or self.at.station.name]
        now, robot, X_WB = self._due // other.cell_ticks, other.station.robot, other.station.X_WB
        poses = [X_WB @ forward(robot, other.plant.q_at(now - back)) for back in (2, 1, 0)]
        free_fall = X_WB.rotation() @ robot.gravity
        return carried_load(other.loads.at(now), poses, other.hz, free_fall)

    def before(self, station: str, period: float, delay: float) -> SensedBefore:
        """Return the cell at the last sample of a sensor, on a control tick of its station."""
        run, at = self.run, self.run.stations[station or self.at.station.name]
        now = self._due // at.cell_ticks
        tick = now - round(delay * at.hz)
        tick -= tick % max(1, round(period * at.hz))
        due = max(tick, 0) * at.cell_ticks
        earlier = SensedRun(run, self.at, due)
        return SensedBefore(earlier, tick, (now - tick) / at.hz, at.station.controller.sensors.seed)

    def _seen_by(self, name: str) -> Blocks:
        """Return all surfaces except of an arm with its tools and held parts."""
        run = self.run
        moment, scenery = run.moment(self._due), run.scenery
        hands, seats = run.stations[name].hands, run.seated.at(self._due).seats
        free = {part: seat for part, seat in seats.items() if seat.rides not in hands}
        parts = part_blocks((scenery.parts[part], moment.pose(seat)) for part, seat in free.items())
        return stacked([scenery.ground.blocks, moment.solids, parts])


def _floor(origin: Array, along: Array) -> float:
    """Return the distance to the plane z = 0 of the world [m]; 0 below it."""
    if origin[2] <= 0.0:
        return 0.0
    return float(-origin[2] / along[2]) if along[2] < 0.0 else math.inf


@dataclass(slots=True)
class Senses:
    """Readings of one station.

    Attributes:
        sensors: delivers them.
        run: the cell, once it runs.
        name: of the station.
    """

    sensors: SensorInterface
    name: str
    run: CellRun | None = None

    def read(self, channel: str, time: float) -> Sample:
        """Return the reading of a channel at a time [s], from the present state of the cell."""
        assert self.run is not None, "a station reads only while it runs"
        seen = SensedRun(self.run, self.run.stations[self.name])
        sample = self._reading(channel, time, seen)
        self.run.note_reading(channel, seen.at.due, sample)
        return sample

    def _reading(self, channel: str, time: float, seen: SensedRun) -> Sample:
        """Return the reading of the sensors; invalid if sensors of a user fail, which is reported."""
        try:
            sample: object = self.sensors.read(channel, time, seen)
        except Exception as error:  # any exception of a user's code is reported
            if is_our_own(self.sensors):
                raise
            return self._failed(channel, f"{raised(error)}, when it was asked for `{channel}`", seen)
        if not isinstance(sample, Sample):
            found = f"returned a `{type(sample).__name__}` instead of a Sample for `{channel}`"
            return self._failed(channel, found, seen)
        value: object = sample.value
        if not isinstance(value, (bool, int, float, np.bool_, np.integer, np.floating)):
            found = f"returned a `{type(value).__name__}` as value of `{channel}`"
            return self._failed(channel, found, seen)
        return sample

    def _failed(self, channel: str, found: str, seen: SensedRun) -> Sample:
        """Return a reading that is not valid; the failure is reported once for a channel and line."""
        span, findings = seen.at.origin.span, seen.run.findings
        reported = ((one.code, one.span, one.data.get("channel")) for one in findings)
        if (ENTITY_FAILS.code, span, channel) not in reported:
            wrong = entity_fails(self.sensors, found, span)
            findings.append(replace(wrong, data={"channel": channel}))
        return Sample(value=False, valid=False, age=0.0)
