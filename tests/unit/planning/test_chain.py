"""Whole moves: from the instruction to the references of the joint controller."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import ModalState
from ropsim.kinematics import forward_batch, posture
from ropsim.motion import Line, OrientationMode
from ropsim.planning import StandardPathPlanner
from ropsim.spatial import Array, Pose
from support.cells import chain_of, with_station
from support.motion import CELL, CHAIN, PUMA, START, interface_pose, lin, planned, ptp, shifted

ON_LINE = 5e-9  # [m] the path between samples is as smooth as its own check at every second one asks for
AT_SAMPLES = 1e-9  # [m] inverse kinematics promises 1e-9 m
ANGLE = 1e-9  # [rad]


def off_line(matrices: Array, start: Array, end: Array) -> Array:
    way = (end - start) / np.linalg.norm(end - start)
    offsets: Array = np.linalg.norm(np.cross(matrices[:, :3, 3] - start, way), axis=1)
    return offsets


def test_ptp_to_a_pose_ends_at_the_pose() -> None:
    goal = shifted(interface_pose(START), -0.1, 0.2, -0.05)
    move = planned(ptp(goal))
    assert [piece.path for piece in move.path_segments] == [None]
    assert np.abs(interface_pose(move.q_end).matrix() - goal.matrix()).max() < AT_SAMPLES


def test_lin_ends_at_the_pose() -> None:
    goal = shifted(interface_pose(START), 0.05, 0.1, -0.06)
    move = planned(lin(goal))
    path = move.path_segments[0].path
    assert isinstance(path, Line)
    assert path.X_end == goal
    assert np.abs(interface_pose(move.q_end).matrix() - goal.matrix()).max() < AT_SAMPLES


def test_q_end_is_the_last_reference_at_rest() -> None:
    for make in (ptp, lin):
        move = planned(make(shifted(interface_pose(START), 0.05, 0.1, -0.06)))
        assert move.q_end.tolist() == move.reference.q[-1].tolist()
        assert move.reference.qd[-1].tolist() == [0.0] * 6


def test_a_move_ends_at_the_first_control_tick_at_which_it_rests() -> None:
    for make in (ptp, lin):
        move = planned(make(shifted(interface_pose(START), 0.05, 0.1, -0.06)))
        assert move.reference.qd[-2].any()
        assert move.duration == pytest.approx(move.reference.ticks / 1000.0, abs=1e-12)
        assert (move.moves[0].last, move.path_segments[0].last) == (move.ticks, move.ticks)


def test_moves_follow_each_other_without_a_jump() -> None:
    first = planned(ptp(shifted(interface_pose(START), -0.1, 0.2, -0.05)))
    second = planned(lin(shifted(interface_pose(first.q_end), 0.0, 0.0, -0.06)), first.q_end)
    step = np.abs(second.reference.q[0] - first.reference.q[-1])
    assert (step <= PUMA.max_speeds * 1e-3).all()


def test_lin_stays_on_the_straight_line() -> None:
    start, goal = interface_pose(START), shifted(interface_pose(START), -0.1, 0.15, -0.08)
    matrices = forward_batch(PUMA, planned(lin(goal)).reference.q)
    offsets = off_line(matrices, start.position, goal.position)
    assert offsets.max() < ON_LINE


def test_lin_keeps_its_orientation_where_start_and_end_agree() -> None:
    matrices = forward_batch(
        PUMA, planned(lin(shifted(interface_pose(START), -0.1, 0.15, -0.08))).reference.q
    )
    assert np.abs(matrices[:, :3, :3] - interface_pose(START).rotation()).max() < ON_LINE


def test_lin_has_a_plateau_of_the_commanded_speed() -> None:
    move = planned(lin(shifted(interface_pose(START), -0.1, 0.15, -0.08), ModalState(path_speed=0.15)))
    positions = forward_batch(PUMA, move.reference.q)[:, :3, 3]
    speeds = np.linalg.norm(np.diff(positions, axis=0), axis=1) * 1e3
    plateau = speeds[len(speeds) // 3 : 2 * len(speeds) // 3]
    assert np.abs(plateau - 0.15).max() < 1e-6 * 0.15
    assert speeds.max() < 0.15 * (1.0 + 1e-6)


def test_tcp_of_a_tool_stays_on_the_straight_line_and_turns_to_the_goal() -> None:
    X_MT = CELL.first.tools["torch"].X_MT
    start = interface_pose(START) @ X_MT
    turned = Pose(start.position + np.array([0.06, 0.1, 0.05]), (start @ _turn(0.4)).orientation)
    move = planned(lin(turned, ModalState(tool="torch")))
    matrices = forward_batch(PUMA, move.reference.q) @ X_MT.matrix()
    offsets = off_line(matrices, start.position, turned.position)
    assert offsets.max() < ON_LINE
    assert np.abs(matrices[-1] - turned.matrix()).max() < AT_SAMPLES


def test_a_planner_with_the_drive_transform_swings_the_tool_in_a_plane() -> None:
    planner = CHAIN.planner
    assert isinstance(planner, StandardPathPlanner)
    swinging = replace(planner.controller, orientation=OrientationMode.DRIVE_TRANSFORM)
    chain = replace(CHAIN, planner=replace(planner, controller=swinging))
    start = interface_pose(START)
    goal = Pose(start.position, (start @ _turn(0.4)).orientation)
    move = planned(lin(goal), START, chain)
    assert np.abs(interface_pose(move.q_end).matrix() - goal.matrix()).max() < AT_SAMPLES
    approach = forward_batch(PUMA, move.reference.q)[:, :3, 2]
    normal = np.cross(start.rotation()[:, 2], goal.rotation()[:, 2])
    assert np.abs(approach @ normal).max() < ON_LINE


def test_targets_are_meant_in_the_task_frame_of_the_cell() -> None:
    X_BT = shifted(interface_pose(START), 0.05, 0.0, 0.0)
    X_KT = CELL.frames["pallet"].X_PK.inverse() @ X_BT
    nominal = Pose(np.array([9.0, 9.0, 9.0]))  # overridden by the cell
    move = planned(ptp(X_KT, ModalState(frame="pallet", X_BK=nominal)))
    assert np.abs(interface_pose(move.q_end).matrix() - X_BT.matrix()).max() < AT_SAMPLES


def test_a_task_frame_of_the_program_holds_where_the_cell_has_none() -> None:
    X_BK = Pose(np.array([0.3, 0.0, 0.1]))
    X_BT = shifted(interface_pose(START), 0.05, 0.0, 0.0)
    move = planned(ptp(X_BK.inverse() @ X_BT, ModalState(frame="bench", X_BK=X_BK)))
    assert np.abs(interface_pose(move.q_end).matrix() - X_BT.matrix()).max() < AT_SAMPLES
    assert move.findings == ()


def test_tools_of_the_cell_override_those_of_the_program() -> None:
    nominal = Pose(np.array([0.5, 0.5, 0.5]))
    X_BT = interface_pose(START) @ CELL.first.tools["gripper"].X_MT
    move = planned(ptp(X_BT, ModalState(tool="gripper", X_MT=nominal)))
    assert np.abs(move.q_end - START).max() < ANGLE


def test_a_tool_of_the_program_holds_where_the_cell_has_none() -> None:
    nominal = Pose(np.array([0.0, 0.05, 0.1]))
    move = planned(ptp(interface_pose(START) @ nominal, ModalState(tool="probe", X_MT=nominal)))
    assert np.abs(move.q_end - START).max() < ANGLE


def test_the_default_tool_of_the_cell_holds_where_the_program_names_none() -> None:
    chain = chain_of(with_station(CELL, default_tool="gripper"))
    move = planned(ptp(interface_pose(START) @ CELL.first.tools["gripper"].X_MT), START, chain)
    assert np.abs(move.q_end - START).max() < ANGLE
    assert chain.tool_pose(move.moves[0].move.modal) == CELL.first.tools["gripper"].X_MT


def test_without_any_tool_the_mechanical_interface_is_the_tool() -> None:
    assert CHAIN.tool_pose(ptp(None).modal) == Pose()


def test_a_target_without_coordinates_is_the_home_position() -> None:
    assert planned(ptp(None)).q_end.tolist() == PUMA.home.tolist()


def test_ptp_to_joint_coordinates_ends_exactly_there() -> None:
    goal = (0.5, 1.0, -3.4, 2.5, 0.5, -4.0)  # joints 3 and 6 beyond half a turn
    assert tuple(planned(ptp(goal)).q_end.tolist()) == goal


def test_moves_to_where_the_arm_is_take_no_time() -> None:
    here = interface_pose(START)
    for move in (ptp(here), ptp(tuple(START.tolist())), lin(here)):
        done = planned(move)
        assert done.reference.ticks == 0
        assert done.duration == 0.0
        assert done.q_end.tolist() == START.tolist()


def test_ptp_keeps_the_posture_and_the_turns_of_the_start() -> None:
    q_start = START + np.array([0.0, 0.0, 0.0, 2.0, 0.0, 3.9])  # joint 6 beyond half a turn
    goal = shifted(interface_pose(q_start), 0.03, 0.05, -0.02)
    move = planned(ptp(goal), q_start)
    assert posture(PUMA, move.q_end) == posture(PUMA, q_start)
    assert np.abs(move.q_end - q_start).max() < 0.5


def test_lin_keeps_the_turns_of_the_start() -> None:
    q_start = START + np.array([0.0, 0.0, 0.0, 2.0, 0.0, 3.9])
    move = planned(lin(shifted(interface_pose(q_start), 0.03, 0.05, -0.02)), q_start)
    assert np.abs(move.q_end - q_start).max() < 0.5


def test_lin_goes_straight_through_a_wrist_singularity_that_it_meets_exactly() -> None:
    singular = np.array([0.2, 1.0, -2.7, 0.3, 0.0, 0.1])
    middle = interface_pose(singular)
    q_start = planned(ptp(shifted(middle, 0.0, -0.1, 0.0)), singular).q_end
    move = planned(lin(shifted(middle, 0.0, 0.1, 0.0)), q_start)
    assert q_start[4] * move.q_end[4] < 0.0
    offsets = off_line(
        forward_batch(PUMA, move.reference.q),
        interface_pose(q_start).position,
        interface_pose(move.q_end).position,
    )
    assert offsets.max() < ON_LINE


def test_all_joints_of_a_ptp_move_start_and_end_together() -> None:
    move = planned(ptp(shifted(interface_pose(START), -0.1, 0.2, -0.05)))
    way = move.q_end - START
    progress = (move.reference.q - START) / way
    assert np.abs(progress - progress[:, :1]).max() < 1e-9
    assert (np.abs(move.reference.qd[move.reference.ticks // 2]) > 0.0).all()


def test_ptp_speed_share_and_override_slow_the_leading_joint_down() -> None:
    goal = (1.5, 1.1, -2.9, -0.4, -0.9, 0.3)  # joint 1 turns 1.3 rad
    half = chain_of(with_station(CELL, controller=replace(CELL.first.controller, speed_override=0.5)))
    for move in (planned(ptp(goal, ModalState(ptp_speed=0.5))), planned(ptp(goal), START, half)):
        peak = np.abs(move.reference.qd[:, 0]).max()
        assert peak == pytest.approx(0.5 * PUMA.joints[0].max_speed, rel=1e-9)


def test_ptp_acceleration_share_lowers_the_peak_acceleration() -> None:
    goal = (1.5, 1.1, -2.9, -0.4, -0.9, 0.3)
    move = planned(ptp(goal, ModalState(ptp_acceleration=0.25)))
    peak = np.abs(move.reference.qdd[:, 0]).max()
    assert peak == pytest.approx(0.25 * PUMA.joints[0].max_acceleration, rel=1e-9)


def test_planning_twice_gives_the_same_bits() -> None:
    goal = shifted(interface_pose(START), 0.05, 0.1, -0.06)
    for make in (ptp, lin):
        first, second = planned(make(goal)), planned(make(goal))
        assert first.reference.q.tobytes() == second.reference.q.tobytes()
        assert first.reference.qdd.tobytes() == second.reference.qdd.tobytes()


def _turn(angle: float) -> Pose:
    return Pose(
        np.zeros(3),
        np.array([np.cos(angle / 2.0), 0.6 * np.sin(angle / 2.0), 0.8 * np.sin(angle / 2.0), 0.0]),
    )
