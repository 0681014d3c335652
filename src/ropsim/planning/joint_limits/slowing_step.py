"""A step by which a section gets slower where joints cannot follow."""

import numpy as np

from ropsim.motion import LawRows, Reference
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.exceeding_kernel import AtTicks, ReferenceRows, SectionLaw, evaluate_section
from ropsim.planning.joint_limits.joint_imposed import EvaluatedPath, imposed_limits
from ropsim.planning.joint_limits.limit_grid import LimitGrid
from ropsim.planning.trajectory.sections import Section, TimingRules
from ropsim.planning.trajectory.trajectory import Trajectory
from ropsim.spatial import Array, record


@record
class Aim:
    """Aim of a step.

    Attributes:
        arm: limits of the joints.
        period: of the ticks at which the motion was evaluated [s].
        used: share of the limits, in ]0, 1].
        rules: time law and look-ahead.
    """

    arm: ArmBounds
    period: float
    used: float
    rules: TimingRules


def slower_section(
    motion: Trajectory, reference: Reference, number: int, grid: LimitGrid, ticks: Array, aim: Aim
) -> tuple[LimitGrid, Section]:
    """Return the cells of a section as caps at ticks bring them down, and its part with them.

    Args:
        motion: of the motion sequence.
        reference: of it, at the evaluated ticks.
        number: of the section.
        grid: of it.
        ticks: at which a limit is exceeded, none of them 0, shape (b,).
        aim: of the step.
    """
    evaluated = _evaluated(motion, reference, number, grid.begins, ticks)
    lower = grid.lowered(imposed_limits(evaluated, aim.arm, aim.period, aim.used))
    return lower, lower.replanned(aim.rules)


def _evaluated(
    motion: Trajectory, reference: Reference, number: int, begins: Array, ticks: Array
) -> EvaluatedPath:
    """Return the path of a section at ticks and at the ticks before them."""
    run, b = motion.timing.sections[number], len(ticks)
    rows, law, parameters = reference.rows, np.empty((5, 2 * b)), np.empty((2, b))
    joints, qdd = np.empty((2, 2, b, rows.q.shape[1]))
    section = SectionLaw(run.law.segments, run.law.duration, run.start, begins)
    references = ReferenceRows(reference.phi, rows.q, rows.d1, rows.d2)
    evaluate_section(section, references, ticks, np.empty(2 * b), AtTicks(law, parameters, joints, qdd))
    points = motion.on_section(number, LawRows(law[0].astype(np.int64), law[1], law[2], law[3]))
    pairs = qdd.shape
    return EvaluatedPath(
        parameters,
        law[2].reshape(2, b),
        law[3].reshape(2, b),
        law[4].reshape(2, b),
        points.d1.reshape(pairs),
        points.d2.reshape(pairs),
        joints[0],
        joints[1],
        qdd,
        None if reference.torque is None else reference.torque[ticks.astype(np.intp)],
    )
