"""How tasks are called: written parameter lists, implicit ones of classic tasks, library tasks."""

from collections.abc import Container, Sequence
from dataclasses import replace

from ropsim.language.blocks.matching import Block
from ropsim.language.check.calls import implicit
from ropsim.language.check.calls.tasks import TaskText
from ropsim.language.check.expressions import convert, functions, poses, values
from ropsim.language.check.scope import fold, hidden
from ropsim.language.check.scope.body import Body, RejectedError, settled
from ropsim.language.check.scope.types import NAMED, NUMBER, POSE, AnyType, Type, Unknown
from ropsim.language.check.scope.units import UnitSystem
from ropsim.language.check.scope.world import Formal, Signature
from ropsim.language.environment import TaskSignature
from ropsim.language.findings import hidden as hidden_kinds
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.task_form import ParameterForm, TaskForm
from ropsim.program import Expression, Local, Task, ValueType


def of_library(library: TaskSignature) -> Signature:
    """Return how a library task is called."""
    task = library.task
    formals = tuple(
        Formal(p.name, _library_type(p, library), library.defaults.get(p.name)) for p in task.parameters
    )
    references = tuple(f.name for f in formals if f.type == POSE)
    return Signature(task.name, formals, references, Type(task.result) if task.result else None)


def for_library(signature: Signature, task: Task) -> TaskSignature:
    """Return a checked task as other texts call it; the way back is `of_library`."""
    dimensions = {
        one.name: word_of(settled(one.type))
        for one in signature.formals
        if settled(one.type).value is ValueType.REAL
    }
    defaults = {one.name: one.default for one in signature.formals if one.default is not None}
    return TaskSignature(task, dimensions, defaults)


def _library_type(parameter: Local, library: TaskSignature) -> Type:
    if parameter.type is ValueType.REAL:
        return NAMED.get(library.dimensions.get(parameter.name, "num"), NUMBER)
    return Type(parameter.type)


def of_text(body: Body, task: TaskText, task_names: Container[str]) -> Signature:
    """Return how a task of the text is called; types not written are left open and inferred from use.

    Args:
        body: of the task, before anything stands in it.
        task: the task.
        task_names: all tasks that can be called.
    """
    header, world = task.header, body.world
    body.line = task.block.opener
    if header is None:
        return Signature(task.name, (), (), None, is_known=False)
    if task.name.lower() in functions.NAMES:
        message = f"`{task.name}` is a function of the language"
        hint = "choose another name for the task"
        body.warn(hidden_kinds.FUNCTION_NAME, header.name, message, hint)
    taken = hidden.in_cell(world.environment, task.name)
    if taken:
        message = f"task `{task.name}` has the name of {taken} of the cell"
        body.warn(hidden_kinds.HIDDEN, header.name, message, "choose another name for the task")
    result = NAMED[header.result.text] if header.result is not None else None
    if header.parameters is not None:
        formals = _explicit(body, header.parameters)
        references = tuple(f.name for f in formals if f.type == POSE)
        return Signature(task.name, formals, references, result)
    if not world.is_classic:
        return Signature(task.name, (), (), result)
    references, scalars = implicit.uses(
        task.block, lambda name: bool(hidden.hidden_by_parameter(world, name)), world.signatures
    )
    formals = (*(Formal(n, POSE) for n in references), *(Formal(n, Unknown()) for n in scalars))
    return Signature(
        task.name, formals, references, result, is_known=not _has_wrong_line(task.block, task_names)
    )


def _has_wrong_line(block: Block, task_names: Container[str]) -> bool:
    """Return whether a line could not be read, or calls a task that is not defined.

    The wrong line may have named a parameter, so the list is incomplete: `call relase 2` in place of `call
    release 2` hides the second reference location. The line has its own finding; callers are not to be blamed
    as well. Prose that looks like a statement does not count: it is a warning only, and its task stays
    callable.
    """
    for section in block.sections:
        for item in section.body:
            line = item.opener if isinstance(item, Block) else item
            statement = line.statement
            if line.fault is not None:
                return True
            if isinstance(statement, syntax.Call) and statement.name.text not in task_names:
                return True
            if isinstance(item, Block) and _has_wrong_line(item, task_names):
                return True
    return False


def _explicit(body: Body, parameters: tuple[syntax.Parameter, ...]) -> tuple[Formal, ...]:
    formals: list[Formal] = []
    for parameter in parameters:
        if any(f.name == parameter.name.text for f in formals):
            message = f"parameter `{parameter.name.text}` is declared twice"
            body.warn(name_kinds.DUPLICATE, parameter.name, message, "rename one of them")
            continue
        kind = NAMED[parameter.type.text] if parameter.type is not None else Unknown()
        default, written = None, ""
        if parameter.default is not None:
            default = _default(body, parameter.name.text, parameter.default, kind)
            written = _written(body, parameter.default)
        formals.append(Formal(parameter.name.text, kind, default, written))
    return tuple(formals)


def _written(body: Body, node: nodes.Node) -> str:
    """Return a default as written in the header, on one line."""
    text = " ".join(body.written(node).split())
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]} …"


def _default(body: Body, name: str, node: nodes.Node, kind: AnyType) -> Expression:
    what = f"the default of `{name}`"
    try:
        value = values.check(body, node)
        inner, posture, moving = fold.opened(convert.to(body, value, kind, node, what))
        number = convert.constant(body, inner, node, what)
        return poses.kept(value, fold.closed(number, posture, moving) if posture or moving else number)
    except RejectedError:
        return fold.real(0.0)  # the finding stands; calls without this argument are not reported as well


def final(body: Body, task: TaskText, signature: Signature, types: Sequence[Type]) -> Signature:
    """Return the signature with the types inferred from use, and its defaults converted to them.

    Args:
        body: of the task, before anything stands in it.
        task: the task.
        signature: as declared by its header.
        types: of its parameters.
    """
    formals = [
        one if one.type is kind else replace(one, type=kind)
        for one, kind in zip(signature.formals, types, strict=True)
    ]
    references = tuple(f.name for f in formals if f.type == POSE)
    if task.header is None:
        return replace(signature, formals=tuple(formals), references=references)
    if task.header.parameters is None:
        return replace(signature, formals=tuple(formals))
    body.line = task.block.opener
    nodes_by_name = {p.name.text: p.default for p in task.header.parameters if p.default is not None}
    for k, formal in enumerate(formals):
        node = nodes_by_name.get(formal.name)
        if node is not None:
            formals[k] = replace(formal, default=_default(body, formal.name, node, formal.type))
    return replace(signature, formals=tuple(formals), references=references)


def report_untold(body: Body, task: TaskText, untold: Container[str]) -> None:
    """Report parameters whose types neither header nor body determine."""
    header = task.header
    for one in (header.parameters or ()) if header is not None else ():
        if one.name.text in untold:
            message = f"nothing in the task tells what `{one.name.text}` is"
            hint = f"write its type: `{one.name.text}: num`, `: length`, `: loc` …"
            fix = f"{one.name.text}: num"
            body.report.at(kinds.NO_TYPE, task.block.opener, one.name, message, hint, fix=fix)


def form_of(signature: Signature, units: UnitSystem) -> TaskForm:
    """Return how a task is called, in words of the language."""
    parameters = tuple(
        ParameterForm(
            formal.name,
            word_of(settled(formal.type)),
            units.name(settled(formal.type).dimension),
            _default_words(formal, units),
        )
        for formal in signature.formals
    )
    result = word_of(signature.result) if signature.result is not None else ""
    return TaskForm(signature.name, parameters, result, signature.is_known)


def _default_words(formal: Formal, units: UnitSystem) -> str:
    """Return the default of a parameter in words of the language; empty for none."""
    number = fold.number_of(formal.default) if formal.default is not None else None
    if formal.default is None or formal.written or number is None:
        return formal.written or ("" if formal.default is None else "…")
    return f"{number / units.factor(settled(formal.type).dimension):.6g}"


def word_of(kind: Type) -> str:
    """Return a type in a word of the language."""
    return _WORDS.get((kind.value, kind.dimension)) or str(kind)


_SHOWN = 40
"""Characters of a default that a form of a task shows."""

_WORDS = {(kind.value, kind.dimension): word for word, kind in reversed(NAMED.items())}
"""Words of types; of two for one the first counts."""
