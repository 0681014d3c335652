"""External axes in the cell file: an arm on a track, and a positioner beside it."""

import math
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.kinematics import body_poses, forward
from ropsim.model import Cell, JointType, Station, body_tree

ROBOT = '[robot]\nmodel = "puma560"\n'
TRACK = "track = { length = 3000, speed = 1500, acceleration = 2000 }\n"
TABLE = (
    "positioner = { radius = 400, height = 600, base = { position = [200, 1500, 0], rpy = [0, 0, 90] } }\n"
)
POSE_TOLERANCE = 1e-12  # [m], a few roundings of coordinates of some metres


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", ROBOT + text), "folder")


def station_of(text: str) -> Station:
    cell, findings = read(text)
    assert [str(found) for found in findings] == []
    assert cell is not None
    return cell.first


def one(text: str) -> Diagnostic:
    cell, (found,) = read(text)
    assert cell is None
    return found


def test_an_arm_on_a_track_has_one_more_axis_behind_its_own() -> None:
    robot = station_of(TRACK).robot
    track = robot.axis_joints[6]
    assert (robot.n, robot.external, track.name, track.measure) == (7, (6,), "E1", JointType.PRISMATIC)
    assert (track.lower, track.upper) == (-1.5, 1.5)
    assert (track.max_speed, track.max_acceleration, track.max_jerk) == (1.5, 2.0, 20.0)
    assert [joint.name for joint in robot.axis_joints[:6]] == ["1", "2", "3", "4", "5", "6"]


def test_track_comes_before_positioner() -> None:
    robot = station_of(TRACK + TABLE).robot
    assert [joint.name for joint in robot.axis_joints[6:]] == ["E1", "E2"]
    assert [joint.measure for joint in robot.axis_joints[6:]] == [JointType.PRISMATIC, JointType.REVOLUTE]


def test_the_arm_comes_along_with_its_carriage() -> None:
    robot, arm = station_of(TRACK + "base = { position = [100, 0, 0] }\n").robot, robots.load("puma560")
    q = np.append(arm.home, 0.7)
    moved = forward(robot, q).position - forward(arm, arm.home).position
    assert moved == pytest.approx([0.7, 0.0, 0.35], abs=POSE_TOLERANCE)  # the carriage is 0.35 m high


def test_the_arm_may_be_turned_on_its_carriage() -> None:
    mounted = TRACK.replace(" }", ", mount = { position = [0, 0, 20], rpy = [0, 0, 90] } }")
    robot, arm = station_of(mounted).robot, robots.load("puma560")
    x, y, z = forward(arm, arm.home).position
    found = forward(robot, np.append(arm.home, 0.0)).position
    assert found == pytest.approx([-y, x, z + 0.37], abs=POSE_TOLERANCE)


def test_the_positioner_stands_in_the_world_wherever_the_robot_is() -> None:
    base = "base = { position = [300, -200, 0], rpy = [0, 0, 30] }\n"
    cell, _ = read(base + TABLE)
    assert cell is not None
    poses = body_poses(body_tree(cell), {"robot": [np.append(cell.first.robot.home[:6], 0.0)]})
    plate = poses["link7"][0]
    assert plate[:3, 3] == pytest.approx([0.2, 1.5, 0.6], abs=POSE_TOLERANCE)
    assert plate[:3, 0] == pytest.approx([0.0, 1.0, 0.0], abs=POSE_TOLERANCE)


HANGING = "length = 3000, width = 2000, height = 2500, mount = { rpy = [180, 0, 0] }"
GANTRY = f'track = {{ kind = "gantry", {HANGING} }}\n'
PLATE = "radius = 300, height = 800, speed = 60, base = { position = [900, 0, 0] }"
TILTING = f'positioner = {{ kind = "tilt_and_turn", {PLATE} }}\n'


def test_an_arm_hangs_from_a_gantry() -> None:
    robot, arm = station_of(GANTRY).robot, robots.load("puma560")
    assert [(joint.name, joint.lower, joint.upper) for joint in robot.axis_joints[6:]] == [
        ("E1", -1.5, 1.5),
        ("E2", -1.0, 1.0),
    ]
    x, y, z = forward(arm, arm.home).position
    found = forward(robot, np.append(arm.home, (0.4, -0.3))).position
    assert found == pytest.approx([x + 0.4, -y - 0.3, 2.5 - z], abs=POSE_TOLERANCE)


def test_a_plate_tilts_and_turns_with_what_hangs_on_it() -> None:
    nest = '[[objects]]\nname = "nest"\nparent = "positioner"\nposition = [0, 200, 0]\nsize = [50, 50, 10]\n'
    cell, findings = read(TILTING + nest)
    assert findings == ()
    assert cell is not None
    robot = cell.first.robot
    assert robot.max_speeds[6:] == pytest.approx([math.radians(60)] * 2)
    q = np.append(robot.home[:6], (math.pi / 2, math.pi / 2))
    placed = body_poses(body_tree(cell), {"robot": [q]})["nest"][0]
    # after the turn at x = -200 of the plate, which now stands upright and looks to -y
    assert placed[:3, 3] == pytest.approx([0.7, -0.1, 0.7], abs=POSE_TOLERANCE)
    assert placed[:3, 2] == pytest.approx([0.0, -1.0, 0.0], abs=POSE_TOLERANCE)


def test_start_has_a_value_for_every_axis_in_its_own_unit() -> None:
    station = station_of(TRACK + TABLE + "start = [0, 75, -180, 0, -75, 0, -1200, 45]\n")
    assert station.start[6:] == pytest.approx([-1.2, math.pi / 4])
    assert station_of(TRACK).start[6] == 0.0


def test_a_start_beyond_the_track_is_named_by_its_axis() -> None:
    found = one(TRACK + "start = [0, 75, -180, 0, -75, 0, 1600]\n")
    assert (found.code, found.message) == (
        "X815",
        "joint `E1` would start at 1600 mm, its limits are -1500 mm and 1500 mm",
    )


def test_the_gains_follow_from_the_drives_of_all_axes() -> None:
    controller = station_of(TRACK + TABLE).controller
    assert len(controller.in_position) == 8
    changed = station_of(TRACK + "[controller]\nin_position = [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 2]\n").controller
    assert changed.in_position[5:] == pytest.approx([math.radians(0.1), 0.002])


def test_gravity_of_a_tilted_track_is_felt_by_all_of_it() -> None:
    robot = station_of(TRACK + "base = { rpy = [0, 90, 0] }\n").robot
    assert robot.gravity == pytest.approx([9.81, 0.0, 0.0])


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        ('track = { kind = "gantri", length = 1000 }\n', "X808", "`linear`, `gantry`"),
        ('track = { kind = "gantry", length = 1000, width = 500 }\n', "X803", "needs `height`"),
        ("track = { length = 1000, width = 500 }\n", "X802", "`robot.track.width`"),
        ('positioner = { kind = "tilt", radius = 300, base = {} }\n', "X808", "`tilt_and_turn`"),
        ("track = {}\n", "X803", "`robot.track` needs `length`"),
        ("track = 3\n", "X804", "`robot.track` is a whole number"),
        ("track = { length = 0 }\n", "X806", "allowed is 10 to 50000 mm"),
        ("track = { length = inf }\n", "X807", "`inf`"),
        ("track = { length = 1000, sped = 1 }\n", "X802", "`robot.track.sped`"),
        ("track = { length = 1000, speed = nan }\n", "X807", "`nan`"),
        ("track = { length = 1000, carriage_mass = 0 }\n", "X806", "allowed is 1 to 10000 kg"),
        ("positioner = { radius = 300 }\n", "X803", "`robot.positioner` needs `base`"),
        ("positioner = { radius = -1, base = {} }\n", "X806", "allowed is 10 to 50000 mm"),
        (
            TRACK + "start = [0, 75, -180, 0, -75, 0]\n",
            "X805",
            "6 items, needed are 7: 6 of the arm, then E1 (track)",
        ),
    ],
)
def test_each_mistake_gets_one_finding(text: str, code: str, words: str) -> None:
    found = one(text)
    assert found.code == code
    assert words in found.message
    assert found.span is not None
    assert found.span.line in {3, 4}


def test_stations_have_external_axes_of_their_own() -> None:
    text = (
        '[stations.left]\nrobot = "puma560"\n'
        '[stations.right]\nrobot = "scara"\nbase = { position = [0, 4000, 0] }\n' + TRACK
    )
    cell, findings = read_cell(SourceText("cell.toml", text), "folder")
    assert findings == ()
    assert cell is not None
    axes: dict[str, Any] = {name: station.robot.n for name, station in cell.stations.items()}
    assert axes == {"left": 6, "right": robots.load("scara").n + 1}


OBJECT = '[[objects]]\nname = "fixture"\nposition = [0, 0, 20]\nsize = [80, 80, 20]\n'


@pytest.mark.parametrize(
    ("axes", "parent", "body"),
    [
        (TABLE, "positioner", "link7"),
        (TRACK, "track", "link2"),  # the slide and the plate that turns its frame back
        (TRACK + TABLE, "track", "link2"),
        (TRACK + TABLE, "positioner", "link9"),
    ],
)
def test_an_object_hangs_on_what_an_external_axis_moves(axes: str, parent: str, body: str) -> None:
    cell, findings = read(axes + OBJECT + f'parent = "{parent}"\n')
    assert findings == ()
    assert cell is not None
    assert cell.objects[0].parent == body


def test_the_frame_of_the_plate_is_in_its_middle_on_top_and_turns_with_it() -> None:
    cell, _ = read(TABLE + OBJECT.replace("[0, 0, 20]", "[100, 0, 20]") + 'parent = "positioner"\n')
    assert cell is not None
    q = [np.append(cell.first.robot.home[:6], math.pi / 2.0)]
    pose = body_poses(body_tree(cell), {"robot": q})["fixture"][0]
    assert pose[:3, 3] == pytest.approx([0.1, 1.5, 0.62], abs=POSE_TOLERANCE)  # base 90°, axis 90°
    assert pose[:3, 0] == pytest.approx([-1.0, 0.0, 0.0], abs=POSE_TOLERANCE)


def test_stations_of_the_long_form_have_their_name_before_the_axis() -> None:
    text = '[stations.left]\nrobot = "puma560"\n' + TABLE + OBJECT + 'parent = "left/positioner"\n'
    cell, findings = read_cell(SourceText("cell.toml", text), "folder")
    assert findings == ()
    assert cell is not None
    assert cell.objects[0].parent == "left/link7"


@pytest.mark.parametrize(
    ("text", "code", "line", "words"),
    [
        (OBJECT + 'parent = "positioner"\n', "X809", 7, "object `positioner` is not defined in this cell"),
        (TABLE + OBJECT + 'parent = "positoner"\n', "X809", 8, "did you mean `positioner`?"),
        (TABLE + OBJECT + 'parent = "track"\n', "X809", 8, "objects of this cell: `fixture`, `positioner`"),
        (TABLE + OBJECT.replace("fixture", "positioner"), "X810", 5, "the name `positioner` is taken"),
        (TRACK + '[devices.track]\nkind = "slide"\n', "X810", 4, "the name of an external axis of this cell"),
        (TABLE + OBJECT.replace("fixture", "link7"), "X810", 5, "the name `link7` is taken"),
    ],
)
def test_names_of_axes_are_looked_at_as_all_others(text: str, code: str, line: int, words: str) -> None:
    _, findings = read(text)
    found = next(one for one in findings if one.code == code)
    assert found.span is not None
    assert found.span.line == line
    assert words in f"{found.message} {found.hint}"


PART = '[[parts]]\nname = "box"\nsize = [60, 60, 40]\nmass = 0.5\n'


@pytest.mark.parametrize(
    ("axes", "place", "codes"),
    [
        (TABLE, [200, 1500, 640], []),
        (TABLE, [200, 1500, 660], ["X819"]),
        (TABLE, [200, 1500, 600], ["X825"]),
        (TRACK, [300, 0, 390], []),
        (TRACK, [300, 0, 420], []),  # nothing else is there: it is not known what carries parts
        (TRACK, [300, 0, 350], []),
        (TRACK + TABLE, [300, 0, 420], ["X819"]),
        (TRACK + TABLE, [300, 0, 350], ["X825"]),
    ],
)
def test_parts_on_external_axes_are_looked_at_when_the_file_is_read(
    axes: str, place: list[int], codes: list[str]
) -> None:
    cell, findings = read(axes + PART + f"position = {place}\n")
    assert cell is not None
    assert [one.code for one in findings] == codes
    assert all(one.span is not None and one.span.line >= 8 for one in findings)


def test_a_part_in_the_plate_of_a_positioner_is_told_with_the_word_of_the_cell_file() -> None:
    (found,) = read(TABLE + PART + "position = [200, 1500, 600]\n")[1]
    assert found.message.startswith("part `box` is in the positioner at the start: it would be free 40.0 mm")
