"""Names of a cell that programs can use, for the compiler."""

from collections.abc import Mapping

from ropsim.kinematics import frame_poses, solver_of
from ropsim.language import NO_SIGNATURES, Environment
from ropsim.model import (
    WORLD,
    Cell,
    JointType,
    RobotModel,
    Station,
    in_base,
)
from ropsim.program import SignalUse, ValueType
from ropsim.spatial import Pose, PoseTuple, quaternion

_MEASURES = {JointType.REVOLUTE: "angle", JointType.PRISMATIC: "length"}


def environment_of(cell: Cell | None, station: Station | None = None) -> Environment:
    """Return frames, tools, locations and signals of a cell as the compiler's environment.

    Programs express poses in the base frame B of their robot, so frames are X_BK and locations X_BT here. A
    frame that external axes move has the pose that it has at the start, and a location in it is X_KT.

    Args:
        cell: None for a program without one.
        station: that runs the program; None for the first one of the cell.
    """
    if cell is None:
        return NO_SIGNATURES
    at = station or cell.first
    still = {name: pose for name, pose in cell.locations.items() if name not in cell.located}
    relative = {name: cell.locations[name] for name in cell.located}
    return Environment(
        frames=_tuples(in_base(at.X_WB, frame_poses(cell))),
        tools={name: tool.X_MT.as_tuple() for name, tool in at.tools.items()},
        default_tool=at.default_tool,
        locations={
            name: (*pose.as_tuple(), *cell.external_at(name, at))
            for name, pose in {**in_base(at.X_WB, still), **relative}.items()
        },
        signals={
            name: SignalUse(name, signal.is_input, ValueType.REAL if signal.analog else ValueType.BOOL)
            for name, signal in cell.signals.items()
        },
        length=cell.classic.length,
        angle=cell.classic.angle,
        frame=cell.classic.frame,
        axes=tuple(_MEASURES[joint.measure] for joint in at.robot.axis_joints),
        external=tuple(_MEASURES[at.robot.axis_joints[k].measure] for k in at.robot.external),
        moving=frozenset(name for name, frame in cell.frames.items() if frame.parent != WORLD),
        located=cell.located,
        free=cell.free,
        given=_given(cell, at),
        measured={
            name: signal.sensor.measures
            for name, signal in cell.signals.items()
            if signal.analog and signal.sensor
        },
        told={name: device.name for device in cell.devices.values() for name in device.tells},
        others_tools=frozenset(cell.tools) - set(at.tools),
        postures=_postures(at.robot),
        up=quaternion.rotate(at.X_WB.inverse().as_tuple()[3:], (0.0, 0.0, 1.0)),
    )


def _given(cell: Cell, station: Station) -> Mapping[str, PoseTuple]:
    """Return the frames X_BF in which locations are given that do not move: that of a key `frame`, else W."""
    frames = {name: frame.X_PK for name, frame in cell.frames.items() if frame.parent == WORLD}
    named = {
        name: frames.get(cell.given.get(name, ""), Pose())
        for name in cell.locations
        if name not in cell.located
    }
    return _tuples(in_base(station.X_WB, named))


def _postures(robot: RobotModel) -> tuple[tuple[str, ...], ...]:
    """Return the words that a posture of an arm may have, for each of its parts; empty for none."""
    if not robot.has_arm:
        return ()
    return tuple(
        tuple(dict.fromkeys(words))
        for words in zip(*(one.words for one in solver_of(robot).postures), strict=True)
    )


def _tuples(poses: Mapping[str, Pose]) -> dict[str, PoseTuple]:
    return {name: pose.as_tuple() for name, pose in poses.items()}
