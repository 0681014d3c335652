"""Brackets of a text of Prolog that do not close each other: where one is missing, where it was opened."""

import re
from bisect import bisect_left
from dataclasses import replace
from functools import cached_property

from ropsim.core import frozen_dataclass

_TOKEN = re.compile(
    r"%[^\n]*|/\*.*?(?:\*/|\Z)"  # comments; an unclosed one extends to the end
    r"|(?<![A-Za-z0-9_])0'(?:\\.|''|.)"  # a character as a number
    r"|'(?:[^'\\]|\\(?:.|\Z)|'')*(?:'|\Z)"
    r'|"(?:[^"\\]|\\(?:.|\Z)|"")*(?:"|\Z)|`(?:[^`\\]|\\(?:.|\Z))*(?:`|\Z)'
    r"|(?P<bracket>[()\[\]{}])"
    r"|(?P<end>(?<![#$&*+\-./:<=>?@^~\\])\.(?=\s|%|\Z))",
    re.DOTALL,
)
_CLOSING = {"(": ")", "[": "]", "{": "}"}


@frozen_dataclass
class BracketFault:
    """A bracket that is missing, or one too many.

    Attributes:
        place: where it is missing, or where the one too many stands, as a number of characters.
        bracket: which.
        opened: where its partner stands; None for one too many.
    """

    place: int
    bracket: str
    opened: int | None


class Brackets:
    """The brackets of a text, clause by clause; each is analysed on request.

    Args:
        text: of all clauses.
    """

    def __init__(self, text: str) -> None:
        self._text = text

    def fault(self, place: int) -> BracketFault | None:
        """Return the fault of the brackets of a clause, None if there is none.

        A bracket may be missed only lines behind the place where the clause cannot be read any more: then it
        is missing at the end of the line of that.

        Args:
            place: where the clause cannot be read any more, as a number of characters.
        """
        found = self._faults[min(bisect_left(self._ends, place), len(self._ends) - 1)]
        if found is None or found.opened is None:
            return found
        line, _, rest = self._text[place : found.place].partition("\n")
        return replace(found, place=place + len(line)) if rest.strip() else found

    @cached_property
    def _ends(self) -> list[int]:
        return [end for _, end in self._clauses]

    @cached_property
    def _faults(self) -> list[BracketFault | None]:
        return [_fault(brackets, end) for brackets, end in self._clauses]

    @cached_property
    def _clauses(self) -> list[tuple[list[tuple[str, int]], int]]:
        """Return the brackets of each clause with their places, and where its full stop or the text ends."""
        clauses: list[tuple[list[tuple[str, int]], int]] = []
        brackets: list[tuple[str, int]] = []
        for token in _TOKEN.finditer(self._text):
            if token["bracket"]:
                brackets.append((token["bracket"], token.start()))
            elif token["end"]:
                clauses.append((brackets, token.start()))
                brackets = []
        return [*clauses, (brackets, len(self._text))]


def _fault(brackets: list[tuple[str, int]], end: int) -> BracketFault | None:
    opened: list[tuple[str, int]] = []
    for bracket, place in brackets:
        if bracket in _CLOSING:
            opened.append((bracket, place))
        elif not opened:
            return BracketFault(place, bracket, None)
        else:
            before, begin = opened.pop()
            if _CLOSING[before] != bracket:
                return BracketFault(place, _CLOSING[before], begin)
    if not opened:
        return None
    before, begin = opened[-1]
    return BracketFault(end, _CLOSING[before], begin)
