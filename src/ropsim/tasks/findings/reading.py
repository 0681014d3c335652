"""Messages about errors found by the reader of knowledge bases."""

from collections.abc import Callable, Mapping

from ropsim.core import Diagnostic, Kind, Label, SourceText, did_you_mean
from ropsim.prolog import Atom, Places, Struct, Term, findings_of
from ropsim.tasks.findings import text_diagnostics as kinds
from ropsim.tasks.findings.words import GEOMETRY, KINDS, PROPERTIES
from ropsim.tasks.terms.conditions import examples, forms
from ropsim.tasks.terms.expression_text import shown

Words = tuple[Kind, str, str]
"""Kind, message and hint of a finding."""
_ORDER = "the properties are `doc`, `params`, `words`, `range`, `pre`, `eff`, `geo` and `body`"
_FIXED: Mapping[str, Words] = {
    "deep": (kinds.TOO_DEEP, "the clause is nested deeper than 60", "split it into facts"),
    "directive": (kinds.NOT_USED, "a directive of a knowledge base is not run", "take it out"),
    "no_clause": (kinds.NOT_USED, "this is neither a task nor a fact nor a rule", "take it out"),
    "no_rule": (
        kinds.NOT_USED,
        "this is no rule: its head is no fact",
        "tasks are facts `task(Head, [Properties])`",
    ),
    "open_fact": (kinds.NOT_USED, "a fact has a variable", "state it for each thing, or write a rule"),
    "no_argument": (
        kinds.UNTYPED,
        "a parameter is no argument of the head",
        "name the variables of the head",
    ),
    "parameter": (kinds.UNTYPED, "a parameter is not `Variable-kind`", "write it as `L-location`"),
    "condition": (kinds.TASK_FORM, "a precondition is a variable", "write a fact such as `gripper(open)`"),
    "effect": (
        kinds.TASK_FORM,
        "an effect is neither `+fact` nor `-fact`",
        "write it as `+held(P)` or `-free(L)`",
    ),
    "unbound": (
        kinds.UNBOUND,
        "a variable is no parameter of the task",
        "name it in the head and in `params`; a body's own variables have small letters",
    ),
}
_GEOMETRY = f"write {examples()}; N, M and D are parameters"
_FORMS: Mapping[str, tuple[str, str]] = {
    "arguments": ("a task has a head and a list of properties", "write `task(Head, [Properties])`"),
    "head": ("the head of a task is a name with variables", "write it as `grip(P, L)`"),
    "head_arguments": ("the arguments of the head are not variables that differ", "write it as `grip(P, L)`"),
    "properties": ("the properties of a task are no list", _ORDER),
    "property": ("this is no property of a task", _ORDER),
    "of_word": (
        "this says no word of a parameter",
        'write `word(L, "place")` or `word(L, "place", "where the part lies")`',
    ),
    "of_range": (
        "this is no bound of a parameter that is a number",
        "write a number behind `>=`, `=<`, `>` or `<`, such as `N >= 1` or `D > 0*mm`",
    ),
    "twice": ("a property stands twice", "join the two"),
}


class Wording:
    """Turns errors of the reader into findings with places."""

    def __init__(self, texts: Mapping[int, SourceText], tasks: Callable[[], tuple[str, ...]]) -> None:
        self._texts = texts
        self._tasks = tasks
        self._places = {index: Places(text) for index, text in texts.items()}

    def of_reader(self, reply: Term) -> tuple[Diagnostic, ...]:
        """Return the findings of the engine about one text: `reply(Text, Items)`."""
        match reply:
            case Struct("reply", (int(index), tuple(items))):
                return findings_of(self._texts[index], Struct("checked", (items, (), (), ())))
        return ()

    def of_base(self, found: Term) -> Diagnostic | None:
        """Return the finding of `found(Text, From, To, Code, Arguments)`."""
        match found:
            case Struct("found", (int(index), int(start), int(end), Atom(code), tuple(arguments))):
                span = self._places[index].span(start, end)
                kind, message, hint = self._words(code, arguments)
                other: tuple[Label, ...] = ()
                if code == "clash":
                    _, first, begin, stop = arguments
                    if isinstance(first, int) and isinstance(begin, int) and isinstance(stop, int):
                        other = (Label(self._places[first].span(begin, stop), "the first one"),)
                return kind.at(span, message, hint=hint, secondary=other)
        return None

    def _words(self, code: str, arguments: tuple[Term, ...]) -> Words:
        if code in _FIXED:
            return _FIXED[code]
        first = _name(arguments[0])
        match code:
            case "form":
                message, hint = _FORMS[first]
                return kinds.TASK_FORM, message, hint
            case "property":
                return (
                    kinds.TASK_FORM,
                    f"`{first}` is no property of a task, or not of this form",
                    (did_you_mean(first, PROPERTIES) or _ORDER),
                )
            case "word":
                return (
                    kinds.NAME_CLASH,
                    f"`{first}` is a statement and no name of a task",
                    "choose another name",
                )
            case "untyped":
                return (
                    kinds.UNTYPED,
                    f"a parameter of `{first}` has no kind",
                    "write it in `params` as `L-location`",
                )
            case "kind":
                hint = did_you_mean(first, KINDS) or f"kinds are {', '.join(KINDS)}"
                return kinds.UNKNOWN_KIND, f"there is no kind `{first}`", hint
            case "geometry":
                if first.partition("/")[0] in GEOMETRY:
                    return kinds.UNKNOWN_GEOMETRY, f"`{first}` is not of its form here", _GEOMETRY
                return (
                    kinds.UNKNOWN_GEOMETRY,
                    f"`{first}` is no condition of geometry",
                    f"there are {forms()}",
                )
            case "statement":
                return kinds.UNKNOWN_STATEMENT, f"`{first}` is no statement", "see `ropsim explain P138`"
        return self._between(code, first, arguments)

    def _between(self, code: str, first: str, arguments: tuple[Term, ...]) -> Words:
        """Return the words of errors that only all texts together show."""
        match code:
            case "clash":
                return kinds.NAME_CLASH, f"there is a task `{first}` already", "give one of them another name"
            case "itself":
                return kinds.UNKNOWN_TASK, f"`{first}` calls itself", "use `repeat` or `while`"
            case "hides":
                whose = "user's own tasks" if arguments[1] == Atom("user") else "library"
                return (
                    kinds.HIDES,
                    f"`{first}` takes the place of the task of the {whose}",
                    "rename it where that is not meant",
                )
            case "unknown_task":
                hint = did_you_mean(first, self._tasks()) or "see `ropsim task list`"
                return kinds.UNKNOWN_TASK, f"Task not defined: `{first}`", hint
            case "arity":
                _, given, least, most = arguments
                wanted = f"{least}" if least == most else f"{least} to {most}"
                return (
                    kinds.WRONG_ARITY,
                    f"`{first}` takes {wanted} arguments of task text, given: {given}",
                    "parts, tools and devices are not passed",
                )
            case "nobody_makes":
                hint = "state it as a fact, or let a task make it"
                return kinds.NOBODY_MAKES, f"nobody makes a fact `{first}`", hint
            case "nobody_reads":
                return (
                    kinds.EFFECT_NEVER_READ,
                    f"no condition looks at `{first}`",
                    "is it spelt as it is read?",
                )
        return kinds.TASK_FORM, f"this task is wrong: {code}", ""


def _name(term: Term) -> str:
    match term:
        case Atom(name):
            return name
        case Struct("/", (Atom(name), int(arity))):
            return f"{name}/{arity}"
    return shown(term)
