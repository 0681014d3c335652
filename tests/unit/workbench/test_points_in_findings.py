"""Findings of a run along a list name its points and their lines, once for each cause, and count them."""

from collections.abc import Sequence
from pathlib import Path

import pytest

from ropsim.flow import MoveEvent, SkipEvent
from ropsim.simulation import Fidelity, RunOptions
from ropsim.views.testing import time_of
from ropsim.workbench import open_project

CELL = '[cell]\nname = "zig"\n[robot]\nmodel = "irb120"\n'
ZIG = [(300.0 + 5.0 * (k % 2), -50.0 + 2.0 * k, 300.0) for k in range(50)]
"""Corners of about 137° at all points but the first and the last."""
KINEMATIC = RunOptions(Fidelity.KINEMATIC)

Told = tuple[str, int, str]


def folder_of(folder: Path, lines: Sequence[str], points: Sequence[tuple[float, ...]] = ZIG) -> Path:
    for name in ("points", "programs"):
        (folder / name).mkdir()
    (folder / "cell.toml").write_text(CELL, "utf-8")
    rows = [";".join(f"{one:g}" for one in point) for point in points]
    (folder / "points" / "zig.csv").write_text("\n".join(("x;y;z", "mm;mm;mm", *rows)) + "\n", "utf-8")
    text = "\n".join(("program main", "units mm, deg, s", *lines))
    (folder / "programs" / "main.task").write_text(text + "\n", "utf-8")
    return folder


def told(folder: Path, code: str = "M560") -> list[Told]:
    recording = open_project(folder).simulate(options=KINEMATIC)
    found = [one for one in recording.findings if one.code == code]
    source = f"{folder.as_posix()}/"
    return [(one.message.replace(source, ""), one.span.line if one.span else 0, one.hint) for one in found]


def test_stops_at_the_corners_of_a_chain_are_one_finding_that_says_how_many_and_where(tmp_path: Path) -> None:
    """The list begins where the arm stands, which costs nothing, and ends with the program."""
    ((message, line, hint),) = told(folder_of(tmp_path, ["mov zig[1]", "lin along zig blend 1 speed 200"]))
    assert line == 4
    assert message == (
        "48 of 50 points of `zig`, first point 2 (points/zig.csv line 4): the arm stops here, its zone of "
        "1 mm is not flown: a stop takes less time than to slow down for the bend of this zone"
    )
    assert hint == "give a larger zone"


def test_another_cause_on_the_same_line_is_another_finding(tmp_path: Path) -> None:
    points = [*ZIG[:6], ZIG[5], *ZIG[6:10]]
    lines = ["mov zig[1]", "lin along zig blend 1 speed 200"]
    found = told(folder_of(tmp_path, [*lines, "wait 1 s"], points))
    causes = {message.rpartition(": ")[2]: message for message, _, _ in found}
    assert len(found) == len(causes) == 3
    quicker = "a stop takes less time than to slow down for the bend of this zone"
    assert causes[quicker].startswith("7 of 11 points of `zig`, first point 2 (points/zig.csv line 4): ")
    same = causes["the next move has the same target"]
    assert same.startswith("point 6 of `zig` (points/zig.csv line 8): the arm stops here")
    assert causes["the program waits next"].startswith("point 11 of `zig` (points/zig.csv line 13): ")
    assert all("fine" not in hint for _, _, hint in found)  # it would be for all points, and is refused


@pytest.mark.parametrize("lines", [["for each p in zig", "  lin p above 5 blend 1 speed 200", "endf"]])
def test_the_points_of_a_loop_over_a_list_are_named_too(tmp_path: Path, lines: list[str]) -> None:
    ((message, line, _),) = told(folder_of(tmp_path, ["mov zig[1] above 5", *lines]))
    assert line == 5
    assert message.startswith("48 of 50 points of `zig`, first point 2 (points/zig.csv line 4): ")


def test_a_point_that_is_out_of_reach_is_named_with_its_line(tmp_path: Path) -> None:
    points = [ZIG[0], (3000.0, 0.0, 300.0), ZIG[2]]
    folder = folder_of(tmp_path, ["mov along zig"], points)
    recording = open_project(folder).simulate(options=KINEMATIC)
    (skip,) = recording.events_of(SkipEvent)
    (found,) = (one for one in recording.findings if one.code == "M501")
    assert found.message.replace(f"{folder.as_posix()}/", "").startswith(
        "point 2 of `zig` (points/zig.csv line 4): "
    )
    assert time_of(found, recording.events) == skip.time
    assert found.label == ""


def test_the_last_point_is_not_taken_for_the_first_pass(tmp_path: Path) -> None:
    """It is reached by an instruction of its own, for the first time."""
    points = [*ZIG[:5], (3000.0, 0.0, 300.0)]
    recording = open_project(folder_of(tmp_path, ["mov along zig"], points)).simulate(options=KINEMATIC)
    (found,) = (one for one in recording.findings if one.code == "M501")
    assert "point 6 of `zig`" in found.message
    (skip,) = recording.events_of(SkipEvent)
    assert time_of(found, recording.events) == skip.time > 0.0


@pytest.mark.parametrize(
    ("place", "name"), [("zig[n]", 3), ("zig[n] above 5", 3), ("zig[2]", 0), ("(300, 0, 300)", 0)]
)
def test_each_move_knows_its_point(tmp_path: Path, place: str, name: int) -> None:
    recording = open_project(folder_of(tmp_path, ["n = 3", f"mov {place}"])).simulate(options=KINEMATIC)
    (moved,) = recording.events_of(MoveEvent)
    assert moved.origin is not None
    point = moved.origin.point
    assert (point.number if point else 0) == name
    if point:
        assert (point.list, point.line) == ("zig", name + 2)


def test_lines_follow_an_edit_of_the_list(tmp_path: Path) -> None:
    """The plans of the first run are kept; the lines in its findings are not."""
    folder = folder_of(tmp_path, ["mov zig[1]", "lin along zig blend 1 speed 200"], ZIG[:8])
    workspace_project = open_project(folder)
    first = workspace_project.simulate(options=KINEMATIC).findings[0].message
    text = (folder / "points" / "zig.csv").read_text("utf-8")
    (folder / "points" / "zig.csv").write_text(text.replace("mm;mm;mm\n", "mm;mm;mm\n\n\n"), "utf-8")
    (second,) = (message for message, _, _ in told(folder))
    assert "first point 2" in first
    assert "line 4)" in first
    assert "line 6)" in second


def test_a_list_that_is_flown_again_says_its_points_once(tmp_path: Path) -> None:
    lines = ["repeat 3", "  mov zig[1]", "  lin along zig blend 1 speed 200", "endr"]
    points = [ZIG[0], ZIG[1], ZIG[2]]
    found = [message for message, line, _ in told(folder_of(tmp_path, lines, points)) if line == 5]
    assert len(found) == 1
    assert found[0].startswith("point 2 of `zig` (points/zig.csv line 4): ")


def test_points_of_two_lists_at_one_line_are_counted_apart(tmp_path: Path) -> None:
    lines = [
        *("task visit(p: loc)", "  lin p above 5 blend 1 speed 200", "endp", "mov zig[1] above 5"),
        *("for each p in zig", "  visit(p)", "endf", "for each q in few", "  visit(q)", "endf", "mov home"),
    ]
    folder = folder_of(tmp_path, lines)
    rows = [";".join(f"{one:g}" for one in (x, y, z + 40.0)) for x, y, z in ZIG[:8]]
    (folder / "points" / "few.csv").write_text("\n".join(("x;y;z", "mm;mm;mm", *rows)) + "\n", "utf-8")
    found = [message for message, _, _ in told(folder) if "a stop takes less time" in message]
    assert {message.partition(" points of ")[2].partition(",")[0] for message in found} == {"`zig`", "`few`"}
    assert {message.partition(" points of ")[0].partition(" of ")[2] for message in found} == {"50", "8"}
