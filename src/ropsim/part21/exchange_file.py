"""An exchange file of ISO 10303-21: its header and the instances of its data section."""

from collections.abc import Iterator
from dataclasses import field

from ropsim.core import Places, Span, frozen_dataclass
from ropsim.part21.values import Reference, Typed, Value


@frozen_dataclass
class Record:
    """A keyword with its parameters.

    Attributes:
        keyword: name of the entity in capitals; user-defined ones begin with `!`.
        values: the parameters.
        offsets: where the parameters stand in the text, of the first `NOTED` of them.
    """

    keyword: str
    values: tuple[Value, ...]
    offsets: tuple[int, ...] = field(default=(), compare=False, repr=False)


NOTED = 64
"""Parameters of a record whose places are kept, which bounds the memory for records of millions of them."""


@frozen_dataclass
class Instance:
    """An instance of an entity.

    Attributes:
        number: of the instance, unique in the file.
        records: one; of a complex instance one for each of its entities.
        offset: where it stands in the text.
    """

    number: int
    records: tuple[Record, ...]
    offset: int = field(default=0, compare=False, repr=False)

    @property
    def keyword(self) -> str:
        """Return the keyword of a simple instance, and the keywords of a complex one joined by `+`."""
        return "+".join(record.keyword for record in self.records)


@frozen_dataclass
class ExchangeFile:
    """Content of an exchange file.

    Attributes:
        header: its records, such as FILE_SCHEMA.
        instances: in the order of the text.
        places: function for places in the text; None without a text.
    """

    header: tuple[Record, ...]
    instances: tuple[Instance, ...]
    places: Places | None = field(default=None, compare=False, repr=False)

    @property
    def schemas(self) -> tuple[str, ...]:
        """Return the names of the schemas in capitals, without their object identifiers."""
        for record in self.header:
            match record:
                case Record("FILE_SCHEMA", (tuple() as names, *_)):
                    return tuple(str(name).partition("{")[0].strip().upper() for name in names)
                case _:
                    pass
        return ()

    def span(self, instance: Instance, record: int = 0, parameter: int | None = None) -> Span | None:
        """Return where an instance or one of its parameters stands.

        Args:
            instance: of this file.
            record: number of its record, from 0.
            parameter: number of a parameter of that record, from 0; None for the instance itself.
        """
        if self.places is None:
            return None
        if parameter is not None and parameter < len(instance.records[record].offsets):
            return self.places.span(instance.records[record].offsets[parameter])
        return self.places.span(instance.offset, len(f"#{instance.number}"))


def references(values: tuple[Value, ...]) -> Iterator[int]:
    """Yield the numbers of the instances that parameters refer to, in order, with repetitions."""
    waiting: list[Value] = list(reversed(values))
    while waiting:
        value = waiting.pop()
        if isinstance(value, Reference):
            yield value.number
        elif isinstance(value, tuple):
            waiting += reversed(value)
        elif isinstance(value, Typed):
            waiting.append(value.value)
