"""A form as the properties of a clause, each with its text; faults of fields are returned with it."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from ropsim.core import Diagnostic, SourceText, did_you_mean, frozen_dataclass
from ropsim.language import Line, LineCache, read, statements
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.answers.call_reading import call_of
from ropsim.tasks.bodies.body_terms import body_terms
from ropsim.tasks.findings.text_diagnostics import TASK_FORM
from ropsim.tasks.findings.words import KINDS
from ropsim.tasks.forms.form import FormParameter, TaskForm
from ropsim.tasks.kinds import LOCATION, TaskError
from ropsim.tasks.terms.bounds import SIGNS
from ropsim.tasks.terms.clause_text import term_text
from ropsim.tasks.terms.conditions import examples
from ropsim.tasks.terms.expression_terms import NoTermError
from ropsim.tasks.terms.expression_text import is_reserved
from ropsim.tasks.terms.task_call import term_of_value

ORDER = ("doc", "params", "words", "range", "pre", "eff", "geo", "body")
"""Properties in the order in which new ones are written."""
WIDTH = 100
"""Lines of bodies are at most so long, where they can be."""
TermFaults = Callable[[Sequence[str]], Sequence[str]]
"""Returns the error of each text as a term; empty if correct."""


@frozen_dataclass
class FieldFault:
    """Fault of a field.

    Attributes:
        field: `name`, `parameters`, or the property that the field belongs to.
        place: which of several fields, from 0.
        finding: the fault.
    """

    field: str
    place: int
    finding: Diagnostic


@frozen_dataclass
class FormClause:
    """Clause made of a form.

    Attributes:
        head: such as `pick(P, L, Clear)`.
        properties: text of each that is not empty, in their order.
        faults: fields that say something that is none; the clause is no good then.
    """

    head: str
    properties: Mapping[str, str]
    faults: tuple[FieldFault, ...]

    @property
    def text(self) -> str:
        """Return the whole clause."""
        inner = ",\n  ".join(self.properties.values())
        return f"task({self.head}, [\n  {inner}]).\n"


def form_clause(form: TaskForm, term_faults: TermFaults) -> FormClause:
    """Return the clause of a form.

    Args:
        form: the fields.
        term_faults: checks in Prolog texts that are to be terms.
    """
    faults = [*_names(form)]
    lists = {"pre": form.needs, "eff": form.effects, "geo": form.geometry}
    for field, texts in lists.items():
        found = term_faults(texts)
        faults += [
            _fault(field, k, f"`{texts[k]}`: {why}", _TERMS[field]) for k, why in enumerate(found) if why
        ]
    defaults, wrong = _defaults(form)
    body, more = _body(form)
    faults += [*wrong, *more]
    written = {
        "doc": f"doc({_quoted(form.doc)})" if form.doc else "",
        "params": _listed("params", defaults),
        "words": _listed("words", [_word(one) for one in form.parameters if one.word]),
        "range": _listed("range", [_bound(one, bound) for one in form.parameters for bound in one.bounds]),
        **{field: _listed(field, [" ".join(one.split()) for one in texts]) for field, texts in lists.items()},
        "body": f"body({laid_out(body, 7, 2)})" if body else "",
    }
    variables = ", ".join(one.name for one in form.parameters)
    head = f"{form.name}({variables})" if variables else form.name
    return FormClause(head, {name: written[name] for name in ORDER if written[name]}, tuple(faults))


_TERMS = {
    "pre": "write a fact such as `gripper(open)` or `at(P, L)`",
    "eff": "write `+` or `-` before a fact, such as `+held(P)`",
    "geo": f"write {examples()}",
}


def _fault(field: str, place: int, message: str, hint: str) -> FieldFault:
    return FieldFault(field, place, TASK_FORM.at(None, message, hint=hint))


def _names(form: TaskForm) -> Iterator[FieldFault]:
    """Yield the faults of names and kinds."""
    if not re.fullmatch(r"[a-z]\w*", form.name, re.ASCII) or is_reserved(form.name):
        hint = "a small letter, then letters, digits and `_`; no word of the task language"
        found = f"`{form.name}` is no name of a task" if form.name else "a task needs a name"
        yield _fault("name", 0, found, hint)
    seen: set[str] = set()
    for place, one in enumerate(form.parameters):
        if not re.fullmatch(r"(?:[A-Z]|_+[A-Za-z])\w*", one.name, re.ASCII) or one.name in seen:
            hint = "a capital letter, then letters, digits and `_`; each name once"
            yield _fault("parameters", place, f"`{one.name}` is no name of a parameter, or there twice", hint)
        if one.kind not in KINDS:
            hint = did_you_mean(one.kind, KINDS) or f"kinds are {', '.join(KINDS)}"
            yield _fault("parameters", place, f"there is no kind `{one.kind}`", hint)
        for bound in one.bounds:
            sign, _, number = bound.partition(" ")
            if sign not in SIGNS or _typed(number) is None:
                hint = "write a number, with its unit where it has one"
                yield _fault("parameters", place, f"`{number}` is no bound of a value", hint)
        seen.add(one.name)


def _typed(text: str) -> Term | None:
    """Return the term of a typed value, None if it is no term."""
    try:
        call = call_of(f"x {text}")
    except TaskError:
        return None
    return term_of_value(call.parameters[0]) if len(call.parameters) == 1 and not call.points else None


def _defaults(form: TaskForm) -> tuple[list[str], list[FieldFault]]:
    """Return the text of each parameter with its kind and default."""
    texts: list[str] = []
    faults: list[FieldFault] = []
    for place, one in enumerate(form.parameters):
        text = f"{one.name}-{one.kind}"
        if one.default.strip():
            value = _typed(one.default)
            if value is None and one.kind in (LOCATION, "str"):
                value = Atom(one.default) if one.kind == LOCATION else one.default.strip('"')
            if value is None:
                hint = "write a number, with its unit where it has one"
                faults.append(_fault("parameters", place, f"`{one.default}` is no value", hint))
            else:
                text = f"{text} = {term_text(value)}"
        texts.append(text)
    return texts, faults


def _word(one: FormParameter) -> str:
    said = (one.word, one.sentence) if one.sentence else (one.word,)
    return f"word({', '.join((one.name, *map(_quoted, said)))})"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'


def _bound(one: FormParameter, bound: str) -> str:
    sign, _, number = bound.partition(" ")
    value = _typed(number)
    return f"{one.name} {sign} {term_text(0 if value is None else value)}"


def _listed(name: str, texts: Sequence[str]) -> str:
    """Return a property with a list; a line for each element where one line is too long."""
    if not texts:
        return ""
    flat = f"{name}([{', '.join(texts)}])"
    if len(flat) <= WIDTH:
        return flat
    inner = ",\n    ".join(texts)
    return f"{name}([\n    {inner}])"


def _body(form: TaskForm) -> tuple[tuple[Term, ...], list[FieldFault]]:
    """Return the statements of a body as terms, and the faults of its lines."""
    names = {one.called or called(one.name): one.name for one in form.parameters}
    found = list(read(SourceText("", form.body), LineCache()))
    faults = [
        _fault("body", at, one.fault.message, one.fault.hint or "see the manual of the task language")
        for at, one in enumerate(found)
        if one.fault is not None
    ]
    faults += _blocks(found)
    if faults:
        return (), faults
    lines = [one.statement for one in found if one.statement is not None]
    try:
        return body_terms(iter(lines), names), []
    except NoTermError as error:
        message = f"the body has what a knowledge base has no term for: {error}"
        return (), [_fault("body", 0, message, "keep such a task in a program")]


def _blocks(lines: Sequence[Line]) -> Iterator[FieldFault]:
    """Yield the faults of the begins and ends of blocks."""
    open_at: list[int] = []
    for at, line in enumerate(lines):
        match line.statement:
            case statements.If(body=None):
                open_at.append(at)
            case statements.Repeat() | statements.While() | statements.For() | statements.ForEach():
                open_at.append(at)
            case statements.With():
                open_at.append(at)
            case statements.Closer() | statements.Until():
                if open_at:
                    open_at.pop()
                else:
                    yield _fault("body", at, "there is no block to end here", "take the line out")
    for at in open_at:
        yield _fault(
            "body", at, "a block has no end", "end it with `endr`, `endw`, `endf`, `endif` or `endwith`"
        )


def called(name: str) -> str:
    """Return the name of a parameter in task text: its variable in small letters."""
    text = name.lower().strip("_") or "q"
    return f"{text}_" if is_reserved(text) else text


def laid_out(term: Term, column: int, indent: int) -> str:
    """Return the text of statements; a list that does not fit on a line has a line for each element.

    Args:
        term: a list of statements, or one.
        column: at which its text begins.
        indent: of the line on which it begins.
    """
    flat = term_text(term)
    if len(flat) + column <= WIDTH:
        return flat
    deeper = indent + 2
    match term:
        case tuple() if term:
            lines = (f"{' ' * deeper}{laid_out(one, deeper, deeper)}" for one in term)
            return "[\n" + ",\n".join(lines) + "]"
        case Struct(name, (*first, tuple(inner))) if inner:
            head = f"{name}({''.join(f'{term_text(one)}, ' for one in first)}"
            return f"{head}{laid_out(inner, column + len(head), indent)})"
    return flat
