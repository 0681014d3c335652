"""A session: commands are carried out one by one, and their run is that of a program."""

from pathlib import Path

import pytest

from ropsim.flow import MessageEvent, MoveEvent
from ropsim.simulation import Fidelity, RunOptions
from ropsim.workbench import (
    ProjectError,
    Session,
    as_program,
    begin_session,
    new_project,
    open_project,
    saved,
    taken_back,
    told,
)

KINEMATIC = RunOptions(fidelity=Fidelity.KINEMATIC)


@pytest.fixture
def begun(tmp_path: Path) -> Session:
    return begin_session(open_project(new_project(tmp_path / "cell", "first_cell")), KINEMATIC)


def after(session: Session, *commands: str) -> Session:
    for command in commands:
        answer = told(session, command, KINEMATIC)
        assert answer.is_taken, answer.diagnostics
        session = answer.session
    return session


def moves(session: Session) -> int:
    return len(session.recording.events_of(MoveEvent))


def test_the_robot_stands_before_the_first_command(begun: Session) -> None:
    assert (moves(begun), begun.recording.duration) == (0, 0.0)


def test_each_command_is_carried_out_at_once(begun: Session) -> None:
    first = after(begun, "mov pick_up above 60")
    assert (moves(first), first.text) == (1, "mov pick_up above 60")
    block = after(first, "repeat 2\n  lin pick_up above 20\n  lin pick_up above 60\nend")
    assert moves(block) == 5
    assert moves(after(begun, "Carry pick_up, set_down")) > 3  # a task of the program


def test_variables_and_tasks_that_are_told_are_known(begun: Session) -> None:
    session = after(
        begun, "d = 60 mm", "task Up(q: loc)\n  mov q above d2\nend".replace("d2", "80 mm"), "Up pick_up"
    )
    assert moves(after(session, "mov pick_up above d")) == 2


@pytest.mark.parametrize(
    ("command", "code"),
    [
        ("mvo pick_up", "N201"),
        ("lin (9000, 0, 0)", "M501"),
        ("repeat 2\n  mov pick_up", "L106"),
        ("x = ", "L101"),
    ],
)
def test_a_command_with_an_error_changes_nothing(begun: Session, command: str, code: str) -> None:
    session = after(begun, "mov pick_up above 60")
    answer = told(session, command, KINEMATIC)
    assert not answer.is_taken
    assert answer.session is session
    assert [one.code for one in answer.diagnostics] == [code]
    span = answer.diagnostics[0].span
    assert span is not None
    assert (span.source, span.line) == ("session", 2)  # its own lines are counted
    assert answer.texts["session"].line(2) == command.split("\n", maxsplit=1)[0]


def test_taking_back_is_as_if_it_had_not_been_said(begun: Session) -> None:
    first = after(begun, "mov pick_up above 60")
    second = after(first, "lin pick_up")
    assert taken_back(second, KINEMATIC) == first
    assert taken_back(taken_back(first, KINEMATIC), KINEMATIC) == begun


def test_saved_commands_run_as_they_were_told(begun: Session) -> None:
    session = after(begun, "loc here_ = pick_up above 50", "mov here_", "lin pick_up", "close", "lin here_")
    path = begun.project.folder / "programs" / "again.task"
    path.write_text(as_program(session, "again"), encoding="utf-8")
    run = open_project(begun.project.folder).simulate("again", KINEMATIC)
    assert run.ok
    assert run.duration == session.recording.duration
    assert (run.rows("q") == session.recording.rows("q")).all()


@pytest.mark.parametrize("line", ["units cm", "classic", "program zz", "  STRICT"])
def test_what_would_change_the_commands_before_is_refused(begun: Session, line: str) -> None:
    session = after(begun, "lin pick_up above 20")
    answer = told(session, line, KINEMATIC)
    assert [one.code for one in answer.diagnostics] == ["X912"]
    assert answer.session == session


def test_nothing_follows_stop(begun: Session) -> None:
    session = after(begun, "print 1", "stop")
    assert [one.code for one in told(session, "print 2", KINEMATIC).diagnostics] == ["X912"]


def test_declarations_between_commands_keep_their_place_in_the_saved_program(begun: Session) -> None:
    commands = (
        "var n: int = 3",
        "n = n + 1",
        "var m: int = n",
        "print m",
        "lin pick_up",
        "var p2: loc = here",
        "lin p2",
    )
    session = after(begun, *commands)
    text = saved(session, "again", KINEMATIC)
    assert "task again" not in text
    (begun.project.folder / "programs" / "again.task").write_text(text, encoding="utf-8")
    run = open_project(begun.project.folder).simulate("again", KINEMATIC)
    assert run.ok
    assert [one.text for one in run.events_of(MessageEvent)] == ["4"]
    assert (run.rows("q") == session.recording.rows("q")).all()


@pytest.mark.parametrize("name", ["mov", "home", "Carry", "été", "1a", "", "../x"])
def test_names_that_no_program_can_have_are_refused(begun: Session, name: str) -> None:
    with pytest.raises(ProjectError) as refused:
        saved(after(begun, "wait 1 s"), name, KINEMATIC)
    assert refused.value.diagnostic.code == "X912"


def test_a_project_with_errors_has_no_session(begun: Session) -> None:
    (begun.project.folder / "programs" / "main.task").write_text("mvo\n", encoding="utf-8")
    with pytest.raises(ProjectError) as raised:
        begin_session(open_project(begun.project.folder), KINEMATIC)
    assert raised.value.diagnostic.code == "N201"
