"""Grips of a run: dwell, take or leave a part."""

from ropsim.core import Diagnostic
from ropsim.flow import GripAction, GripEvent, GripInstruction, ReleaseEvent
from ropsim.model import Tool
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.diagnostics import NOTHING_GRASPED, TOOL_CANNOT_GRASP
from ropsim.simulation.parts import close_on, release
from ropsim.simulation.placements import Placements
from ropsim.simulation.standing import release_findings, stood


def grip(state: CellRun, instruction: GripInstruction) -> None:
    """Open or close a gripper; a part within its capture is taken, a held one is left where it is."""
    tool = state.cell.tools.get(instruction.tool) if instruction.tool else state.tool
    since = state.tick
    hz = state.cell.controller.rates.control_hz
    if tool is None or tool.gripper is None:
        state.findings.append(_cannot_grasp(instruction, tool))
        return
    held = state.parts.held
    if instruction.action is GripAction.CLOSE:
        state.stand(round(tool.gripper.close_time * hz))
        taken = close_on(state.parts, state.cell, tool, state.attained())
        come = tuple(name for name in taken.seats if name not in state.parts.seats)
        state.take(state.tool, stood(taken, come, state.scenery, state.cell.supports)[0] if come else taken)
        part = state.parts.held
        if not part:
            state.findings.append(_nothing_grasped(instruction, tool))
        event: type[GripEvent | ReleaseEvent] = GripEvent
    else:
        state.stand(round(tool.gripper.open_time * hz))
        part = held
        state.take(state.tool, _put_down(state, part, instruction))
        event = ReleaseEvent
    state.track("gripper", 1.0 if instruction.action is GripAction.CLOSE else 0.0)
    state.note(event(*state.when(since), instruction.origin, part=part))


def _put_down(state: CellRun, part: str, instruction: GripInstruction) -> Placements:
    """Return the placements after the part in the gripper is left, and note where that was wrong."""
    left = release(state.parts, state.cell, state.attained())
    if part not in left.seats:
        return left
    limits = state.cell.supports
    left, found = stood(left, (part,), state.scenery, limits)
    state.findings += release_findings(left, part, found[part], state.scenery, limits, instruction.origin)
    return left


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
