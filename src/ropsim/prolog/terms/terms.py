"""Terms of Prolog as values of Python.

Integers, floats and rationals are numbers of Python, strings are `str`, proper lists are tuples; other terms
are the records below. A list whose end is not known is `Struct("[|]", (head, tail))`.
"""

from collections.abc import Iterator
from fractions import Fraction

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Atom:
    """A constant that stands for itself.

    Attributes:
        name: the characters, without quotes.
    """

    name: str


@frozen_dataclass
class Var:
    """A variable; variables of one answer are the same when their names are.

    Attributes:
        name: as Prolog writes it, such as `_123`.
    """

    name: str


@frozen_dataclass
class Struct:
    """A compound term.

    Attributes:
        name: the name of the functor.
        arguments: its arguments; possibly none, as in `now()`.
    """

    name: str
    arguments: "tuple[Term, ...]"

    @property
    def indicator(self) -> str:
        """Return name and arity, such as `grip/2`."""
        return f"{self.name}/{len(self.arguments)}"


Term = Atom | Var | Struct | int | float | Fraction | str | tuple["Term", ...]


def leaves(term: Term) -> Iterator[Term]:
    """Yield the variables and constants of a term, in no order that matters."""
    left: list[Term] = [term]
    while left:
        match left.pop():
            case Struct(_, arguments):
                left += arguments
            case tuple() as several:
                left += several
            case one:
                yield one
