"""Expressions of `${...}`: a parser of our own, so that a file can compute numbers and do nothing else.

The grammar is that of Python's expressions, without assignments, lambdas, comprehensions and calls except of
the functions of `operators.py`; texts and numbers have no methods.
"""

from functools import lru_cache

from ropsim.exchange.xacro.meanings import Meaning, Names
from ropsim.exchange.xacro.parser import Parser
from ropsim.exchange.xacro.values import Value


def value_of(text: str, names: Names) -> Value:
    """Return the value of an expression.

    Raises:
        XacroError: it has no value.
    """
    return _meaning(text)(names)


@lru_cache(maxsize=4096)
def _meaning(text: str) -> Meaning:
    return Parser(text).meaning()
