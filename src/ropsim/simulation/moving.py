"""Moves of a run: plan, follow, settle."""

import math

from ropsim.controller import Refusal, plan_move
from ropsim.core import Diagnostic
from ropsim.flow import MoveEvent, MoveInstruction, SkipEvent
from ropsim.model import JointType
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.diagnostics import FAR_FROM_TARGET, NOT_IN_POSITION
from ropsim.simulation.move_span import MoveSpan

FAR = 50.0
"""Share of `in_position` from which on an arm that does not settle has lost its target."""


def move(state: CellRun, instruction: MoveInstruction) -> None:
    """Plan a move and follow it until the arm is in position; what cannot be planned is skipped."""
    planned = plan_move(state.chain, instruction, state.q_command)
    since = state.tick
    if isinstance(planned, Refusal):
        state.findings.extend(planned.diagnostics)
        state.note(SkipEvent(*state.when(since), instruction.origin, motion=instruction.kind))
        return
    state.findings.extend(planned.findings)
    ordinal = len(state.moves)
    state.track("move", ordinal)
    state.follow(planned.reference)
    end, q_start = state.tick, state.q_command
    state.q_command = planned.q_end
    settle = _settle(state, instruction)
    state.moves.append(
        MoveSpan(
            instruction, since, end, state.tick, q_start, planned.q_end, state.chain.tool_pose(instruction)
        )
    )
    state.track("move", -1)
    state.note(
        MoveEvent(
            *state.when(since),
            instruction.origin,
            motion=instruction.kind,
            ordinal=ordinal,
            travel=planned.duration,
            settle=settle,
            zone=instruction.modal.zone,
        )
    )
    state.progress(f"move {ordinal + 1}")


def _settle(state: CellRun, move: MoveInstruction) -> float:
    """Stand until every joint is in position; return how long that took [s]."""
    controller = state.cell.controller
    start, limit = state.tick, round(controller.settle_timeout * controller.rates.control_hz)
    while bool((abs(state.plant.q - state.q_command) > controller.in_position).any()):
        if state.tick - start >= limit:
            state.findings.append(_not_in_position(state, move))
            break
        state.stand(controller.rates.interpolation_ticks)
        if state.cut_short:
            break
    return (state.tick - start) / controller.rates.control_hz


def _not_in_position(state: CellRun, move: MoveInstruction) -> Diagnostic:
    controller = state.cell.controller
    error = abs(state.plant.q - state.q_command)
    joint = int((error / controller.in_position).argmax())
    model = state.cell.robot.axis_joints[joint]
    scale, unit = (180.0 / math.pi, "°") if model.measure is JointType.REVOLUTE else (1e3, " mm")
    kind = FAR_FROM_TARGET if error[joint] > FAR * controller.in_position[joint] else NOT_IN_POSITION
    return kind.at(
        move.origin.span,
        f"joint `{model.name}` is {error[joint] * scale:.4g}{unit} from its target "
        f"after {controller.settle_timeout:g} s, "
        f"in position means {controller.in_position[joint] * scale:.4g}{unit}",
        label=f"pass {move.origin.visit}",
        hint="slow the move down, raise the integral gain `ki`, or widen `in_position` in the cell file",
        data={"pass": move.origin.visit, "joint": joint + 1, "error_rad": float(error[joint])},
    )
