"""The rows of `loops`, `springs` and `joint_springs`: closed chains, springs and dampers."""

from collections.abc import Mapping, Sequence
from itertools import accumulate

import numpy as np

from ropsim.model import BASE_LINK, Direction, Joint, JointSpring, JointType, LoopCut, Spring
from ropsim.robotfile.frames.rows import link_named
from ropsim.robotfile.frames.words import DIRECTIONS, FREE, coordinate_kinds, held_by
from ropsim.spatial import Array, Pose
from ropsim.tomltext import CONFLICTING_KEYS, NUMBER, ORIGIN, TomlTable, Units, read_pose

_FROM_ZERO = NUMBER.within(0.0, 1e12)


def read_loops(root: TomlTable, places: Mapping[str, int], units: Units) -> tuple[LoopCut, ...]:
    """Return the closed chains of a file.

    Args:
        root: the file, with the key `loops`.
        places: number of each link by its name.
        units: of the file.
    """
    return tuple(_loop(table, places, units) for table in root.tables("loops"))


def _loop(table: TomlTable, places: Mapping[str, int], units: Units) -> LoopCut:
    ends = []
    table.require("first", "second")
    for key in ("first", "second"):
        end = table.table(key)
        end.require("on")
        link = link_named(end, "on", places, BASE_LINK)
        ends.append((link, read_pose(end, units)))
        if end.present:
            end.finish()
    held = held_by(table.choice("joint", tuple(FREE), "fixed"))
    if "holds" in table:
        held = _held(table)
    table.finish()
    return LoopCut(*ends[0], *ends[1], held)


def _held(table: TomlTable) -> tuple[Direction, ...]:
    """Return the directions of the key `holds`."""
    value = table.values["holds"]
    if "joint" in table.values:
        message = "`joint` and `holds` both say how the chain is closed"
        table.findings.add(CONFLICTING_KEYS, table.key_span("holds"), message, "keep one of them")
    if not isinstance(value, list) or not set(map(str, value)) <= set(DIRECTIONS) or not value:
        table.wrong_type(("holds",), value, "a list of " + ", ".join(f'"{one}"' for one in DIRECTIONS))
        return tuple(Direction)
    return tuple(one for one in Direction if one.value in value)


def read_springs(
    root: TomlTable, places: Mapping[str, int], frames: Sequence[Pose], units: Units
) -> tuple[Spring, ...]:
    """Return the springs between bodies.

    Args:
        root: the file, with the key `springs`.
        places: number of each link by its name.
        frames: in which the file speaks of each link, in the frame of its joint.
        units: of the file.
    """
    found = []
    for number, table in enumerate(root.tables("springs"), start=1):
        table.require("first", "second", "stiffness")
        ends: list[tuple[int, Array]] = []
        for key in ("first", "second"):
            end = table.table(key)
            end.require("on")
            link = link_named(end, "on", places, BASE_LINK)
            point = np.array(end.numbers("point", 3, units.position, ORIGIN))
            if link != BASE_LINK and not frames[link].is_identity:
                point = frames[link].rotation() @ point + frames[link].position
            ends.append((link, point))
            if end.present:
                end.finish()
        name = table.text("name", f"spring {number}")
        numbers = (
            table.number("stiffness", _FROM_ZERO, 0.0),
            table.number("free_length", units.position.within(0.0, units.position.high), 0.0),
            table.number("damping", _FROM_ZERO, 0.0),
        )
        table.finish()
        found.append(Spring(name, *ends[0], *ends[1], *numbers))
    return tuple(found)


def read_joint_springs(root: TomlTable, joints: Sequence[Joint], units: Units) -> tuple[JointSpring, ...]:
    """Return the springs on coordinates of joints.

    Args:
        root: the file, with the key `joint_springs`.
        joints: of the robot.
        units: of the file.
    """
    known = {joint.name: number for number, joint in enumerate(joints) if joint.type.freedoms}
    first = [0, *accumulate(joint.type.freedoms for joint in joints)]
    found = []
    for number, table in enumerate(root.tables("joint_springs"), start=1):
        table.require("joint", "stiffness")
        joint = link_named(table, "joint", known, next(iter(known.values()), 0))
        kinds = coordinate_kinds(joints[joint].type) or (JointType.REVOLUTE,)
        place = table.integer("coordinate", 1, len(kinds), 1)
        way = units.turn if kinds[place - 1] is JointType.REVOLUTE else units.position
        name = table.text("name", f"joint spring {number}")
        numbers = (
            table.number("stiffness", _FROM_ZERO, 0.0),
            table.number("rest", way, 0.0),
            table.number("damping", _FROM_ZERO, 0.0),
        )
        table.finish()
        found.append(JointSpring(name, first[joint] + place - 1, *numbers))
    return tuple(found)
