"""The running state of a cell: everything that changes while its stations work, against one clock."""

import math
from bisect import bisect_right
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from ropsim.controller import CellSensors
from ropsim.core import Diagnostic
from ropsim.flow import SLOWEST, Event, InputChange, Placement, WaitEvent
from ropsim.model import Cell, Part, Tool
from ropsim.planning import MotionSequence, NothingSensed, Sample
from ropsim.simulation.devices.device_run import NEVER, DeviceRun
from ropsim.simulation.parts.moment import Moment
from ropsim.simulation.parts.parts import payload
from ropsim.simulation.parts.placements import Placements, changes
from ropsim.simulation.parts.scenery import Scenery
from ropsim.simulation.records.planned_sequence import Planning
from ropsim.simulation.records.polling_wait import PollingWait
from ropsim.simulation.records.track import Track
from ropsim.simulation.state.clasp import Clasp
from ropsim.simulation.state.inputs import signal_track
from ropsim.simulation.state.past_values import PastValues
from ropsim.simulation.state.reported import ReportedOnce
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.watch import NobodyWatches, Watch
from ropsim.spatial import Pose


@dataclass(slots=True)
class CellRun:
    """Running state.

    Attributes:
        cell: static model.
        content: its fingerprint, `Cell.content`.
        input_changes: of the original cell, without the inputs of the run: `Cell.input_changes`.
        stations: their running states by name.
        devices: theirs.
        sensors: channels of the cell.
        scenery: fixed data while parts are moved.
        parts: where the parts are.
        hz: ticks of the cell's clock per second; every control tick of every station is one of them.
        progress: called after every move with a text.
        ordered: called with every motion sequence before it is planned, and the name of its station.
        plan: plans a sequence.
        moved: how many moves have been done.
        at_work: the programs that have not ended, by station.
        watch: looks on.
        events: events so far.
        findings: findings so far.
        reported: which findings of plans are among the findings.
        placements: where each body hung at the start, and every change since.
        tracks: signals by the name of their channel, over ticks of the cell's clock.
        stop_tick: tick of the cell's clock from which on the run is ended by hand; None for its own end.
        lost_tick: tick of the cell's clock at which the state of an arm was lost; None while it is not.
        overrides: changes of the speed override in order of time: tick of the cell's clock, value of 0 to 1.
        override_read: the last tick for which the override was requested.
        inputs: changes of inputs that are not from the cell.
        supplies: of each supply the part that has come last, and the parts still to come.
        seated: where the parts were in the immediate past, over ticks of the cell's clock.
        clasps: grippers that are closed on a part which hangs on another one, by the body of the tool.
    """

    cell: Cell
    content: str
    input_changes: str
    stations: Mapping[str, StationRun]
    devices: Mapping[str, DeviceRun]
    sensors: CellSensors
    scenery: Scenery
    parts: Placements
    hz: int
    progress: Callable[[str], None]
    ordered: Callable[[str, MotionSequence], None]
    plan: Planning
    moved: int = 0
    at_work: dict[str, Iterator[None]] = field(default_factory=dict)
    watch: Watch = field(default_factory=NobodyWatches)
    events: list[Event] = field(default_factory=list)
    findings: list[Diagnostic] = field(default_factory=list)
    reported: ReportedOnce = field(default_factory=ReportedOnce)
    placements: list[Placement] = field(default_factory=list)
    tracks: dict[str, Track] = field(default_factory=dict)
    stop_tick: int | None = None
    lost_tick: int | None = None
    overrides: list[tuple[int, float]] = field(default_factory=list)
    override_read: int = -1
    inputs: list[InputChange] = field(default_factory=list)
    supplies: Mapping[str, deque[Part]] = field(default_factory=dict)
    clasps: dict[str, Clasp] = field(default_factory=dict)
    seated: PastValues[Placements] = field(init=False)

    def __post_init__(self) -> None:
        self.seated = PastValues(self.parts)

    @property
    def tick(self) -> int:
        """Return the tick of the cell's clock up to which all stations at work have come."""
        dues = {name: station.due for name, station in self.stations.items()}
        return min((dues[name] for name in self.at_work), default=max(dues.values()))

    @property
    def farthest(self) -> int:
        """Return the tick of the cell's clock to which the station at work has come that is farthest."""
        return max((self.stations[name].due for name in self.at_work), default=self.tick)

    @property
    def time(self) -> float:
        """Return the simulated time up to which all stations have come [s]."""
        return self.tick / self.hz

    def forget(self, tick: int) -> None:
        """Drop the past before a tick of the cell's clock, less the memory of sensors."""
        for at in self.stations.values():
            at.forget(tick)
        self.seated.forget(tick - max(at.memory * at.cell_ticks for at in self.stations.values()))

    def next_device(self, until: int) -> DeviceRun | None:
        """Return the device that acts next and not after a tick, None where none does."""
        if not self.devices:
            return None
        due = [one for one in self.devices.values() if NEVER < one.due <= until]
        return min(due, key=lambda one: (one.due, one.device.name), default=None)

    def moment(self, due: int) -> Moment:
        """Return where everything that can carry a part is at a tick of the cell's clock."""
        carriers: dict[str, Pose] = {}
        for station in self.stations.values():
            carriers |= station.carriers(due)
        for device in self.devices.values():
            carriers |= device.poses(due / self.hz)
        return Moment(carriers, self.scenery.moving(carriers))

    def take(self, at: StationRun, tool: Tool | None, parts: Placements) -> None:
        """Let `tool` be in force at a station and the parts be where `parts` says; its payload follows."""
        changed, at.tool = tool is not at.tool, tool
        self.place(parts, at.due)
        if changed:
            self._weigh(at)

    def _weigh(self, at: StationRun) -> None:
        """Let the payload of a station be the present load of its tools, after a grasp or a release."""
        load = payload(self.parts.carried(at.hands), self.scenery.parts, at.tool)
        if load != at.payload:
            at.weigh(load)

    def place(self, parts: Placements, due: int) -> None:
        """Let the parts be where `parts` says from a tick of the cell's clock on; devices check them."""
        if parts is self.parts:
            return
        self.placements += changes(due / self.hz, self.parts, parts, self.scenery.objects)
        self.parts = parts
        self.seated.set(due, parts)
        for at in self.stations.values():
            self._weigh(at)
        for device in self.devices.values():
            device.wake(due)

    def is_on(self, signal: str, time: float) -> bool:
        """Return whether a signal is on at a time [s]; one that is not valid is off."""
        sample = self.sensors.read(signal, time, NothingSensed())
        return sample.valid and bool(sample.value)

    def note_reading(self, channel: str, tick: int, sample: Sample) -> None:
        """Enter into the recording the measurement of a sensor at a tick of the cell's clock."""
        signal = self.cell.signals.get(channel)
        if signal and signal.sensor and sample.valid:
            track = self.tracks.setdefault(f"signal.{channel}", Track([0], [signal.initial]))
            if tick >= track.ticks[-1]:
                track.set(tick, float(sample.value))

    def set_output(self, at: StationRun, channel: str, value: float) -> None:
        """Let a station set an output now."""
        self.sensors.set_output(channel, value)
        self._tell(channel, at.due, float(value))

    def set_input(self, signal: str, tick: int, value: float) -> None:
        """Let a device set an input of the cell at a tick of the cell's clock."""
        self.sensors.change(signal, tick / self.hz, value)
        self._tell(signal, tick, value)

    def _tell(self, signal: str, tick: int, value: float) -> None:
        self.tracks.setdefault(f"signal.{signal}", Track([0], [0.0])).set(tick, value)
        self._rouse(signal, tick)

    def _rouse(self, signal: str, tick: int) -> None:
        """Let the devices that follow a signal read it at a tick of the cell's clock."""
        for device in self.devices.values():
            if signal in device.device.listens:
                device.wake(tick)

    def press(self, signal: str, tick: int, value: float) -> None:
        """Let an input of the cell have a value from a tick of the cell's clock on."""
        self.inputs.append(InputChange(tick / self.hz, signal, value))
        changed = self.sensors.change(signal, tick / self.hz, value)
        self.tracks[f"signal.{signal}"] = signal_track(changed, self.hz)
        self._rouse(signal, tick)

    def come_together(self) -> None:
        """Let the arms whose programs ended earlier stand until the end of the last one."""
        end = max(station.due for station in self.stations.values())
        for station in self.stations.values():
            station.rest(-((station.due - end) // station.cell_ticks))

    def override(self, tick: int) -> float:
        """Return the speed override in force at a tick of the cell's clock, from 0 (hold) to 1."""
        self.override_read = max(self.override_read, tick)
        if not self.overrides:
            return 1.0
        number = bisect_right(self.overrides, (tick, math.inf))
        return self.overrides[number - 1][1] if number else 1.0

    def slice(self, at: StationRun) -> int:
        """Return the number of control ticks until the next observation or intervention."""
        if not self.overrides and self.stop_tick is None:
            return at.stride
        number = bisect_right(self.overrides, (at.due, math.inf))
        ahead = [tick for tick, _ in self.overrides[number : number + 1]]
        if self.stop_tick is not None and self.stop_tick > at.due:
            ahead.append(self.stop_tick)
        return min([at.stride, *(-((at.due - tick) // at.cell_ticks) for tick in ahead)])

    def set_override(self, value: float) -> int:
        """Let the speed override have a value from the first tick on that is open; return that tick."""
        tick = max(self.farthest, self.override_read + 1)
        self.override_from(tick, value)
        return tick

    def override_from(self, tick: int, value: float) -> None:
        """Let the speed override have a value from a tick of the cell's clock on, not before the last change.

        No station may have passed that tick, or have requested the override there. A value with which no
        program would come to its end counts as 0.
        """
        value = value if value >= SLOWEST else 0.0
        if self.overrides and self.overrides[-1][0] == tick:
            del self.overrides[-1]
        self.overrides.append((tick, value))
        self.tracks.setdefault("override", Track([0], [1.0])).set(tick, value)

    def stop(self) -> int:
        """End the run at the first tick that no station has reached; return that tick."""
        tick = self.farthest + 1
        if self.stop_tick is None:
            self.stop_from(tick)
        return tick

    def stop_from(self, tick: int) -> None:
        """End the run at a tick of the cell's clock that no station has reached.

        Arms that stand then stay where they are, moving ones are braked on their paths.
        """
        for station in self.stations.values():
            station.last_tick = min(station.last_tick, -(-tick // station.cell_ticks))
        self.stop_tick = tick

    def is_stopped(self, tick: int) -> bool:
        """Return whether the run has been ended by hand at a tick of the cell's clock."""
        return self.stop_tick is not None and tick >= self.stop_tick

    def note(self, at: StationRun, since: int, event: Event) -> None:
        """Enter an event of a station that began at its tick `since` and ends now."""
        self.end_looking(at)
        self.events.append(event)
        if event.origin:
            at.ran(event.origin, since)

    def note_looking(self, at: StationRun, since: int, event: WaitEvent) -> None:
        """Take down that a station looks again and has stood from its tick `since` up to now.

        It is entered once the program does something else, as one event that covers the whole wait.
        """
        known = at.polling_wait
        if known is not None and known.goes_on_in(event, since):
            whole = WaitEvent(
                *at.when(known.since),
                known.event.origin,
                pause=(since - known.since) / at.hz + event.pause,
                looked=event.looked,
            )
            at.polling_wait = PollingWait(whole, known.since, at.tick)
        else:
            self.end_looking(at)
            at.polling_wait = PollingWait(event, since, at.tick)
        if event.origin:
            at.ran(event.origin, since)

    def end_looking(self, at: StationRun) -> None:
        """Enter the wait of a station that looks again and again, if it does."""
        if at.polling_wait is not None:
            self.events.append(at.polling_wait.event)
            at.polling_wait = None
