"""Programs put together task by task, and the lists of points for them."""

import os
from dataclasses import replace
from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.icr import run
from ropsim.language import compile
from ropsim.prolog import Atom, Struct
from ropsim.tasks import (
    ApproachPose,
    Coordinates,
    Draft,
    PointList,
    Quantity,
    TaskCall,
    TaskError,
    TypedStep,
    WorldState,
    WorldTable,
    added,
    call_of,
    default_text,
    draft_points,
    draft_text,
    drafted,
    listed,
    point_text,
    program_text,
    read_point_list,
    read_point_lists,
    taken_back,
    typed_points,
    typed_values,
    version_of,
    world_table,
)
from ropsim.tasks.testing import ordered, point_of_term, points_of, points_text, term_of_point
from support.knowledge import CELL, GEOMETRY, base, last

BEGIN = WorldState.of("gripper(open)", "at(bolt, s1)", "free(s2)")
CORNERS = ((31.0, 42.0, 86.0), (830.0, 220.0, 150.0, 20.0, 30.0))


def test_what_is_accepted_becomes_a_program_and_what_is_refused_changes_nothing() -> None:
    known, draft = base(), Draft(BEGIN)
    for call in (
        TaskCall("grip", ("s1",)),
        TaskCall("grip", ("s2",)),
        TaskCall("xyz", ("s2",)),
        TaskCall("move_over", (CORNERS[0],)),
        TaskCall("release", ("s2",)),
        TaskCall("park", (CORNERS[1],)),
        TaskCall("move_over", (CORNERS[0],)),
    ):
        draft = added(draft, known, call)
    assert [one.ok for one in draft.entries] == [True, False, False, True, True, True, True]
    assert draft.entries[2].message == "Task not defined: `xyz`"
    assert draft.state.holds("at(bolt, s2)")
    assert taken_back(draft).calls == draft.calls[:-1]
    text = draft_text(draft, known, "shift")
    compiled = compile(text, CELL)
    assert compiled.diagnostics == ()
    assert compiled.icr is not None
    assert len(run(compiled.icr).moves) == 5
    assert "loc point_2 = (830, 220, 150, 20, 30)" in text
    assert [line for line in text.splitlines() if line.startswith("move_over")] == ["move_over point_1"] * 2
    found, findings = points_of(SourceText("p.csv", draft_points(draft)), "p")
    assert findings == ()
    assert found == PointList("p", (("point_1", CORNERS[0]), ("point_2", CORNERS[1])))


def test_a_list_of_points_has_units_and_stands_for_its_points() -> None:
    text = "name,x,y,z,pitch,roll\n,cm,cm,cm,deg,rad\na, 3.1, 4.2, 8.6, 0, 1\nb,7.6,13,5,,\n"
    found, findings = points_of(SourceText("p.csv", text), "table")
    assert findings == ()
    assert found is not None
    assert [name for name, _ in found.points] == ["a", "b"]
    assert found.points[0][1] == pytest.approx((31, 42, 86, 0, 57.29577951))
    assert found.points[1][1] == pytest.approx((76, 130, 50))
    assert listed(("s1", "table"), {"table": found}) == ("s1", found.points[0][1], found.points[1][1])


EXACT = ((1234.5678, -0.1, 2345678.0), (1.0, 2.0, 3.0, 57.29577951308232, -1e-5))
"""Numbers of more than six digits, a whole one, and one that is written with an exponent."""


JOGGED = ApproachPose(1.5, 2.0, 3.0, 20.0, 10.0, 30.0)
"""X Y Z [mm] Pitch Roll Yaw [deg], as a list has them."""


@pytest.mark.parametrize("more", [(), (("c", JOGGED),)])
def test_a_written_list_has_the_points_to_the_last_digit(more: tuple[tuple[str, Coordinates], ...]) -> None:
    points = (("a", EXACT[0]), ("b", EXACT[1]), *more)
    text = points_text(points)
    found, findings = points_of(SourceText("p.csv", text), "p")
    assert findings == ()
    assert found == PointList("p", points)
    assert ("c,1.5,2,3,20,10,30" in text.splitlines(), "yaw" in text) == (bool(more), bool(more))


def test_a_program_has_its_points_to_the_last_digit() -> None:
    known, draft = base(), Draft(BEGIN)
    for point in EXACT:
        draft = added(draft, known, TaskCall("park", (point,)))
    text = draft_text(draft, known, "exact")
    assert compile(text, CELL).diagnostics == ()
    lines = [line for line in text.splitlines() if line.startswith("loc point_")]
    assert [tuple(map(float, line.split("(")[1].rstrip(")").split(","))) for line in lines] == list(EXACT)


def test_angles_are_typed_listed_and_shown_in_one_order_and_a_program_names_them() -> None:
    (typed,) = typed_points("1.5 2 3 20 10 30", {})
    assert typed == JOGGED
    call = TaskCall("park", (typed,))
    draft = added(Draft(BEGIN), base(), call)
    assert str(call) == "park (1.5, 2, 3; pitch 20, roll 10, yaw 30)"
    assert call_of(str(call)) == call
    assert draft_points(draft).splitlines()[2] == "point_1,1.5,2,3,20,10,30"
    named = draft_text(draft, base(), "p")
    assert "loc point_1 = (1.5, 2, 3; pitch 20, roll 10, yaw 30)" in named.splitlines()
    codes = (compile(one, CELL).icr for one in (named, program_text(base().task, [call], "p")))
    one, other = (run(code).moves[0].target for code in codes if code is not None)
    assert one == other
    GEOMETRY.refuse(("arm", str(typed)))
    refused = added(Draft(BEGIN), last(), call).entries[0].message
    assert (
        refused == "`park` is not possible here: `(1.5, 2, 3; pitch 20, roll 10, yaw 30)` cannot be reached"
    )
    for place in (typed, f"{point_text(typed)} rel (75, 0, 0)"):
        table = world_table(WorldState(ordered([Struct("at", (Atom("nut"), term_of_point(place)))])), {})
        assert table.parts[0][1].startswith("(1.5, 2, 3; pitch 20, roll 10, yaw 30)")


def test_a_program_names_the_versions_of_the_tasks_that_it_copies() -> None:
    known = base("task(twice(L), [params([L-location]), body([call(park(L)), call(park(L))])]).")
    lines = program_text(known.task, [TaskCall("twice", ("s1",))], "p").splitlines()
    versions = {name: version_of(task)[:8] for name in ("twice", "park") if (task := known.task(name))}
    assert [line for line in lines if line.startswith("# copied")] == [
        f"# copied from kb/t0.pl, version {versions['twice']}",
        f"# copied from library/pick.pl, version {versions['park']}",
    ]


def test_a_call_is_shown_with_what_it_is_given_to_the_last_digit() -> None:
    call = TaskCall("go", ((1234.5678, 2.0, 3.0),), (Quantity(1234.5678, "mm"), Quantity(50.0, "mm/s")))
    assert str(call) == "go (1234.5678, 2, 3), 1234.5678 mm, 50 mm/s"


@pytest.mark.parametrize(
    ("unit", "millimetres"),
    [("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("inch", 25.4)],  # the international inch of 1959
)
def test_lengths_of_a_list_are_taken_in_their_unit(unit: str, millimetres: float) -> None:
    found, findings = points_of(SourceText("p.csv", f"name,x,y,z\n,mm,{unit},mm\na,1,2,3\n"), "p")
    assert findings == ()
    assert found == PointList("p", (("a", (1.0, 2.0 * millimetres, 3.0)),))


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("", [1]),
        ("name,x,y\n,mm,mm\n", [1]),
        (f"name,x,y,z\n,mm,mm,mm\n{'a' * 200_000},1,2,3\n", [3]),
        ("name,x,y,z\n,mm,mm,foot\n", [2]),
        ("name,x,y,z\n,mm,mm,mm\na,1,2\nb,1,2,3\n,1,2,3\nc,1,2,x\nd,1,2,nan\n\n", [3, 6, 7]),
        ('name,x,y,z\n,mm,mm,mm\n"a,1\n', [3]),
    ],
)
def test_wrong_lines_of_a_list_are_told(text: str, lines: list[int]) -> None:
    found, findings = points_of(SourceText("p.csv", text), "p")
    assert [one.span and one.span.line for one in findings] == lines
    assert (found is None) == (lines in ([1], [2]))


def test_a_list_that_is_no_text_is_told(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_bytes(b"\xff\xfe")
    assert [one.code for one in read_point_list(tmp_path / "a.csv")[1]] == ["P148"]


def test_typed_steps_say_what_the_terminal_says() -> None:
    known = base()
    lists = {"table": PointList("table", (("a", CORNERS[0]), ("b", CORNERS[1])))}
    steps = (
        TypedStep("pick", ("s1", ""), ("",)),
        TypedStep("xyz", ("s1",)),
        TypedStep("place", (" 31 42  86 ",), ("20 mm",)),
        TypedStep("palletize", ("table",), ("75 mm", "2")),
        TypedStep("palletize", ("s1", "s2"), ("", "2")),
        TypedStep("move_over", ("s2",), ("5 furlong",)),
        TypedStep("park", ("nan 0 0",)),
        TypedStep("park", ("s1\nhalt",)),
        TypedStep("park", ("s2",), ("1\nhalt",)),
        TypedStep("park", ("1, 2, 3, 20, 10, 30",)),
        TypedStep("park", ("1, 2, 3, , , 30",)),
        TypedStep("park", ("1 2 3 20",)),
        TypedStep("park", ("4 12,",)),
        TypedStep("park", ("1, -147.5 600, 3, 4",)),
    )
    draft = drafted(steps, known, BEGIN, lists)
    assert [one.message for one in draft.entries] == [
        "accepted",
        "Task not defined: `xyz`",
        "accepted",
        "accepted",
        "`distance` of `palletize` is not given",
        "`move_over 5 furlong` is no call of a task: unknown unit `furlong`",
        "`nan 0 0` is neither a name nor numbers",
        "`s1\nhalt` is neither a name nor numbers",
        "`park 1\nhalt` is no call of a task: there is not one statement",
        "accepted",
        "Pitch, Roll of `1, 2, 3, , , 30` is left blank",
        "a point has 3, 5 or 6 numbers, given: 4",
        "X is one number, given with a blank in it: `4 12`",
        "Y is one number, given with a blank in it: `-147.5 600`",
    ]
    assert [str(one) for one in draft.calls] == [
        "pick s1",
        "place (31, 42, 86), 20 mm",
        "palletize (31, 42, 86), (830, 220, 150, 20, 30), 75 mm, 2",
        "park (1, 2, 3; pitch 20, roll 10, yaw 30)",
    ]
    assert draft.unchecked == ("draughts",)


def test_defaults_are_shown_as_they_are_typed() -> None:
    known = base()
    texts = {task.name: [default_text(one) for one in task.passed] for task in known.tasks()}
    assert texts["insert"] == ["", "20 mm/s"]
    assert texts["palletize"] == ["", "", "", ""]


def test_a_world_is_told_by_its_gripper_and_parts() -> None:
    facts = "gripper(closed)|part(a)|part(b)|part(c)|held(a)|at(b, s1)|free(s2)|inserted(b)|location(s1)"
    state = WorldState.of(*facts.split("|"), "at(d, p(1.0, 2.0, 3.0))")
    found = world_table(state, {(1.0, 2.0, 3.0): "point_1"})
    assert found == WorldTable("closed", "a", (("b", "s1"), ("c", ""), ("d", "point_1")), ("inserted(b)",))
    bare = world_table(WorldState.of("tool(glue)", "without_gripper(glue)"), {})
    assert bare == WorldTable("none", "", (), ("the tool glue",))


def test_parts_that_wait_in_a_supply_are_counted() -> None:
    queue = [f"follows(box_{k + 1}, box_{k})" for k in range(9, 12)]
    lying = [f"at(box_{k}, s{k})" for k in (2, 10, 9, 1)]
    found = world_table(WorldState.of("follows(nut_2, nut_1)", "at(nut_1, s3)", *queue[1:], *lying), {})
    assert [name for name, _ in found.parts] == ["box_1", "box_2", "box_9", "box_10", "nut_1"]
    assert found.others == (
        "box_11 and 1 more in the supply behind box_10",
        "nut_2 in the supply behind nut_1",
    )


def test_the_lists_of_a_project_are_its_files_and_nothing_else(tmp_path: Path) -> None:
    assert read_point_lists(tmp_path) == ({}, ())
    folder = tmp_path / "points"
    (folder / "folder.csv").mkdir(parents=True)
    if hasattr(os, "mkfifo"):
        os.mkfifo(folder / "pipe.csv")  # whoever reads it waits for ever
    (folder / "b.csv").write_text("name,x,y,z\n,mm,mm,mm\nq,1,2,3\n")
    (folder / "a.csv").write_text("nonsense")
    lists, findings = read_point_lists(tmp_path)
    assert lists == {"b": PointList("b", (("q", (1.0, 2.0, 3.0)),))}
    assert [one.code for one in findings] == ["P148"]


def test_points_by_numbers_have_names_that_nothing_else_has() -> None:
    begin = WorldState.of(*BEGIN.facts, "location(point_1)", "free(point_3)")
    draft = added(Draft(begin), base(), TaskCall("park", ((1.0, 2.0, 3.0),)))
    draft = added(draft, base(), TaskCall("park", ((4.0, 5.0, 6.0),)))
    assert draft.points == (("point_2", (1.0, 2.0, 3.0)), ("point_4", (4.0, 5.0, 6.0)))


@pytest.mark.parametrize("typed", ["abc", "nan", "home", "(1, 2, 3)"])
def test_a_word_is_no_value_of_a_parameter(typed: str) -> None:
    task = base().task("pick")
    assert task is not None
    with pytest.raises(TaskError, match="P151") as refused:
        typed_values(typed, task)
    assert f"`{typed}` is no value" in str(refused.value)


@pytest.mark.parametrize(
    ("typed", "text"),
    [
        ("0, 0, 0 in pallet", "(0, 0, 0) in pallet"),
        ("1.5 2 3 90 0 in pallet", "(1.5, 2, 3, 90, 0) in pallet"),
        ("1 2 3 90 0 180 in pallet", "(1, 2, 3; pitch 90, roll 0, yaw 180) in pallet"),
    ],
)
def test_a_point_may_be_typed_in_a_frame_of_the_cell(typed: str, text: str) -> None:
    (point,) = typed_points(typed, {})
    assert point_text(point) == text
    assert point_of_term(term_of_point(point)) == point
    call = TaskCall("park", (point,))
    assert call_of(str(call)) == call
    known = base()
    holding = WorldState.of("gripper(closed)", "held(bolt)")
    draft = added(added(Draft(holding), known, TaskCall("place", (point,))), known, call)
    assert [one.message for one in draft.entries] == ["accepted", "accepted"]
    framed = replace(CELL, frames={"pallet": (0.4, 0.1, 0.2, 1.0, 0.0, 0.0, 0.0)})
    program = draft_text(draft, known, "p")
    assert f"loc point_1 = {text}" in program.splitlines()
    assert compile(program, framed).diagnostics == ()
    assert draft_points(draft).splitlines()[2:] == []
    (refused,) = added(Draft(BEGIN), known, TaskCall("pick", (point,))).entries
    assert text in refused.message


@pytest.mark.parametrize("typed", ["1 2 in pallet", "in pallet", "s1 in pallet", "1 2 3 in 4"])
def test_what_is_no_point_in_a_frame_is_refused(typed: str) -> None:
    with pytest.raises(TaskError):
        typed_points(typed, {})
