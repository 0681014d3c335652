"""A small pick-and-place run with the channels, events and facts of a real one, made in closed form."""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ropsim.core import Diagnostic, Severity, SourceText
from ropsim.flow import (
    AxisFacts,
    Channel,
    ChannelGroup,
    Event,
    GripEvent,
    MotionKind,
    MoveEvent,
    Origin,
    OriginKind,
    ParameterOrigin,
    Recording,
    ReleaseEvent,
    RunFacts,
    StationFacts,
    TaskEvent,
)
from ropsim.spatial import Array

JOINTS = ("1", "2", "3", "4", "5", "6")
STATION = "robot"
LAG = 0.012
"""Time constant of the imagined servo [s]: the attained pose follows the command by it."""
SOURCE = SourceText(
    "palletize.task",
    "task main\n  repeat 3\n    pick(infeed)\n    place(slot)\n  end\nend\n\ntask pick(at)\n  mov above(at)\n"
    "  lin at\n  grip\n  lin above(at)\nend\n\ntask place(at)\n  mov above(at)\n  lin at\n  release\n"
    "  lin above(at)\nend\n",
)

INFEED = (0.45, -0.30, 0.10)
SLOT = (0.40, 0.30, 0.08)
LIFT = 0.06


@dataclass(slots=True)
class _Tape:
    """What the maker collects while it walks through the program."""

    rate: float
    position: tuple[float, float, float] = (0.45, 0.0, 0.40)
    points: list[Array] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)
    moves: list[int] = field(default_factory=list)
    straight: list[bool] = field(default_factory=list)
    closed: list[float] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    gripped: float = 0.0
    ordinal: int = 0

    @property
    def now(self) -> float:
        return len(self.points) / self.rate

    def move(self, motion: MotionKind, target: tuple[float, float, float], line: int, visit: int) -> None:
        start, distance = self.now, float(np.linalg.norm(np.subtract(target, self.position)))
        seconds = distance / (0.12 if motion == MotionKind.LIN else 0.5) + 0.2
        count = round(seconds * self.rate)
        s = np.arange(1, count + 1)[:, None] / count
        blend = s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
        self._add(
            np.array(self.position) + blend * np.subtract(target, self.position),
            line,
            motion == MotionKind.LIN,
        )
        self.events.append(
            MoveEvent(
                start,
                self.now - start,
                STATION,
                Origin(SOURCE.span(line, 3, 6), visit),
                motion=motion,
                ordinal=self.ordinal,
                travel=self.now - start - 0.02,
                settle=0.02,
            )
        )
        self.position = target
        self.ordinal += 1

    def grip(self, kind: type[GripEvent | ReleaseEvent], line: int) -> None:
        start, self.gripped = self.now, float(kind is GripEvent)
        self._add(np.tile(self.position, (round(0.2 * self.rate), 1)), line, False)
        origin = Origin(SOURCE.span(line, 3, 4))
        self.events.append(kind(start, self.now - start, STATION, origin, part="box"))

    def task(self, name: str, start: float, serial: int, depth: int) -> None:
        self.events.append(TaskEvent(start, self.now - start, STATION, name=name, serial=serial, depth=depth))

    def _add(self, points: Array, line: int, straight: bool) -> None:
        count = len(points)
        self.points += list(points)
        self.lines += [line] * count
        self.moves += [self.ordinal] * count
        self.straight += [straight] * count
        self.closed += [self.gripped] * count


def pick_and_place(passes: int = 3, rate: float = 100.0, findings: tuple[Diagnostic, ...] = ()) -> Recording:
    """Return a run of `passes` cycles recorded at `rate` [Hz]."""
    tape = _Tape(rate)
    for visit in range(1, passes + 1):
        for serial, (name, at, line) in enumerate((("pick", INFEED, 9), ("place", SLOT, 16)), 2 * visit - 1):
            start, above = tape.now, (at[0], at[1], at[2] + LIFT)
            tape.move(MotionKind.PTP, above, line, visit)
            tape.move(MotionKind.LIN, at, line + 1, visit)
            tape.grip(GripEvent if name == "pick" else ReleaseEvent, line + 2)
            tape.move(MotionKind.LIN, above, line + 3, visit)
            tape.task(name, start, serial, 1)
    tape.task("main", 0.0, 0, 0)
    return _recording(tape, findings)


def two_findings() -> tuple[Diagnostic, ...]:
    """Return findings as a run makes them: one place in three passes, and a warning without a place."""
    reached = [
        Diagnostic(
            "M502",
            "joint-out-of-range",
            Severity.ERROR,
            f"command pose needs joint `3` at {170 + visit}.4°, the limit is 135.0°",
            SOURCE.span(16, 3, 13),
            label=f"reached in pass {visit}",
            hint="lower `pallet` by 0.12 m",
            data={"pass": visit},
        )
        for visit in (1, 2, 3)
    ]
    saturated = Diagnostic(
        "S703", "torque-saturated", Severity.WARNING, "joint `2` asks for 190 N·m of 186 N·m"
    )
    return (saturated, *reached)


def station(**changes: Any) -> StationFacts:
    """Return the station of the imagined run, limits as for a PUMA 560, with some fields changed."""
    ranges = [160.0, 125.0, 135.0, 140.0, 100.0, 266.0]
    speeds, efforts = [1.92, 1.92, 1.92, 4.0, 4.0, 4.0], [97.6, 186.4, 89.4, 24.2, 20.1, 21.3]
    axes = tuple(
        AxisFacts(
            name,
            lower=-float(np.deg2rad(degrees)),
            upper=float(np.deg2rad(degrees)),
            max_speed=speed,
            max_effort=effort,
            max_current=10.0,
        )
        for name, degrees, speed, effort in zip(JOINTS, ranges, speeds, efforts, strict=True)
    )
    plain = StationFacts(
        STATION,
        program="main",
        source=SOURCE.name,
        icr_id="5f2c9a",
        law="cascaded_p_pi",
        control_hz=1000.0,
        interpolation_ticks=4,
        plant_steps=4,
        robot="puma560",
        title="Unimation PUMA 560",
        axes=axes,
        origins=(
            ParameterOrigin("link inertias", OriginKind.PUBLISHED, "Armstrong, Khatib & Burdick 1986"),
            *estimates("motor resistance and inductance", "joint speed limits"),
        ),
    )
    return replace(plain, **changes)


def facts(**changes: Any) -> RunFacts:
    """Return the facts of the imagined run, with some fields changed."""
    return replace(RunFacts("0.1.0", "palletizing", record_hz=100.0, stations=(station(),)), **changes)


def estimates(*parameters: str) -> tuple[ParameterOrigin, ...]:
    """Return origins of parameters that are estimates."""
    return tuple(ParameterOrigin(one, OriginKind.ESTIMATED, "a guess") for one in parameters)


def held(
    time: Array,
    rows: Array,
    unit: str = "",
    description: str = "",
    group: ChannelGroup = ChannelGroup.PROGRAM,
    subject: str = "robot",
) -> Channel:
    """Return a channel that holds its values and changes halfway between rows, which it has as given."""
    changed = np.flatnonzero(np.diff(rows)) + 1
    times = np.concatenate([time[:1], 0.5 * (time[changed - 1] + time[changed])])
    return Channel(rows[np.append(0, changed)], unit, (), description, group, subject, times)


def joints_of(tcp: Array) -> Array:
    """Return imagined joint coordinates for TCP positions, shape (n, 6) [rad]; smooth, not a real arm."""
    x, y, z = tcp.T
    turn, reach = np.arctan2(y, x), np.hypot(x, y)
    columns = [turn, z - 1.0, 2.0 * reach - 2.5, 0.3 * turn, 0.8 - z, 0.5 * turn - 0.2]
    return np.stack(columns, axis=1)


def _recording(tape: _Tape, findings: tuple[Diagnostic, ...]) -> Recording:
    command = np.array(tape.points)
    n = len(command)
    time = np.arange(n) / tape.rate
    attained = _lagging(command, tape.rate)
    sag = 2e-5 + 1e-4 * np.sin(7.0 * time) ** 2
    attained[:, 2] -= sag
    q_ref, q = joints_of(command), joints_of(attained)
    qd_ref, qd = np.gradient(q_ref, time, axis=0), np.gradient(q, time, axis=0)
    payload = 0.5 * np.array(tape.closed)
    weights = np.array([20.0, 60.0, 30.0, 5.0, 4.0, 2.0])
    tau = weights * np.gradient(qd, time, axis=0) / 3.0 + weights * np.cos(q) * (0.4 + 0.1 * payload[:, None])
    path_error = np.where(tape.straight, sag, np.nan)
    upright = np.tile([0.0, 0.0, 1.0, 0.0], (n, 1))
    xyz, wxyz = ("x", "y", "z"), ("w", "x", "y", "z")
    of_joints, of_tcp = (ChannelGroup.JOINTS, STATION), (ChannelGroup.TCP, STATION)
    channels = {
        "q": Channel(q, "rad", JOINTS, "attained joint coordinates", *of_joints),
        "qd": Channel(qd, "rad/s", JOINTS, "attained joint speeds", *of_joints),
        "tau": Channel(tau, "N·m", JOINTS, "torques at the joints", *of_joints),
        "current": Channel(tau / 12.0, "A", JOINTS, "motor currents", *of_joints),
        "voltage": Channel(tau / 3.0, "V", JOINTS, "motor voltages", *of_joints),
        "q_ref": Channel(q_ref, "rad", JOINTS, "reference joint coordinates", *of_joints),
        "qd_ref": Channel(qd_ref, "rad/s", JOINTS, "reference joint speeds", *of_joints),
        "q_error": Channel(q_ref - q, "rad", JOINTS, "following errors", *of_joints),
        "command_position": Channel(command, "m", xyz, "command TCP in the base frame", *of_tcp),
        "attained_position": Channel(attained, "m", xyz, "attained TCP in the base frame", *of_tcp),
        "command_orientation": Channel(upright, "", wxyz, "command orientation of the tool", *of_tcp),
        "attained_orientation": Channel(upright, "", wxyz, "attained orientation of the tool", *of_tcp),
        "path_error": Channel(path_error, "m", (), "distance of the TCP from the commanded line", *of_tcp),
        "line": held(time, np.array(tape.lines, dtype=float), "", "active source line"),
        "move": held(time, np.array(tape.moves, dtype=float), "", "ordinal of the active move"),
        "gripper": held(time, np.array(tape.closed), "", "0 open, 1 closed"),
        "payload": held(time, payload, "kg", "mass at the mechanical interface"),
        "signal.lamp": held(time, (np.sin(time) > 0.0).astype(float), "", "output", ChannelGroup.SIGNALS, ""),
        "signal.pressure": Channel(
            4.0 + 0.2 * np.cos(3.0 * time), "bar", (), "analogue input", ChannelGroup.SIGNALS
        ),
    }
    events = tuple(sorted(tape.events, key=lambda event: event.time))
    return Recording(time, channels, events, findings, float(time[-1]) + 1.0 / tape.rate, facts())


def _lagging(command: Array, rate: float) -> Array:
    """Return the command delayed by a first-order lag."""
    alpha = 1.0 / (1.0 + LAG * rate)
    result = command.copy()
    for k in range(1, len(result)):
        result[k] = result[k - 1] + alpha * (command[k] - result[k - 1])
    return result


def empty_recording() -> Recording:
    """Return a recording without a sample, an event or a fact."""
    return Recording(np.empty(0), {}, (), (), 0.0)


def two_stations(passes: int = 1) -> Recording:
    """Return a run in which `left` and, a second later, `right` do the same beside a belt."""
    one = pick_and_place(passes)
    late = tuple(replace(event, time=event.time + 1.0) for event in one.events)
    channels: dict[str, Channel] = {}
    for name in ("left", "right"):
        for quantity, channel in one.channels.items():
            if channel.group is not ChannelGroup.SIGNALS:
                channels[f"{name}/{quantity}"] = replace(channel, subject=name)
    channels |= {name: one.channels[name] for name in one.channels if name.startswith("signal.")}
    way = np.minimum(0.2 * one.time, 0.5)[:, None]
    channels["infeed/q"] = Channel(
        way, "m", ("1",), "coordinate of the device", ChannelGroup.DEVICES, "infeed"
    )
    events = [replace(event, station="left") for event in one.events]
    events += [replace(event, station="right") for event in late]
    about = facts(stations=(station(name="left"), station(name="right", program="other")))
    return replace(one, channels=channels, events=tuple(sorted(events, key=lambda e: e.time)), facts=about)
