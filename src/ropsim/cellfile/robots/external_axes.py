"""The external axes of a station in a cell file: the `track` of its arm, and a `positioner` next to it."""

from dataclasses import replace

from ropsim import robots
from ropsim.cellfile.poses import read_base
from ropsim.model import Mechanism, RobotModel, beside, on_track
from ropsim.spatial import Pose, record
from ropsim.tomltext import MASS, MOMENT, TomlTable, Units, read_pose

_LONGEST = 50.0  # [m]
_LEAST = 0.01  # [m] of travel, of a radius
_LOWEST = 0.5  # [m], of a gantry
_LIGHTEST = 1.0  # [kg]
_LEAST_INERTIA = 0.1  # [kg·m²]
_RISE = 10.0  # [1/s], greatest jerk over greatest acceleration, as in the library


@record
class ExternalAxes:
    """Axes that a station moves in addition to its arm.

    Attributes:
        track: carries the arm; None for an arm that stands still.
        X_LB: base of the arm in the frame of its carriage.
        positioner: stands next to the arm; None for none.
        X_WP: its base frame in the world frame.
    """

    track: Mechanism | None = None
    X_LB: Pose = Pose()
    positioner: Mechanism | None = None
    X_WP: Pose = Pose()

    def joined(self, arm: RobotModel, X_WB: Pose) -> RobotModel:
        """Return an arm with its external axes behind its own: first the track, then the positioner.

        Args:
            arm: the arm alone.
            X_WB: base frame of the whole, the foot of the track where there is one, in the world frame.
        """
        robot = arm if self.track is None else on_track(arm, self.track, self.X_LB)
        if self.positioner is None:
            return robot
        return beside(robot, self.positioner, X_WB.inverse() @ self.X_WP)


def read_external_axes(table: TomlTable, units: Units) -> ExternalAxes:
    """Return the external axes of `[robot]` or `[stations.NAME]`."""
    axes = ExternalAxes()
    if "track" in table:
        track, X_LB = _track(table.table("track"), units)
        axes = replace(axes, track=track, X_LB=X_LB)
    if "positioner" in table:
        positioner, X_WP = _positioner(table.table("positioner"), units)
        axes = replace(axes, positioner=positioner, X_WP=X_WP)
    return axes


def _track(table: TomlTable, units: Units) -> tuple[Mechanism, Pose]:
    kind = table.choice("kind", tuple(_TRACKS), "linear")
    mount = table.table("mount")
    X_LB = read_pose(mount, units)
    mount.finish()
    track = _limited(_TRACKS[kind](table, units), table, units)
    table.finish()
    return track, X_LB


def _positioner(table: TomlTable, units: Units) -> tuple[Mechanism, Pose]:
    kind = table.choice("kind", tuple(_POSITIONERS), "turntable")
    table.require("radius", "base")
    radius = table.number("radius", units.position.within(_LEAST, _LONGEST), 0.5)
    inertia = table.number("inertia", MOMENT.within(_LEAST_INERTIA, MOMENT.high), 40.0)
    height = table.number("height", units.position.within(_LEAST, _LONGEST), _HEIGHTS[kind])
    X_WP = read_base(table, units)
    positioner = _limited(_POSITIONERS[kind](radius, height, inertia), table, units)
    table.finish()
    return positioner, X_WP


def _linear(table: TomlTable, units: Units) -> Mechanism:
    table.require("length")
    length = table.number("length", units.position.within(_LEAST, _LONGEST), 1.0)
    return robots.linear_track(length, table.number("carriage_mass", _CARRIED, 250.0))


def _gantry(table: TomlTable, units: Units) -> Mechanism:
    table.require("length", "width", "height")
    way = units.position.within(_LEAST, _LONGEST)
    length, width = table.number("length", way, 1.0), table.number("width", way, 1.0)
    height = table.number("height", units.position.within(_LOWEST, _LONGEST), 2.0)
    bridge = table.number("bridge_mass", _CARRIED, 500.0)
    return robots.gantry(length, width, height, bridge, table.number("carriage_mass", _CARRIED, 150.0))


def _limited(mechanism: Mechanism, table: TomlTable, units: Units) -> Mechanism:
    """Return a mechanism with the speed and acceleration of the file for all its axes."""
    axes = mechanism.axis_joints
    if "speed" in table:
        speed = table.number("speed", units.rate(axes[0].type, 1), axes[0].max_speed)
        axes = tuple(replace(joint, max_speed=speed) for joint in axes)
    if "acceleration" in table:
        most = table.number("acceleration", units.rate(axes[0].type, 2), axes[0].max_acceleration)
        axes = tuple(replace(joint, max_acceleration=most, max_jerk=_RISE * most) for joint in axes)
    limited = dict(zip(mechanism.axes, axes, strict=True))
    joints = tuple(limited.get(number, joint) for number, joint in enumerate(mechanism.joints))
    return replace(mechanism, joints=joints)


_CARRIED = MASS.within(_LIGHTEST, MASS.high)
_TRACKS = {"linear": _linear, "gantry": _gantry}
_POSITIONERS = {"turntable": robots.turntable, "tilt_and_turn": robots.tilting_turntable}
_HEIGHTS = {"turntable": 0.7, "tilt_and_turn": 0.8}
