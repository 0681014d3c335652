"""The inverse transform by damped least squares: it passes close to singular poses without a turn-about."""

from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import JointSamples, MoveInstruction, PoseSetpoints
from ropsim.kinematics import damped_path
from ropsim.planning.moves.inverse_transform import StandardInverseTransform
from ropsim.planning.moves.line_check import end_findings
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.free_orientation import counted_of
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.planned_path import Counts
from ropsim.planning.records.posture_choice import JointRange
from ropsim.spatial import Array, record

MOST_DISTANCE = 5e-4
"""Distance of the TCP from its path that is left [m]."""
MOST_TURN = 5e-4
"""Turn of the tool away from its path that is left [rad]."""
_POSE = 6


@record
class DampedInverseTransform:
    """Follows a path numerically, from each pose to the next one, with damping near singular poses.

    Its results are those of the exact transform away from singular poses. Past one it leaves the tool up to
    0.5 mm and 0.0005 rad beside the path where that spares the joints a turn-about. Paths that need more, or
    joint coordinates outside of their limits, paths with external axes, of points, and of arms with fewer
    than six axes are followed by the exact one.

    Attributes:
        exact: the transform by the closed form of the arm.
    """

    exact: StandardInverseTransform

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        """Return joint samples that continue `q_start` without a jump, or say where it is impossible.

        Args:
            setpoints: X_BT along the path, k rows.
            q_start: joint coordinates at the start [rad | m], shape (n,).
            move: the instruction; names the tool.
        """
        robot = self.exact.robot
        X_MT = self.exact.tool_of(move)
        if (
            isinstance(X_MT, Diagnostic)
            or robot.external
            or robot.n < _POSE
            or counted_of(move, robot) is Counts.POINT
        ):
            return self.exact.solve(setpoints, q_start, move)
        found = damped_path(robot, setpoints.matrices, q_start, X_MT)
        limits = JointRange.of(robot)
        if (
            not (found.distance <= MOST_DISTANCE and found.turn <= MOST_TURN)
            or limits.excess(found.q).any()
            or not np.isfinite(found.q).all()
        ):
            return self.exact.solve(setpoints, q_start, move)
        return JointSamples(setpoints.length, found.q, end_findings(move, found.q[-1]))


def damped_least_squares(chain: MotionChain) -> MotionChain:
    """Return a chain with this inverse transform.

    Args:
        chain: with the standard inverse transform.
    """
    exact = chain.inverse
    assert isinstance(exact, StandardInverseTransform)
    return replace(chain, inverse=DampedInverseTransform(exact))
