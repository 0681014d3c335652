"""Classic tasks: the printed program of paper 1, implicit parameters, contracts in prose."""

import math
from collections.abc import Sequence
from pathlib import Path

import pytest

from ropsim.flow import GripAction, MoveInstruction
from ropsim.icr import DryRun, run
from ropsim.language import Compiled, compile
from ropsim.program import ValueType
from ropsim.spatial import Pose
from support.tasks import codes, compiled, only

FIG5 = Path(__file__).parents[2] / "golden" / "task" / "fig5.task"
ROUNDING = 1e-12
"""Sums of six hundredths of a centimetre in double precision."""


@pytest.fixture(scope="module")
def printed() -> Compiled:
    return compile(FIG5.read_text(encoding="utf-8"), name="fig5.task")


@pytest.fixture(scope="module")
def trace(printed: Compiled) -> DryRun:
    assert printed.icr is not None
    return run(printed.icr)


def positions(moves: Sequence[MoveInstruction]) -> list[tuple[float, float, float]]:
    poses = [m.target for m in moves]
    assert all(isinstance(p, Pose) for p in poses)
    return [p.as_tuple()[:3] for p in poses if isinstance(p, Pose)]


def test_printed_program_has_no_finding(printed: Compiled) -> None:
    assert printed.diagnostics == ()
    assert printed.ok


def test_printed_program_makes_72_moves_36_closes_and_36_opens(trace: DryRun) -> None:
    actions = [g.action for g in trace.grips]
    assert len(trace.moves) == 72
    assert actions == [GripAction.CLOSE, GripAction.OPEN] * 36


def test_printed_program_grips_a_grid_with_x_reset_each_row_and_y_kept(trace: DryRun) -> None:
    expected = [(0.13 + 0.001 * i, 0.05 + 0.001 * j, 0.08) for j in range(6) for i in range(6)]
    for found, wanted in zip(positions(trace.moves[0::2]), expected, strict=True):
        assert found == pytest.approx(wanted, abs=ROUNDING)


def test_printed_program_releases_all_parts_at_location_two(trace: DryRun) -> None:
    assert set(positions(trace.moves[1::2])) == {(0.06, 0.03, 0.02)}


def test_three_numbers_point_the_tool_straight_down(trace: DryRun) -> None:
    for move in trace.moves:
        assert isinstance(move.target, Pose)
        assert move.target.rotation()[:, 2] == pytest.approx([0.0, 0.0, -1.0])


def test_implicit_parameters_are_locations_then_scalars_in_alphabetical_order(printed: Compiled) -> None:
    assert printed.program is not None
    task = printed.program.tasks[2]
    assert [(p.name, p.type) for p in task.parameters] == [
        ("l", ValueType.POSE),
        ("l2", ValueType.POSE),
        ("a", ValueType.REAL),
        ("b", ValueType.INT),
    ]


def test_every_move_knows_its_line(trace: DryRun) -> None:
    spans = [m.origin.span for m in trace.moves[:2]]
    assert [s.line for s in spans if s is not None] == [3, 9]


def test_prose_with_other_counts_is_a_warning() -> None:
    text = "task t\n needs two reference locations\n mov l\nendp\nt infeed\n"
    found = only(text)
    assert (found.code, found.is_error) == ("T308", False)
    assert "names 2 reference locations, the body uses 1" in found.message


def test_prose_ends_at_a_full_stop() -> None:
    assert codes("task t\n needs one location.\n gobble l\nendp\nt infeed\n") == ["N201"]


def test_prose_goes_on_without_one() -> None:
    assert codes("task t\n needs one location and\n gobble l\n mov l\nendp\nt infeed\n") == []


def test_a_misspelt_verb_in_prose_is_a_warning() -> None:
    found = compiled("task t\n needs care\n mvo l\n mov l\nendp\nt infeed\n").diagnostics
    assert [(d.code, d.hint.split("?")[0]) for d in found] == [("L112", "did you mean `mov`")]


def test_a_number_in_the_place_of_a_location_is_the_callers() -> None:
    result = compiled("task r\n mov l\nendp\ntask s\n r 3\n mov l\nendp\ns infeed, infeed, (1,2,3)\n")
    assert result.program is not None
    assert [p.name for p in result.program.tasks[1].parameters] == ["l", "l2", "l3"]


def test_keywords_have_no_case_but_names_have() -> None:
    assert codes('TASK "Grip"\n MOV l\n CLOSE\nENDP\nGrip infeed.\n') == []
    assert only("task Grip\n mov l\nendp\ngrip infeed\n").hint == "did you mean `Grip`?"


def test_five_names_of_load_are_pitch_and_roll_of_five_numbers() -> None:
    text = "units mm, deg\nload (x, y, z, p, r), (300, 200, 100, 30, 40)\nlin (x, y, z, p, r)\n"
    lowered = compiled(text).icr
    direct = compiled("units mm, deg\nlin (300, 200, 100, 30, 40)\n").icr
    assert lowered is not None
    assert direct is not None
    found, wanted = run(lowered).moves[0].target, run(direct).moves[0].target
    assert isinstance(found, Pose)
    assert isinstance(wanted, Pose)
    assert found.as_tuple() == pytest.approx(wanted.as_tuple(), abs=ROUNDING)


def test_five_numbers_approach_along_the_azimuth_of_the_point() -> None:
    lowered = compiled("units mm, deg\nlin (300, 300, 100, 0, 0)\n").icr
    assert lowered is not None
    target = run(lowered).moves[0].target
    assert isinstance(target, Pose)
    assert target.rotation()[:, 2] == pytest.approx([math.sqrt(0.5), math.sqrt(0.5), 0.0])


def test_a_broken_line_of_a_classic_task_does_not_spoil_its_calls() -> None:
    text = "task grip\n needs one reference location\n mov l speed\n close\nendp\ngrip infeed\n"
    assert codes(text) == ["L101"]


def test_a_warning_never_drops_a_call() -> None:
    text = "task grip\n needs one reference location\n mvo l\n close\nendp\ngrip infeed\n"
    assert codes(text) == ["L112", "T303"]
    assert not compiled(text).ok


def test_the_arguments_of_a_call_whose_result_is_assigned_are_those_of_a_call() -> None:
    """A name of a parameter is none of the caller; a number in the place of a location is its location."""
    height = "task H(q: loc, up: length = 5) -> length\nreturn q.z + up\nendp\n"
    task = "task T\nmov l\nh = H(2, up = a)\nlin l above h\nendp\n"
    result = compiled(f"units mm\n{height}{task}T infeed, (1, 2, 3), 7")
    assert result.diagnostics == ()
    assert result.program is not None
    assert [p.name for p in result.program.tasks[1].parameters] == ["l", "l2", "a"]
    assert result.icr is not None
    assert positions(run(result.icr).moves)[1] == pytest.approx((0.4, 0.3, 0.11), abs=ROUNDING)
