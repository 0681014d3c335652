"""Arcs, curves and points on the way: both ways of writing them, and what each one makes."""

import math
from dataclasses import replace

import pytest

from ropsim.flow import MotionKind, MoveInstruction
from ropsim.icr import disassemble, run
from ropsim.language import Environment
from ropsim.spatial import Pose
from support.tasks import CELL, codes, compiled, only

UNITS = "program p\nunits mm, deg, s\n"
PLACES = "loc a = (300, 0, 100)\nloc b = (350, 80, 100)\nloc c = (400, 0, 100)\n"
UPRIGHT = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
MOVING = replace(
    CELL,
    external=("angle",),
    frames={**CELL.frames, "plate": UPRIGHT, "disc": UPRIGHT},
    moving=frozenset(["plate", "disc"]),
)


def moves(text: str, environment: Environment = CELL) -> list[MoveInstruction]:
    result = compiled(UNITS + PLACES + text, environment)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    return list(run(result.icr).moves)


def x_of(pose: object) -> float:
    assert isinstance(pose, Pose)
    return round(1e3 * pose.as_tuple()[0], 6)


def shape(move: MoveInstruction) -> tuple[str, list[float], float]:
    """Return kind, x of the via points and x of the target [mm]."""
    return move.kind, [x_of(one) for one in move.via], x_of(move.target)


@pytest.mark.parametrize("verb", ["circ", "movc", "MovC"])
def test_an_arc_is_written_in_two_ways(verb: str) -> None:
    (arc,) = moves(f"{verb} via b to c")
    assert (shape(arc), arc.angle) == (("CIRC", [350.0], 400.0), None)


def test_an_arc_may_go_on_for_an_angle() -> None:
    (arc,) = moves("x = 2\ncirc via b to c angle 180 * x")
    assert arc.angle == pytest.approx(2 * math.pi)


@pytest.mark.parametrize("written", ["via a, b to c", "a, b to c", "VIA a,\nb TO c"])
def test_a_curve_leads_through_its_points(written: str) -> None:
    if "\n" in written:
        written = written.replace("\n", "\\\n")
    (curve,) = moves(f"spline {written}")
    assert shape(curve) == ("SPLINE", [300.0, 350.0], 400.0)


@pytest.mark.parametrize(("verb", "kind"), [("mov", "PTP"), ("movj", "PTP"), ("lin", "LIN"), ("movl", "LIN")])
def test_points_on_the_way_are_moves_that_pass_by(verb: str, kind: str) -> None:
    found = moves(f"{verb} via a, b to c")
    assert [shape(one) for one in found] == [(kind, [], 300.0), (kind, [], 350.0), (kind, [], 400.0)]
    assert [one.modal.passes for one in found] == [True, True, False]
    assert len({one.origin.span for one in found}) == 1


def test_the_zone_in_force_is_that_of_the_points_on_the_way() -> None:
    found = moves("set blend 5\nlin via a, b to c fine\nlin via a to b blend 3\nlin c")
    assert [one.modal.zone for one in found] == pytest.approx([0.005, 0.005, 0.0, 0.003, 0.003, 0.005])


def test_ways_through_joints_and_home_are_pose_to_pose_only() -> None:
    found = moves("mov via joints(0, 90), home to a speed 50 %")
    assert [one.target for one in found[:2]] == [pytest.approx((0.0, math.pi / 2)), None]
    assert {one.modal.ptp_speed for one in found} == {0.5}
    assert codes(UNITS + PLACES + "lin via joints(0, 90) to a") == ["T301"]
    assert codes(UNITS + PLACES + "circ via home to a") == ["T301"]


def test_via_may_be_a_name_elsewhere() -> None:
    first, second = moves("via = a\nangle = 3 mm\nlin via via offset (angle, 0, 0) to b")
    assert (x_of(first.target), x_of(second.target)) == (303.0, 350.0)


def test_a_classic_task_counts_the_points_of_its_motions_as_references() -> None:
    text = "task Arc\ncirc via l2 to l3 angle a\nspline l1, l2 to l4\nendp\n"
    result = compiled(text + "call Arc (1, 2, 3), (2, 3, 9), (3, 4, 5), (4, 5, 6), 90")
    assert result.program is not None
    (arc,) = result.program.tasks
    assert [one.name for one in arc.parameters] == ["l1", "l2", "l3", "l4", "a"]


def test_an_arc_lies_in_the_frame_of_its_points_that_move() -> None:
    (arc,) = moves("circ via (10, 20, 0) in plate to (20, 0, 0) in plate", MOVING)
    assert (arc.modal.frame, shape(arc)) == ("plate", ("CIRC", [10.0], 20.0))
    result = compiled(UNITS + PLACES + "circ via (10, 20, 0) in disc to (20, 0, 0) in plate", MOVING)
    assert result.icr is not None
    trap = run(result.icr).trap
    assert trap is not None
    assert trap.code == "I465"


def test_points_of_a_path_have_no_external_values_of_their_own() -> None:
    external = replace(CELL, external=("length",))
    (arc,) = moves("circ via b to c external (800)", external)
    assert arc.external == (0.8,)
    (arc,) = moves("circ via b external (800) to c external (800)", external)
    assert arc.external == (0.8,)
    assert codes(UNITS + PLACES + "circ via b external (800) to c", external) == ["T301"]
    assert codes(UNITS + PLACES + "spline a, b external (800) to c external (700)", external) == ["T301"]
    assert [one.external for one in moves("mov via b external (800) to c", external)] == [(0.8,), ()]


def test_a_computed_angle_that_is_not_greater_than_zero_ends_the_program() -> None:
    result = compiled(UNITS + PLACES + "x = 90 deg\nx = x - 90 deg\ncirc via b to c angle x")
    assert result.icr is not None
    trap = run(result.icr).trap
    assert trap is not None
    assert trap.code == "I461"


def test_points_on_one_line_are_found_where_the_start_is_known() -> None:
    assert only(UNITS + PLACES + "lin a\ncirc via (350, 0, 100) to c").code == "T393"
    assert codes(UNITS + PLACES + "circ via (350, 0, 100) to c") == []
    assert codes(UNITS + PLACES + "lin a tool jaws\ncirc via (350, 0, 100) to c") == []
    assert codes(UNITS + PLACES + "lin a\nset tool jaws\ncirc via (350, 0, 100) to c") == []
    assert codes(UNITS + PLACES + "lin a\ncirc via (350, 0.01, 100) to c") == []
    assert codes(UNITS + PLACES + "circ via b to c angle 90\ncirc via (450, 0, 100) to (500, 0, 100)") == []


def test_the_start_is_known_after_branches_that_end_in_one_place() -> None:
    text = "if part_ok\nlin a\nelse\nmov {}\nendif\ncirc via b to a\n"
    assert codes(UNITS + PLACES + text.format("a")) == ["T393"]
    assert codes(UNITS + PLACES + text.format("c")) == []


def test_the_code_of_a_motion_without_points_is_as_short_as_before() -> None:
    result = compiled(UNITS + PLACES + "lin a")
    assert result.icr is not None
    assert "MODAL" not in disassemble(result.icr)
    assert MotionKind.CIRC not in disassemble(result.icr)


@pytest.mark.parametrize(
    ("location", "hint"),
    [
        ("(1, 2, 3; roll 0 pitch 60 yaw 0)", "write `,` between parts of an orientation"),
        ("(1, 2, 3; down; config(left))", "write `,` between parts of an orientation"),
        ("(1, 2, 3; 0, 90, 0)", "say which angles: `rpy ROLL PITCH YAW`"),
    ],
)
def test_parts_of_an_orientation_that_are_written_otherwise_have_a_hint(location: str, hint: str) -> None:
    found = only(f"program p\nunits mm\nmov {location}")
    assert found.code == "L101"
    assert hint in found.hint
