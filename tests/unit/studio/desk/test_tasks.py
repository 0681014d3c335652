"""Tasks that an operator chooses: the worker says of each step what the terminal says of it."""

import os
from pathlib import Path
from typing import Any

import msgspec
import pytest

from ropsim.spatial import Pose
from ropsim.studio.testing import (
    Cancelled,
    CheckTaskForm,
    CheckTasks,
    Desk,
    EstimateTasks,
    FormParameterFields,
    Job,
    ListTasks,
    OpenTaskForm,
    Order,
    Report,
    TaskFormFields,
    TasksReply,
    TaskStep,
)

CELL = """\
[cell]
name = "small"
[robot]
model = "puma560"
tool = "jaws"
base = { position = [100, 0, 0] }
[tools.jaws]
position = [0, 0, 145]
gripper = {}
[locations]
s1 = { position = [500, 100, -200], rpy = [180, 0, 0] }
s2 = { position = [500, -100, -200], rpy = [180, 0, 0] }
[[parts]]
name = "bolt"
size = [20, 20, 20]
mass = 0.1
position = [500, 100, -200]
"""
#: Numbers are those of the cell file, through a few products of matrices [mm].
EXACT = 1e-9


class Quiet:
    """A line on which nobody speaks, or a word to stop."""

    number = 1

    def __init__(self) -> None:
        self.stops = False

    def report(self, content: Report) -> None:
        del content

    def orders(self, seconds: float) -> list[Order]:
        del seconds
        if self.stops:
            raise Cancelled
        return []


LINE = Quiet()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("small")
    (made / "points").mkdir()
    (made / "cell.toml").write_text(CELL)
    (made / "points" / "table.csv").write_text("name,x,y,z\n,mm,mm,mm\na,400,100,-150\nb,400,-100,-150\n")
    return made


@pytest.fixture(scope="module")
def desk() -> Desk:
    return Desk()


def said(desk: Desk, job: Job) -> dict[str, Any]:
    reply = desk.do(job, LINE)
    assert isinstance(reply, TasksReply)
    return dict(reply.payload)


def test_what_may_be_chosen_is_told(desk: Desk, folder: Path) -> None:
    found = said(desk, ListTasks(str(folder), {}))
    insert = next(one for one in found["tasks"] if one["name"] == "insert")
    assert (insert["group"], insert["needs"][0]) == ("pick", "a closed gripper")
    assert [(one["name"], one["kind"], one["default"], one["told"]) for one in insert["parameters"]] == [
        ("P", "part", "", True),
        ("L", "location", "", False),
        ("V", "speed", "20 mm/s", False),
    ]
    assert insert["parameters"][2]["units"][0] == "mm/s"
    assert [(one["list"], one["name"], one["text"], one["count"]) for one in found["places"]] == [
        ("", "s1", "s1", 1),
        ("", "s2", "s2", 1),
        ("table", "", "table", 2),
        ("table", "a", "400 100 -150", 1),
        ("table", "b", "400 -100 -150", 1),
    ]
    assert found["begin"]["parts"] == ({"part": "bolt", "place": "s1"},)
    assert found["findings"] == ()


def test_each_step_is_answered_in_the_world_that_the_one_before_it_made(desk: Desk, folder: Path) -> None:
    steps = (
        TaskStep("pick", ("s1",), ("",)),
        TaskStep("xyz", (), ()),
        TaskStep("place", ("s1 above",), ()),
        TaskStep("place", ("400 -100 -150",), ("20 mm",)),
        TaskStep("park", ("5000 0 0",), ()),
    )
    found = said(desk, CheckTasks(str(folder), {}, 7, steps))
    assert (found["id"], found["problem"]) == (7, "")
    assert [one["message"] for one in found["steps"]] == [
        "accepted",
        "Task not defined: `xyz`",
        "`s1 above` is neither a name nor numbers",
        "accepted",
        "`park` is not possible here: `(5000, 0, 0)` cannot be reached",
    ]
    assert found["steps"][0]["told"] == ({"part": "P", "place": "bolt"},)
    worlds = [one["world"] for one in found["steps"]]
    assert [one["held"] for one in worlds] == ["bolt", "bolt", "bolt", "", ""]
    assert worlds[3]["parts"] == ({"part": "bolt", "place": "point_1"},)
    assert [one["name"] for one in found["points"]] == ["s1", "point_1", ""]
    assert [one["points"] for one in found["steps"]] == [(0,), (), (), (1,), (2,)]
    assert found["points"][0]["numbers"] == pytest.approx((400, 100, -200, 90, 0, 180), abs=EXACT)
    assert Pose.from_tuple(found["points"][1]["pose"]).position == pytest.approx((0.5, -0.1, -0.15))
    assert found["text"].splitlines()[-2:] == ["pick s1", "place point_1, 20 mm"]
    assert found["listed"].splitlines()[2:] == ["point_1,400,-100,-150,,"]
    assert found["unchecked"].startswith("not checked: collisions on the way between places, collisions with")
    assert said(desk, CheckTasks(str(folder), {}, 8, ()))["unchecked"] == ""


def test_the_time_of_the_program_is_planned_and_can_be_given_up(desk: Desk, folder: Path) -> None:
    steps = (TaskStep("pick", ("s1",), ()), TaskStep("place", ("s2",), ()))
    text = said(desk, CheckTasks(str(folder), {}, 1, steps))["text"]
    job = EstimateTasks(str(folder), {}, 1, text)
    found = said(desk, job)
    assert (found["message"], found["seconds"] > 1.0) == ("", True)
    broken = said(desk, EstimateTasks(str(folder), {}, 2, "program p\nmoov home\n"))
    assert broken["seconds"] is None
    assert "moov" in broken["message"]
    LINE.stops = True
    with pytest.raises(Cancelled):
        desk.do(job, LINE)
    LINE.stops = False


def test_an_unsaved_cell_counts_and_makes_a_new_list(desk: Desk, folder: Path) -> None:
    before = said(desk, CheckTasks(str(folder), {}, 1, ()))["revision"]
    moved = CELL.replace("s2 =", "s3 =")
    found = said(desk, ListTasks(str(folder), {"cell.toml": moved}))
    assert (found["revision"], found["places"][1]["name"]) == (before + 1, "s3")
    broken = said(desk, ListTasks(str(folder), {"cell.toml": "[cell\n"}))
    assert broken["findings"]
    assert len(broken["tasks"]) == len(found["tasks"])


def test_texts_of_tasks_count_by_what_they_say(
    desk: Desk, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path))
    (tmp_path / "kb").mkdir()
    mine = tmp_path / "kb" / "mine.pl"

    def body(unsaved: str = "") -> str:
        texts = {"kb/own.pl": unsaved} if unsaved else {}
        step = TaskStep("rest", ("s1",), ())
        return str(said(desk, CheckTasks(str(folder), texts, 1, (step,)))["text"])

    def rest(height: int) -> str:
        return f"task(rest(L), [params([L-location]), body([mov(above(L, {height}*mm))])])."

    mine.write_text(rest(21))
    before = mine.stat()
    assert "21 mm" in body()
    mine.write_text(rest(34))  # of the same size, and of the same time
    os.utime(mine, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert "34 mm" in body()
    groups = {one["name"]: one["group"] for one in said(desk, ListTasks(str(folder), {}))["tasks"]}
    assert (groups["rest"], groups["pick"]) == ("yours", "pick")
    ours = said(desk, ListTasks(str(folder), {"kb/own.pl": rest(55)}))["tasks"]
    assert [one["group"] for one in ours if one["name"] == "rest"] == [""]
    assert "55 mm" in body(unsaved=rest(55))
    wrong = said(desk, ListTasks(str(folder), {"kb/own.pl": f"goal(done/0).\n{rest(55)[:-3]}"}))["findings"][
        0
    ]
    assert (wrong["severity"], wrong["span"]["source"], wrong["span"]["line"]) == ("error", "kb/own.pl", 2)
    assert "34 mm" in body()
    revision = said(desk, ListTasks(str(folder), {}))["revision"]
    assert said(desk, ListTasks(str(folder), {}))["revision"] == revision
    table = folder / "points" / "table.csv"
    stamp, text = table.stat(), table.read_text()
    table.write_text(text.replace("a,400,100", "a,401,100"))
    os.utime(table, ns=(stamp.st_atime_ns, stamp.st_mtime_ns))
    assert said(desk, ListTasks(str(folder), {}))["places"][3]["text"] == "401 100 -150"
    table.write_text(text)


def test_a_task_is_opened_as_a_form_and_written_where_it_stands(desk: Desk, folder: Path) -> None:
    own = "% ours\ntask(rest(L), [params([L-location]), body([mov(L)])]).  % done\ngoal(rested/0).\n"
    texts = {"kb/own.pl": own}
    opened = said(desk, OpenTaskForm(str(folder), texts, "rest"))
    assert (opened["document"], opened["problem"], opened["form"]["body"]) == ("kb/own.pl", "", "mov l")
    form = msgspec.convert(opened["form"], TaskFormFields)
    job = CheckTaskForm(str(folder), texts, 3, "kb/own.pl", "rest", form)
    assert (said(desk, job)["text"], said(desk, job)["faults"]) == (own, ())
    changed = msgspec.structs.replace(form, doc="Rests.", effects=("+rested",), body="mov l above 5 mm")
    found = said(desk, CheckTaskForm(str(folder), texts, 4, "kb/own.pl", "rest", changed))
    assert (found["id"], found["faults"]) == (4, ())
    assert found["text"] == own.replace("mov(L)", "mov(above(L, 5*mm))").replace(
        "])]).", ']),\n  doc("Rests."),\n  eff([+rested])]).'
    )
    library = said(desk, OpenTaskForm(str(folder), texts, "pick"))
    assert library["document"] == "kb/pick.pl"
    assert said(desk, OpenTaskForm(str(folder), texts, "xyz"))["problem"] == "Task not defined: `xyz`"


def test_each_field_of_a_form_is_told_what_check_tells(desk: Desk, folder: Path) -> None:
    parameter = FormParameterFields("L", "location", "", "", "", (), "")
    form = TaskFormFields("pick", "", (parameter,), ("helt(_)",), ("+lost(L, Q)",), (), "mov l\nmoov l")

    def faults(one: TaskFormFields) -> list[tuple[str, str]]:
        found = said(desk, CheckTaskForm(str(folder), {}, 1, "kb/pick.pl", "", one))
        return [(fault["field"], fault["message"].split(":")[0]) for fault in found["faults"]]

    assert faults(form) == [
        ("pre", "nobody makes a fact `helt/1`"),
        ("eff", "a variable is no parameter of the task"),
        ("eff", "no condition looks at `lost/2`"),
        ("eff", "variable `Q` occurs only once in its clause"),
        ("body", "Task not defined"),
    ]
    good = msgspec.structs.replace(form, needs=(), effects=(), body="mov l")
    assert faults(good) == [("name", "`pick` takes the place of the task of the library")]
    assert faults(msgspec.structs.replace(good, body="mov l\nmov s9"))[1:] == [
        ("body", "the body of `pick` does not compile")
    ]
