"""Jogging and live runs of a cell with two arms and a belt: each arm by its name, all in the frames."""

import struct
from pathlib import Path

import numpy as np
import pytest

from ropsim.kinematics import body_poses, forward
from ropsim.model import body_tree, link_name, start_of
from ropsim.spatial import Pose
from ropsim.studio.testing import (
    Clocks,
    Failed,
    JoggedArms,
    JogJoints,
    JogReply,
    JogTcp,
    LiveControl,
    LiveStart,
    run_live,
)
from ropsim.workbench import open_project
from support.live import FakeLine

TWO_ARMS = Path(__file__).parents[4] / "examples" / "two_arms"
PROJECT = open_project(TWO_ARMS)
CELL = PROJECT.cell
assert CELL is not None
TREE = body_tree(CELL)
ARMS = JoggedArms.of(CELL)
BENT = (0.1, 1.2, -2.8, 0.2, 0.5, 0.3)
#: Frames are in single precision [m, rad].
SINGLE = 1e-5
#: Of an inverse and a forward kinematics one after the other [rad].
ROUNDING = 1e-8
HEADER = 32


@pytest.mark.parametrize("name", ["left", "right"])
def test_a_jog_moves_the_bodies_of_its_station_only(name: str) -> None:
    assert CELL is not None
    reply = ARMS.move(JogJoints(name, BENT, ""))
    assert isinstance(reply, JogReply)
    (hand,) = (one for one in start_of(CELL) if one.startswith(f"{name}/tool:"))
    own = [*(link_name(number, name) for number in range(7)), f"{hand}/finger1", f"{hand}/finger2"]
    poses = body_poses(TREE, {name: np.array([BENT]), hand: start_of(CELL)[hand][None]}, own)
    assert [body for body, _ in reply.bodies] == [TREE.places()[one] for one in own]
    for (_, pose), matrix in zip(reply.bodies, poses.values(), strict=True):
        assert Pose.from_tuple(pose).matrix() == pytest.approx(matrix[0], abs=ROUNDING)


@pytest.mark.parametrize("name", ["left", "right"])
def test_the_tcp_of_a_station_is_that_of_its_own_tool_at_its_own_place(name: str) -> None:
    assert CELL is not None
    station = CELL.stations[name]
    reply = ARMS.move(JogJoints(name, BENT, ""))
    assert isinstance(reply, JogReply)
    X_WT = station.X_WB @ forward(station.robot, BENT) @ station.tools[station.default_tool].X_MT
    assert Pose.from_tuple(reply.tcp).matrix() == pytest.approx(X_WT.matrix(), abs=ROUNDING)
    back = ARMS.move(JogTcp(name, BENT, "", reply.tcp))
    assert isinstance(back, JogReply)
    assert back.q == pytest.approx(BENT, abs=ROUNDING)


def test_a_station_that_the_cell_lacks_is_refused_with_those_that_it_has() -> None:
    refused = ARMS.move(JogJoints("middle", BENT, ""))
    assert refused == Failed("the cell has no station `middle`, it has `left`, `right`")


def test_frames_of_a_live_run_have_the_poses_of_both_arms_and_of_the_belt() -> None:
    line = FakeLine([(1.5, LiveControl("stop"))])
    run_live(LiveStart(str(TWO_ARMS), {}, "right", 1.0), line, Clocks(line.now, lambda: 0.0))
    (layout,) = line.messages("layout")
    channels, bodies, stations = layout["channels"], layout["bodies"], layout["stations"]
    assert isinstance(channels, tuple)
    assert isinstance(bodies, tuple)
    assert stations == (
        {"name": "left", "program": "left", "source": "programs/left.task"},
        {"name": "right", "program": "right", "source": "programs/right.task"},
    )
    assert bodies == tuple(TREE.places()[name] for name in TREE.moving())
    names = [channel["name"] for channel in channels]
    frame = line.frames[-1]
    values = np.frombuffer(frame, "<f4", len(names), HEADER)
    poses = np.frombuffer(frame, "<f4", 7 * len(bodies), HEADER + values.nbytes).reshape(-1, 7)
    q = {name: values[[one == f"{name}/q" for one in names]][None] for name in TREE.mechanisms}
    expected = body_poses(TREE, q, TREE.moving())
    for pose, matrix in zip(poses, expected.values(), strict=True):
        assert pose[:3] == pytest.approx(matrix[0][:3, 3], abs=SINGLE)
    start = struct.unpack_from("<d", line.frames[0], 8)[0]
    assert start < struct.unpack_from("<d", frame, 8)[0]
    assert q["infeed"][0, 0] > 0.0
