"""What becomes of lowered procedures in a program: values at their start, lines, what is declared."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.icr import Type
from ropsim.program.diagnostics import without_value
from ropsim.program.lowering.expressions import zero_of
from ropsim.program.lowering.procedure import Lowered
from ropsim.program.lowering.shifting import shifted
from ropsim.program.program import Program
from ropsim.program.source_map import SourceMap
from ropsim.spatial import PoseTuple, quaternion


def draft_of(lowered: Lowered) -> icr.Procedure:
    """Return a procedure in which variables may be read before they have a value."""
    return icr.Procedure(
        lowered.name, lowered.parameters, lowered.locals + lowered.hidden, lowered.results, lowered.code
    )


def started(
    draft: icr.Procedure, needs: Sequence[icr.Need], variables: Mapping[str, Type], axes: int | None
) -> icr.Procedure:
    """Return a procedure that begins with giving values to the variables that would have none.

    Args:
        draft: the procedure.
        needs: variables that it may read before they have a value.
        variables: types of the global ones.
        axes: how many joint coordinates there are, None where nothing tells.
    """
    if not needs:
        return draft
    start = prologue(needs, _types(draft, variables), axes)
    return replace(draft, code=(*start, *shifted(draft.code, len(start))))


def prologue(needs: Sequence[icr.Need], types: Mapping[str, Type], axes: int | None) -> tuple[icr.Step, ...]:
    """Return what gives values to variables that would have none; see `started`."""
    start: list[icr.Step] = []
    for name in dict.fromkeys(need.slot.name for need in needs):  # in the order in which they are read
        start.append(icr.Step("PUSH", (zero_of(types[name], axes or 1),)))
        start.append(icr.Step("STORE", (name,)))
    return tuple(start)


def _types(procedure: icr.Procedure, variables: Mapping[str, Type]) -> Mapping[str, Type]:
    return {**variables, **{one.name: one.type for one in procedure.variables}}


def placed_lines(lowered: Lowered, procedure: icr.Procedure, places: SourceMap) -> tuple[int, ...]:
    """Return the source line of each instruction of a procedure, whose start no line has."""
    start = len(procedure.code) - len(lowered.code)
    return (0,) * start + places.lines(lowered.unit, lowered.lines)


def findings_of(
    lowered: Lowered, needs: Sequence[icr.Need], variables: Mapping[str, Type], places: SourceMap
) -> tuple[Diagnostic, ...]:
    """Return what the author should know of variables that may be read before they have a value."""
    own = {one.name: one.type for one in (*lowered.parameters, *lowered.locals)}
    hidden = {one.name for one in lowered.hidden}
    return tuple(
        without_value(
            places.source,
            places.lines(lowered.unit, (lowered.lines[need.at],))[0],
            need.slot.name,
            own.get(need.slot.name) or variables[need.slot.name],
        )
        for need in needs
        if need.slot.name not in hidden
    )


def axes_of(lowered: Iterable[Lowered]) -> int | None:
    """Return how many joint coordinates there are in a program, None where it has none."""
    every = list(lowered)
    told = next((one.axes for one in every if one.axes is not None), None)
    needs_one = any(one.has_guessed_axes for one in every)
    return told or (1 if needs_one else None)


def linked(
    program: Program, lowered: Sequence[Lowered], procedures: tuple[icr.Procedure, ...], source: str
) -> icr.Program:
    """Return the program of its procedures; it declares what they use and nothing else.

    Args:
        program: the structured program, for what it defines.
        lowered: its procedures, `main` first.
        procedures: the same, ready.
        source: name of the text to which source lines refer.
    """
    channels = {channel.name: channel for one in lowered for channel in one.channels}
    frames = dict.fromkeys(name for one in lowered for name in one.frames)
    tools = dict.fromkeys(name for one in lowered for name in one.tools)
    return icr.Program(
        program.name,
        procedures,
        capabilities=tuple(sorted({word for one in lowered for word in one.capabilities})),
        axes=_axes(lowered, procedures),
        variables=tuple(icr.Variable(one.name, one.type) for one in program.main_locals),
        channels=tuple(channels.values()),
        frames=tuple(icr.FrameDefinition(name, _canonical(program.frames[name])) for name in frames),
        tools=tuple(icr.ToolDefinition(name, _tool_pose(program, name)) for name in tools),
        source=source,
    )


def _axes(lowered: Sequence[Lowered], procedures: Sequence[icr.Procedure]) -> int | None:
    """Return how many joint coordinates the values of a program have, those of its starts among them."""
    found = axes_of(lowered)
    has_start = (
        len(ready.code) > len(one.code)
        and any(_is_joints(step) for step in ready.code[: len(ready.code) - len(one.code)])
        for one, ready in zip(lowered, procedures, strict=True)
    )
    return found if found is not None else (1 if any(has_start) else None)


def _is_joints(step: icr.Step) -> bool:
    constant = step.operands[0] if step.operands else None
    return isinstance(constant, icr.Constant) and constant.type is Type.JOINTS


def _tool_pose(program: Program, name: str) -> PoseTuple | None:
    return _canonical(program.tools[name]) if name in program.tools else None


def _canonical(pose: PoseTuple) -> PoseTuple:
    x, y, z, qw, qx, qy, qz = (float(number) for number in pose)
    return (x, y, z, *quaternion.normalize((qw, qx, qy, qz)))
