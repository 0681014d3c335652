"""A planned motion sequence, with the data that a run needs on its motion."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from ropsim.controller import ClockLimits
from ropsim.flow import CriticalLimit
from ropsim.kinematics import tool_places
from ropsim.model import Payload, RobotModel
from ropsim.motion import JointBounds
from ropsim.planning import (
    PLANNED_ACCELERATION,
    MotionChain,
    MotionPlan,
    MotionSequence,
    Refusal,
    arm_bounds,
    binding_constraints,
    ordered,
)
from ropsim.simulation.records.tally_kernel import peaks
from ropsim.spatial import Array, record

_LEAST_SPEED = 1e-3
"""Share of the greatest speed of a joint below which its own one says nothing of how it brakes."""

_SPEED_WITH_CORRECTION = 0.5
"""Least share of the greatest speeds for braking of a corrected motion: then the correction, at most a tenth
of them, takes less than a sixth of the accelerations."""


@record
class PlannedMotion:
    """The plan of a motion sequence, and derived data.

    Attributes:
        plan: the motion.
        critical: the limit that each move is at for longest, None where it reaches none.
        places: where the TCP is at the end of each move, in the base frame [m].
        joints: capabilities of the joints.
    """

    plan: MotionPlan
    critical: tuple[CriticalLimit | None, ...]
    places: tuple[tuple[float, ...], ...]
    joints: JointBounds

    def clock_limits(self) -> ClockLimits:
        """Return how quickly the override may act; only where it does must that be known."""
        top, joints = np.empty(len(self.joints.speed)), self.joints
        peaks(np.ascontiguousarray(self.plan.reference.qd), top)
        speeds, accelerations = np.maximum(top, _LEAST_SPEED * joints.speed), joints.acceleration
        if self.plan.is_corrected:  # the correction is braked with it
            speeds = np.maximum(speeds, _SPEED_WITH_CORRECTION * joints.speed)
            accelerations = accelerations * PLANNED_ACCELERATION
        return clock_limits(speeds, accelerations, joints.jerk)


@record
class PlannedSequence:
    """Result of planning a motion sequence.

    Attributes:
        motion: through the moves up to the first one that cannot be made, None where that is the first.
        refusal: why that cannot be made, None where all can.
    """

    motion: PlannedMotion | None
    refusal: Refusal | None


Planning: TypeAlias = Callable[[str, MotionChain, MotionSequence], PlannedSequence]
"""Plans a sequence of the station of a name; see `ropsim.controller.plan`."""


def planned_anew(station: str, chain: MotionChain, order: MotionSequence) -> PlannedSequence:
    """Plan a motion sequence without using kept plans."""
    del station
    planned, refusal = ordered(chain, order)
    return PlannedSequence(_motion(planned, chain.robot, order.payload) if planned else None, refusal)


def clock_limits(speeds: Array, accelerations: Array, jerks: Array) -> ClockLimits:
    """Return how quickly the rate of the motion clock may change.

    A joint at its largest speed is braked with its full acceleration, built up with its full jerk; the joint
    that takes longest decides.

    Args:
        speeds: largest ones of the joints on the motion [rad/s | m/s], shape (n,).
        accelerations: [rad/s² | m/s²], shape (n,).
        jerks: [rad/s³ | m/s³], shape (n,).
    """
    return ClockLimits(float((accelerations / speeds).min()), float((jerks / speeds).min()), accelerations)


def _motion(planned: MotionPlan, robot: RobotModel, payload: Payload) -> PlannedMotion:
    critical = binding_constraints(planned, robot, payload)
    return PlannedMotion(planned, critical, _places(planned, robot), arm_bounds(robot, payload).joints)


def _places(planned: MotionPlan, robot: RobotModel) -> tuple[tuple[float, ...], ...]:
    ends = np.concatenate([one.q_end for one in planned.moves])
    return tuple(map(tuple, tool_places(robot, ends, [one.X_MT for one in planned.moves]).tolist()))
