"""The running state of one simulated program: everything that changes while it runs."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ropsim.controller import MotionChain, ScriptedSensors
from ropsim.core import Diagnostic
from ropsim.flow import Event, InputChange, JointReference, Placement
from ropsim.kinematics import forward
from ropsim.model import ROBOT, Cell, Payload, Tool
from ropsim.simulation.activation import Activations
from ropsim.simulation.inputs import signal_track
from ropsim.simulation.move_span import MoveSpan
from ropsim.simulation.parts import payload
from ropsim.simulation.placements import Placements, changes
from ropsim.simulation.plant import Plant
from ropsim.simulation.scenery import Scenery
from ropsim.simulation.track import Track
from ropsim.simulation.watch import NobodyWatches, Watch
from ropsim.spatial import Array, Pose

_SLICE = 1_000
"""Longest reference of an arm that stands still [control ticks]."""


@dataclass(slots=True)
class CellRun:
    """Running state.

    Attributes:
        cell: static model.
        chain: the slow side of the controller.
        plant: joint controller, drives and arm, advanced by references.
        sensors: channels of the cell.
        q_command: command coordinates reached so far, shape (n,).
        scenery: what stays as it is while parts are moved.
        parts: where the parts are.
        tool: tool in force.
        payload: tool and grasped part as one body; one object as long as it does not change.
        last_tick: control tick at which standing still ends at the latest.
        watch: looks on.
        tick: control ticks done.
        moves: moves done.
        events: what happened.
        findings: what was found.
        placements: where each body hung at the start, and every change since.
        tracks: piecewise constant channels by name.
        activations: times of the tasks.
        waiting: whether the last instruction did nothing but wait for the ones before it.
        cut_short: whether standing still was ended by `last_tick`; the run is over then.
        stopped: whether the run was ended by who watches.
        inputs: changes of inputs that are not from the cell.
    """

    cell: Cell
    chain: MotionChain
    plant: Plant
    sensors: ScriptedSensors
    q_command: Array
    scenery: Scenery
    parts: Placements
    tool: Tool | None
    payload: Payload
    progress: Callable[[str], None]
    last_tick: int
    watch: Watch = field(default_factory=NobodyWatches)
    tick: int = 0
    moves: list[MoveSpan] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    findings: list[Diagnostic] = field(default_factory=list)
    placements: list[Placement] = field(default_factory=list)
    tracks: dict[str, Track] = field(default_factory=dict)
    activations: Activations = field(default_factory=Activations)
    waiting: bool = False
    cut_short: bool = False
    stopped: bool = False
    inputs: list[InputChange] = field(default_factory=list)

    @property
    def is_over(self) -> bool:
        """Return whether the longest simulated time has passed."""
        return self.cut_short or self.tick >= self.last_tick

    @property
    def time(self) -> float:
        """Return the simulated time [s]."""
        return self.tick / self.cell.controller.rates.control_hz

    def take(self, tool: Tool | None, parts: Placements) -> None:
        """Let `tool` be in force and the parts be where `parts` says; the payload follows."""
        if tool is self.tool and parts is self.parts:
            return
        self.placements += changes(self.time, self.parts, parts, self.scenery.ground.poses)
        self.tool, self.parts = tool, parts
        self.payload = payload(parts, self.scenery.parts, tool)
        self.track("payload", self.payload.mass)

    def attained(self) -> Pose:
        """Return the attained pose of the mechanical interface X_WM."""
        return self.cell.X_WB @ forward(self.cell.robot, self.plant.q)

    def follow(self, reference: JointReference) -> None:
        """Let the arm follow a reference to its end."""
        if reference.ticks:
            self.plant.follow(reference, self.payload)
            self.tick += reference.ticks

    def stand(self, ticks: int) -> None:
        """Hold the command position for a number of control ticks, at the longest until `last_tick`.

        However long that is, it takes the memory of `_SLICE` ticks only.
        """
        left = max(self.last_tick - self.tick, 0)
        self.cut_short |= ticks > left
        until = self.tick + min(ticks, left)
        while self.tick < min(until, self.last_tick):
            slice_ = min(until - self.tick, _SLICE)
            self.plant.hold(self.q_command, slice_, self.payload)
            self.tick += slice_
            self.watch.advanced(self)

    def press(self, signal: str, tick: int, value: float) -> None:
        """Let an input of the cell have a value from a tick on."""
        hz = self.cell.controller.rates.control_hz
        self.inputs.append(InputChange(tick / hz, signal, value))
        changed = self.sensors.change(signal, tick / hz, value)
        self.tracks[f"signal.{signal}"] = signal_track(changed, hz)

    def stop(self) -> None:
        """End the run at the present tick."""
        self.last_tick = min(self.last_tick, self.tick)
        self.stopped = self.cut_short = True

    def track(self, name: str, value: float) -> None:
        """Let a piecewise constant channel have a new value from now on; before its first one it is 0."""
        self.tracks.setdefault(name, Track([0], [0.0])).set(self.tick, value)

    def when(self, since: int) -> tuple[float, float, str]:
        """Return time [s], duration [s] and station of an event that began at tick `since` and ends now."""
        hz = self.cell.controller.rates.control_hz
        return since / hz, (self.tick - since) / hz, ROBOT

    def note(self, event: Event) -> None:
        """Enter an event that ends now."""
        self.events.append(event)
        if event.origin:
            since = round(event.time * self.cell.controller.rates.control_hz)
            self.activations.add(event.origin, since, self.tick)
