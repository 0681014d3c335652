"""Static check of gripper contracts: abstract interpretation of the structured program.

Abstract states are open, closed and unknown; `None` stands for "no way leads here". Branches are joined,
loops are followed to a fixpoint, calls are followed with the state at the call (P. Cousot and R. Cousot,
"Abstract interpretation", POPL 1977).
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum

from ropsim.core import Diagnostic, Label, frozen_dataclass
from ropsim.flow import GripAction
from ropsim.program import statements as st
from ropsim.program.calls import callees_first
from ropsim.program.diagnostics import GRIPPER_STATE
from ropsim.program.expressions import Constant
from ropsim.program.move import Move, Settings
from ropsim.program.program import Contract, Program, Task
from ropsim.program.source_map import SourceMap
from ropsim.program.walk import walk


class _Gripper(Enum):
    OPEN = "open"
    CLOSED = "closed"
    UNKNOWN = "unknown"


_State = _Gripper | None
_Entry = tuple[str, _Gripper]
"""A task and the state in which it begins."""
_Place = tuple[str, int, int, str]
"""Source, line and column of a call, and the task."""
_AFTER = {GripAction.OPEN: _Gripper.OPEN, GripAction.CLOSE: _Gripper.CLOSED}


@dataclass(slots=True)
class _Flow:
    """The state where control is, and the states that leave by break, continue and return."""

    now: _State
    broken: _State = None
    continued: _State = None
    returned: _State = None


def check_contracts(program: Program, places: SourceMap | None = None) -> tuple[Diagnostic, ...]:
    """Return a warning for each call of a task whose gripper contract the state at the call contradicts.

    The state is that of the tool in force; where a program uses several tools, changing the tool makes it
    unknown. Each task is followed once from each state, callees first; of that counts what control reaches.
    """
    tasks = {task.name: task for task in program.tasks}
    if not any(contract.gripper for task in tasks.values() for contract in task.contracts):
        return ()
    check = _Check(tasks, len(_tools(program)) > 1)
    for name in callees_first(tasks):
        for state in _Gripper:
            check.passed[name, state] = check.passage(tasks[name].body, state)
    found: dict[_Place, Diagnostic] = {}
    work = [check.passage(program.main, _Gripper.UNKNOWN)]
    reached: set[_Entry] = set()
    while work:
        passage = work.pop()
        found |= {place: one for place, one in passage.found.items() if place not in found}
        work += [check.passed[entry] for entry in passage.entered if entry not in reached]
        reached |= passage.entered
    at = (places or SourceMap("")).finding
    return tuple(sorted(map(at, found.values()), key=_order))


def _order(finding: Diagnostic) -> tuple[str, int, int, str]:
    span = finding.span
    return (span.source, span.line, span.column, finding.message) if span is not None else ("", 0, 0, "")


def _tools(program: Program) -> set[str]:
    blocks = (program.main, *(task.body for task in program.tasks))
    statements = [statement for block in blocks for statement in walk(block)]
    named = {program.tool} | {one.tool for one in statements if isinstance(one, st.Grip)}
    changed = {one.settings.tool or "" for one in statements if isinstance(one, st.Set | st.With | Move)}
    return (named | changed) - {""}


@frozen_dataclass
class _Passage:
    """A block followed from one state: how it ends, what is found in it, and which tasks it enters how."""

    end: _State
    found: dict[_Place, Diagnostic]
    entered: set[_Entry]


@dataclass(slots=True)
class _Check:
    tasks: dict[str, Task]
    has_tools: bool
    passed: dict[_Entry, _Passage] = field(default_factory=dict)

    def passage(self, block: st.Block, state: _State) -> _Passage:
        """Follow a block from a state."""
        following = _Walk(self)
        flow = _Flow(state)
        following.block(block, flow)
        return _Passage(_join(flow.now, flow.returned), following.found, following.entered)


@dataclass(slots=True)
class _Walk:
    check: _Check
    found: dict[_Place, Diagnostic] = field(default_factory=dict)
    entered: set[_Entry] = field(default_factory=set)
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
        if settings.tool is not None and self.check.has_tools and flow.now is not None:
            flow.now = _Gripper.UNKNOWN

    def call(self, call: st.Call, state: _State) -> _State:
        task = self.check.tasks.get(call.task)
        if task is None or state is None:
            return _Gripper.UNKNOWN
        for contract, wanted in _wanted(task):
            if state in _AFTER.values() and state is not wanted:
                self.report(call, contract, state)
            state = wanted
        passed = self.check.passed.get((task.name, state))
        if passed is None:  # a task that calls itself
            return _Gripper.UNKNOWN
        self.entered.add((task.name, state))
        return passed.end

    def report(self, call: st.Call, contract: Contract, state: _Gripper) -> None:
        wanted = _AFTER[contract.gripper].value if contract.gripper else ""
        message = f"task `{call.task}` assumes the gripper {wanted}, it is {state.value} at this call"
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
