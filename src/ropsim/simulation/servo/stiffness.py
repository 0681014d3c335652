"""Axes whose friction is too steep for the integration step: a light link on a joint with much friction.

Friction with bristles holds a joint at rest as a spring k does: ẍ = -k/J·x decays or swings at √(k/J).
"""

from collections.abc import Iterator

import numpy as np

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.dynamics import reflected_inertia
from ropsim.flow import Fidelity
from ropsim.model import ROBOT, Cell, JointType, Rates, RobotModel
from ropsim.simulation.servo.diagnostics import STEEP_FRICTION
from ropsim.simulation.servo.plant_steps import friction_rates, plant_steps_of

STABLE = 2.7
"""Greatest product of integration step and decay rate; fixed Runge-Kutta steps of fourth order bear 2.785.
E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, section IV.2."""


@frozen_dataclass
class SteepAxis:
    """An axis that friction brakes within less than an integration step.

    Attributes:
        axis: its number, from 0.
        friction: slope of its friction over its speed, at rest [N·m·s/rad | N·s/m].
        inertia: the least that it moves while the other axes are free [kg·m² | kg].
        product: d/J·dt of the two and the step, or √(k/J)·dt where that is greater; stable below `STABLE`.
        bristles: stiffness k of the bristles [N·m/rad | N/m] where they set the product, else 0.
    """

    axis: int
    friction: float
    inertia: float
    product: float
    bristles: float = 0.0


def steep_axes(robot: RobotModel, rates: Rates) -> tuple[SteepAxis, ...]:
    """Return the axes whose friction cannot be integrated, the steepest first.

    Args:
        robot: with drives.
        rates: of its controller.

    Raises:
        MissingMassError: M590 or M591, the arm, or what an axis moves, has no inertia.
    """
    step = rates.control_period / plant_steps_of(robot, rates)
    found = friction_rates(robot)
    products, swings = found.rates * step, found.swings * step
    order = np.argsort(-products, kind="stable")
    return tuple(
        SteepAxis(
            int(k),
            float(found.slopes[k]),
            float(found.inertias[k]),
            float(products[k]),
            float(found.springs[k]) if swings[k] == products[k] else 0.0,
        )
        for k in order
        if not products[k] < STABLE
    )


STEEP_HINT = "`ropsim robot estimate FILE robots/NEW.stp` adds rotors and gears; or raise `plant_steps`"


def steep_words(robot: RobotModel, steep: SteepAxis) -> str:
    """Return what is wrong with a steep axis, in words."""
    joint = robot.axis_joints[steep.axis]
    slides = joint.type is JointType.PRISMATIC
    inertia, friction = ("kg", "N·s/m") if slides else ("kg·m²", "N·m·s/rad")
    rotor = reflected_inertia(robot.drives[steep.axis], float(robot.home[steep.axis]))
    behind = "with its rotor" if rotor else "without a rotor"
    against, rate = f"friction of {steep.friction:.3g} {friction}", "d/J·dt"
    if steep.bristles:
        unit = "N/m" if slides else "N·m/rad"
        against, rate = f"bristles of {steep.bristles:.3g} {unit}", "√(k/J)·dt"
    return (
        f"axis `{joint.name}` moves {steep.inertia:.3g} {inertia} {behind} against {against}, "
        f"{rate} is {steep.product:.3g}, stable is less than {STABLE:g}"
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
