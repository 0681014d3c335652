"""Texts with `${expression}` and `$(command)` in them."""

import re
from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.exchange.xacro.formulas.names import FileOfNames
from ropsim.exchange.xacro.formulas.parser import value_of
from ropsim.exchange.xacro.formulas.values import LONGEST, Value, XacroError, literal, words
from ropsim.exchange.xacro.scope import Scope

_PARTS = re.compile(
    r"\$\$(?=[{(])|\$\{(?P<expression>[^{}]*(?:\{[^{}]*\}[^{}]*)*)\}|\$\((?P<command>[^()]*(?:\([^()]*\)[^()]*)*)\)"
)


def value_of_text(text: str, scope: Scope) -> Value:
    """Return the value of a text: of its one expression, or the text with everything put in.

    Args:
        text: text with or without substitutions; then its value.
        scope: of the place.

    Raises:
        XacroError: something in it cannot be evaluated.
    """
    if "$" not in text:
        return literal(text)
    match = _PARTS.fullmatch(text)
    if match is not None and match.lastgroup is not None:
        made = _part(match, scope)
        return literal(made) if isinstance(made, str) else made
    return literal(text_of(text, scope))


def text_of(text: str, scope: Scope) -> str:
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
        parts += [between, "$" if match.lastgroup is None else words(_part(match, scope))]
        place = match.end()
    _check(text[place:])
    made = "".join(parts) + text[place:]
    if len(made) > LONGEST:
        raise XacroError(f"a text has more than {LONGEST} characters", "make it shorter")
    return made


def _check(text: str) -> None:
    if "${" in text or "$(" in text:
        raise XacroError("a substitution is not closed", "close it by } or )")


def _part(match: re.Match[str], scope: Scope) -> Value:
    if match.lastgroup == "expression":
        return value_of(text_of(match.group("expression"), scope), scope)
    command, _, rest = text_of(match.group("command"), scope).strip().partition(" ")
    known = _COMMANDS.get(command)
    if known is None:
        hint = _HINTS.get(command, f"allowed are {', '.join(_COMMANDS)}")
        raise XacroError(f"`$({command[:40]} ...)` is not carried out", hint)
    return known(rest.strip(), scope)


def _optional(rest: str, _scope: Scope) -> Value:
    """Return the default of an environment variable; environment variables are not read."""
    return rest.partition(" ")[2].strip()


def _evaluated(rest: str, scope: Scope) -> Value:
    return value_of(rest, _Arguments(scope))


_COMMANDS: Mapping[str, Callable[[str, Scope], Value]] = MappingProxyType(
    {
        "arg": lambda rest, scope: scope.file.argument(rest),
        "find": lambda rest, _: f"package://{rest}",
        "eval": _evaluated,
        "dirname": lambda _, scope: scope.file.directory(),
        "optenv": _optional,
    }
)
_HINTS: Mapping[str, str] = MappingProxyType(
    {
        "env": "environment variables are not read: write `$(arg ...)` or the value",
        "anon": "write the name itself",
        "cwd": "write `$(dirname)` or `$(find package)`",
    }
)


class _Arguments:
    """Names of `$(eval ...)`: the arguments of the file by their names, before its properties."""

    def __init__(self, scope: Scope) -> None:
        self._scope = scope

    @property
    def file(self) -> FileOfNames:
        return self._scope.file

    def value(self, name: str) -> Value:
        if not self._scope.file.has_argument(name):
            return self._scope.value(name)
        return literal(self._scope.file.argument(name))
