"""The example with a track, a door and an indexing table: what happens when, and nothing meets anything."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import BodyKind, Cell, body_tree, grip_width, link_name, tool_body, tool_shapes
from ropsim.spatial import Array
from support.arm_capsules import block_around, fixed_blocks
from support.clearance import arm_tracks
from support.separation import Track, least_gap

EXAMPLE = Path(__file__).parents[2] / "examples" / "track_and_table"
PERIOD = 0.02  # [s] of the samples; the TCP goes 40 mm at most between two of them
KEPT = 0.025  # [m]; the fingers reach down beside a block and end 28 mm above what it lies on
ROUNDING = 1e-6  # [m]


@cache
def run_of() -> tuple[Cell, Recording]:
    project = ropsim.open(EXAMPLE)
    assert project.cell is not None
    return project.cell, project.simulate()


def coordinates(recording: Recording, mechanisms: tuple[str, ...], times: Array) -> dict[str, Array]:
    """Return the coordinates of mechanisms at some times, shape (k, n) each, by name."""
    rows = np.minimum(np.searchsorted(recording.time, times), len(recording.time) - 1)
    channels = {name: "q" if name == "robot" else f"{name}/q" for name in mechanisms}
    found = {name: recording.channels[channel].values[rows] for name, channel in channels.items()}
    return {name: values.reshape(len(rows), -1) for name, values in found.items()}


def test_there_is_nothing_to_find_fault_with() -> None:
    _, recording = run_of()
    assert recording.ok
    assert [str(found) for found in recording.findings] == []


def test_the_table_carries_one_block_at_each_quarter() -> None:
    cell, recording = run_of()
    last = {one.body: one for one in recording.placements if one.body.startswith("block")}
    assert {one.parent for one in last.values()} == {"table/link1"}
    end = coordinates(recording, ("robot", "door", "table"), np.array([recording.duration]))
    elsewhere = {one.body: (one.parent, one.X_PB) for one in last.values()}
    poses = body_poses(body_tree(cell), end, sorted(last), elsewhere)
    places = {tuple((1e3 * X[0, :3, 3]).round().astype(int).tolist()) for X in poses.values()}
    assert places == {(-800, 700, 890), (-650, 850, 890), (-800, 1000, 890), (-950, 850, 890)}


def test_the_arm_reaches_through_the_door_only_while_that_stands_open() -> None:
    cell, recording = run_of()
    times = np.arange(0.0, recording.duration, PERIOD)
    Q = coordinates(recording, ("robot", "door", "table"), times)
    hand = body_poses(body_tree(cell), Q, [tool_body("jaws")])[tool_body("jaws")]
    inside = (hand[:, 1, 3] > 0.5) & (hand[:, 0, 3] < 0.0)
    assert inside.any()
    assert Q["door"][inside, 0] == pytest.approx(-1.2, abs=ROUNDING)
    assert Q["robot"][inside, 6] == pytest.approx(-0.8, abs=0.001)
    door = recording.channels["door/q"].values.ravel()
    assert door[[0, -1]] == pytest.approx([0.0, 0.0], abs=ROUNDING)


def test_nothing_moves_while_the_table_is_loaded_but_the_arm() -> None:
    cell, recording = run_of()
    times = np.arange(0.0, recording.duration, PERIOD)
    Q = coordinates(recording, ("robot", "door", "table"), times)
    hand = body_poses(body_tree(cell), Q, [tool_body("jaws")])[tool_body("jaws")]
    near = (np.hypot(hand[:, 0, 3] + 0.8, hand[:, 1, 3] - 0.7) < 0.05) & (hand[:, 2, 3] < 1.1)
    turns = np.abs(np.diff(Q["table"][:, 0])) > ROUNDING
    assert near.any()
    assert turns.any()
    assert not (near[1:] & turns).any()


def test_arm_and_gripper_keep_clear_of_door_frame_and_stands() -> None:
    cell, recording = run_of()
    times = np.arange(0.0, recording.duration, PERIOD)
    tree, station = body_tree(cell), cell.first
    Q = coordinates(recording, ("robot", "door", "table"), times)
    arm = [link_name(number + 1) for number in station.robot.axes[:6]]
    poses = body_poses(tree, Q, [*arm, tool_body("jaws"), *tree.names(BodyKind.DEVICE)])
    frames = np.stack([poses[name] for name in arm], axis=1)
    always = np.ones(len(times), dtype=bool)
    hand = poses[tool_body("jaws")]
    tracks = [track for _, track in arm_tracks(frames)]
    for shape in tool_shapes(station.tools["jaws"], grip_width(cell)):
        block = block_around("gripper", shape.pose, shape)
        tracks.append(Track("gripper", hand @ block.centre.matrix(), block.half, 0.0, always))
    gaps = [least_gap(track, block, always)[0] for track in tracks for block in fixed_blocks(cell)]
    for name, device in cell.devices.items():
        back = np.linalg.inv(poses[link_name(1, name)])  # seen from its moving body, the arm moves
        for track in tracks:
            seen = Track(track.name, back @ track.poses, track.half, track.radius, always)
            shapes = device.mechanism.links[0].shapes
            gaps += [least_gap(seen, block_around(name, one.pose, one), always)[0] for one in shapes]
    assert np.isfinite(gaps).any()
    assert min(gaps) > KEPT
