"""Statements that the inference pass skips, since they contain no evidence for types."""

import re

from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import Type, known
from ropsim.language.check.scope.world import Poison, Variable
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import Line

_WORDS = re.compile(r"[A-Za-z_]\w*+", re.ASCII).findall
_ACTING = frozenset({syntax.Gripper, syntax.SetSignal, syntax.WaitTime, syntax.Print, syntax.Stop})


def tells_nothing(body: Body, line: Line) -> bool:
    """Return whether a statement makes no variable, and nothing in it has an open type.

    Other errors in it are found by the checking pass.
    """
    return _makes_nothing(body, line.statement) and not _has_open(body, line.logical.text)


def words_of(text: str) -> list[str]:
    """Return the words of a text that can be names."""
    return _WORDS(text)


def _makes_nothing(body: Body, node: syntax.Statement | None) -> bool:
    """Return whether a statement makes no variable, moves no frame, and determines no type of a parameter."""
    match node:
        case syntax.Motion(store=store):
            return store is None
        case syntax.Assign(name=name, member=None, value=value):
            symbol = body.find(name.text)
            is_made = symbol is not None and not isinstance(symbol, Poison)
            return is_made and not isinstance(value, nodes.Function)
        case syntax.If(body=inner):
            return _makes_nothing(body, inner)
        case syntax.WaitCondition(otherwise=inner):
            return inner is None or _makes_nothing(body, inner)
        case syntax.SetMode(setting=setting):
            return setting.word != "frame"
        case syntax.Call(name=name):
            called = body.world.signatures.get(name.text)
            return called is None or all(isinstance(known(one.type), Type) for one in called.formals)
    return type(node) in _ACTING


def _has_open(body: Body, text: str) -> bool:
    """Return whether a line may name something of open type, or determine the count of `joints(…)`."""
    names, untyped = body.names, body.world.untyped
    for word in words_of(text):
        symbol = names.get(word)
        if symbol is None:
            if word in untyped:
                return True
        elif isinstance(symbol, Variable) and not isinstance(known(symbol.type), Type):
            return True
    return "joints" in text.lower()
