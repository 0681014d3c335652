"""Task programs as objects: expressions, statements, tasks."""

from dataclasses import dataclass, field

KINDS = ("int", "num", "bool", "length", "loc")
"""Types of the language that programs use."""

PLACE = "place"
"""A length that was read from a location: right but for rounding, so that nothing is decided by it."""


def word(kind: str) -> str:
    """Return the type of the language."""
    return "length" if kind == PLACE else kind


@dataclass(frozen=True, slots=True)
class Expr:
    """An expression.

    Attributes:
        op: `literal`, `name`, a sign or function of the language, or what `text` and `meaning` say of it.
        kind: its type.
        parts: operands.
        text: of a literal as it is written; of a name, a frame or a signal its name.
        value: of a literal, in SI units.
    """

    op: str
    kind: str
    parts: tuple["Expr", ...] = ()
    text: str = ""
    value: bool | int | float = 0

    @property
    def is_written(self) -> bool:
        """Return whether this is a location in numbers, moved or not."""
        moved = self.op in ("above", "offset", "rel")
        return self.op in ("location", "polar", "like") or (moved and self.parts[0].is_written)

    @property
    def is_constant(self) -> bool:
        """Return whether the compiler can know the value."""
        return self.op not in ("name", "signal", "here", "reference") and all(
            part.is_constant for part in self.parts
        )


@dataclass(eq=False, slots=True)
class Stmt:
    """A statement; the writer notes its line.

    Attributes:
        op: what it does.
        name: variable, task, pattern or frame that it names.
        parts: its expressions.
        blocks: the statements in it.
        names: further names, such as those of `load` and of arguments.
        line: where it stands.
        lines: where its conditions stand.
    """

    op: str
    name: str = ""
    parts: tuple[Expr, ...] = ()
    blocks: tuple[list["Stmt"], ...] = ()
    names: tuple[str, ...] = ()
    line: int = 0
    lines: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of a task; `default` is a literal or None."""

    name: str
    kind: str
    default: Expr | None = None


@dataclass(slots=True)
class Task:
    """A task.

    Attributes:
        result: the type that it returns, empty for none.
        is_classic: whether its parameters are not written: those are told by what it reads.
    """

    name: str
    parameters: tuple[Parameter, ...]
    result: str
    body: list[Stmt] = field(default_factory=list)
    is_classic: bool = False


@dataclass(frozen=True, slots=True)
class Pattern:
    """A grid: counts, first location, steps [mm], order."""

    name: str
    counts: tuple[int, ...]
    first: tuple[int, int, int]
    steps: tuple[tuple[int, int, int], ...]
    order: str
    frame: str


@dataclass(slots=True)
class Program:
    """A text: constants, variables of all tasks with their first values, patterns, tasks, control statements.

    `kinds` tells those of all variables of the control statements, `wrong` a line behind these that the
    compiler refuses, with the code of its finding.
    """

    constants: dict[str, Expr] = field(default_factory=dict)
    shared: dict[str, Expr] = field(default_factory=dict)
    kinds: dict[str, str] = field(default_factory=dict)
    patterns: list[Pattern] = field(default_factory=list)
    tasks: list[Task] = field(default_factory=list)
    main: list[Stmt] = field(default_factory=list)
    wrong: tuple[str, str] | None = None
