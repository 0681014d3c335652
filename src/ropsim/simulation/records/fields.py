"""Named places in a row of numbers that joints have more or fewer of."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Field:
    """A named place in the state vector or in a row of the log.

    Attributes:
        name: such as `current`.
        axes: joints that have it, in order.
        first: where its numbers begin, one for each of the axes.
    """

    name: str
    axes: tuple[int, ...]
    first: int

    @property
    def place(self) -> slice:
        """Return the place of its numbers."""
        return slice(self.first, self.first + len(self.axes))


def fields(names_of_axes: tuple[tuple[str, ...], ...], first: int) -> tuple[Field, ...]:
    """Return a field for every name, one behind the other.

    Args:
        names_of_axes: entities of each joint.
        first: where the first field begins.
    """
    found: list[Field] = []
    for name in dict.fromkeys(name for names in names_of_axes for name in names):
        axes = tuple(k for k, names in enumerate(names_of_axes) if name in names)
        found.append(Field(name, axes, first))
        first += len(axes)
    return tuple(found)
