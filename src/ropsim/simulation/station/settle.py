"""The end of a fine stop: the arm stands until it is in position."""

import math
from collections.abc import Generator, Iterator

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import forward
from ropsim.model import JointType
from ropsim.simulation.diagnostics.run_diagnostics import FAR_FROM_TARGET, NOT_IN_POSITION
from ropsim.simulation.findings.circumstances import Circumstances, contact_words, loop_words
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun

FAR = 50.0
"""Multiple of `in_position` from which on an arm that does not settle has lost its target."""

FAR_AT_TOOL, CLEARLY = 0.01, 2.0
"""The same at the tool [m], where a joint is further away than this multiple of `in_position`."""

SPEED_TIME = 0.02
"""Time in which a joint in position may at most pass `in_position` [s]."""


def settle(run: CellRun, at: StationRun, move: MoveInstruction) -> Generator[None, None, float | None]:
    """Stand until every joint is near its target and slow, for the settling time of the controller.

    An arm that is exactly there, as that of a kinematic run, has nothing to settle.

    Returns:
        Largest share of `in_position` by which a joint is off; None where the run was cut short before.
    """
    controller = at.station.controller
    step = controller.rates.interpolation_ticks
    if _is_there(at):
        return 0.0
    start, limit = at.tick, round(controller.settle_timeout * at.hz)
    needed, stood = round(controller.settle_time * at.hz), 0
    while stood < needed or not _is_in_position(at):
        if at.tick - start >= limit:
            run.findings.append(_not_in_position(run, at, move))
            break
        stood = stood + step if _is_in_position(at) else 0
        yield from at.stand(step)
        if at.cut_short:
            return None
    return max(_shares(at))


def _is_there(at: StationRun) -> bool:
    q, qd = at.plant.sensed
    return q.tolist() == at.q_command.tolist() and not any(qd.tolist())


def _is_in_position(at: StationRun) -> bool:
    return all(share <= 1.0 for share in _shares(at))


def _shares(at: StationRun) -> Iterator[float]:
    """Yield the error of each joint as a share of its window; its speed counts as the way of `SPEED_TIME`."""
    window = at.station.controller.in_position.tolist()
    q_seen, qd_seen = at.plant.sensed.tolist()
    joints = zip(q_seen, at.q_command.tolist(), qd_seen, window, strict=True)
    for q, wanted, qd, most in joints:
        off = max(abs(q - wanted), abs(qd) * SPEED_TIME)
        yield off / most if most > 0.0 else math.inf if off > 0.0 else 0.0


def _not_in_position(run: CellRun, at: StationRun, move: MoveInstruction) -> Diagnostic:
    controller = at.station.controller
    window = controller.in_position
    q, qd = at.plant.sensed
    errors, speeds = np.abs(q - at.q_command), np.abs(qd)
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
    away = _away(at, move)
    is_far = error > FAR * allowed or (away > FAR_AT_TOOL and error > CLEARLY * allowed)
    kind = FAR_FROM_TARGET if is_far else NOT_IN_POSITION
    return kind.at(
        move.origin.span,
        f"joint `{model.name}` {found} after {controller.settle_timeout:g} s, in position means {means}; "
        f"the tool is {away * 1e3:.3g} mm from its target",
        label=f"pass {move.origin.visit}",
        hint=Circumstances(
            loop_words(at.station.robot, controller),
            contact_words(run.cell, float(np.linalg.norm(at.plant.wrench[:3]))),
        ).hint("slow the move down, or widen `in_position` in the cell file"),
        data={
            **move.origin.data,
            "joint": joint + 1,
            f"error_{sort}": error,
            "distance_m": away,
        },
    )


def _away(at: StationRun, move: MoveInstruction) -> float:
    """Return how far the TCP is from where it is commanded to be [m]."""
    X_MT = at.chain.tool_pose(move.modal)
    is_, wanted = (forward(at.station.robot, q) @ X_MT for q in (at.plant.q, at.q_command))
    return float(np.linalg.norm(is_.position - wanted.position))
