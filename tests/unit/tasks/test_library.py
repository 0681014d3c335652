"""The built-in library: nothing is wrong with it, and each task compiles and runs."""

import pytest

from ropsim.flow import GripAction
from ropsim.icr import StillWorld, run
from ropsim.language import compile
from ropsim.spatial import Pose
from ropsim.tasks import GROUPS, KnownTask, Quantity, TaskCall, Value, WorldState, grouped, program_text
from support.knowledge import CELL, GEOMETRY, INPUTS, base

TASKS = {
    "grip", "release", "palletize", "pick", "place", "move_over", "depalletize", "insert", "screw",
    "dispense", "inspect", "load_machine", "unload_machine", "tool_change", "park",
    "load_pallet", "unload_pallet",
}  # fmt: skip
VALUES: dict[str, Value] = {"length": Quantity(10, "mm"), "int": 2}


def call_of(task: KnownTask) -> TaskCall:
    """Return a call of a task, with what it needs and no more."""
    passed = [one for one in task.passed if one.default is None]
    points = ("s1", "s2")[: sum(one.kind == "location" for one in passed)]
    return TaskCall(task.name, points, tuple(VALUES[one.kind] for one in passed if one.kind != "location"))


def test_the_library_has_its_tasks_and_nothing_is_wrong_with_them() -> None:
    known = base()
    assert known.findings == ()
    assert set(known.names) == TASKS
    assert all(one.doc and one.is_built_in for one in known.tasks())
    assert all(one.word and one.sentence for task in known.tasks() for one in task.parameters)


def test_a_pallet_is_filled_and_emptied_from_above_in_rows() -> None:
    spots = [(0.0, 0.0), (50.0, 0.0), (0.0, 50.0), (50.0, 50.0), (0.0, 100.0), (50.0, 100.0)]
    for name, far in (("load_pallet", 1), ("unload_pallet", 0)):
        call = TaskCall(name, ("s1", (100.0, 300.0, 200.0))[:: 1 if far else -1], (2, 3, Quantity(50, "mm")))
        code = compile(program_text(base().task, [call], "main"), CELL).icr
        assert code is not None
        trace = run(code)
        poses = [one.target for one in trace.moves if isinstance(one.target, Pose)]
        places = [tuple(round(1e3 * c, 6) for c in pose.position.tolist()) for pose in poses]
        patterned = places[3 * far :: 6], places[3 * far + 1 :: 6], places[3 * far + 2 :: 6]
        assert patterned[1] == [(100.0 + x, 300.0 + y, 200.0) for x, y in spots]
        assert patterned[0] == patterned[2] == [(x, y, z + 50.0) for x, y, z in patterned[1]]
        assert [one.action for one in trace.grips] == [GripAction.CLOSE, GripAction.OPEN] * 6


def test_lists_have_groups_and_each_file_of_the_library_is_one() -> None:
    groups = grouped(base("task(rest(L), [params([L-location]), body([mov(L)])]).").tasks())
    assert [one.name for one in groups[""]] == ["rest"]
    assert list(groups) == [one for one in GROUPS if one != "yours"]
    assert str(groups["palletize"][0]) == (
        "palletize(From: location, To: location, Distance: length, Count: int)"
    )


@pytest.mark.parametrize("name", ["load_pallet", "depalletize"])
def test_rows_lie_along_the_axes_of_their_first_place(name: str) -> None:
    numbers = (2, 1, Quantity(50, "mm")) if name == "load_pallet" else (Quantity(50, "mm"), 2)
    call = TaskCall(name, ("s1", (100.0, 300.0, 200.0, 180.0, 0.0, 90.0)), numbers)
    code = compile(program_text(base().task, [call], "main"), CELL).icr
    assert code is not None
    poses = [one.target for one in run(code).moves if isinstance(one.target, Pose)]
    places = [tuple(round(1e3 * c, 6) for c in pose.position.tolist()) for pose in poses]
    left = [place[:2] for place in places if round(place[2]) == 200 and place[:2] != (400.0, 0.0)]
    rows = [(100.0, 300.0), (100.0, 350.0), (50.0, 300.0), (50.0, 350.0)]
    assert list(dict.fromkeys(left)) == rows[: len(dict.fromkeys(left))]
    assert len(dict.fromkeys(left)) == (2 if name == "load_pallet" else 4)


def test_who_takes_a_part_looks_at_what_is_in_the_way_there() -> None:
    known, state = base(), WorldState.of("gripper(open)", "at(bolt, s1)")
    GEOMETRY.refuse(("arm", "bolt", "s1"))
    for name in ("grip", "pick"):
        (finding,) = known.check(f"{name} s1", state).findings
        words = f"`{name}` is not possible here: at `s1` the part `bolt` would be 12.3 mm deep in `post`"
        assert (finding.code, finding.message) == ("P153", words)


@pytest.mark.parametrize("name", sorted(TASKS))
def test_a_task_of_the_library_compiles_and_runs(name: str) -> None:
    task = base().task(name)
    assert task is not None
    compiled = compile(program_text(base().task, [call_of(task)], "main"), CELL)
    assert compiled.diagnostics == ()
    assert compiled.icr is not None
    assert run(compiled.icr, StillWorld(dict.fromkeys(INPUTS, True))).moves
