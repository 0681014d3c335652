"""What a recording's header says about the run, read with care: a missing entry is never an error."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ropsim.flow import Recording
from ropsim.model import JointType, ParameterOrigin


@dataclass(frozen=True, slots=True)
class JointFacts:
    """Name, type and limits of one joint.

    Attributes:
        name: such as `1`.
        type: revolute or prismatic.
        lower: lower limit of the coordinate [rad | m]; -inf where unknown.
        upper: upper limit [rad | m]; inf where unknown.
        max_speed: [rad/s | m/s]; inf where unknown.
        max_effort: [N·m | N]; inf where unknown.
        max_current: of the amplifier [A]; inf where unknown.
    """

    name: str
    type: JointType = JointType.REVOLUTE
    lower: float = -math.inf
    upper: float = math.inf
    max_speed: float = math.inf
    max_effort: float = math.inf
    max_current: float = math.inf


@dataclass(frozen=True, slots=True)
class RunHeader:
    """Who ran what on which arm.

    Attributes:
        version: version of ropsim that made the run.
        project: name of the project.
        program: name of the program.
        source: name of the text whose lines the channel `line` counts.
        fidelity: `dynamic`, or `kinematic` for a run without drives and masses.
        robot: maker and model of the arm.
        joints: facts of each joint, n of them.
        control_hz: rate of the joint controller [Hz]; NaN where unknown.
        record_hz: rate of the recording [Hz]; NaN where unknown.
        icr_id: identity of the compiled program.
        estimated: what in the model is an estimate, for people.
        checked: what the run looked at beside motion and limits, such as `collisions`.
        origins: where the parameters of the arm come from.
    """

    version: str
    project: str
    program: str
    source: str
    fidelity: str
    robot: str
    joints: tuple[JointFacts, ...]
    control_hz: float
    record_hz: float
    icr_id: str
    estimated: tuple[str, ...]
    checked: tuple[str, ...]
    origins: tuple[ParameterOrigin, ...]

    @property
    def is_kinematic(self) -> bool:
        """Return whether the run was one without drives and masses."""
        return self.fidelity == "kinematic"

    @property
    def title(self) -> str:
        """Return project and program, each once, or `run` where neither has a name."""
        return " / ".join(dict.fromkeys(part for part in (self.project, self.program) if part)) or "run"


def run_header(recording: Recording) -> RunHeader:
    """Return the header of a recording; texts that are absent are empty, numbers NaN or infinite."""
    header = recording.header
    robot = _mapping(header.get("robot"))
    rates = _mapping(header.get("rates"))
    return RunHeader(
        version=_text(header.get("ropsim")),
        project=_text(header.get("project")),
        program=_text(header.get("program")),
        source=_text(header.get("source")),
        fidelity=_text(header.get("fidelity")),
        robot=_text(robot.get("title")) or _text(robot.get("name")),
        joints=_joints(recording, robot),
        control_hz=number(rates.get("control_hz")),
        record_hz=number(header.get("record_hz")),
        icr_id=_text(header.get("icr_id")),
        estimated=tuple(_text(entry) for entry in _sequence(header.get("estimated"))),
        checked=tuple(_text(entry) for entry in _sequence(header.get("checked"))),
        origins=tuple(_origin(_mapping(entry)) for entry in _sequence(robot.get("origins"))),
    )


def number(value: object, default: float = math.nan) -> float:
    """Return a plain value as a float, or `default` where it is no number."""
    if isinstance(value, (int, float)):
        return float(value)
    return default


def whole(value: object, default: int) -> int:
    """Return a plain value as a whole number, or `default` where it is none."""
    return int(value) if isinstance(value, (int, float)) and math.isfinite(value) else default


def _joints(recording: Recording, robot: Mapping[str, object]) -> tuple[JointFacts, ...]:
    channel = recording.channels.get("q")
    names = [_text(name) for name in _sequence(robot.get("joint_names"))]
    if channel is not None and channel.values.ndim == 2:
        width = channel.values.shape[1]
        names = (names or list(channel.columns))[:width]
        names += [str(k + 1) for k in range(len(names), width)]
    return tuple(
        JointFacts(
            name,
            _joint_type(_entry(robot, "joint_types", k)),
            number(_entry(robot, "lower", k), -math.inf),
            number(_entry(robot, "upper", k), math.inf),
            number(_entry(robot, "max_speed", k), math.inf),
            number(_entry(robot, "max_effort", k), math.inf),
            number(_entry(robot, "max_current", k), math.inf),
        )
        for k, name in enumerate(names)
    )


def _joint_type(value: object) -> JointType:
    return JointType.PRISMATIC if value == JointType.PRISMATIC.value else JointType.REVOLUTE


def _origin(entry: Mapping[str, object]) -> ParameterOrigin:
    return ParameterOrigin(
        _text(entry.get("parameters")), _text(entry.get("kind")), _text(entry.get("source"))
    )


def _entry(robot: Mapping[str, object], key: str, index: int) -> object:
    values = _sequence(robot.get(key))
    return values[index] if index < len(values) else None


def _text(value: object) -> str:
    return "" if value is None else str(value)


def _mapping(value: object) -> Mapping[str, object]:
    return value if isinstance(value, Mapping) else {}


def _sequence(value: object) -> Sequence[object]:
    return value if isinstance(value, (list, tuple)) else ()
