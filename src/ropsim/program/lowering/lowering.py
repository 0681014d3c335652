"""Structured program (SIR) -> ICR."""

from collections.abc import Callable

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.icr import Type, Variable
from ropsim.program import statements as st
from ropsim.program.calls import recursion
from ropsim.program.diagnostics import unsound, without_value
from ropsim.program.lowering import flow, robot
from ropsim.program.lowering.expressions import evaluate, push, zero
from ropsim.program.lowering.motion import lower_move
from ropsim.program.move import Move
from ropsim.program.program import Local, Program, Task
from ropsim.program.scope import Scope, Used
from ropsim.program.source_map import SourceMap
from ropsim.spatial import PoseTuple, quaternion


def lower(program: Program, source: str) -> icr.Program:
    """Return the ICR of a structured program; see `lower_with_findings`."""
    return lower_with_findings(program, source)[0]


def lower_with_findings(
    program: Program, source: str, places: SourceMap | None = None
) -> tuple[icr.Program, tuple[Diagnostic, ...]]:
    """Return the ICR of a structured program, which passes `icr.verify`, and what its author should know.

    The findings name variables that may be read before they have a value (T391, T392).

    Tasks that `main` does not reach are left out; the others stand in the order of their first call.
    Variables that could be read before they have a value start with the zero of their type.

    Args:
        program: a sound structured program without recursion.
        source: name of the text; statements whose span is in it record their line.
        places: where spans lie in it; None where they say so themselves.

    Raises:
        LoweringError: the program contradicts itself.
    """
    used = Used.by(program)
    scopes = _procedures(program, places or SourceMap(source), used)
    draft = _assembled(program, source, scopes, {})
    if recursion(program):
        return draft, ()
    starts = {}
    findings: tuple[Diagnostic, ...] = ()
    for name, needs in icr.unassigned(draft).items():
        scope = scopes[name]
        names = dict.fromkeys(need.slot.name for need in needs)  # in the order in which they are read
        starts[name] = tuple(step for one in names for step in _start(scope, one))
        seen = [
            (need.slot.name, scope.type_of(need.slot.name), need.at)
            for need in needs
            if need.slot.name not in scope.hidden
        ]
        findings += tuple(without_value(draft, name, *one) for one in seen)
    return (_assembled(program, source, scopes, starts) if starts else draft), findings


def _procedures(program: Program, source: SourceMap, used: Used) -> dict[str, Scope]:
    """Lower `main` and all that it reaches, depth first."""
    main = Scope(program, None, used, source, _block)
    if program.frame:
        main.emitter.emit("FRAME", main.frame(program.frame))
    if program.tool:
        robot.use_tool(main, program.tool)
        main.emitter.emit("TOOL", program.tool)
    _block(main, program.main)
    main.emitter.line = 0
    _end(main)
    scopes = {"main": main}
    work = list(reversed(main.callees))
    while work:
        task = main.callee(work.pop())
        name = _procedure_name(main, task.name)
        if name in scopes:
            continue
        scope = Scope(program, task, used, source, _block)
        _block(scope, task.body)
        if scope.emitter.is_live:
            if task.result is not None:
                scope.emitter.push(zero(scope, task.result))
            scope.emitter.line = 0
            scope.emitter.emit("RET")
        scopes[name] = scope
        work += reversed(scope.callees)
    return scopes


def _assembled(
    program: Program, source: str, scopes: dict[str, Scope], starts: dict[str, tuple[icr.Step, ...]]
) -> icr.Program:
    procedures = []
    used = scopes["main"].used
    for name, scope in scopes.items():
        code, lines = scope.emitter.finished(starts.get(name, ()))
        hidden = tuple(Variable(one, kind) for one, kind in scope.hidden.items())
        task = scope.task
        procedures.append(
            icr.Procedure(
                name,
                _variables(task.parameters) if task else (),
                (_variables(task.locals) if task else ()) + hidden,
                (task.result,) if task and task.result else (),
                code,
                lines,
            )
        )
    return icr.Program(
        program.name,
        tuple(procedures),
        capabilities=icr.capabilities(procedures),
        axes=used.axes,
        variables=_variables(program.main_locals),
        channels=tuple(used.channels.values()),
        frames=tuple(icr.FrameDefinition(name, _canonical(program.frames[name])) for name in used.frames),
        tools=tuple(icr.ToolDefinition(name, _tool_pose(program, name)) for name in used.tools),
        source=source,
    )


def _tool_pose(program: Program, name: str) -> PoseTuple | None:
    return _canonical(program.tools[name]) if name in program.tools else None


def _canonical(pose: PoseTuple) -> PoseTuple:
    x, y, z, qw, qx, qy, qz = (float(number) for number in pose)
    return (x, y, z, *quaternion.normalize((qw, qx, qy, qz)))


def _variables(variables: tuple[Local, ...]) -> tuple[Variable, ...]:
    return tuple(Variable(one.name, one.type) for one in variables)


def _start(scope: Scope, name: str) -> tuple[icr.Step, ...]:
    kind = scope.hidden.get(name) or scope.type_of(name)
    return icr.Step("PUSH", (zero(scope, kind),)), icr.Step("STORE", (name,))


def _procedure_name(scope: Scope, task: str) -> str:
    """Return the name of the procedure of a task; `main` is taken by the control statements."""
    name = task
    while name == "main" or (name != task and name in scope.used.tasks):
        name += "_"
    return name


def _end(scope: Scope) -> None:
    scope.emitter.emit("SYNC")
    scope.emitter.emit("HALT")


def _block(scope: Scope, block: st.Block) -> None:
    for statement in block:
        if not scope.emitter.is_live:
            return
        scope.emitter.line = scope.source.line(statement.span)
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
    scope.emitter.emit("CALL", _procedure_name(scope, task.name))
    if statement.result:
        if task.result is None:
            raise unsound(f"task `{task.name}` returns no value", statement.span)
        if task.result is Type.INT and scope.type_of(statement.result) is Type.REAL:
            scope.emitter.emit("I2R")
        scope.emitter.emit("STORE", statement.result)
    elif task.result is not None:
        scope.emitter.emit("POP")


def _with(scope: Scope, statement: st.With) -> None:
    if statement.settings.is_empty:
        _block(scope, statement.body)
        return
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
