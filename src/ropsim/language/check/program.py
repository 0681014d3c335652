"""The whole text: signatures callee first, then every body twice (types first, findings second)."""

from collections.abc import Mapping
from dataclasses import dataclass

from ropsim.language.blocks import Block
from ropsim.language.check import declarations, hidden, signatures, structures
from ropsim.language.check.body import Body, settled
from ropsim.language.check.expressions import EXPRESSIONS
from ropsim.language.check.near_names import check_near_names, check_unread
from ropsim.language.check.tasks import TaskText, callee_first, control_statements, tasks_of
from ropsim.language.check.types import POSE, Type, known
from ropsim.language.check.world import Poison, Signature, Variable, World
from ropsim.language.clause import Clause
from ropsim.language.environment import Environment
from ropsim.language.findings import hidden as hidden_kinds
from ropsim.language.findings import syntax as syntax_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.report import Report
from ropsim.language.syntax import statements as syntax
from ropsim.language.task_form import TaskForm
from ropsim.language.text import Line
from ropsim.program import Block as StatementBlock
from ropsim.program import Contract, If, Local, Program, Return, Statement, Task

_MAIN = ""


@dataclass(frozen=True, slots=True)
class Checked:
    """The structured program of all right lines, how its tasks are called, and the types of variables."""

    program: Program
    tasks: Mapping[str, TaskForm]
    variables: Mapping[str, Mapping[str, str]]


def check(tree: tuple[Line | Block, ...], environment: Environment, report: Report) -> Checked:
    """Return the structured program of all lines that are right; the others are reported."""
    world = declarations.world(tree, environment, report)
    tasks = tasks_of(tree, report)
    for name, library in environment.tasks.items():
        world.signatures.setdefault(name, signatures.of_library(library))
    order = callee_first(tasks)
    callable_names = frozenset(tasks) | frozenset(environment.tasks)
    for name in order:
        world.signatures[name] = signatures.of_text(world, tasks[name], callable_names, report)
    settled_types = _find_types(world, tasks, order, tree, report)
    checked: list[Body] = []
    bodies = {name: _task(world, tasks[name], settled_types[name], report, checked) for name in order}
    main_body = Body(world, report, EXPRESSIONS, settled_types[_MAIN])
    main = structures.walk(main_body, control_statements(tree))
    check_near_names(main_body)
    if not report.has_errors:
        for body in (*checked, main_body):
            check_unread(body)
    if not main:
        _report_empty(tree, tasks, report)
    library_tasks = tuple(t.task for n, t in environment.tasks.items() if n not in tasks)
    program = Program(
        _program_name(tree),
        main,
        (*_globals(world), *main_body.locals(())),
        (*(bodies[name] for name in tasks), *library_tasks),
        world.frame,
        dict(world.frames),
        dict(world.tools),
        environment.default_tool,
        tuple(world.used_signals.values()),
    )
    forms = {name: signatures.form_of(one, world.units) for name, one in world.signatures.items()}
    return Checked(program, forms, _types_in_words(world, settled_types))


def _find_types(
    world: World,
    tasks: Mapping[str, TaskText],
    order: list[str],
    tree: tuple[Line | Block, ...],
    report: Report,
) -> dict[str, Mapping[str, Type]]:
    """Walk through all bodies once, silently, and return the types that use has told."""
    report.muted = True
    bodies: dict[str, Body] = {}
    for name in order:
        bodies[name] = _enter(world, tasks[name], None, report)
        structures.walk(bodies[name], tasks[name].block.sections[0].body)
    bodies[_MAIN] = Body(world, report, EXPRESSIONS, None)
    structures.walk(bodies[_MAIN], control_statements(tree))
    report.muted = False
    found = {name: body.types() for name, body in bodies.items()}
    for name, signature in world.signatures.items():
        world.signatures[name] = signatures.final(world, tasks.get(name), signature, report)
    for name, symbol in world.symbols.items():
        if isinstance(symbol, Variable):
            world.symbols[name] = Variable(symbol.name, settled(symbol.type), symbol.is_fixed)
    world.used_signals.clear()
    return dict(found)


def _types_in_words(world: World, found: Mapping[str, Mapping[str, Type]]) -> Mapping[str, Mapping[str, str]]:
    """Return the types of all variables by task; those that all tasks see are with the control statements."""
    seen = {n: settled(s.type) for n, s in world.symbols.items() if isinstance(s, Variable)}
    types = {**found, _MAIN: {**seen, **found[_MAIN]}}
    return {
        task: {name: signatures.word_of(kind) for name, kind in of_task.items()}
        for task, of_task in types.items()
    }


def _enter(world: World, task: TaskText, types: Mapping[str, Type] | None, report: Report) -> Body:
    """Return the state at the start of a task: its parameters have values."""
    signature = world.signatures[task.name]
    body = Body(world, report, EXPRESSIONS, types, task.name)
    body.references = signature.references
    body.result = signature.result
    body.is_tolerant = not signature.is_known
    for formal in signature.formals:
        body.enter(formal.name, known(formal.type))
    if signature.references and signature.references[0] == "l":
        body.names.setdefault("l1", Variable("l", POSE))
    body.line = task.block.opener
    return body


def _task(
    world: World, task: TaskText, types: Mapping[str, Type], report: Report, checked: list[Body]
) -> Task:
    signature = world.signatures[task.name]
    body = _enter(world, task, types, report)
    header_span = body.statement_span
    _check_hidden(body, task, signature)
    contracts = []
    for line, clause in task.clauses:
        body.line = line
        contracts.append(Contract(clause.gripper, clause.text, body.statement_span))
        _check_counts(body, task, signature, clause)
    block = structures.walk(body, task.block.sections[0].body)
    check_near_names(body)
    checked.append(body)
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


def _check_hidden(body: Body, task: TaskText, signature: Signature) -> None:
    """Warn of parameters that have the name of something that the whole text sees."""
    if task.header is None:
        return
    places = {one.name.text: one.name for one in task.header.parameters or ()}
    for formal in signature.formals:
        symbol = body.world.symbols.get(formal.name)
        if symbol is not None and not isinstance(symbol, Poison):
            message = f"parameter `{formal.name}` hides {hidden.what(symbol)} of that name in the whole task"
            hint = "rename the parameter"
            body.warn(hidden_kinds.HIDDEN, places.get(formal.name, task.header), message, hint)


def _check_counts(body: Body, task: TaskText, signature: Signature, clause: Clause) -> None:
    first = task.block.sections[0].body[:1]
    has_prose = bool(first) and isinstance(first[0], Line) and isinstance(first[0].statement, syntax.Broken)
    if has_prose or not signature.is_known:  # what the line would have used is not known
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


def _globals(world: World) -> tuple[Local, ...]:
    return tuple(
        Local(s.name, settled(s.type).value) for s in world.symbols.values() if isinstance(s, Variable)
    )


def _program_name(tree: tuple[Line | Block, ...]) -> str:
    for item in tree:
        if isinstance(item, Line) and isinstance(item.statement, syntax.ProgramHeader):
            return item.statement.name.text
    return "main"


def _report_empty(tree: tuple[Line | Block, ...], tasks: Mapping[str, TaskText], report: Report) -> None:
    if any(d.is_error for d in report.found):
        return
    lines = [i.opener if isinstance(i, Block) else i for i in tree]
    line = lines[0] if lines else Line.empty()
    hint = (
        f"call a task, for example `{next(iter(tasks))}`" if tasks else "write a statement such as `mov home`"
    )
    report.line(syntax_kinds.EMPTY, line, "the program has no control statements", hint)
