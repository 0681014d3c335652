"""Findings in the clauses of a text, from the terms that Prolog read."""

from bisect import bisect_right
from collections.abc import Iterator, Mapping

from ropsim.core import Diagnostic, Label, SourceText, Span, did_you_mean
from ropsim.prolog.diagnostics import CLAUSE_SYNTAX, SCATTERED, SINGLETON, UNKNOWN_PREDICATE
from ropsim.prolog.failures import failure_of
from ropsim.prolog.terms.brackets import BracketFault, Brackets
from ropsim.prolog.terms.syntax_words import may_be_bracket, syntax_words
from ropsim.prolog.terms.terms import Atom, Struct, Term


class Places:
    """Turns numbers of characters into lines and columns; every kind of line end is understood."""

    def __init__(self, text: SourceText) -> None:
        self._name = text.name
        self._starts = [0]
        place = 0
        characters = text.text
        for line in text.lines[:-1]:
            place += len(line)
            place += 2 if characters.startswith("\r\n", place) else 1
            self._starts.append(place)
        self._end = len(characters)

    def span(self, start: int, end: int) -> Span:
        """Return the span of the characters from `start` to `end`, counted from 0."""
        start, end = min(max(start, 0), self._end), min(max(end, 0), self._end)
        line, column = self._at(start)
        end_line, end_column = self._at(max(end, start))
        if (end_line, end_column) == (line, column):
            end_column += 1
        return Span(self._name, line, column, end_line, end_column)

    def _at(self, place: int) -> tuple[int, int]:
        line = bisect_right(self._starts, place)
        return line, place - self._starts[line - 1] + 1


def findings_of(text: SourceText, reply: Term) -> tuple[Diagnostic, ...]:
    """Return the findings in a text, in the order of the text.

    Raises:
        GoalError: reading was stopped, or ended with an error.
    """
    match reply:
        case Struct("checked", (tuple(items), tuple(unknown), tuple(own), tuple(others))):
            places = Places(text)
            found = [
                *_syntax(places, items, Brackets(text.text)),
                *_singletons(places, items),
                *_scattered(places, items),
                *_unknown(places, unknown, (_by_name(own), _by_name(others))),
            ]
            return tuple(
                sorted(found, key=lambda one: (one.span.line, one.span.column) if one.span else (0, 0))
            )
    raise failure_of(reply)


def _syntax(places: Places, items: tuple[Term, ...], brackets: Brackets) -> Iterator[Diagnostic]:
    for item in items:
        match item:
            case Struct("error", (int(place), message)):
                fault = brackets.fault(place) if may_be_bracket(message) else None
                if fault is not None:
                    yield _of_bracket(places, fault)
                    continue
                words, hint = syntax_words(message)
                yield CLAUSE_SYNTAX.at(places.span(place, place + 1), words, hint=hint)


def _of_bracket(places: Places, fault: BracketFault) -> Diagnostic:
    """Return the finding at the place where a bracket is missing, or where one too many stands."""
    span, partner = places.span(fault.place, fault.place + 1), {")": "(", "]": "[", "}": "{"}[fault.bracket]
    if fault.opened is None:
        hint = f"take it out, or open it with `{partner}`"
        return CLAUSE_SYNTAX.at(span, f"`{fault.bracket}` closes nothing", hint=hint)
    opened = places.span(fault.opened, fault.opened + 1)
    message = f"`{fault.bracket}` is missing before this"
    hint = f"the `{partner}` of line {opened.line}, column {opened.column} is not closed"
    return CLAUSE_SYNTAX.at(span, message, hint=hint, secondary=(Label(opened, "opened here"),))


def _singletons(places: Places, items: tuple[Term, ...]) -> Iterator[Diagnostic]:
    for item in items:
        match item:
            case Struct("clause", (_, _, _, _, _, tuple(singles))):
                for single in singles:
                    match single:
                        case Struct("single", (Atom(name), int(start), int(end))):
                            yield SINGLETON.at(
                                places.span(start, end),
                                f"variable `{name}` occurs only once in its clause",
                                hint=f"write `_{name}` or `_` where that is meant",
                            )


def _scattered(places: Places, items: tuple[Term, ...]) -> Iterator[Diagnostic]:
    declared = {
        _words(item.arguments[0]) for item in items if isinstance(item, Struct) and item.name == "declared"
    }
    seen: set[str] = set()
    before = ""
    for item in items:
        match item:
            case Struct("clause", (_, _, indicator, int(start), int(end), _)):
                name = _words(indicator)
                if name != before and name in seen and name not in declared:
                    yield SCATTERED.at(
                        places.span(start, end),
                        f"clauses of `{name}` do not stand together",
                        hint=f"move this one to the others, or write `:- discontiguous {name}.`",
                    )
                seen.add(name)
                before = name


def _unknown(
    places: Places, unknown: tuple[Term, ...], known: tuple[Mapping[str, list[str]], ...]
) -> Iterator[Diagnostic]:
    for call in unknown:
        match call:
            case Struct("call", (Struct("/", (Atom(name), int(arity))), int(start), int(end))):
                hints = (_meant(name, names) for names in known)
                yield UNKNOWN_PREDICATE.at(
                    places.span(start, end),
                    f"predicate `{name}/{arity}` is defined nowhere",
                    hint=next(filter(None, hints), ""),
                )


def _meant(name: str, names: Mapping[str, list[str]]) -> str:
    """Return the likely intended predicate: the same name with other arguments, or another name."""
    if name in names:
        return f"there is {' and '.join(f'`{one}`' for one in names[name][:3])}"
    return did_you_mean(name, names)


def _by_name(indicators: tuple[Term, ...]) -> Mapping[str, list[str]]:
    found: dict[str, list[str]] = {}
    for one in map(_words, indicators):
        found.setdefault(one.rpartition("/")[0], []).append(one)
    return found


def _words(indicator: Term) -> str:
    match indicator:
        case Struct("/", (Atom(name), int(arity))):
            return f"{name}/{arity}"
    return "?"
