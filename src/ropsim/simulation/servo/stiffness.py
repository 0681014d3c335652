"""Axes whose friction is too steep for the integration step: a light link on a joint with much friction."""

from collections.abc import Iterator

import numpy as np

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.dynamics import free_inertias, reflected_inertia
from ropsim.flow import Fidelity
from ropsim.kinematics import configurations
from ropsim.model import ROBOT, Cell, Drive, JointType, Rates, RobotModel
from ropsim.simulation.servo.diagnostics import STEEP_FRICTION
from ropsim.simulation.servo.plant_steps import plant_steps_of
from ropsim.spatial import Array

STABLE = 2.7
"""Greatest product of integration step and decay rate; fixed Runge-Kutta steps of fourth order bear 2.785.
E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, section IV.2."""
SAMPLES = 64
"""Configurations in which the least inertia of each axis is looked for."""


@frozen_dataclass
class SteepAxis:
    """An axis that friction brakes within less than an integration step.

    Attributes:
        axis: its number, from 0.
        friction: slope of its friction over its speed, at rest [N·m·s/rad | N·s/m].
        inertia: the least that it moves while the other axes are free [kg·m² | kg].
        product: d/J·dt of the two and the step; stable below `STABLE`.
    """

    axis: int
    friction: float
    inertia: float
    product: float


def steep_axes(robot: RobotModel, rates: Rates) -> tuple[SteepAxis, ...]:
    """Return the axes whose friction cannot be integrated, the steepest first.

    Args:
        robot: with drives.
        rates: of its controller.

    Raises:
        MissingMassError: M590 or M591, the arm, or what an axis moves, has no inertia.
    """
    step = rates.control_period / plant_steps_of(robot, rates)
    inertias = free_inertias(robot, configurations(robot, SAMPLES)).min(axis=0)
    slopes = np.array([_slope(drive, q) for drive, q in zip(robot.drives, robot.home.tolist(), strict=True)])
    products: Array = slopes / inertias * step
    order = np.argsort(-products, kind="stable")
    return tuple(
        SteepAxis(int(k), float(slopes[k]), float(inertias[k]), float(products[k]))
        for k in order
        if not products[k] < STABLE
    )


def _slope(drive: Drive, q: float) -> float:
    """Return the slope of the friction at the joint over its speed, at rest: B·G² + |G|·Tc/v_s."""
    ratio, friction = abs(drive.ratio_at(q)), drive.friction
    dry = max(friction.coulomb_positive, -friction.coulomb_negative)
    return ratio**2 * friction.viscous + (ratio * dry / friction.smoothing_speed if dry else 0.0)


STEEP_HINT = "`ropsim robot estimate FILE robots/NEW.stp` adds rotors and gears; or raise `plant_steps`"


def steep_words(robot: RobotModel, steep: SteepAxis) -> str:
    """Return what is wrong with a steep axis, in words."""
    joint = robot.axis_joints[steep.axis]
    slides = joint.type is JointType.PRISMATIC
    inertia, friction = ("kg", "N·s/m") if slides else ("kg·m²", "N·m·s/rad")
    rotor = reflected_inertia(robot.drives[steep.axis], float(robot.home[steep.axis]))
    behind = "with its rotor" if rotor else "without a rotor"
    return (
        f"axis `{joint.name}` moves {steep.inertia:.3g} {inertia} {behind} against friction of "
        f"{steep.friction:.3g} {friction}, d/J·dt is {steep.product:.3g}, stable is less than {STABLE:g}"
    )


def steep_findings(cell: Cell, fidelity: Fidelity) -> Iterator[Diagnostic]:
    """Yield a warning for each robot with drives whose friction is too steep, about its steepest axis.

    Args:
        cell: that is run.
        fidelity: that was requested.
    """
    if fidelity is Fidelity.KINEMATIC:
        return
    for name, station in cell.stations.items():
        found = steep_axes(station.robot, station.controller.rates) if station.robot.drives else ()
        if found:
            where = "" if name == ROBOT else f" of station `{name}`"
            others = f"; {len(found) - 1} more axes are like it" if len(found) > 1 else ""
            yield STEEP_FRICTION.at(
                None,
                f"`{station.robot.name}`{where}: {steep_words(station.robot, found[0])}{others}",
                hint=STEEP_HINT,
                data={"axes": tuple(station.robot.axis_joints[one.axis].name for one in found)},
            )
