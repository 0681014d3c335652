from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import (
    AxisFacts,
    AxisType,
    Channel,
    Destinations,
    Fidelity,
    MotionKind,
    MoveEvent,
    SkipEvent,
)
from ropsim.views import Closeness, Verdict, result_figures, summarize, verdict
from ropsim.views.testing import SettlingFigure
from support.recordings import empty_recording, facts, pick_and_place, station, two_findings, two_stations


def test_verdict_counts_and_the_line_beside_it_are_those_of_the_summary() -> None:
    summary = summarize(pick_and_place(2, findings=two_findings()))
    result = result_figures(summary)
    assert result.verdict == verdict(summary)
    assert result.verdict.kind is Verdict.FAILED
    assert result.unchecked == summary.unchecked.text
    assert (result.errors, result.warnings, result.moves) == (3, 1, 12)


def test_the_largest_share_of_a_limit_has_joint_time_and_line() -> None:
    recording = pick_and_place(1)
    tau = np.zeros_like(recording.channels["tau"].values)
    tau[7, 1], tau[9, 4] = 100.0, -15.0  # 54 % of 186.4 N·m, 75 % of 20.1 N·m
    loaded = replace(recording, channels={**recording.channels, "tau": Channel(tau, "N·m")})
    peak = result_figures(summarize(loaded)).peak_torque
    assert peak is not None
    assert peak.share == pytest.approx(15.0 / 20.1)
    assert (peak.joint, peak.time) == ("5", recording.time[9])
    assert peak.line == recording.rows("line")[9]


@pytest.mark.parametrize(
    ("share", "closeness"),
    [(0.89, Closeness.FAR), (0.91, Closeness.NEAR), (1.0, Closeness.NEAR), (1.01, Closeness.BEYOND)],
)
def test_a_peak_torque_is_near_its_limit_from_90_percent_and_beyond_it_above(
    share: float, closeness: Closeness
) -> None:
    recording = pick_and_place(1)
    tau = np.zeros_like(recording.channels["tau"].values)
    tau[9, 4] = 20.1 * share
    loaded = replace(recording, channels={**recording.channels, "tau": Channel(tau, "N·m")})
    peak = result_figures(summarize(loaded)).peak_torque
    assert peak is not None
    assert peak.closeness == closeness


@pytest.mark.parametrize(
    ("share", "closeness"),
    [(0.95, Closeness.FAR), (1.0, Closeness.FAR), (1.019, Closeness.FAR), (1.021, Closeness.BEYOND)],
)
def test_a_speed_at_its_limit_is_what_a_good_plan_asks_for(share: float, closeness: Closeness) -> None:
    recording = pick_and_place(1)
    qd = np.zeros_like(recording.channels["qd"].values)
    qd[9, 4] = share * recording.facts.stations[0].axes[4].max_speed
    quick = replace(recording, channels={**recording.channels, "qd": Channel(qd, "rad/s")})
    peak = result_figures(summarize(quick)).peak_speed
    assert peak is not None
    assert peak.closeness == closeness


def test_the_least_margin_names_its_side_and_unit() -> None:
    q = np.zeros((3, 6))
    q[1, 2] = -np.deg2rad(134.0)
    recording = replace(pick_and_place(1), time=np.arange(3) / 10.0, channels={"q": Channel(q, "rad")})
    closest = result_figures(summarize(recording)).closest_limit
    assert closest is not None
    assert closest.margin == pytest.approx(np.deg2rad(1.0))
    assert (closest.joint, closest.side, closest.unit, closest.time) == ("3", "lower", "rad", 0.1)


@pytest.mark.parametrize(
    ("margin", "closeness"), [(0.3, Closeness.NEAR), (1.5, Closeness.FAR), (-0.5, Closeness.BEYOND)]
)
def test_a_margin_says_how_near_it_is_and_a_small_one_is_not_good(
    margin: float, closeness: Closeness
) -> None:
    q = np.zeros((3, 6))
    q[1, 2] = -np.deg2rad(135.0 - margin)
    recording = replace(pick_and_place(1), time=np.arange(3) / 10.0, channels={"q": Channel(q, "rad")})
    result = result_figures(summarize(recording))
    assert result.closest_limit is not None
    assert result.closest_limit.closeness is closeness
    how = {Closeness.NEAR: "comes within 0.3° of", Closeness.BEYOND: "is 0.5° beyond"}.get(closeness)
    reason = f"ran to the end, but joint 3 {how} the end of its range"
    assert result.verdict.text == (reason if how else "ran to the end, no errors, no warnings")
    assert result.verdict.kind is (Verdict.DOUBTFUL if how else Verdict.GOOD)


def test_a_run_without_drives_has_neither_path_error_nor_settling() -> None:
    recording = pick_and_place(1)
    kinematic = replace(recording, facts=facts(fidelity=Fidelity.KINEMATIC))
    assert result_figures(summarize(recording)).path_error is not None
    result = result_figures(summarize(kinematic))
    assert (result.path_error, result.settling) == (None, None)


def test_a_margin_of_a_sliding_joint_is_in_metres() -> None:
    axis = AxisFacts("1", AxisType.PRISMATIC, 0.0, 1.0)
    rail = replace(
        empty_recording(),
        time=np.zeros(1),
        channels={"q": Channel(np.array([[0.9]]), "m")},
        facts=facts(stations=(station(axes=(axis,)),)),
    )
    closest = result_figures(summarize(rail)).closest_limit
    assert closest is not None
    assert (closest.unit, closest.side) == ("m", "upper")
    assert closest.margin == pytest.approx(0.1)


def test_settling_leads_to_the_longest_wait() -> None:
    recording = pick_and_place(1)
    slow = recording.events_of(MoveEvent)[2]
    events = list(recording.events)
    events[events.index(slow)] = replace(slow, settle=0.05)
    summary = summarize(replace(recording, events=tuple(events)))
    settling = result_figures(summary).settling
    assert settling is not None
    assert (settling.total, settling.share) == (summary.settling.total, summary.settling.share)
    assert (settling.station, settling.line) == (slow.station, slow.line)
    assert settling.time == pytest.approx(slow.time + slow.duration - 0.05)


def test_a_run_that_never_settles_has_no_place_of_settling() -> None:
    settling = result_figures(summarize(empty_recording())).settling
    assert settling == SettlingFigure(0.0, 0.0, None, "", 0)


def test_a_skipped_move_makes_the_cycle_time_not_valid() -> None:
    recording = pick_and_place(1)
    skipped = replace(recording, events=(*recording.events, SkipEvent(3.0, motion=MotionKind.LIN)))
    result = result_figures(summarize(skipped))
    assert result.cycle_time_valid is False
    assert result.verdict == verdict(summarize(skipped))
    assert result.verdict.kind is Verdict.FAILED


def test_figures_that_a_run_does_not_know_are_nothing() -> None:
    result = result_figures(summarize(empty_recording()))
    for name in ("peak_torque", "peak_speed", "closest_limit", "path_error"):
        assert getattr(result, name) is None


@pytest.mark.parametrize(
    ("wanted", "told"), [(Destinations(), None), (Destinations(36, 35), Destinations(36, 35))]
)
def test_destinations_are_told_where_a_part_has_one(wanted: Destinations, told: Destinations | None) -> None:
    recording = pick_and_place(1)
    facts_ = replace(recording.facts, destinations=wanted)
    assert result_figures(summarize(replace(recording, facts=facts_))).destinations == told


def test_figures_of_several_stations_name_the_one_that_they_are_of() -> None:
    recording = two_stations()
    tau = np.zeros_like(recording.channels["right/tau"].values)
    tau[9, 4] = 20.0
    channels = {**recording.channels, "right/tau": Channel(tau, "N·m")}
    result = result_figures(summarize(replace(recording, channels=channels)))
    peak, path = result.peak_torque, result.path_error
    assert peak is not None
    assert path is not None
    assert (peak.station, peak.joint) == ("right", "5")
    assert path.station in ("left", "right")
