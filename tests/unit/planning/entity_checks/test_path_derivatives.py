"""Paths of the joints of one's own that tell other derivatives than they have."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from ropsim.flow import JointSamples
from ropsim.motion import JointPath, JointPoints
from ropsim.planning import MotionPlan, Refusal, StandardJointInterpolator, plan_move
from ropsim.planning.testing import wrong_joint_derivatives
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
        (Telling(first=0.5), "returned `d1` that is not the derivative at path parameter"),
        (Telling(first=1.05), "returned `d1` that is not the derivative at path parameter"),
        (Telling(first=float("inf")), "numbers that are not finite"),
        (Telling(second=1.0), "returned `d2` that is not the derivative at path parameter"),
    ],
)
def test_a_path_that_tells_other_derivatives_than_it_has_is_refused(telling: Telling, told: str) -> None:
    found = plan_move(replace(CHAIN, joint_interpolator=telling), LINE, START)
    assert isinstance(found, Refusal)
    assert found.diagnostics[0].code == "C603"
    assert told in found.diagnostics[0].message
    assert "Tell" in found.diagnostics[0].message


@dataclass(frozen=True)
class Weaving:
    """A joint that goes to and fro; the derivatives may have another sign than its way has."""

    times: int
    d1: float = 1.0
    d2: float = 1.0
    length: float = 1.0

    def joints(self, s: Array) -> JointPoints:
        w = 2.0 * np.pi * self.times
        phase = w * np.asarray(s)[:, None]
        return JointPoints(np.sin(phase) / w, self.d1 * np.cos(phase), -self.d2 * w * np.sin(phase))


def found_of(path: Weaving) -> Refusal | None:
    return wrong_joint_derivatives(path, path, path.joints(np.linspace(0.0, 1.0, 20_011)), LINE)


@pytest.mark.parametrize("times", [1, 30, 300, 1000, 2500])
def test_however_often_a_path_weaves_its_derivatives_are_known_for_what_they_are(times: int) -> None:
    """2,500 times, a millionth of the path is 1/400 of a turn: only with its bend the slope is that."""
    assert found_of(Weaving(times)) is None
    assert found_of(Weaving(times, d1=-1.0)) is not None
    assert found_of(Weaving(times, d2=-1.0)) is not None
