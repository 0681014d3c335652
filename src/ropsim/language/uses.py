"""Every place where a text uses a name, and what the name means there; it knows no types."""

from collections.abc import Iterable, Iterator
from enum import Enum

from ropsim.core import Span, frozen_dataclass
from ropsim.language.outline import Role


class Space(Enum):
    """Names of different spaces do not meet."""

    SYMBOL = "name"
    FRAME = "frame"
    TOOL = "tool"
    TASK = "task"


class Act(Enum):
    """What a place does with the meaning of its name."""

    DEFINES = "defines"
    WRITES = "writes"
    READS = "reads"


@frozen_dataclass
class Meaning:
    """What a name stands for, in the part of a text that knows it.

    Attributes:
        name: as written.
        space: among which names it is looked for.
        role: what it stands for; None where the text does not define it: the cell does, or nobody.
        task: the task that alone knows it, empty for the control statements and for the whole text.
        is_global: whether all tasks know it.
        definition: place that defines it; None for a name of the cell, of nobody, and for an implicit
            parameter.
        line: the statement that defines it, as written.
        number: tells meanings of one name apart, in order of their place.
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
        act: what the place does.
        meaning: of the name there.
        task: name of the task in which it stands, empty for none.
    """

    span: Span
    act: Act
    meaning: Meaning
    task: str


@frozen_dataclass
class Uses:
    """All uses of a text in order of their place.

    Attributes:
        found: the uses.
        broken: places of the statements that could not be read, whose names nobody knows.
        tasks: first and last line of each task, in order, with its name.
        blocks: first and last line of each part of a block that has a header of its own; the line that closes
            a block belongs to none.
        is_classic: whether tasks may have implicit parameters.
    """

    found: tuple[Use, ...] = ()
    broken: tuple[Span, ...] = ()
    tasks: tuple[tuple[str, int, int], ...] = ()
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

    def task_at(self, line: int) -> str:
        """Return the task in which a line (from 1) stands, empty for none."""
        return next((name for name, first, last in self.tasks if first <= line <= last), "")

    def seen_at(self, line: int, column: int = 1) -> dict[str, Meaning]:
        """Return what names of the text mean at a place (from 1), tasks, frames and tools left out."""
        task = self.task_at(line)
        seen: dict[str, Meaning] = {}
        for one in sorted(self.meanings(), key=_nearness):
            is_own = not one.is_global and one.task == task
            if one.space is Space.SYMBOL and one.role is not None and (one.is_global or is_own):
                seen.setdefault(one.name, one)
        before = (use for use in self.found if (use.span.line, use.span.column) <= (line, column))
        for use in before:  # of several variables of one name, the one that was used last
            if use.task == task and use.meaning.name in seen:
                seen[use.meaning.name] = use.meaning
        return seen


def _nearness(one: Meaning) -> tuple[bool, bool]:
    """Parameters hide what the whole text knows; nothing else may have such a name."""
    return one.role is not Role.PARAMETER, one.is_global


def in_order(uses: Iterable[Use]) -> Iterator[Use]:
    """Yield uses in order of their place."""
    yield from sorted(uses, key=lambda one: (one.span.line, one.span.column))
