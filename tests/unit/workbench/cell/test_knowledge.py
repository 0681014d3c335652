"""The knowledge base of a project: what its cell says is true, what its arm reaches, what is wrong."""

from pathlib import Path

import pytest

from ropsim.cellfile import read_cell
from ropsim.cli.testing import main
from ropsim.core import SourceText
from ropsim.tasks import WorldState, term_text
from ropsim.workbench import (
    Knowledge,
    has_knowledge,
    new_project,
    open_knowledge,
    open_project,
    world_state,
)

TASKS = """\
task(stack(P, L, H), [params([P-part, L-location, H-length]), pre([held(P)]), eff([-held(P), +at(P, L)]),
  geo([reachable(arm, L)]), body([mov(above(L, H)), set(nosuch, on), wait(H)])]).
task(two(L), [params([L-location]), body([mov('a b')])]).
task(three(L), [params([L-location]), body([call(two(L)), open])]).
"""
CELL = """\
[cell]
name = "small"
[units]
length = "mm"
angle = "deg"
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
position = [0, 0, 145]
gripper = {}
[locations]
s1 = { position = [400, 100, -200], rpy = [180, 0, 0] }
s2 = { position = [400, -100, -200], rpy = [180, 0, 0] }
far = { position = [4000, 0, 0], rpy = [180, 0, 0] }
rest = { position = [300, 0, 300], rpy = [180, 0, 0] }
taken = { position = [300, 0, -200], rpy = [180, 0, 0] }
[signals.glue]
output = 1
[[parts]]
name = "bolt"
size = [20, 20, 20]
mass = 0.1
position = [401, 100, -200]
[[objects]]
name = "post"
position = [300, 0, -215]
shapes = [{ cylinder = { radius = 5, length = 20 } }]
[[parts]]
name = "nut"
size = [20, 20, 20]
mass = 0.1
position = [0, 400, -200]
"""


@pytest.fixture(scope="module")
def known(tmp_path_factory: pytest.TempPathFactory) -> Knowledge:
    folder = tmp_path_factory.mktemp("project")
    (folder / "cell.toml").write_text(CELL)
    (folder / "programs").mkdir()
    (folder / "kb").mkdir()
    (folder / "kb" / "own.pl").write_text(TASKS)
    return open_knowledge(folder)


def test_a_cell_says_what_is_true_at_the_start(known: Knowledge) -> None:
    true = ("at(bolt, s1)", "free(s2)", "gripper(open)", "tool(jaws)", "part(nut)", "location(far)")
    assert [one for one in true if not known.state.holds(one)] == []
    assert not any(known.state.holds(one) for one in ("free(s1)", "at(nut, s1)", "free(nut)"))


def test_a_tool_that_cannot_grasp_is_told_and_no_gripper_is_open() -> None:
    glue = "[tools.glue]\nposition = [0, 0, 100]\n[locations]"

    def state(text: str) -> WorldState:
        cell, findings = read_cell(SourceText("cell.toml", text), "small")
        assert cell is not None, findings
        return world_state(cell)

    bare = state(CELL.replace("gripper = {}\n", ""))
    assert [bare.holds(one) for one in ("without_gripper(jaws)", "gripper(open)")] == [True, False]
    two = state(CELL.replace("[locations]", glue))
    assert [two.holds(one) for one in ("without_gripper(glue)", "gripper(open)")] == [True, True]
    assert (bare.gripperless, two.gripperless) == ("jaws", "")


def test_bodies_are_compiled_in_the_cell_and_mistakes_stand_at_their_clauses(known: Knowledge) -> None:
    places = [(one.code, Path(one.span.source).name, one.span.line) for one in known.findings if one.span]
    assert places == [("P145", "own.pl", 3), *[("P147", "own.pl", 1)] * 2, ("P160", "own.pl", 4)]
    assert "there is no output `nosuch`" in known.findings[1].message
    assert known.findings[2].notes == ("its text there: wait h",)
    assert {Path(name).name for name in known.texts} == {"own.pl", "cell.toml"}


def test_the_arm_of_the_cell_tells_what_it_can_reach(known: Knowledge) -> None:
    calls = [
        "grip s1",
        "release far",
        "release s2",
        "park (400, 0, 100)",
        "park (4000, 0, 0)",
        "park nowhere",
    ]
    said = [one.message for one in known.base.check_all(calls, known.state)]
    assert said == [
        "accepted",
        "`release` is not possible here: `far` cannot be reached",
        "accepted",
        "accepted",
        "`park` is not possible here: `(4000, 0, 0)` cannot be reached",
        "Location not defined: `nowhere`",
    ]


def test_a_plan_for_the_cell_avoids_what_is_out_of_reach(known: Knowledge) -> None:
    plan = known.base.plan(["at(bolt, s2)"], known.state)
    assert [str(one) for one in plan.calls] == ["grip s1", "release s2"]
    refused = known.base.plan(["at(bolt, far)"], known.state)
    assert "`far` cannot be reached" in refused.findings[0].message


def test_what_stands_at_a_destination_refuses_it_with_both_names_and_the_depth(known: Knowledge) -> None:
    grip, there, beside = known.base.check_all(["grip s1", "release taken", "release s2"], known.state)
    assert (grip.ok, beside.ok) == (True, True)
    assert [(one.code, one.message, one.hint) for one in there.findings] == [
        (
            "P153",
            "`release` is not possible here: at `taken` the part `bolt` would be 14.0 mm deep in `post`",
            "choose another location, or move `post`",
        )
    ]
    assert there.unchecked == (
        "collisions on the way between places",
        "collisions with parts at other places",
    )


def test_a_plan_goes_round_a_place_that_is_not_free_and_says_so_where_none_is_left(known: Knowledge) -> None:
    state = WorldState.of(
        "at(bolt, s1)", "at(nut, s2)", "free(taken)", "free(rest)", "gripper(open)", "location(rest)"
    )
    swapped = known.base.plan(["at(bolt, s2)", "at(nut, s1)"], state)
    assert "rest" in str(swapped)
    assert "taken" not in str(swapped)
    left = WorldState.of(*(one for one in map(term_text, state.facts) if "rest" not in one))
    stuck = known.base.plan(["at(bolt, s2)", "at(nut, s1)"], left)
    assert not stuck.ok
    refused = known.base.plan(["at(bolt, taken)"], state).findings[0]
    assert "at `taken` the part `bolt` would be 14.0 mm deep in `post`" in refused.message
    assert refused.hint == "choose another location, or move `post`"


def test_texts_of_a_knowledge_base_need_no_trust(tmp_path: Path) -> None:
    folder = new_project(tmp_path / "cell", "first_cell")
    (folder / "kb").mkdir()
    (folder / "kb" / "own.pl").write_text("part(bolt).")
    project = open_project(folder)
    assert has_knowledge(project)
    assert "X890" not in [one.code for one in project.diagnostics]
    (folder / "run.pl").write_text("part(bolt).")
    assert "X890" in [one.code for one in open_project(folder).diagnostics]


def test_a_check_of_the_project_tells_what_is_wrong_with_its_tasks(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = new_project(tmp_path / "cell", "first_cell")
    (folder / "kb").mkdir()
    (folder / "kb" / "own.pl").write_text("task(wave, [body([open, clos])]).\n")
    assert main(["check", str(folder)]) == 1
    assert "own.pl:1:25" in capsys.readouterr().err


@pytest.mark.parametrize("call", ["park (0, 0, 100) in tabel", "grip (0, 0, 100) in tabel"])
def test_a_point_in_a_frame_that_the_cell_does_not_have_is_told_so_with_a_near_name(
    tmp_path: Path, call: str
) -> None:
    (tmp_path / "cell.toml").write_text(
        CELL.replace("[signals", "[frames.table]\nposition = [400, 0, 0]\n[signals")
    )
    known = open_knowledge(tmp_path)
    (finding,) = known.base.check(call, known.state).findings
    assert (finding.code, finding.message) == ("P151", "Frame not defined: `tabel`")
    assert finding.hint == "did you mean `table`?"
    for goal in ("parked(in(p(0,0,100),tabel))", "at(bolt,in(p(0,0,100),tabel))"):
        (finding,) = known.base.plan([goal], known.state).findings
        assert (finding.code, finding.message) == ("P154", "no plan: there is no frame `tabel`")
        assert finding.hint == "did you mean `table`?"


def test_a_pattern_in_a_frame_that_is_not_there_is_told_so(tmp_path: Path) -> None:
    (tmp_path / "cell.toml").write_text(CELL)
    known = open_knowledge(tmp_path)
    (finding,) = known.base.check("load_pallet s1, (0, 0, 0) in table, 2, 1, 75", known.state).findings
    assert (finding.message, finding.hint) == ("Frame not defined: `table`", "the cell has no frames")


def test_a_goal_at_a_location_that_the_cell_does_not_have_is_told_so(known: Knowledge) -> None:
    (finding,) = known.base.plan(["at(bolt, rset)"], known.state).findings
    assert (finding.message, finding.hint) == ("no plan: there is no location `rset`", "did you mean `rest`?")
