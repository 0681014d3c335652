"""What-if runs: changes as people write them, and what they make of a run."""

import json
import math
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.cli.testing import main
from ropsim.flow import MoveEvent
from ropsim.simulation import Fidelity, RunOptions
from ropsim.views import Comparison
from ropsim.workbench import Change, Project, Subject, WhatIfError, open_project, read_change
from ropsim.workbench.testing import NOTHING_COMPARED, content_of
from support.characters import ANY
from support.examples import examples

CELL = """\
[cell]
name = "c"
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
mass = 1.0
inertia = [0.002, 0.001, 0.0014, 0, 0, 0]
gripper = { open_time = 0.2, close_time = 0.2, capture = 5 }
[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [500, -200, 300]
"""
PROGRAM = """\
program c
units mm, deg, s
mov (500, -200, 300)
lin (500, 0, 300){zone} speed 200 mm/s
lin (500, 0, 100){zone} speed 200 mm/s
mov (500, 200, 100) speed 50 %
mov (500, -200, 300)
close
mov (500, 0, 300)
"""
OPTIONS = RunOptions(Fidelity.KINEMATIC)


def project(folder: Path, zone: str = " blend 30 mm", cell: str = CELL) -> Project:
    (folder / "programs").mkdir(parents=True)
    (folder / "cell.toml").write_text(cell)
    (folder / "programs" / "main.task").write_text(PROGRAM.format(zone=zone))
    return open_project(folder)


def compared(folder: Path, *changes: str) -> Comparison:
    return project(folder).what_if(changes, options=OPTIONS)


@pytest.mark.parametrize(
    ("text", "change"),
    [
        ("speed=120%", Change(Subject.SPEED, 1.2)),
        ("acceleration = 80 %", Change(Subject.ACCELERATION, 0.8)),
        ("payload=3kg", Change(Subject.PAYLOAD, 3.0)),
        ("tool=2.5kg", Change(Subject.TOOL, 2.5)),
        ("payload=0kg", Change(Subject.PAYLOAD, 0.0)),
        ("zones=stop", Change(Subject.ZONES)),
    ],
)
def test_changes_are_read_as_people_write_them(text: str, change: Change) -> None:
    found = read_change(text)
    assert isinstance(found, Change)
    assert (found.subject, found.line) == (change.subject, 0)
    assert found.value == pytest.approx(change.value, rel=1e-15)
    assert read_change(found.text) == found


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("sped=1%", "did you mean `speed`"),
        ("speed", "has no value"),
        ("speed=", "is no value of `speed`"),
        ("speed=120", "the unit `%`"),
        ("speed=0%", "allowed are 1% to 500%"),
        ("speed=nan%", "is no value"),
        ("payload=3lb", "the unit `kg`"),
        ("payload=-1kg", "allowed are 0kg to 10000kg"),
        ("zones=off", "known are stop, each"),
        ("=", "cannot be changed"),
    ],
)
def test_what_is_no_change_is_told_with_what_is_allowed(text: str, says: str) -> None:
    with pytest.raises(WhatIfError) as caught:
        read_change(text)
    found = caught.value.diagnostic
    assert found.code == "X896"
    assert says in f"{found.message} {found.hint}"


@settings(derandomize=True, max_examples=examples(300))
@given(st.text(ANY) | st.from_regex(r"(speed|tool|zones)=[0-9.e+%kg]{0,12}", alphabet=ANY))
def test_any_text_is_a_change_or_a_finding(text: str) -> None:
    found: Change | Subject | None = None
    with suppress(WhatIfError):
        found = read_change(text)
    known = found in (None, Subject.ZONES) or (isinstance(found, Change) and math.isfinite(found.value))
    assert known


def test_without_zones_a_program_takes_as_long_as_one_that_gives_none(tmp_path: Path) -> None:
    (stopping,) = compared(tmp_path / "a", "zones=stop").alternatives
    plain = project(tmp_path / "b", zone="").simulate(options=OPTIONS)
    assert stopping.cycle_time == pytest.approx(plain.duration, rel=1e-12)
    assert stopping.findings == ()


def test_each_zone_is_taken_away_alone(tmp_path: Path) -> None:
    found = compared(tmp_path, "zones=each")
    assert [one.change for one in found.alternatives] == ["zones=stop in line 4", "zones=stop in line 5"]
    (both,) = project(tmp_path / "b").what_if(["zones=stop"], options=OPTIONS).alternatives
    for one in found.alternatives:
        assert one.cycle_time != both.cycle_time


def test_lines_with_one_number_in_two_programs_are_two_lines(tmp_path: Path) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(
        '[stations.left]\nrobot = "puma560"\nprogram = "load"\n'
        '[stations.right]\nrobot = "puma560"\nbase = { position = [2200, 0, 0] }\nprogram = "mark"\n'
    )
    for name, end in (("load", "wait 5 s\n"), ("mark", "")):
        text = PROGRAM.replace("{zone}", " blend 60 mm", 1)
        (tmp_path / "programs" / f"{name}.task").write_text(text.format(zone="") + end)
    found = open_project(tmp_path).what_if(["zones=each"], options=OPTIONS)
    each = found.alternatives
    assert [one.change for one in each] == [
        f"zones=stop in line 4 of {name}.task" for name in ("load", "mark")
    ]
    left, right = (found.difference(one) for one in each)
    assert left > 0.1  # who takes longest
    assert right == 0.0


def test_a_change_to_what_is_there_changes_nothing(tmp_path: Path) -> None:
    found = compared(tmp_path, "speed=100%", "acceleration=100%", "payload=0.5kg", "tool=1kg")
    assert [found.difference(one) for one in found.alternatives] == [0.0] * 4


def test_speeds_and_accelerations_of_program_and_cell_change_the_time(tmp_path: Path) -> None:
    found = compared(tmp_path, "speed=50%", "speed=150%", "acceleration=80%", "acceleration=50%")
    slower, faster, weak, weaker = (found.difference(one) for one in found.alternatives)
    assert slower > 0.0 > faster
    assert 0.0 < weak < weaker


def test_what_is_found_with_a_change_only_is_told_once(tmp_path: Path) -> None:
    (heavy,) = compared(tmp_path, "tool=200kg").alternatives
    codes = [(found.code, found.span and found.span.line) for found in heavy.findings]
    assert "M564" in [code for code, _ in codes]
    assert len(heavy.findings) == len({(found.message, found.span) for found in heavy.findings})
    assert not heavy.valid


@pytest.mark.parametrize("change", ["zones=each", "zones=stop"])
def test_a_program_without_zones_has_none_to_take_away(tmp_path: Path, change: str) -> None:
    found = project(tmp_path, zone="").what_if([change, "speed=50%"], options=OPTIONS)
    assert [one.change for one in found.alternatives] == ["speed=50%"]
    (note,) = found.notes
    assert (note.code, note.message.split(":")[0]) == ("X897", "no zone in this program")


def test_a_program_that_grips_nothing_asks_for_no_payload(tmp_path: Path) -> None:
    folder = project(tmp_path).folder
    main_task = folder / "programs" / "main.task"
    lines = main_task.read_text().splitlines()
    main_task.write_text("\n".join(line for line in lines if line.strip() not in {"open", "close"}) + "\n")
    found = open_project(folder).what_if(["payload=30kg", "speed=50%"], options=OPTIONS)
    assert [one.change for one in found.alternatives] == ["speed=50%"]
    (note,) = found.notes
    assert (note.code, note.message.split(":")[0]) == ("X897", "no part is gripped in this run")


def test_a_program_that_does_not_come_to_its_end_is_compared_with_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project(tmp_path / "p")
    main_task = tmp_path / "p" / "programs" / "main.task"
    main_task.write_text(main_task.read_text() + "lin (5000, 0, 300)\n")
    found = open_project(tmp_path / "p").what_if(["speed=50%", "zones=each"], options=OPTIONS)
    assert found.alternatives == ()
    assert [one.code for one in found.notes] == ["X897"]
    assert main(["run", str(tmp_path / "p"), "--kinematic", "--what-if", "speed=50%"]) == 1
    told = capsys.readouterr()
    assert "X897" in told.err
    assert "what if" not in told.out


def test_findings_are_known_by_what_they_say_of_whom() -> None:
    """Figures may differ; names, places and codes may not."""
    kind = NOTHING_COMPARED
    one = kind.at(None, "joint `2` took 61.25 N·m, the limit is 60 N·m")
    louder = kind.at(None, "joint `2` took 64.5 N·m, the limit is 60 N·m")
    other = kind.at(None, "joint `3` took 61.25 N·m, the limit is 60 N·m")
    assert content_of(one) == content_of(louder) != content_of(other)


@pytest.mark.parametrize(
    ("change", "says"), [("payload=1kg", "no parts"), ("tool=1kg", "no tool with a mass")]
)
def test_a_cell_without_what_is_to_be_changed_says_so(tmp_path: Path, change: str, says: str) -> None:
    bare = '[cell]\nname = "c"\n[robot]\nmodel = "puma560"\n'
    with pytest.raises(WhatIfError) as caught:
        project(tmp_path, cell=bare).what_if([change], options=OPTIONS)
    assert says in caught.value.diagnostic.message


def test_the_command_runs_nothing_for_a_change_that_cannot_be(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ropsim.cli.commands.run._simulate", lambda *_: pytest.fail("the program was run"))
    project(tmp_path, cell='[cell]\nname = "c"\n[robot]\nmodel = "puma560"\n')
    assert main(["run", str(tmp_path), "--what-if", "payload=1kg"]) == 2
    assert "X896" in capsys.readouterr().err


def test_the_command_shows_the_table_and_its_document_the_figures(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project(tmp_path / "p")
    report = tmp_path / "r.html"
    words = ["run", str(tmp_path / "p"), "--kinematic", "--no-collisions", "--what-if", "zones=stop"]
    assert main([*words, "--report", str(report)]) == 0
    told = capsys.readouterr().out
    assert "zones=stop" in told.split("what if", 1)[1]
    assert "<h2>What if</h2>" in report.read_text()
    assert main([*words, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    (one,) = document["what_if"]
    assert one["difference"] == pytest.approx(one["cycle_time"] - document["summary"]["cycle_time"])


def test_a_wrong_change_is_wrong_usage_and_nothing_runs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project(tmp_path / "p")
    assert main(["run", str(tmp_path / "p"), "--what-if", "speed=fast"]) == 2
    assert "X896" in capsys.readouterr().err


def test_flown_zones_are_those_of_the_recording(tmp_path: Path) -> None:
    recording = project(tmp_path).simulate(options=OPTIONS)
    flown = [move.line for move in recording.events_of(MoveEvent) if move.flown > 0.0]
    assert flown == [4, 5]
