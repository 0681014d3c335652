"""The names that a place of a text can use, with their descriptions."""

import math
import re
from collections.abc import Iterator
from itertools import pairwise

from ropsim.core import frozen_dataclass, plural
from ropsim.language import Outline, PointTable, Role, Space, TaskForm, Uses
from ropsim.lsp.analysis.types_of import type_of_parameter, variable_types
from ropsim.lsp.analysis.workshop import Surroundings
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.parameters import Position
from ropsim.model import WORLD, JointType, Signal, Station, in_base, still_frames
from ropsim.spatial import Pose, quaternion
from ropsim.workbench import CheckedText

_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)


@frozen_dataclass
class Known:
    """A name that can be used.

    Attributes:
        name: as written.
        role: its kind of value.
        text: the most important about it on one line.
        origin: `cell` or `text`.
        where: frame of its pose, empty if it has no frame.
        note: further remark; may be empty.
        type: in a word of the language if the compiler has determined it; else empty.
    """

    name: str
    role: Role
    text: str
    origin: str
    where: str = ""
    note: str = ""
    type: str = ""


def word_at(document: Document, position: Position) -> tuple[str, int] | None:
    """Return the word at a place and its column in characters, None where none touches it."""
    column = document.column(position)
    for match in _WORD.finditer(document.line(position.line)):
        if match.start() <= column <= match.end():
            return match[0], match.start()
    return None


def of_cell(around: Surroundings) -> Iterator[Known]:
    """Yield the names that the cell defines."""
    cell, station = around.cell, around.station
    if cell is None or station is None:
        return
    still = {name: pose for name, pose in cell.locations.items() if name not in cell.located}
    places = {name: (pose, "in the base frame") for name, pose in in_base(station.X_WB, still).items()}
    places |= {name: (cell.locations[name], f"in the frame {frame}") for name, frame in cell.located.items()}
    for name, (pose, where) in places.items():
        note = external_words(station, cell.external_at(name, station))
        yield Known(name, Role.LOCATION, pose_words(pose), "cell", where, note)
    for name, pose in in_base(station.X_WB, still_frames(cell.frames)).items():
        yield Known(name, Role.FRAME, pose_words(pose), "cell", "in the base frame")
    for name, one in cell.frames.items():
        if one.parent != WORLD:
            yield Known(name, Role.FRAME, pose_words(one.X_PK), "cell", f"on {one.parent}, which moves")
    for name, tool in station.tools.items():
        yield Known(name, Role.TOOL, pose_words(tool.X_MT), "cell", "in the mechanical interface")
    for name, table in around.environment.lists.items():
        yield Known(name, Role.LIST, list_words(table), "cell", "in the frame in force")
    for name, signal in cell.signals.items():
        yield Known(name, Role.SIGNAL, signal_words(signal), "cell")


def of_text(uses: Uses, line: int, checked: CheckedText) -> Iterator[Known]:
    """Yield the names that the text defines and a statement in line `line` (from 0) can use, except tasks."""
    types = variable_types(uses, checked)
    for one in uses.seen_at(line + 1).values():
        if one.role is not None and one.space is not Space.TASK:
            type_ = types.get(one) or type_of_parameter(one, checked)
            yield Known(one.name, one.role, one.line or one.role.value, "text", type=type_)


def list_words(table: PointTable) -> str:
    """Return how many points a list has, how long the way through them is, and where the first one is."""
    if not table.points:
        return "its text is wrong"
    way = sum(math.dist(one[:3], other[:3]) for one, other in pairwise(table.points))
    count, first = plural(len(table.points), "point"), pose_words(Pose.from_tuple(table.points[0]))
    return f"{count}, {_shown(way * 1000.0, 1)} mm from one to the next; the first is {first}"


def pose_words(pose: Pose) -> str:
    """Return a pose in millimetres and degrees; the orientation as fixed XYZ angles."""
    x, y, z, *turn = pose.as_tuple()
    yaw, pitch, roll = quaternion.to_zyx((turn[0], turn[1], turn[2], turn[3]))
    place = ", ".join(_shown(value * 1000.0, 1) for value in (x, y, z))
    turned = ", ".join(_shown(math.degrees(value), 1) for value in (roll, pitch, yaw))
    return f"({place}) mm, roll pitch yaw ({turned})°"


def external_words(station: Station, values: tuple[float, ...]) -> str:
    """Return where the external axes of a station stand; empty without values."""
    joints = [station.robot.axis_joints[k] for k in station.robot.external][: len(values)]
    shown = [
        f"{joint.name} {_shown(math.degrees(value), 1)}°"
        if joint.measure is JointType.REVOLUTE
        else f"{joint.name} {_shown(value * 1000.0, 1)} mm"
        for joint, value in zip(joints, values, strict=True)
    ]
    return f"external axes: {', '.join(shown)}" if shown else ""


def signal_words(signal: Signal) -> str:
    """Return direction, sort and first value of a signal."""
    sort = "analog " if signal.analog else ""
    first = f"{signal.initial:g}" if signal.analog else ("on" if signal.initial else "off")
    return f"{sort}{'input' if signal.is_input else 'output'}, {first} at the start"


def task_notes(outline: Outline, name: str) -> tuple[str, ...]:
    """Return the comment and the contract of a task of the text."""
    return next((task.notes for task in outline.tasks if task.definition.name == name), ())


def task_words(form: TaskForm) -> str:
    """Return how a task is called."""
    return f"task {form}"


def _shown(value: float, digits: int) -> str:
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
