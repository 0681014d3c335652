"""Motion of each joint in a run, compared with its limits."""

import math
from collections.abc import Iterable
from enum import Enum
from typing import Literal, TypeAlias

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import AxisFacts, AxisType, Recording
from ropsim.model import OVERRUN, SPEED_OVERSHOOT
from ropsim.spatial import Array
from ropsim.views.channels import Peak, StationView, rms, station_views

NEAR = 0.9
"""Share of a torque limit from which on a peak is marked as near it."""

NEAR_END = {AxisType.REVOLUTE: math.radians(1.0), AxisType.PRISMATIC: 1e-3}
"""Distance from the end of its range below which a joint is marked as near it [rad | m]."""

LimitSide: TypeAlias = Literal["lower", "upper"]
"""Which end of the range of a joint."""


class Closeness(Enum):
    """How a peak stands to its limit."""

    FAR = "far"
    NEAR = "near"
    BEYOND = "beyond"


@frozen_dataclass
class LimitApproach:
    """How near a coordinate came to one of its limits.

    Attributes:
        side: which limit it is.
        margin: distance left to the limit [rad | m]; negative beyond it, 0 where a servo overran it by up to
            `OVERRUN`, NaN without samples.
        coordinate: attained coordinate at that moment [rad | m].
        time: when [s].
        line: active source line, 0 for none.
    """

    side: LimitSide
    margin: float = math.nan
    coordinate: float = math.nan
    time: float = math.nan
    line: int = 0


@frozen_dataclass
class JointSummary:
    """One joint in one run.

    Attributes:
        station: name of the station whose joint it is.
        name: of the joint, with several stations that of its station before it.
        facts: name, type and limits.
        effort: largest torque or force at the joint [N·m | N].
        speed: largest attained speed [rad/s | m/s].
        current: largest motor current [A].
        nearest_lower: closest approach to the lower limit.
        nearest_upper: closest approach to the upper limit.
        following_max: largest following error (reference minus attained coordinate) [rad | m]; NaN without
            drives.
        following_rms: root of its mean square [rad | m].
    """

    station: str
    name: str
    facts: AxisFacts
    effort: Peak
    speed: Peak
    current: Peak
    nearest_lower: LimitApproach
    nearest_upper: LimitApproach
    following_max: Peak
    following_rms: float

    @property
    def words(self) -> str:
        """Return the joint in a sentence: `joint 3`, with several stations `right: joint 3`."""
        alone = f"joint {self.facts.name}"
        return alone if self.name == self.facts.name else f"{self.station}: {alone}"

    @property
    def effort_share(self) -> float:
        """Return the peak torque as a share of the limit; NaN where there is no limit."""
        return share(self.effort.size, self.facts.max_effort)

    @property
    def speed_share(self) -> float:
        """Return the peak speed as a share of the limit; NaN where there is no limit."""
        return share(self.speed.size, self.facts.max_speed)

    @property
    def effort_closeness(self) -> Closeness:
        """Return how the peak torque stands to its limit."""
        if self.effort_share > 1.0:
            return Closeness.BEYOND
        return Closeness.NEAR if self.effort_share >= NEAR else Closeness.FAR

    @property
    def speed_closeness(self) -> Closeness:
        """Return how the peak speed stands to its limit; an overshoot of 2 % counts as within it.

        A good plan uses all of the speed that a joint has, so being near the limit is no finding.
        """
        return Closeness.BEYOND if self.speed_share > 1.0 + SPEED_OVERSHOOT else Closeness.FAR

    @property
    def margin_closeness(self) -> Closeness:
        """Return how the joint stands to the nearer end of its range."""
        return end_closeness(self.nearest.margin, self.facts.type)

    @property
    def share_of_range_left(self) -> float:
        """Return the least margin as a share of the range; 0 for a range without end."""
        return self.nearest.margin / (self.facts.upper - self.facts.lower)

    @property
    def nearest(self) -> LimitApproach:
        """Return the closer of the two approaches."""
        lower, upper = self.nearest_lower, self.nearest_upper
        return upper if not math.isfinite(lower.margin) or upper.margin < lower.margin else lower


def end_closeness(margin: float, joint: AxisType) -> Closeness:
    """Return how a margin to an end of the range of a joint stands to it [rad | m]; NaN is far."""
    if margin < 0.0:
        return Closeness.BEYOND
    return Closeness.NEAR if margin < NEAR_END[joint] else Closeness.FAR


def closest_to_torque_limit(joints: Iterable[JointSummary]) -> JointSummary | None:
    """Return the joint with the largest share of its torque limit, None where no share is known."""
    known = [joint for joint in joints if math.isfinite(joint.effort_share)]
    return max(known, key=lambda joint: joint.effort_share, default=None)


def closest_to_speed_limit(joints: Iterable[JointSummary]) -> JointSummary | None:
    """Return the joint with the largest share of its speed limit, None where no share is known."""
    known = [joint for joint in joints if math.isfinite(joint.speed_share)]
    return max(known, key=lambda joint: joint.speed_share, default=None)


def closest_to_position_limit(joints: Iterable[JointSummary]) -> JointSummary | None:
    """Return the joint with the least margin to an end of its range, None where no margin is known.

    Radians are compared with radians and metres with metres; between the two the share of the range decides.
    """
    known = [joint for joint in joints if math.isfinite(joint.nearest.margin)]
    least: dict[AxisType, JointSummary] = {}
    for joint in known:
        other = least.get(joint.facts.type)
        if other is None or joint.nearest.margin < other.nearest.margin:
            least[joint.facts.type] = joint
    return min(least.values(), key=lambda joint: joint.share_of_range_left, default=None)


def share(value: float, limit: float) -> float:
    """Return `value` / `limit`, or NaN where the limit is unknown or zero."""
    return value / limit if math.isfinite(limit) and limit > 0.0 else math.nan


def summarize_joints(recording: Recording) -> tuple[JointSummary, ...]:
    """Return the figures of every joint, station after station."""
    return tuple(joint for station in station_views(recording) for joint in _of_station(station))


def _of_station(station: StationView) -> tuple[JointSummary, ...]:
    q, qd, tau, current, error = map(station.joints, ("q", "qd", "tau", "current", "q_error"))
    if not station.is_driven:
        error = np.full_like(error, np.nan)
    return tuple(
        JointSummary(
            station.facts.name,
            station.label(facts.name),
            facts,
            effort=station.peak(tau[:, k]),
            speed=station.peak(qd[:, k]),
            current=station.peak(current[:, k]),
            nearest_lower=_approach(station, "lower", q[:, k] - facts.lower, q[:, k]),
            nearest_upper=_approach(station, "upper", facts.upper - q[:, k], q[:, k]),
            following_max=station.peak(error[:, k]),
            following_rms=rms(error[:, k]),
        )
        for k, facts in enumerate(station.facts.axes)
    )


def _approach(station: StationView, side: LimitSide, margins: Array, coordinates: Array) -> LimitApproach:
    if not np.any(np.isfinite(margins)):
        return LimitApproach(side)
    index = int(np.nanargmin(margins))
    margin = float(margins[index])
    return LimitApproach(
        side,
        0.0 if -OVERRUN <= margin < 0.0 else margin,
        float(coordinates[index]),
        float(station.time[index]),
        station.line(index),
    )
