"""Moves of a run: plan, follow, settle."""

import math
from collections.abc import Iterator

from ropsim.controller import Refusal, plan_move
from ropsim.core import Diagnostic
from ropsim.flow import MoveEvent, MoveInstruction, SkipEvent
from ropsim.model import JointType
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.diagnostics import FAR_FROM_TARGET, NOT_IN_POSITION
from ropsim.simulation.move_span import MoveSpan
from ropsim.simulation.station_run import StationRun

FAR = 50.0
"""Share of `in_position` from which on an arm that does not settle has lost its target."""


def move(run: CellRun, at: StationRun, instruction: MoveInstruction) -> Iterator[None]:
    """Plan a move and follow it until the arm is in position; what cannot be planned is skipped."""
    planned = plan_move(at.chain, instruction, at.q_command)
    since = at.tick
    if isinstance(planned, Refusal):
        run.findings.extend(planned.diagnostics)
        run.note(at, since, SkipEvent(*at.when(since), instruction.origin, motion=instruction.kind))
        return
    run.findings.extend(planned.findings)
    ordinal = len(at.moves)
    at.track("move", ordinal)
    at.follow(planned.reference)
    end, q_start = at.tick, at.q_command
    at.q_command = planned.q_end
    yield from _settle(run, at, instruction)
    settle = (at.tick - end) / at.hz
    X_MT = at.chain.tool_pose(instruction.modal)
    at.moves.append(MoveSpan(instruction, since, end, at.tick, q_start, planned.q_end, X_MT))
    at.track("move", -1)
    done = MoveEvent(
        *at.when(since),
        instruction.origin,
        motion=instruction.kind,
        ordinal=ordinal,
        travel=float(planned.duration),
        settle=settle,
        zone=float(instruction.modal.zone),
    )
    run.note(at, since, done)
    run.progress(f"move {sum(len(one.moves) for one in run.stations.values())}")


def _settle(run: CellRun, at: StationRun, move: MoveInstruction) -> Iterator[None]:
    """Stand until every joint is in position."""
    controller = at.station.controller
    start, limit = at.tick, round(controller.settle_timeout * at.hz)
    while bool((abs(at.plant.q - at.q_command) > controller.in_position).any()):
        if at.tick - start >= limit:
            run.findings.append(_not_in_position(at, move))
            break
        yield from at.stand(controller.rates.interpolation_ticks)
        if at.cut_short:
            break


def _not_in_position(at: StationRun, move: MoveInstruction) -> Diagnostic:
    controller = at.station.controller
    error = abs(at.plant.q - at.q_command)
    joint = int((error / controller.in_position).argmax())
    model = at.station.robot.axis_joints[joint]
    turns = model.measure is JointType.REVOLUTE
    scale, unit, sort = (180.0 / math.pi, "°", "rad") if turns else (1e3, " mm", "m")
    kind = FAR_FROM_TARGET if error[joint] > FAR * controller.in_position[joint] else NOT_IN_POSITION
    return kind.at(
        move.origin.span,
        f"joint `{model.name}` is {error[joint] * scale:.4g}{unit} from its target "
        f"after {controller.settle_timeout:g} s, "
        f"in position means {controller.in_position[joint] * scale:.4g}{unit}",
        label=f"pass {move.origin.visit}",
        hint="slow the move down, raise the integral gain `ki`, or widen `in_position` in the cell file",
        data={
            "pass": move.origin.visit,
            "joint": joint + 1,
            f"error_{sort}": float(error[joint]),
        },
    )
