"""Packs of real runs: what a page shows is what was simulated."""

import importlib
import json
from dataclasses import asdict, dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from ropsim.core import Diagnostic, Severity
from ropsim.flow import Channel, GripEvent, Recording, ReleaseEvent
from ropsim.kinematics import forward_batch
from ropsim.model import WORLD, Cell, body_tree
from ropsim.records import numeric, read_recording, write_recording
from ropsim.simulation import Fidelity, RunOptions
from ropsim.simulation.testing import CellRun
from ropsim.views import pack, result_figures, scene, summarize
from ropsim.views.testing import sample_times
from ropsim.workbench import Project, open_project, pack_of
from support.packs import ReadPack, read_pack

EXAMPLES = Path(__file__).parents[4] / "examples"
#: The part is drawn by a pose between two samples, of links that are rounded to 10 µm and 2⁻¹⁵ [m].
JUMP = 1e-4
#: Placements are told from recorded rows; the arm stands still when the gripper acts [m].
RESTING = 1e-6


@dataclass(frozen=True)
class Shown:
    """A run, what the simulator knew at its end, its file for pages and the pack in it."""

    project: Project
    cell: Cell
    recording: Recording
    end: CellRun
    content: bytes
    pack: ReadPack


@cache
def show(name: str) -> Shown:
    """Run an example, once for all tests."""
    module = importlib.import_module("ropsim.simulation.run")
    ends: list[CellRun] = []
    original = module.recording_of

    def remember(state: CellRun, *rest: object) -> Recording:
        ends.append(state)
        recording: Recording = original(state, *rest)
        return recording

    project = open_project(EXAMPLES / name)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "recording_of", remember)
        recording = project.simulate()
    assert project.cell is not None
    content = pack_of(project, recording)
    return Shown(project, project.cell, recording, ends[0], content, read_pack(content))


@pytest.fixture(scope="module", params=["first_cell", "fig5", "palletizing"])
def shown(request: pytest.FixtureRequest) -> Shown:
    return show(request.param)


@pytest.mark.slow
def test_every_recorded_channel_is_there_and_true(shown: Shown) -> None:
    names = [entry["name"] for entry in shown.pack.header["channels"]]
    assert names == list(shown.recording.channels)
    for name, worst in (("q", 1e-6), ("qd", 1e-4), ("tau", 1e-3), ("attained_position", 1e-6)):
        for k, column in enumerate(shown.recording.channels[name].values.T):
            at = np.interp(shown.pack.times, shown.recording.time, column)
            assert np.max(np.abs(shown.pack.column(name, k) - at)) <= worst / 2 * (1 + 1e-6), name


def test_the_last_link_is_where_forward_kinematics_has_it(shown: Shown) -> None:
    cell, times = shown.cell, shown.pack.times[:: max(len(shown.pack.times) // 50, 1)]
    q = np.stack(
        [np.interp(times, shown.recording.time, one) for one in shown.recording.channels["q"].values.T]
    )
    expected = cell.first.X_WB.matrix() @ forward_batch(cell.first.robot, q.T)
    for time, X_WM in zip(times, expected, strict=True):
        shown_pose = (
            shown.pack.pose(f"link{cell.first.robot.n}", float(time)) @ cell.first.robot.X_nM
        ).matrix()
        assert np.max(np.abs(shown_pose - X_WM)) < 2e-4


def test_no_part_jumps_when_it_is_taken_or_left(shown: Shown) -> None:
    recording = shown.recording
    grips, releases = recording.events_of(GripEvent), recording.events_of(ReleaseEvent)
    acts = [(one.part, one.end) for one in grips if one.part]
    acts += [(one.part, one.end) for one in releases if one.part]
    assert acts
    for name, time in acts:
        before, at = shown.pack.pose(name, time - 1e-6), shown.pack.pose(name, time)
        assert np.linalg.norm(before.position - at.position) < JUMP


def test_parts_end_where_the_simulation_has_them(shown: Shown) -> None:
    end, duration = shown.end.parts, shown.recording.duration
    for part in shown.cell.parts:
        gone = part.name in end.queued or part.name in end.left
        assert shown.pack.visible(part.name, duration) == (not gone)
        if part.name in end.seats and end.seats[part.name].rides == WORLD:
            X_WO = end.seats[part.name].pose
            error = shown.pack.pose(part.name, duration).position - X_WO.position
            assert np.max(np.abs(error)) < RESTING


def test_supplies_show_one_part_at_a_time(shown: Shown) -> None:
    pack_, supplies = shown.pack, {part.supply for part in shown.cell.parts if part.supply}
    for supply in supplies:
        waiting = [part for part in shown.cell.parts if part.supply == supply]
        for time in np.linspace(0.0, shown.recording.duration, 40):
            at_supply = [
                part.name
                for part in waiting
                if pack_.visible(part.name, float(time))
                and np.linalg.norm(pack_.pose(part.name, float(time)).position - part.X_WO.position) < 1e-9
            ]
            assert len(at_supply) <= 1


def test_changes_of_held_channels_have_the_exact_times_of_the_events(shown: Shown) -> None:
    grips = [one for one in shown.recording.events if one.kind == "grip"]
    gripper = next(entry for entry in shown.pack.header["channels"] if entry["name"] == "gripper")
    code = gripper["columns"][0]["code"]
    closed = [time for time, value in zip(code["times"], code["values"], strict=True) if value == 1.0]
    assert closed == pytest.approx([one.end for one in grips], abs=1e-9)


def test_bodies_are_those_of_the_scene(shown: Shown) -> None:
    described = scene(shown.cell)["bodies"]
    assert isinstance(described, list)
    names = [entry["name"] for entry in shown.pack.header["bodies"]]
    assert names == [body["name"] for body in described]
    assert names == [body.name for body in body_tree(shown.cell).bodies]


def test_the_36_boxes_end_on_the_pallet() -> None:
    shown = show("palletizing")
    pallet, end = shown.cell.frames["pallet"].X_PK, shown.recording.duration
    boxes = np.array([shown.pack.pose(f"box_{k}", end).position for k in range(1, 37)])
    local = (boxes - pallet.position) @ pallet.rotation()
    slots = np.array([[0.075 * i, 0.075 * j, 0.04] for i in range(6) for j in range(6)])
    nearest = np.linalg.norm(local[:, None] - slots[None], axis=2)
    assert np.max(np.min(nearest, axis=1)) < 1e-3
    assert sorted(np.argmin(nearest, axis=1)) == list(range(36))


def test_the_same_run_gives_the_same_bytes(shown: Shown) -> None:
    assert pack_of(shown.project, shown.recording) == shown.content


def test_what_was_saved_is_equal_and_shown_as_before(shown: Shown, tmp_path: Path) -> None:
    write_recording(shown.recording, tmp_path / "run.npz")
    again = read_recording(tmp_path / "run.npz")
    assert again == shown.recording
    assert pack_of(shown.project, again) == shown.content
    assert shown.project.report(again).text() == shown.project.report(shown.recording).text()


def test_a_minute_takes_little_room() -> None:
    shown = show("palletizing")
    size = len(shown.content)
    assert size * 60.0 / shown.recording.duration < 0.37e6


def test_a_part_that_leaves_by_a_sink_is_seen_no_more() -> None:
    project = open_project(EXAMPLES / "first_cell")
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    *others, last = recording.placements
    assert (last.body, last.parent) == ("box", "stand_right")
    gone = replace(recording, placements=(*others, replace(last, visible=False)))
    shown = read_pack(pack_of(project, gone))
    release = next(event for event in recording.events if event.kind == "release")
    assert shown.visible("box", release.time)
    assert not shown.visible("box", release.time + release.duration)


def test_the_result_is_that_of_the_summary() -> None:
    project = open_project(EXAMPLES / "first_cell")
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    shown = read_pack(pack_of(project, recording))
    assert shown.header["result"] == numeric(asdict(result_figures(summarize(recording))))


def test_values_that_are_no_numbers_become_null() -> None:
    project = open_project(EXAMPLES / "first_cell")
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    strange = Channel(np.full(len(recording.time), np.inf), "", (), "made up")
    about = replace(recording.facts, record_hz=float("nan"), checked=("a", "b"))
    made = replace(recording, channels={**recording.channels, "strange": strange}, facts=about)
    shown = read_pack(pack_of(project, made))
    assert shown.header["facts"]["record_hz"] is None
    assert shown.header["facts"]["checked"] == ["a", "b"]
    assert np.all(np.isnan(shown.column("strange")))
    json.dumps(shown.header, allow_nan=False)


def test_findings_have_the_time_at_which_they_arose() -> None:
    project = open_project(EXAMPLES / "first_cell")
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    grip = next(event for event in recording.events if event.kind == "grip")
    assert project.cell is not None
    timed = Diagnostic("S1", "a", Severity.WARNING, "late", data={"time_s": 1.5})
    placed = Diagnostic("S2", "b", Severity.WARNING, "there", grip.span, data={"pass": 1})
    other_pass = replace(placed, data={"pass": 7})
    nowhere = Diagnostic("S3", "c", Severity.WARNING, "nowhere")
    made = replace(recording, findings=(timed, placed, other_pass, nowhere))
    listed = pack(made, project.cell, summarize(made), [replace(timed, code="T9")]).header["findings"]
    assert isinstance(listed, list)
    assert [(one["code"], one["time"]) for one in listed] == [
        ("T9", None),
        ("S1", 1.5),
        ("S2", grip.time),
        ("S2", None),
        ("S3", None),
    ]


@pytest.mark.parametrize(("duration", "last"), [(0.0, 0), (1.0, 60), (0.05, 3), (1.001, 61)])
def test_samples_go_from_the_start_to_the_very_end(duration: float, last: int) -> None:
    times = sample_times(duration)
    assert len(times) == last + 1
    assert times[0] == 0.0 or duration == 0.0
    assert times[-1] == duration
    assert np.all(np.diff(times) > 0.0)


def test_a_run_of_no_length_has_one_sample(tmp_path: Path) -> None:
    example = EXAMPLES / "first_cell"
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text((example / "cell.toml").read_text("utf-8"), "utf-8")
    (tmp_path / "programs" / "main.task").write_text("program nothing\n", "utf-8")
    project = open_project(tmp_path)
    recording = project.simulate()
    shown = read_pack(pack_of(project, recording))
    assert recording.duration == 0.0
    assert shown.header["count"] == 1
    assert shown.column("q", 1)[0] == pytest.approx(recording.channels["q"].values[0, 1], abs=1e-6)
    assert shown.visible("box", 0.0)
