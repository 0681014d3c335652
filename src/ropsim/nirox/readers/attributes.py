"""The attributes of instances of a valid file, for readers."""

from collections.abc import Iterable

from ropsim.core import Diagnostic, Kind
from ropsim.express import Population, plain
from ropsim.nirox.diagnostics import IMPOSSIBLE
from ropsim.part21 import Enumeration, Reference, Value

LARGEST = 1e12
"""No number of a robot is larger, in any unit; products of numbers up to it stay finite."""


class ImpossibleError(Exception):
    """Data of a file are impossible; carries the message."""

    def __init__(self, finding: Diagnostic) -> None:
        super().__init__(finding.message)
        self.finding = finding


class Attributes:
    """The attributes of the instances of one file.

    Attributes:
        population: the instances of entities that the schema has.
    """

    def __init__(self, population: Population) -> None:
        self.population = population

    def is_a(self, number: int, entity: str) -> bool:
        """Return whether an instance is of an entity."""
        return self.population.is_a(number, entity)

    def extent(self, entity: str) -> list[int]:
        """Return the instances of an entity in the order of the file."""
        return self.population.extent(entity)

    def users(self, number: int, entity: str, attribute: str) -> tuple[int, ...]:
        """Return the instances of an entity that refer to one by an attribute."""
        return self.population.users(number, entity, attribute)

    def user(self, number: int, entity: str, attribute: str) -> int | None:
        """Return the first instance of an entity that refers to one by an attribute."""
        return next(iter(self.users(number, entity, attribute)), None)

    def has(self, number: int, name: str) -> bool:
        """Return whether an attribute has a value."""
        return self.population.value(number, name) is not None

    def text(self, number: int, name: str) -> str:
        """Return a text, or the item of an enumeration in small letters."""
        value = plain(self.population.value(number, name))
        return value.name.lower() if isinstance(value, Enumeration) else str(value or "")

    def flag(self, number: int, name: str) -> bool:
        """Return whether a logical value is TRUE."""
        return plain(self.population.value(number, name)) is True

    def real(self, number: int, name: str, default: float | None = None) -> float:
        """Return a number.

        Args:
            number: of the instance.
            name: of the attribute.
            default: where it has no value.

        Raises:
            ImpossibleError: it is larger than `LARGEST`, or has no value and no default.
        """
        value = plain(self.population.value(number, name))
        if value is None and default is not None:
            return default
        return self._bounded(number, name, value)

    def reals(self, number: int, name: str) -> tuple[float, ...]:
        """Return the numbers of a list; raises `ImpossibleError` where one is larger than `LARGEST`."""
        return tuple(self._bounded(number, name, plain(one)) for one in self._list(number, name))

    def points(self, number: int, name: str) -> tuple[tuple[float, ...], ...]:
        """Return the lists of numbers of a list; raises `ImpossibleError` as `reals` does."""
        rows = [one if isinstance(one, tuple) else () for one in self._list(number, name)]
        return tuple(tuple(self._bounded(number, name, plain(one)) for one in row) for row in rows)

    def integer(self, number: int, name: str) -> int:
        """Return a whole number; 0 where it has no value."""
        value = plain(self.population.value(number, name))
        return value if isinstance(value, int) else 0

    def integers(self, number: int, name: str) -> tuple[int, ...]:
        """Return the whole numbers of a list."""
        return tuple(one for one in self._list(number, name) if isinstance(one, int))

    def ref(self, number: int, name: str) -> int:
        """Return the instance that an attribute refers to.

        Raises:
            ImpossibleError: it is of an entity that the schema does not have.
        """
        return self._known(number, name, plain(self.population.value(number, name)))

    def refs(self, number: int, name: str) -> list[int]:
        """Return the instances that a list refers to; raises `ImpossibleError` as `ref` does."""
        return [self._known(number, name, plain(one)) for one in self._list(number, name)]

    def impossible(self, number: int, message: str, hint: str = "") -> ImpossibleError:
        """Return the exception for an impossible instance."""
        return ImpossibleError(self.finding(IMPOSSIBLE, number, message, hint))

    def called(self, number: int) -> str:
        """Return an instance in words, such as `#12 KINEMATIC_LINK`."""
        return f"#{number} {self.population.instances[number].keyword[:60]}"

    def finding(self, kind: Kind, number: int | None, message: str, hint: str = "") -> Diagnostic:
        """Return a finding at an instance, or without a place."""
        if number is None:
            return kind.at(None, message, hint=hint)
        span = self.population.file.span(self.population.instances[number])
        return kind.at(span, f"{self.called(number)}: {message}", hint=hint)

    def _list(self, number: int, name: str) -> Iterable[Value]:
        value = self.population.value(number, name)
        return value if isinstance(value, tuple) else ()

    def _known(self, number: int, name: str, value: object) -> int:
        if isinstance(value, Reference) and self.population.lineage(value.number):
            return value.number
        raise self.impossible(number, f"`{name}` is no instance that is known")

    def _bounded(self, number: int, name: str, value: object) -> float:
        if isinstance(value, float) and abs(value) <= LARGEST:
            return value
        shown = f"{value:g}" if isinstance(value, float) else "no number"
        raise self.impossible(number, f"`{name}` is {shown}, allowed are numbers up to {LARGEST:g}")
