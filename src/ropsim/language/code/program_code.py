"""The executable form of a text, assembled on request: findings do not wait for it."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Self

from ropsim import icr
from ropsim.core import frozen_dataclass, without_collection
from ropsim.language.code.main_code import LoweredParts, with_start
from ropsim.language.code.placing import PlacedCode, placed_main, placed_tasks
from ropsim.language.code.task_codes import Made
from ropsim.language.questions import Group
from ropsim.program import SourceMap
from ropsim.query import is_same


@frozen_dataclass
class CodeParts:
    """Components of the code; independent of later changes of the text.

    Attributes:
        start: steps that initialise variables of the control statements without a value.
        control: the control statements behind that, in groups.
        tasks: procedures of the tasks that they reach, in groups.
        places: where units lie in the text.
        placed: results of an earlier assembly; they save time and do not change the result.
    """

    start: tuple[icr.Step, ...]
    control: Mapping[Group, LoweredParts]
    tasks: Mapping[Group, tuple[Made, ...]]
    places: SourceMap
    placed: PlacedCode


class Code:
    """The executable form of a text; two are equal if their programs are, with all their lines.

    Attributes:
        header: its declarations: the program without its procedures.
    """

    __slots__ = ("_made", "_make", "header")

    def __init__(self, header: icr.Program, make: Callable[[], icr.Program]) -> None:
        self.header = header
        self._make: Callable[[], icr.Program] | None = make
        self._made = header

    @classmethod
    def known(cls, program: icr.Program) -> Self:
        """Return the form that a program is."""
        return cls(replace(program, procedures=()), lambda: program)

    @property
    def program(self) -> icr.Program:
        """Return the program; it is made the first time."""
        if self._make is not None:
            with without_collection():
                self._made = self._make()
            self._make = None  # the components are not needed any more
        return self._made

    def __eq__(self, other: object) -> bool:
        """Return whether both are of the same program."""
        return is_same(self.program, other.program) if isinstance(other, Code) else NotImplemented

    def __hash__(self) -> int:
        """Return the hash of the declarations."""
        return hash(self.header)


def put_together(header: icr.Program, parts: CodeParts) -> icr.Program:
    """Return the program of its parts."""
    main = placed_main(parts.placed, parts.control, len(parts.start), parts.places)
    tasks = placed_tasks(parts.placed, parts.tasks, parts.places)
    return replace(header, procedures=(with_start(main, parts.start), *tasks))
