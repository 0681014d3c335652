"""Legs from pose to pose that are chosen all at once: they are those of the moves one by one."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import MotionChain, Refusal
from ropsim.controller.leg import Leg, leg_of
from ropsim.controller.legs_in_order import legs_in_order
from ropsim.controller.ptp_legs import ptp_legs_of
from ropsim.flow import ModalState, MoveInstruction, PostureRequest
from ropsim.kinematics import forward, posture
from ropsim.model import Synchronisation
from ropsim.motion import JointLine, SynchronisedJoints
from ropsim.robots import default_controller
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import CHAIN, START, lin, ptp

WRISTS = ["puma560", "irb4600_60_205", "kr210_r2700_2"]
OTHERS = ["ur10e", "panda", "scara"]
ROUNDING = 1e-12  # of sine and cosine in compiled code
FRAMED = ModalState(frame="pallet", tool="torch", ptp_speed=0.5)


def chain_for(name: str, ptp_mode: Synchronisation = Synchronisation.TIME) -> MotionChain:
    controller = replace(default_controller(name), ptp=ptp_mode)
    return chain_of(one_station("c", robots.load(name), controller))


def walk(chain: MotionChain, random: np.random.Generator) -> tuple[Array, list[MoveInstruction]]:
    """Return a start, and moves from there to poses anywhere in the joint ranges."""
    robot = chain.robot
    width = robot.upper_limits - robot.lower_limits
    places = robot.lower_limits + random.uniform(0.1, 0.9, (7, robot.n)) * width
    shares = random.uniform(0.2, 1.0, 6).tolist()
    states = [ModalState(ptp_speed=share) for share in shares]
    moves = [ptp(forward(robot, q), modal, visit=1) for q, modal in zip(places[1:], states, strict=True)]
    return np.asarray(places[0]), moves


def hops(chain: MotionChain, random: np.random.Generator) -> tuple[Array, list[MoveInstruction]]:
    """Return a start near to a singular place, and moves from there that are short or keep the posture."""
    robot = chain.robot
    share = random.uniform(0.35, 0.65, robot.n)
    q = np.asarray(robot.lower_limits + share * (robot.upper_limits - robot.lower_limits))
    q[4] = random.choice([0.0, 1e-7, 0.05, -0.3])
    near = [q + random.normal(scale=scale, size=robot.n) for scale in (0.01, 0.1, 0.2, 0.3, 0.3)]
    return q, [ptp(forward(robot, one)) for one in near]


def assert_same(quick: Leg, slow: Leg) -> None:
    assert quick.move is slow.move
    assert quick.findings == slow.findings == ()
    assert quick.tool is slow.tool is None
    assert (quick.planned.limits, quick.planned.X_MT) == (slow.planned.limits, slow.planned.X_MT)
    assert quick.q_end == pytest.approx(slow.q_end, abs=ROUNDING)
    assert type(quick.joints) is type(slow.joints)
    here, there = quick.joints, slow.joints
    if isinstance(here, SynchronisedJoints) and isinstance(there, SynchronisedJoints):
        assert here.limits == there.limits
        assert here.shapes == pytest.approx(there.shapes, rel=1e-9, abs=ROUNDING)
    assert isinstance(here, JointLine | SynchronisedJoints)
    assert isinstance(there, JointLine | SynchronisedJoints)
    assert here.length == pytest.approx(there.length, rel=1e-9)
    assert np.array_equal(here.q_start, there.q_start)
    assert np.array_equal(here.q_end, quick.q_end)


def assert_as_one_by_one(chain: MotionChain, moves: list[MoveInstruction], q_start: Array) -> int:
    """Hold the legs of all moves against those one by one; return how many there are."""
    joints, q, count = ptp_legs_of(chain), q_start, 0
    assert joints is not None
    for first in range(len(moves)):
        begin = q
        for move, quick in zip(moves[first:], joints.legs(moves, first, q), strict=False):
            slow = leg_of(chain, move, begin)
            assert isinstance(slow, Leg)
            assert_same(quick, slow)
            begin, count = quick.q_end, count + 1
        alone = leg_of(chain, moves[first], q)
        if isinstance(alone, Refusal):
            break
        q = alone.q_end
    return count


@pytest.mark.parametrize("ptp_mode", list(Synchronisation))
@pytest.mark.parametrize("name", WRISTS)
def test_ends_are_chosen_at_once_as_one_by_one(name: str, ptp_mode: Synchronisation) -> None:
    chain, random = chain_for(name, ptp_mode), np.random.default_rng(9)
    assert sum(assert_as_one_by_one(chain, *walk(chain, random)[::-1]) for _ in range(12)) > 20


@pytest.mark.parametrize("name", WRISTS)
def test_near_to_singular_places_they_are_too(name: str) -> None:
    chain, random = chain_for(name), np.random.default_rng(2)
    assert sum(assert_as_one_by_one(chain, *hops(chain, random)[::-1]) for _ in range(12)) > 20


def test_targets_in_a_task_frame_with_a_tool_are_too() -> None:
    X_MT, X_BK = CHAIN.tool_pose(FRAMED), CHAIN.work.frame_pose(FRAMED, START)
    random = np.random.default_rng(4)
    places = [START + random.normal(scale=0.2, size=6) for _ in range(4)]
    moves = [ptp(X_BK.inverse() @ forward(CHAIN.robot, q) @ X_MT, FRAMED) for q in places]
    assert assert_as_one_by_one(CHAIN, moves, START) >= 4


@pytest.mark.parametrize("name", OTHERS)
def test_arms_without_exact_spherical_wrist_are_planned_one_by_one(name: str) -> None:
    assert ptp_legs_of(chain_for(name)) is None


def beyond() -> list[MoveInstruction]:
    X_BM = forward(CHAIN.robot, START + 0.05)
    spot = X_BM.position
    changed = forward(CHAIN.robot, np.array([0.2, 1.1, -2.9, -0.4, 0.9, 0.3]))
    words = posture(CHAIN.robot, START).words
    return [
        ptp(X_BM),  # where the run has come to: there is no way
        ptp(replace(X_BM, position=spot + np.array([3.0, 0.0, 0.0]))),  # out of reach
        ptp(replace(X_BM, position=spot + np.array([3e3, 0.0, 0.0]))),  # of a mistaken unit
        replace(ptp(changed), posture=PostureRequest(words)),
        ptp(tuple(START)),
        ptp(None),
        lin(Pose(spot + 0.01, X_BM.orientation)),
        ptp(X_BM, ModalState(ptp_speed=2.0)),
    ]


@pytest.mark.parametrize("number", range(8))
def test_what_cannot_be_chosen_ends_the_run_and_is_made_or_refused_as_by_itself(number: int) -> None:
    moves = [ptp(forward(CHAIN.robot, START + step)) for step in (0.02, 0.05)]
    moves.append(beyond()[number])
    joints = ptp_legs_of(CHAIN)
    assert joints is not None
    led = joints.legs(moves, 0, START)
    legs, refusal = legs_in_order(CHAIN, moves, START)
    assert len(led) == 2
    assert joints.legs(moves, 2, led[-1].q_end) == []
    alone = leg_of(CHAIN, moves[2], led[-1].q_end)
    if isinstance(alone, Refusal):
        assert refusal is not None
        assert refusal.diagnostics == alone.diagnostics
    else:
        assert refusal is None
        assert legs[2].q_end == pytest.approx(alone.q_end, abs=1e-9)
        assert legs[2].findings == alone.findings


def test_a_change_of_posture_is_left_to_the_planner_that_tells_of_it() -> None:
    """Where the posture of the start lies beyond the limits at the target."""
    random, seen = np.random.default_rng(1), 0
    for name in WRISTS:
        chain = chain_for(name)
        joints = ptp_legs_of(chain)
        assert joints is not None
        for _ in range(40):
            q, moves = walk(chain, random)
            alone = leg_of(chain, moves[0], q)
            if isinstance(alone, Leg) and alone.findings:
                seen += 1
                assert joints.legs(moves, 0, q) == []
    assert seen
