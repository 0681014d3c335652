"""All uses of names in a text, and the meaning of each name there; without types."""

from collections.abc import Iterable, Iterator
from enum import Enum

from ropsim.core import Span, frozen_dataclass
from ropsim.language.editing.outline import Role


class Space(Enum):
    """Names of different spaces do not meet."""

    SYMBOL = "name"
    FRAME = "frame"
    TOOL = "tool"
    TASK = "task"


class Act(Enum):
    """Access of a place to the meaning of its name."""

    DEFINES = "defines"
    WRITES = "writes"
    READS = "reads"


@frozen_dataclass
class Meaning:
    """Meaning of a name, in the part of a text where it is visible.

    Attributes:
        name: as written.
        space: name space.
        role: kind of entity; None if the text does not define it: it belongs to the cell, or is undefined.
        task: the task in which it is visible, empty for the control statements and for the whole text.
        is_global: whether it is visible in all tasks.
        definition: place that defines it; None for a name of the cell, an undefined one, and for an implicit
            parameter.
        line: the statement that defines it, as written.
        number: distinguishes meanings of one name, in order of their place.
    """

    name: str
    space: Space
    role: Role | None
    task: str = ""
    is_global: bool = True
    definition: Span | None = None
    line: str = ""
    number: int = 0

    @property
    def is_implicit(self) -> bool:
        """Return whether it is a parameter that the lines of a classic task imply."""
        return self.role is Role.PARAMETER and self.definition is None


@frozen_dataclass
class Use:
    """One place with a name.

    Attributes:
        span: of the name.
        act: access of the place.
        meaning: of the name there.
        task: name of the task in which it stands, empty for none.
    """

    span: Span
    act: Act
    meaning: Meaning
    task: str


@frozen_dataclass
class Sight:
    """Lines that can name a meaning.

    Attributes:
        meaning: that is known there.
        first: line from which on it is known (from 1).
        end: the line from which on it is known no more.
        is_outside: whether only control statements see it, of the lines from `first` to `end`.
    """

    meaning: Meaning
    first: int
    end: float
    is_outside: bool = False


@frozen_dataclass
class Uses:
    """All uses of a text in order of their place.

    Attributes:
        found: the uses.
        sights: lines in which each meaning is visible, hiding ones after hidden ones.
        broken: places of the statements that could not be read, whose names are unknown.
        tasks: first and last line of each task, in order, with its name.
        rooms: first line of each task and the one that ends it; without an end the one of the next statement.
        blocks: first and last line of each part of a block that has a header of its own; the line that closes
            a block belongs to none.
        is_classic: whether tasks may have implicit parameters.
    """

    found: tuple[Use, ...] = ()
    sights: tuple[Sight, ...] = ()
    broken: tuple[Span, ...] = ()
    tasks: tuple[tuple[str, int, int], ...] = ()
    rooms: tuple[tuple[int, float], ...] = ()
    blocks: tuple[tuple[int, int], ...] = ()
    is_classic: bool = True

    def at(self, line: int, column: int) -> Use | None:
        """Return the use that a place touches (both from 1), None for none."""
        near = (
            one
            for one in self.found
            if one.span.line == line and one.span.column <= column <= one.span.end_column
        )
        return next(near, None)

    def of(self, meaning: Meaning) -> tuple[Use, ...]:
        """Return all uses of a meaning."""
        return tuple(one for one in self.found if one.meaning == meaning)

    def meanings(self) -> tuple[Meaning, ...]:
        """Return all meanings, each once, in order of their first use."""
        return tuple(dict.fromkeys(one.meaning for one in self.found))

    def seen_at(self, line: int) -> dict[tuple[Space, str], Meaning]:
        """Return the meanings of names at the begin of a statement in a line (from 1)."""
        is_outside = not any(first <= line < end for first, end in self.rooms)
        return {
            (one.meaning.space, one.meaning.name): one.meaning
            for one in self.sights
            if one.first <= line < one.end and (is_outside or not one.is_outside)
        }


def in_order(uses: Iterable[Use]) -> Iterator[Use]:
    """Yield uses in order of their place."""
    yield from sorted(uses, key=lambda one: (one.span.line, one.span.column))
