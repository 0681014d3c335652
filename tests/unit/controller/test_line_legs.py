"""Legs of lines that are led all at once: they are those of the moves one by one."""

from dataclasses import astuple, replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import MotionChain, Refusal
from ropsim.controller.leg import Leg, leg_of
from ropsim.controller.legs_in_order import legs_in_order
from ropsim.controller.line_legs import line_legs_of
from ropsim.controller.part_times_kernel import longest_cell
from ropsim.controller.posture_trouble import max_speeds_of
from ropsim.flow import ModalState, MotionKind, MoveInstruction, PostureRequest
from ropsim.kinematics import forward
from ropsim.model import OrientationMode
from ropsim.motion import Line, Traced
from ropsim.robots import default_controller
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import CHAIN, START, lin, ptp

WRISTS = ["puma560", "irb4600_60_205", "kr210_r2700_2"]
OTHERS = ["ur10e", "panda", "scara"]
MODES = [OrientationMode.FIXED_AXIS, OrientationMode.DRIVE_TRANSFORM]
ROUNDING = (
    1e-9  # a start differs by the rounding of forward kinematics, and near singularities joints by more
)
FRAMED = ModalState(frame="pallet", tool="torch")
GRIPPER = ModalState(tool="gripper")


def chain_for(name: str, mode: OrientationMode) -> MotionChain:
    controller = replace(default_controller(name), orientation=mode)
    return chain_of(one_station("c", robots.load(name), controller))


def walk(chain: MotionChain, random: np.random.Generator) -> tuple[Array, list[MoveInstruction]]:
    """Return a start in the middle of the joint ranges, and lines from there of up to some decimetres."""
    robot = chain.robot
    share = random.uniform(0.35, 0.65, robot.n)
    q = np.asarray(robot.lower_limits + share * (robot.upper_limits - robot.lower_limits))
    targets = [forward(robot, q + random.normal(scale=0.1, size=robot.n)) for _ in range(6)]
    return q, [lin(target, ModalState(zone=0.01 * number)) for number, target in enumerate(targets)]


def assert_same(quick: Leg, slow: Leg) -> None:
    assert isinstance(quick.tool, Line)
    assert isinstance(slow.tool, Line)
    assert isinstance(quick.joints, Traced)
    assert isinstance(slow.joints, Traced)
    assert quick.move is slow.move
    assert (quick.findings, quick.planned.limits, quick.planned.X_MT) == (
        slow.findings,
        slow.planned.limits,
        slow.planned.X_MT,
    )
    assert quick.tool.X_end == slow.tool.X_end
    assert quick.tool.mode is slow.tool.mode
    at = np.linspace(0.0, min(quick.tool.length, slow.tool.length), 9)
    for here, there in zip(astuple(quick.tool.tool(at)), astuple(slow.tool.tool(at)), strict=True):
        assert here == pytest.approx(there, abs=ROUNDING)
    assert quick.joints.length == pytest.approx(slow.joints.length, abs=ROUNDING)
    assert quick.joints.q == pytest.approx(slow.joints.q, abs=ROUNDING)
    assert quick.joints.derivatives == pytest.approx(slow.joints.derivatives, abs=ROUNDING)
    assert np.array_equal(quick.q_end, quick.joints.q[-1])


def assert_as_one_by_one(chain: MotionChain, moves: list[MoveInstruction], q_start: Array) -> int:
    """Hold the legs of all moves against those one by one; return how many there are."""
    lines = line_legs_of(chain)
    assert lines is not None
    led = lines.legs(moves, 0, q_start)
    q = q_start
    for move, quick in zip(moves, led, strict=False):
        slow = leg_of(chain, move, q)
        assert isinstance(slow, Leg)
        assert_same(quick, slow)
        told = np.empty(1)
        assert isinstance(quick.joints, Traced)
        longest_cell(quick.joints.q, quick.joints.derivatives, max_speeds_of(chain.robot), told)
        assert quick.longest == told[0]
        q = quick.q_end
    return len(led)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("name", WRISTS)
def test_lines_are_led_at_once_as_one_by_one(name: str, mode: OrientationMode) -> None:
    chain, random = chain_for(name, mode), np.random.default_rng(5)
    counts = []
    for _ in range(8):
        q_start, moves = walk(chain, random)
        counts.append(assert_as_one_by_one(chain, moves, q_start))
    assert sum(counts) > 16


def test_lines_in_a_task_frame_with_a_tool_are_led_at_once_as_one_by_one() -> None:
    X_BT = forward(CHAIN.robot, START) @ CHAIN.tool_pose(FRAMED)
    X_BK = CHAIN.work.frame_pose(FRAMED, START)
    ways = np.array([[0.05, 0.0, 0.0], [0.0, 0.04, -0.03], [0.02, 0.02, 0.02]])
    moves = [lin(X_BK.inverse() @ replace(X_BT, position=X_BT.position + way), FRAMED) for way in ways]
    assert assert_as_one_by_one(CHAIN, moves, START) == 3


def test_a_line_with_another_tool_begins_a_new_run() -> None:
    X_BM = forward(CHAIN.robot, START)
    near, far = (replace(X_BM, position=X_BM.position + np.array([x, 0.0, 0.1])) for x in (0.02, 0.05))
    lines = line_legs_of(CHAIN)
    assert lines is not None
    moves = [lin(near, GRIPPER), lin(far, GRIPPER), lin(near, FRAMED)]
    assert len(lines.legs(moves, 0, START)) == 2


@pytest.mark.parametrize("name", OTHERS)
def test_arms_without_exact_spherical_wrist_are_led_one_by_one(name: str) -> None:
    assert line_legs_of(chain_for(name, MODES[0])) is None


def beyond() -> list[MoveInstruction]:
    X_BM = forward(CHAIN.robot, START)
    spot = X_BM.position
    creeping = ModalState(path_speed=1e-5, orientation_speed=1e-5)
    return [
        lin(X_BM),  # where the run has come to: of no length
        lin(replace(X_BM, position=spot + np.array([3.0, 0.0, 0.0]))),  # out of reach
        lin(replace(X_BM, position=spot + np.array([3e3, 0.0, 0.0]))),  # of a mistaken unit
        lin(replace(X_BM, position=spot * np.array([-1.0, -1.0, 1.0]))),  # past the axis of joint 1
        lin(replace(X_BM, position=spot + np.array([0.0, 0.03, 0.0])), creeping),  # takes an hour
        lin(tuple(START)),
        ptp(X_BM),
        replace(lin(X_BM), kind=MotionKind.CIRC, via=(X_BM,)),
    ]


@pytest.mark.parametrize("number", range(8))
def test_what_cannot_be_led_ends_the_run_and_is_made_or_refused_as_by_itself(number: int) -> None:
    X_BM = forward(CHAIN.robot, START)
    moves = [lin(replace(X_BM, position=X_BM.position + np.array([0.02, 0.0, 0.0]))), lin(X_BM)]
    moves.append(beyond()[number])
    lines = line_legs_of(CHAIN)
    assert lines is not None
    led = lines.legs(moves, 0, START)
    legs, refusal = legs_in_order(CHAIN, moves, START)
    assert len(led) == 2
    assert lines.legs(moves, 2, led[-1].q_end) == []
    alone = leg_of(CHAIN, moves[2], led[-1].q_end)
    if isinstance(alone, Refusal):
        assert refusal is not None
        assert refusal.diagnostics == alone.diagnostics
    else:
        assert refusal is None
        assert np.array_equal(legs[2].q_end, alone.q_end)


def test_a_way_that_asks_for_more_rows_is_led_with_them() -> None:
    """A line past the wrist singularity, for which the first rows are too few."""
    q = np.array([0.2, 1.1, -2.9, -0.4, -0.12, 0.3])
    X_BM = forward(CHAIN.robot, q)
    moves = [lin(replace(X_BM, position=X_BM.position + np.array([0.0, 0.12, 0.02])))]
    assert assert_as_one_by_one(CHAIN, moves, q) == 1
    lines = line_legs_of(CHAIN)
    assert lines is not None
    joints = lines.legs(moves, 0, q)[0].joints
    assert isinstance(joints, Traced)
    assert len(joints.q) > 33


def test_findings_about_a_posture_are_those_of_the_move_by_itself() -> None:
    X_BM = forward(CHAIN.robot, START)
    for words in (("left",), ("right",)):
        move = replace(lin(Pose(X_BM.position + 0.01, X_BM.orientation)), posture=PostureRequest(words))
        assert assert_as_one_by_one(CHAIN, [move], START) == 1
