"""Code of blocks with the model of the arm: torques of a motion, inputs of the amplifiers."""

from functools import lru_cache

import numpy as np

from ropsim import blockdiagram as b
from ropsim.codegen import SourceFunction, Tracer, emit
from ropsim.controller.diagrams.written import Written
from ropsim.dynamics import (
    ArmStructure,
    split_numbers,
    steady_drive,
    structure_of,
    trace_loaded_inverse,
    with_rigid_gears,
)
from ropsim.model import Mechanism

WORK = ("coordinate", "speed", "acceleration", "motor_speed", "effort")
"""Rows in which the model of the arm takes a motion and returns its efforts."""
_LOAD = 10


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
    to.outputs.append("motion_efforts(model, work.reshape(-1), load)")
    to.outputs += [f"{y} = work[4, {k}]" for k, y in enumerate(to.results(block))]


def motion_efforts(robot: Mechanism) -> SourceFunction:
    """Return `motion_efforts(model, work, load)` of an arm; `WORK` names the rows of `work`."""
    return _motion_efforts(structure_of(with_rigid_gears(robot)))


@lru_cache(maxsize=16)
def _motion_efforts(structure: ArmStructure) -> SourceFunction:
    tracer, n = Tracer(), structure.n
    zero = tracer.constant(0.0)
    numbers = [tracer.variable(f"model[{k}]") if there else zero for k, there in enumerate(structure.present)]
    q, qd, qdd, motor = ([tracer.variable(f"work[{row * n + k}]") for k in range(n)] for row in range(4))
    arm, load = split_numbers(structure, numbers), tracer.variables("load", _LOAD)
    tau = trace_loaded_inverse(tracer, structure, arm, (q, qd, qdd), load, (motor, qdd))
    results = [(f"work[{4 * n + k}]", one) for k, one in enumerate(tau)]
    return emit("motion_efforts", ("model", "work", "load"), results)


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
