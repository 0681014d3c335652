"""A task of a knowledge base as task text, and a task text as a clause of a knowledge base."""

import hashlib
import re
from collections.abc import Iterator, Mapping
from itertools import pairwise
from textwrap import wrap

from ropsim.core import Diagnostic, SourceText
from ropsim.language import Environment, LineCache, ParameterForm, compile, read, statements
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.bodies.body_terms import body_terms
from ropsim.tasks.bodies.body_text import body_lines
from ropsim.tasks.findings.text_diagnostics import NO_TERM
from ropsim.tasks.kinds import TYPES, TaskError, kind_of_type
from ropsim.tasks.terms.clause_text import clause_text
from ropsim.tasks.terms.expression_terms import NoTermError, term_of
from ropsim.tasks.terms.expression_text import NotTextError, expression, is_reserved
from ropsim.tasks.terms.known_task import KnownTask, Parameter

_WORD = re.compile(r"\W+")
_COLUMNS = 100
"""Width to which comments are wrapped."""


def task_text(task: KnownTask) -> str:
    """Return a task as `task … endp`, with the parameters that task text passes.

    Raises:
        TaskError: its body has a term that is no statement.
    """
    try:
        return _text(task, text_names(task))
    except NotTextError as error:
        message = f"the body of `{task.name}` is no task text: {error}"
        raise TaskError(NO_TERM.at(task.span, message, hint="see `ropsim explain P138`")) from error


def _text(task: KnownTask, names: Mapping[str, str]) -> str:
    header = f"task {task.name}({', '.join(_parameter(one, names) for one in task.passed)})"
    doc = [f"# {line}" for one in task.doc.splitlines() for line in wrap(one, _COLUMNS)]
    words = [f"#   {names[one.name]}: {_comment(one)}" for one in task.passed if one.word]
    return "\n".join([*doc, *words, header, *body_lines(task.body, names), "endp"])


def _comment(parameter: Parameter) -> str:
    return ", ".join(" ".join(one.split()) for one in (parameter.word, parameter.sentence) if one)


def text_names(task: KnownTask) -> Mapping[str, str]:
    """Return the name in task text of each parameter that it passes: its variable in small letters.

    Words of the language and names that the body has for its own variables get a `_` behind.
    """
    own = names_of(task.body)
    names: dict[str, str] = {}
    for one in task.passed:
        name = one.name.lower().strip("_") or "q"
        while name in names.values() or name in own or is_reserved(name):
            name += "_"
        names[one.name] = name
    return names


def names_of(body: tuple[Term, ...]) -> frozenset[str]:
    """Return all names of a body that are no parameters."""
    found: set[str] = set()
    left: list[Term] = list(body)
    while left:
        match left.pop():
            case Atom(name):
                found.add(name)
            case Struct(_, arguments):
                left += arguments
            case tuple() as several:
                left += several
    return frozenset(found)


def stored_clause(text: SourceText, environment: Environment) -> tuple[str | None, tuple[Diagnostic, ...]]:
    """Return the clause under which the first task of a text can be kept in a knowledge base.

    Its contract states the required state of the gripper, the last statement about the gripper its final
    state. If a list of parameters is missing the compiler determines the parameters.

    Args:
        text: task text with one task, and the texts that it needs.
        environment: the cell for which it is written.
    """
    compiled = compile(text.text, environment, text.name)
    if not compiled.ok:
        return None, compiled.diagnostics
    lines = [line.statement for line in read(text, LineCache()) if line.statement is not None]
    header = next((one for one in lines if isinstance(one, statements.TaskHeader)), None)
    if header is None:
        return None, (NO_TERM.at(None, "the text has no task", hint="write `task NAME(…)` … `endp`"),)
    form = compiled.tasks[header.name.text]
    inside = iter(lines[lines.index(header) + 1 :])
    names = dict(zip((one.name for one in form.parameters), _variables(form.parameters), strict=True))
    try:
        task = _stored(header, form.parameters, names, inside)
    except NoTermError as error:
        message = f"the task holds what a knowledge base has no term for: {error}"
        return None, (NO_TERM.at(None, message, hint="keep such a task in a program"),)
    return clause_text(task), compiled.diagnostics


def _stored(
    header: statements.TaskHeader,
    parameters: tuple[ParameterForm, ...],
    names: Mapping[str, str],
    lines: Iterator[statements.Statement],
) -> Term:
    contracts: list[str] = []
    body: list[statements.Statement] = []
    for one in lines:
        if isinstance(one, statements.ContractClause):
            contracts.append(one.text)
        else:
            body.append(one)
    terms = body_terms(iter(body), names)
    defaults = {one.name.text: one.default for one in header.parameters or () if one.default is not None}
    kinds: list[Term] = []
    for form in parameters:
        kind = kind_of_type(form.type)
        if kind is None:
            raise NoTermError(f"a parameter of type `{form.type}`")
        pair = Struct("-", (Var(names[form.name]), Atom(kind)))
        default = defaults.get(form.name)
        kinds.append(pair if default is None else Struct("=", (pair, term_of(default, names))))
    variables = tuple(Var(names[form.name]) for form in parameters)
    head: Term = Struct(header.name.text, variables) if variables else Atom(header.name.text)
    before, after = _gripper(" ".join(contracts), terms)
    parts = (
        Struct("doc", ("; ".join(contracts),)),
        Struct("params", (tuple(kinds),)),
        Struct("pre", (before,)),
        Struct("eff", (after,)),
        Struct("geo", ((),)),
        Struct("body", (terms,)),
    )
    return Struct("task", (head, parts))


def _gripper(contract: str, body: tuple[Term, ...]) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
    """Return the state of the gripper that a contract requires, and the state after the body."""
    words = _WORD.split(contract.lower())
    named = [after for word, after in pairwise(words) if word == "gripper"]
    states = {"open": "open", "opened": "open", "close": "closed", "closed": "closed"}
    before = next((states[word] for word in named if word in states), None)
    grips = [one for one in _words(body) if one in ("open", "close")]
    after = states[grips[-1]] if grips else before
    fact = {state: Struct("gripper", (Atom(state),)) for state in ("open", "closed")}
    effects: list[Term] = []
    if after is not None and after != before:
        gone = "open" if after == "closed" else "closed"
        effects = [Struct("-", (fact[gone],)), Struct("+", (fact[after],))]
    return (() if before is None else (fact[before],)), tuple(effects)


def _words(body: tuple[Term, ...]) -> Iterator[str]:
    """Yield the statements without arguments, as written in the text."""
    for one in body:
        match one:
            case Atom(name):
                yield name
            case Struct(_, arguments):
                for inner in arguments:
                    yield from _words(inner) if isinstance(inner, tuple) else ()


def _variables(parameters: tuple[ParameterForm, ...]) -> list[str]:
    found: list[str] = []
    for one in parameters:
        name = one.name.lstrip("_")
        name = f"{name[:1].upper()}{name[1:]}" or "Q"
        while name in found:
            name += "_"
        found.append(name)
    return found


def _parameter(parameter: Parameter, names: Mapping[str, str]) -> str:
    default = "" if parameter.default is None else f" = {expression(parameter.default, names)}"
    return f"{names[parameter.name]}: {TYPES[parameter.kind]}{default}"


SHORT = 8
"""Digits of a version that people are shown."""


def version_of(task: KnownTask) -> str:
    """Return the version of a task, by its content: the SHA-256 of its task text, empty without a text."""
    try:
        return version_of_text(task_text(task))
    except TaskError:
        return ""


def version_of_text(text: str) -> str:
    """Return the SHA-256 of a task text, as 64 digits."""
    return hashlib.sha256(text.encode(errors="surrogatepass")).hexdigest()
