"""What keeps moves below their programmed speed, and how much time that costs, for each cause."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import (
    LimitQuantity,
    ModalState,
    MotionKind,
    MoveInstruction,
    Origin,
    ReachedSpeed,
    SpeedCause,
)
from ropsim.kinematics import forward
from ropsim.model import LookAhead, OrientationMode
from ropsim.planning import MotionChain, MotionPlan, MotionState, plan
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import LINE, PASS

ROBOT = robots.load("irb120")
CONTROLLER = robots.default_controller("irb120")
Q = np.array([0.0, 0.2, 0.1, 0.0, 1.2, 0.0])
HERE = forward(ROBOT, Q)
"""Far from limits and singularities, with room on all sides."""
PATH = replace(
    CONTROLLER.path,
    acceleration=4.0,
    jerk=40.0,
    orientation_speed=3.0,
    orientation_acceleration=20.0,
    orientation_jerk=200.0,
)
"""Joints that are quick enough bind nowhere, so that limits of the path decide."""
QUICK = replace(
    ROBOT,
    joints=tuple(replace(one, max_speed=100.0, max_acceleration=1e4, max_jerk=1e6) for one in ROBOT.joints),
    drives=(),
)


def chain(robot: object = QUICK, **changes: object) -> MotionChain:
    controller = replace(CONTROLLER, path=PATH, **changes)  # type: ignore[arg-type]
    return chain_of(one_station("c", robot, controller, start=Q))  # type: ignore[arg-type]


def lin(x: float, y: float, speed: float, *, zone: float = 0.0, turned: float = 0.0) -> MoveInstruction:
    """Return a line to a point beside the start [m], with the tool turned about its axis there [rad]."""
    turn = Pose(np.zeros(3), np.array([math.cos(turned / 2.0), 0.0, 0.0, math.sin(turned / 2.0)]))
    target = Pose(HERE.position + np.array([x, y, 0.0]), (HERE @ turn).orientation)
    modal = ModalState(path_speed=speed, zone=zone)
    return MoveInstruction(MotionKind.LIN, target, modal, Origin(LINE, PASS))


def planned(moves: list[MoveInstruction], by: MotionChain | None = None, q: Array = Q) -> MotionPlan:
    found, refusal = plan(by or chain(), moves, MotionState.at_rest(q))
    assert refusal is None, refusal
    assert found is not None
    return found


def reached(moves: list[MoveInstruction], by: MotionChain | None = None) -> list[ReachedSpeed | None]:
    return [one.reached for one in planned(moves, by).moves]


def times(plan_: MotionPlan) -> list[float]:
    ends = [0, *(one.last for one in plan_.moves)]
    return [plan_.period * (last - first) for first, last in pairwise(ends)]


@pytest.mark.parametrize("length", [0.005, 0.02, 0.1])
@pytest.mark.parametrize("speed", [0.05, 0.4, 2.0])
def test_a_line_from_stop_to_stop_is_not_slow_for_the_ramps_that_it_needs(
    length: float, speed: float
) -> None:
    assert reached([lin(0.0, length, speed)]) == [None]


def test_ramps_that_go_on_through_collinear_moves_are_no_loss() -> None:
    ways = [lin(0.0, 0.02 * k, 1.0, zone=0.009 if k < 9 else 0.0) for k in range(1, 10)]
    assert reached(ways) == [None] * 9


def zigzag(step: float, zone: float, speed: float, count: int) -> list[MoveInstruction]:
    ways = [lin(0.004 * (k % 2), step * k, speed, zone=zone) for k in range(1, count)]
    return [*ways, lin(0.004 * (count % 2), step * count, speed)]


def test_moves_too_short_between_their_corners_name_acceleration_or_jerk_of_the_path() -> None:
    found = reached(zigzag(0.03, 0.002, 1.0, 8))
    inner = [one for one in found[1:-1] if one]
    assert len(inner) == 6
    assert {one.cause for one in inner} <= {SpeedCause.ACCELERATION, SpeedCause.JERK, SpeedCause.ZONE}
    assert {one.cause for one in inner} & {SpeedCause.ACCELERATION, SpeedCause.JERK}
    for one in inner:
        assert one.top < 0.9
        assert one.length == pytest.approx(0.0303, rel=0.1)
        assert one.value == {SpeedCause.ACCELERATION: 4.0, SpeedCause.JERK: 40.0}.get(one.cause, one.value)


def test_time_lost_is_that_beyond_the_programmed_speed() -> None:
    """Between two corners the tool would go with the programmed speed all the way."""
    plan_ = planned(zigzag(0.015, 0.005, 0.3, 8))
    for one, time in list(zip(plan_.moves, times(plan_), strict=True))[2:-2]:
        assert one.reached is not None
        assert one.reached.lost == pytest.approx(time - one.reached.length / 0.3, abs=2e-3)


def test_a_sharp_corner_of_long_moves_names_its_zone_and_its_angle() -> None:
    found = reached([lin(0.0, 0.1, 0.4, zone=0.01), lin(-0.08, 0.15, 0.4)])
    for one in found:  # the corner is at the end of one, and where the other begins
        assert one is not None
        assert one.cause is SpeedCause.ZONE
        assert one.value == pytest.approx(0.01, rel=1e-6)
        assert one.corner == pytest.approx(math.atan2(0.08, 0.05), abs=1e-6)
        assert one.top == pytest.approx(0.4, rel=1e-3)


def test_a_tool_that_turns_far_on_a_short_way_names_the_speed_of_rotation() -> None:
    (one,) = reached([lin(0.0, 0.05, 0.4, turned=1.5)])
    assert one is not None
    assert (one.cause, one.value) == (SpeedCause.TURN_SPEED, 3.0)
    assert one.turn == pytest.approx(1.5, rel=1e-6)
    assert one.top == pytest.approx(3.0 * 0.05 / 1.5, rel=0.02)


def test_a_short_turn_that_never_comes_to_its_speed_names_its_acceleration() -> None:
    (one,) = reached([lin(0.0, 0.005, 0.4, turned=0.3)])
    assert one is not None
    assert (one.cause, one.value) == (SpeedCause.TURN_ACCELERATION, 20.0)


def test_an_arc_that_is_tight_for_its_speed_names_its_radius() -> None:
    via, target = (
        Pose(HERE.position + np.array(by), HERE.orientation) for by in ((0.05, 0.05, 0.0), (0.0, 0.1, 0.0))
    )
    arc = MoveInstruction(MotionKind.CIRC, target, ModalState(path_speed=1.0), Origin(LINE, PASS), via=(via,))
    (one,) = reached([arc])
    assert one is not None
    assert one.cause is SpeedCause.BEND
    assert one.value == pytest.approx(0.05, rel=1e-6)
    assert one.top <= math.sqrt(4.0 * 0.05)
    assert one.length == pytest.approx(math.pi * 0.05, rel=1e-6)


def test_a_controller_that_does_not_look_far_ahead_is_named() -> None:
    ways = [lin(0.0, 0.02 * k, 1.0, zone=0.009 if k < 9 else 0.0) for k in range(1, 10)]
    found = reached(ways, chain(look_ahead=LookAhead(1, 0.0)))
    causes = [one.cause for one in found if one]
    assert causes.count(SpeedCause.LOOK_AHEAD) >= 5
    assert set(causes) == {SpeedCause.LOOK_AHEAD}


def test_a_joint_that_is_slow_is_named_with_its_quantity() -> None:
    slow = replace(QUICK, joints=(replace(QUICK.joints[0], max_speed=0.2), *QUICK.joints[1:]))
    (one,) = reached([lin(0.0, 0.2, 0.5)], chain(slow))
    assert one is not None
    assert (one.cause, one.joint) == (SpeedCause.JOINT, ROBOT.axis_joints[0].name)
    assert one.quantity is LimitQuantity.SPEED
    assert one.singularity == ""
    reach = float(np.linalg.norm(HERE.position[:2]))
    assert one.top < 0.2 * 1.5 * reach


def across_wrist(mode: OrientationMode) -> MotionPlan:
    """Return a line on which the tool tilts through the pose with axes 4 and 6 nearly in line."""
    begin, end = np.array([0.05, 0.3, 0.1, -1.5, 0.5, 0.0]), np.array([-0.05, 0.3, 0.1, -1.5, -0.5, 0.0])
    target = MoveInstruction(
        MotionKind.LIN, forward(ROBOT, end), ModalState(path_speed=0.3), Origin(LINE, PASS)
    )
    near = begin.copy()
    near[3] += 0.25
    controller = replace(CONTROLLER, path=PATH, orientation=mode)
    by = chain_of(one_station("c", replace(ROBOT, drives=()), controller, start=near))
    return planned([target], by, near)


def test_the_wrist_near_its_singularity_is_named_and_wrist_angles_pass_it() -> None:
    found = across_wrist(OrientationMode.FIXED_AXIS)
    (slow,) = (one for one in found.findings if one.code == "M563")
    assert "near the singularity of the wrist" in slow.message
    assert slow.hint is not None
    assert 'orientation = "wrist angles"' in slow.hint
    (one,) = (move.reached for move in found.moves)
    assert one is not None
    assert (one.cause, one.singularity) == (SpeedCause.JOINT, "wrist")
    other = across_wrist(OrientationMode.WRIST_ANGLES)
    assert [move.code for move in other.findings if move.code == "M563"] == []
    assert other.duration < 0.7 * found.duration


def sine(step: float, count: int) -> list[MoveInstruction]:
    """Return short lines along a sine of 5 mm, 40 mm long, with zones."""
    ways = [(0.005 * math.sin(2.0 * math.pi * step * k / 0.04), step * k) for k in range(1, count + 1)]
    return [lin(x, y, 0.2, zone=0.001 if k < count else 0.0) for k, (x, y) in enumerate(ways, 1)]


LIMITED = [
    ({"acceleration": 2.0, "jerk": 2.0}, (LimitQuantity.JERK,)),
    ({"acceleration": 0.2, "jerk": 400.0}, (LimitQuantity.ACCELERATION,)),
]


@pytest.mark.parametrize(("limits", "helps"), LIMITED)
@pytest.mark.parametrize("ways", [sine(0.001, 80), zigzag(0.03, 0.002, 1.0, 8)], ids=["curve", "corners"])
def test_the_limit_of_the_path_that_binds_is_named_and_no_other(
    limits: dict[str, float], helps: tuple[LimitQuantity, ...], ways: list[MoveInstruction]
) -> None:
    """More of it makes the motion quicker by a tenth of what is lost, more of the other one does not."""
    by = chain_of(one_station("c", QUICK, replace(CONTROLLER, path=replace(PATH, **limits)), start=Q))
    before = planned(ways, by)
    found = [one.reached for one in before.moves if one.reached and one.reached.helps]
    assert found
    assert {one.helps for one in found} == {helps}

    def saved(name: str) -> float:
        more = replace(PATH, **{**limits, name: 2.0 * limits[name]})
        raised = chain_of(one_station("c", QUICK, replace(CONTROLLER, path=more), start=Q))
        return before.duration - planned(ways, raised).duration

    lost = sum(one.reached.lost for one in before.moves if one.reached)
    other = next(one for one in limits if one != helps[0].value)
    assert saved(helps[0].value) > 0.1 * lost
    assert saved(other) < saved(helps[0].value) / 3.0


def test_no_limit_of_the_path_is_named_where_joints_would_take_it_back() -> None:
    """Joints of little jerk bind everywhere: the tool could have more."""
    joints = tuple(replace(one, max_jerk=one.max_jerk * 0.02) for one in ROBOT.joints if one.max_jerk)
    slow = replace(ROBOT, joints=joints, drives=())
    found = reached(sine(0.001, 80), chain(slow))
    assert [one for one in found if one and one.helps] == []
