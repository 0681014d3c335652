"""The external axes of a station in a cell file: the `track` of its arm, and a `positioner` beside it."""

from dataclasses import replace

from ropsim import robots
from ropsim.cellfile.poses import read_base, read_pose
from ropsim.cellfile.quantity import MASS, MOMENT, Units
from ropsim.cellfile.tomltext.checks import TomlTable
from ropsim.model import JointType, Mechanism, RobotModel, beside, on_track
from ropsim.spatial import Pose, record

_LONGEST = 50.0  # [m]
_LEAST = 0.01  # [m] of travel, of a radius
_LIGHTEST = 1.0  # [kg]
_LEAST_INERTIA = 0.1  # [kg·m²]
_FASTEST = {JointType.PRISMATIC: 20.0, JointType.REVOLUTE: 100.0}
_HARDEST = {JointType.PRISMATIC: 1e3, JointType.REVOLUTE: 1e4}
_RISE = 10.0  # [1/s], greatest jerk over greatest acceleration, as in the library


@record
class ExternalAxes:
    """What a station moves beside its arm.

    Attributes:
        track: carries the arm; None for an arm that stands still.
        X_LB: base of the arm in the frame of its carriage.
        positioner: stands beside the arm; None for none.
        X_WP: its base frame in the world frame.
    """

    track: Mechanism | None = None
    X_LB: Pose = Pose()
    positioner: Mechanism | None = None
    X_WP: Pose = Pose()

    def joined(self, arm: RobotModel, X_WB: Pose) -> RobotModel:
        """Return an arm with its external axes behind its own: first the track, then the positioner.

        Args:
            arm: by itself.
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
    table.require("length")
    length = table.number("length", units.position.within(_LEAST, _LONGEST), 1.0)
    mass = table.number("carriage_mass", MASS.within(_LIGHTEST, MASS.high), 250.0)
    mount = table.table("mount")
    X_LB = read_pose(mount, units)
    mount.finish()
    track = _limited(robots.linear_track(length, mass), table, units)
    table.finish()
    return track, X_LB


def _positioner(table: TomlTable, units: Units) -> tuple[Mechanism, Pose]:
    table.require("radius", "base")
    radius = table.number("radius", units.position.within(_LEAST, _LONGEST), 0.5)
    height = table.number("height", units.position.within(_LEAST, _LONGEST), 0.7)
    inertia = table.number("inertia", MOMENT.within(_LEAST_INERTIA, MOMENT.high), 40.0)
    X_WP = read_base(table, units)
    turntable = _limited(robots.turntable(radius, height, inertia), table, units)
    table.finish()
    return turntable, X_WP


def _limited(mechanism: Mechanism, table: TomlTable, units: Units) -> Mechanism:
    """Return a mechanism of one axis with the speed and acceleration that the file gives."""
    number = mechanism.axes[0]
    joint = mechanism.joints[number]
    rate = units.path if joint.type is JointType.PRISMATIC else units.orientation
    speed = table.number("speed", rate(1, _FASTEST[joint.type]), joint.max_speed)
    acceleration = table.number("acceleration", rate(2, _HARDEST[joint.type]), joint.max_acceleration)
    changed = replace(joint, max_speed=speed, max_acceleration=acceleration, max_jerk=_RISE * acceleration)
    joints = (*mechanism.joints[:number], changed, *mechanism.joints[number + 1 :])
    return replace(mechanism, joints=joints)
