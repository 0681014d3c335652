"""The palletizing cell: 36 boxes from an infeed to a pallet, with true servo and arm dynamics."""

import shutil
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.flow import Destinations, GripEvent, MoveEvent, Recording, ReleaseEvent
from ropsim.simulation import Fidelity, RunOptions

CELL = Path(__file__).parents[2] / "examples" / "palletizing"
#: A box set down by a servo with a millimetre's path error stands this near to its slot [m].
PLACING = 1.0e-3


@pytest.fixture(scope="module")
def recording() -> Recording:
    return ropsim.open(CELL).simulate()


def test_nothing_goes_wrong(recording: Recording) -> None:
    assert [str(found) for found in recording.findings if found.severity.value != "hint"] == []


def test_every_box_is_gripped_and_released_once(recording: Recording) -> None:
    gripped = [event.part for event in recording.events_of(GripEvent)]
    released = [event.part for event in recording.events_of(ReleaseEvent)]
    assert len(set(gripped)) == 36
    assert gripped == released


def test_boxes_are_set_down_on_the_6_by_6_pattern(recording: Recording) -> None:
    cell = ropsim.open(CELL).cell
    assert cell is not None
    pallet = cell.frames["pallet"].X_PK
    times = [event.time for event in recording.events if event.kind == "release"]
    tcp = recording.channels["attained_position"].values[np.searchsorted(recording.time, times)]
    slots = [[0.075 * i, 0.075 * j, 0.04] for i in range(6) for j in range(6)]
    expected = np.array([pallet.position + pallet.rotation() @ np.array(slot) for slot in slots])
    order = [int(np.argmin(np.linalg.norm(expected - point, axis=1))) for point in tcp]
    assert sorted(order) == list(range(36))
    assert np.linalg.norm(tcp - expected[order], axis=1).max() < PLACING


def test_infeed_and_pallet_centre_are_half_a_metre_apart() -> None:
    cell = ropsim.open(CELL).cell
    assert cell is not None
    centre = cell.frames["pallet"].X_PK.position + cell.frames["pallet"].X_PK.rotation() @ np.array(
        [0.1875, 0.1875, 0.04]
    )
    assert float(np.linalg.norm(cell.locations["infeed"].position - centre)) >= 0.5


def test_every_joint_works_for_its_living(recording: Recording) -> None:
    travel = np.abs(np.diff(recording.channels["q"].values, axis=0)).sum(axis=0)
    assert (travel > 1.0).all()


def test_the_payload_changes_with_each_grasp(recording: Recording) -> None:
    payload = recording.rows("payload")
    assert np.ptp(payload) == pytest.approx(0.5)
    assert int((np.diff(payload) > 0).sum()) == 36


def test_approaches_run_at_their_speed_on_a_straight_line(recording: Recording) -> None:
    error = recording.channels["path_error"].values
    assert np.nanmax(error) < 2e-3
    speeds = np.linalg.norm(np.diff(recording.channels["command_position"].values, axis=0), axis=1)
    speed = np.max((speeds / np.diff(recording.time))[~np.isnan(error[1:]) & ~np.isnan(error[:-1])])
    assert speed == pytest.approx(0.150, rel=1e-3)


def test_the_same_project_gives_the_same_bits(recording: Recording) -> None:
    again = ropsim.open(CELL).simulate()
    for name, channel in recording.channels.items():
        assert channel.values.tobytes() == again.channels[name].values.tobytes(), name
    assert recording.events == again.events


def test_the_kinematic_run_commands_the_same_path(recording: Recording) -> None:
    ideal = ropsim.open(CELL).simulate(options=RunOptions(Fidelity.KINEMATIC))
    np.testing.assert_array_equal(ideal.channels["q"].values, ideal.channels["q_ref"].values)
    moves = [(event.span, event.travel) for event in recording.events_of(MoveEvent)]
    assert moves == [(event.span, event.travel) for event in ideal.events_of(MoveEvent)]
    assert ideal.duration <= recording.duration


def test_blends_at_the_approach_points_save_15_percent_of_the_cycle_time_and_each_of_them_its_part() -> None:
    options = RunOptions(Fidelity.KINEMATIC)
    found = ropsim.open(CELL).what_if(["zones=stop", "zones=each"], options=options)
    stops, *each = found.alternatives
    assert found.cycle_time < 0.85 * stops.cycle_time
    saved = [found.difference(one) for one in each]
    assert len(saved) == 4
    assert min(saved) > 5.0
    assert sum(saved) == pytest.approx(found.difference(stops), rel=0.01)


def test_the_boxes_are_at_their_destinations_where_the_cell_gives_them_some(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    shutil.copytree(CELL, folder)
    text = (folder / "cell.toml").read_text("utf-8")
    grid = "grid = { counts = [6, 6], step = [[75, 0, 0], [0, 75, 0]] }"
    goal = f"count = 36\ndestination = {{ position = [412.5, -147.5, 600], {grid}, tolerance = 1 }}\n"
    (folder / "cell.toml").write_text(text.replace("count = 36\n", goal), "utf-8")
    run = ropsim.open(folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
    assert run.facts.destinations == Destinations(36, 36)
    assert run.ok
    shifted = goal.replace("412.5", "414.5")
    (folder / "cell.toml").write_text(text.replace("count = 36\n", shifted), "utf-8")
    failed = ropsim.open(folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
    assert [found.code for found in failed.findings] == ["S738"] * 36
    assert "2.0 mm away, allowed are 1 mm" in failed.findings[0].message
