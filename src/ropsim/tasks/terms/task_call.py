"""A call of a task by an operator: the task, a list of points and a list of parameters."""

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.terms.expression_text import short_text
from ropsim.tasks.terms.point import Point, exact_number, point_text


@frozen_dataclass
class Quantity:
    """A number with a unit of the task language.

    Attributes:
        value: the number.
        unit: such as `mm` or `mm/s`.
    """

    value: float
    unit: str

    def __str__(self) -> str:
        return f"{short_text(self.value)} {self.unit}"


Value = bool | int | float | str | Quantity
"""A parameter; a text is the name of something, such as a variable."""


@frozen_dataclass
class TaskCall:
    """A task and its arguments.

    Attributes:
        name: of the task.
        points: locations, in the order of its parameters.
        parameters: all else that task text passes, in their order.
        objects: parameters taken from the state, by name, if known.
    """

    name: str
    points: tuple[Point, ...] = ()
    parameters: tuple[Value, ...] = ()
    objects: tuple[tuple[str, str], ...] = ()

    def __str__(self) -> str:
        points = map(point_text, self.points)
        given = [str(one).lower() if isinstance(one, bool) else str(one) for one in self.parameters]
        return f"{self.name} {', '.join((*points, *given))}".rstrip()


def term_of_value(value: Value) -> Term:
    """Return a parameter as a term; a quantity is `50*mm` or `5*mm/s`."""
    match value:
        case bool():
            return Atom("true" if value else "false")
        case Quantity(number, unit):
            return quantity_term(exact_number(number), unit)
        case str():
            return Atom(value)
        case _:
            return value


def quantity_term(number: Term, unit: str) -> Term:
    """Return a number with its unit as a term."""
    first, slash, second = unit.partition("/")
    product = Struct("*", (number, Atom(first)))
    return Struct("/", (product, Atom(second))) if slash else product
