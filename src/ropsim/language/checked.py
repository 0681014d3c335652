"""The whole text: results of the bodies, combined."""

from collections.abc import Hashable, Iterable, Mapping

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language import questions
from ropsim.language.check.declarations import Declared
from ropsim.language.check.scope.body import settled
from ropsim.language.check.scope.world import Outcome, Variable, World
from ropsim.language.control.check import check_control
from ropsim.language.control.walk import walk_control
from ropsim.language.control.way import give_equal
from ropsim.language.division import Units
from ropsim.language.findings import syntax as syntax_kinds
from ropsim.language.report import Report
from ropsim.language.syntax.text import Line
from ropsim.language.task_form import TaskForm
from ropsim.program import Local, Program, SignalUse
from ropsim.query import Database


@frozen_dataclass
class Checked:
    """The structured program of all lines that are right.

    Attributes:
        program: places in it count lines in their unit.
        tasks: how its tasks are called.
        bodies: results of the tasks of the text, group by group, callees first.
        control: result of the control statements.
        variables: type of each variable in a word, by its task (empty for variables of all tasks) and name.
    """

    program: Program
    tasks: Mapping[str, TaskForm]
    bodies: tuple[questions.Bodies, ...]
    control: Outcome
    variables: Mapping[str, Mapping[str, str]]


def check(units: Units, report: Report, db: Database) -> Checked:
    """Return the structured program of all lines that are right; the others are reported.

    Args:
        units: of the text.
        report: takes findings.
        db: holds them, and further results.

    Raises:
        TooManyFindingsError: the list is full.
    """

    def tell(found: Iterable[Diagnostic]) -> None:
        for one in found:
            report.add(units.map.finding(one))

    declared = db.ask(questions.declared)
    tell(declared.found)
    order = db.ask(questions.order)
    db.give({questions.DECLARED: declared, questions.ORDER: order})
    groups = db.ask(questions.groups)
    for group in groups:  # callees first, so that no chain of calls becomes a chain of questions
        tell(db.ask(questions.found_in_headers, group))
    inferred = db.ask(questions.inference)
    db.give({questions.INFERRED: inferred})
    for group in groups:
        db.ask(questions.find_types, group)
    if inferred is None:
        give_equal(db, questions.WALKED_CONTROL, walk_control(db))
    db.give({questions.JOINT_COUNT: db.ask(questions.joint_count)})
    for group in groups:
        tell(db.ask(questions.found_in_signatures, group))
    bodies: list[questions.Bodies] = []
    for group in groups:
        bodies.append(db.ask(questions.bodies_in, group))
        tell(bodies[-1].found)
    control = check_control(db, db.ask(questions.types, "").types)
    tell(control.found)
    _give_variables(db, control.locals)
    if not report.has_errors:
        for one in bodies:
            tell(one.unread)
        tell(control.unread)
    if not control.block:
        _report_empty(units.tasks, units.opener, report)
    program = _program(bodies, control, declared, db)
    library = ((name, db.ask(questions.form, name)) for name in declared.world.environment.tasks)
    forms = {name: form for name, form in library if form is not None}
    own = db.ask(questions.all_forms)
    return Checked(
        program, {**forms, **own} if forms else own, tuple(bodies), control, db.ask(questions.all_words)
    )


def _program(
    bodies: Iterable[questions.Bodies], control: Outcome, declared: Declared, db: Database
) -> Program:
    world = declared.world
    environment = world.environment
    signals: dict[str, SignalUse] = {}
    for one in bodies:
        signals |= one.signals
    signals |= {signal.name: signal for signal in control.signals}
    library = tuple(one.task for name, one in environment.tasks.items() if not db.ask(questions.is_own, name))
    lists = db.read(questions.LISTS)
    return Program(
        declared.name,
        control.block,
        (*_globals(world, db), *control.locals),
        (*db.ask(questions.own_tasks), *library),
        world.frame,
        dict(world.frames),
        dict(world.tools),
        environment.default_tool,
        tuple(signals.values()),
        {name: one.points for name, one in lists.items()},
        {name: (one.source, one.places) for name, one in lists.items() if one.places},
    )


def _globals(world: World, db: Database) -> tuple[Local, ...]:
    names = (name for name, one in world.symbols.items() if isinstance(one, Variable))
    found = (db.ask(questions.symbol, name) for name in names)
    return tuple(Local(one.name, settled(one.type).value) for one in found if isinstance(one, Variable))


def _give_variables(db: Database, variables: tuple[Local, ...]) -> None:
    """Set the types of the variables of the control statements as inputs, name by name."""
    before: tuple[Local, ...] = db.read(questions.CONTROL_LOCALS) or ()
    if before == variables:
        return
    types = {one.name: one.type for one in variables}
    known = {one.name: one.type for one in before}
    inputs: dict[Hashable, object] = {
        (questions.CONTROL_LOCAL, name): types.get(name)
        for name in {**known, **types}
        if known.get(name) is not types.get(name)
    }
    db.give({questions.CONTROL_LOCALS: variables, **inputs})


def _report_empty(names: tuple[str, ...], opener: Span | None, report: Report) -> None:
    if report.has_errors:
        return
    hint = f"call a task, for example `{names[0]}`" if names else "write a statement such as `mov home`"
    place = opener if opener is not None else Line.empty().logical.span(report.source, 0, 0)
    report.add(syntax_kinds.EMPTY.at(place, "the program has no control statements", hint=hint))
