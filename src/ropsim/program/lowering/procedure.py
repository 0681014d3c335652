"""A task, or the control statements, to the code of one procedure."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import chain

from ropsim.core import frozen_dataclass, maker
from ropsim.icr import IoChannel, Procedure, Step, Type, Variable, capabilities
from ropsim.program import statements as st
from ropsim.program.diagnostics import unsound
from ropsim.program.lowering import flow, robot
from ropsim.program.lowering.expressions import evaluate, push, zero
from ropsim.program.lowering.motion import lower_move
from ropsim.program.lowering.shifting import shifted
from ropsim.program.move import Move
from ropsim.program.program import Local, Task
from ropsim.program.scope import Known, Scope, no_number

_variable = maker(Variable)

MAIN = "main"
"""Name of the procedure of the control statements."""


@frozen_dataclass
class Lowered:
    """A procedure, lowered independent of others.

    Attributes:
        name: of the procedure.
        task: name of the task, empty for the control statements.
        parameters: taken from the stack by CALL.
        locals: variables of the task.
        hidden: counters, limits and kept values that no statement names.
        results: types left on the stack.
        code: instructions.
        lines: line of each instruction in its unit, 0 where unknown.
        unit: name of the unit of the lines in spans.
        callees: tasks that it calls, in order.
        channels: that it uses.
        tools: that it uses, by name.
        frames: that it uses, by name.
        lists: of poses that it uses, by name.
        axes: how many joint coordinates its values have, None where there are none.
        has_guessed_axes: whether it has values of joint coordinates whose number only other procedures
            determine.
        capabilities: required capabilities of a robot.
        numbers: of the newest name in `hidden` of each purpose; of a part only.
        goes_on: whether control reaches the end of the code; of a part only.
    """

    name: str
    task: str
    parameters: tuple[Variable, ...]
    locals: tuple[Variable, ...]
    hidden: tuple[Variable, ...]
    results: tuple[Type, ...]
    code: tuple[Step, ...]
    lines: tuple[int, ...]
    unit: str
    callees: tuple[str, ...]
    channels: tuple[IoChannel, ...]
    tools: tuple[str, ...]
    frames: tuple[str, ...]
    lists: tuple[str, ...]
    axes: int | None
    has_guessed_axes: bool
    capabilities: tuple[str, ...]
    numbers: Mapping[str, int] = field(default_factory=dict)
    goes_on: bool = False


def lower_control(known: Known, block: st.Block, frame: str, tool: str) -> Lowered:
    """Return the procedure `main` of the control statements.

    Args:
        known: definitions of the program.
        block: the control statements.
        frame: name of the work frame, empty for the base frame.
        tool: in force at the start, empty for none.
    """
    part = lower_part(known, block)
    parts = (lower_start(known, frame, tool), part, *((lower_end(known),) if part.goes_on else ()))
    code = chain.from_iterable(one.code for one in placed_in_turn(parts))
    return joined(parts, tuple(code), tuple(chain.from_iterable(one.lines for one in parts)))


def placed_in_turn(parts: Iterable[Lowered]) -> Iterator[Lowered]:
    """Yield parts with jumps that lead to where their targets stand when the parts follow each other."""
    start = 0
    for one in parts:
        yield replace(one, code=shifted(one.code, start))
        start += len(one.code)


def lower_start(known: Known, frame: str, tool: str) -> Lowered:
    """Return the code before the control statements: their frame and the tool in force."""
    scope = Scope(known, None, "", _block)
    if frame:
        scope.emitter.emit("FRAME", scope.frame(frame))
    if tool:
        robot.use_tool(scope, tool)
        scope.emitter.emit("TOOL", tool)
    return _lowered(scope, MAIN)


def lower_part(known: Known, block: st.Block, first: Callable[[str], int] = no_number) -> Lowered:
    """Return the code of some of the control statements that follow each other.

    Args:
        known: definitions of the program.
        block: the statements.
        first: returns the number of the newest hidden name of a purpose before them, 0 for none.
    """
    scope = Scope(known, None, block[0].span.source if block else "", _block, first=first)
    _block(scope, block)
    return _lowered(scope, MAIN)


def lower_end(known: Known) -> Lowered:
    """Return the code behind the control statements."""
    scope = Scope(known, None, "", _block)
    _end(scope)
    return _lowered(scope, MAIN)


def joined(
    parts: Sequence[Lowered], code: tuple[Step, ...], lines: tuple[int, ...], unit: str = ""
) -> Lowered:
    """Return the procedure `main` of parts that follow each other.

    Args:
        parts: those.
        code: of all of them, in which jumps lead to where it stands.
        lines: of that.
        unit: name of the unit of the lines in spans, empty for that of the parts.
    """
    return Lowered(
        MAIN,
        "",
        (),
        (),
        tuple(one for part in parts for one in part.hidden),
        (),
        code,
        lines,
        unit or next((one.unit for one in parts if one.unit), ""),
        tuple(dict.fromkeys(one for part in parts for one in part.callees)),
        tuple({one.name: one for part in parts for one in part.channels}.values()),
        tuple(dict.fromkeys(one for part in parts for one in part.tools)),
        tuple(dict.fromkeys(one for part in parts for one in part.frames)),
        tuple(dict.fromkeys(one for part in parts for one in part.lists)),
        next((one.axes for one in parts if one.axes is not None), None),
        any(one.has_guessed_axes for one in parts),
        tuple(sorted({one for part in parts for one in part.capabilities})),
    )


def lower_task(known: Known, task: Task) -> Lowered:
    """Return the procedure of a task."""
    scope = Scope(known, task, task.span.source, _block)
    _block(scope, task.body)
    if scope.emitter.is_live:
        if task.result is not None:
            scope.emitter.push(zero(scope, task.result))
        scope.emitter.line = 0
        scope.emitter.emit("RET")
    return _lowered(scope, procedure_name(known, task.name))


def _lowered(scope: Scope, name: str) -> Lowered:
    code, lines = scope.emitter.finished()
    task, used = scope.task, scope.used
    return Lowered(
        name,
        task.name if task is not None else "",
        _variables(task.parameters) if task is not None else (),
        _variables(task.locals) if task is not None else (),
        tuple(Variable(one, kind) for one, kind in scope.hidden.items()),
        (task.result,) if task is not None and task.result is not None else (),
        code,
        lines,
        scope.unit,
        tuple(scope.callees),
        tuple(used.channels.values()),
        tuple(used.tools),
        tuple(used.frames),
        tuple(used.lists),
        used.axes,
        used.has_guessed_axes,
        capabilities((Procedure(name, code=code),)),
        scope.numbers,
        scope.emitter.is_live,
    )


def _variables(variables: tuple[Local, ...]) -> tuple[Variable, ...]:
    return tuple([_variable(one.name, one.type) for one in variables])


def procedure_name(known: Known, task: str) -> str:
    """Return the name of the procedure of a task; `main` is taken by the control statements."""
    name = task
    while name == "main" or (name != task and name in known.tasks):
        name += "_"
    return name


def _end(scope: Scope) -> None:
    scope.emitter.emit("SYNC")
    scope.emitter.emit("HALT")


def _block(scope: Scope, block: st.Block) -> None:
    for statement in block:
        if not scope.emitter.is_live:
            return
        scope.emitter.line = scope.line(statement.span)
        _STATEMENTS[type(statement)](scope, statement)


def _assign(scope: Scope, statement: st.Assign) -> None:
    evaluate(scope, statement.value, scope.type_of(statement.name))
    scope.emitter.emit("STORE", statement.name)


def _assign_component(scope: Scope, statement: st.AssignComponent) -> None:
    scope.emitter.emit("LOAD", statement.name)
    evaluate(scope, statement.value, Type.REAL)
    scope.emitter.emit("SETC", statement.index)
    scope.emitter.emit("STORE", statement.name)


def _call(scope: Scope, statement: st.Call) -> None:
    task: Task = scope.callee(statement.task)
    if len(statement.arguments) != len(task.parameters):
        found, allowed = len(statement.arguments), len(task.parameters)
        raise unsound(f"task `{task.name}` is given {found} arguments, it takes {allowed}", statement.span)
    for argument, parameter in zip(statement.arguments, task.parameters, strict=True):
        evaluate(scope, argument, parameter.type)
    scope.emitter.emit("CALL", procedure_name(scope.known, task.name))
    if statement.result:
        if task.result is None:
            raise unsound(f"task `{task.name}` returns no value", statement.span)
        if task.result is Type.INT and scope.type_of(statement.result) is Type.REAL:
            scope.emitter.emit("I2R")
        scope.emitter.emit("STORE", statement.result)
    elif task.result is not None:
        scope.emitter.emit("POP")


def _with(scope: Scope, statement: st.With) -> None:
    scope.emitter.emit("MODAL.SAVE")
    robot.lower_settings(scope, statement.settings)
    scope.depth += 1
    _block(scope, statement.body)
    scope.depth -= 1
    scope.emitter.emit("MODAL.RESTORE")


def _return(scope: Scope, statement: st.Return) -> None:
    if scope.task is None:
        _end(scope)
        return
    if scope.task.result is not None:
        result = scope.task.result
        if statement.value is None:
            scope.emitter.push(zero(scope, result))
        else:
            evaluate(scope, statement.value, result)
    for _ in range(scope.depth):
        scope.emitter.emit("MODAL.RESTORE")
    scope.emitter.emit("RET")


def _stop(scope: Scope, statement: st.Stop) -> None:
    if statement.message:
        push(scope, Type.STR, statement.message)
        scope.emitter.emit("MSG")
    scope.emitter.emit("HALT")


_STATEMENTS: dict[type, Callable[..., None]] = {
    Move: lower_move,
    st.Grip: robot.lower_grip,
    st.Output: robot.lower_output,
    st.Wait: robot.lower_wait,
    st.WaitUntil: robot.lower_wait_until,
    st.Message: robot.lower_message,
    st.Set: lambda scope, statement: robot.lower_settings(scope, statement.settings),
    st.Assign: _assign,
    st.AssignComponent: _assign_component,
    st.Call: _call,
    st.If: flow.lower_if,
    st.While: flow.lower_while,
    st.Repeat: flow.lower_repeat,
    st.For: flow.lower_for,
    st.Break: flow.leave_loop,
    st.Continue: flow.leave_loop,
    st.With: _with,
    st.Return: _return,
    st.Stop: _stop,
}
