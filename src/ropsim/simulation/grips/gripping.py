"""Grips of a run: dwell, take or leave a part."""

from collections.abc import Iterator

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import GripAction, GripEvent, GripInstruction, ReleaseEvent
from ropsim.model import Fingers, Gripper, Part, Tool, tool_body
from ropsim.simulation.devices.axis_profile import AxisProfile, ProfileSegment
from ropsim.simulation.diagnostics.part_diagnostics import (
    NOTHING_GRASPED,
    TOOL_CANNOT_GRASP,
    WIDER_THAN_FINGERS,
)
from ropsim.simulation.grips.handing import kept, let_go, take_over
from ropsim.simulation.parts.parts import close_on, release
from ropsim.simulation.parts.placements import Placements
from ropsim.simulation.parts.standing import release_findings, stood
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun
from ropsim.spatial import Pose

_ROUNDING = 1e-6
"""Share by which a part may be wider than the stroke: both are rounded."""


def grip(run: CellRun, at: StationRun, instruction: GripInstruction) -> Iterator[None]:
    """Open or close a gripper; a part within its capture is taken, a held one is left where it is."""
    tool = at.station.tools.get(instruction.tool) if instruction.tool else at.tool
    since = at.tick
    if tool is None or tool.gripper is None:
        run.findings.append(_cannot_grasp(instruction, tool))
        return
    hand = tool_body(tool.name, at.station.name)
    _move_fingers(run, at, tool, instruction.action)
    if instruction.action is GripAction.OPEN:
        let_go(run, at, tool)
    yield from at.stand(round(_dwell(tool.gripper, instruction.action) * at.hz))
    if instruction.action is GripAction.CLOSE:
        taken = _picked_up(run, at, tool)
        take_over(run, at, tool, taken)
        run.take(at, at.tool, taken)
        part = run.parts.held({hand})
        if not part:
            run.findings.append(_nothing_grasped(instruction, tool))
        run.findings += _too_wide(run, at, tool, instruction)
        event: type[GripEvent | ReleaseEvent] = GripEvent
    else:
        part = run.parts.held({hand})
        run.take(at, at.tool, _put_down(run, at, hand, instruction))
        event = ReleaseEvent
    at.track("gripper", 1.0 if instruction.action is GripAction.CLOSE else 0.0)
    run.note(at, since, event(*at.when(since), instruction.origin, part=part))


def _dwell(gripper: Gripper, action: GripAction) -> float:
    return gripper.close_time if action is GripAction.CLOSE else gripper.open_time


def _move_fingers(run: CellRun, at: StationRun, tool: Tool, action: GripAction) -> None:
    """Let the fingers of a gripper go, on the part that is between them now where they close."""
    hand, fingers = tool_body(tool.name, at.station.name), tool.fingers
    if fingers is None or tool.gripper is None:
        return
    target = fingers.opened
    if action is GripAction.CLOSE:
        moment, parts = run.moment(at.due), _picked_up(run, at, tool)
        name = parts.held({hand})
        X_WT = moment.carriers[hand] @ tool.X_MT
        X_TO = X_WT.inverse() @ moment.pose(parts.seats[name]) if name else Pose()
        target = closed_on(fingers, run.scenery.parts.get(name), X_TO)
    go(at.fingers[hand], at.time, _dwell(tool.gripper, action), target)


def _picked_up(run: CellRun, at: StationRun, tool: Tool) -> Placements:
    """Return the placements after the fingers have closed; parts from a supply lie on present bodies."""
    hand = tool_body(tool.name, at.station.name)
    if run.parts.held({hand}):
        return run.parts
    moment = run.moment(at.due)
    taken = close_on(run.parts, run.cell, tool, hand, moment)
    come = tuple(name for name in taken.seats if name not in run.parts.seats)
    return stood(taken, come, run.scenery, run.cell.supports, moment)[0] if come else taken


def _put_down(run: CellRun, at: StationRun, hand: str, instruction: GripInstruction) -> Placements:
    """Return the placements after the part in a gripper is left, and note where that was wrong.

    A part on which another gripper is still closed hangs on that one again.
    """
    moment, part = run.moment(at.due), run.parts.held({hand})
    if held := kept(run, part, moment):
        return held
    left = release(run.parts, run.cell, {hand}, moment)
    if part not in left.seats:
        return left
    left, found = stood(left, (part,), run.scenery, run.cell.supports, moment)
    run.findings += release_findings(
        left, part, found[part], run.scenery, run.cell, moment, instruction.origin
    )
    return left


def _cannot_grasp(grip: GripInstruction, tool: Tool | None) -> Diagnostic:
    named = grip.tool or grip.modal.tool
    hint = "give the tool a `gripper` in cell.toml, or name another tool"
    if tool is not None:
        found = f"tool `{tool.name}` has no gripper"
    else:
        found = f"tool `{named}` is none of the cell's tools" if named else "no tool is in force"
        if not named:
            hint = "choose a tool with a gripper: `set tool NAME`, or `tool` of the station in cell.toml"
    return TOOL_CANNOT_GRASP.at(
        grip.origin.span,
        f"`{grip.action.value}` needs a gripper, but {found}",
        hint=hint,
        data=grip.origin.data,
    )


def _nothing_grasped(grip: GripInstruction, tool: Tool) -> Diagnostic:
    capture = tool.gripper.capture if tool.gripper else 0.0
    return NOTHING_GRASPED.at(
        grip.origin.span,
        f"no part within {capture * 1e3:g} mm of the TCP when the gripper closed",
        label=f"pass {grip.origin.visit}",
        hint="check the location, the supply of parts and the tool's `capture`",
        data=grip.origin.data,
    )


def _too_wide(run: CellRun, at: StationRun, tool: Tool, grip: GripInstruction) -> tuple[Diagnostic, ...]:
    """Return S726 where the part in a gripper does not fit between its fingers; once for each line."""
    moment, hand = run.moment(at.due), tool_body(tool.name, at.station.name)
    part = run.scenery.parts.get(run.parts.held({hand}))
    if part is None or tool.fingers is None:
        return ()
    X_TO = (moment.carriers[hand] @ tool.X_MT).inverse() @ moment.pose(run.parts.seats[part.name])
    width, stroke, span = width_between(part, X_TO), 2.0 * tool.fingers.opened, grip.origin.span
    known = any(one.code == WIDER_THAN_FINGERS.code and one.span == span for one in run.findings)
    if width <= stroke * (1.0 + _ROUNDING) or known:
        return ()
    finding = WIDER_THAN_FINGERS.at(
        span,
        f"part `{part.name}` is {width * 1e3:.4g} mm wide between the fingers of `{tool.name}`, "
        f"which open to {stroke * 1e3:.4g} mm",
        label=f"pass {grip.origin.visit}",
        hint="grip it across a narrower edge, or with a gripper of a greater stroke",
        data={"found_mm": width * 1e3, "allowed_mm": stroke * 1e3, **grip.origin.data},
    )
    return (finding,)


def width_between(part: Part, X_TO: Pose) -> float:
    """Return the edge of a part that lies nearest to the direction in which fingers close [m].

    Args:
        part: a box.
        X_TO: its object frame in the tool frame, along y of which fingers close.
    """
    return float(part.size[int(np.abs(X_TO.rotation()[1]).argmax())])


def go(profile: AxisProfile, time: float, dwell: float, target: float) -> None:
    """Let fingers go evenly to a coordinate [m] within the dwell [s] that begins at a time [s]."""
    q, _ = profile.at(time)
    segments = [ProfileSegment(time, q, (target - q) / dwell, 0.0)] if dwell > 0.0 else []
    profile.go([*segments, ProfileSegment(time + dwell, target, 0.0, 0.0)])


def closed_on(fingers: Fingers, part: Part | None, X_TO: Pose) -> float:
    """Return the coordinate of fingers that have closed [m]: on the sides of a part, or on nothing.

    Args:
        fingers: its fingers, apart along y of the tool frame.
        part: that they hold; None for nothing.
        X_TO: object frame of the part in the tool frame.
    """
    if part is None:
        return fingers.closed
    half = float(np.abs(X_TO.rotation()[1]) @ part.size / 2.0)
    return min(max(half, fingers.closed), fingers.opened)
