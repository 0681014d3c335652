"""A whole program in a whole cell: interpreter, controller, drives, arm, parts.

`run` is the main loop; it reads like the generic controller's block diagram: the interpreter hands over
instructions, the slow side of the controller turns a move into joint references, the plant follows them.
"""

import math
from dataclasses import replace

from ropsim.controller import Refusal, plan_move
from ropsim.core import Diagnostic
from ropsim.flow import (
    GripAction,
    GripInstruction,
    Instruction,
    MessageInstruction,
    ModalState,
    MoveInstruction,
    OutputInstruction,
    Recording,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr import Finished, Machine, Program
from ropsim.model import Cell, JointType, Tool
from ropsim.simulation.cell_run import CellRun, MoveSpan
from ropsim.simulation.diagnostics import (
    NOT_IN_POSITION,
    NOTHING_GRASPED,
    RUN_TOO_LONG,
    TOOL_CANNOT_GRASP,
)
from ropsim.simulation.fidelity import RunOptions
from ropsim.simulation.parts import close_on, release
from ropsim.simulation.record import recording_of
from ropsim.simulation.servo_diagnostics import DivergedError
from ropsim.simulation.start import start_run
from ropsim.simulation.world import SimulatedWorld


def run(cell: Cell, program: Program, options: RunOptions) -> Recording:
    """Run a verified program in a cell and return the recording with all findings.

    A move that cannot be made becomes a finding on its source line and is skipped; the program goes on,
    so that one run shows every such line.

    Args:
        cell: static model.
        program: verified ICR.
        options: fidelity, rates of recording, progress.
    """
    state = start_run(cell, options)
    machine = Machine(program, _world(state, options))
    step = machine.advance()
    stopped_at: Instruction | None = None
    while not isinstance(step, Finished) and stopped_at is None:
        if state.time >= options.longest:
            stopped_at = step
            continue
        try:
            _carry_out(state, step)
            following = machine.advance()
        except DivergedError as error:
            raise DivergedError(_placed(error.diagnostic, step)) from error
        stopped_at = step if state.cut_short else None
        step = following
    if stopped_at is not None:
        state.findings.append(_too_long(stopped_at, options))
    elif isinstance(step, Finished) and step.trap is not None:
        state.findings.append(step.trap)
    return recording_of(state, program, options)


def _world(state: CellRun, options: RunOptions) -> SimulatedWorld:
    hz = state.cell.controller.rates.control_hz

    def stand(until: float) -> bool:
        state.stand(max(1, round(until * hz) - state.tick))
        return not state.cut_short

    return SimulatedWorld(
        options.sensors or state.sensors,
        lambda: state.time,
        stand,
        state.cell.controller.rates.interpolation_period,
    )


def _tool_in_force(cell: Cell, modal: ModalState) -> Tool | None:
    """Return the tool of the cell that is in force; None for the bare interface or a tool of the program."""
    return cell.tools.get(modal.tool or (cell.default_tool if modal.X_MT is None else ""))


def _placed(diagnostic: Diagnostic, step: Instruction) -> Diagnostic:
    """Return a finding of the servo at the source line and pass during which it came up."""
    label, data = f"pass {step.origin.visit}", {**diagnostic.data, "pass": step.origin.visit}
    return replace(diagnostic, span=step.origin.span, label=label, data=data)


def _too_long(step: Instruction, options: RunOptions) -> Diagnostic:
    return RUN_TOO_LONG.at(
        step.origin.span,
        f"the program still runs after {options.longest:g} s of simulated time, it was stopped here",
        label=f"pass {step.origin.visit}",
        hint="give the loop an end, or simulate fewer passes of it",
        data={"pass": step.origin.visit},
    )


def _carry_out(state: CellRun, step: Instruction) -> None:
    span = step.origin.span
    state.track("line", span.line if span else 0)
    state.take(_tool_in_force(state.cell, step.modal), state.parts)
    match step:
        case MoveInstruction():
            _move(state, step)
        case GripInstruction():
            _grip(state, step)
        case WaitInstruction():
            since = state.tick
            state.stand(round(step.duration * state.cell.controller.rates.control_hz))
            state.note("wait", f"wait {step.duration:g} s", step.origin, since)
        case OutputInstruction():
            state.sensors.set_output(step.channel, step.value)
            state.track(f"signal.{step.channel}", float(step.value))
            state.note(
                "output", f"{step.channel} = {step.value}", step.origin, state.tick, channel=step.channel
            )
        case MessageInstruction():
            state.note("message", step.text, step.origin, state.tick)
        case SyncInstruction():
            # A program that does nothing but look at channels must see time pass.
            if state.waiting:
                state.stand(state.cell.controller.rates.interpolation_ticks)
    state.waiting = isinstance(step, SyncInstruction)


def _move(state: CellRun, move: MoveInstruction) -> None:
    planned = plan_move(state.chain, move, state.q_command)
    since = state.tick
    if isinstance(planned, Refusal):
        state.findings.extend(planned.diagnostics)
        state.skipped += 1
        state.note("skip", f"{move.kind.value} not possible", move.origin, since, kind=move.kind.value)
        return
    state.findings.extend(planned.findings)
    ordinal = len(state.moves)
    state.track("move", ordinal)
    state.follow(planned.reference)
    end, q_start = state.tick, state.q_command
    state.q_command = planned.q_end
    settle = _settle(state, move)
    state.moves.append(
        MoveSpan(move, since, end, state.tick, q_start, planned.q_end, state.chain.tool_pose(move))
    )
    state.track("move", -1)
    state.note(
        "move",
        f"{move.kind.value} pass {move.origin.visit}",
        move.origin,
        since,
        kind=move.kind.value,
        ordinal=ordinal,
        settle=settle,
        travel=planned.duration,
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
    return (state.tick - start) / controller.rates.control_hz


def _not_in_position(state: CellRun, move: MoveInstruction) -> Diagnostic:
    controller = state.cell.controller
    error = abs(state.plant.q - state.q_command)
    joint = int((error / controller.in_position).argmax())
    model = state.cell.robot.joints[joint]
    scale, unit = (180.0 / math.pi, "°") if model.type is JointType.REVOLUTE else (1e3, " mm")
    return NOT_IN_POSITION.at(
        move.origin.span,
        f"joint `{model.name}` is {error[joint] * scale:.4g}{unit} from its target "
        f"after {controller.settle_timeout:g} s, "
        f"in position means {controller.in_position[joint] * scale:.4g}{unit}",
        label=f"pass {move.origin.visit}",
        hint="slow the move down, raise the integral gain `ki`, or widen `in_position` in the cell file",
        data={"pass": move.origin.visit, "joint": joint + 1, "error_rad": float(error[joint])},
    )


def _grip(state: CellRun, grip: GripInstruction) -> None:
    tool = state.cell.tools.get(grip.tool) if grip.tool else state.tool
    since = state.tick
    hz = state.cell.controller.rates.control_hz
    if tool is None or tool.gripper is None:
        state.findings.append(_cannot_grasp(grip, tool))
        return
    held = state.parts.grasp
    if grip.action is GripAction.CLOSE:
        state.stand(round(tool.gripper.close_time * hz))
        state.take(state.tool, close_on(state.parts, state.cell, tool, state.attained()))
        part = state.parts.grasp.part.name if state.parts.grasp else ""
        if not part:
            state.findings.append(_nothing_grasped(grip, tool))
        kind, text = "grip", f"close on {part}" if part else "close on nothing"
    else:
        state.stand(round(tool.gripper.open_time * hz))
        state.take(state.tool, release(state.parts, state.cell, state.attained()))
        part = held.part.name if held else ""
        kind, text = "release", f"release {part}" if part else "open"
    state.track("gripper", 1.0 if grip.action is GripAction.CLOSE else 0.0)
    state.track("payload", state.payload.mass)
    state.note(kind, text, grip.origin, since, part=part)


def _cannot_grasp(grip: GripInstruction, tool: Tool | None) -> Diagnostic:
    named = grip.tool or grip.modal.tool
    if tool is not None:
        found = f"tool `{tool.name}` has no gripper"
    else:
        found = f"tool `{named}` is none of the cell's tools" if named else "no tool is in force"
    return TOOL_CANNOT_GRASP.at(
        grip.origin.span,
        f"`{grip.action.value}` needs a gripper, but {found}",
        hint="give the tool a `gripper` in cell.toml, or name another tool",
        data={"pass": grip.origin.visit},
    )


def _nothing_grasped(grip: GripInstruction, tool: Tool) -> Diagnostic:
    capture = tool.gripper.capture if tool.gripper else 0.0
    return NOTHING_GRASPED.at(
        grip.origin.span,
        f"no part within {capture * 1e3:g} mm of the TCP when the gripper closed",
        label=f"pass {grip.origin.visit}",
        hint="check the location, the supply of parts and the tool's `capture`",
        data={"pass": grip.origin.visit},
    )
