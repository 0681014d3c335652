"""Laws of whole moves on random targets: planned within limits, or refused with a reason on the line."""

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import robots
from ropsim.controller import Refusal, plan_move
from ropsim.flow import ModalState
from ropsim.kinematics import forward, forward_batch
from ropsim.model import on_track
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import CHAIN, LINE, PUMA, Target, interface_pose, lin, ptp, shifted

POSE = 1e-9  # [m] and per entry of the rotation; the promise of the inverse kinematics
BETWEEN_SAMPLES = 20e-6  # [m] off the line between two poses 4 ms apart
TRACK = on_track(PUMA, robots.linear_track(4.0))
TRACK_CHAIN = chain_of(one_station("track", TRACK, robots.default_controller(TRACK)))
OVERSHOOT = 1.01  # of limits: the spline rounds the corners of the acceleration

shares = st.lists(st.floats(0.05, 0.95), min_size=6, max_size=6)
configurations = shares.map(
    lambda share: PUMA.lower_limits + np.array(share) * (PUMA.upper_limits - PUMA.lower_limits)
)
shifts = st.tuples(*[st.floats(-0.2, 0.2)] * 3)
wild = st.floats(allow_nan=True, allow_infinity=True)
wild_poses = st.tuples(wild, wild, wild).map(lambda place: Pose(np.array(place)))
wild_targets: st.SearchStrategy[Target] = st.one_of(
    st.none(), wild_poses, st.lists(wild, max_size=8).map(tuple)
)
wild_states = st.builds(
    ModalState,
    ptp_speed=wild,
    ptp_acceleration=st.one_of(st.just(1.0), wild),
    path_speed=st.one_of(st.none(), wild),
    path_acceleration=st.one_of(st.none(), wild),
    path_jerk=st.one_of(st.none(), wild),
    zone=st.one_of(st.just(0.0), wild),
)


@settings(max_examples=100, derandomize=True)
@given(configurations, configurations)
def test_ptp_reaches_every_pose_that_the_arm_can_take_within_all_limits(start: Array, goal: Array) -> None:
    pose = interface_pose(goal)
    move = plan_move(CHAIN, ptp(pose), start)
    assert not isinstance(move, Refusal)
    assert np.abs(interface_pose(move.q_end).matrix() - pose.matrix()).max() < POSE
    reference = move.reference
    if reference.ticks:
        assert (reference.q >= PUMA.lower_limits - POSE).all()
        assert (reference.q <= PUMA.upper_limits + POSE).all()
        assert (np.abs(reference.qd) / PUMA.max_speeds).max() <= OVERSHOOT
        assert (np.abs(reference.qdd) / PUMA.max_accelerations).max() <= OVERSHOOT


@settings(max_examples=100, derandomize=True)
@given(configurations, shifts)
def test_lin_is_straight_and_within_limits_or_refused_on_its_line(
    start: Array, shift: tuple[float, float, float]
) -> None:
    begin = interface_pose(start)
    end = shifted(begin, *shift)
    move = plan_move(CHAIN, lin(end), start)
    if isinstance(move, Refusal):
        assert {finding.code for finding in move.diagnostics} <= {"M501", "M502", "M503", "M504", "M505"}
        assert all(finding.span == LINE and finding.is_error for finding in move.diagnostics)
        return
    if not move.reference.ticks:
        return
    matrices = forward_batch(PUMA, move.reference.q)
    way = end.position - begin.position
    offsets = np.linalg.norm(np.cross(matrices[:, :3, 3] - begin.position, way), axis=1) / np.linalg.norm(way)
    assert offsets[3::4].max() < POSE
    assert offsets.max() < BETWEEN_SAMPLES
    assert np.abs(matrices[-1] - end.matrix()).max() < POSE
    assert (np.abs(move.reference.qd) / PUMA.max_speeds).max() <= OVERSHOOT
    accelerated = (np.abs(move.reference.qdd) / PUMA.max_accelerations).max() > OVERSHOOT
    assert not accelerated or [finding.code for finding in move.findings] == ["M510"]


@settings(max_examples=60, derandomize=True)
@given(configurations, shifts)
def test_references_run_on_without_steps_of_position_or_speed(
    start: Array, shift: tuple[float, float, float]
) -> None:
    end = shifted(interface_pose(start), *shift)
    for make in (ptp, lin):
        move = plan_move(CHAIN, make(end), start)
        if isinstance(move, Refusal) or not move.reference.ticks:
            continue
        q = np.concatenate((start[None], move.reference.q))
        qd = np.concatenate((np.zeros((1, 6)), move.reference.qd))
        # the mean of the speeds at both ends of a tick is the mean speed, to third order in the tick
        bend = np.abs(np.diff(move.reference.qdd, axis=0)).max() * 1e-3 if move.reference.ticks > 1 else 0.0
        assert np.abs(np.diff(q, axis=0) / 1e-3 - (qd[1:] + qd[:-1]) / 2.0).max() <= bend + 1e-9


@settings(max_examples=200, derandomize=True)
@given(wild_targets, wild_states)
def test_no_value_of_a_program_raises_an_exception(target: Target, modal: ModalState) -> None:
    for make in (ptp, lin):
        move = plan_move(CHAIN, make(target, modal), PUMA.home)
        if isinstance(move, Refusal):
            assert all(finding.span == LINE for finding in move.diagnostics)
        else:
            assert np.isfinite(move.reference.q).all()


@settings(max_examples=150, derandomize=True)
@given(st.booleans(), configurations, st.lists(wild | st.floats(-3.0, 3.0), max_size=3).map(tuple))
def test_no_value_of_an_external_axis_raises_an_exception(
    is_line: bool, goal: Array, external: tuple[float, ...]
) -> None:
    q = np.append(goal, 0.5)
    move = replace((lin if is_line else ptp)(forward(TRACK, q)), external=external)
    planned = plan_move(TRACK_CHAIN, move, np.append(PUMA.home, 0.5))
    if isinstance(planned, Refusal):
        assert planned.diagnostics
        assert all(finding.span == LINE for finding in planned.diagnostics)
    else:
        assert len(external) < 2
        assert np.abs(planned.q_end[6:] - (external or (0.5,))).max() < POSE
