"""Hand-overs: the gripper that gives a part away is to open before anything moves."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import Recording, ReleaseEvent
from ropsim.model import Cell, Device, Gripper, IndexDrive, Part, Signal, Station, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.simulation.testing import (
    CHECKS,
    AxisProfile,
    CellRun,
    Clasp,
    ProfileSegment,
    Seat,
    find_pulls,
    start_run,
    take_over,
)
from ropsim.spatial import Pose
from ropsim.workbench import environment_of

ARM = robots.load("puma560")
CAPTURE = 0.005
JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.1])), 1.0, gripper=Gripper(0.25, 0.25, CAPTURE))
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
TURNED = Pose(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0]))
POST = Part("post", np.array([0.04, 0.04, 0.12]), 0.4, Pose(np.array([0.5, 0.0, 0.5])))
PLACES = {"post": Pose(np.array([0.5, 0.0, 0.5]), DOWN), "high": Pose(np.array([0.5, 0.0, 0.6]), DOWN)}
LEFT = "left/tool:jaws"
EXACT = 1e-9  # [s], rounding of times
LIFT = ("mov post", "close", "lin high", "set up on")
TAKE = ("wait until up", "mov high", "close", "set mine on")


def cell_of(parts: tuple[Part, ...]) -> Cell:
    controller = robots.default_controller(ARM)
    left_arm = Station("left", ARM, controller, Pose(), {"jaws": JAWS}, "jaws", program="left")
    right_arm = replace(left_arm, name="right", X_WB=TURNED, program="right")
    signals = {name: Signal(name, is_input=False) for name in ("up", "mine", "free")}
    arms = {"left": left_arm, "right": right_arm}
    return Cell("c", arms, parts=parts, signals=signals, locations=PLACES)


def ran(
    left: tuple[str, ...],
    right: tuple[str, ...],
    options: RunOptions | None = None,
    parts: tuple[Part, ...] = (POST,),
) -> Recording:
    made = cell_of(parts)
    codes = {}
    for name, lines in (("left", left), ("right", right)):
        text = "\n".join([f"program {name}", "units mm, deg, s", *lines, ""])
        code = ropsim.language.compile(text, environment_of(made, made.stations[name]), name).icr
        assert code is not None
        codes[name] = code
    return run(made, codes, options or RunOptions(Fidelity.KINEMATIC))


def pulls(recording: Recording) -> list[tuple[str, int]]:
    return [
        (found.span.source, found.span.line) if found.span else ("", 0)
        for found in recording.findings
        if found.code == "S743"
    ]


def test_who_takes_a_part_out_of_a_closed_gripper_is_found_where_it_moves() -> None:
    recording = ran((*LIFT, "wait 6 s", "open"), (*TAKE, "lin high above 50 mm speed 50 mm/s"))
    assert pulls(recording) == [("right", 7)]
    (found,) = recording.findings
    assert found.data["station"] == "left"
    # at 50 mm/s a look every 4 ms is 0.2 mm
    assert CAPTURE < float(str(found.data["distance_m"])) < CAPTURE + 0.0003
    row = int(np.searchsorted(recording.time, float(str(found.data["time_s"])) - 1e-9))
    z = recording.channels["right/attained_position"].values[: row + 1, 2]
    assert z[-1] - z[-200:].min() == pytest.approx(CAPTURE, abs=0.0005)


def test_who_gives_a_part_away_and_moves_off_with_closed_jaws_is_found() -> None:
    recording = ran((*LIFT, "wait until mine", "lin high above 50 mm", "open"), (*TAKE, "wait 3 s"))
    assert pulls(recording) == [("left", 8)]


def test_a_gripper_that_opens_first_may_move() -> None:
    recording = ran(
        (*LIFT, "wait until mine", "open", "set free on", "lin high above 50 mm"),
        (*TAKE, "wait until free", "lin high offset (0, 50, 0)"),
    )
    assert recording.findings == ()


@pytest.mark.parametrize(("way", "count"), [("4", 0), ("6", 1)])
def test_a_way_within_the_capture_is_none(way: str, count: int) -> None:
    recording = ran((*LIFT, "wait 6 s", "open"), (*TAKE, f"lin high above {way} mm", "lin high"))
    assert len(pulls(recording)) == count


def test_a_pull_in_the_middle_of_a_move_that_comes_back_is_found_once() -> None:
    recording = ran(
        (*LIFT, "wait 9 s", "open"), (*TAKE, "lin high above 30 mm", "lin high", "lin high above 30 mm")
    )
    assert pulls(recording) == [("right", 7)]


def test_two_arms_that_move_together_do_not_pull() -> None:
    """The bases are turned by half a turn: both TCPs go the same way at the same speed."""
    both = "lin high above 40 mm speed 50 mm/s"
    recording = ran((*LIFT, "wait until mine", both, "open"), (*TAKE, both, "wait 2 s"))
    assert pulls(recording) == []


def test_a_program_that_ends_with_closed_jaws_is_found_too() -> None:
    recording = ran(LIFT, (*TAKE, "lin high above 50 mm"))
    assert pulls(recording) == [("right", 7)]


def test_a_part_that_is_given_back_hangs_on_the_first_gripper_again() -> None:
    recording = ran(
        (*LIFT, "wait until free", "lin high above 40 mm", "wait 1 s"),
        (*TAKE, "wait 0.5 s", "open", "set free on"),
    )
    assert recording.findings == ()
    told = [one.parent for one in recording.placements if one.body == "post"]
    assert told == ["", "left/tool:jaws", "right/tool:jaws", "left/tool:jaws"]
    assert [one.part for one in recording.events_of(ReleaseEvent)] == ["post"]
    assert recording.at("left/payload", recording.duration) == pytest.approx(1.4)


def test_with_drives_arms_that_hold_still_do_not_pull() -> None:
    recording = ran(
        (*LIFT, "wait until mine", "wait 1 s", "open", "set free on"),
        (*TAKE, "wait until free"),
        RunOptions(),
    )
    assert pulls(recording) == []


def test_what_lies_on_a_part_is_given_back_with_it() -> None:
    cap = Part("cap", np.array([0.03, 0.03, 0.03]), 0.1, Pose(np.array([0.5, 0.0, 0.53])))
    recording = ran(
        (*LIFT, "wait until free", "lin high above 40 mm", "wait 1 s"),
        (*TAKE, "wait 0.5 s", "open", "set free on", "wait 2 s"),
        parts=(POST, cap),
    )
    assert recording.findings == ()
    loads = {name: recording.channels[f"{name}/payload"].values for name in ("left", "right")}
    assert loads["right"].tolist() == pytest.approx([1.0, 1.5, 1.0])
    assert loads["left"].tolist() == pytest.approx([1.0, 1.5, 1.0, 1.5])


def begun() -> CellRun:
    """Return the start of a run in which the left gripper holds the post, beside a turntable."""
    table = Device("table", robots.rotary(()), IndexDrive("up", 1.0, 1.0, 1.0), Pose())
    made = replace(cell_of((POST,)), devices={"table": table})
    begun = start_run(made, RunOptions(Fidelity.KINEMATIC))
    begun.parts = begun.parts.with_seats({"post": Seat(LEFT, LEFT, Pose())})
    return begun


def test_only_another_gripper_takes_a_part_over() -> None:
    """A gripper that closes once more on what it holds has nobody to wait for."""
    run_ = begun()
    take_over(run_, run_.stations["left"], JAWS, run_.parts)
    assert run_.clasps == {}
    taken = run_.parts.with_seats({"post": Seat("right/tool:jaws", "right/tool:jaws", Pose())})
    take_over(run_, run_.stations["right"], JAWS, taken)
    assert [(hand, one.part, one.at.station.name) for hand, one in run_.clasps.items()] == [
        (LEFT, "post", "left")
    ]


def test_a_device_pulls_too() -> None:
    """The table turns about the origin at 1 rad/s, with the post on it where the gripper is closed on it."""
    run_ = begun()
    left = run_.stations["left"]
    tcp = (left.carriers(0)[LEFT] @ JAWS.X_MT).position
    run_.parts = run_.parts.with_seats({"post": Seat("table/link1", "table/link1", Pose(tcp))})
    run_.clasps[LEFT] = Clasp(left, JAWS, "post", np.zeros(3), 0)
    run_.devices["table"].profile = AxisProfile([ProfileSegment(0.0, 0.0, 1.0, 0.0)])
    find_pulls(run_, 1000, {})
    (found,) = run_.findings
    assert found.code == "S743"
    radius = float(np.hypot(tcp[0], tcp[1]))
    passes = 2.0 * np.arcsin(CAPTURE / radius / 2.0)  # [s], the chord is the way of the post
    assert passes <= float(str(found.data["time_s"])) < passes + 1.0 / CHECKS + EXACT
