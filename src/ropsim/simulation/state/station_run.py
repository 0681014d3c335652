"""The running state of one station: its controller, drives and arm, and how far they are."""

from collections.abc import Iterator
from dataclasses import dataclass, field

from ropsim.flow import AwaitInstruction, JointReference, ModalState, Origin
from ropsim.kinematics import forward_batch, frames_batch
from ropsim.model import Payload, Station, Tool, external_links, link_name, tool_body
from ropsim.planning import MotionChain
from ropsim.simulation.devices.axis_profile import AxisProfile
from ropsim.simulation.records.activation import Activations
from ropsim.simulation.records.move_span import MoveSpan, PathSpan
from ropsim.simulation.records.plant import Plant
from ropsim.simulation.records.polling import Polled
from ropsim.simulation.records.polling_wait import PollingWait
from ropsim.simulation.records.tool_frames import ToolFrames
from ropsim.simulation.records.track import Track
from ropsim.simulation.state.past_values import PastValues
from ropsim.spatial import Array, Pose

_SLICE = 1_000
"""Longest reference of an arm that stands still [control ticks]."""

_STRIDE = 100_000
"""Control ticks that a station moves on at a time without an observer."""


@dataclass(slots=True)
class StationRun:
    """Running state.

    Attributes:
        station: static model.
        chain: the slow side of the controller.
        plant: joint controller, drives and arm, advanced by references.
        q_command: command coordinates reached so far, shape (n,).
        tool: tool in force.
        tool_frames: X_MT that were in force, also of tools defined only by the program.
        payload: tool and grasped part as one body; the same object until it changes.
        loads: the payload over control ticks.
        memory: for how long its past is kept [control ticks].
        last_tick: control tick at which standing still ends at the latest.
        cell_ticks: ticks of the cell's clock in one control tick.
        stride: control ticks that it moves on at a time at the longest.
        tick: control ticks done.
        moves: moves done.
        paths: followed parts of the tool paths.
        tracks: piecewise constant channels by name, over control ticks.
        activations: times of the tasks.
        fingers: profiles of the fingers of its tools, by the name of the body of the tool.
        awaits: its wait, if it waits for a channel.
        polled: its polled readings, if it only polls.
        polling_wait: its wait by polling, while it lasts.
        origin: of the instruction in force.
        modal: the modal state whose tool is in force.
        is_busy: whether that is still being carried out.
        is_held: whether it stands because the override is 0.
        in_vain: whether its wait is endless; the program is over then.
        dismissed: whether the stations that it served have ended; the program is over then.
        unfinished: whether the run was ended, by hand or by its longest time, before the program.
        is_lost: whether nothing is known of its arm any more: its state diverged, or its law failed.
        cut_short: whether `last_tick` ended its standing still, or a hand its move; the program is over then.
        hands: names of the bodies of its tools.
        hz: rate of the joint controller [Hz].
    """

    station: Station
    chain: MotionChain
    plant: Plant
    q_command: Array
    tool: Tool | None
    tool_frames: ToolFrames
    payload: Payload
    last_tick: int
    cell_ticks: int
    memory: int = 0
    stride: int = _STRIDE
    tick: int = 0
    moves: list[MoveSpan] = field(default_factory=list)
    paths: list[PathSpan] = field(default_factory=list)
    tracks: dict[str, Track] = field(default_factory=dict)
    activations: Activations = field(default_factory=Activations)
    fingers: dict[str, AxisProfile] = field(default_factory=dict)
    awaits: AwaitInstruction | None = None
    polled: Polled | None = None
    polling_wait: PollingWait | None = None
    origin: Origin = field(default_factory=Origin)
    modal: ModalState | None = None
    is_busy: bool = False
    is_held: bool = False
    in_vain: bool = False
    dismissed: bool = False
    unfinished: bool = False
    cut_short: bool = False
    is_lost: bool = False
    loads: PastValues[Payload] = field(init=False)
    hands: frozenset[str] = field(init=False)
    hz: int = field(init=False)

    def __post_init__(self) -> None:
        self.hands = frozenset(tool_body(name, self.station.name) for name in self.station.tools)
        self.hz = self.station.controller.rates.control_hz
        self.loads = PastValues(self.payload)

    @property
    def is_over(self) -> bool:
        """Return whether the longest simulated time has passed."""
        return self.cut_short or self.tick >= self.last_tick

    @property
    def due(self) -> int:
        """Return how far the station is [ticks of the cell's clock]."""
        return self.tick * self.cell_ticks

    @property
    def time(self) -> float:
        """Return the simulated time [s]."""
        return self.tick / self.hz

    @property
    def hand(self) -> str:
        """Return the name of the body of the tool in force, empty for none."""
        return tool_body(self.tool.name, self.station.name) if self.tool else ""

    def carriers(self, due: int) -> dict[str, Pose]:
        """Return the attained poses X_WC of the carriers of parts at a tick of the cell's clock, by name.

        These are its tools, with the pose of the mechanical interface, and the links that external axes move.
        From the tick on that the station has come to they are the present ones of the arm, before it past
        ones, which is kept from the least tick on that any station has come to.
        """
        hands, robot, X_WB = self.hands, self.station.robot, self.station.X_WB
        moved = external_links(robot) if robot.external else ()
        if not hands and not moved:
            return {}
        q = self.plant.q if due >= self.due else self.plant.q_at(due / self.cell_ticks)
        poses = {}
        if hands:
            poses = dict.fromkeys(hands, X_WB @ Pose.from_matrix(forward_batch(robot, q[None])[0]))
        if moved:
            frames = frames_batch(robot, q[None])[0]
            names = {number: link_name(number + 1, self.station.name) for number in moved}
            poses |= {names[number]: X_WB @ Pose.from_matrix(frames[number]) for number in moved}
        return poses

    def external_frames(self, q: Array) -> dict[str, Array]:
        """Return the poses X_WL of the links that external axes move, shape (4, 4), by name.

        Args:
            q: joint coordinates [rad | m], shape (n,).
        """
        robot = self.station.robot
        moved = external_links(robot) if robot.external else ()
        if not moved:
            return {}
        X_WB, frames = self.station.X_WB.matrix(), frames_batch(robot, q[None])[0]
        return {link_name(number + 1, self.station.name): X_WB @ frames[number] for number in moved}

    def forget(self, due: int) -> None:
        """Drop where the arm was before a tick of the cell's clock, less the memory of its sensors."""
        tick = due // self.cell_ticks - self.memory
        self.plant.forget(tick)
        self.loads.forget(tick)

    def weigh(self, load: Payload) -> None:
        """Let tool and grasped part have another load from now on."""
        self.payload = load
        self.loads.set(self.tick, load)
        self.track("payload", load.mass)

    def follow(self, reference: JointReference) -> None:
        """Let the arm follow a reference to its end, which is its command position then."""
        if reference.ticks:
            self.plant.follow(reference, self.payload)
            self.tick += reference.ticks
            self.q_command = reference.q[-1]

    def stand(self, ticks: int) -> Iterator[None]:
        """Hold the command position for a number of control ticks, at the longest until `last_tick`.

        Its memory is that of `_SLICE` ticks for any duration; it yields after each slice.
        """
        until = self.tick + ticks
        while (left := min(until, self.last_tick) - self.tick) > 0:  # who watches may end the run
            self.rest(min(left, self.stride, _SLICE))
            yield
        self.cut_short |= self.tick < until

    def rest(self, ticks: int) -> None:
        """Hold the command position for a number of control ticks, while others wait."""
        until = self.tick + ticks
        while self.tick < until:
            slice_ = min(until - self.tick, _SLICE)
            self.plant.hold(self.q_command, slice_, self.payload)
            self.tick += slice_

    def rest_to_row(self) -> None:
        """Record the arm where it stands at the end of a run, up to the first row at or behind that time."""
        if left := -self.tick % self.plant.record_ticks:
            self.plant.hold(self.q_command, left, self.payload)

    def track(self, name: str, value: float) -> None:
        """Let a piecewise constant channel have a new value from now on; before its first one it is 0."""
        track = self.tracks.get(name)
        if track is None:
            track = self.tracks[name] = Track([0], [0.0])
        track.set(self.tick, value)

    def when(self, since: int) -> tuple[float, float, str]:
        """Return time [s], duration [s] and station of an event that began at tick `since` and ends now."""
        return since / self.hz, (self.tick - since) / self.hz, self.station.name

    def ran(self, origin: Origin, since: int) -> None:
        """Count an instruction that began at tick `since` and ends now for the tasks around it."""
        self.activations.add(origin, since, self.tick)
