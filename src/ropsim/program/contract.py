"""Static check of gripper contracts: abstract interpretation of the structured program.

Abstract states are open, closed and unknown; `None` stands for "no way leads here". Branches are joined,
loops are followed to a fixpoint, calls are followed with the state at the call (P. Cousot and R. Cousot,
"Abstract interpretation", POPL 1977).
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum

from ropsim.core import Diagnostic, Label
from ropsim.flow import GripAction
from ropsim.program import statements as st
from ropsim.program.diagnostics import GRIPPER_STATE
from ropsim.program.expressions import Constant
from ropsim.program.move import Move, Settings
from ropsim.program.program import Contract, Program, Task
from ropsim.program.walk import walk


class _Gripper(Enum):
    OPEN = "open"
    CLOSED = "closed"
    UNKNOWN = "unknown"


_State = _Gripper | None
_AFTER = {GripAction.OPEN: _Gripper.OPEN, GripAction.CLOSE: _Gripper.CLOSED}


@dataclass(slots=True)
class _Flow:
    """The state where control is, and the states that leave by break, continue and return."""

    now: _State
    broken: _State = None
    continued: _State = None
    returned: _State = None


def check_contracts(program: Program) -> tuple[Diagnostic, ...]:
    """Return a warning for each call of a task whose gripper contract the state at the call contradicts.

    The state is that of the tool in force; where a program uses several tools, changing the tool makes it
    unknown.
    """
    check = _Check({task.name: task for task in program.tasks}, len(_tools(program)) > 1)
    check.block(program.main, _Flow(_Gripper.UNKNOWN))
    found = sorted(check.found.items(), key=lambda item: item[0])
    return tuple(diagnostic for _, diagnostic in found)


def _tools(program: Program) -> set[str]:
    blocks = (program.main, *(task.body for task in program.tasks))
    statements = [statement for block in blocks for statement in walk(block)]
    named = {program.tool} | {one.tool for one in statements if isinstance(one, st.Grip)}
    changed = {one.settings.tool or "" for one in statements if isinstance(one, st.Set | st.With | Move)}
    return (named | changed) - {""}


@dataclass(slots=True)
class _Check:
    tasks: dict[str, Task]
    has_tools: bool
    found: dict[tuple[str, int, int, str], Diagnostic] = field(default_factory=dict)
    results: dict[tuple[str, _State], _State] = field(default_factory=dict)
    loops: dict[tuple[int, _State], _Flow] = field(default_factory=dict)

    def block(self, block: st.Block, flow: _Flow) -> None:
        """Carry the state through a block; what follows a way out is not looked at."""
        for statement in block:
            if flow.now is None:
                return
            self.statement(statement, flow)

    def statement(self, statement: st.Statement, flow: _Flow) -> None:
        match statement:
            case st.Grip():
                flow.now = _AFTER[statement.action]
            case st.Call():
                flow.now = self.call(statement, flow.now)
            case st.If():
                self.branches([*(block for _, block in statement.branches), statement.otherwise], flow)
            case st.WaitUntil():
                ends = () if statement.timeout is None or not statement.otherwise else (statement.otherwise,)
                self.branches([(), *ends], flow)
            case st.While() | st.For() | st.Repeat():
                self.loop(statement, flow)
            case st.With():
                self.tool(statement.settings, flow)
                self.block(statement.body, flow)
                self.tool(statement.settings, flow)
            case st.Set():
                self.tool(statement.settings, flow)
            case st.Break():
                flow.broken, flow.now = _join(flow.broken, flow.now), None
            case st.Continue():
                flow.continued, flow.now = _join(flow.continued, flow.now), None
            case st.Return():
                flow.returned, flow.now = _join(flow.returned, flow.now), None
            case st.Stop():
                flow.now = None
            case _:
                pass

    def branches(self, blocks: list[st.Block], flow: _Flow) -> None:
        end: _State = None
        start = flow.now
        for block in blocks:
            flow.now = start
            self.block(block, flow)
            end = _join(end, flow.now)
        flow.now = end

    def loop(self, statement: st.While | st.For | st.Repeat, flow: _Flow) -> None:
        # The first round with the state at the entry is exactly the first pass, so what it finds is true.
        key = (id(statement), flow.now)
        if key not in self.loops:
            head = flow.now
            inner = self.round(statement, head)
            while (joined := _join(head, _join(inner.now, inner.continued))) is not head:
                head = joined
                earlier, inner = inner, self.round(statement, head)
                inner.returned = _join(inner.returned, earlier.returned)
            again = _join(inner.now, inner.continued)
            end = again if _runs_at_least_once(statement) else None if _is_endless(statement) else head
            self.loops[key] = _Flow(_join(end, inner.broken), returned=inner.returned)
        after = self.loops[key]
        flow.now, flow.returned = after.now, _join(flow.returned, after.returned)

    def round(self, statement: st.While | st.For | st.Repeat, head: _State) -> _Flow:
        inner = _Flow(head)
        self.block(statement.body, inner)
        return inner

    def tool(self, settings: Settings, flow: _Flow) -> None:
        if settings.tool is not None and self.has_tools and flow.now is not None:
            flow.now = _Gripper.UNKNOWN

    def call(self, call: st.Call, state: _State) -> _State:
        task = self.tasks.get(call.task)
        if task is None:
            return _Gripper.UNKNOWN
        for contract, wanted in _wanted(task):
            if state in _AFTER.values() and state is not wanted:
                self.report(call, contract, state)
            state = wanted
        key = (task.name, state)
        if key not in self.results:
            self.results[key] = _Gripper.UNKNOWN  # what a task that calls itself sees
            flow = _Flow(state)
            self.block(task.body, flow)
            self.results[key] = _join(flow.now, flow.returned)
        return self.results[key]

    def report(self, call: st.Call, contract: Contract, state: _State) -> None:
        wanted = _AFTER[contract.gripper].value if contract.gripper else ""
        found = state.value if state else ""
        message = f"task `{call.task}` assumes the gripper {wanted}, it is {found} at this call"
        verb = contract.gripper.value if contract.gripper else ""
        key = (call.span.source, call.span.line, call.span.column, call.task)
        self.found.setdefault(
            key,
            GRIPPER_STATE.at(
                call.span,
                message,
                hint=f"`{verb}` before the call",
                secondary=(Label(contract.span, "assumed here"),),
            ),
        )


def _wanted(task: Task) -> Iterator[tuple[Contract, _Gripper]]:
    for contract in task.contracts:
        if contract.gripper is not None:
            yield contract, _AFTER[contract.gripper]


def _join(one: _State, other: _State) -> _State:
    if one is None or other is None or one is other:
        return other if one is None else one
    return _Gripper.UNKNOWN


def _runs_at_least_once(statement: st.While | st.For | st.Repeat) -> bool:
    if not isinstance(statement, st.Repeat):
        return False
    count = statement.count
    if isinstance(count, Constant) and isinstance(count.value, int | float):
        return count.value >= 1
    return count is None and statement.until is not None


def _is_endless(statement: st.While | st.For | st.Repeat) -> bool:
    return isinstance(statement, st.Repeat) and statement.count is None and statement.until is None
