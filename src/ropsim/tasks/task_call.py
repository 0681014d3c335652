"""A task with what it is called with, as an operator picks it: a list of points and a list of parameters."""

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.expression_text import short_text


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


Numbers = tuple[float, ...]
"""X Y Z, X Y Z Pitch Roll or X Y Z Roll Pitch Yaw in the units of the program."""
Point = str | Numbers
"""Name of a location, or its numbers."""
Value = bool | int | float | str | Quantity
"""A parameter; a text is the name of something, such as a variable."""


@frozen_dataclass
class TaskCall:
    """A task and what it is given.

    Attributes:
        name: of the task.
        points: locations, in the order of its parameters.
        parameters: all else that task text passes, in their order.
        objects: parameters that the state tells, by name, where they are known.
    """

    name: str
    points: tuple[Point, ...] = ()
    parameters: tuple[Value, ...] = ()
    objects: tuple[tuple[str, str], ...] = ()

    def __str__(self) -> str:
        points = map(point_text, self.points)
        given = [str(one).lower() if isinstance(one, bool) else str(one) for one in self.parameters]
        return f"{self.name} {', '.join((*points, *given))}".rstrip()


def point_text(point: Point) -> str:
    """Return a point as it stands in task text."""
    return point if isinstance(point, str) else f"({', '.join(map(short_text, point))})"


def point_words(point: Point) -> str:
    """Return a point as people read it: the angles of six numbers have names, in the order of fields."""
    if isinstance(point, str):
        head, behind, rest = point.partition(") rel ")
        numbers = _six(head) if behind else None
        return point if numbers is None else f"{point_words(numbers)} rel {rest}"
    if len(point) != 6:
        return point_text(point)
    x, y, z, roll, pitch, yaw = map(short_text, point)
    return f"({x}, {y}, {z}, pitch {pitch}, roll {roll}, yaw {yaw})"


def _six(text: str) -> Numbers | None:
    """Return the six numbers of a point without its last bracket, None where it is none of these."""
    cells = text.removeprefix("(").split(",")
    try:
        return tuple(map(float, cells)) if len(cells) == 6 else None
    except ValueError:
        return None


def call_words(call: TaskCall) -> str:
    """Return a call as people read it, who type pitch before roll."""
    return str(TaskCall(call.name, tuple(map(point_words, call.points)), call.parameters))


def term_of_point(point: Point) -> Term:
    """Return a point as it stands in facts: a name, or `p(X,Y,Z)`."""
    return Atom(point) if isinstance(point, str) else Struct("p", tuple(map(_number, point)))


def term_of_value(value: Value) -> Term:
    """Return a parameter as it stands in terms; a quantity is `50*mm` or `5*mm/s`."""
    match value:
        case bool():
            return Atom("true" if value else "false")
        case Quantity(number, unit):
            return quantity_term(_number(number), unit)
        case str():
            return Atom(value)
        case _:
            return value


def quantity_term(number: Term, unit: str) -> Term:
    """Return a number with its unit as a term."""
    first, slash, second = unit.partition("/")
    product = Struct("*", (number, Atom(first)))
    return Struct("/", (product, Atom(second))) if slash else product


def _number(number: float) -> Term:
    return int(number) if float(number).is_integer() and isinstance(number, int) else float(number)


def point_of_term(term: Term) -> Point | None:
    """Return the point of a term, None where it is none."""
    match term:
        case Atom(name):
            return name
        case Struct("p", numbers) if all(isinstance(one, int | float) for one in numbers):
            return tuple(float(one) for one in numbers if isinstance(one, int | float))
    return None
