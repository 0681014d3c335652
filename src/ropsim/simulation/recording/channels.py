"""The recorded channels: units, names and meaning."""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.dynamics import Column, structure_of
from ropsim.flow import Channel, ChannelGroup
from ropsim.model import Device, Joint, JointType, RobotModel
from ropsim.simulation.records.track import Track
from ropsim.simulation.servo.log import ARM_COLUMNS, POWER, REFERENCE_COLUMNS, LogLayout, recorded
from ropsim.spatial import Array, frozen

_ERROR = Column("q_error", "{q}", "reference minus attained joint coordinates")
_COORDINATE = {JointType.REVOLUTE: "rad", JointType.PRISMATIC: "m"}
_EFFORT = {JointType.REVOLUTE: "N·m", JointType.PRISMATIC: "N"}


def joint_channels(station: str, robot: RobotModel, log: Mapping[str, Array]) -> dict[str, Channel]:
    """Return the channels of the joints that a log holds, by quantity.

    Args:
        station: name of the station whose robot it is.
        robot: names and types of the joints.
        log: arrays by channel name, a column for each joint that has the quantity; other names are left out.
    """
    chains = structure_of(robot).drives
    drives = dict.fromkeys(column for chain in chains for column in recorded(chain))
    axes = {field.name: field.axes for field in LogLayout.of(chains).fields}
    channels = {}
    for column in (*ARM_COLUMNS, *drives, *REFERENCE_COLUMNS, _ERROR, POWER):
        if column.name in log:
            joints = [robot.axis_joints[k] for k in axes.get(column.name, range(robot.n))]
            values = np.asarray(log[column.name])
            names = tuple(joint.name for joint in joints)
            unit = _unit(column, joints)
            channels[column.name] = Channel(values, unit, names, column.text, ChannelGroup.JOINTS, station)
    return channels


def finger_channel(station: str, q: Array) -> Channel:
    """Return the channel of the fingers of a tool at rows of the recording, shape (rows,)."""
    text = "half the distance between the fingers"
    return Channel(q[:, np.newaxis], "m", ("finger",), text, ChannelGroup.PROGRAM, station)


def device_channel(device: Device, q: Array) -> Channel:
    """Return the channel of the coordinate of a device at rows of the recording, shape (rows,)."""
    joints = device.mechanism.axis_joints
    unit, names = _unit(ARM_COLUMNS[0], joints), tuple(joint.name for joint in joints)
    text = "coordinate of the device"
    return Channel(q[:, np.newaxis], unit, names, text, ChannelGroup.DEVICES, device.name)


def _unit(column: Column, joints: Sequence[Joint]) -> str:
    """Return the unit of a quantity of these joints, such as `rad | m`."""
    types = {joint.measure for joint in joints}
    coordinate, effort = (
        " | ".join(units[kind] for kind in JointType if kind in types) for units in (_COORDINATE, _EFFORT)
    )
    return column.unit.format(q=coordinate, tau=effort)


_TRACK_TEXTS = {
    "line": "active source line, 0 for none",
    "move": "ordinal of the active move, -1 for none",
    "gripper": "0 open, 1 closed",
    "payload": "mass of tool and grasped part",
    "override": "share of the planned speed at which motions are followed, 0 held",
}


def track_channel(station: str, name: str, track: Track, last: int, control_hz: int) -> Channel:
    """Return the channel of a piecewise constant quantity.

    Args:
        station: name of the station that it is of, where it is of one.
        name: `line`, `move`, `gripper`, `payload`, `override`, or `signal.NAME` for a signal of the cell.
        track: its values over time.
        last: tick at which the recording ends; later changes are left out.
        control_hz: ticks per second.
    """
    ticks, values = track.until(last)
    text = _TRACK_TEXTS.get(name)
    group, subject = (ChannelGroup.PROGRAM, station) if text else (ChannelGroup.SIGNALS, "")
    unit, times = "kg" if name == "payload" else "", frozen(ticks / control_hz)
    return Channel(frozen(values), unit, (), text or "signal of the cell", group, subject, times)


def pose_channels(station: str, kind: str, position: Array, orientation: Array) -> dict[str, Channel]:
    """Return position and orientation of the TCP, by quantity.

    Args:
        station: name of the station whose TCP it is.
        kind: `attained` or `command`.
        position: in the base frame [m], shape (rows, 3).
        orientation: unit quaternions, shape (rows, 4).
    """
    return {
        f"{kind}_position": Channel(
            position,
            "m",
            ("x", "y", "z"),
            f"{kind} TCP position in the base frame",
            ChannelGroup.TCP,
            station,
        ),
        f"{kind}_orientation": Channel(
            orientation,
            "",
            ("w", "x", "y", "z"),
            f"{kind} TCP orientation in the base frame, unit quaternion",
            ChannelGroup.TCP,
            station,
        ),
    }


def path_speed_channel(station: str, kind: str, speeds: Array) -> Channel:
    """Return the channel of speeds along paths in frames that are moved [m/s], shape (rows,), NaN elsewhere.

    Args:
        station: name of the station whose TCP it is.
        kind: `attained` or `command`.
        speeds: against the frame of the path.
    """
    text = f"{kind} speed of the TCP against the frame of its path, where external axes move that"
    return Channel(speeds, "m/s", (), text, ChannelGroup.TCP, station)


def correction_channel(station: str, values: Array) -> Channel:
    """Return the channel of path corrections [m], shape (rows,), NaN where no sensor corrects the path.

    Args:
        station: name of the station whose tool is shifted.
        values: along the direction that the move names.
    """
    text = "shift of the path along an axis of the tool, by a sensor"
    return Channel(values, "m", (), text, ChannelGroup.TCP, station)


def wrench_channel(station: str, values: Array) -> Channel:
    """Return the channel of the contact wrench at the mechanical interface, shape (rows, 6)."""
    text = (
        "force and moment on tool and held part by what they are pressed on, about the mechanical interface"
    )
    names = ("fx", "fy", "fz", "mx", "my", "mz")
    return Channel(values, "N | N·m", names, f"{text}, in the world frame", ChannelGroup.TCP, station)


def path_error_channel(station: str, errors: Array) -> Channel:
    """Return the channel of path errors [m], shape (rows,), NaN where there is none."""
    text = "distance of the attained TCP from the path of the tool, with its correction by a sensor"
    return Channel(errors, "m", (), text, ChannelGroup.TCP, station)
