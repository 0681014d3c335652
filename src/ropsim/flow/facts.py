"""Facts of a recording about its run: stations and programs, arms, limits."""

from enum import Enum, StrEnum
from math import inf, nan

from ropsim.core import frozen_dataclass
from ropsim.flow.inputs import InputChange, Interventions, OverrideChange
from ropsim.flow.way_facts import WayFacts

ROBOT = "robot"
"""Name of the station of a cell with a single one; its bodies and channels are called without it."""


class OriginKind(StrEnum):
    """How a number is known: by measuring it, from its maker or a paper, from such numbers, or by a rule."""

    MEASURED = "measured"
    PUBLISHED = "published"
    DERIVED = "derived"
    ESTIMATED = "estimated"


@frozen_dataclass
class ParameterOrigin:
    """Where a group of parameters comes from.

    Attributes:
        parameters: covered parameters, such as `motor constants`.
        kind: how they are known.
        source: paper, table or reasoning.
    """

    parameters: str
    kind: OriginKind
    source: str


class Fidelity(Enum):
    """Model that follows the references."""

    DYNAMIC = "dynamic"
    KINEMATIC = "kinematic"


class AxisType(Enum):
    """How a driven axis moves."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"


@frozen_dataclass
class AxisFacts:
    """Name, type and limits of one driven axis.

    Attributes:
        name: such as `1`.
        type: revolute or prismatic.
        lower: lower limit of the coordinate [rad | m]; -inf where unknown.
        upper: upper limit [rad | m]; inf where unknown.
        max_speed: [rad/s | m/s]; inf where unknown.
        max_effort: torque or force at the joint [N·m | N]; inf where unknown.
        max_current: of the amplifier or the current loop [A]; inf where unknown.
        lasting_current: which the winding bears for ever [A]; inf where unknown.
        max_rise: of the winding over the surroundings [K]; inf where unknown.
    """

    name: str
    type: AxisType = AxisType.REVOLUTE
    lower: float = -inf
    upper: float = inf
    max_speed: float = inf
    max_effort: float = inf
    max_current: float = inf
    lasting_current: float = inf
    max_rise: float = inf


@frozen_dataclass
class CalledTask:
    """A task of a knowledge base that a program calls, or that another such task calls.

    Attributes:
        name: its name.
        source: name of its text, such as `kb/glue.pl`.
        version: SHA-256 of its task text, as 64 digits.
    """

    name: str
    source: str = ""
    version: str = ""


class StepCause(StrEnum):
    """What set the integration steps in a control tick."""

    LONGEST = "longest step"
    POLE = "fastest pole"
    FRICTION = "steepest friction"
    STATED = "stated"
    MOST = "most steps"


@frozen_dataclass
class IntegrationFacts:
    """How the equations of drives and arm were integrated.

    Attributes:
        method: name of the method.
        step: the integration step [s].
        cause: what set it.
        pole: the fastest rate of drives and arm, friction at the largest effort included, to four digits
            [1/s].
        error: by how much a coordinate differs at most from steps of half the length, rounded up to one digit
            [rad | m], over a jolt of every axis at the start; NaN where it was not measured.
    """

    method: str
    step: float
    cause: StepCause
    pole: float
    error: float = nan


@frozen_dataclass
class StationFacts:
    """One robot with its controller and the program that it ran.

    Attributes:
        name: of the station; `robot` is that of the only one of a cell.
        program: name of the program; empty where it followed references of no program.
        source: name of the text whose lines the channel `line` counts.
        icr_id: identity of the compiled program.
        law: name of the joint controller; empty for a run without drives.
        control_hz: rate of the joint controller [Hz]; NaN where unknown.
        interpolation_ticks: control ticks per interpolation tick.
        plant_steps: integration steps of drives and arm per control tick.
        integration: how drives and arm were integrated; None where nothing was: in a kinematic run, and in
            recordings of older versions.
        robot: short name of the robot.
        title: its maker and model.
        axes: of the robot, in the order of the columns of `q`.
        origins: where the parameters of robot and controller come from.
        skipped_moves: how many moves were refused and left out.
        called: the tasks of knowledge bases that its program is made of.
    """

    name: str
    program: str = ""
    source: str = ""
    icr_id: str = ""
    law: str = ""
    control_hz: float = nan
    interpolation_ticks: int = 1
    plant_steps: int = 1
    integration: IntegrationFacts | None = None
    robot: str = ""
    title: str = ""
    axes: tuple[AxisFacts, ...] = ()
    origins: tuple[ParameterOrigin, ...] = ()
    skipped_moves: int = 0
    called: tuple[CalledTask, ...] = ()

    @property
    def estimated(self) -> tuple[str, ...]:
        """Return which groups of parameters are estimates."""
        return tuple(one.parameters for one in self.origins if one.kind is OriginKind.ESTIMATED)


@frozen_dataclass
class Destinations:
    """The parts that have a destination in the cell.

    Attributes:
        wanted: required number.
        reached: how many of them are there when the run ends.
    """

    wanted: int = 0
    reached: int = 0


@frozen_dataclass
class RunFacts:
    """Programs, stations and settings of a run.

    Attributes:
        ropsim: version that made the run.
        project: name of the project.
        fidelity: with drives and masses or without.
        record_hz: recorded rows per second [Hz]; NaN where unknown.
        checked: checks of the run in addition to motion, limits and, with drives, torques, drives and servo,
            such as `collisions`.
        inputs: changes of inputs of interventions in addition to those of the cell, in order of time.
        overrides: changes of the override, in order of time.
        stopped: when the run was ended by hand [s]; None where it came to its own end.
        parts_left: names of the parts that have left by a sink, in that order.
        destinations: of parts; empty for a run that was cut short.
        stations: each with its program, in the order of the cell.
        ways: results of collision checks; null if there was none.
    """

    ropsim: str = ""
    project: str = ""
    fidelity: Fidelity = Fidelity.DYNAMIC
    record_hz: float = nan
    checked: tuple[str, ...] = ()
    inputs: tuple[InputChange, ...] = ()
    overrides: tuple[OverrideChange, ...] = ()
    stopped: float | None = None
    parts_left: tuple[str, ...] = ()
    destinations: Destinations = Destinations()
    stations: tuple[StationFacts, ...] = ()
    ways: WayFacts | None = None

    @property
    def interventions(self) -> Interventions:
        """Return all interventions in the run."""
        return Interventions(self.inputs, self.overrides, self.stopped)

    @property
    def is_kinematic(self) -> bool:
        """Return whether the run was one without drives and masses."""
        return self.fidelity is Fidelity.KINEMATIC

    def station(self, name: str) -> StationFacts | None:
        """Return a station by its name, None where there is none."""
        return next((one for one in self.stations if one.name == name), None)

    def channel(self, quantity: str, station: str) -> str:
        """Return the name of the channel of a quantity: `q`, where there are several stations `left/q`."""
        return channel_name(quantity, station)


def channel_name(quantity: str, owner: str) -> str:
    """Return the name of the channel with a quantity of a station or device: `q`, or `left/q`."""
    return prefix_of(owner) + quantity


def prefix_of(owner: str) -> str:
    """Return the prefix of the names of channels and bodies of a station or device."""
    return "" if owner == ROBOT else f"{owner}/"
