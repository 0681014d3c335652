"""Mechanisms that cannot be: each contradiction is a finding, wherever the mechanism is used first."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import dynamics, kinematics, robots
from ropsim.core import RopsimError
from ropsim.model import (
    BASE_LINK,
    Coupling,
    Direction,
    JointSpring,
    JointType,
    LoopCut,
    Mechanism,
    RobotModel,
    Spring,
    audit,
)
from ropsim.robots import default_controller
from ropsim.spatial import Pose, frozen
from support.arms import random_arm
from support.trees import random_tree

ARM = random_arm(1, "RRRR")
PIN = Pose(np.array([0.1, 0.0, 0.0]))
CUT = LoopCut(3, PIN, BASE_LINK, Pose(), (Direction.X, Direction.Y))


def with_joint(number: int, **changes: Any) -> RobotModel:
    joints = list(ARM.joints)
    joints[number] = replace(joints[number], **changes)
    return replace(ARM, joints=tuple(joints))


def coupled(*couplings: Coupling, axes: tuple[int, ...] = (0, 1)) -> RobotModel:
    return replace(ARM, couplings=couplings, axes=axes, home=np.zeros(len(axes)))


FOLLOWS_FIRST = Coupling(2, ((0, 1.0),))
FOLLOWS_SECOND = Coupling(3, ((1, -1.0),))
WRONG = {
    "two names": (with_joint(2, name="2"), "X830", "2 joints called `2`"),
    "absent parent": (with_joint(2, parent=9), "X831", "carried by link 10, which does not exist"),
    "parent below the base": (with_joint(2, parent=-3), "X831", "which does not exist"),
    "own parent": (with_joint(2, parent=2), "X831", "carried by link 3, which hangs on it"),
    "circle of parents": (
        with_joint(1, parent=3),
        "X831",
        "joint `2` is carried by link 4, which hangs on it",
    ),
    "parent that comes later": (
        replace(
            with_joint(1, parent=3),
            joints=(*with_joint(1, parent=3).joints[:3], with_joint(3, parent=0).joints[3]),
        ),
        "X831",
        "which comes after it",
    ),
    "absent tip": (replace(ARM, tip=7), "X831", "the interface of `random_RRRR` is on link 8"),
    "no axes": (with_joint(0, type=JointType.FIXED), "X833", "which has 0 freedoms"),
    "absent axis": (replace(ARM, axes=(0, 1, 2, 4)), "X833", "axis 4 of `random_RRRR` is joint 5"),
    "axis twice": (replace(ARM, axes=(0, 1, 2, 2)), "X833", "a second time"),
    "axis that follows": (replace(ARM, couplings=(FOLLOWS_FIRST,)), "X833", "follows others by a coupling"),
    "axis with two freedoms": (with_joint(1, type=JointType.UNIVERSAL), "X833", "which has 2 freedoms"),
    "absent coordinate": (coupled(FOLLOWS_FIRST, Coupling(3, ((9, 1.0),))), "X834", "names coordinate 9"),
    "coupled twice": (coupled(FOLLOWS_FIRST, FOLLOWS_FIRST, FOLLOWS_SECOND), "X834", "a second time"),
    "no number": (coupled(FOLLOWS_FIRST, Coupling(3, ((1, np.nan),))), "X834", "not finite"),
    "coupled to itself": (coupled(FOLLOWS_FIRST, Coupling(3, ((3, 0.5),))), "X835", "joint `4` → joint `4`"),
    "circle of couplings": (
        coupled(Coupling(2, ((3, 1.0),)), Coupling(3, ((0, 1.0), (2, 1.0)))),
        "X835",
        "joint `3` → joint `4` → joint `3`",
    ),
    "free coordinate": (coupled(FOLLOWS_FIRST), "X836", "joint `4` of `random_RRRR` is no axis"),
    "cut of nothing": (replace(ARM, cuts=(replace(CUT, first=8),)), "X837", "links 9 and 0"),
    "cut of one link": (replace(ARM, cuts=(replace(CUT, second=3),)), "X837", "links 4 and 4"),
    "loop of axes": (replace(ARM, cuts=(CUT,)), "X838", "whose coordinates are axes or coupled"),
    "loop cut twice": (
        replace(ARM, axes=(0,), home=np.zeros(1), cuts=(CUT, LoopCut(BASE_LINK, Pose(), 3, PIN))),
        "X838",
        "an earlier one holds",
    ),
    "absent external axis": (replace(ARM, external=(4,)), "X828", "[4] of 4 axes"),
    "spring of nothing": (
        replace(ARM, springs=(Spring("balance", BASE_LINK, np.zeros(3), 4, np.zeros(3), 1e3),)),
        "X977",
        "between links 0 and 5",
    ),
    "spring of one link": (
        replace(ARM, springs=(Spring("balance", 1, np.zeros(3), 1, np.ones(3), 1e3),)),
        "X977",
        "between links 2 and 2",
    ),
    "spring on no coordinate": (
        replace(ARM, joint_springs=(JointSpring("return", 4, 10.0),)),
        "X977",
        "on coordinate 4",
    ),
    "external axis twice": (replace(ARM, external=(3, 3)), "X828", "[3, 3] of 4 axes"),
}


@pytest.mark.parametrize(("robot", "code", "told"), WRONG.values(), ids=WRONG)
def test_each_contradiction_is_a_finding_of_the_audit(robot: RobotModel, code: str, told: str) -> None:
    found = [finding for finding in audit(robot) if finding.is_error]
    assert [finding.code for finding in found] == [code]
    assert told in found[0].message
    assert found[0].hint


@pytest.mark.parametrize(("robot", "code", "_told"), WRONG.values(), ids=WRONG)
def test_kinematics_and_dynamics_refuse_it_with_the_same_finding(
    robot: RobotModel, code: str, _told: str
) -> None:
    q = np.zeros(robot.n)
    for use in (
        lambda: kinematics.forward(robot, q),
        lambda: kinematics.jacobian(robot, q),
        lambda: kinematics.inverse(robot, Pose()),
        lambda: dynamics.gravity(robot, q),
        lambda: dynamics.mass_matrices(robot, q[np.newaxis]),
    ):
        with pytest.raises(RopsimError) as caught:
            use()
        assert caught.value.diagnostic.code == code


def test_a_mechanism_without_joints_has_no_axes() -> None:
    bare = Mechanism("bare", "bare", (), (), (), np.zeros(0))
    assert [finding.code for finding in audit(bare)] == ["X832"]


@pytest.mark.parametrize(
    "change", [{"links": ()}, {"drives": robots.load("puma560").drives[:2]}], ids=["links", "drives"]
)
def test_missing_links_and_drives_are_findings_everywhere(change: dict[str, Any]) -> None:
    puma = replace(robots.load("puma560"), **change)
    assert [finding.code for finding in audit(puma) if finding.is_error] == ["X858"]
    for use in (
        lambda: dynamics.gravity(puma, puma.home),
        lambda: dynamics.mass_matrices(puma, puma.home[np.newaxis]),
        lambda: default_controller(puma),
    ):
        with pytest.raises(RopsimError) as caught:
            use()
        assert caught.value.diagnostic.code in {"X858", "M573"}


def test_a_closed_chain_is_described_placed_and_held() -> None:
    """A linkage with one axis and three passive joints, of which the cut leaves one free."""
    loop = replace(ARM, axes=(0,), home=frozen([0.0]), cuts=(CUT,))
    assert not [finding for finding in audit(loop) if finding.is_error]
    assert kinematics.joint_frames(loop, [0.3]).shape == (5, 4, 4)
    assert np.isfinite(dynamics.gravity(loop, [0.3])).all()


def test_random_trees_are_sound() -> None:
    for seed in range(20):
        assert not [finding for finding in audit(random_tree(seed, 8).robot) if finding.is_error]


def test_a_robot_of_external_axes_alone_moves_and_has_no_inverse_kinematics() -> None:
    alone = replace(ARM, external=(0, 1, 2, 3))
    assert [one for one in audit(alone) if one.is_error] == []
    q = np.full(4, 0.2)
    np.testing.assert_array_equal(kinematics.forward(alone, q).matrix(), kinematics.forward(ARM, q).matrix())
    with pytest.raises(RopsimError) as caught:
        kinematics.inverse(alone, Pose())
    assert caught.value.diagnostic.code == "X828"
