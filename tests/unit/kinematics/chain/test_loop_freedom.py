"""Closed chains leave the axes free, and nothing else: sound linkages, and each way of being wrong."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import loop_freedom
from ropsim.model import BASE_LINK, Direction, Joint, JointType, Link, LoopCut, RobotModel
from support.linkages import COUPLER, CRANK, FOUR_BAR, GROUND, IN_PLANE, ROCKER, ROD, SLIDER_CRANK, at

PIN = (Direction.X, Direction.Y, Direction.Z, Direction.ABOUT_X, Direction.ABOUT_Y)


def codes(robot: RobotModel) -> list[str]:
    return [one.code for one in loop_freedom(robot)]


@pytest.mark.parametrize("robot", [SLIDER_CRANK, FOUR_BAR], ids=["slider-crank", "four-bar"])
def test_a_planar_linkage_has_the_freedom_of_its_axis(robot: RobotModel) -> None:
    assert codes(robot) == []


def test_a_pin_of_a_planar_linkage_may_hold_what_the_plane_holds() -> None:
    """Grübler's count of freedoms in space would be -2 here: the linkage is overdetermined, and moves."""
    cut = LoopCut(1, at(COUPLER), 2, at(ROCKER), PIN)
    assert codes(replace(FOUR_BAR, cuts=(cut,))) == []


def test_open_chains_are_not_looked_at() -> None:
    assert codes(robots.load("puma560")) == []
    assert codes(robots.load("palletizer")) == []  # couplings, no cuts


def test_a_rod_that_is_too_short_cannot_be_closed() -> None:
    short = replace(FOUR_BAR, cuts=(LoopCut(1, at(0.05), 2, at(ROCKER), IN_PLANE),))
    (finding,) = loop_freedom(short)
    assert finding.code == "M553"
    least = GROUND - CRANK - 0.05 - ROCKER  # stretched towards the rocker, which points at it
    assert f"stay {max(least, 0.05):.1}" in finding.message


def test_a_weld_where_a_pin_should_be_holds_the_axis() -> None:
    cut = LoopCut(1, at(COUPLER), 2, at(ROCKER), (*IN_PLANE, Direction.ABOUT_Z))
    welded = replace(FOUR_BAR, cuts=(cut,))
    assert set(codes(welded)) <= {"M553", "M554"}
    assert codes(welded)


def test_a_slider_that_is_held_along_its_way_holds_the_crank() -> None:
    fixed = replace(SLIDER_CRANK, joints=SLIDER_CRANK.joints[:2], links=SLIDER_CRANK.links[:2])
    to_ground = LoopCut(1, at(ROD), BASE_LINK, at(CRANK + ROD), IN_PLANE)
    (finding,) = loop_freedom(replace(fixed, tip=1, cuts=(to_ground,)))
    assert (finding.code, "axis `crank`" in finding.message) == ("M554", True)


def test_a_joint_beside_the_loop_that_nothing_moves_is_loose() -> None:
    flap = Joint("flap", JointType.REVOLUTE, at(0.1), 0.0, -4.0, 4.0, 1.0, 1.0, 1.0, parent=2)
    more = (*FOUR_BAR.links, Link(1.0, np.zeros(3), np.eye(3)))
    (finding,) = loop_freedom(replace(FOUR_BAR, joints=(*FOUR_BAR.joints, flap), links=more))
    assert (finding.code, "1 coordinate free" in finding.message) == ("M555", True)


def test_a_cut_that_holds_one_direction_too_few_leaves_one_free() -> None:
    slot = LoopCut(1, at(COUPLER), 2, at(ROCKER), (Direction.Y,))
    assert codes(replace(FOUR_BAR, cuts=(slot,))) == ["M555"]


def test_a_parallelogram_that_lies_flat_at_home_is_no_loose_joint() -> None:
    """All four bars in line: the rank drops at home, and is there beside it."""
    crank, coupler, rocker = FOUR_BAR.joints
    flat = (crank, coupler, replace(rocker, placement=at(COUPLER)))
    cut = LoopCut(1, at(COUPLER), 2, at(CRANK), IN_PLANE)
    assert codes(replace(FOUR_BAR, joints=flat, cuts=(cut,))) == []
