"""Block diagrams for tests: one axis, laws called tick by tick, and a slide that a law drives."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim import robots
from ropsim.blockdiagram import Axes, Block, Diagram, OutputKind, Role, Signal, Unit
from ropsim.controller import CompiledLaw, diagram_law, in_python, law_arrays
from ropsim.flow import JointReference, Recording
from ropsim.model import (
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    JointType,
    RobotModel,
    VoltageAmplifier,
)
from ropsim.simulation import SimulationOptions, simulate
from ropsim.spatial import Array

PERIOD = 0.001
SLIDE = Axes((JointType.PRISMATIC,), PERIOD, OutputKind.EFFORT)
"""One axis that slides, under a force."""


def slide(mass: float = 10.0, viscous: float = 0.0, most: float = 1e6) -> RobotModel:
    """Return a mass that slides along x under a force at once, with viscous friction and without dry one."""
    made = robots.driven_slide((), robots.AxisData(-5.0, 5.0, 50.0, 500.0, mass))
    drive = Drive(EffortAmplifier(most), IdealMotor(), Gear(1.0), Friction(viscous))
    return replace(made, drives=(drive,))


def of_block(block: Block, unit: Unit = Unit.METRE) -> Diagram:
    """Return a diagram of one block between the reference `r`, the measurement `m` and the output `y`."""
    signals = (
        Signal("r", 1, (Unit.METRE,), Role.REFERENCE_COORDINATE),
        Signal("m", 1, (Unit.METRE,), Role.COORDINATE),
        Signal("y", 1, (unit,), Role.OUTPUT),
    )
    return Diagram("one", PERIOD, signals, (block,))


def outputs(law: CompiledLaw, references: npt.ArrayLike, measured: npt.ArrayLike = ()) -> Array:
    """Return what a law of one axis puts out, tick by tick, in plain Python."""
    function, arrays = in_python(law), law_arrays(law, 1)
    made, given = [], np.asarray(references, np.float64)
    seen = np.resize(np.asarray(measured, np.float64), given.shape) if np.size(measured) else 0.0 * given
    for k, value in enumerate(given):
        arrays["ref"][0, 0], arrays["meas"][0, 0] = value, seen[k]
        function(arrays)
        made.append(arrays["out"][0])
    return np.array(made)


def answers(block: Block, references: npt.ArrayLike, measured: npt.ArrayLike = ()) -> Array:
    """Return what a block alone makes of a reference `r` and a measurement `m`."""
    return outputs(diagram_law(of_block(block), slide()), references, measured)


def voltages(robot: RobotModel) -> tuple[float, ...]:
    """Return the greatest voltages of the amplifiers of an arm with DC motors."""
    amplifiers = [one.amplifier for one in robot.drives]
    return tuple(one.max_voltage for one in amplifiers if isinstance(one, VoltageAmplifier))


def run(robot: RobotModel, diagram: Diagram, q: npt.ArrayLike, qd: npt.ArrayLike | None = None) -> Recording:
    """Return the recording of an arm that follows coordinates and speeds, shape (ticks, n)."""
    coordinates = np.asarray(q, np.float64)
    zeros = np.zeros_like(coordinates)
    reference = JointReference(coordinates, zeros if qd is None else np.asarray(qd, np.float64), zeros)
    controller = robots.default_controller(robot)
    law = diagram_law(diagram, robot)
    return simulate(robot, controller, reference, SimulationOptions(start=robot.home, law=law))
