"""Corners between lines, made at once: they are those that are made one by one."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import MotionChain, StandardInterpolator
from ropsim.controller.corners import Rounding, Stop, corner_between
from ropsim.controller.leg import Leg, leg_of
from ropsim.controller.line_corners import line_corners_of
from ropsim.controller.stages import lesser_limits, tool_stages
from ropsim.flow import ModalState, MoveInstruction
from ropsim.kinematics import forward
from ropsim.motion import Curve, Traced
from ropsim.robots import default_controller
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import CHAIN, START, interface_pose, lin, ptp, shifted

HERE = interface_pose(START)
ZONE = ModalState(zone=0.02)


class OneByOne(StandardInterpolator):
    """Samples as the standard one does, but is none: each entity is asked by itself."""


def legs_through(chain: MotionChain, moves: list[MoveInstruction], q_start: Array) -> list[Leg]:
    """Return the moves that can be made one after the other."""
    found: list[Leg] = []
    for move in moves:
        leg = leg_of(chain, move, found[-1].q_end if found else q_start)
        if not isinstance(leg, Leg):
            break
        found.append(leg)
    return found


def wandering(chain: MotionChain, random: np.random.Generator) -> list[Leg]:
    """Return lines between poses that are near to each other, with zones of all sizes."""
    robot = chain.robot
    span = robot.upper_limits - robot.lower_limits
    q = robot.lower_limits + random.uniform(0.3, 0.7, robot.n) * span
    near = [forward(robot, q + random.normal(scale=0.15, size=robot.n)) for _ in range(6)]
    moves = [lin(X, replace(ZONE, zone=10.0 ** random.uniform(-4.0, -0.5))) for X in near]
    return legs_through(chain, moves, np.asarray(q))


@pytest.mark.parametrize("name", ["puma560", "irb4600_60_205", "kr210_r2700_2"])
def test_corners_between_lines_are_those_that_are_made_one_by_one(name: str) -> None:
    chain = chain_of(one_station("c", robots.load(name), default_controller(name)))
    random, count, densities = np.random.default_rng(11), 0, set()
    for _ in range(25):
        legs = wandering(chain, random)
        for number, quick in line_corners_of(chain, legs).items():
            before, behind = legs[number], legs[number + 1]
            slow = corner_between(chain, before, behind)
            assert isinstance(slow, Rounding)
            assert isinstance(slow.tool, Curve)
            assert isinstance(quick.joints, Traced)
            assert isinstance(slow.joints, Traced)
            assert (quick.zone, quick.leave, quick.enter) == (slow.zone, slow.leave, slow.enter)
            assert (quick.tool, quick.joints) == (slow.tool, slow.joints)
            limits = lesser_limits(before.planned.limits.tool, behind.planned.limits.tool)
            stages = tool_stages(slow.tool, limits)
            assert quick.stages is None or np.array_equal(quick.stages.rows, stages.rows)
            densities.add(len(quick.joints.q))
            count += quick.stages is not None
    assert count > 20
    assert {17, 33, 65} >= densities > {65}


def test_what_is_not_plain_is_left_to_be_asked_by_itself() -> None:
    there = shifted(HERE, -0.1, 0.1, 0.0)
    back = shifted(HERE, -0.05, 0.05, 0.0)
    turned = there @ Pose(np.zeros(3), np.array([0.9, 0.0, 0.0, 0.3]))
    for one, other in (
        (lin(there, ZONE), ptp(back)),
        (ptp(there, ZONE), lin(back)),
        (lin(there, ZONE), lin(back)),  # it turns back
        (lin(there, replace(ZONE, zone=1e-7)), lin(HERE)),
        (lin(there, ZONE), lin(turned)),  # the TCP stands
    ):
        assert line_corners_of(CHAIN, legs_through(CHAIN, [one, other], START)) == {}


def test_others_than_standard_entities_are_asked_by_themselves() -> None:
    moves = [lin(shifted(HERE, -0.1, 0.1, 0.0), ZONE), lin(shifted(HERE, -0.1, 0.1, 0.06))]
    legs = legs_through(CHAIN, moves, START)
    assert list(line_corners_of(CHAIN, legs)) == [0]
    assert line_corners_of(CHAIN, legs[:1]) == {}
    assert line_corners_of(replace(CHAIN, interpolator=OneByOne()), legs) == {}
    blind = replace(CHAIN, controller=replace(CHAIN.controller, look_ahead=0))
    assert line_corners_of(blind, legs) == {}
    assert corner_between(blind, *legs) is Stop.NO_LOOK_AHEAD


def test_only_corners_between_neighbours_that_are_lines_are_made() -> None:
    points = [shifted(HERE, *by) for by in ((0.0, 0.1, 0.0), (0.0, 0.1, 0.08), (0.06, 0.1, 0.08))]
    ends = [shifted(HERE, *by) for by in ((0.06, 0.0, 0.08), (0.06, 0.0, 0.0))]
    moves = [lin(points[0], ZONE), lin(points[1], ZONE), ptp(points[2], ZONE)]
    legs = legs_through(CHAIN, [*moves, *(lin(end, ZONE) for end in ends)], START)
    assert len(legs) == 5
    found = line_corners_of(CHAIN, legs)
    assert list(found) == [0, 3]
    for number, quick in found.items():
        slow = corner_between(CHAIN, legs[number], legs[number + 1])
        assert isinstance(slow, Rounding)
        assert (quick.tool, quick.joints) == (slow.tool, slow.joints)


def test_nobody_can_change_the_arrays_of_a_corner() -> None:
    moves = [lin(shifted(HERE, -0.1, 0.1, 0.0), ZONE), lin(shifted(HERE, -0.1, 0.1, 0.06))]
    found = line_corners_of(CHAIN, legs_through(CHAIN, moves, START))[0]
    assert isinstance(found.tool, Curve)
    assert isinstance(found.joints, Traced)
    assert found.stages is not None
    for array in (found.tool.coefficients, found.tool.middles, found.tool.way.ends, found.tool.way.inverse):
        assert not array.flags.writeable
    for array in (found.joints.q, found.joints.derivatives, found.stages.rows):
        assert not array.flags.writeable
