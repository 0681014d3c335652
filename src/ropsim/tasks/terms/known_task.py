"""Tasks of a knowledge base as records."""

from ropsim.core import Span, frozen_dataclass
from ropsim.prolog import Struct, Term
from ropsim.tasks.kinds import SYMBOLIC, Layer
from ropsim.tasks.terms.bounds import PROGRAM_UNITS, Bound
from ropsim.tasks.terms.expression_text import unit_of


@frozen_dataclass
class Parameter:
    """One parameter of a task.

    Attributes:
        name: its variable, such as `L`.
        kind: a word of `KINDS`.
        default: its value if a call omits it, None if it is required.
        word: label for users; empty if the text has none.
        sentence: remark for users; empty if the text has none.
        bounds: all of which its value keeps.
    """

    name: str
    kind: str
    default: Term | None = None
    word: str = ""
    sentence: str = ""
    bounds: tuple[Bound, ...] = ()

    @property
    def label(self) -> str:
        """Return its word, or its name if it has no word."""
        return self.word or self.name

    @property
    def is_symbolic(self) -> bool:
        """Return whether the state of the cell determines it instead of task text."""
        return self.kind in SYMBOLIC

    @property
    def unit(self) -> str:
        """Return the unit for input: that of its default, or that of programs; else empty."""
        quantity = unit_of(self.default) if isinstance(self.default, Struct) else None
        return PROGRAM_UNITS.get(self.kind, "") if quantity is None else quantity[1]

    def __str__(self) -> str:
        return f"{self.name}: {self.kind}"


@frozen_dataclass
class KnownTask:
    """A task of a knowledge base; in its terms variables have the names of the text.

    Attributes:
        name: how it is called.
        parameters: in the order of its head.
        doc: purpose, in words.
        needs: conditions that hold before it (`pre`).
        adds: facts that are true after it.
        removes: facts that are not true any more after it.
        geometry: conditions that only geometry decides (`geo`).
        body: statements as terms.
        span: where it is defined, whose source is the file.
        layer: whose texts define it.
    """

    name: str
    parameters: tuple[Parameter, ...]
    doc: str
    needs: tuple[Term, ...]
    adds: tuple[Term, ...]
    removes: tuple[Term, ...]
    geometry: tuple[Term, ...]
    body: tuple[Term, ...]
    span: Span
    layer: Layer

    @property
    def is_built_in(self) -> bool:
        """Return whether it is of the library that comes with ropsim."""
        return self.layer is Layer.LIBRARY

    @property
    def passed(self) -> tuple[Parameter, ...]:
        """Return the parameters that task text passes."""
        return tuple(one for one in self.parameters if not one.is_symbolic)

    @property
    def called(self) -> frozenset[str]:
        """Return the names of the tasks that its body calls."""
        return frozenset(_called(self.body))

    def __str__(self) -> str:
        return f"{self.name}({', '.join(map(str, self.parameters))})"


def _called(body: tuple[Term, ...]) -> tuple[str, ...]:
    found: list[str] = []
    left: list[Term] = list(body)
    while left:
        match left.pop():
            case Struct("call", (Struct(name, _),)):
                found.append(name)
            case Struct("call", (one,)) if name := getattr(one, "name", ""):
                found.append(name)
            case Struct(_, arguments):
                left += arguments
            case tuple() as several:
                left += several
    return tuple(found)
