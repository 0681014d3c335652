"""Laws of whole moves on random targets: planned within limits, or refused with a reason on the line."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import robots
from ropsim.flow import ModalState, MoveInstruction
from ropsim.kinematics import forward, forward_batch
from ropsim.model import on_track
from ropsim.planning import MotionState, Refusal, plan, plan_move
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.examples import examples
from support.motion import CHAIN, LINE, PUMA, Target, interface_pose, lin, ptp, references, shifted

POSE = 1e-9  # [m] and per entry of the rotation; the promise of the inverse kinematics
ON_LINE = 5e-9  # [m] off the line; the joints between samples are as smooth as `leg` asks for
TRACK = on_track(PUMA, robots.linear_track(4.0))
TRACK_CHAIN = chain_of(one_station("track", TRACK, robots.default_controller(TRACK)))
WITHIN = 1.0 + 1e-9  # of limits: rounding
ONE_STEP = 1e-6  # [rad] more than the jerk limits let a joint go in two control ticks

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


@settings(max_examples=examples(100), derandomize=True)
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
        assert (np.abs(reference.qd) / PUMA.max_speeds).max() <= WITHIN
        assert (np.abs(reference.qdd) / PUMA.max_accelerations).max() <= WITHIN
        jerk = np.abs(np.diff(reference.qdd, axis=0, prepend=0.0)) / 1e-3
        assert (jerk / PUMA.max_jerks).max() <= 1.0 + 1e-7  # differences lose digits


@settings(max_examples=examples(100), derandomize=True)
@given(configurations, shifts)
def test_lin_is_straight_and_keeps_its_speed_or_is_refused_on_its_line(
    start: Array, shift: tuple[float, float, float]
) -> None:
    begin = interface_pose(start)
    end = shifted(begin, *shift)
    move = plan_move(CHAIN, lin(end), start)
    if isinstance(move, Refusal):
        assert {finding.code for finding in move.diagnostics} <= {"M501", "M502", "M503", "M505"}
        assert all(finding.span == LINE and finding.is_error for finding in move.diagnostics)
        return
    if not move.reference.ticks:
        return
    matrices = forward_batch(PUMA, move.reference.q)
    way = end.position - begin.position
    offsets = np.linalg.norm(np.cross(matrices[:, :3, 3] - begin.position, way), axis=1) / np.linalg.norm(way)
    assert np.abs(matrices[-1] - end.matrix()).max() < POSE
    assert offsets.max() < ON_LINE
    steps = np.linalg.norm(np.diff(matrices[:, :3, 3], axis=0, prepend=begin.position[None]), axis=1)
    assert steps.max() / 1e-3 <= CHAIN.controller.path.speed * (1.0 + 1e-4)
    assert (np.abs(move.reference.qd) / PUMA.max_speeds).max() <= WITHIN
    assert (np.abs(move.reference.qdd) / PUMA.max_accelerations).max() <= WITHIN


@settings(max_examples=examples(60), derandomize=True)
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
        if not qd.any():  # a way of less than two control ticks is one step
            assert np.abs(q[-1] - start).max() <= ONE_STEP
            continue
        # the mean of the speeds at both ends of a tick is the mean speed, to third order in the tick
        bend = np.abs(np.diff(move.reference.qdd, axis=0)).max() * 1e-3 if move.reference.ticks > 1 else 0.0
        assert np.abs(np.diff(q, axis=0) / 1e-3 - (qd[1:] + qd[:-1]) / 2.0).max() <= bend + 1e-9


zones = st.one_of(st.just(0.0), st.floats(-7.0, 0.0).map(lambda exponent: float(10.0**exponent)))
steps = st.lists(st.tuples(st.sampled_from((ptp, lin)), shifts, zones), min_size=2, max_size=5)


@settings(max_examples=examples(60), derandomize=True)
@given(configurations, steps)
def test_stretches_run_on_without_steps_and_end_at_the_last_target_that_can_be_reached(
    start: Array, walk: list[tuple[Callable[..., MoveInstruction], tuple[float, float, float], float]]
) -> None:
    goal, moves, goals = interface_pose(start), [], []
    for make, shift, zone in walk:
        goal = shifted(goal, *shift)
        moves.append(make(goal, ModalState(zone=zone)))
        goals.append(goal)
    planned, refusal = plan(CHAIN, moves, MotionState.at_rest(start))
    assert (planned is None or len(planned.moves) < len(moves)) == (refusal is not None)
    if planned is None:
        return
    assert (
        np.abs(interface_pose(planned.q_end).matrix() - goals[len(planned.moves) - 1].matrix()).max() < POSE
    )
    lasts = [one.last for one in planned.moves]
    assert lasts == sorted(lasts)
    assert lasts[-1] == planned.ticks
    q, qd, qdd = references(planned)
    assert np.isfinite(qdd).all()
    bend = np.abs(np.diff(qdd, axis=0)).max(initial=0.0) * 1e-3
    assert np.abs(np.diff(q, axis=0) / 1e-3 - (qd[1:] + qd[:-1]) / 2.0).max(initial=0.0) <= bend + 1e-9
    assert (
        np.abs(np.diff(qd, axis=0) / 1e-3 - (qdd[1:] + qdd[:-1]) / 2.0).max(initial=0.0) <= bend / 1e-3 + 1e-6
    )
    limits = PUMA.max_speeds, PUMA.max_accelerations, PUMA.max_jerks
    for values, limit in zip((qd, qdd, np.diff(qdd, axis=0) / 1e-3), limits, strict=True):
        assert (np.abs(values) / limit).max(initial=0.0) <= WITHIN
    for one in planned.moves:
        assert 0.0 <= one.zone <= max(one.move.modal.zone * (1.0 + 1e-6), 0.0) + 1e-12


@settings(max_examples=examples(200), derandomize=True)
@given(wild_targets, wild_states)
def test_no_value_of_a_program_raises_an_exception(target: Target, modal: ModalState) -> None:
    for make in (ptp, lin):
        move = plan_move(CHAIN, make(target, modal), PUMA.home)
        if isinstance(move, Refusal):
            assert all(finding.span == LINE for finding in move.diagnostics)
        else:
            assert np.isfinite(move.reference.q).all()


@settings(max_examples=examples(150), derandomize=True)
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
