import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim.cli import all_kinds
from ropsim.flow import (
    AxisType,
    Channel,
    GripEvent,
    MotionKind,
    MoveEvent,
    Recording,
    RunFacts,
    SkipEvent,
    TaskEvent,
    WaitEvent,
)
from ropsim.views import summarize
from ropsim.views.testing import closest_to_position_limit, effort_lines, key_figures, moves_by_kind
from support.recordings import empty_recording, facts, pick_and_place, station, two_findings, two_stations

ROUNDING = 1e-12
"""Sums of a few dozen floats."""


def with_channel(recording: Recording, name: str, values: "np.typing.NDArray[np.float64]") -> Recording:
    channel = replace(recording.channels[name], values=values)
    return replace(recording, channels={**recording.channels, name: channel})


def ramp(q: list[float], **channels: list[float]) -> Recording:
    """A run of one joint at 10 Hz."""
    time = np.arange(len(q)) / 10.0
    table = {name: Channel(np.array(values)[:, None], "") for name, values in {"q": q, **channels}.items()}
    return Recording(
        time, table, (), (), float(time[-1]), facts(stations=(station(axes=station().axes[:1]),))
    )


def test_cycle_time_is_the_end_of_the_last_event() -> None:
    move = MoveEvent(1.0, 2.0, motion=MotionKind.PTP, ordinal=0)
    recording = replace(pick_and_place(1), events=(move, WaitEvent(2.5, 1.5, pause=1.5)))
    assert summarize(recording).cycle_time == pytest.approx(4.0, abs=ROUNDING)


def test_moves_are_counted_by_kind() -> None:
    summary = summarize(pick_and_place(2))
    assert dict(summary.moves) == {"PTP": 4, "LIN": 8}
    assert (summary.grips, summary.empty_grips, summary.releases) == (2, 0, 2)


def test_a_grip_that_took_nothing_is_counted_apart_and_told() -> None:
    recording = pick_and_place(2)
    first = next(event for event in recording.events if isinstance(event, GripEvent))
    events = tuple(replace(event, part="") if event is first else event for event in recording.events)
    summary = summarize(replace(recording, events=events))
    assert (summary.grips, summary.empty_grips, summary.releases) == (1, 1, 2)
    assert [(one.grips, one.empty_grips) for one in summary.stations] == [(1, 1)]
    assert effort_lines(summary, summary)[-1].endswith("1 grip, 1 empty grip, 2 releases")
    assert "<dd>1<small>grips, 1 empty, 2 releases</small></dd>" in key_figures(summary)


def test_settle_times_add_up_and_are_a_share_of_the_cycle() -> None:
    summary = summarize(pick_and_place(2))
    assert summary.settling.total == pytest.approx(12 * 0.02, abs=ROUNDING)
    assert summary.settling.share == pytest.approx(12 * 0.02 / summary.cycle_time, abs=ROUNDING)


def test_the_longest_settling_has_its_line_pass_and_time() -> None:
    recording = pick_and_place(2)
    one = recording.events_of(MoveEvent)[7]
    slow, at = replace(one, settle=0.05), recording.events.index(one)
    changed = replace(recording, events=(*recording.events[:at], slow, *recording.events[at + 1 :]))
    settling = summarize(changed).settling
    assert (settling.longest, settling.slow) == (0.05, 1)
    assert (settling.line, settling.visit) == (slow.line, slow.visit)
    assert settling.time == pytest.approx(slow.time + slow.duration - 0.05, abs=ROUNDING)


def test_share_in_motion_is_that_of_the_parts_of_the_cycle_time() -> None:
    recording = pick_and_place(2)
    summary = summarize(recording)
    moves = recording.events_of(MoveEvent)
    way = sum(one.duration - one.settle for one in moves)
    assert summary.share_in_motion == pytest.approx(way / summary.cycle_time, abs=ROUNDING)
    parts = summary.stations[0].cycle.whole
    assert summary.share_in_motion == (parts.motion + parts.blending) / parts.total


def test_share_in_motion_of_several_stations_is_of_their_times_together() -> None:
    summary = summarize(two_stations())
    moving = sum(one.share_in_motion * one.cycle_time for one in summary.stations)
    times = sum(one.cycle_time for one in summary.stations)
    assert summary.share_in_motion == pytest.approx(moving / times, abs=ROUNDING)


def test_tasks_have_calls_total_mean_and_longest() -> None:
    events = (
        TaskEvent(0.0, 2.0, name="pick", serial=1, depth=1),
        TaskEvent(2.0, 4.0, name="pick", serial=2, depth=1),
        TaskEvent(0.0, 6.0, name="main", serial=0, depth=0),
    )
    main, pick = summarize(replace(pick_and_place(1), events=events)).tasks
    assert (main.name, main.depth) == ("main", 0)
    assert (pick.calls, pick.total, pick.mean, pick.longest) == (2, 6.0, 3.0, 4.0)


def test_peak_torque_is_the_largest_magnitude_with_its_time_and_line() -> None:
    recording = pick_and_place(1)
    tau = np.zeros_like(recording.channels["tau"].values)
    tau[7, 0], tau[9, 0] = 20.0, -48.8
    joint = summarize(with_channel(recording, "tau", tau)).joints[0]
    assert joint.effort.value == -48.8
    assert joint.effort.time == recording.time[9]
    assert joint.effort.line == recording.rows("line")[9]
    assert joint.effort_share == pytest.approx(0.5, abs=ROUNDING)


def test_closest_approach_names_the_limit_and_the_moment() -> None:
    lower, upper = math.radians(-160.0), math.radians(160.0)
    joint = summarize(ramp([0.0, upper - 0.1, 0.0, lower + 0.3])).joints[0]
    assert joint.nearest_upper.margin == pytest.approx(0.1, abs=ROUNDING)
    assert joint.nearest_upper.time == 0.1
    assert joint.nearest_lower.margin == pytest.approx(0.3, abs=ROUNDING)
    assert joint.nearest.side == "upper"


def test_margin_beyond_a_limit_is_negative() -> None:
    joint = summarize(ramp([0.0, math.radians(161.0)])).joints[0]
    assert joint.nearest.margin == pytest.approx(math.radians(-1.0), abs=ROUNDING)


def test_following_error_has_rms_and_maximum() -> None:
    joint = summarize(ramp([0.0] * 4, q_error=[3.0, -4.0, 0.0, 0.0])).joints[0]
    assert joint.following_max.value == -4.0
    assert joint.following_rms == pytest.approx(2.5, abs=ROUNDING)


def test_samples_that_are_not_finite_do_not_count_but_are_reported() -> None:
    recording = pick_and_place(1)
    tau = recording.channels["tau"].values.copy()
    tau[3, 0], tau[4, 1] = np.nan, np.inf
    summary = summarize(with_channel(recording, "tau", tau))
    assert math.isfinite(summary.joints[0].effort.value)
    assert math.isfinite(summary.joints[1].effort.value)
    assert summary.invalid_samples == 2
    assert not summary.cycle_time_valid


def test_skipped_moves_make_the_cycle_time_invalid() -> None:
    recording = pick_and_place(1)
    skipped = replace(recording, events=(*recording.events, SkipEvent(3.0, motion=MotionKind.LIN)))
    assert summarize(recording).cycle_time_valid
    assert not summarize(skipped).cycle_time_valid


@pytest.mark.parametrize(
    "code", ["S723", "S742", "S761", "S762", "I460", "I461", "I462", "I463", "I464", "I465"]
)
def test_a_program_that_was_ended_before_its_end_has_no_cycle_time(code: str) -> None:
    ended = pick_and_place(1, findings=(all_kinds()[code].at(None, "it ended"),))
    assert not summarize(ended).cycle_time_valid
    assert summarize(ended).stopped_by_hand is (code == "S761")


def test_moves_are_counted_in_the_order_of_their_kinds() -> None:
    kinds = (MotionKind.SPLINE, "WEAVE", MotionKind.CIRC, MotionKind.PTP, MotionKind.LIN, MotionKind.LIN)
    counted = moves_by_kind([MoveEvent(0.0, motion=kind, ordinal=0) for kind in kinds])
    assert list(counted.items()) == [("PTP", 1), ("LIN", 2), ("CIRC", 1), ("SPLINE", 1), ("WEAVE", 1)]


def test_findings_are_sorted_by_severity_and_counted_with_repeats() -> None:
    summary = summarize(pick_and_place(1, findings=two_findings()))
    assert [group.first.code for group in summary.findings] == ["M502", "S703"]
    assert (summary.error_count, summary.warning_count) == (3, 1)


def test_empty_recording_has_a_summary_of_nothing() -> None:
    summary = summarize(empty_recording())
    assert summary.joints == ()
    assert summary.path.moves == ()
    assert summary.cycle_time == 0.0
    assert math.isnan(summary.share_in_motion)


def test_kinematic_run_without_torques_has_unknown_torques() -> None:
    recording = pick_and_place(1)
    channels = {
        name: c for name, c in recording.channels.items() if name not in {"tau", "current", "voltage"}
    }
    joint = summarize(replace(recording, channels=channels)).joints[0]
    assert math.isnan(joint.effort.value)
    assert math.isnan(joint.effort_share)


def test_a_run_that_does_not_name_its_stations_has_no_joints() -> None:
    assert summarize(replace(pick_and_place(1), facts=RunFacts())).joints == ()


def test_several_stations_are_told_apart_by_their_names() -> None:
    one = pick_and_place(1)
    summary = summarize(two_stations())
    alone = summarize(one)
    assert [joint.name for joint in summary.joints[::6]] == ["left 1", "right 1"]
    assert [joint.words for joint in summary.joints[::6]] == ["left: joint 1", "right: joint 1"]
    assert alone.joints[0].words == "joint 1"
    assert [joint.effort for joint in summary.joints[6:]] == [joint.effort for joint in alone.joints]
    assert {task.name for task in summary.tasks} == {
        f"{name} {task.name}" for name in ("left", "right") for task in alone.tasks
    }
    assert [(line.station, line.line) for line in summary.path.lines] == [
        (name, line.line) for name in ("left", "right") for line in alone.path.lines
    ]
    assert summary.title == "palletizing / main / other"
    assert summary.stations[0].share_in_motion == alone.share_in_motion


def test_each_of_several_stations_has_the_figures_that_it_has_alone() -> None:
    alone, summary = summarize(pick_and_place(2)), summarize(two_stations(2))
    left, right = summary.stations
    assert [one.facts.name for one in summary.stations] == ["left", "right"]
    for one in (left, right):
        assert [joint.name for joint in one.joints] == ["1", "2", "3", "4", "5", "6"]
        assert [joint.effort for joint in one.joints] == [joint.effort for joint in alone.joints]
        assert (one.moves, one.grips, one.releases) == (alone.moves, alone.grips, alone.releases)
        assert [task.name for task in one.tasks] == [task.name for task in alone.tasks]
        assert one.path.max_error == alone.path.max_error
    assert left.settling.total == right.settling.total == alone.settling.total
    assert left.cycle_time == alone.cycle_time
    assert right.cycle_time == pytest.approx(alone.cycle_time + 1.0, abs=ROUNDING)
    assert summary.cycle_time == right.cycle_time


def test_settling_of_several_stations_is_a_share_of_their_times_together() -> None:
    summary = summarize(two_stations())
    together = sum(one.settling.total for one in summary.stations)
    times = sum(one.cycle_time for one in summary.stations)
    assert summary.settling.total == pytest.approx(together, abs=ROUNDING)
    assert summary.settling.share == pytest.approx(together / times, abs=ROUNDING)


def test_a_station_alone_is_the_whole_run() -> None:
    summary = summarize(pick_and_place(1))
    (only,) = summary.stations
    assert (only.joints, only.tasks, only.path) == (summary.joints, summary.tasks, summary.path)
    assert (only.cycle_time, only.settling) == (summary.cycle_time, summary.settling)


def test_a_device_has_its_way_and_its_ends() -> None:
    (belt,) = summarize(two_stations()).devices
    assert (belt.name, belt.type, belt.lowest) == ("infeed", AxisType.PRISMATIC, 0.0)
    assert belt.highest == pytest.approx(0.5, abs=ROUNDING)
    assert belt.travel == pytest.approx(0.5, abs=ROUNDING)


def test_a_joint_that_stands_at_its_limit_is_not_beyond_it() -> None:
    lower, upper = station().axes[0].lower, station().axes[0].upper
    (joint,) = summarize(ramp([lower - 5e-5, upper + 5e-5])).joints
    assert (joint.nearest_lower.margin, joint.nearest_upper.margin) == (0.0, 0.0)
    (joint,) = summarize(ramp([0.0, upper + 2e-4])).joints
    assert joint.nearest_upper.margin == pytest.approx(-2e-4, abs=ROUNDING)


def test_metres_are_not_compared_with_radians() -> None:
    """0.05 rad of 0.5 left is the smaller number, 0.1 m of 2 m the smaller share."""
    turning, sliding = station().axes[0], station().axes[1]
    axes = (
        replace(turning, lower=-0.25, upper=0.25),
        replace(sliding, type=AxisType.PRISMATIC, lower=-1.0, upper=1.0),
    )
    time, q = np.arange(2) / 10.0, np.array([[0.0, 0.0], [0.2, 0.9]])
    run = Recording(time, {"q": Channel(q, "")}, (), (), 0.1, facts(stations=(station(axes=axes),)))
    closest = closest_to_position_limit(summarize(run).joints)
    assert closest is not None
    assert closest.facts.type is AxisType.PRISMATIC
