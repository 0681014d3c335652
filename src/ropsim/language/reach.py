"""How far a block without end reaches."""

from collections.abc import Sequence

from ropsim.language.syntax.statements import DECLARATIONS, Broken
from ropsim.language.text import Line

_DECLARING = frozenset({"frame", "loc", "tool", "signal", "const", "pattern", "units", "program"})
"""First words of declarations that stand outside of all blocks, also where the rest is wrong."""


def reach(opener: Line, firsts: Sequence[Line]) -> int:
    """Return how many lines and blocks of those below an opener are in its block, which nothing closes.

    Where lines are indented, the block ends before the first that is not, and always before a declaration,
    which stands in no block.

    Args:
        opener: the line that opens it.
        firsts: the first line of each line or block up to where the block around it ends.
    """
    left = opener.indent
    is_indented = bool(firsts) and firsts[0].indent > left
    for number, line in enumerate(firsts):
        if (is_indented and line.indent <= left) or _declares(line):
            return number
    return len(firsts)


def _declares(line: Line) -> bool:
    statement = line.statement
    if isinstance(statement, Broken):
        return statement.head in _DECLARING
    return isinstance(statement, DECLARATIONS) and line.head != "var"
