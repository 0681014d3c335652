"""Settings, gripper, signals, messages -> ICR."""

from ropsim.icr import TRAP_TIMED_OUT, Type
from ropsim.program import expressions as sir
from ropsim.program import statements as st
from ropsim.program.emitter import Label
from ropsim.program.lowering.expressions import evaluate, push, static_type
from ropsim.program.move import Settings
from ropsim.program.scope import Scope
from ropsim.program.walk import signals_of

POLL_PERIOD = 0.004
"""How often a condition is tested that is no plain input [s]; the usual tick of robot controllers."""
_SETTINGS = (
    ("path_speed", "SPD.LIN"),
    ("ptp_speed", "SPD.PTP"),
    ("orientation_speed", "SPD.ORI"),
    ("path_acceleration", "ACC.LIN"),
    ("ptp_acceleration", "ACC.PTP"),
)


def lower_settings(scope: Scope, settings: Settings) -> None:
    """Emit the modal instructions of settings."""
    if settings.tool is not None:
        use_tool(scope, settings.tool)
        scope.emitter.emit("TOOL", settings.tool)
    for field, mnemonic in _SETTINGS:
        value: sir.Expression | None = getattr(settings, field)
        if value is not None:
            evaluate(scope, value, Type.REAL)
            scope.emitter.emit(mnemonic)
    zone = settings.zone
    if isinstance(zone, sir.Constant) and zone.value == 0:
        scope.emitter.emit("ZONE.FINE")
    elif zone is not None:
        evaluate(scope, zone, Type.REAL)
        scope.emitter.emit("ZONE.DIST")


def use_tool(scope: Scope, tool: str) -> None:
    """Note that a tool is used."""
    if tool:
        scope.used.tools.setdefault(tool)


def lower_grip(scope: Scope, grip: st.Grip) -> None:
    """Emit a GRIP."""
    use_tool(scope, grip.tool)
    scope.emitter.emit("GRIP", grip.action.value, grip.tool)


def lower_output(scope: Scope, output: st.Output) -> None:
    """Emit an OUT."""
    channel = scope.channel(output.signal)
    evaluate(scope, output.value, channel.type)
    scope.emitter.emit("OUT", channel.name)


def lower_wait(scope: Scope, wait: st.Wait) -> None:
    """Emit a WAIT.T."""
    evaluate(scope, wait.duration, Type.REAL)
    scope.emitter.emit("WAIT.T")


def lower_wait_until(scope: Scope, wait: st.WaitUntil) -> None:
    """Emit WAIT.IN where a digital signal is waited for, else a loop that tests the condition."""
    holds = Label()
    simple = _plain_signal(scope, wait.condition)
    if not simple and wait.timeout is not None and not any(signals_of(wait.condition)):
        # nothing changes it while the program waits
        evaluate(scope, wait.condition, Type.BOOL)
        scope.emitter.jump("JT", holds)
        evaluate(scope, wait.timeout, Type.REAL)
        scope.emitter.emit("WAIT.T")
    elif simple:
        name, value = simple
        push(scope, Type.BOOL, value)
        lower_timeout(scope, wait.timeout)
        scope.emitter.emit("WAIT.IN", name)
        if wait.timeout is None:
            scope.emitter.emit("POP")
            return
        scope.emitter.jump("JT", holds)
    elif wait.timeout is None:
        _poll(scope, wait.condition, holds, "")
    else:
        deadline = scope.hide("deadline", Type.REAL)
        scope.emitter.emit("TIME")
        evaluate(scope, wait.timeout, Type.REAL)
        scope.emitter.emit("ADD.R")
        scope.emitter.emit("STORE", deadline)
        _poll(scope, wait.condition, holds, deadline)
    if wait.timeout is not None:
        scope.lower_block(scope, wait.otherwise)
        scope.emitter.line = scope.line(wait.span)
        if not wait.otherwise:
            scope.emitter.emit("TRAP", TRAP_TIMED_OUT)
    scope.emitter.place(holds)


def lower_message(scope: Scope, message: st.Message) -> None:
    """Emit a MSG of the values, joined by blanks."""
    _text(scope, message.parts)
    scope.emitter.emit("MSG")


def _text(scope: Scope, parts: tuple[sir.Expression, ...]) -> None:
    if not parts:
        push(scope, Type.STR, "")
    for number, part in enumerate(parts):
        if number:
            push(scope, Type.STR, " ")
            scope.emitter.emit("CAT")
        kind = static_type(scope, part)
        evaluate(scope, part, kind)
        if kind is not Type.STR:
            scope.emitter.emit("FMT")
        if number:
            scope.emitter.emit("CAT")


def _plain_signal(scope: Scope, condition: sir.Expression) -> tuple[str, bool] | None:
    """Return channel and value where the condition compares one digital signal with a constant.

    It may be an output: another station sets it.
    """
    match condition:
        case sir.SignalValue(name=name) if scope.channel(name).kind in ("DI", "DO"):
            return name, True
        case sir.Unary(op="not", operand=operand):
            inner = _plain_signal(scope, operand)
            return (inner[0], not inner[1]) if inner else None
        case sir.Binary(op="eq" | "ne", left=left, right=sir.Constant(value=bool() as value)):
            inner = _plain_signal(scope, left)
            is_same = value is (condition.op == "eq")
            return (inner[0], inner[1] is is_same) if inner else None
        case _:
            return None


def lower_timeout(scope: Scope, timeout: sir.Expression | None) -> None:
    """Emit the timeout of WAIT.IN or GUARD [s], where 0 is none: less than a tick becomes a tick."""
    if timeout is None:
        push(scope, Type.REAL, 0.0)
        return
    evaluate(scope, timeout, Type.REAL)
    if not (isinstance(timeout, sir.Constant) and isinstance(timeout.value, float) and timeout.value > 0.0):
        push(scope, Type.REAL, POLL_PERIOD)
        scope.emitter.emit("MAX.R")


def _poll(scope: Scope, condition: sir.Expression, holds: Label, deadline: str) -> None:
    again, late = Label(), Label()
    scope.emitter.place(again)
    evaluate(scope, condition, Type.BOOL)
    scope.emitter.jump("JT", holds)
    if deadline:
        scope.emitter.emit("TIME")
        scope.emitter.emit("LOAD", deadline)
        scope.emitter.emit("GE.R")
        scope.emitter.jump("JT", late)
    push(scope, Type.REAL, POLL_PERIOD)
    scope.emitter.emit("WAIT.T")
    scope.emitter.jump("JMP", again)
    scope.emitter.place(late)
