"""One body: the inference pass that finds types, and the checking pass that reports errors."""

from collections.abc import Iterator, Mapping
from contextlib import suppress

from ropsim.language.blocks.clause import Clause
from ropsim.language.blocks.units import CONTROL, Items, of_task
from ropsim.language.check.calls.first_values import with_first_values
from ropsim.language.check.calls.tasks import TaskText
from ropsim.language.check.doubts import origins
from ropsim.language.check.doubts.near_names import near_names, seen_variables, unread_variables
from ropsim.language.check.expressions.expression import EXPRESSIONS
from ropsim.language.check.reached import late
from ropsim.language.check.scope import hidden
from ropsim.language.check.scope.body import Body, Told, settled
from ropsim.language.check.scope.types import POSE, Type, known
from ropsim.language.check.scope.world import Outcome, Signature, TaskOrigins, Variable, World
from ropsim.language.check.statements import structures
from ropsim.language.findings import hidden as hidden_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import Line
from ropsim.program import Block as StatementBlock
from ropsim.program import Call, Contract, If, Local, Return, Statement, Task, points_of, walk


def walked_task(world: World, task: TaskText, signature: Signature) -> Body:
    """Return a body after the inference pass, which infers types from use."""
    body = _enter(world, task, signature, None, _muted(of_task(task.name)))
    structures.walk(body, task.block.sections[0].body)
    return body


def walked_control(world: World, items: Items) -> Body:
    """Return the control statements after the inference pass."""
    body = Body(world, _muted(CONTROL), EXPRESSIONS, None)
    structures.walk(body, items)
    return body


def checked_task(world: World, task: TaskText, signature: Signature, types: Mapping[str, Type]) -> Outcome:
    """Return a checked task; `types` are the results of the inference pass."""
    report = Report(of_task(task.name))
    body = _enter(world, task, signature, types.get, report)
    made: Task | None = None
    with suppress(TooManyFindingsError):  # the list of the whole text will be full as well
        made = _task(body, task, signature)
    block = made.body if made is not None else ()
    return Outcome(
        block,
        made.locals if made is not None else (),
        made,
        tuple(with_first_values(report.log, body.unfit, body.made.values(), body.quantities, ())),
        tuple(unread_variables(body.made, body.read)),
        tuple(body.used_signals.values()),
        tuple((one.task, one.span) for one in walk(block) if isinstance(one, Call)),
        tuple(late(block)),
        points_of(block),
        TaskOrigins(body.readings, origins.joined(body.returned)),
    )


def _muted(unit: str) -> Report:
    report = Report(unit)
    report.muted = True
    return report


def _enter(world: World, task: TaskText, signature: Signature, told: Told | None, report: Report) -> Body:
    """Return the state at the start of a task: its parameters have values."""
    body = Body(world, report, EXPRESSIONS, told, task.name)
    body.references = signature.references
    body.result = signature.result
    body.is_tolerant = not signature.is_known
    for formal in signature.formals:
        body.enter(formal.name, known(formal.type))
    if signature.references and signature.references[0] == "l":
        body.names.setdefault("l1", Variable("l", POSE))
    body.line = task.block.opener
    return body


def _task(body: Body, task: TaskText, signature: Signature) -> Task:
    header_span = body.statement_span
    _check_hidden(body, task, signature)
    contracts = []
    for line, clause in task.clauses:
        body.line = line
        contracts.append(Contract(clause.gripper, clause.text, body.statement_span))
        _check_counts(body, task, signature, clause)
    block = structures.walk(body, task.block.sections[0].body)
    _check_near_names(body)
    body.line = task.block.opener
    is_open = (
        signature.result is not None
        and not body.has_gaps
        and task.block.closer is not None
        and not _always_returns(block)
    )
    if is_open and task.header is not None:
        body.warn(
            kinds.NO_RETURN,
            task.header,
            f"task `{task.name}` may end without `return`",
            "end it with `return value`",
        )
    parameters = tuple(Local(f.name, settled(f.type).value) for f in signature.formals)
    names = tuple(p.name for p in parameters)
    result = signature.result.value if signature.result is not None else None
    return Task(task.name, parameters, body.locals(names), result, block, tuple(contracts), header_span)


def _check_near_names(body: Body) -> None:
    def visible() -> Iterator[str]:
        return seen_variables({**body.world.symbols, **body.names})

    for name, found in list(near_names(body.made, body.read, visible)):
        body.report.add(found)
        del body.made[name]


def _check_hidden(body: Body, task: TaskText, signature: Signature) -> None:
    """Report parameters that have the name of something that the whole text sees."""
    if task.header is None:
        return
    places = {one.name.text: one.name for one in task.header.parameters or ()}
    for formal in signature.formals:
        taken = hidden.hidden_by_parameter(body.world, formal.name)
        if taken:
            message = f"parameter `{formal.name}` hides {taken} of that name in the whole task"
            hint = "rename the parameter"
            body.warn(hidden_kinds.HIDDEN, places.get(formal.name, task.header), message, hint)


def _check_counts(body: Body, task: TaskText, signature: Signature, clause: Clause) -> None:
    first = task.block.sections[0].body[:1]
    has_prose = bool(first) and isinstance(first[0], Line) and isinstance(first[0].statement, syntax.Broken)
    if has_prose or not signature.is_known:  # the variables that the line would have used are unknown
        return
    locations = sum(settled(f.type) == POSE for f in signature.formals)
    scalars = len(signature.formals) - locations
    for said, found, what in (
        (clause.locations, locations, "reference location"),
        (clause.parameters, scalars, "parameter"),
    ):
        if said is not None and said != found:
            listed = ", ".join(f"`{f.name}`" for f in signature.formals) or "none"
            message = f"the contract names {said} {what}{'' if said == 1 else 's'}, the body uses {found}"
            body.warn(
                kinds.CONTRACT_COUNTS, body.line, message, f"the parameters of `{task.name}` are {listed}"
            )


def _always_returns(block: StatementBlock) -> bool:
    last: Statement | None = block[-1] if block else None
    if isinstance(last, If):
        return bool(last.otherwise) and all(
            _always_returns(b) for b in (*(b for _, b in last.branches), last.otherwise)
        )
    return isinstance(last, Return)
