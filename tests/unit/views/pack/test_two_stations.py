"""The pack and the scene of a cell with two arms and a belt: everything moves as it was recorded."""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.flow import GripEvent, Recording
from ropsim.kinematics import body_poses
from ropsim.model import BodyKind, Cell, body_tree
from ropsim.simulation import Fidelity, RunOptions
from ropsim.views import scene
from ropsim.workbench import open_project, pack_of
from support.packs import ReadPack, read_pack

TWO_ARMS = Path(__file__).parents[4] / "examples" / "two_arms"
#: Links are rounded to 10 µm and 2⁻¹⁵, coordinates are interpolated between rows [m].
NEAR = 2e-4
ROUNDING = 1e-12


@cache
def run() -> tuple[Cell, Recording, ReadPack]:
    """Run the example without dynamics, once for all tests."""
    project = open_project(TWO_ARMS)
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    assert project.cell is not None
    return project.cell, recording, read_pack(pack_of(project, recording))


def moving_at(cell: Cell, recording: Recording, times: list[float]) -> dict[str, Any]:
    """Return where the recorded coordinates put everything that joints move."""
    tree = body_tree(cell)
    q = {
        name: np.stack([np.interp(times, recording.time, one) for one in rows.T], axis=1)
        for name in tree.mechanisms
        for rows in [recording.channels[f"{name}/q"].values]
    }
    return body_poses(tree, q, tree.moving())


def test_arms_and_devices_are_where_their_recorded_coordinates_put_them() -> None:
    cell, recording, pack = run()
    times = [float(time) for time in pack.times[:: len(pack.times) // 40]]
    expected = moving_at(cell, recording, times)
    assert {"left/link6", "right/link6", "infeed/link1"} <= set(expected)
    for name, matrices in expected.items():
        for time, matrix in zip(times, matrices, strict=True):
            assert np.max(np.abs(pack.pose(name, time).matrix() - matrix)) < NEAR, (name, time)


def test_a_part_on_the_belt_goes_with_the_belt() -> None:
    cell, recording, pack = run()
    grip = next(one for one in recording.events_of(GripEvent) if one.part)
    times = [float(time) for time in np.linspace(0.1, grip.time - 0.1, 10)]
    belt = moving_at(cell, recording, times)["infeed/link1"][:, :3, 3]
    assert np.ptp(belt, axis=0).max() > 0.1
    for time, at in zip(times, belt, strict=True):
        ridden = pack.pose(grip.part, time).position - at
        assert ridden == pytest.approx(pack.pose(grip.part, times[0]).position - belt[0], abs=NEAR)


def test_each_station_has_its_base_in_the_pack_and_its_robot_in_the_scene() -> None:
    cell, _, pack = run()
    document: Any = scene(cell)
    described = document["stations"]
    assert [one["name"] for one in described] == list(cell.stations) == list(pack.header["bases"])
    for one, station in zip(described, cell.stations.values(), strict=True):
        assert one["base"] == pytest.approx(list(station.X_WB.as_tuple()), abs=ROUNDING)
        assert pack.header["bases"][station.name] == pytest.approx(one["base"], abs=ROUNDING)
        assert (one["program"], one["tool"]) == (station.program, station.default_tool)
        assert len(one["joints"]) == station.robot.n


def test_events_and_channels_say_whose_they_are() -> None:
    cell, recording, pack = run()
    for name in cell.stations:
        sources = {
            event["span"]["source"]
            for event in pack.header["events"]
            if event["station"] == name and event["span"]
        }
        assert [Path(source).stem for source in sources] == [cell.stations[name].program]
    for entry in pack.header["channels"]:
        owner, _, quantity = entry["name"].rpartition("/")
        assert f"{owner}/".startswith(f"{entry['subject']}/") or not owner, quantity
    assert set(recording.channels) == {entry["name"] for entry in pack.header["channels"]}


def test_bodies_of_devices_are_drawn_by_their_own_shapes_only() -> None:
    cell, _, _ = run()
    document: Any = scene(cell)
    own = {body.name: body.shapes for body in body_tree(cell).bodies if body.kind is BodyKind.DEVICE}
    drawn = {body["name"]: body["shapes"] for body in document["bodies"] if body["kind"] == "device"}
    assert drawn.keys() == own.keys()
    assert {name: len(shapes) for name, shapes in drawn.items()} == {
        name: len(shapes) for name, shapes in own.items()
    }


def test_each_arm_has_its_tool_and_its_tcp_on_its_own_last_link() -> None:
    cell, _, _ = run()
    document: Any = scene(cell)
    places = body_tree(cell).places()
    marks = {mark["name"]: mark for mark in document["frames"]}
    for name, station in cell.stations.items():
        last = places[f"{name}/link6"]
        assert document["bodies"][places[f"{name}/tool:{station.default_tool}"]]["parent"] == last
        assert (marks[f"{name}/tcp"]["kind"], marks[f"{name}/tcp"]["parent"]) == ("tcp", last)
        assert marks[f"{name}/base"]["pose"] == pytest.approx(list(station.X_WB.as_tuple()), abs=ROUNDING)


def test_the_extent_holds_the_reach_of_every_arm() -> None:
    cell, recording, _ = run()
    extent: Any = scene(cell)["extent"]
    times = [float(time) for time in recording.time[::200]]
    for matrices in moving_at(cell, recording, times).values():
        assert (matrices[:, :3, 3] >= np.array(extent["min"]) - NEAR).all()
        assert (matrices[:, :3, 3] <= np.array(extent["max"]) + NEAR).all()
