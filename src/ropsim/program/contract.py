"""Static check of gripper contracts: abstract interpretation of the structured program.

Abstract states are open, closed and unknown; `None` stands for "no way leads here". Branches are joined,
loops are followed to a fixpoint, calls are followed with the state at the call (P. Cousot and R. Cousot,
"Abstract interpretation", POPL 1977).
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
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


class Gripper(Enum):
    """Known state of the gripper at a place of a program."""

    OPEN = "open"
    CLOSED = "closed"
    UNKNOWN = "unknown"


State = Gripper | None
"""None where control never is."""
_Entry = tuple[str, Gripper]
"""A task and the state in which it begins."""
_Place = tuple[str, int, int, str]
"""Source, line and column of a call, and the task."""
_AFTER = {GripAction.OPEN: Gripper.OPEN, GripAction.CLOSE: Gripper.CLOSED}


@frozen_dataclass
class GripperPassage:
    """A block followed from one state.

    Attributes:
        now: state behind its last statement.
        end: state behind it, also where it returns.
        found: findings, by the place of the call.
        entered: tasks that it calls, with the states in which they begin.
    """

    now: State
    end: State
    found: Mapping[_Place, Diagnostic]
    entered: frozenset[_Entry]


@frozen_dataclass
class GripperCalls:
    """Data of tasks that a block needs.

    Attributes:
        contracts: of a task, by its name; None for no task.
        passage: a task followed from a state; None for one that calls itself.
        has_tools: whether the program has several tools.
    """

    contracts: Callable[[str], tuple[Contract, ...] | None]
    passage: Callable[[str, Gripper], GripperPassage | None]
    has_tools: bool

    def followed(self, block: st.Block, state: State) -> GripperPassage:
        """Follow a block from a state."""
        following = _Walk(self)
        flow = _Flow(state)
        following.block(block, flow)
        end = _join(flow.now, flow.returned)
        return GripperPassage(flow.now, end, following.found, frozenset(following.entered))


@dataclass(slots=True)
class _Flow:
    """The state where control is, and the states that leave by break, continue and return."""

    now: State
    broken: State = None
    continued: State = None
    returned: State = None


def check_contracts(program: Program, places: SourceMap | None = None) -> tuple[Diagnostic, ...]:
    """Return a warning for each call of a task whose gripper contract the state at the call contradicts.

    The state is that of the tool in force; where a program uses several tools, changing the tool makes it
    unknown. Each task is followed once from each state, callees first; only reachable code counts.
    """
    tasks = {task.name: task for task in program.tasks}
    if not any(has_gripper_contract(task) for task in tasks.values()):
        return ()
    passed: dict[_Entry, GripperPassage] = {}
    blocks = (program.main, *(task.body for task in program.tasks))
    calls = GripperCalls(
        lambda name: tasks[name].contracts if name in tasks else None,
        lambda name, state: passed.get((name, state)),
        has_several_tools((program.tool, *(tool for block in blocks for tool in tools_in(block)))),
    )
    for name in callees_first(tasks):
        for state in Gripper:
            passed[name, state] = calls.followed(tasks[name].body, state)
    main = calls.followed(program.main, Gripper.UNKNOWN)
    return in_order(contract_findings(main, lambda name, state: passed[name, state]), places or SourceMap(""))


def has_gripper_contract(task: Task) -> bool:
    """Return whether a task says in which state the gripper must be."""
    return any(contract.gripper for contract in task.contracts)


def contract_findings(
    main: GripperPassage, passage: Callable[[str, Gripper], GripperPassage]
) -> tuple[Diagnostic, ...]:
    """Return the findings in reachable code, places as in the statements.

    Args:
        main: the control statements, followed.
        passage: a task followed from a state.
    """
    found: dict[_Place, Diagnostic] = {}
    work = [main]
    reached: set[_Entry] = set()
    while work:
        one = work.pop()
        found |= {place: wrong for place, wrong in one.found.items() if place not in found}
        work += [passage(*entry) for entry in one.entered if entry not in reached]
        reached |= one.entered
    return tuple(found.values())


def in_order(findings: Iterable[Diagnostic], places: SourceMap) -> tuple[Diagnostic, ...]:
    """Return findings where they lie in the text, in order of their places."""
    return tuple(sorted(map(places.finding, findings), key=_order))


def _order(finding: Diagnostic) -> tuple[str, int, int, str]:
    span = finding.span
    return (span.source, span.line, span.column, finding.message) if span is not None else ("", 0, 0, "")


def has_several_tools(named: Iterable[str]) -> bool:
    """Return whether there are several tools among names, of which empty ones are none."""
    return len({*named} - {""}) > 1


def tools_in(block: st.Block) -> frozenset[str]:
    """Return the tools that a block names; the empty name where it names none."""
    statements = [*walk(block)]
    named = {one.tool for one in statements if isinstance(one, st.Grip)}
    changed = {one.settings.tool or "" for one in statements if isinstance(one, st.Set | st.With | Move)}
    return frozenset(named | changed)


@dataclass(slots=True)
class _Walk:
    calls: GripperCalls
    found: dict[_Place, Diagnostic] = field(default_factory=dict)
    entered: set[_Entry] = field(default_factory=set)
    loops: dict[tuple[int, State], _Flow] = field(default_factory=dict)

    def block(self, block: st.Block, flow: _Flow) -> None:
        """Carry the state through a block; statements behind an exit are skipped."""
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
        end: State = None
        start = flow.now
        for block in blocks:
            flow.now = start
            self.block(block, flow)
            end = _join(end, flow.now)
        flow.now = end

    def loop(self, statement: st.While | st.For | st.Repeat, flow: _Flow) -> None:
        # The first round with the state at the entry is exactly the first pass, so its findings are valid.
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

    def round(self, statement: st.While | st.For | st.Repeat, head: State) -> _Flow:
        inner = _Flow(head)
        self.block(statement.body, inner)
        return inner

    def tool(self, settings: Settings, flow: _Flow) -> None:
        if settings.tool is not None and self.calls.has_tools and flow.now is not None:
            flow.now = Gripper.UNKNOWN

    def call(self, call: st.Call, state: State) -> State:
        contracts = self.calls.contracts(call.task)
        if contracts is None or state is None:
            return Gripper.UNKNOWN
        for contract, wanted in _wanted(contracts):
            if state in _AFTER.values() and state is not wanted:
                self.report(call, contract, state)
            state = wanted
        passed = self.calls.passage(call.task, state)
        if passed is None:  # a task that calls itself
            return Gripper.UNKNOWN
        self.entered.add((call.task, state))
        return passed.end

    def report(self, call: st.Call, contract: Contract, state: Gripper) -> None:
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


def _wanted(contracts: tuple[Contract, ...]) -> Iterator[tuple[Contract, Gripper]]:
    for contract in contracts:
        if contract.gripper is not None:
            yield contract, _AFTER[contract.gripper]


def _join(one: State, other: State) -> State:
    if one is None or other is None or one is other:
        return other if one is None else one
    return Gripper.UNKNOWN


def _runs_at_least_once(statement: st.While | st.For | st.Repeat) -> bool:
    if not isinstance(statement, st.Repeat):
        return False
    count = statement.count
    if isinstance(count, Constant) and isinstance(count.value, int | float):
        return count.value >= 1
    return count is None and statement.until is not None


def _is_endless(statement: st.While | st.For | st.Repeat) -> bool:
    return isinstance(statement, st.Repeat) and statement.count is None and statement.until is None
