"""The end of a fine stop: the arm stands until it is in position."""

import math
from collections.abc import Iterator

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.model import JointType
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.diagnostics import FAR_FROM_TARGET, NOT_IN_POSITION
from ropsim.simulation.station_run import StationRun

FAR = 50.0
"""Share of `in_position` from which on an arm that does not settle has lost its target."""

SPEED_TIME = 0.02
"""Time in which a joint in position may at most pass `in_position` [s]."""


def settle(run: CellRun, at: StationRun, move: MoveInstruction) -> Iterator[None]:
    """Stand until every joint is near its target and slow, for the settling time of the controller.

    An arm that is exactly there, as that of a kinematic run, has nothing to settle.
    """
    controller = at.station.controller
    step = controller.rates.interpolation_ticks
    if _is_there(at):
        return
    start, limit = at.tick, round(controller.settle_timeout * at.hz)
    needed, stood = round(controller.settle_time * at.hz), 0
    while stood < needed or not _is_in_position(at):
        if at.tick - start >= limit:
            run.findings.append(_not_in_position(at, move))
            break
        stood = stood + step if _is_in_position(at) else 0
        yield from at.stand(step)
        if at.cut_short:
            break


def _is_there(at: StationRun) -> bool:
    return at.plant.q.tolist() == at.q_command.tolist() and not any(at.plant.qd.tolist())


def _is_in_position(at: StationRun) -> bool:
    window = at.station.controller.in_position.tolist()
    joints = zip(at.plant.q.tolist(), at.q_command.tolist(), at.plant.qd.tolist(), window, strict=True)
    return all(abs(q - wanted) <= most and abs(qd) * SPEED_TIME <= most for q, wanted, qd, most in joints)


def _not_in_position(at: StationRun, move: MoveInstruction) -> Diagnostic:
    controller = at.station.controller
    window = controller.in_position
    errors, speeds = np.abs(at.plant.q - at.q_command), np.abs(at.plant.qd)
    moves = bool((errors <= window).all())
    joint = int(((speeds if moves else errors) / window).argmax())
    model, error, allowed = at.station.robot.axis_joints[joint], float(errors[joint]), float(window[joint])
    turns = model.measure is JointType.REVOLUTE
    scale, unit, sort = (180.0 / math.pi, "°", "rad") if turns else (1e3, " mm", "m")
    if moves:
        found = f"still moves at {speeds[joint] * scale:.4g}{unit}/s"
        means = f"not faster than {allowed / SPEED_TIME * scale:.4g}{unit}/s"
    else:
        found = f"is {error * scale:.4g}{unit} from its target"
        means = f"{allowed * scale:.4g}{unit}"
    kind = FAR_FROM_TARGET if error > FAR * allowed else NOT_IN_POSITION
    return kind.at(
        move.origin.span,
        f"joint `{model.name}` {found} after {controller.settle_timeout:g} s, in position means {means}",
        label=f"pass {move.origin.visit}",
        hint="slow the move down, raise the integral gain `ki`, or widen `in_position` in the cell file",
        data={
            "pass": move.origin.visit,
            "joint": joint + 1,
            f"error_{sort}": error,
        },
    )
