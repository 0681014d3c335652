"""Functions of Python that knowledge bases call as predicates, with types that are checked both ways."""

import re
from collections.abc import Callable, Iterable, Sequence
from enum import Enum
from fractions import Fraction

from ropsim.core import frozen_dataclass
from ropsim.prolog.terms.terms import Atom, Struct, Term, Var

_NAME = re.compile(r"[a-z][a-zA-Z0-9_]*")


class Sort(Enum):
    """Type of an argument; the values are the words of Prolog's type errors."""

    ATOM = "atom"
    INTEGER = "integer"
    NUMBER = "number"
    TEXT = "text"
    LIST = "list"
    TERM = "nonvar"

    def admits(self, term: Term) -> bool:
        """Return whether a term is of this sort."""
        match self:
            case Sort.ATOM:
                return isinstance(term, Atom)
            case Sort.INTEGER:
                return isinstance(term, int)
            case Sort.NUMBER:
                return isinstance(term, int | float | Fraction)
            case Sort.TEXT:
                return isinstance(term, str | Atom)
            case Sort.LIST:
                return isinstance(term, tuple)
            case Sort.TERM:
                return not isinstance(term, Var)


@frozen_dataclass
class Predicate:
    """A predicate whose first arguments are known when it is called and whose last ones it finds.

    Attributes:
        name: how knowledge bases call it; small letters, digits and underlines.
        inputs: types of the first arguments.
        outputs: types of the last arguments.
        solve: given the inputs, yields the outputs of one solution after the other. The next one is requested
            only when Prolog needs it; the generator is closed when Prolog needs no more.
    """

    name: str
    inputs: tuple[Sort, ...]
    outputs: tuple[Sort, ...]
    solve: Callable[..., Iterable[Sequence[Term]]]

    def __post_init__(self) -> None:
        if not _NAME.fullmatch(self.name):
            raise ValueError(
                f"`{self.name}` is no name of a predicate: a small letter, then letters, digits, `_`"
            )

    @property
    def indicator(self) -> str:
        """Return name and arity, such as `reachable/2`."""
        return f"{self.name}/{len(self.inputs) + len(self.outputs)}"


def question(name: str, inputs: tuple[Sort, ...], holds: Callable[..., bool]) -> Predicate:
    """Return the predicate that is true where a function of its arguments returns True."""

    def solve(*arguments: Term) -> Iterable[Sequence[Term]]:
        return ((),) if holds(*arguments) else ()

    return Predicate(name, inputs, (), solve)


def complaint(sort: Sort, term: Term) -> Term | None:
    """Return the error of Prolog for a term that is not of a sort, None where it is."""
    if sort.admits(term):
        return None
    formal = (
        Atom("instantiation_error")
        if isinstance(term, Var)
        else Struct("type_error", (Atom(sort.value), term))
    )
    return Struct("error", (formal, Var("_")))
