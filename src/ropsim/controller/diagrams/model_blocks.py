"""Code of blocks with the model of the arm: torques of a motion, inputs of the amplifiers."""

import numpy as np

from ropsim import blockdiagram as b
from ropsim.codegen import SourceFunction
from ropsim.controller.diagrams.written import Written
from ropsim.controller.law_model import inverse_function
from ropsim.dynamics import steady_drive, structure_of, with_rigid_gears
from ropsim.model import Mechanism

WORK = ("coordinate", "speed", "acceleration", "motor_speed", "effort")
"""Rows in which the model of the arm takes a motion and returns its efforts."""


def model_feed_forward(block: b.ModelFeedForward, to: Written) -> None:
    """Write the efforts of a motion: coordinates, speeds, accelerations, and speeds for friction."""
    inputs = to.inputs(block)
    n = len(inputs[0])
    zeros = ["0.0"] * n
    if block.kind is b.ModelKind.GRAVITY:
        inputs = [inputs[0], zeros, zeros, zeros]
    elif len(inputs) == 3:
        inputs = [*inputs, inputs[1]]
    for row, elements in enumerate(inputs):
        to.outputs += [f"work[{row}, {k}] = {one}" for k, one in enumerate(elements)]
    to.outputs.append("motion_efforts(model, work[0], work[1], work[2], work[3], load, work[4])")
    to.outputs += [f"{y} = work[4, {k}]" for k, y in enumerate(to.results(block))]


def motion_efforts(robot: Mechanism) -> SourceFunction:
    """Return `motion_efforts` of an arm: model, the rows of `WORK` but the last, load, and that last row."""
    return inverse_function("motion_efforts", WORK[:4], structure_of(with_rigid_gears(robot)))


def drive_command(block: b.DriveCommand, to: Written, robot: Mechanism) -> None:
    """Write the inputs of the amplifiers for efforts and speeds at the joints.

    As of the steady drive: for a DC motor the voltage for its current and its back-EMF.
    """
    efforts, speeds = to.inputs(block)
    home = np.asarray(robot.home, np.float64).tolist()
    for k, (y, drive) in enumerate(zip(to.results(block), robot.drives, strict=True)):
        per_effort = steady_drive(drive, home[k], 0.0, 1.0).command
        per_speed = steady_drive(drive, home[k], 1.0, 0.0).command
        to.outputs.append(
            f"{y} = {to.number(per_effort)} * {efforts[k]} + {to.number(per_speed)} * {speeds[k]}"
        )
