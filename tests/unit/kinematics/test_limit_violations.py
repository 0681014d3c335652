import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import IkOptions, Limits, forward, inverse, limit_violations, turned_to_limits

SAME = 1e-9
"""Rounding of whole turns and of forward kinematics [rad, m]."""


@pytest.mark.parametrize("seed", range(20))
def test_a_branch_is_a_solution_or_exceeds_a_limit_never_both(seed: int) -> None:
    arm = robots.load("puma560")
    q = np.random.default_rng(seed).uniform(arm.lower_limits, arm.upper_limits)
    pose = forward(arm, q)
    inside = {str(one) for one in inverse(arm, pose).postures}
    free = inverse(arm, pose, IkOptions(limits=Limits.IGNORE))
    for branch, posture in zip(free.solutions, free.postures, strict=True):
        assert (str(posture) in inside) == (not limit_violations(arm, branch))


@pytest.mark.parametrize("seed", range(20))
def test_whole_turns_do_not_change_the_pose_and_end_nearest_to_the_middle(seed: int) -> None:
    arm = robots.load("puma560")
    q = np.random.default_rng(seed).uniform(-10.0, 10.0, 6)
    turned = turned_to_limits(arm, q)
    before, after = forward(arm, q).matrix(), forward(arm, turned).matrix()
    assert np.allclose(before, after, rtol=0.0, atol=SAME)
    assert np.all(np.abs(turned - (arm.lower_limits + arm.upper_limits) / 2.0) <= np.pi + SAME)


def test_a_violation_names_joint_limit_and_excess_worst_first() -> None:
    arm = robots.load("puma560")
    q = np.zeros(6)
    q[1] = arm.lower_limits[1] - 0.1
    q[4] = arm.upper_limits[4] + 0.3
    worst, other = limit_violations(arm, q)
    assert (worst.name, other.name) == ("5", "2")
    assert worst.limit == arm.upper_limits[4]
    assert worst.excess == pytest.approx(0.3, abs=SAME)
    assert other.excess == pytest.approx(0.1, abs=SAME)
