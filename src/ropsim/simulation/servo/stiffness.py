"""Integration steps that are too long: for the friction of an axis, or for the fastest pole of the plant.

Friction with bristles holds a joint at rest as a spring k does: ẍ = -k/J·x decays or swings at √(k/J).
"""

from collections.abc import Iterator
from math import ceil, isfinite

import numpy as np

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.dynamics import reflected_inertia
from ropsim.flow import Fidelity
from ropsim.model import ROBOT, Cell, JointType, Rates, RobotModel
from ropsim.simulation.servo.diagnostics import LONG_STEP, STEEP_FRICTION
from ropsim.simulation.servo.plant_steps import LARGEST_PRODUCT, fastest_pole, friction_rates, plant_steps_of

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
    step = _step(robot, rates)
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
    """Yield a warning for each robot with drives whose integration steps are too long.

    It is about the axis with the steepest friction, or about the fastest pole of drives and arm.

    Args:
        cell: that is run.
        fidelity: that was requested.
    """
    if fidelity is Fidelity.KINEMATIC:
        return
    for name, station in cell.stations.items():
        robot, rates = station.robot, station.controller.rates
        found = steep_axes(robot, rates) if robot.drives else ()
        if found:
            where = "" if name == ROBOT else f" of station `{name}`"
            others = f"; {len(found) - 1} more axes are like it" if len(found) > 1 else ""
            yield STEEP_FRICTION.at(
                None,
                f"`{robot.name}`{where}: {steep_words(robot, found[0])}{others}",
                hint=STEEP_HINT,
                data={"axes": tuple(robot.axis_joints[one.axis].name for one in found)},
            )
        elif robot.drives and (long := long_step(name, robot, rates)):
            yield long


def long_step(name: str, robot: RobotModel, rates: Rates) -> Diagnostic | None:
    """Return the warning that the integration step is too long for the fastest pole; None where it is not.

    Args:
        name: of the station.
        robot: with drives.
        rates: of its controller.
    """
    pole, step = fastest_pole(robot), _step(robot, rates)
    if pole * step < STABLE:
        return None
    where = "" if name == ROBOT else f" of station `{name}`"
    needed = ceil(rates.control_period * pole / LARGEST_PRODUCT) if isfinite(pole) else 0
    message = (
        f"`{robot.name}`{where}: the fastest pole of drives and arm is {pole:.3g} 1/s, times the integration "
        f"step of {step * 1e3:.3g} ms it is {pole * step:.3g}, stable is less than {STABLE:g}"
    )
    hint = f"`plant_steps` = {needed} would do" if needed else "an axis moves nothing: look for its inertia"
    return LONG_STEP.at(None, message, hint=hint, data={"pole": pole, "step_s": step})


def _step(robot: RobotModel, rates: Rates) -> float:
    """Return the integration step [s]."""
    return rates.control_period / plant_steps_of(robot, rates)
