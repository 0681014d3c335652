import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim.core import Category, Diagnostic, Severity
from ropsim.flow import (
    AwaitEvent,
    AxisType,
    Channel,
    Fidelity,
    MotionKind,
    MoveEvent,
    Origin,
    SkipEvent,
    TaskEvent,
    WaitEvent,
)
from ropsim.views import Style, summarize, terminal_report
from ropsim.views.testing import width
from support.golden import GOLDEN, check_golden
from support.recordings import (
    SOURCE,
    empty_recording,
    estimates,
    facts,
    pick_and_place,
    station,
    two_findings,
    two_stations,
)

COLUMNS = 80


def report(**changes: Any) -> str:
    recording = pick_and_place(3, findings=two_findings())
    return terminal_report(summarize(replace(recording, **changes)), Style.PLAIN)


def test_report_looks_as_in_the_golden_file() -> None:
    check_golden(GOLDEN / "views" / "report.txt", report())


def test_report_fits_80_columns() -> None:
    assert max(width(line) for line in report().splitlines()) <= COLUMNS


def test_long_names_do_not_break_the_columns() -> None:
    events = (TaskEvent(0.0, 1.0, name="t" * 200, serial=1, depth=9),)
    text = report(events=events, facts=facts(project="p" * 300))
    assert max(width(line) for line in text.splitlines()) <= COLUMNS


def test_waits_are_told_with_the_longest_one_and_not_at_all_where_there_are_none() -> None:
    assert "waiting" not in report()
    events = pick_and_place(3).events
    waits = (
        AwaitEvent(1.0, 2.0, "robot", Origin(SOURCE.span(9), 2), channel="ready", value=True, came=True),
        WaitEvent(4.0, 0.5, "robot", Origin(SOURCE.span(8)), pause=0.5),
    )
    text = report(events=(*events, *waits))
    share = 2.5 / max(event.end for event in events)
    assert f"waiting      2.50 s, {share * 100:.0f} % of the cycle time" in text
    assert "             longest 2.00 s (line 9 pass 2)" in text


def test_names_of_joints_are_shown_whole_up_to_24_columns() -> None:
    plain = station()
    names = ("shoulder_pan_joint", "j" * 30)
    axes = tuple(replace(axis, name=name) for axis, name in zip(plain.axes[:2], names, strict=True))
    text = report(facts=facts(stations=(replace(plain, axes=(*axes, *plain.axes[2:])),)))
    lines = [line for line in text.splitlines() if line.startswith(("  shoulder", "  jjj"))]
    assert [line.split()[0] for line in lines] == ["shoulder_pan_joint", "j" * 23 + "…"] * 2
    assert width(lines[0]) == width(lines[1])


def test_units_stand_below_where_they_do_not_fit_beside() -> None:
    plain = station()
    track = replace(plain.axes[5], type=AxisType.PRISMATIC)
    text = report(facts=facts(stations=(replace(plain, axes=(*plain.axes[:5], track)),)))
    assert max(width(line) for line in text.splitlines()) <= COLUMNS
    title, units = text[text.index("  joint ") :].splitlines()[:2]
    assert "N·m" not in title
    assert [title.index(word) + len(word) for word in ("torque", "speed", "lag")] == [
        units.index(unit) + len(unit) for unit in ("N·m or N", "°/s or mm/s", "° or mm        ° or mm")
    ]


def test_skipped_moves_are_told_first_and_beside_the_cycle_time() -> None:
    recording = pick_and_place(1)
    text = report(events=(*recording.events, SkipEvent(3.0, motion=MotionKind.LIN)))
    assert "1 move skipped: the cycle time is not that of the program" in text
    assert re.search(r"cycle time .* not valid", text)


def test_torque_beyond_its_limit_is_marked() -> None:
    recording = pick_and_place(1)
    tau = np.full_like(recording.channels["tau"].values, 10.0)
    tau[5, 0] = 120.0
    text = report(channels={**recording.channels, "tau": Channel(tau, "N·m")}, time=recording.time)
    assert "123 % !!" in text


def test_estimated_parameters_are_named() -> None:
    assert "estimated, not from a published source: motor resistance" in report()


def test_kinematic_run_says_that_torques_are_not_known() -> None:
    assert "kinematic run" in report(facts=facts(fidelity=Fidelity.KINEMATIC))


def test_settling_is_a_line_with_its_share_and_the_longest_wait() -> None:
    recording = pick_and_place(1)
    events = [replace(one, settle=0.5) for one in recording.events_of(MoveEvent)]
    text = report(events=(*events[:1], *recording.events))
    assert re.search(r"settling +0\.\d\d s after moves, \d+\.\d % of the cycle time\n", text)
    assert re.search(r"longest 0\.500 s \(line \d+ pass 1\); 1 move longer than 20 ms\n", text)


def test_a_kinematic_run_does_not_claim_to_settle_at_once() -> None:
    text = report(facts=facts(fidelity=Fidelity.KINEMATIC))
    assert "settling     – (a kinematic run has no servo that settles)" in text


def test_a_run_without_drives_has_no_figures_of_its_attained_path() -> None:
    recording = pick_and_place(3)
    driven = terminal_report(summarize(recording), Style.PLAIN)
    text = report(facts=facts(fidelity=Fidelity.KINEMATIC))
    assert "path error of tool paths (12 moves): –, without drives" in text
    for figure in (
        "max ",
        "RMS",
        "orientation:",
        "speed error",
        "spread of the passes",
        "conditions of the accuracy",
        "stops (",
    ):
        assert figure in driven
        assert figure not in text
    rows = [line.split() for line in text.splitlines() if re.match(r"  [1-6]  ", line)]
    assert [row[-1] for row in rows] == ["–"] * 6


def test_of_two_stations_only_the_one_with_drives_has_figures_of_its_attained_path() -> None:
    recording = two_stations(2)
    left, right = recording.facts.stations
    stations = (left, replace(right, law=""))
    channels = {name: one for name, one in recording.channels.items() if name != "right/tau"}
    mixed = replace(recording, channels=channels, facts=replace(recording.facts, stations=stations))
    summary = summarize(mixed)
    assert [one.is_driven for one in summary.stations] == [True, False]
    assert {one.station for one in summary.stops} == {"left"}
    assert summary.path.worst is not None
    assert summary.path.worst.station == "left"
    _, first, second = re.split(
        r"^(?=left runs|right runs)", terminal_report(summary, Style.PLAIN), flags=re.MULTILINE
    )
    assert "settling     –, without drives" in second
    assert "settling     –" not in first


@pytest.mark.parametrize(
    ("margin", "sign"),
    [(0.3, "! 0.3 lower"), (0.9, "! 0.9 lower"), (1.1, "1.1 lower"), (-0.5, "!! -0.5 lower")],
)
def test_a_joint_that_is_nearly_at_the_end_of_its_range_is_marked(margin: float, sign: str) -> None:
    q = np.zeros((3, 6))
    q[1, 2] = np.deg2rad(margin - 135.0)
    recording = replace(pick_and_place(1), time=np.arange(3) / 10.0, channels={"q": Channel(q, "rad")})
    text = terminal_report(summarize(recording), Style.PLAIN)
    (row,) = [line for line in text.splitlines() if line.startswith("  3  ")]
    assert re.search(rf"  {re.escape(sign)}(  |$)", row)
    assert ("! less than 1° or 1 mm of the range left" in text) == sign.startswith("!")


def test_what_was_not_looked_at_breaks_between_its_parts_only() -> None:
    origins = estimates("p" * 30, "q" * 30)
    about = facts(fidelity=Fidelity.KINEMATIC, stations=(station(origins=origins),))
    lines = report(facts=about).splitlines()
    start = lines.index("not checked: collisions, rated payload, torques, drives, servo ·")
    assert lines[start + 1] == "  estimated: 2 groups of parameters"


def test_empty_recording_has_a_report() -> None:
    text = terminal_report(summarize(empty_recording()), Style.PLAIN)
    assert "cycle time   0.00 s" in text
    assert "nan" not in text


def test_colour_changes_nothing_but_colour() -> None:
    summary = summarize(pick_and_place(1, findings=two_findings()))
    coloured = terminal_report(summary, Style.COLOR)
    plain = terminal_report(summary, Style.PLAIN)
    assert coloured != plain
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == plain


def test_a_run_that_was_ended_by_hand_does_not_claim_to_have_run_to_the_end() -> None:
    stopped = Diagnostic("S761", "run-stopped", Severity.HINT, "ended at 1 s", category=Category.STOPPED)
    text = report(findings=(stopped,))
    assert "ended by hand before the program ended, no errors" in text
    assert "s  ! not valid" in text
    assert "ran to the end" not in text


def test_several_stations_have_a_block_each_and_the_cell_is_told_once() -> None:
    text = terminal_report(summarize(two_stations(2)), Style.PLAIN)
    assert max(width(line) for line in text.splitlines()) <= COLUMNS
    cell, left, right = re.split(r"^(?=left runs|right runs)", text, flags=re.MULTILINE)
    assert "devices      infeed went 500.0 mm\n" in cell
    assert "moves" not in cell
    for block in (left, right):
        for once in ("cycle time  ", "  joint  ", "path error of tool paths (8 moves)"):
            assert block.count(once) == 1
    assert text.count("largest torque and speed") == 1
    assert text.count("estimated, not from a published source") == 1
