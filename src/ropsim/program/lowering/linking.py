"""Linking of lowered procedures to a program: values at their start, lines, declarations."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from ropsim import icr
from ropsim.core import Diagnostic, maker
from ropsim.icr import Type
from ropsim.program.diagnostics import without_value
from ropsim.program.lowering.expressions import zero_of
from ropsim.program.lowering.procedure import Lowered
from ropsim.program.lowering.shifting import shifted
from ropsim.program.lowering.usage import Usage
from ropsim.program.program import Local, Program
from ropsim.program.source_map import SourceMap
from ropsim.spatial import PoseTuple, quaternion

_variable = maker(icr.Variable)


def draft_of(lowered: Lowered) -> icr.Procedure:
    """Return a procedure in which variables may be read before they have a value."""
    return icr.Procedure(
        lowered.name, lowered.parameters, lowered.locals + lowered.hidden, lowered.results, lowered.code
    )


def started(
    draft: icr.Procedure, needs: Sequence[icr.Need], variables: Mapping[str, Type], axes: int | None
) -> icr.Procedure:
    """Return a procedure that begins by initialising variables without a value.

    Args:
        draft: the procedure.
        needs: variables that it may read before they have a value.
        variables: types of the global ones.
        axes: number of joint coordinates, None if unknown.
    """
    if not needs:
        return draft
    start = prologue(needs, _types(draft, variables), axes)
    return replace(draft, code=(*start, *shifted(draft.code, len(start))))


def prologue(needs: Sequence[icr.Need], types: Mapping[str, Type], axes: int | None) -> tuple[icr.Step, ...]:
    """Return the steps that initialise variables without a value; see `started`."""
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
    """Return the findings on variables that may be read before they have a value."""
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


def axes_of(parts: Iterable[Lowered | Usage]) -> int | None:
    """Return the number of joint coordinates in a program, None without any."""
    every = list(parts)
    known_count = next((one.axes for one in every if one.axes is not None), None)
    needs_one = any(one.has_guessed_axes for one in every)
    return known_count or (1 if needs_one else None)


def axes_with_starts(axes: int | None, starts: Iterable[Sequence[icr.Step]]) -> int | None:
    """Return the number of joint coordinates of the values of a program, including those in its starts.

    Args:
        axes: the same without the starts.
        starts: initialising steps of procedures.
    """
    if axes is not None:
        return axes
    return 1 if any(_is_joints(step) for start in starts for step in start) else None


def declared_of(variables: Iterable[Local]) -> tuple[icr.Variable, ...]:
    """Return global variables as code declares them."""
    return tuple([_variable(one.name, one.type) for one in variables])


def linked(
    program: Program,
    usage: Usage,
    procedures: tuple[icr.Procedure, ...],
    axes: int | None,
    variables: tuple[icr.Variable, ...],
    source: str,
    libraries: tuple[icr.LibraryText, ...] = (),
) -> icr.Program:
    """Return the program of its procedures; it declares only entities that they use.

    Args:
        program: the structured program, for its definitions.
        usage: entities used by its procedures.
        procedures: `main` first.
        axes: how many joint coordinates its values have.
        variables: its global ones.
        source: name of the text to which source lines refer.
        libraries: texts of the procedures that come from elsewhere.
    """
    return icr.Program(
        program.name,
        procedures,
        capabilities=usage.capabilities,
        axes=axes,
        variables=variables,
        channels=usage.channels,
        frames=tuple(icr.FrameDefinition(name, _canonical(program.frames[name])) for name in usage.frames),
        tools=tuple(icr.ToolDefinition(name, _tool_pose(program, name)) for name in usage.tools),
        lists=tuple(
            icr.PoseList(name, program.lists[name], *program.places.get(name, ())) for name in usage.lists
        ),
        source=source,
        libraries=libraries,
    )


def _is_joints(step: icr.Step) -> bool:
    constant = step.operands[0] if step.operands else None
    return isinstance(constant, icr.Constant) and constant.type is Type.JOINTS


def _tool_pose(program: Program, name: str) -> PoseTuple | None:
    return _canonical(program.tools[name]) if name in program.tools else None


def _canonical(pose: PoseTuple) -> PoseTuple:
    x, y, z, qw, qx, qy, qz = (float(number) for number in pose)
    return (x, y, z, *quaternion.normalize((qw, qx, qy, qz)))
