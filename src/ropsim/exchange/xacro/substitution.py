"""Texts with `${expression}` and `$(command)` in them."""

import re
from collections.abc import Mapping

from ropsim.exchange.xacro.expressions import value_of
from ropsim.exchange.xacro.scope import Scope
from ropsim.exchange.xacro.values import LONGEST, Value, XacroError, literal, words

_PARTS = re.compile(
    r"\$\$(?=[{(])|\$\{(?P<expression>[^{}]*(?:\{[^{}]*\}[^{}]*)*)\}|\$\((?P<command>[^()]*(?:\([^()]*\)[^()]*)*)\)"
)


def value_of_text(text: str, scope: Scope, arguments: Mapping[str, str]) -> Value:
    """Return the value of a text: of its one expression, or the text with everything put in.

    Args:
        text: text with or without substitutions; then its value.
        scope: of the place.
        arguments: of the file.

    Raises:
        XacroError: something in it cannot be evaluated.
    """
    if "$" not in text:
        return literal(text)
    match = _PARTS.fullmatch(text.strip())
    if match is not None and match.lastgroup is not None:
        made = _part(match, scope, arguments)
        return literal(made) if isinstance(made, str) else made
    return literal(text_of(text, scope, arguments))


def text_of(text: str, scope: Scope, arguments: Mapping[str, str]) -> str:
    """Return a text with everything put in.

    Raises:
        XacroError: something in it cannot be evaluated.
    """
    if "$" not in text:
        return text
    parts: list[str] = []
    place = 0
    for match in _PARTS.finditer(text):
        between = text[place : match.start()]
        _check(between)
        parts += [between, "$" if match.lastgroup is None else words(_part(match, scope, arguments))]
        place = match.end()
    _check(text[place:])
    made = "".join(parts) + text[place:]
    if len(made) > LONGEST:
        raise XacroError(f"a text has more than {LONGEST} characters", "make it shorter")
    return made


def _check(text: str) -> None:
    if "${" in text or "$(" in text:
        raise XacroError("a substitution is not closed", "close it by } or )")


def _part(match: re.Match[str], scope: Scope, arguments: Mapping[str, str]) -> Value:
    if match.lastgroup == "expression":
        return value_of(text_of(match.group("expression"), scope, arguments), scope)
    command, _, rest = match.group("command").strip().partition(" ")
    rest = text_of(rest.strip(), scope, arguments)
    if command == "arg":
        if rest not in arguments:
            raise XacroError(f"the argument `{rest[:60]}` has no value", "give it, or a default by xacro:arg")
        return arguments[rest]
    if command == "find":
        return f"package://{rest}"
    if command == "eval":
        return value_of(rest, scope)
    if command == "dirname":
        return "."
    raise XacroError(f"`$({command[:40]} ...)` is not carried out", "allowed are arg, find, eval and dirname")
