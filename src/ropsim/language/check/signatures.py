"""How tasks are called: written parameter lists, implicit ones of classic tasks, library tasks."""

from ropsim.language.check import convert, implicit, values
from ropsim.language.check.body import Body, RejectedError
from ropsim.language.check.tasks import TaskText
from ropsim.language.check.types import NAMED, NUMBER, POSE, Type, Unknown
from ropsim.language.check.world import Formal, Signature, World
from ropsim.language.environment import TaskSignature
from ropsim.language.findings import names as name_kinds
from ropsim.language.report import Report
from ropsim.language.syntax import statements as syntax
from ropsim.program import Local, ValueType


def of_library(library: TaskSignature) -> Signature:
    """Return how a library task is called."""
    task = library.task
    formals = tuple(Formal(p.name, _library_type(p, library)) for p in task.parameters)
    references = tuple(f.name for f in formals if f.type == POSE)
    return Signature(task.name, formals, references, Type(task.result) if task.result else None)


def _library_type(parameter: Local, library: TaskSignature) -> Type:
    if parameter.type is ValueType.REAL:
        return NAMED.get(library.dimensions.get(parameter.name, "num"), NUMBER)
    return Type(parameter.type)


def of_text(world: World, task: TaskText, report: Report) -> Signature:
    """Return how a task of the text is called; types not written are left open for use to tell."""
    header = task.header
    if header is None:
        return Signature(task.name, (), (), None, is_known=False)
    result = NAMED[header.result.text] if header.result is not None else None
    if header.parameters is not None:
        formals = _explicit(world, task, header.parameters, report)
        references = tuple(f.name for f in formals if f.type == POSE)
        return Signature(task.name, formals, references, result)
    if not world.is_classic:
        return Signature(task.name, (), (), result)
    references, scalars = implicit.uses(task.block, lambda n: n in world.symbols, world.signatures)
    formals = (*(Formal(n, POSE) for n in references), *(Formal(n, Unknown()) for n in scalars))
    return Signature(task.name, formals, references, result)


def _explicit(
    world: World, task: TaskText, parameters: tuple[syntax.Parameter, ...], report: Report
) -> tuple[Formal, ...]:
    body = Body(world, report, None, task.name)
    body.line = task.block.opener
    formals: list[Formal] = []
    for parameter in parameters:
        if any(f.name == parameter.name.text for f in formals):
            message = f"parameter `{parameter.name.text}` is declared twice"
            report.at(name_kinds.DUPLICATE, body.line, parameter.name, message, "rename one of them")
            continue
        kind = NAMED[parameter.type.text] if parameter.type is not None else Unknown()
        default = None
        if parameter.default is not None:
            what = f"the default of `{parameter.name.text}`"
            try:
                value = values.expect(body, parameter.default, kind, what)
                default = convert.constant(body, value, parameter.default, what)
            except RejectedError:
                default = None
        formals.append(Formal(parameter.name.text, kind, default))
    return tuple(formals)
