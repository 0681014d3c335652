"""The compiler: text to structured program and ICR. This page is the table of contents of its phases."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ropsim.core import Diagnostic, SourceText
from ropsim.icr import Program as IcrProgram
from ropsim.language import blocks, misspelt, prose
from ropsim.language import text as texts
from ropsim.language.check import program as checker
from ropsim.language.check.reached import uncalled, unreached
from ropsim.language.environment import NO_SIGNATURES, Environment
from ropsim.language.findings import syntax as kinds
from ropsim.language.places import at_names
from ropsim.language.report import MAX_FINDINGS, Report, TooManyFindingsError
from ropsim.language.syntax.statements import Broken, TaskHeader
from ropsim.language.task_form import TaskForm
from ropsim.language.text import Line, LineCache
from ropsim.program import Program, check_contracts, check_points, lower_with_findings, recursion


@dataclass(frozen=True, slots=True)
class Compiled:
    """What the compiler answers.

    Attributes:
        program: the structured program of all lines that are right; None where the text was given up.
        icr: the executable form; None where anything found is an error.
        diagnostics: all findings in order of their place.
        source: the text.
        tasks: how each task that can be called is called, also where other lines are wrong.
    """

    program: Program | None
    icr: IcrProgram | None
    diagnostics: tuple[Diagnostic, ...]
    source: SourceText
    tasks: Mapping[str, TaskForm] = field(default_factory=dict)

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
        signatures: what the cell and the library give names to.
        name: of the text, for messages.
        cache: what earlier versions of the text have left; it saves time and changes no result.

    Returns:
        Program, ICR and findings. A wrong line is reported and left out; all others are compiled.
    """
    source = SourceText(name, text)
    report = Report(name)
    checked = _checked(source, signatures, report, cache or LineCache())
    if checked is None:
        return Compiled(None, None, report.in_order(), source)
    icr = None if report.has_errors else _lowered(checked.program, source, report)
    return Compiled(checked.program, icr, report.in_order(), source, checked.tasks)


def _lowered(program: Program, source: SourceText, report: Report) -> IcrProgram | None:
    """Return the executable form; None where tasks call each other in a circle."""
    report.extend(recursion(program))
    if report.has_errors:
        return None
    report.extend(check_contracts(program))
    report.extend(check_points(program))
    report.extend(unreached(program, report.source))
    report.extend(uncalled(program, report.source))
    code, findings = lower_with_findings(program, report.source)
    report.extend(at_names(findings, source))
    return None if report.has_errors else code


def _checked(
    source: SourceText, environment: Environment, report: Report, cache: LineCache
) -> checker.Checked | None:
    """Run the phases; None where the text holds more wrong lines than are worth looking at."""
    if len(source.lines) > texts.MAX_LINES:
        message = f"the text has {len(source.lines)} lines; at most {texts.MAX_LINES} are allowed"
        report.line(kinds.LINE_LENGTH, Line.empty(), message, "split it")
        return None
    try:
        lines = _lines(source, environment, report, cache)
        tree = blocks.build(lines, report)
        return checker.check(tree, environment, report)
    except TooManyFindingsError:
        report.muted = False
        return None


def _lines(source: SourceText, environment: Environment, report: Report, cache: LineCache) -> list[Line]:
    """Return the lines with something on them, contract prose joined to its clause."""
    read: list[Line] = []
    faults = 0
    for line in texts.read(source, cache):
        read.append(line)
        faults += line.fault is not None
        if faults > 2 * MAX_FINDINGS:
            break
    names = _task_names(read) | frozenset(environment.tasks)
    mended = list(misspelt.mended(read, names))
    return list(prose.absorb(mended, names | _task_names(mended), report))


def _task_names(lines: Iterable[Line]) -> frozenset[str]:
    """Return the names of the tasks of a text, also of those whose header is wrong."""
    found = set()
    for line in lines:
        match line.statement:
            case TaskHeader(name=name):
                found.add(name.text)
            case Broken(head="task", name=name) if name:
                found.add(name)
    return frozenset(found)
