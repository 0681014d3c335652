"""Expressions of `${...}`: a parser of our own, so that a file can compute numbers and do nothing else.

The grammar is that of Python's expressions without assignments and lambdas. Called are the functions of
`functions.py` and `file_functions.py` and the methods of `methods.py`; all others are refused by name.
"""

from functools import lru_cache

from ropsim.exchange.xacro.formulas.meanings import Meaning
from ropsim.exchange.xacro.formulas.names import Names
from ropsim.exchange.xacro.formulas.parser import Parser
from ropsim.exchange.xacro.formulas.values import Value


def value_of(text: str, names: Names) -> Value:
    """Return the value of an expression.

    Raises:
        XacroError: it has no value.
    """
    return _meaning(text)(names)


@lru_cache(maxsize=4096)
def _meaning(text: str) -> Meaning:
    return Parser(text).meaning()
