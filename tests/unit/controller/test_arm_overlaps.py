"""Overlaps of moves, found at once: they are those that are found one by one."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller.arm_overlaps import arm_overlaps_of
from ropsim.controller.corners import Overlap, corner_between
from ropsim.controller.leg import Leg, leg_of
from ropsim.flow import ModalState
from ropsim.kinematics import forward
from ropsim.model import Synchronisation
from ropsim.motion import Traced
from ropsim.robots import default_controller
from support.cells import chain_of, one_station
from support.motion import CHAIN, START, interface_pose, lin, ptp, shifted

ZONE = ModalState(zone=0.02)


@pytest.mark.parametrize("synchronised", list(Synchronisation))
@pytest.mark.parametrize("name", ["puma560", "stanford", "panda", "cobra600", "kr210_r2700_2"])
def test_overlaps_are_those_that_are_found_one_by_one(name: str, synchronised: Synchronisation) -> None:
    controller = replace(default_controller(name), ptp=synchronised)
    chain = chain_of(one_station("c", robots.load(name), controller))
    robot, random, count, kinds = chain.robot, np.random.default_rng(4), 0, set()
    span = robot.upper_limits - robot.lower_limits
    for _ in range(10):
        q = q_start = np.asarray(robot.lower_limits + random.uniform(0.3, 0.7, robot.n) * span)
        legs: list[Leg] = []
        for _ in range(12):  # so that there are more of them than are searched for side by side
            q = q_start + random.normal(scale=0.15, size=robot.n)
            modal = replace(ZONE, zone=10.0 ** random.uniform(-7.0, -0.5))
            move = lin(forward(robot, q), modal) if random.integers(2) else ptp(tuple(q.tolist()), modal)
            leg = leg_of(chain, move, legs[-1].q_end if legs else q_start)
            if isinstance(leg, Leg):
                legs.append(leg)
        for number, quick in arm_overlaps_of(chain, legs).items():
            before, behind = legs[number], legs[number + 1]
            slow = corner_between(chain, before, behind)
            assert isinstance(slow, Overlap)
            assert quick == slow
            kinds.add((type(before.joints) is Traced, type(behind.joints) is Traced))
            count += 1
    assert count > 10
    assert (False, False) in kinds


def test_others_are_left_to_be_asked_by_themselves() -> None:
    here = interface_pose(START)
    there, then = shifted(here, -0.1, 0.1, 0.0), shifted(here, -0.1, 0.1, 0.06)
    for one, other, found in (
        (ptp(there, ZONE), lin(then), [0]),
        (lin(there, ZONE), lin(then), []),  # a path of the tool leads round it
        (ptp(there, replace(ZONE, zone=1e-7)), lin(then), []),  # it is none
    ):
        before = leg_of(CHAIN, one, START)
        assert isinstance(before, Leg)
        behind = leg_of(CHAIN, other, before.q_end)
        assert isinstance(behind, Leg)
        assert list(arm_overlaps_of(CHAIN, [before, behind])) == found
        blind = replace(CHAIN, controller=replace(CHAIN.controller, look_ahead=0))
        assert arm_overlaps_of(blind, [before, behind]) == {}
