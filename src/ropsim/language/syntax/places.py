"""Place of a name in a text, for findings of later phases, which have only its line."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, SourceText, Span
from ropsim.language.syntax.fault import LineFaultError
from ropsim.language.syntax.lexer import Token, tokens
from ropsim.language.syntax.lines import MAX_JOINED, LogicalLine, logical_lines


def at_names(findings: Iterable[Diagnostic], source: SourceText) -> Iterator[Diagnostic]:
    """Yield findings of lines with a name at that name or at the call that passes it, others unchanged."""
    for one in findings:
        name = one.data.get("name")
        if one.span is not None and one.span.is_whole_line and isinstance(name, str):
            yield replace(one, span=read_at(source, one.span.line, name) or one.span)
        else:
            yield one


def read_at(source: SourceText, line: int, name: str) -> Span | None:
    """Return where the statement that begins at a line reads a variable; all of it where it does not name it.

    Then a task that it calls reads the variable. None where there is no statement.
    """
    text = "\n".join(source.lines[line - 1 : line - 1 + MAX_JOINED])
    logical = next(logical_lines(SourceText(source.name, text)), None)
    if logical is None:
        return None
    found = _words(logical.text)
    places = [k for k, token in enumerate(found) if token.text == name]
    reads = [k for k in places if not _is_given(found, k)]
    first, last = (0, -1) if not places else ((reads or places)[0],) * 2
    here = LogicalLine(line, logical.text)
    return here.span(source.name, found[first].start, found[last].end) if found else None


def named_at(source: SourceText, name: str) -> Span | None:
    """Return where a text names something first, None where it does not."""
    for logical in logical_lines(source):
        if name in logical.text:
            for token in _words(logical.text):
                if token.text == name:
                    return _span(source, logical, token)
    return None


def _words(text: str) -> list[Token]:
    try:
        return tokens(text)
    except LineFaultError:
        return []


def _is_given(found: list[Token], k: int) -> bool:
    """Return whether a name is given a value: `name = …`, `for name = …` or `… store name`."""
    before = found[k - 1].word if k else ""
    after = found[k + 1].word if k + 1 < len(found) else ""
    return before == "store" or (before in ("", "for", "then") and after in ("=", ":="))


def _span(source: SourceText, logical: LogicalLine, token: Token) -> Span:
    return logical.span(source.name, token.start, token.end)
