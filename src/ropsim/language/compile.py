"""The compiler: text to structured program and ICR. This page is the table of contents of its phases."""

from collections.abc import Hashable, Mapping
from dataclasses import field

from ropsim.core import Diagnostic, SourceText, frozen_dataclass, without_collection
from ropsim.icr import Program as IcrProgram
from ropsim.language import checked as checker
from ropsim.language import questions
from ropsim.language.cache import LineCache, once
from ropsim.language.check.calls.signatures import for_library
from ropsim.language.check.reached import never_called, unreached
from ropsim.language.check.scope.world import Outcome
from ropsim.language.code.codes import code_of
from ropsim.language.code.main_code import HIDDEN
from ropsim.language.code.program_code import Code
from ropsim.language.division import divided
from ropsim.language.environment import NO_SIGNATURES, Environment, TaskSignature
from ropsim.language.findings import syntax as kinds
from ropsim.language.questions.contract_checks import broken_contracts
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.syntax import text as texts
from ropsim.language.syntax.places import at_names
from ropsim.language.syntax.text import Line
from ropsim.language.task_form import TaskForm
from ropsim.program import Program, SourceMap, has_gripper_contract, in_order, recursion
from ropsim.query import Database

OF_UNITS = (*questions.OF_PARTS, HIDDEN)
"""Inputs about a part of the control statements."""


@frozen_dataclass
class Compiled:
    """Result of the compiler.

    Attributes:
        program: the structured program of all lines that are right; None where the text was given up.
        code: the executable form; None where anything found is an error.
        diagnostics: all findings in order of their place.
        source: the text.
        tasks: how each task that can be called is called, also where other lines are wrong.
        places: where the statements of the structured program lie in the text.
        variables: type of each variable in a word of the language, by the name of its task (empty for the
            control statements and for variables of all tasks) and its own name in the structured program.
    """

    program: Program | None
    code: Code | None
    diagnostics: tuple[Diagnostic, ...]
    source: SourceText
    tasks: Mapping[str, TaskForm] = field(default_factory=dict)
    places: SourceMap = field(default_factory=lambda: SourceMap(""))
    variables: Mapping[str, Mapping[str, str]] = field(default_factory=dict)

    @property
    def icr(self) -> IcrProgram | None:
        """Return the program of the executable form, assembled on the first request."""
        return self.code.program if self.code is not None else None

    @property
    def ok(self) -> bool:
        """Return whether no finding is an error."""
        return not any(d.is_error for d in self.diagnostics)


def compile(
    text: str,
    signatures: Environment = NO_SIGNATURES,
    name: str = "<text>",
    cache: LineCache | None = None,
) -> Compiled:
    """Compile a task program; every text is answered, none raises.

    Args:
        text: the program.
        signatures: names that the cell and the library define.
        name: of the text, for messages.
        cache: results of earlier versions of the text; they save time and do not change the result.

    Returns:
        Program, ICR and findings. A wrong line is reported and left out; all others are compiled.
    """
    with without_collection():  # temporary results are freed at its end without a search by the collector
        return _compiled(SourceText(name, text), signatures, cache)


def compile_library(
    text: str, environment: Environment = NO_SIGNATURES, name: str = "<text>"
) -> tuple[Compiled, Mapping[str, TaskSignature]]:
    """Return the result for a text of tasks, and the signature of each of them for other texts.

    Args:
        text: the tasks.
        environment: names that the cell defines.
        name: of the text, for messages.
    """
    db = once(environment)
    with without_collection():
        compiled = _compiled_in(db, SourceText(name, text), environment)
        made = compiled.program.tasks if compiled.program is not None else ()
        asked = ((one, db.ask(questions.signature, one.name)) for one in made)
        return compiled, {
            task.name: for_library(called.signature, task) for task, called in asked if called is not None
        }


def _compiled(source: SourceText, signatures: Environment, cache: LineCache | None) -> Compiled:
    db = cache.database(signatures, source.name) if cache is not None else once(signatures)
    return _compiled_in(db, source, signatures)


def _compiled_in(db: Database, source: SourceText, signatures: Environment) -> Compiled:
    with db.version():
        return _version_compiled(db, source, signatures)


def _version_compiled(db: Database, source: SourceText, signatures: Environment) -> Compiled:
    report = Report(source.name)
    checked, places = _checked(source, signatures, report, db)
    if checked is None:
        return Compiled(None, None, report.in_order(), source)
    code = None if report.has_errors else _lowered(checked, places, source, report, db)
    return Compiled(
        checked.program, code, report.in_order(), source, checked.tasks, places, checked.variables
    )


def _lowered(
    checked: checker.Checked, places: SourceMap, source: SourceText, report: Report, db: Database
) -> Code | None:
    """Return the executable form; None where tasks call each other in a circle."""
    program, control, bodies = checked.program, checked.control, checked.bodies
    report.extend(map(places.finding, _circles(program, db)))
    if report.has_errors:
        return None
    library = program.tasks[len(db.ask(questions.own_tasks)) :]
    if any(one.has_contracts for one in bodies) or any(map(has_gripper_contract, library)):
        report.extend(in_order(broken_contracts(db), places))
    every: tuple[Outcome | questions.Bodies, ...] = (control, *bodies)
    report.extend(places.finding(found) for one in every for found in one.impossible)
    report.extend(unreached((places.span(one), places.span(end)) for body in every for one, end in body.late))
    if program.main:
        db.give({questions.CONTROL_CALLS: tuple(called for called, _ in control.calls)})
        missed = (db.ask(questions.checked, name).task for name in db.ask(questions.uncalled_tasks))
        report.extend(places.finding(never_called(task)) for task in missed if task is not None)
    code, findings = code_of(checked, places, db)
    report.extend(at_names(findings, source))
    return None if report.has_errors else code


def _circles(program: Program, db: Database) -> tuple[Diagnostic, ...]:
    """Return a finding for each call that closes a circle."""
    own, library = db.ask(questions.circles_of), program.tasks[len(db.ask(questions.own_tasks)) :]
    return (*own, *recursion(library)) if library else own  # tasks of a library call each other only


def _checked(
    source: SourceText, environment: Environment, report: Report, db: Database
) -> tuple[checker.Checked | None, SourceMap]:
    """Run the phases; None where the text holds more wrong lines than the limit."""
    nowhere = SourceMap(source.name)
    size = source.with_line_feeds().count("\n") + 1
    if size > texts.MAX_LINES:
        message = f"the text has {size} lines; at most {texts.MAX_LINES} are allowed"
        report.line(kinds.LINE_LENGTH, Line.empty(), message, "split it")
        return None, nowhere
    try:
        units = divided(source, environment, report, db)
        left = [unit for unit, items in units.new_parts.items() if items is None]
        inputs: dict[Hashable, object] = {("task", name): task for name, task in units.new_tasks.items()}
        inputs |= {(what, unit): None for unit in left for what in OF_UNITS}
        inputs |= {(questions.PART, unit): items for unit, items in units.new_parts.items()}
        inputs |= {questions.TASKS: units.tasks, questions.PARTS: units.parts}
        db.give(inputs)
        return checker.check(units, report, db), units.map
    except TooManyFindingsError:
        return None, nowhere
