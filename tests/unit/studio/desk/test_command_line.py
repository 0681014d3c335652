"""The robot of the command line: each job brings the commands so far, no worker has to remember them."""

from dataclasses import replace
from pathlib import Path

import pytest

from ropsim.studio.testing import Cancel, Cancelled, OfferWords, Tell, ToldReply, ToldRobot
from ropsim.workbench import Workspace, new_project
from support.live import FakeLine

ENDLESS = "repeat 100000\n  wait 3600 s\nend"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return new_project(tmp_path_factory.mktemp("told") / "cell", "first_cell")


@pytest.fixture(scope="module")
def robot() -> ToldRobot:
    return ToldRobot(Workspace())


def tell(robot: ToldRobot, folder: Path, *lines: str, texts: dict[str, str] | None = None) -> list[ToldReply]:
    """Return what is answered to lines that are said one after the other."""
    replies: list[ToldReply] = []
    commands: tuple[str, ...] = ()
    for line in lines:
        replies.append(robot.tell(Tell(str(folder), texts or {}, commands, line), FakeLine()))
        commands = replies[-1].commands
    return replies


def test_a_line_is_carried_out_from_where_the_robot_stands(robot: ToldRobot, folder: Path) -> None:
    stands, first, second = tell(robot, folder, "", "mov pick_up above 60", "lin pick_up above 20")
    assert (stands.outcome, stands.pack, stands.commands) == ("answered", None, ())
    assert (first.outcome, first.since) == ("moved", 0.0)
    assert second.since > 0.1
    assert second.commands == ("mov pick_up above 60", "lin pick_up above 20")
    assert stands.told != first.told != second.told


def test_what_is_taken_back_leaves_the_run_that_there_was(robot: ToldRobot, folder: Path) -> None:
    """All of it: the arm, the gripper with the part, signals, and what is on its way."""
    first, _, back = tell(robot, folder, "mov pick_up above 60", "Carry pick_up, set_down", "undo")
    assert back.commands == first.commands
    assert back.pack == first.pack


def test_a_worker_that_has_heard_nothing_makes_the_same_run(robot: ToldRobot, folder: Path) -> None:
    *_, known = tell(robot, folder, "mov pick_up above 60", "lin pick_up")
    job = Tell(str(folder), {}, known.commands[:1], "lin pick_up")
    assert ToldRobot(Workspace()).tell(job, FakeLine()) == known


def test_a_block_is_open_until_it_is_closed(robot: ToldRobot, folder: Path) -> None:
    begun, empty, closed = tell(
        robot, folder, "repeat 2", "repeat 2\n  print 1\n", "repeat 2\n  print 1\nend"
    )
    assert (begun.outcome, begun.commands) == ("open", ())
    assert [one["code"] for one in empty.findings] == ["L106"]
    assert closed.told[:2] == ("says 1", "says 1")


def test_a_line_with_an_error_changes_nothing_and_says_where(robot: ToldRobot, folder: Path) -> None:
    done, refused = tell(robot, folder, "print 1", "lin (9000, 0, 0)")
    assert (refused.outcome, refused.commands, refused.pack) == ("refused", done.commands, None)
    (finding,) = refused.findings
    span = finding["span"]
    assert isinstance(span, dict)
    assert (finding["code"], span["source"], span["line"], refused.first) == ("M501", "session", 2, 2)


def test_commands_are_carried_out_again_on_changed_texts(robot: ToldRobot, folder: Path) -> None:
    text = (folder / "programs" / "main.task").read_text("utf-8")
    *_, told = tell(robot, folder, "Carry pick_up, set_down")
    job = Tell(str(folder), {"programs/main.task": text + "\n"}, told.commands, "print 1")
    assert robot.tell(job, FakeLine()).outcome == "moved"
    without = {"programs/main.task": "program main\nunits mm, deg, s\nmov home\n"}
    gone = robot.tell(replace(job, texts=without), FakeLine())
    assert [one["code"] for one in gone.findings] == ["X912"]
    assert gone.commands == told.commands  # the text may be changed back
    anew = robot.tell(replace(job, texts=without, line="Restart"), FakeLine())
    assert (anew.outcome, anew.commands) == ("moved", ())


def test_a_broken_project_is_told_with_its_error(robot: ToldRobot, folder: Path) -> None:
    (reply,) = tell(robot, folder, "print 1", texts={"programs/main.task": "mvo\n"})
    assert (reply.outcome, [one["code"] for one in reply.findings]) == ("refused", ["N201"])


def test_what_is_given_up_was_never_said(folder: Path) -> None:
    robot = ToldRobot(Workspace())
    with pytest.raises(Cancelled):
        robot.tell(Tell(str(folder), {}, (), ENDLESS), FakeLine([(0.0, Cancel())]))
    (after,) = tell(robot, folder, "print 1")
    assert after.commands == ("print 1",)


def test_commands_are_saved_as_a_program_that_is_not_there_yet(robot: ToldRobot, folder: Path) -> None:
    _, kept, taken = tell(robot, folder, "print 1", "save again", "save main")
    assert kept.program is not None
    name, text = kept.program
    assert (name, text.endswith("task again\n  print 1\nend\nagain\n")) == ("again", True)
    assert [one["code"] for one in taken.findings] == ["X847"]


def test_words_that_can_end_a_line(robot: ToldRobot, folder: Path) -> None:
    def offered(
        line: str, *commands: str, texts: dict[str, str] | None = None
    ) -> tuple[str, tuple[str, ...]]:
        reply = robot.offer(OfferWords(str(folder), texts or {}, commands, line))
        return reply.begun, reply.words

    assert offered("lin pick") == ("pick", ("pick_up",))
    assert "Carry" in offered("Ca")[1]
    assert offered("mov plac", "loc placed = pick_up above 50") == ("plac", ("placed",))
    assert offered("repeat 2\nlin pick") == ("pick", ("pick_up",))
    assert "undo" in offered("un")[1]
    assert "undo" not in offered("repeat 2\nun")[1]
    assert offered("mov x", texts={"cell.toml": "["}) == ("x", ())
