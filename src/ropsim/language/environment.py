"""Names that a program can use beyond its own text: frames, tools, locations, signals, library tasks."""

import math
from collections.abc import Mapping
from dataclasses import field

from ropsim.core import frozen_dataclass
from ropsim.icr import Location
from ropsim.program import Expression, SignalUse, Task
from ropsim.spatial import PoseTuple


@frozen_dataclass
class TaskSignature:
    """A task of the library.

    Attributes:
        task: its structured program; names, types and order of the parameters stand there.
        dimensions: for each REAL parameter, the dimension of a bare number: `length`, `angle`, `time`,
            `speed`, `accel`, `force` or `num`; parameters not named here are plain numbers.
        defaults: value of each parameter that a call may leave out.
        source: name of the text that it was made of.
        version: of its effect; empty if unknown.
    """

    task: Task
    dimensions: Mapping[str, str] = field(default_factory=dict)
    defaults: Mapping[str, Expression] = field(default_factory=dict)
    source: str = ""
    version: str = ""


@frozen_dataclass
class PointTable:
    """A list of points of the project.

    Attributes:
        points: poses in the frame in which the list is read, in their order [m, unit quaternion w x y z];
            none where a line of the list is wrong, so that no program can use it.
        names: number of each point that has a name, from 1.
        source: name of its text.
        places: lines in which the points stand, in their order; empty if they have none.
    """

    points: tuple[PoseTuple, ...]
    names: Mapping[str, int] = field(default_factory=dict)
    source: str = ""
    places: tuple[int, ...] = ()


@frozen_dataclass
class Environment:
    """The names that a cell and a library define for programs.

    Attributes:
        frames: pose of each frame in the base frame [m, unit quaternion w x y z]; of one that moves where it
            is at the start.
        moving: names of the frames that external axes move.
        tools: pose of each tool in the mechanical interface frame.
        default_tool: tool in force at the start, empty for none.
        locations: poses in the base frame, or in the frame that `located` names, with values of external axes
            behind them where they have some.
        others_tools: names of the tools of the cell that the station has not.
        measured: quantity measured by analog inputs, by the sensors of the cell: `length` or `force`, by
            name.
        told: names of the devices by names of the inputs that they set.
        located: names of the frames that move in which locations are given, by the name of the location.
        given: frames that stand still in which locations are given, X_BF, by the name of the location; the
            base frame where none is named.
        free: names of the locations whose orientation is free.
        signals: channels by name.
        tasks: library tasks by name.
        refused: library tasks that there are and that cannot be called, with the reason, by name.
        listed: names of all tasks of the library, those too that `tasks` leaves out because the text does
            not name them; a misspelt call is near to one of these.
        length: metres per bare unit where a text has no `units` line for lengths.
        angle: radians per bare unit.
        frame: name of the frame of the locations in texts, empty for the base frame.
        axes: measure of each axis of the robot, `angle` or `length`; empty if unknown, then a bare joint
            coordinate is an angle.
        external: the same for each external axis of the robot.
        postures: the words that a posture of the arm may have, for each of its parts; empty if they have no
            names, None if the arm is unknown.
        lists: lists of points by name.
        up: z of the world in the base frame [unit vector].
    """

    frames: Mapping[str, PoseTuple] = field(default_factory=dict)
    tools: Mapping[str, PoseTuple] = field(default_factory=dict)
    default_tool: str = ""
    locations: Mapping[str, Location] = field(default_factory=dict)
    signals: Mapping[str, SignalUse] = field(default_factory=dict)
    tasks: Mapping[str, TaskSignature] = field(default_factory=dict)
    refused: Mapping[str, str] = field(default_factory=dict)
    listed: tuple[str, ...] = ()
    length: float = 0.01
    angle: float = math.pi / 180.0
    frame: str = ""
    axes: tuple[str, ...] = ()
    external: tuple[str, ...] = ()
    moving: frozenset[str] = frozenset()
    located: Mapping[str, str] = field(default_factory=dict)
    given: Mapping[str, PoseTuple] = field(default_factory=dict)
    others_tools: frozenset[str] = frozenset()
    measured: Mapping[str, str] = field(default_factory=dict)
    told: Mapping[str, str] = field(default_factory=dict)
    postures: tuple[tuple[str, ...], ...] | None = None
    lists: Mapping[str, PointTable] = field(default_factory=dict)
    up: tuple[float, float, float] = (0.0, 0.0, 1.0)
    free: frozenset[str] = frozenset()


NO_SIGNATURES = Environment()
