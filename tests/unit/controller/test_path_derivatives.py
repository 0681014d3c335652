"""Paths of the joints of one's own that tell other derivatives than they have."""

from dataclasses import dataclass, replace

import pytest

from ropsim.controller import MotionPlan, Refusal, StandardJointInterpolator, plan_move
from ropsim.flow import JointSamples
from ropsim.motion import JointPath, JointPoints
from ropsim.spatial import Array
from support.motion import CHAIN, START, interface_pose, lin, shifted

LINE = lin(shifted(interface_pose(START), -0.1, 0.1, 0.0))


@dataclass(frozen=True)
class Told:
    """The standard path of the joints, of which somebody says that it has other derivatives."""

    path: JointPath
    first: float = 1.0
    second: float = 0.0

    @property
    def length(self) -> float:
        return self.path.length

    def joints(self, s: Array) -> JointPoints:
        points = self.path.joints(s)
        return JointPoints(points.q, points.d1 * self.first, points.d2 + self.second)


@dataclass(frozen=True)
class Telling:
    """An interpolator of the joints of somebody else's."""

    first: float = 1.0
    second: float = 0.0

    def refine(self, samples: JointSamples) -> Told:
        return Told(StandardJointInterpolator().refine(samples), self.first, self.second)


def test_a_path_that_is_what_it_says_is_flown() -> None:
    assert isinstance(plan_move(replace(CHAIN, joint_interpolator=Telling()), LINE, START), MotionPlan)


@pytest.mark.parametrize(
    ("telling", "told"),
    [
        (Telling(first=0.5), "returned `d1` that is not the derivative at place"),
        (Telling(first=1.05), "returned `d1` that is not the derivative at place"),
        (Telling(first=float("inf")), "numbers that are not finite"),
        (Telling(second=1.0), "returned `d2` that is not the derivative at place"),
    ],
)
def test_a_path_that_tells_other_derivatives_than_it_has_is_refused(telling: Telling, told: str) -> None:
    found = plan_move(replace(CHAIN, joint_interpolator=telling), LINE, START)
    assert isinstance(found, Refusal)
    assert found.diagnostics[0].code == "C603"
    assert told in found.diagnostics[0].message
    assert "Tell" in found.diagnostics[0].message
