"""The controller of an arm as data: rates, gains, default speeds, limits of corrections and tolerances."""

from dataclasses import fields
from enum import Enum
from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.flow import ParameterOrigin
from ropsim.model.controller_file import ControllerFile
from ropsim.model.entities import NamedEntity, OwnEntity
from ropsim.model.findings.number_range import COORDINATE, EXTENT, RATE, TIME, Ranges, between, whole
from ropsim.model.joint_sensors import JointSensors
from ropsim.spatial import Array, frozen, record


class OrientationMode(Enum):
    """Which of the ways from one orientation to another the tool takes.

    With wrist angles the joints of the wrist turn evenly along a line or an arc, on a curve smoothly from
    point to point, and how the tool turns follows from the arm; a path alone, without an arm, has a fixed
    axis then.
    """

    FIXED_AXIS = "fixed axis"
    DRIVE_TRANSFORM = "drive transform"
    WRIST_ANGLES = "wrist angles"


class Synchronisation(Enum):
    """Properties common to the joints of a PTP move in addition to start and end.

    With the phase they share one profile: at each time all have the same share of their way behind them, and
    the way is straight in joint space. With the time alone each has a profile of its own, as fast as its
    own limits allow and stretched to the time of the slowest one.
    """

    PHASE = "phase"
    TIME = "time"


class ShortLines(Enum):
    """How a controller flies chains of short lines with zones.

    As curves of least jerk within the zones, which controllers with a compressor do (for milling, bonding and
    welding along sampled points), or with a blend of its own at each point.
    """

    CURVES = "curves"
    ZONES = "zones"


@frozen_dataclass
class CorrectionLimits:
    """Limits of a path correction; estimated, as manuals keep theirs in settings of the cell.

    Attributes:
        size: greatest shift to either side [m].
        speed: greatest speed of the shift [m/s].
        acceleration: greatest acceleration of it [m/s²].
    """

    RANGES: ClassVar[Ranges] = {"size": EXTENT, "speed": RATE, "acceleration": RATE}

    size: float = 0.02
    speed: float = 0.02
    acceleration: float = 0.5


class ControllerKind(Enum):
    """The law of the joint controller.

    That of a file is a block diagram or a module of the project; the ideal one lets arms without drives be
    where they should.
    """

    CASCADED_P_PI = "cascaded_p_pi"
    COMPUTED_TORQUE = "computed_torque"
    FILE = "file"
    FLOW_LOAD_DAMPING = "flow_load_damping"
    PARALLEL_PI = "parallel_pi"
    IDEAL = "ideal"


LAW_WORDS = {
    ControllerKind.COMPUTED_TORQUE: "computed torque",
    ControllerKind.CASCADED_P_PI: "fixed gains",
    ControllerKind.FILE: "file of the project",
    ControllerKind.FLOW_LOAD_DAMPING: "flow, load and damping",
    ControllerKind.PARALLEL_PI: "parallel PI",
    ControllerKind.IDEAL: "ideal",
}
"""What people call the laws."""


@frozen_dataclass
class Rates:
    """The fixed periods of a controller; integer multiples of each other.

    Attributes:
        control_hz: joint controller ticks per second.
        interpolation_ticks: control ticks per interpolation tick.
        plant_steps: integration steps of drives and arm per control tick; None for steps of at most 0.5 ms,
            and as many more as the fastest pole of drives and arm needs. With steps of 0.5 ms, a palletizing
            run of the PUMA 560 is within 1.5e-8 rad and 1.1e-5 of the largest torque of one with an eighth.
    """

    RANGES: ClassVar[Ranges] = {
        "control_hz": whole(1, 1_000_000, "Hz"),
        "interpolation_ticks": whole(1, 1_000_000),
        "plant_steps": whole(1, 10_000),
    }

    control_hz: int = 1000
    interpolation_ticks: int = 4
    plant_steps: int | None = None

    @property
    def control_period(self) -> float:
        """Return the control period [s]."""
        return 1.0 / self.control_hz

    @property
    def interpolation_period(self) -> float:
        """Return the interpolation period [s]."""
        return self.interpolation_ticks / self.control_hz


GAIN_NAMES = ("kp", "kv", "ki", "kf", "ke", "ka")
"""The gains of the cascaded controller, in the order of its parameters."""


@record
class CascadedGains:
    """Gains of the cascaded P-PI joint controller, each of shape (n,).

    Position loop: qd_cmd = kp·(q_ref - q) + kf·qd_ref.
    Speed loop: u = kv·(qd_cmd - qd) + ki·∫(qd_cmd - qd) dt + ke·qd_ref + ka·qdd_ref, clipped to the
    amplifier's voltage; the integral stands still while the output is clipped.

    Attributes:
        kp: position gain [1/s].
        kv: speed gain [V·s/rad].
        ki: integral gain of the speed loop [V/rad].
        kf: share of the reference speed that is fed forward into the speed loop, usually 1.
        ke: voltage fed forward for the reference speed, against back-EMF and viscous friction [V·s/rad].
        ka: voltage fed forward for the reference acceleration [V·s²/rad].
    """

    RANGES: ClassVar[Ranges] = dict.fromkeys(GAIN_NAMES, COORDINATE)

    kp: Array
    kv: Array
    ki: Array
    kf: Array
    ke: Array
    ka: Array

    def __post_init__(self) -> None:
        for name in GAIN_NAMES:
            object.__setattr__(self, name, frozen(getattr(self, name)))


@record
class ComputedTorqueGains:
    """Gains of the computed-torque joint controller, each of shape (n,).

    With c = kd·(qd_ref - qd) + kp·(q_ref - q) it gives D(q, qd, qdd_ref + c + ki·∫c dt), the torque or force
    that the model of the arm with its drives, its tool and the grasped part needs for that acceleration;
    friction is taken at the speed of the reference. A DC motor gets the voltage for it, with the back-EMF at
    that speed, which is clipped to that of the amplifier; the integral stands still meanwhile. As far as the
    model is true the error of each axis obeys ë + kd·ė + kp·e = 0 with ki = 0, independent of the others
    (Luh, Walker & Paul 1980).

    Attributes:
        kp: [1/s²].
        kd: [1/s].
        ki: corner of the integral action, 0 for none [1/s].
    """

    RANGES: ClassVar[Ranges] = {"kp": COORDINATE, "kd": COORDINATE, "ki": COORDINATE}

    kp: Array
    kd: Array
    ki: Array

    def __post_init__(self) -> None:
        for name in ("kp", "kd", "ki"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


@record
class FlowGains:
    """Gains of the law of flow, load and damping of hydraulic axes, each of shape (n,).

    The valve gets the opening whose flow, at the pressures of the wanted motion, moves the rod at
    v + F'/k + kp·G·e + ki·∫G·e dt - kd/k·(f - f_slow), with its own rate times `lead` added to the part of
    the wanted motion. G is the ratio of the transmission, v = G·q̇_ref; F is the force that the model of the
    arm with its load needs, k the spring of the oil, e = q_ref - q, f the measured force beyond F, and
    f_slow what a low pass of the corner lets through of it. Where `swing` times the frequency at which the
    axis with its load swings on its oil, the others standing, is below kp, it takes the place of kp, and kd,
    corner and the root of ki are smaller by the same share. The integral stands still while the amplifier is
    at its limit.

    Attributes:
        kp: [1/s].
        ki: [1/s²].
        kd: rate at which the measured force damps the swing on the oil [1/s].
        corner: of the low pass [rad/s].
        lead: lag of valve and control that is made up for [s].
        swing: most of kp over the frequency at which the axis swings [1/s over rad/s].
    """

    RANGES: ClassVar[Ranges] = dict.fromkeys(("kp", "ki", "kd", "corner", "lead", "swing"), COORDINATE)

    kp: Array
    ki: Array
    kd: Array
    corner: Array
    lead: Array
    swing: Array

    def __post_init__(self) -> None:
        for name in ("kp", "ki", "kd", "corner", "lead", "swing"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


@record
class PiGains:
    """Gains of parallel PI loops, u = kp·e + ki·∫e dt with e = q_ref - q, each of shape (n,).

    u is the input of the amplifier, in A for valves; the integral stands still while it is clipped.

    Attributes:
        kp: [A/rad | A/m] for valves.
        ki: [A/(rad·s) | A/(m·s)] for valves.
    """

    RANGES: ClassVar[Ranges] = {"kp": COORDINATE, "ki": COORDINATE}

    kp: Array
    ki: Array

    def __post_init__(self) -> None:
        for name in ("kp", "ki"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


@frozen_dataclass
class NoGains:
    """The gains of the ideal joint controller: there are none."""

    RANGES: ClassVar[Ranges] = {}


Gains = CascadedGains | ComputedTorqueGains | FlowGains | PiGains | NoGains | ControllerFile


def gain_names(gains: Gains) -> tuple[str, ...]:
    """Return the names of the gains of a law, in the order of its parameters; the law of a file has none."""
    return () if isinstance(gains, ControllerFile) else tuple(one.name for one in fields(gains))


@frozen_dataclass
class PathDefaults:
    """Settings of tool paths where the program gives none.

    Attributes:
        speed: [m/s].
        acceleration: [m/s²].
        jerk: [m/s³].
        orientation_speed: [rad/s].
        orientation_acceleration: [rad/s²].
        orientation_jerk: [rad/s³].
    """

    RANGES: ClassVar[Ranges] = {
        "speed": RATE,
        "acceleration": RATE,
        "jerk": RATE,
        "orientation_speed": RATE,
        "orientation_acceleration": RATE,
        "orientation_jerk": RATE,
    }

    speed: float = 0.25
    acceleration: float = 2.0
    jerk: float = 20.0
    orientation_speed: float = 1.0
    orientation_acceleration: float = 6.0
    orientation_jerk: float = 60.0


@frozen_dataclass
class LookAhead:
    """How far beyond the present move a controller knows its path: as far as the longer of both goes.

    Attributes:
        moves: number of moves; with 0 no zone is flown.
        braking: length of path over the braking distance from the speed of the path to rest.
    """

    RANGES: ClassVar[Ranges] = {"moves": whole(0, 1_000_000, "moves"), "braking": between(0.0, 1e6)}

    moves: int = 10
    braking: float = 1.5


@record
class ControllerModel:
    """A whole controller.

    Attributes:
        kind: law of the joint controller.
        rates: periods.
        gains: gains of the joint controller, for its law, or the file that holds the law.
        path: settings of tool paths where the program gives none.
        in_position: a fine stop is over when every joint is this near its target [rad | m], and not faster
            than this way in 20 ms, shape (n,).
        settle_time: for which time both must hold [s].
        settle_timeout: longest wait for that [s]; beyond it a finding is made and the program goes on.
        speed_override: factor on all speeds, in (0, 1].
        look_ahead: how far beyond the present move the path is known.
        via_zone: distance at which via points are passed if the program sets no zone [m].
        orientation: how the tool turns on its paths.
        ptp: how the joints go together on PTP moves.
        short_lines: how chains of short lines with zones are flown.
        correction: how far and how quickly a sensor may shift a path.
        sensors: of the joint controller.
        entities: that modules of the project make in place of the built-in ones.
        built_in: built-in entities in place of the standard ones.
        origins: where the gains come from.
    """

    RANGES: ClassVar[Ranges] = {
        "in_position": between(0.0, 1e9),
        "settle_timeout": TIME,
        "settle_time": TIME,
        "speed_override": between(1e-6, 1.0),
        "via_zone": EXTENT,
    }

    kind: ControllerKind
    rates: Rates
    gains: Gains
    path: PathDefaults
    in_position: Array
    settle_timeout: float = 1.0
    settle_time: float = 0.004
    speed_override: float = 1.0
    look_ahead: LookAhead = LookAhead()
    via_zone: float = 0.01
    orientation: OrientationMode = OrientationMode.FIXED_AXIS
    ptp: Synchronisation = Synchronisation.PHASE
    short_lines: ShortLines = ShortLines.CURVES
    correction: CorrectionLimits = CorrectionLimits()
    sensors: JointSensors = JointSensors()
    entities: tuple[OwnEntity, ...] = ()
    built_in: tuple[NamedEntity, ...] = ()
    origins: tuple[ParameterOrigin, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "in_position", frozen(self.in_position))


SPEED_OVERSHOOT = 0.02
"""Share by which a servo may exceed a speed limit for a moment; more is a finding."""

OVERRUN = 1e-4
"""How far a servo may overrun the limit of a joint that it stands at [rad | m]; more is a finding."""
