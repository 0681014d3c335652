"""Bounds along straight parts of a stretch, found at once: they are those that are found one by one."""

from dataclasses import replace

import numpy as np

from ropsim.controller.coordination import Coordination
from ropsim.controller.leg import Leg, leg_of
from ropsim.controller.plain_stages import plain_stages
from ropsim.controller.stages import joint_stages, tool_stages
from ropsim.flow import ModalState, MoveInstruction
from ropsim.kinematics import forward
from ropsim.model import OrientationMode
from ropsim.motion import Line, ToolSection
from support.motion import CHAIN, START, interface_pose, lin, ptp, shifted


def legs_of(moves: list[MoveInstruction]) -> list[Leg]:
    q, legs = START, list[Leg]()
    for move in moves:
        leg = leg_of(CHAIN, move, q)
        assert isinstance(leg, Leg)
        legs.append(leg)
        q = leg.q_end
    return legs


def moves(random: np.random.Generator) -> list[MoveInstruction]:
    found, here = [], interface_pose(START)
    for number in range(8):
        q = START + random.normal(scale=0.05, size=len(START))
        away = random.uniform(-0.1, 0.1, 3).tolist()
        there = forward(CHAIN.robot, q) if number % 3 else shifted(here, *away)
        modal = ModalState(ptp_speed=random.uniform(0.1, 1.0), path_speed=random.uniform(0.05, 0.5))
        found.append(ptp(tuple(q.tolist()), modal) if number % 2 else lin(there, modal))
    return found


def test_they_are_those_of_each_path_by_itself() -> None:
    legs = legs_of(moves(np.random.default_rng(2)))
    parts = {}
    for number, leg in enumerate(legs):
        assert leg.joints is not None
        length = leg.joints.length
        parts[number] = (0.1 * length, 0.7 * length) if leg.tool else (0.0, length)
    found = plain_stages(legs, parts)
    assert sorted(found) == list(range(len(legs)))
    for number, leg in enumerate(legs):
        assert leg.joints is not None
        if leg.tool:
            own = tool_stages(ToolSection(leg.tool, *parts[number]), leg.planned.limits.tool)
        else:
            own = joint_stages(leg.joints, leg.planned.limits.joints)
        assert found[number].rows.tolist() == own.rows.tolist()


def test_lines_along_which_external_axes_go_are_left_to_be_asked_by_themselves() -> None:
    (leg,) = legs_of([lin(shifted(interface_pose(START), 0.05, 0.0, 0.0))])
    assert leg.joints is not None
    assert leg.tool is not None
    standing = Coordination(CHAIN.robot, leg.joints, None, leg.planned.limits.joints)
    along = replace(leg, planned=replace(leg.planned, coordination=standing))
    assert sorted(plain_stages([leg, along], {0: (0.0, 0.05), 1: (0.0, 0.05)})) == [0]


def test_lines_on_which_the_tool_rolls_as_it_swings_are_left_to_be_asked_by_themselves() -> None:
    legs = legs_of([lin(forward(CHAIN.robot, START + 0.1)), lin(interface_pose(START))])
    line = legs[0].tool
    assert isinstance(line, Line)
    rolls = replace(line, mode=OrientationMode.DRIVE_TRANSFORM)
    legs[0] = replace(legs[0], planned=replace(legs[0].planned, tool=rolls))
    assert list(plain_stages(legs, {0: (0.0, rolls.length), 1: (0.0, 0.1)})) == [1]
